// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_ANGLE_IMPROVEMENT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_ANGLE_IMPROVEMENT_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Angle_worth.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Fit_samples.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Trial_fan.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Moves vertices of narrow triangles where what the angles gain is worth more than what the distance loses.
class Angle_improvement
{
public:
  // `within_bounds` returns the nearest point where a vertex may lie.
  Angle_improvement(const Border_arcs& border, const Flippable_triangulation& coarse, std::vector<Vector>& positions,
                    Fit_samples& samples, std::function<Vector(Index, const Vector&)> within_bounds,
                    const Cancellation_point& cancellation)
    : border_(border), coarse_(coarse), positions_(positions), samples_(samples), within_bounds_(std::move(within_bounds)),
      cancellation_(cancellation)
  {}

  // The narrowest triangle comes first.
  void run(const Angle_worth& worth)
  {
    worth_ = worth;
    std::vector<std::pair<double, Index> > narrow;
    for (std::size_t t = 0; t < coarse_.triangles().size(); ++t) {
      cancellation_.poll();
      const double angle = angle_of(Index(t));
      if (angle < narrow_angle)
        narrow.emplace_back(angle, Index(t));
    }
    std::sort(narrow.begin(), narrow.end());
    for (const auto& [angle, t] : narrow)
      if (angle_of(t) < narrow_angle)
        improve(t);
  }

private:
  static constexpr std::size_t max_valence = 32;
  static constexpr double min_turn_cosine = 0.8;

  struct Move
  {
    double gain = 0;
    Index vertex = NONE;
    Vector to{{0, 0, 0}};
  };

  double angle_of(Index t) const { return smallest_angle(positions_, coarse_.triangles()[t]); }

  // Makes the best of the moves of its corners, if there is one.
  void improve(Index t)
  {
    Move best;
    for (int i = 0; i < 3; ++i) {
      const Index v = coarse_.triangles()[t][std::size_t(i)];
      if (!border_.is_on_border(v) && coarse_.around(v).size() <= max_valence)
        try_moves(t, i, best);
    }
    if (best.vertex != NONE)
      make(best);
  }

  // Takes the move back if it does not pay with the distances of the triangles from the input counted, too.
  void make(const Move& move)
  {
    const std::vector<Index>& around = coarse_.around(move.vertex);
    const double before = cost_of(around);
    const Vector from = std::exchange(positions_[move.vertex], move.to);
    samples_.redistribute(around, around);
    if (cost_of(around) < before)
      return;
    positions_[move.vertex] = from;
    samples_.redistribute(around, around);
  }

  double cost_of(const std::vector<Index>& triangles) const
  {
    double sum = 0;
    for (const Index t : triangles)
      sum += samples_.cost(t) - worth_(angle_of(t));
    return sum;
  }

  void try_moves(Index t, int i, Move& best)
  {
    const Index v = coarse_.triangles()[t][std::size_t(i)];
    const double before = look_at_star(v);
    for (const Vector& place : places(t, i)) {
      cancellation_.poll(16);
      fan_.move_to(place);
      // Distances are not computed where angles do not gain.
      if (fan_.worth(worth_) <= worth_before_)
        continue;
      Vector better;
      fan_.squared_distances(place, better);
      const Vector to = within_bounds_(v, place + dot(better - place, normal_) * normal_);
      fan_.move_to(to);
      const double gain = before - (2 * samples_.weight() * fan_.squared_distances(to, better) - fan_.worth(worth_));
      if (gain > best.gain && fan_.is_sound(max_cosine_, min_turn_cosine)) {
        best.gain = gain;
        best.vertex = v;
        best.to = to;
      }
    }
  }

  // Prepares the triangles around a vertex. Returns what they cost.
  double look_at_star(Index v)
  {
    fan_.clear();
    normal_ = {{0, 0, 0}};
    worth_before_ = 0;
    double distances = 0, least = min_angle;
    for (const Index t : coarse_.around(v)) {
      const Triangle& c = coarse_.triangles()[t];
      const Vector n = normal_of(positions_, c);
      fan_.add_triangle(positions_[c[0]], positions_[c[1]], positions_[c[2]], coarse_.corner(t, v), n);
      samples_.for_each_on(t, [this](const Fit_samples::Sample& s) { fan_.add_sample(s.position); });
      normal_ = normal_ + n;
      const double angle = angle_of(t);
      least = (std::min)(least, angle);
      worth_before_ += worth_(angle);
      distances += 2 * samples_.cost_of_input(t);
    }
    const double length = std::sqrt(dot(normal_, normal_));
    normal_ = length > 0 ? (1 / length) * normal_ : normal_;
    max_cosine_ = std::cos(least) + 1e-12;
    return distances - worth_before_;
  }

  // Returns places for corner `i`: towards the mean of its neighbors, farther from the opposite edge, farther from the nearest
  // corner.
  std::vector<Vector> places(Index t, int i) const
  {
    const Triangle& c = coarse_.triangles()[t];
    const Index v = c[std::size_t(i)];
    const Vector &p = positions_[v], &a = positions_[c[std::size_t(i + 1) % 3]], &b = positions_[c[std::size_t(i + 2) % 3]];
    const Vector ab = b - a, pa = p - a, pb = p - b, way = coarse_.mean_of_neighbors(v, positions_) - p;
    const double square = dot(ab, ab);
    const Vector height = square > 0 ? pa - (dot(pa, ab) / square) * ab : pa;
    const double size = std::sqrt((std::max)({square, dot(pa, pa), dot(pb, pb)}));
    std::vector<Vector> found;
    for (const double part : {0.25, 0.5, 1.})
      found.push_back(p + part * (way - dot(way, normal_) * normal_));
    for (const Vector& d : {height, dot(pa, pa) < dot(pb, pb) ? pa : pb}) {
      const double length = std::sqrt(dot(d, d));
      if (length > 0)
        for (const double part : {0.07, 0.15, 0.3})
          found.push_back(p + (part * size / length) * d);
    }
    return found;
  }

  const Border_arcs& border_;
  const Flippable_triangulation& coarse_;
  std::vector<Vector>& positions_;
  Fit_samples& samples_;
  const std::function<Vector(Index, const Vector&)> within_bounds_;
  const Cancellation_point cancellation_;
  Angle_worth worth_;
  Trial_fan fan_;
  // Of the star of the vertex that is to move:
  Vector normal_{{0, 0, 0}};
  double worth_before_ = 0, max_cosine_ = 1;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_ANGLE_IMPROVEMENT_H
