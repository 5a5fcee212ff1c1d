// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_FITTED_PLACEMENT_H
#define CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_FITTED_PLACEMENT_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/internal/Surface_fit.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningPlacements
/// \cgalModels `GlobalVertexPlacement`
///
/// fits all vertices together to the input, starting from `Quadric_placement`: in turns, looks for the points of the coarse
/// mesh closest to those of the input, and solves the sparse linear least squares problem for the positions that bring them
/// together. In between, edges of the coarse mesh are flipped where that lowers the distance clearly and makes no angle
/// smaller than the least angle.
class Fitted_placement
{
public:
  /// \param rounds the number of fits
  /// \param least_angle the angle, in degrees, below which a flip may not bring the angles of triangles
  explicit Fitted_placement(std::size_t rounds = 6, double least_angle = 25) : rounds_(rounds), least_angle_(least_angle) {}

  /// places the vertices of all clusters, and may flip edges of the coarse mesh.
  /// \param surface the clusters
  /// \param border keeps vertices on the border
  /// \param triangles the triangles of the coarse mesh
  /// \param positions the positions of the vertices; those on the border are placed already
  void operator()(const Clustered_surface& surface, const Border_arcs& border,
                  std::vector<std::array<std::uint32_t, 3> >& triangles,
                  std::vector<Clustered_surface::Point>& positions) const
  {
    using namespace internal;
    const Quadric_placement start;
    for (std::size_t x = 0; x < positions.size(); ++x)
      if (!border.is_on_border(x))
        positions[x] = start(surface, x);
    Coarse_surface coarse(triangles, positions.size());
    Surface_fit fit(surface, coarse, positions);
    for (std::size_t i = 0; i < rounds_; ++i) {
      fit.find_feet();
      fit.flip_edges(least_angle_ / degrees_per_radian);
      fit.solve(inertia);
      border.pull_back(positions);
    }
    triangles = coarse.triangles();
  }

private:
  static constexpr double inertia = 0.01;
  static constexpr double degrees_per_radian = 180 / 3.14159265358979323846;
  std::size_t rounds_;
  double least_angle_;
};

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_FITTED_PLACEMENT_H
