// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_VERTEX_RELOCATION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_VERTEX_RELOCATION_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/face_geometry.h>

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// What a placement that exchanges vertices asks of the clusters, which follow.
struct Vertex_relocation
{
  std::size_t rounds = 0; // with exchanges
  // Moves cluster `x` into a neighbor, to `into` if possible, and back to face `f` of the surface. Returns whether it did.
  std::function<bool(Index x, Index into, Index f)> relocate;
  // The point nearest to `p` where the vertex of cluster `x` may lie.
  std::function<Vector(Index x, const Vector& p)> within_bounds;
  // Gives all clusters the faces back that they had.
  std::function<void()> undo;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_VERTEX_RELOCATION_H
