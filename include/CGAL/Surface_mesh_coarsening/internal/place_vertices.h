// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACE_VERTICES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACE_VERTICES_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/dual_triangles.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

template <class Placement>
constexpr bool is_local_placement =
  std::is_invocable_r<Vector, const Placement&, const Clustered_surface&, std::size_t>::value;

// Places the vertices of the clusters as `placement` says, those on the border on it. A global placement may flip edges
// of the triangles.
template <class Placement>
std::vector<Vector> place_vertices(const Clustered_surface& surface, const Placement& placement,
                                   std::vector<Triangle>& triangles)
{
  std::vector<Vector> positions(surface.number_of_clusters());
  const Border_arcs border(surface);
  border.place(positions);
  if constexpr (is_local_placement<Placement>) {
    for (std::size_t x = 0; x < positions.size(); ++x)
      if (!border.is_on_border(x))
        positions[x] = placement(surface, x);
    (void)triangles;
  } else {
    placement(surface, border, triangles, positions);
  }
  // Where a placement finds nothing, as among coordinates of very different sizes, the centroid stands in.
  const auto is_number = [](double x) { return std::isfinite(x); };
  for (std::size_t x = 0; x < positions.size(); ++x)
    if (!std::all_of(positions[x].begin(), positions[x].end(), is_number))
      positions[x] = surface.cluster_centroid(x);
  return positions;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACE_VERTICES_H
