// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_IMPL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_IMPL_H

#include <CGAL/Surface_mesh_coarsening/internal/base/inline.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Edge_flips.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Surface_fit.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/fit_vertices.h>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

CGAL_SURFACE_MESH_COARSENING_INLINE void fit_vertices(const Clustered_surface& surface, const Border_arcs& border,
                                                      std::size_t rounds, double mean_angle, std::vector<Triangle>& triangles,
                                                      std::vector<Vector>& positions)
{
  constexpr double degrees_per_radian = 180 / 3.14159265358979323846;
  // The movements after the last flips take a little from the angles.
  constexpr double reserve = 0.4;
  constexpr double min_angle = 7;
  // Before the last rounds, one in so many samples will do.
  constexpr std::size_t rounds_with_all = 3, step_before = 4;
  for (std::size_t x = 0; x < positions.size(); ++x) {
    surface.cancellation().poll(surface.faces(x).size());
    if (!border.is_on_border(x))
      positions[x] = quadric_position(surface, x, Quadric_placement::default_pull);
  }
  Flippable_triangulation coarse(triangles, positions.size(), surface.features());
  Surface_fit fit(surface, border, coarse, positions);
  Edge_flips flips(coarse, positions, fit.samples(), surface.cancellation());
  for (std::size_t i = 0; i < rounds; ++i) {
    fit.find_feet(i + rounds_with_all < rounds ? step_before : 1);
    flips.run((mean_angle + reserve) / degrees_per_radian, min_angle / degrees_per_radian);
    fit.move_vertices();
    for (std::size_t x = 0; x < positions.size(); ++x)
      positions[x] = surface.within_bounds(x, positions[x]);
  }
  triangles = coarse.triangles();
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_IMPL_H
