// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_PLACE_VERTICES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_PLACE_VERTICES_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Coarse_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Placement_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Placement_repair.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

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

struct Placement_input
{
  const Clustered_faces& surface;
  const Border_arcs& border;
  const Placement_model& placement;
};

// Places the vertices of the clusters. Vertices of clusters on the border lie on the border. A global placement may flip edges
// of the triangles.
inline std::vector<Vector> place_vertices(const Placement_input& input, std::vector<Triangle>& triangles)
{
  const Clustered_faces& surface = input.surface;
  const Run_context context = input.placement.may_run_in_parallel ? surface.context() : surface.context().on_one_thread();
  context.stage_begins(Coarsening_stage::PLACEMENT);
  std::vector<Vector> positions(surface.number_of_clusters());
  input.border.place(positions);
  if (input.placement.local) {
    for_each_chunk(context, positions.size(), 16, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t x = begin; x < end; ++x) {
        if (!context.is_parallel())
          context.poll(surface.faces(x).size());
        if (!input.border.is_on_border(x))
          positions[x] = input.placement.local(surface, x);
      }
    });
  } else if (input.placement.fitted) {
    fit_vertices(surface, input.border, *input.placement.fitted, triangles, positions);
  } else {
    input.placement.global(surface, input.border, triangles, positions);
  }
  for (std::size_t x = 0; x < positions.size(); ++x)
    positions[x] = checked_position(surface, x, positions[x]);
  context.stage_ends(Coarsening_stage::PLACEMENT);
  return positions;
}

// Moves vertices and flips edges where triangles intersect that do not in the input, or face away from the surface.
inline Repair_counts repair_placement(const Placement_input& input, const Output_coordinates& output_coordinates,
                                      std::vector<Triangle>& triangles, std::vector<Vector>& positions, Repair_budget& budget)
{
  Coarse_mesh mesh(input.surface, input.border, triangles, positions, nullptr);
  const Repair_counts counts = Placement_repair(mesh, input.surface, output_coordinates, budget).run(input.placement);
  triangles = mesh.triangles();
  return counts;
}

// Places the vertices, and repairs the placement on request.
inline std::vector<Vector> place_vertices(const Placement_input& input, bool with_repair,
                                          const Output_coordinates& output_coordinates, std::vector<Triangle>& triangles,
                                          Repair_counts& counts)
{
  std::vector<Vector> positions = place_vertices(input, triangles);
  Repair_budget budget(input.surface.input().mesh.number_of_faces());
  counts = with_repair ? repair_placement(input, output_coordinates, triangles, positions, budget) : Repair_counts();
  return positions;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_PLACE_VERTICES_H
