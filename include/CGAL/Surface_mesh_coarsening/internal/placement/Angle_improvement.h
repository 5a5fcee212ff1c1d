// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_ANGLE_IMPROVEMENT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_ANGLE_IMPROVEMENT_H

#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Coarse_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Trial_fan.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Moves vertices of narrow triangles if the gain in angles is worth more than the increase of the distance.
class Angle_improvement
{
public:
  explicit Angle_improvement(Coarse_mesh& mesh) : mesh_(mesh) {}

  // Processes the narrowest triangle first.
  void run(const Angle_worth& worth)
  {
    worth_ = worth;
    is_marked_.assign(mesh_.positions().size(), false);
    tries_.assign(mesh_.positions().size(), 0);
    std::vector<std::pair<double, Index> > narrow;
    for (std::size_t t = 0; t < mesh_.triangles().size(); ++t) {
      mesh_.context().poll();
      const double angle = mesh_.angle(Index(t));
      if (angle < narrow_angle)
        narrow.emplace_back(angle, Index(t));
    }
    std::sort(narrow.begin(), narrow.end());
    std::vector<Index> triangles;
    work_left_ = work_of_triangle * mesh_.triangles().size();
    for (const auto& [angle, t] : narrow) {
      if (triangles.size() == at_a_time || depends_on_marked(t))
        improve(triangles);
      if (work_left_ == 0)
        break;
      triangles.push_back(t);
      mark(t, true);
    }
    improve(triangles);
  }

private:
  static constexpr std::size_t at_a_time = 32, max_valence = 32, max_tries = 12, steps_of_triangle = 512;
  static constexpr double min_turn_cosine = 0.8;
  // The comparisons of samples with triangles in all trials. Ten models need at most 1,800 for each triangle, with 1 to 20 % of
  // their vertices; meshes of needles would need 8,000.
  static constexpr std::size_t work_of_triangle = 2500;

  struct Move
  {
    double gain = 0;
    Index vertex = NONE;
    Vector to{{0, 0, 0}};
    std::size_t work = 0; // of all trials
  };

  // The triangles around a vertex to be moved.
  struct Star
  {
    Trial_fan fan;
    Vector normal{{0, 0, 0}};
    double cost = 0, worth = 0, max_cosine = 1;
    std::size_t samples = 0;
  };

  // Improves the marked triangles and clears the marks. Their moves do not depend on each other and are computed in parallel.
  void improve(std::vector<Index>& triangles)
  {
    mesh_.context().poll(steps_of_triangle * triangles.size());
    std::vector<Move> moves(triangles.size());
    for_each_chunk(mesh_.context().uninterrupted(), triangles.size(), 1, [&](std::size_t i, std::size_t, std::size_t) {
      if (mesh_.angle(triangles[i]) < narrow_angle)
        moves[i] = best_move(triangles[i]);
    });
    for (const Move& move : moves) {
      work_left_ -= (std::min)(move.work, work_left_);
      if (move.vertex != NONE)
        make(move);
    }
    for (const Index t : triangles) {
      mark(t, false);
      for (const Index v : mesh_.triangle(t))
        ++tries_[v];
    }
    triangles.clear();
  }

  // A vertex of many narrow triangles is tried for the narrowest ones.
  bool may_move(Index v) const
  {
    return !mesh_.is_on_border(v) && mesh_.around(v).size() <= max_valence && tries_[v] < max_tries;
  }

  // Marks the corners that may move.
  void mark(Index t, bool is_marked)
  {
    for (const Index v : mesh_.triangle(t))
      if (may_move(v))
        is_marked_[v] = is_marked;
  }

  // Returns whether a marked vertex is a corner of `t` or of a triangle around a corner of `t` that may move.
  bool depends_on_marked(Index t) const
  {
    const auto has_marked_corner = [this](Index u) {
      const Triangle& c = mesh_.triangle(u);
      return std::any_of(c.begin(), c.end(), [this](Index v) { return is_marked_[v]; });
    };
    if (has_marked_corner(t))
      return true;
    for (const Index v : mesh_.triangle(t))
      if (may_move(v) && std::any_of(mesh_.around(v).begin(), mesh_.around(v).end(), has_marked_corner))
        return true;
    return false;
  }

  // Returns the best move of a corner of a triangle; its vertex is NONE if no move improves the triangle.
  Move best_move(Index t) const
  {
    Move best;
    for (int i = 0; i < 3; ++i) {
      const Index v = mesh_.triangle(t)[std::size_t(i)];
      if (may_move(v))
        try_moves(t, i, best);
    }
    return best;
  }

  // Undoes the move if it is not profitable when the distances of the triangles from the input are also counted.
  void make(const Move& move)
  {
    const std::vector<Index>& around = mesh_.around(move.vertex);
    const double before = mesh_.cost_of(around, worth_);
    mesh_.move_if(move.vertex, move.to, [&]() { return mesh_.cost_of(around, worth_) < before; });
  }

  void try_moves(Index t, int i, Move& best) const
  {
    const Index v = mesh_.triangle(t)[std::size_t(i)];
    Star star = star_of(v);
    for (const Vector& place : places(t, i, star.normal)) {
      star.fan.move_to(place);
      // If the angles do not improve, distances need not be computed.
      if (star.fan.worth(worth_) <= star.worth)
        continue;
      best.work += star.samples * mesh_.around(v).size();
      Vector better;
      star.fan.squared_distances(place, better);
      const Vector to = mesh_.within_bounds(v, place + dot(better - place, star.normal) * star.normal);
      star.fan.move_to(to);
      if (!star.fan.is_sound(star.max_cosine, min_turn_cosine))
        continue;
      // Distances are summed until the gain is less than the best gain so far.
      const double worth = star.fan.worth(worth_), weight = 2 * mesh_.samples().weight();
      const double gain = star.cost - (weight * star.fan.squared_distances((star.cost + worth - best.gain) / weight) - worth);
      if (gain > best.gain)
        best = {gain, v, to, best.work};
    }
  }

  Star star_of(Index v) const
  {
    Star star;
    double distances = 0, least = min_angle;
    for (const Index t : mesh_.around(v)) {
      const Triangle& c = mesh_.triangle(t);
      const Vector n = mesh_.normal(t);
      star.fan.add_triangle(mesh_.point(c[0]), mesh_.point(c[1]), mesh_.point(c[2]), mesh_.corner(t, v), n);
      mesh_.samples().for_each_on(t, [&](const Input_sample& s) {
        star.fan.add_sample(s.position);
        ++star.samples;
      });
      star.normal = star.normal + n;
      const double angle = mesh_.angle(t);
      least = (std::min)(least, angle);
      star.worth += worth_(angle);
      distances += 2 * mesh_.samples().cost_of_input(t);
    }
    const double length = std::sqrt(dot(star.normal, star.normal));
    star.normal = length > 0 ? (1 / length) * star.normal : star.normal;
    star.max_cosine = std::cos(least) + 1e-12;
    star.cost = distances - star.worth;
    return star;
  }

  // Returns candidate positions for corner `i`: closer to the mean of its neighbors, farther from the opposite edge, farther from
  // the nearest corner.
  std::vector<Vector> places(Index t, int i, const Vector& normal) const
  {
    const Triangle& c = mesh_.triangle(t);
    const Index v = c[std::size_t(i)];
    const Vector &p = mesh_.point(v), &a = mesh_.point(c[std::size_t(i + 1) % 3]), &b = mesh_.point(c[std::size_t(i + 2) % 3]);
    const Vector ab = b - a, pa = p - a, pb = p - b, to_mean = mesh_.mean_of_neighbors(v, mesh_.positions()) - p;
    const double square = dot(ab, ab);
    const Vector height = square > 0 ? pa - (dot(pa, ab) / square) * ab : pa;
    const double size = std::sqrt((std::max)({square, dot(pa, pa), dot(pb, pb)}));
    std::vector<Vector> found;
    for (const double part : {0.25, 0.5, 1.})
      found.push_back(p + part * (to_mean - dot(to_mean, normal) * normal));
    for (const Vector& d : {height, dot(pa, pa) < dot(pb, pb) ? pa : pb}) {
      const double length = std::sqrt(dot(d, d));
      if (length > 0)
        for (const double part : {0.07, 0.15, 0.3})
          found.push_back(p + (part * size / length) * d);
    }
    return found;
  }

  Coarse_mesh& mesh_;
  Angle_worth worth_;
  std::vector<char> is_marked_; // of each vertex
  std::vector<std::size_t> tries_;
  std::size_t work_left_ = 0;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_ANGLE_IMPROVEMENT_H
