// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/refinement/Cluster_editing.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The functions by which a placement that exchanges vertices relocates their clusters.
struct Vertex_relocation
{
  std::size_t rounds = 0; // the number of rounds with exchanges
  // Called between the fit and the rounds with exchanges.
  std::function<void()> begins;
  // Merges cluster `x` into a neighbor, if possible into `into`, and forms it again around one of some faces of the surface, the
  // first possible one with which the vertices are within their bounds.
  std::function<Relocation(Index x, Index into, const std::vector<Index>& faces, const std::vector<Vector>& positions)> relocate;
  // Returns the point nearest to `p` that is an admissible position of the vertex of cluster `x`.
  std::function<Vector(Index x, const Vector& p)> within_bounds;
  // Restores all clusters.
  std::function<void()> undo;
};

// A coarse mesh, its mean squared distance from the input in the direction in which it is larger, and the mean of its smallest
// angles.
struct Fitted_mesh
{
  std::vector<Triangle> triangles;
  std::vector<Vector> positions;
  double error = 0, mean_angle = 0;

  // Returns whether this mesh is closer than another one, and its angles reach the goal or are not worse.
  bool improves(const Fitted_mesh& other, double wanted_angle) const
  {
    return error < other.error && mean_angle >= (std::min)(wanted_angle, other.mean_angle);
  }
};

// If the clusters are more than this part of the cells of vertices, only the distance counts: few faces lie under a triangle,
// and flips for angles would leave them.
constexpr double min_share_of_dense = 0.3;

// Returns whether the clusters consist of several cells, in the mean.
inline bool has_merged_cells(const Clustered_faces& surface)
{
  return surface.has_cells() && surface.clusters_per_cell() <= min_share_of_dense;
}

// Fits all vertices together, starting from quadrics; see `Fitted_placement`. `mean_angle` is in degrees. After `rounds` rounds,
// `relocation` determines the number of rounds that exchange vertices; they end early when there are no profitable exchanges.
// Two rounds without exchange follow, and further ones if only the angles are not good enough. The plain fit is the result unless
// the last mesh is closer and its angles are no worse.
void fit_vertices(const Clustered_faces& surface, const Border_arcs& border, std::size_t rounds, double mean_angle,
                  std::vector<Triangle>& triangles, std::vector<Vector>& positions,
                  const Vertex_relocation& relocation = Vertex_relocation());

// The same from given positions, without exchanges.
void fit_vertices_from(const Clustered_faces& surface, const Border_arcs& border, std::size_t rounds, double mean_angle,
                       std::vector<Triangle>& triangles, std::vector<Vector>& positions);

} // namespace CGAL::Surface_mesh_coarsening::internal

#ifndef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#include <CGAL/Surface_mesh_coarsening/internal/placement/fit_vertices_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_H
