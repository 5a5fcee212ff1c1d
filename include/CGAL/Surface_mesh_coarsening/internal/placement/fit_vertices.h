// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// What a fit does: see `Fitted_placement`. After `rounds` rounds, `exchange_rounds` rounds exchange vertices; they end early when
// there are no profitable exchanges. Two rounds without exchange follow, and further ones if only the angles are not good enough.
// The plain fit is the result unless the last mesh is closer and its angles are no worse.
struct Fit_choice
{
  std::size_t rounds;
  double mean_angle; // in degrees
  std::size_t exchange_rounds = 0;
};

// The positions of a coarse mesh, its mean squared distance from the input in the direction in which it is larger, and the mean of
// its smallest angles.
struct Fitted_mesh
{
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

class Coarse_mesh;

// Fits all vertices together, starting from quadrics.
void fit_vertices(Coarse_mesh& mesh, const Fit_choice& choice);
void fit_vertices(const Clustered_faces& surface, const Border_arcs& border, const Fit_choice& choice,
                  std::vector<Triangle>& triangles, std::vector<Vector>& positions);

// The same from given positions, without exchanges.
void fit_vertices_from(const Clustered_faces& surface, const Border_arcs& border, const Fit_choice& choice,
                       std::vector<Triangle>& triangles, std::vector<Vector>& positions);

} // namespace CGAL::Surface_mesh_coarsening::internal

#ifndef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#include <CGAL/Surface_mesh_coarsening/internal/placement/fit_vertices_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_H
