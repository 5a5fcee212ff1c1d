// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_IMPL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_IMPL_H

#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/defaults.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Angle_improvement.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Coarse_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Edge_flips.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Plane_fit.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Surface_fit.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Vertex_exchange.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/fit_vertices.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Returns whether the result has all vertices of the input.
inline bool has_all_vertices(const Clustered_faces& surface)
{
  for (std::size_t x = 0; x < surface.number_of_clusters(); ++x)
    if (surface.single_vertex(x) == NONE)
      return false;
  return true;
}

// The rounds of the fit on one coarse mesh.
class Vertex_fit
{
public:
  // `mean_angle` is the goal in degrees.
  Vertex_fit(Coarse_mesh& mesh, double mean_angle)
    : mesh_(mesh), mean_angle_(mean_angle), judges_movements_(mean_angle < Coarsening_defaults::mean_angle),
      keeps_vertices_(has_all_vertices(mesh.surface())), fit_(mesh), flips_(mesh, mean_angle), exchange_(mesh), angles_(mesh),
      planes_(mesh, fit_)
  {}

  // The first step of a round. From now on, every `step`-th sample of the input is used.
  void find_feet(std::size_t step = 1)
  {
    if (has_feet_ && step == step_)
      return;
    fit_.find_feet(step);
    has_feet_ = true;
    step_ = step;
    if (!before_.empty())
      undo_harmful_movements();
    before_.clear();
  }

  // From now on, the exchange rate between angles and distance changes slowly.
  void keep_rate()
  {
    is_steady_ = true;
    flips_.bound_rate();
  }

  // From now on, the mean angle matters more than the distance.
  void correct_angles() { only_angles_matter_ = true; }

  // Returns the number of exchanged vertices. The flips reach the goal of the mean angle after `rounds_to_goal` rounds.
  std::size_t advance(bool exchanges, std::size_t rounds_to_goal = 1)
  {
    if (is_steady_)
      flips_.run_steadily(mean_angle_ + reserve_of_steady - current_angle(), only_angles_matter_);
    else
      flips_.run(next_angle(rounds_to_goal) / degrees_per_radian);
    const std::size_t exchanged = exchanges ? exchange_.run(flips_.worth()) : 0;
    if (!keeps_vertices_)
      move_vertices(exchanges ? coarse_tolerance : fine_tolerance);
    has_feet_ = false;
    return exchanged;
  }

  // Completes all rounds, or a group of rounds.
  void settle()
  {
    find_feet();
    if (keeps_vertices_)
      return;
    Angle_worth worth = flips_.worth();
    worth.narrow_rate *= final_factor();
    angles_.run(worth);
    planes_.run(flips_.worth());
    has_feet_ = false;
  }

  // Returns the mean squared distance in the direction in which it is larger. The feet of the samples must be up to date.
  double error() const { return mesh_.samples().squared_distance(); }

  // Returns the current mesh. The feet of the samples must be up to date.
  Fitted_mesh mesh() const
  {
    return {mesh_.positions(), error(), current_angle()};
  }

private:
  static constexpr double degrees_per_radian = 180 / CGAL_PI;
  // In degrees: movements after the last flips reduce the angles slightly.
  static constexpr double reserve = 0.4, reserve_of_steady = 0.2;
  // Exchanges change the equations of the next round more than an inexact solution does.
  static constexpr double coarse_tolerance = 1e-2, fine_tolerance = 1e-3;
  // Narrow triangles that remain at the end of a group of rounds are final, so their worth is increased. Clusters that are merged by
  // quadrics are long, in particular clusters of cells, so more of their triangles would be narrow. With factor 4 instead of 8, 26
  // of 286 triangles of elephant.off are below 25 degrees instead of at most 20. Without feedback, clusters of faces are not merged by
  // quadrics, and flips do not count narrow triangles either.
  double final_factor() const
  {
    constexpr double with_cells = 12, with_feedback = 8, otherwise = 2;
    return mesh_.surface().has_cells() ? with_cells : mesh_.may_relocate() ? with_feedback : otherwise;
  }
  // A movement that increases the cost by less is left to the next round, in units of the mean cost of a triangle. With 0.3, the
  // models of compare_quality are 1 % closer, but thin parts have more pairs of intersecting triangles.
  static constexpr double harmless_part = 1;
  static constexpr std::size_t steps_of_vertex = 64;

  // The fit is linear between feet, so a vertex may move too far, in particular near sharp edges. If movements are judged, vertices
  // around which the cost has increased move half of the way back, then all of the way. In rounds of exchanges, very harmful
  // movements are undone when the feet have been found again.
  void move_vertices(double tolerance)
  {
    std::vector<Vector>& positions = mesh_.positions();
    const std::vector<Vector> before = positions;
    const std::vector<double> costs = judges_movements_ || is_steady_ ? costs_of_triangles() : std::vector<double>();
    fit_.move_vertices(tolerance);
    for (std::size_t x = 0; x < positions.size(); ++x)
      positions[x] = mesh_.within_bounds(Index(x), positions[x]);
    if (judges_movements_)
      for (const double part : {0.5, 0.})
        retreat(before, costs, part);
    if (is_steady_) {
      before_ = before;
      costs_before_ = costs;
    }
  }

  // Moves vertices back around which the last movement has increased the cost by much, the most harmful movement first. Vertices on
  // lines are left out, because a single one could pass its neighbor on the line.
  void undo_harmful_movements()
  {
    const double harmless = harmless_part * mesh_.mean_cost();
    std::vector<double> increases(costs_before_.size()); // of triangles
    for_each_number(mesh_.context(), increases.size(), [&](Index t) { increases[t] = increase(t); });
    const auto sum_around = [&](Index v) { return sum(v, [&](Index t) { return increases[t]; }); };
    std::vector<std::pair<double, Index> > harmful;
    for (Index v = 0; v < before_.size(); ++v)
      if (!mesh_.is_on_border(v) && sum_around(v) > harmless)
        harmful.emplace_back(-sum_around(v), v);
    std::sort(harmful.begin(), harmful.end());
    for (const auto& movement : harmful) {
      const Index v = movement.second;
      mesh_.context().poll(steps_of_vertex);
      const double now = sum_around(v);
      const auto is_better = [&]() { return sum(v, [this](Index t) { return increase(t); }) < now && keeps_sides(v); };
      if (now > harmless && mesh_.move_if(v, mesh_.within_bounds(v, before_[v]), is_better))
        for (const Index t : mesh_.around(v))
          increases[t] = increase(t);
    }
  }

  // Returns by how much the cost of a triangle, minus the worth of its angle, exceeds the cost before the last movement.
  double increase(Index t) const { return mesh_.cost(t, flips_.worth()) - costs_before_[t]; }

  // Returns the sum of the values of the triangles around a vertex.
  template <class Value>
  double sum(Index v, const Value& value) const
  {
    double sum = 0;
    for (const Index t : mesh_.around(v))
      sum += value(t);
    return sum;
  }

  // Returns whether no triangle around a vertex has turned over since the last movement.
  bool keeps_sides(Index v) const
  {
    const std::vector<Index>& around = mesh_.around(v);
    return std::all_of(around.begin(), around.end(),
                       [this](Index t) { return dot(mesh_.normal(t), normal_of(before_, mesh_.triangle(t))) > 0; });
  }

  // Keeps `part` of the movement of vertices around which the cost has increased by more than rounding errors.
  void retreat(const std::vector<Vector>& before, const std::vector<double>& costs, double part)
  {
    constexpr double rounding = 1e-9;
    has_feet_ = false;
    find_feet(step_);
    const std::vector<double> costs_now = costs_of_triangles();
    std::vector<Vector>& positions = mesh_.positions();
    for (std::size_t x = 0; x < positions.size(); ++x) {
      double change = 0, size = 0;
      for (const Index t : mesh_.around(Index(x))) {
        change += costs_now[t] - costs[t];
        size += std::abs(costs_now[t]) + std::abs(costs[t]);
      }
      if (change > rounding * size)
        positions[x] = mesh_.within_bounds(Index(x), part * positions[x] + (1 - part) * before[x]);
    }
  }

  // Returns the contributions of the triangles to the squared distance, minus the worth of their angles.
  std::vector<double> costs_of_triangles() const
  {
    Angle_worth worth = flips_.worth();
    if (!mesh_.may_relocate())
      worth.narrow_rate = 0; // as in flips
    std::vector<double> costs(mesh_.triangles().size());
    for_each_number(mesh_.context(), costs.size(), [&](Index t) { costs[t] = mesh_.cost(t, worth); });
    return costs;
  }

  double current_angle() const
  {
    double angles = 0;
    for (std::size_t t = 0; t < mesh_.triangles().size(); ++t)
      angles += mesh_.angle(Index(t));
    return angles * degrees_per_radian / (std::max)(double(mesh_.triangles().size()), 1.);
  }

  // Returns the mean angle that flips aim at.
  double next_angle(std::size_t rounds_to_goal) const
  {
    const double goal = mean_angle_ + reserve;
    if (rounds_to_goal == 1)
      return goal;
    const double now = (std::min)(current_angle(), goal);
    return now + (goal - now) / double(rounds_to_goal);
  }

  Coarse_mesh& mesh_;
  const double mean_angle_;
  const bool judges_movements_;
  std::size_t step_ = 1;
  bool has_feet_ = false;
  // The positions before the last movement, until the feet are found again, and the costs of the triangles then.
  std::vector<Vector> before_;
  std::vector<double> costs_before_;
  bool is_steady_ = false;
  bool only_angles_matter_ = false;
  const bool keeps_vertices_; // only the diagonals of polygons change
  Surface_fit fit_;
  Edge_flips flips_;
  Vertex_exchange exchange_;
  Angle_improvement angles_;
  Plane_fit planes_;
};

// A cluster that is the cell of one vertex keeps this vertex.
inline void place_by_quadrics(const Clustered_faces& surface, const Border_arcs& border, std::vector<Vector>& positions)
{
  // Clusters of cells are small, so a weak pull is sufficient. Measured at 60 and 80 % of the vertices of the Horse and the
  // Fandisk: with the default pull, the RMS distance is a third larger.
  constexpr double pull_in_cells = 1e-5;
  const double pull = surface.has_cells() ? pull_in_cells : Quadric_placement::default_pull;
  for_each_chunk(surface.context(), positions.size(), 16, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t x = begin; x < end; ++x) {
      if (!surface.context().is_parallel())
        surface.context().poll(surface.faces(x).size());
      if (const Index v = surface.single_vertex(x); v != NONE)
        positions[x] = surface.point(v);
      else if (!border.is_on_border(x))
        positions[x] = quadric_position(surface, x, pull);
    }
  });
}

// Continues a fit with rounds that exchange vertices, and some rounds without exchange. Returns whether the mesh is closer then,
// and its angles reach the goal or are not worse.
inline bool improves_by_exchanges(Vertex_fit& fit, const Fitted_mesh& plain, const Fit_choice& choice, const Run_context& context)
{
  // The number of rounds after the last exchange, and of further rounds while only the angles are not good enough.
  constexpr std::size_t last_rounds = 2, max_corrections = 3;
  // The rounds end when two of them together lower the squared distance by less than this part. In the runs of compare_quality, 0.02
  // is 0.2 % closer and takes 4 % longer; 0.05 is 0.3 % farther and takes 4 % less.
  constexpr double min_gain = 0.03;
  fit.keep_rate();
  std::size_t exchanged = 1;
  std::vector<double> errors{plain.error};
  const auto pays = [&]() { return errors.size() < 3 || errors.back() <= (1 - min_gain) * *(errors.end() - 3); };
  for (std::size_t i = 0; i < choice.exchange_rounds && exchanged > 0 && pays(); ++i) {
    exchanged = fit.advance(true);
    fit.find_feet();
    errors.push_back(fit.error());
    context.step_done(Coarsening_stage::FEEDBACK, i + 1, choice.exchange_rounds + last_rounds);
  }
  for (std::size_t i = 0; i < last_rounds; ++i) {
    fit.advance(false);
    if (i + 1 < last_rounds)
      fit.find_feet();
    context.step_done(Coarsening_stage::FEEDBACK, choice.exchange_rounds + i + 1, choice.exchange_rounds + last_rounds);
  }
  fit.settle();
  Fitted_mesh mesh = fit.mesh();
  for (std::size_t i = 0; i < max_corrections && mesh.error < plain.error && !mesh.improves(plain, choice.mean_angle); ++i) {
    fit.correct_angles();
    fit.advance(false);
    fit.settle();
    mesh = fit.mesh();
  }
  return mesh.improves(plain, choice.mean_angle);
}

// The rounds without exchange. Merged cells begin with long triangles and close to the input, so the angles approach their goal in
// these rounds.
inline void run_plain_rounds(Vertex_fit& fit, std::size_t rounds, bool has_cells, const Run_context& context)
{
  // Before the last rounds, every `step_before`-th sample is sufficient.
  constexpr std::size_t rounds_with_all = 3, step_before = 4;
  for (std::size_t left = rounds; left > 0; --left) {
    fit.find_feet(left > rounds_with_all ? step_before : 1);
    fit.advance(false, has_cells ? left : 1);
    context.step_done(Coarsening_stage::PLACEMENT, rounds + 1 - left, rounds);
  }
  fit.settle();
}

// Returns whether the triangles are the faces of the input. A polygon would have several triangles.
inline bool are_input(const Clustered_faces& surface, const std::vector<Triangle>& triangles)
{
  if (!has_all_vertices(surface))
    return false;
  std::size_t faces = 0;
  for_each_meeting_point(surface.labels(), [&](Index, const std::vector<Index>&) { ++faces; });
  return triangles.size() == faces;
}

CGAL_SURFACE_MESH_COARSENING_INLINE void fit_vertices_from(const Clustered_faces& surface, const Border_arcs& border,
                                                           const Fit_choice& choice, std::vector<Triangle>& triangles,
                                                           std::vector<Vector>& positions)
{
  Coarse_mesh mesh(surface, border, triangles, positions, nullptr);
  Vertex_fit fit(mesh, choice.mean_angle);
  run_plain_rounds(fit, choice.rounds, surface.has_cells(), surface.context());
  triangles = mesh.triangles();
}

CGAL_SURFACE_MESH_COARSENING_INLINE void fit_vertices(Coarse_mesh& mesh, const Fit_choice& wanted)
{
  const Clustered_faces& surface = mesh.surface();
  place_by_quadrics(surface, mesh.border(), mesh.positions());
  if (are_input(surface, mesh.triangles()))
    return;
  Fit_choice choice = wanted;
  if (surface.has_cells() && !has_merged_cells(surface)) {
    // Five rounds are no closer at 60 and 80 % of the vertices of the Horse.
    constexpr std::size_t rounds_of_dense = 2;
    choice.mean_angle = 0;
    choice.rounds = (std::min)(choice.rounds, rounds_of_dense);
  }
  Vertex_fit fit(mesh, choice.mean_angle);
  const Run_context& context = surface.context();
  run_plain_rounds(fit, choice.rounds, surface.has_cells(), context);
  if (!mesh.may_relocate())
    return;
  context.stage_ends(Coarsening_stage::PLACEMENT);
  context.stage_begins(Coarsening_stage::FEEDBACK);
  const std::vector<Triangle> triangles = mesh.triangles();
  const Fitted_mesh plain = fit.mesh();
  if (!improves_by_exchanges(fit, plain, choice, context)) {
    mesh.clusters().undo();
    mesh.restore(triangles, plain.positions);
  }
}

CGAL_SURFACE_MESH_COARSENING_INLINE void fit_vertices(const Clustered_faces& surface, const Border_arcs& border,
                                                      const Fit_choice& choice, std::vector<Triangle>& triangles,
                                                      std::vector<Vector>& positions)
{
  Coarse_mesh mesh(surface, border, triangles, positions, nullptr);
  fit_vertices(mesh, choice);
  triangles = mesh.triangles();
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_IMPL_H
