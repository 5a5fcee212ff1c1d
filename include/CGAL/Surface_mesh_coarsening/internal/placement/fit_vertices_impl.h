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

// A coarse mesh, how far it is from the input, the squared distance of both directions, and the mean of its smallest angles.
struct Fitted_mesh
{
  std::vector<Triangle> triangles;
  std::vector<Vector> positions;
  double error = 0, mean_angle = 0;

  // Whether it is nearer than another one, and its angles are as they should be, or not worse.
  bool improves(const Fitted_mesh& other, double wanted_angle) const
  {
    return error < other.error && mean_angle >= (std::min)(wanted_angle, other.mean_angle);
  }
};

// The rounds of the fit on one coarse mesh.
class Vertex_fit
{
public:
  Vertex_fit(const Clustered_faces& surface, const Border_arcs& border, double mean_angle,
             const std::vector<Triangle>& triangles, std::vector<Vector>& positions, const Vertex_relocation& relocation)
    : surface_(surface), mean_angle_(mean_angle), positions_(positions), relocation_(relocation),
      coarse_(triangles, positions.size(), surface.features()), fit_(surface, border, coarse_, positions),
      flips_(coarse_, positions, fit_.samples(), surface.cancellation(), surface.execution()),
      exchange_(border, coarse_, positions, fit_.samples(), relocation, surface.cancellation(), surface.execution())
  {}

  const std::vector<Triangle>& triangles() const { return coarse_.triangles(); }

  // What rounds begin with.
  void find_feet(std::size_t step = 1) { fit_.find_feet(step); }

  void exchange_at_faults() { exchange_.run_at(relocation_.faulty); }

  // From now on, angles and distance are traded at a rate that changes slowly.
  void keep_rate() { is_steady_ = true; }

  // Returns the number of vertices exchanged.
  std::size_t advance(bool exchanges)
  {
    // The movements after the last flips take a little from the angles.
    constexpr double reserve = 0.4;
    constexpr double min_angle = 7;
    flips_.run((mean_angle_ + reserve) / degrees_per_radian, min_angle / degrees_per_radian, is_steady_);
    const std::size_t exchanged = exchanges ? exchange_.run(flips_.rate()) : 0;
    fit_.move_vertices();
    for (std::size_t x = 0; x < positions_.size(); ++x)
      positions_[x] = relocation_.rounds > 0 ? relocation_.within_bounds(Index(x), positions_[x])
                                             : surface_.within_bounds(x, positions_[x]);
    return exchanged;
  }

  // The mesh as it is, with feet found.
  Fitted_mesh mesh() const
  {
    double angles = 0;
    for (const Triangle& t : triangles())
      angles += smallest_angle(positions_, t);
    const double number = (std::max)(double(triangles().size()), 1.);
    return {triangles(), positions_, fit_.samples().squared_distance(), angles * degrees_per_radian / number};
  }

private:
  static constexpr double degrees_per_radian = 180 / CGAL_PI;

  const Clustered_faces& surface_;
  double mean_angle_;
  bool is_steady_ = false;
  std::vector<Vector>& positions_;
  const Vertex_relocation& relocation_;
  Flippable_triangulation coarse_;
  Surface_fit fit_;
  Edge_flips flips_;
  Vertex_exchange exchange_;
};

inline void place_by_quadrics(const Clustered_faces& surface, const Border_arcs& border, std::vector<Vector>& positions)
{
  for (std::size_t x = 0; x < positions.size(); ++x) {
    surface.cancellation().poll(surface.faces(x).size());
    if (!border.is_on_border(x))
      positions[x] = quadric_position(surface, x, Quadric_placement::default_pull);
  }
}

CGAL_SURFACE_MESH_COARSENING_INLINE double fit_vertices(const Clustered_faces& surface, const Border_arcs& border,
                                                      std::size_t rounds, double mean_angle, std::vector<Triangle>& triangles,
                                                      std::vector<Vector>& positions, const Vertex_relocation& relocation)
{
  // Before the last rounds, one in so many samples will do.
  constexpr std::size_t rounds_with_all = 3, step_before = 4;
  // After the last exchange.
  constexpr std::size_t last_rounds = 2;
  if (!relocation.faulty.empty()) {
    Vertex_fit fit(surface, border, mean_angle, triangles, positions, relocation);
    fit.find_feet();
    fit.exchange_at_faults();
    triangles = fit.triangles();
    return 0;
  }
  place_by_quadrics(surface, border, positions);
  Vertex_fit fit(surface, border, mean_angle, triangles, positions, relocation);
  for (std::size_t left = rounds; left > 0; --left) {
    fit.find_feet(left > rounds_with_all ? step_before : 1);
    fit.advance(false);
    surface.cancellation().step_done(Coarsening_stage::PLACEMENT, rounds + 1 - left, rounds);
  }
  triangles = fit.triangles();
  if (relocation.rounds == 0)
    return 0;
  relocation.begins();
  fit.find_feet();
  Fitted_mesh best = fit.mesh();
  const double plain_distance = best.error;
  fit.keep_rate();
  bool is_plain = true;
  std::size_t exchanged = 1;
  for (std::size_t i = 0; i < relocation.rounds && exchanged > 0; ++i) {
    exchanged = fit.advance(true);
    fit.find_feet();
    surface.cancellation().step_done(Coarsening_stage::FEEDBACK, i + 1, relocation.rounds + last_rounds);
  }
  for (std::size_t i = 0; i <= last_rounds; ++i) {
    Fitted_mesh mesh = fit.mesh();
    if (mesh.improves(best, mean_angle)) {
      best = std::move(mesh);
      is_plain = false;
    }
    if (i < last_rounds) {
      fit.advance(false);
      fit.find_feet();
      surface.cancellation().step_done(Coarsening_stage::FEEDBACK, relocation.rounds + i + 1, relocation.rounds + last_rounds);
    }
  }
  if (is_plain)
    relocation.undo();
  triangles = best.triangles;
  positions = best.positions;
  return plain_distance;
}

CGAL_SURFACE_MESH_COARSENING_INLINE double squared_fit_distance(const Clustered_faces& surface,
                                                                const std::vector<Triangle>& triangles,
                                                                const std::vector<Vector>& positions)
{
  const Flippable_triangulation coarse(triangles, positions.size(), surface.features());
  Fit_samples samples(surface, coarse, positions);
  samples.find_feet(1);
  return samples.squared_distance();
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_IMPL_H
