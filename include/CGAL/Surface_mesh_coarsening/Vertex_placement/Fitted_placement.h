// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_FITTED_PLACEMENT_H
#define CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_FITTED_PLACEMENT_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/defaults.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/fit_vertices.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningPlacements
/// \cgalModels `GlobalVertexPlacement`
///
/// fits all vertices together to the input, starting from `Quadric_placement`. Each round finds the closest points of samples
/// of the input on the coarse mesh, and of samples of the coarse mesh on the input. It then solves a sparse linear least squares
/// problem for the movements of the vertices that bring these points together. Between rounds, edges of the coarse mesh are
/// flipped. Flips with the best ratio of the decrease of the distance to the loss in angles come first, until the mean
/// over the triangles of the smallest angle has decreased to a bound.
///
/// With a goal below the default of 40 degrees, each movement of a vertex is judged: if the distance around the vertex increases
/// by more than the change of the angles is worth, the vertex moves back. With the goal 0, the mean is 33 to 36 degrees on smooth
/// models, and less at sharp edges.
///
/// If features are kept, polylines are fitted to the feature lines together with the surface; corners do not move.
class Fitted_placement
{
public:
  /// the number of fits of the default placement
  static constexpr std::size_t default_rounds = 5;

  /// \param rounds the number of fits, at most 2 for clusters of dual cells that are more than 0.3 times the cells
  /// \param mean_angle the mean over the triangles of their smallest angle that flips aim at, in degrees, between 0 and 60. While
  /// the mean is larger, flips that lower the distance are made. If the mean is smaller at the start, flips that increase it and
  /// add little to the distance are made.
  /// \throws Invalid_input if `mean_angle` is out of range.
  explicit Fitted_placement(std::size_t rounds = default_rounds, double mean_angle = Coarsening_defaults::mean_angle)
    : rounds_(rounds),
      mean_angle_(mean_angle)
  {
    if (!(mean_angle >= 0 && mean_angle <= 60))
      throw Invalid_input("the mean angle of a fit is " + internal::number_text(mean_angle) + ", not in [0, 60]");
  }

  /// places the vertices of all clusters, and may flip edges of the coarse mesh.
  /// \param surface the clusters
  /// \param border the arcs of the vertices on the border, which do not move, and on feature lines, which may move
  /// \param triangles the triangles of the coarse mesh
  /// \param positions the positions of the vertices; on entry, vertices on the border have their positions
  void operator()(const Clustered_surface& surface, const Border_arcs& border,
                  std::vector<std::array<std::uint32_t, 3> >& triangles,
                  std::vector<Clustered_surface::Point_3>& positions) const
  {
    std::vector<internal::Vector> fitted = internal::to_vectors(positions);
    internal::fit_vertices(surface.clusters(), border, choice(), triangles, fitted);
    positions = internal::to_points(fitted);
  }

  /// \cond SKIP_IN_MANUAL
  internal::Fit_choice choice() const { return {rounds_, mean_angle_}; }
  /// \endcond

private:
  std::size_t rounds_;
  double mean_angle_;
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_FITTED_PLACEMENT_H
