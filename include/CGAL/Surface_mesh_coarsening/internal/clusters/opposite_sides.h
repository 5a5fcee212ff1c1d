// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_OPPOSITE_SIDES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_OPPOSITE_SIDES_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Bucketed_items.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/Index.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Returns, for each side of a triangulated 2-manifold, the side of the same edge in the other triangle; NONE on the border. Side
// `3 t + i` goes from corner `i` of triangle `t` to the next corner. `source(side)` is the vertex where a side begins.
template <class Source>
std::vector<Index> opposite_sides(std::size_t triangles, std::size_t vertices, const Source& source)
{
  const auto target = [&](Index side) { return source(side % 3 == 2 ? side - 2 : side + 1); };
  const auto low = [&](Index side) { return (std::min)(source(side), target(side)); };
  const auto high = [&](Index side) { return (std::max)(source(side), target(side)); };
  const Bucketed_items<Index> by_low(numbers_below(Index(3 * triangles)), vertices, low);
  const Bucketed_items<Index> sorted(by_low.items(), vertices, high);
  std::vector<Index> opposite(3 * triangles, NONE);
  for (std::size_t k = 1; k < sorted.items().size(); ++k) {
    const Index s = sorted.items()[k - 1], r = sorted.items()[k];
    if (low(s) == low(r) && high(s) == high(r)) {
      opposite[s] = r;
      opposite[r] = s;
    }
  }
  return opposite;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_OPPOSITE_SIDES_H
