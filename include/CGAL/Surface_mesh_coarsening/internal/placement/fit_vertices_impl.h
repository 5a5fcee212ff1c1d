// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_IMPL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_IMPL_H

#include <CGAL/Surface_mesh_coarsening/internal/base/inline.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Edge_flips.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Surface_fit.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Vertex_exchange.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/fit_vertices.h>

#include <CGAL/number_type_config.h>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The rounds of the fit on one coarse mesh.
class Vertex_fit
{
public:
  Vertex_fit(const Clustered_surface& surface, const Border_arcs& border, double mean_angle,
             const std::vector<Triangle>& triangles, std::vector<Vector>& positions, const Vertex_relocation& relocation)
    : surface_(surface), mean_angle_(mean_angle), positions_(positions), relocation_(relocation),
      coarse_(triangles, positions.size(), surface.features()), fit_(surface, border, coarse_, positions),
      flips_(coarse_, positions, fit_.samples(), surface.cancellation(), surface.execution()),
      exchange_(border, coarse_, positions, fit_.samples(), surface.cancellation())
  {}

  const std::vector<Triangle>& triangles() const { return coarse_.triangles(); }

  // What rounds begin with.
  void find_feet(std::size_t step = 1) { fit_.find_feet(step); }
  double cost() { return fit_.samples().sum_of_costs(); }

  // Returns the number of vertices exchanged.
  std::size_t advance(bool exchanges)
  {
    constexpr double degrees_per_radian = 180 / CGAL_PI;
    // The movements after the last flips take a little from the angles.
    constexpr double reserve = 0.4;
    constexpr double min_angle = 7;
    flips_.run((mean_angle_ + reserve) / degrees_per_radian, min_angle / degrees_per_radian);
    const std::size_t exchanged = exchanges ? exchange_.run(flips_.rate(), relocation_.relocate) : 0;
    fit_.move_vertices();
    for (std::size_t x = 0; x < positions_.size(); ++x)
      positions_[x] = relocation_.rounds > 0 ? relocation_.within_bounds(Index(x), positions_[x])
                                             : surface_.within_bounds(x, positions_[x]);
    return exchanged;
  }

private:
  const Clustered_surface& surface_;
  double mean_angle_;
  std::vector<Vector>& positions_;
  const Vertex_relocation& relocation_;
  Flippable_triangulation coarse_;
  Surface_fit fit_;
  Edge_flips flips_;
  Vertex_exchange exchange_;
};

inline void place_by_quadrics(const Clustered_surface& surface, const Border_arcs& border, std::vector<Vector>& positions)
{
  for (std::size_t x = 0; x < positions.size(); ++x) {
    surface.cancellation().poll(surface.faces(x).size());
    if (!border.is_on_border(x))
      positions[x] = quadric_position(surface, x, Quadric_placement::default_pull);
  }
}

CGAL_SURFACE_MESH_COARSENING_INLINE void fit_vertices(const Clustered_surface& surface, const Border_arcs& border,
                                                      std::size_t rounds, double mean_angle, std::vector<Triangle>& triangles,
                                                      std::vector<Vector>& positions, const Vertex_relocation& relocation)
{
  // Before the last rounds, one in so many samples will do.
  constexpr std::size_t rounds_with_all = 3, step_before = 4;
  place_by_quadrics(surface, border, positions);
  Vertex_fit fit(surface, border, mean_angle, triangles, positions, relocation);
  std::size_t left = rounds;
  for (const std::size_t last = relocation.rounds > 0 ? rounds - 2 * rounds / 3 : 0; left > last; --left) {
    fit.find_feet(left > rounds_with_all ? step_before : 1);
    fit.advance(false);
  }
  triangles = fit.triangles();
  if (relocation.rounds == 0)
    return;
  const std::vector<Vector> old_positions = positions;
  fit.find_feet();
  const double old_cost = fit.cost();
  std::size_t exchanged = 1;
  for (std::size_t i = 0; i < relocation.rounds && exchanged > 0; ++i, left -= left > 1) {
    exchanged = fit.advance(true);
    fit.find_feet();
  }
  for (; left > 0; --left) {
    fit.advance(false);
    fit.find_feet();
  }
  if (fit.cost() < old_cost) {
    triangles = fit.triangles();
  } else {
    positions = old_positions;
    relocation.undo();
  }
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_IMPL_H
