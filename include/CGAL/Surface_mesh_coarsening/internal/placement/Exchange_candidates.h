// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_EXCHANGE_CANDIDATES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_EXCHANGE_CANDIDATES_H

#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Coarse_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Trial_fan.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

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
  explicit Exchange_candidates(const Coarse_mesh& mesh) : mesh_(mesh) {}

  // Measures the current triangles. An insertion into a triangle gains its bonus, too, if there is one.
  void measure_triangles(const Angle_worth& worth, const std::vector<double>& bonus)
  {
    worth_ = worth;
    bonus_ = bonus;
    const std::size_t n = mesh_.triangles().size();
    cost_.resize(n);
    angle_.resize(n);
    for_each_number(mesh_.context(), n, [this](Index t) {
      cost_[t] = 2 * mesh_.samples().cost_of_input(t);
      angle_[t] = mesh_.angle(t);
    });
  }

  // Calls `visit` with a removal of each vertex that can be removed, with an estimate of the loss.
  template <class Visit>
  void for_each_removal(const Visit& visit) const
  {
    for_each_part<std::vector<Vertex_removal> >(
      mesh_.context(), mesh_.positions().size(), vertices_of_part,
      [this](std::vector<Vertex_removal>& removals, std::size_t begin, std::size_t end) {
        removals.clear();
        for (std::size_t v = begin; v != end; ++v)
          if (is_free(Index(v)))
            removals.push_back(estimated_removal(Index(v)));
      },
      [&](const std::vector<Vertex_removal>& removals) {
        mesh_.context().poll(steps_of_removal * vertices_of_part);
        for (const Vertex_removal& r : removals)
          if (r.into != NONE)
            visit(r);
      });
  }

  // Calls `visit` with an insertion on each edge that belongs to no feature, with an estimate of the gain.
  template <class Visit>
  void for_each_insertion(const Visit& visit) const
  {
    for (std::size_t t = 0; t < mesh_.triangles().size(); ++t) {
      mesh_.context().poll();
      for (int i = 0; i < 3; ++i) {
        const Index u = mesh_.across(Index(t), i);
        if (u != NONE && u > t)
          visit(insertion_at(Index(t), i));
      }
    }
  }

  // Returns the insertion on the edge from corner `i` of a triangle, with an estimate of the gain. The edge belongs to no
  // feature.
  Vertex_insertion insertion_at(Index t, int i) const
  {
    const Index u = mesh_.across(t, i), a = mesh_.triangle(t)[i], b = mesh_.triangle(t)[(i + 1) % 3];
    return {{insertion_part * (cost_[t] + cost_[u]) + bonus(t, u)}, t, u, {a, b, mesh_.opposite(t, i), mesh_.opposite(u, mesh_.corner(u, b))}};
  }

  // Measures some removals, or some insertions.
  template <class Candidate>
  void measure(std::vector<Candidate>& candidates) const
  {
    for_each_chunk(mesh_.context().uninterrupted(), candidates.size(), 1,
                   [&](std::size_t i, std::size_t, std::size_t) { measure(candidates[i]); });
  }

private:
  // A position of the vertex of a fan, and the cost of the samples and angles of the fan there.
  struct Place
  {
    double cost = std::numeric_limits<double>::infinity();
    Vector position{{0, 0, 0}};
  };

  void measure(Vertex_removal& r) const
  {
    Trial_fan fan;
    double cost = 0, least = min_angle;
    const auto add = [&](Index t, const Triangle& now) {
      const bool remains = now[0] != now[1] && now[1] != now[2] && now[2] != now[0];
      if (remains)
        fan.add_triangle(mesh_.point(now[0]), mesh_.point(now[1]), mesh_.point(now[2]),
                         int(std::find(now.begin(), now.end(), r.into) - now.begin()), mesh_.normal(t));
      add_samples_of(t, fan);
      cost += cost_[t] - worth_(angle_[t]);
      least = (std::min)(least, angle_[t]);
    };
    for (const Index t : mesh_.around(r.vertex))
      add(t, with_corner(mesh_.triangle(t), r.vertex, r.into));
    for (const Index t : mesh_.around(r.into))
      if (mesh_.corner(t, r.vertex) < 0)
        add(t, mesh_.triangle(t));
    const Vector& p = mesh_.point(r.into);
    Place best = best_place(fan, p, 1, least, std::numeric_limits<double>::infinity());
    if (!mesh_.is_on_border(r.into)) {
      const Place moved = best_place(fan, 0.5 * (p + mesh_.point(r.vertex)), max_steps, least, best.cost);
      if (moved.cost < best.cost)
        best = moved;
    }
    r.place = best.position;
    r.measured = best.cost - cost;
  }

  void measure(Vertex_insertion& x) const
  {
    Trial_fan fan;
    const Vector n = mesh_.normal(x.t) + mesh_.normal(x.u);
    const Vector &a = mesh_.point(x.corners[0]), &b = mesh_.point(x.corners[1]), &c = mesh_.point(x.corners[2]),
                 &d = mesh_.point(x.corners[3]);
    const Vector middle = 0.5 * (a + b);
    fan.add_triangle(a, middle, c, 1, n);
    fan.add_triangle(middle, b, c, 0, n);
    fan.add_triangle(b, middle, d, 1, n);
    fan.add_triangle(middle, a, d, 0, n);
    add_samples_of(x.t, fan);
    add_samples_of(x.u, fan);
    const double least = (std::min)({min_angle, angle_[x.t], angle_[x.u]});
    const Place best = best_place(fan, middle, max_steps, least, std::numeric_limits<double>::infinity());
    x.place = best.position;
    x.measured = cost_[x.t] + cost_[x.u] - worth_(angle_[x.t]) - worth_(angle_[x.u]) - best.cost + bonus(x.t, x.u);
  }

  // Factors of the estimates. The removal of the apex of a pyramid increases the squared distance by the first factor times the
  // squared height times the area of the base. A vertex on the edge of two triangles saves the second fraction of their cost.
  // With these values, most of the best candidates are measured.
  static constexpr double pyramid_part = 0.18, insertion_part = 0.65;
  static constexpr std::size_t max_valence = 32;
  static constexpr std::size_t vertices_of_part = 16, steps_of_removal = 32;
  static constexpr int max_steps = 3;

  double bonus(Index t, Index u) const { return bonus_.empty() ? 0 : (std::max)(bonus_[t], bonus_[u]); }

  // The squared distance in both directions is estimated as twice the distance of the samples of the input.
  double sample_weight() const { return 2 * mesh_.samples().weight(); }

  // Returns whether all edges at a vertex may be removed.
  bool is_free(Index v) const
  {
    if (mesh_.is_on_border(v) || mesh_.around(v).size() > max_valence)
      return false;
    for (const Index t : mesh_.around(v))
      for (int i = 0; i < 3; ++i)
        if (mesh_.triangle(t)[(i + 2) % 3] != v && mesh_.across(t, i) == NONE)
          return false;
    return true;
  }

  // Returns the collapse of an edge at the vertex after which the surface is closest to the old position of the vertex.
  Vertex_removal estimated_removal(Index v) const
  {
    Vertex_removal best{{std::numeric_limits<double>::infinity()}, v, NONE};
    double area = 0, worth = 0, least = min_angle;
    for (const Index t : mesh_.around(v)) {
      const Vector n = mesh_.normal(t);
      area += 0.5 * length(n);
      worth += worth_(angle_[t]);
      least = (std::min)(least, angle_[t]);
    }
    for (const Index t : mesh_.around(v)) {
      const Index w = mesh_.triangle(t)[(mesh_.corner(t, v) + 1) % 3];
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
    for (const Index t : mesh_.around(v)) {
      if (mesh_.corner(t, into) >= 0)
        continue;
      const Triangle now = with_corner(mesh_.triangle(t), v, into);
      const Vector m = normal_of(mesh_.positions(), now), n = mesh_.normal(t);
      const double new_angle = smallest_angle(mesh_.positions(), now);
      if (!(dot(m, n) > Trial_fan::max_turn * std::sqrt(dot(m, m) * dot(n, n))) || new_angle < least_angle)
        return false;
      worth += worth_(new_angle);
      const Vector &a = mesh_.point(now[0]), &b = mesh_.point(now[1]), &c = mesh_.point(now[2]);
      height = (std::min)(height, closest_on_triangle(mesh_.point(v), a, b, c, height).squared_distance);
    }
    return true;
  }

  // Returns whether the mesh remains a manifold with at least three triangles around each vertex: the only common neighbors of
  // the two vertices are the tips of the two triangles at the edge (link condition).
  bool may_collapse(Index v, Index w) const
  {
    if (mesh_.around(w).size() > max_valence)
      return false;
    std::size_t common = 0;
    for (const Index t : mesh_.around(v)) {
      const Index x = mesh_.triangle(t)[(mesh_.corner(t, v) + 1) % 3];
      if (x == w || !mesh_.is_edge(w, x))
        continue;
      if (mesh_.around(x).size() < (mesh_.is_on_border(x) ? 3u : 4u))
        return false;
      ++common;
    }
    return common == 2;
  }

  void add_samples_of(Index t, Trial_fan& fan) const
  {
    mesh_.samples().for_each_on(t, [&](const Input_sample& s) { fan.add_sample(s.position); });
  }

  // Returns the best of several positions of the vertex of a fan, beginning at `p`. Its cost is infinite if the fan is sound at
  // none of them, or if all costs reach `limit`.
  Place best_place(Trial_fan& fan, Vector p, int steps, double least_angle, double limit) const
  {
    Place best;
    for (int i = 0; i < steps; ++i) {
      fan.move_to(p);
      Vector better = p;
      const double worth = fan.worth(worth_);
      const double squares = i + 1 < steps ? fan.squared_distances(p, better)
                                           : fan.squared_distances(((std::min)(best.cost, limit) + worth) / sample_weight());
      const double cost = sample_weight() * squares - worth;
      if (cost < best.cost && cost < limit && fan.is_sound(std::cos(least_angle) + 1e-12))
        best = {cost, p};
      p = better;
    }
    return best;
  }

  const Coarse_mesh& mesh_;
  Angle_worth worth_;
  std::vector<double> cost_, angle_, bonus_; // of each triangle; or no bonus
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_EXCHANGE_CANDIDATES_H
