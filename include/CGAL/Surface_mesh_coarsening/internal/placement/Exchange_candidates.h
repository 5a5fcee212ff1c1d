// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_EXCHANGE_CANDIDATES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_EXCHANGE_CANDIDATES_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Fit_samples.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Trial_fan.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// What is known about a change of the mesh before it is made.
struct Change_estimate
{
  double value; // an estimate until the change is the best candidate; then measured
  bool is_measured = false;
  std::optional<double> measured = std::nullopt; // before it replaces the estimate
  Vector place{{0, 0, 0}};                        // of the vertex

  void take_measured()
  {
    value = *measured;
    is_measured = true;
  }
};

// The removal of a vertex by a collapse of its edge to `into`, which moves to `place`.
struct Vertex_removal : Change_estimate
{
  Index vertex, into;

  double loss() const { return value; }
  bool may_pay() const { return loss() < std::numeric_limits<double>::infinity(); }
  // The smallest loss has the highest priority.
  bool operator<(const Vertex_removal& r) const { return std::tie(value, vertex) > std::tie(r.value, r.vertex); }
};

// The insertion of a vertex at `place` on the edge between the first two of the four corners of two triangles.
struct Vertex_insertion : Change_estimate
{
  Index t, u;
  std::array<Index, 4> corners;

  double gain() const { return value; }
  bool may_pay() const { return gain() > 0; }
  bool operator<(const Vertex_insertion& i) const { return std::tie(value, i.t, i.u) < std::tie(i.value, t, u); }
};

// The removals and insertions of vertices of a coarse mesh, with their effect on the distance.
//
// The cost is the sum of the squared distances of the samples of the input, with one of the vertices at its optimal position, and
// of the angles at the exchange rate of flips.
class Exchange_candidates
{
public:
  Exchange_candidates(const Border_arcs& border, const Flippable_triangulation& coarse, const std::vector<Vector>& positions,
                      const Fit_samples& samples, const Run_context& context)
    : border_(border), coarse_(coarse), positions_(positions), samples_(samples), context_(context) {}

  // Measures the current triangles.
  void measure_triangles(const Angle_worth& worth)
  {
    worth_ = worth;
    const std::size_t n = coarse_.triangles().size();
    cost_.resize(n);
    angle_.resize(n);
    for_each_number(context_, n, [this](Index t) {
      cost_[t] = 2 * samples_.cost_of_input(t);
      angle_[t] = smallest_angle(positions_, triangle(t));
    });
  }

  // Calls `visit` with a removal of each vertex that can be removed, with an estimate of the loss.
  template <class Visit>
  void for_each_removal(const Visit& visit) const
  {
    for_each_part<std::vector<Vertex_removal> >(
      context_, positions_.size(), vertices_of_part,
      [this](std::vector<Vertex_removal>& removals, std::size_t begin, std::size_t end) {
        removals.clear();
        for (std::size_t v = begin; v != end; ++v)
          if (is_free(Index(v)))
            removals.push_back(estimated_removal(Index(v)));
      },
      [&](const std::vector<Vertex_removal>& removals) {
        context_.poll(steps_of_removal * vertices_of_part);
        for (const Vertex_removal& r : removals)
          if (r.into != NONE)
            visit(r);
      });
  }

  // Calls `visit` with an insertion on each edge that belongs to no feature, with an estimate of the gain.
  template <class Visit>
  void for_each_insertion(const Visit& visit) const
  {
    for (std::size_t t = 0; t < coarse_.triangles().size(); ++t) {
      context_.poll();
      for (int i = 0; i < 3; ++i) {
        const Index u = coarse_.across(Index(t), i);
        if (u != NONE && u > t)
          visit(insertion_at(Index(t), i));
      }
    }
  }

  // Returns the insertion on the edge from corner `i` of a triangle, with an estimate of the gain. The edge belongs to no
  // feature.
  Vertex_insertion insertion_at(Index t, int i) const
  {
    const Index u = coarse_.across(t, i), a = triangle(t)[i], b = triangle(t)[(i + 1) % 3];
    return {{insertion_part * (cost_[t] + cost_[u])}, t, u,
            {a, b, coarse_.opposite(t, i), coarse_.opposite(u, coarse_.corner(u, b))}};
  }

  // Measures some removals, or some insertions.
  template <class Candidate>
  void measure(std::vector<Candidate>& candidates) const
  {
    for_each_chunk(context_.uninterrupted(), candidates.size(), 1,
                   [&](std::size_t i, std::size_t, std::size_t) { measure(candidates[i]); });
  }

private:
  void measure(Vertex_removal& r) const
  {
    Trial_fan fan;
    double cost = 0, least = min_angle;
    const auto add = [&](Index t, const Triangle& now) {
      const bool remains = now[0] != now[1] && now[1] != now[2] && now[2] != now[0];
      if (remains)
        fan.add_triangle(positions_[now[0]], positions_[now[1]], positions_[now[2]],
                          int(std::find(now.begin(), now.end(), r.into) - now.begin()), normal(t));
      add_samples_of(t, fan);
      cost += cost_[t] - worth_(angle_[t]);
      least = (std::min)(least, angle_[t]);
    };
    for (const Index t : coarse_.around(r.vertex))
      add(t, with_corner(triangle(t), r.vertex, r.into));
    for (const Index t : coarse_.around(r.into))
      if (coarse_.corner(t, r.vertex) < 0)
        add(t, triangle(t));
    const Vector& p = positions_[r.into];
    Vector place;
    double rest = best_place(fan, p, 1, least, std::numeric_limits<double>::infinity(), r.place);
    if (!border_.is_on_border(r.into)) {
      const double moved = best_place(fan, 0.5 * (p + positions_[r.vertex]), max_steps, least, rest, place);
      if (moved < rest) {
        rest = moved;
        r.place = place;
      }
    }
    r.measured = rest - cost;
  }

  void measure(Vertex_insertion& x) const
  {
    Trial_fan fan;
    const Vector n = normal(x.t) + normal(x.u);
    const Vector &a = positions_[x.corners[0]], &b = positions_[x.corners[1]], &c = positions_[x.corners[2]],
                 &d = positions_[x.corners[3]];
    const Vector middle = 0.5 * (a + b);
    fan.add_triangle(a, middle, c, 1, n);
    fan.add_triangle(middle, b, c, 0, n);
    fan.add_triangle(b, middle, d, 1, n);
    fan.add_triangle(middle, a, d, 0, n);
    add_samples_of(x.t, fan);
    add_samples_of(x.u, fan);
    const double least = (std::min)({min_angle, angle_[x.t], angle_[x.u]});
    const double rest = best_place(fan, middle, max_steps, least, std::numeric_limits<double>::infinity(), x.place);
    x.measured = cost_[x.t] + cost_[x.u] - worth_(angle_[x.t]) - worth_(angle_[x.u]) - rest;
  }

  // Factors of the estimates. The removal of the apex of a pyramid increases the squared distance by the first factor times the
  // squared height times the area of the base. A vertex on the edge of two triangles saves the second fraction of their cost.
  // With these values, most of the best candidates are measured.
  static constexpr double pyramid_part = 0.18, insertion_part = 0.65;
  static constexpr std::size_t max_valence = 32;
  static constexpr std::size_t vertices_of_part = 16, steps_of_removal = 32;
  static constexpr int max_steps = 3;

  const Triangle& triangle(Index t) const { return coarse_.triangles()[t]; }
  Vector normal(Index t) const { return normal_of(positions_, triangle(t)); }

  // The squared distance in both directions is estimated as twice the distance of the samples of the input.
  double sample_weight() const { return 2 * samples_.weight(); }

  // Returns whether all edges at a vertex may be removed.
  bool is_free(Index v) const
  {
    if (border_.is_on_border(v) || coarse_.around(v).size() > max_valence)
      return false;
    for (const Index t : coarse_.around(v))
      for (int i = 0; i < 3; ++i)
        if (triangle(t)[(i + 2) % 3] != v && coarse_.across(t, i) == NONE)
          return false;
    return true;
  }

  // Returns the collapse of an edge at the vertex after which the surface is closest to the old position of the vertex.
  Vertex_removal estimated_removal(Index v) const
  {
    Vertex_removal best{{std::numeric_limits<double>::infinity()}, v, NONE};
    double area = 0, worth = 0, least = min_angle;
    for (const Index t : coarse_.around(v)) {
      const Vector n = normal(t);
      area += 0.5 * length(n);
      worth += worth_(angle_[t]);
      least = (std::min)(least, angle_[t]);
    }
    for (const Index t : coarse_.around(v)) {
      const Index w = triangle(t)[(coarse_.corner(t, v) + 1) % 3];
      double height = std::numeric_limits<double>::infinity(), new_worth = 0;
      if (!look_at_collapse(v, w, least, height, new_worth))
        continue;
      const double loss = pyramid_part * area * height + worth - new_worth;
      if (loss < best.loss() && may_collapse(v, w)) {
        best.value = loss;
        best.into = w;
      }
    }
    return best;
  }

  // Returns whether the triangles that remain around a vertex after its collapse into another one are sound. `height` receives
  // the smallest squared distance from its old position to one of these triangles.
  bool look_at_collapse(Index v, Index into, double least_angle, double& height, double& worth) const
  {
    for (const Index t : coarse_.around(v)) {
      if (coarse_.corner(t, into) >= 0)
        continue;
      const Triangle now = with_corner(triangle(t), v, into);
      const Vector m = normal_of(positions_, now), n = normal(t);
      const double new_angle = smallest_angle(positions_, now);
      if (!(dot(m, n) > Trial_fan::max_turn * std::sqrt(dot(m, m) * dot(n, n))) || new_angle < least_angle)
        return false;
      worth += worth_(new_angle);
      height = (std::min)(height, closest_on_triangle(positions_[v], positions_[now[0]], positions_[now[1]], positions_[now[2]],
                                                      height).squared_distance);
    }
    return true;
  }

  // Returns whether the mesh remains a manifold with at least three triangles around each vertex: the only common neighbors of
  // the two vertices are the tips of the two triangles at the edge (link condition).
  bool may_collapse(Index v, Index w) const
  {
    if (coarse_.around(w).size() > max_valence)
      return false;
    std::size_t common = 0;
    for (const Index t : coarse_.around(v)) {
      const Index x = triangle(t)[(coarse_.corner(t, v) + 1) % 3];
      if (x == w || !coarse_.is_edge(w, x))
        continue;
      if (coarse_.around(x).size() < (border_.is_on_border(x) ? 3u : 4u))
        return false;
      ++common;
    }
    return common == 2;
  }

  void add_samples_of(Index t, Trial_fan& fan) const
  {
    samples_.for_each_on(t, [&](const Fit_samples::Sample& s) { fan.add_sample(s.position); });
  }

  // Returns the smallest cost of samples and angles of a fan over several positions of its vertex, beginning at `p`; infinity if
  // the fan is sound at none of them.
  double best_place(Trial_fan& fan, Vector p, int steps, double least_angle, double limit, Vector& place) const
  {
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < steps; ++i) {
      fan.move_to(p);
      Vector better = p;
      const double worth = fan.worth(worth_);
      const double squares = i + 1 < steps ? fan.squared_distances(p, better)
                                           : fan.squared_distances(((std::min)(best, limit) + worth) / sample_weight());
      const double cost = sample_weight() * squares - worth;
      if (cost < best && cost < limit && fan.is_sound(std::cos(least_angle) + 1e-12)) {
        best = cost;
        place = p;
      }
      p = better;
    }
    return best;
  }

  const Border_arcs& border_;
  const Flippable_triangulation& coarse_;
  const std::vector<Vector>& positions_;
  const Fit_samples& samples_;
  const Run_context context_;
  Angle_worth worth_;
  std::vector<double> cost_, angle_; // of each triangle
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_EXCHANGE_CANDIDATES_H
