// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_VERTEX_RELOCATION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_VERTEX_RELOCATION_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/face_geometry.h>

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The functions by which a placement that exchanges vertices relocates their clusters.
struct Vertex_relocation
{
  std::size_t rounds = 0; // with exchanges
  // Merges cluster `x` into a neighbor, if possible into `into`, and forms it again around face `f` of the surface.
  // Returns whether this was possible.
  std::function<bool(Index x, Index into, Index f)> relocate;
  // Returns the point nearest to `p` that is allowed for the vertex of cluster `x`.
  std::function<Vector(Index x, const Vector& p)> within_bounds;
  // Restores all clusters.
  std::function<void()> undo;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_VERTEX_RELOCATION_H
