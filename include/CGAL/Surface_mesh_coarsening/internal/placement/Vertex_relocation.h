// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_VERTEX_RELOCATION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_VERTEX_RELOCATION_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/refinement/Relocation.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The functions by which a placement that exchanges vertices relocates their clusters.
struct Vertex_relocation
{
  std::size_t rounds = 0; // the number of rounds with exchanges
  // Called between the fit and the rounds with exchanges.
  std::function<void()> begins;
  // Triangles that get a vertex each from elsewhere. If there are any, the placement does nothing else.
  std::vector<Index> destinations;
  // Merges cluster `x` into a neighbor, if possible into `into`, and forms it again around one of some faces of the surface, the
  // first possible one.
  std::function<Relocation(Index x, Index into, const std::vector<Index>& faces)> relocate;
  // Returns the point nearest to `p` that is an admissible position of the vertex of cluster `x`.
  std::function<Vector(Index x, const Vector& p)> within_bounds;
  // Restores all clusters.
  std::function<void()> undo;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_VERTEX_RELOCATION_H
