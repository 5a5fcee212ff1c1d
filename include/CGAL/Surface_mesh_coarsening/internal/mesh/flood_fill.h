// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FLOOD_FILL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FLOOD_FILL_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Visitor_handle.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Traverses the faces breadth first from `seed`, which the caller has marked. The edge after corner `c` is crossed to
// face `g` if `enter(c, g)`, which marks `g`. Appends the faces to `reached` in the order of traversal.
// `CGAL::Polygon_mesh_processing::connected_component()` stores visited faces in a tree and cannot be cancelled.
template <class Enter>
void flood_fill(const Flat_mesh& m, Index seed, std::vector<Index>& reached, const Cancellation_point& cancellation,
                const Enter& enter)
{
  reached.assign(1, seed);
  for (std::size_t i = 0; i < reached.size(); ++i) {
    cancellation.poll();
    for (const Index c : m.corners(reached[i])) {
      const Index g = m.face_across[c];
      if (g != NONE && enter(c, g))
        reached.push_back(g);
    }
  }
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FLOOD_FILL_H
