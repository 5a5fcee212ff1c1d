// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_VERTEX_EXCHANGE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_VERTEX_EXCHANGE_H

#include <CGAL/Surface_mesh_coarsening/internal/placement/Fit_samples.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Trial_fan.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Moves vertices of a coarse mesh from places where they cost little to places where the distance from the input is large,
// one at a time: collapses an edge and splits another one. The numbers of vertices and triangles and the topology do not
// change. In an optimal mesh the error is evenly distributed over the vertices; the exchange distributes it.
//
// Costs are sums of squared distances of the samples of the input, with one of the vertices at its optimal position, and of
// angles at the exchange rate of flips.
class Vertex_exchange
{
public:
  Vertex_exchange(const Border_arcs& border, Flippable_triangulation& coarse, std::vector<Vector>& positions, Fit_samples& samples,
                  const Cancellation_point& cancellation)
    : border_(border), coarse_(coarse), positions_(positions), samples_(samples), cancellation_(cancellation) {}

  // Exchanges vertices as long as an exchange between two untouched places is profitable. `rate` is the squared distance per
  // radian. `relocate(v, w, f)` is called before vertex `v` is merged into `w` and inserted near face `f` of the input, and
  // may refuse. Returns the number of exchanged vertices.
  template <class Relocate>
  std::size_t run(double rate, const Relocate& relocate)
  {
    rate_ = rate;
    is_touched_.assign(positions_.size(), false);
    measure_triangles();
    list_removals();
    list_insertions();
    std::size_t exchanged = 0;
    while (find_best_removal() && find_best_insertion()) {
      const Removal removal = removals_.top();
      const Insertion insertion = insertions_.top();
      if (!(insertion.gain > min_ratio * removal.loss))
        break;
      removals_.pop();
      if (do_overlap(removal, insertion))
        continue;
      insertions_.pop();
      exchanged += exchange(removal, insertion, relocate);
    }
    return exchanged;
  }

private:
  // Gain and loss are estimated before other vertices adapt, which lowers the loss more than the gain.
  static constexpr double min_ratio = 0.6;
  // Factors of the quick estimates. Removing a pyramid increases the squared distance by the first factor times its height
  // squared times the area of its base; a vertex on the edge of two triangles saves the second fraction of their cost. With
  // these values, most of the best candidates are measured.
  static constexpr double pyramid_part = 0.18, insertion_part = 0.65;
  static constexpr double min_angle = 10 / 57.29577951308232;
  static constexpr std::size_t max_valence = 32;
  static constexpr int max_steps = 3;

  // Collapses the edge from a vertex to `into`, which moves to `place`.
  struct Removal
  {
    double loss;
    Index vertex, into;
    bool is_measured;
    Vector place;
    bool operator<(const Removal& r) const { return std::tie(loss, vertex) > std::tie(r.loss, r.vertex); } // the least comes first
  };

  // Splits the edge between the first two of the four corners of two triangles at `place`.
  struct Insertion
  {
    double gain;
    Index t, u;
    std::array<Index, 4> corners;
    bool is_measured;
    Vector place;
    bool operator<(const Insertion& i) const { return std::tie(gain, i.t, i.u) < std::tie(i.gain, t, u); }
  };

  const Triangle& triangle(Index t) const { return coarse_.triangles()[t]; }
  Vector normal(Index t) const { return normal_of(positions_, triangle(t)); }
  double angle(const Triangle& t) const { return std::acos((std::min)(1., sharpest_of(positions_, t))); }

  // The squared distance in both directions is estimated as twice the distance of the samples of the input.
  double sample_weight() const { return 2 * samples_.weight(); }

  void measure_triangles()
  {
    const std::size_t n = coarse_.triangles().size();
    cost_.resize(n);
    angle_.resize(n);
    for (std::size_t t = 0; t < n; ++t) {
      cancellation_.poll();
      cost_[t] = 2 * samples_.cost_of_input(Index(t));
      angle_[t] = angle(triangle(Index(t)));
    }
  }

  template <class Visit>
  bool any_around(Index v, const Visit& visit) const
  {
    for (const Index t : coarse_.around(v))
      for (const Index x : triangle(t))
        if (visit(x))
          return true;
    return false;
  }

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

  void list_removals()
  {
    removals_ = std::priority_queue<Removal>();
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      cancellation_.poll();
      if (!is_free(Index(v)))
        continue;
      const Removal r = estimated_removal(Index(v));
      if (r.into != NONE)
        removals_.push(r);
    }
  }

  // Returns the edge at a vertex whose collapse keeps the new surface closest to the vertex.
  Removal estimated_removal(Index v) const
  {
    Removal best{std::numeric_limits<double>::infinity(), v, NONE, false, {}};
    double area = 0, angles = 0, least = min_angle;
    for (const Index t : coarse_.around(v)) {
      const Vector n = normal(t);
      area += 0.5 * std::sqrt(dot(n, n));
      angles += angle_[t];
      least = (std::min)(least, angle_[t]);
    }
    for (const Index t : coarse_.around(v)) {
      const Index w = triangle(t)[(coarse_.corner(t, v) + 1) % 3];
      double height = std::numeric_limits<double>::infinity(), new_angles = 0;
      if (!look_at_collapse(v, w, least, height, new_angles))
        continue;
      const double loss = pyramid_part * area * height + rate_ * (angles - new_angles);
      if (loss < best.loss && may_collapse(v, w)) {
        best.loss = loss;
        best.into = w;
      }
    }
    return best;
  }

  // Returns whether the triangles that remain around a vertex are valid after it has moved into another one. `height`: the
  // smallest squared distance from its old position to one of them.
  bool look_at_collapse(Index v, Index into, double least_angle, double& height, double& angles) const
  {
    for (const Index t : coarse_.around(v)) {
      if (coarse_.corner(t, into) >= 0)
        continue;
      const Triangle now = with_corner(triangle(t), v, into);
      const Vector m = normal_of(positions_, now), n = normal(t);
      const double new_angle = angle(now);
      if (!(dot(m, n) > Trial_fan::max_turn * std::sqrt(dot(m, m) * dot(n, n))) || new_angle < least_angle)
        return false;
      angles += new_angle;
      height = (std::min)(height, closest_on_triangle(positions_[v], positions_[now[0]], positions_[now[1]],
                                                      positions_[now[2]]).squared_distance);
    }
    return true;
  }

  static Triangle with_corner(Triangle t, Index old_corner, Index new_corner)
  {
    std::replace(t.begin(), t.end(), old_corner, new_corner);
    return t;
  }

  // Whether the mesh remains a manifold, with three triangles or more around each vertex: the two have no common neighbors
  // except in the two triangles at the edge (link condition).
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

  void list_insertions()
  {
    insertions_ = std::priority_queue<Insertion>();
    for (std::size_t t = 0; t < coarse_.triangles().size(); ++t) {
      cancellation_.poll();
      for (int i = 0; i < 3; ++i) {
        const Index u = coarse_.across(Index(t), i);
        if (u == NONE || u < t)
          continue;
        const Index a = triangle(Index(t))[i], b = triangle(Index(t))[(i + 1) % 3];
        insertions_.push({insertion_part * (cost_[t] + cost_[u]), Index(t), u,
                          {a, b, coarse_.opposite(Index(t), i), coarse_.opposite(u, coarse_.corner(u, b))}, false, {}});
      }
    }
  }

  bool find_best_removal()
  {
    while (!removals_.empty()) {
      Removal r = removals_.top();
      const auto is_touched = [this](Index x) { return bool(is_touched_[x]); };
      if (!is_touched(r.vertex) && !is_touched(r.into) && !any_around(r.vertex, is_touched) && !any_around(r.into, is_touched)) {
        if (r.is_measured)
          return true;
        cancellation_.poll(64);
        removals_.pop();
        measure(r);
        if (r.loss < std::numeric_limits<double>::infinity())
          removals_.push(r);
      } else {
        removals_.pop();
      }
    }
    return false;
  }

  bool find_best_insertion()
  {
    while (!insertions_.empty()) {
      Insertion x = insertions_.top();
      if (!std::any_of(x.corners.begin(), x.corners.end(), [this](Index v) { return is_touched_[v]; })) {
        if (x.is_measured)
          return true;
        cancellation_.poll(16);
        insertions_.pop();
        measure(x);
        if (x.gain > 0)
          insertions_.push(x);
      } else {
        insertions_.pop();
      }
    }
    return false;
  }

  void add_samples_of(Index t)
  {
    samples_.for_each_on(t, [this](const Fit_samples::Sample& s) { fan_.add_sample(s.position); });
  }

  void measure(Removal& r)
  {
    fan_.clear();
    double cost = 0, angles = 0, least = min_angle;
    const auto add = [&](Index t, const Triangle& now) {
      const bool remains = now[0] != now[1] && now[1] != now[2] && now[2] != now[0];
      if (remains)
        fan_.add_triangle(positions_[now[0]], positions_[now[1]], positions_[now[2]],
                          int(std::find(now.begin(), now.end(), r.into) - now.begin()), normal(t));
      add_samples_of(t);
      cost += cost_[t];
      angles += angle_[t];
      least = (std::min)(least, angle_[t]);
    };
    for (const Index t : coarse_.around(r.vertex))
      add(t, with_corner(triangle(t), r.vertex, r.into));
    for (const Index t : coarse_.around(r.into))
      if (coarse_.corner(t, r.vertex) < 0)
        add(t, triangle(t));
    const Vector& p = positions_[r.into];
    Vector place;
    double rest = best_place(p, 1, least, std::numeric_limits<double>::infinity(), r.place);
    if (!border_.is_on_border(r.into)) {
      const double moved = best_place(0.5 * (p + positions_[r.vertex]), max_steps, least, rest, place);
      if (moved < rest) {
        rest = moved;
        r.place = place;
      }
    }
    r.loss = rest - (cost - rate_ * angles);
    r.is_measured = true;
  }

  void measure(Insertion& x)
  {
    fan_.clear();
    const Vector n = normal(x.t) + normal(x.u);
    const Vector &a = positions_[x.corners[0]], &b = positions_[x.corners[1]], &c = positions_[x.corners[2]],
                 &d = positions_[x.corners[3]];
    const Vector middle = 0.5 * (a + b);
    fan_.add_triangle(a, middle, c, 1, n);
    fan_.add_triangle(middle, b, c, 0, n);
    fan_.add_triangle(b, middle, d, 1, n);
    fan_.add_triangle(middle, a, d, 0, n);
    add_samples_of(x.t);
    add_samples_of(x.u);
    const double least = (std::min)({min_angle, angle_[x.t], angle_[x.u]});
    const double rest = best_place(middle, max_steps, least, std::numeric_limits<double>::infinity(), x.place);
    x.gain = cost_[x.t] + cost_[x.u] - rate_ * (angle_[x.t] + angle_[x.u]) - rest;
    x.is_measured = true;
  }

  // Returns the minimal cost of samples and angles of the fan while its vertex moves from `p` to better positions; infinite
  // if the fan is never valid.
  double best_place(Vector p, int steps, double least_angle, double limit, Vector& place)
  {
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < steps; ++i) {
      fan_.move_to(p);
      Vector better;
      const double bonus = rate_ * fan_.sum_of_angles();
      const double cost = sample_weight() * fan_.squared_distances(p, better) - bonus;
      if (cost < best && cost < limit && fan_.is_sound(std::cos(least_angle) + 1e-12)) {
        best = cost;
        place = p;
      }
      p = better;
    }
    return best;
  }

  bool do_overlap(const Removal& r, const Insertion& x) const
  {
    const auto is_corner = [&](Index v) { return std::find(x.corners.begin(), x.corners.end(), v) != x.corners.end(); };
    return any_around(r.vertex, is_corner) || any_around(r.into, is_corner);
  }

  // Returns the nearest face of the input among the samples around.
  Index nearest_face(const Insertion& x) const
  {
    Index nearest = NONE;
    double least = 0;
    for (const Index t : {x.t, x.u})
      samples_.for_each_on(t, [&](const Fit_samples::Sample& s) {
        const Vector d = s.position - x.place;
        if (nearest == NONE || dot(d, d) < least) {
          least = dot(d, d);
          nearest = s.face;
        }
      });
    return nearest;
  }

  // Returns whether both steps were made: not if the distance in both directions would increase, or if the clusters cannot
  // follow.
  template <class Relocate>
  bool exchange(const Removal& r, const Insertion& x, const Relocate& relocate)
  {
    const Index v = r.vertex, face = nearest_face(x);
    std::vector<Index> around = coarse_.around(v), changed, split{x.t, x.u};
    std::vector<Triangle> now, before;
    for (const Index t : coarse_.around(v))
      if (coarse_.corner(t, r.into) >= 0) {
        split.push_back(t);
      } else {
        changed.push_back(t);
        now.push_back(with_corner(triangle(t), v, r.into));
      }
    for (const Index t : coarse_.around(r.into))
      if (coarse_.corner(t, v) < 0)
        around.push_back(t);
    changed.insert(changed.end(), split.begin(), split.end());
    const auto [a, b, c, d] = x.corners;
    now.insert(now.end(), {{a, v, c}, {v, b, c}, {b, v, d}, {v, a, d}});
    for (const Index t : changed)
      before.push_back(triangle(t));
    std::vector<Index> all = around;
    all.insert(all.end(), {x.t, x.u});
    const double cost = cost_of(all);
    const Vector place = std::exchange(positions_[r.into], r.place), place_of_v = std::exchange(positions_[v], x.place);
    coarse_.replace(changed, now);
    samples_.redistribute(around, coarse_.around(r.into));
    samples_.redistribute({x.t, x.u}, split);
    if (face != NONE && cost_of(all) < cost + 1 * x.gain && relocate(v, r.into, face)) {
      touch(r, x);
      return true;
    }
    positions_[r.into] = place;
    positions_[v] = place_of_v;
    coarse_.replace(changed, before);
    samples_.redistribute(all, all);
    return false;
  }

  double cost_of(const std::vector<Index>& triangles) const
  {
    double sum = 0;
    for (const Index t : triangles)
      sum += samples_.cost(t) - rate_ * angle(triangle(t));
    return sum;
  }

  // The old and new neighbors of the vertices.
  void touch(const Removal& r, const Insertion& x)
  {
    is_touched_[r.into] = true;
    const auto touch = [this](Index y) {
      is_touched_[y] = true;
      return false;
    };
    any_around(r.into, touch);
    any_around(r.vertex, touch);
    std::for_each(x.corners.begin(), x.corners.end(), touch);
  }

  const Border_arcs& border_;
  Flippable_triangulation& coarse_;
  std::vector<Vector>& positions_;
  Fit_samples& samples_;
  Cancellation_point cancellation_;
  double rate_ = 0;
  std::vector<double> cost_, angle_; // of each triangle
  std::vector<char> is_touched_;     // of each vertex, in this run
  std::priority_queue<Removal> removals_;
  std::priority_queue<Insertion> insertions_;
  Trial_fan fan_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_VERTEX_EXCHANGE_H
