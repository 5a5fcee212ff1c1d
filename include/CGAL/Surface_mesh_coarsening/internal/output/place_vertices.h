// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_PLACE_VERTICES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_PLACE_VERTICES_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Placement_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Placement_repair.h>

#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Returns the centroid if the position of a placement is not finite, for example with coordinates of very different magnitude.
inline Vector checked_position(const Clustered_faces& surface, std::size_t cluster, const Vector& p)
{
  const Vector inside = surface.within_bounds(cluster, p);
  const bool is_finite = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  if (is_finite && inside != p)
    throw Invalid_input("the placement puts the vertex of cluster " + std::to_string(cluster) + " at (" + std::to_string(p[0]) +
                        ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) +
                        "), outside of the bounding box of the cluster grown by half its diagonal");
  return inside;
}

// Places the vertices of the clusters. Vertices of clusters on the border lie on the border. A global placement may flip edges
// of the triangles.
inline std::vector<Vector> place_vertices(const Clustered_faces& surface, const Border_arcs& border,
                                          const Placement_model& placement, std::vector<Triangle>& triangles)
{
  const Run_context context = placement.may_run_in_parallel ? surface.context() : surface.context().on_one_thread();
  context.stage_begins(Coarsening_stage::PLACEMENT);
  std::vector<Vector> positions(surface.number_of_clusters());
  border.place(positions);
  if (placement.local) {
    for_each_chunk(context, positions.size(), 16, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t x = begin; x < end; ++x) {
        if (!context.is_parallel())
          context.poll(surface.faces(x).size());
        if (!border.is_on_border(x))
          positions[x] = placement.local(surface, x);
      }
    });
  } else {
    placement.global(surface, border, triangles, positions);
  }
  for (std::size_t x = 0; x < positions.size(); ++x)
    positions[x] = checked_position(surface, x, positions[x]);
  context.stage_ends(Coarsening_stage::PLACEMENT);
  return positions;
}

// Moves vertices and flips edges where triangles intersect that do not in the input, or face away from the surface.
inline Repair_counts repair_placement(const Clustered_faces& surface, const Border_arcs& border,
                                      const Placement_model& placement, const Output_coordinates& output_coordinates,
                                      std::vector<Triangle>& triangles, std::vector<Vector>& positions, Repair_budget& budget)
{
  surface.context().stage_begins(Coarsening_stage::REPAIR);
  Placement_repair repair(surface, border, output_coordinates, triangles, positions, budget);
  if (placement.is_at_input_vertices)
    repair.stay_at_input_vertices();
  const Repair_counts counts = repair.run();
  surface.context().stage_ends(Coarsening_stage::REPAIR);
  return counts;
}

// Places the vertices, and repairs the placement on request.
inline std::vector<Vector> place_vertices(const Clustered_faces& surface, const Border_arcs& border,
                                          const Placement_model& placement, bool with_repair,
                                          const Output_coordinates& output_coordinates, std::vector<Triangle>& triangles,
                                          Repair_counts& counts)
{
  std::vector<Vector> positions = place_vertices(surface, border, placement, triangles);
  Repair_budget budget(surface.input().mesh.number_of_faces());
  counts = with_repair ? repair_placement(surface, border, placement, output_coordinates, triangles, positions, budget)
                       : Repair_counts();
  return positions;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_PLACE_VERTICES_H
