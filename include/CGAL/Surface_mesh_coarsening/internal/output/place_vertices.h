// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_PLACE_VERTICES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_PLACE_VERTICES_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Closest_vertex_placement.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Placement_repair.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>

#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {

class Quadric_placement;

namespace internal {

template <class Placement>
constexpr bool is_local_placement =
  std::is_invocable_r<Vector, const Placement&, const Clustered_surface&, std::size_t>::value;

// Placements of the package can be called by several threads at a time; those of others may not be made for it.
template <class Placement>
constexpr bool is_own_placement = std::is_same<Placement, Centroid_placement>::value ||
                                  std::is_same<Placement, Closest_vertex_placement>::value ||
                                  std::is_same<Placement, Quadric_placement>::value;

// Whether a placement puts vertices at vertices of the input, and repairs have to keep to that.
template <class Placement>
constexpr bool is_at_input_vertices = std::is_same<Placement, Closest_vertex_placement>::value;

// Where a placement finds nothing, as among coordinates of very different sizes, the centroid stands in.
inline Vector checked_position(const Clustered_surface& surface, std::size_t cluster, const Vector& p)
{
  const Vector inside = surface.within_bounds(cluster, p);
  const bool is_finite = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  if (is_finite && inside != p)
    throw Invalid_input("the placement puts the vertex of cluster " + std::to_string(cluster) + " at (" + std::to_string(p[0]) +
                        ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) +
                        "), outside of the bounding box of the cluster grown by half its diagonal");
  return inside;
}

// Places the vertices of the clusters as `placement` says, those on the border on it. A global placement may flip edges
// of the triangles.
template <class Placement>
std::vector<Vector> place_vertices(const Clustered_surface& surface, const Border_arcs& border, const Placement& placement,
                                   std::vector<Triangle>& triangles, const Cancellation_point& cancellation)
{
  std::vector<Vector> positions(surface.number_of_clusters());
  border.place(positions);
  if constexpr (is_local_placement<Placement>) {
    const Execution execution = is_own_placement<Placement> ? surface.execution() : Execution::SEQUENTIAL;
    for_each_chunk(execution, positions.size(), 16, cancellation, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t x = begin; x < end; ++x) {
        if (execution == Execution::SEQUENTIAL)
          cancellation.poll(surface.faces(x).size());
        if (!border.is_on_border(x))
          positions[x] = placement(surface, x);
      }
    });
    (void)triangles;
  } else {
    placement(surface, border, triangles, positions);
  }
  for (std::size_t x = 0; x < positions.size(); ++x)
    positions[x] = checked_position(surface, x, positions[x]);
  return positions;
}

// The same, and if asked to moves vertices and flips edges where triangles intersect that do not in the input, or look away
// from the surface. `output_coordinates` gives the coordinates that a position has in the output.
template <class Placement, class OutputCoordinates>
std::vector<Vector> place_vertices(const Clustered_surface& surface, const Placement& placement, bool with_repair,
                                   const OutputCoordinates& output_coordinates, std::vector<Triangle>& triangles,
                                   Repair_counts& counts, const Cancellation_point& cancellation = Cancellation_point())
{
  const Border_arcs border(surface);
  std::vector<Vector> positions = place_vertices(surface, border, placement, triangles, cancellation);
  counts = Repair_counts();
  if (with_repair) {
    Placement_repair repair(surface, border, output_coordinates, triangles, positions, cancellation);
    if (is_at_input_vertices<Placement>)
      repair.stay_at_input_vertices();
    counts = repair.run();
  }
  return positions;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_PLACE_VERTICES_H
