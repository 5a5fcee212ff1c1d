// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_BORDER_FIT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_BORDER_FIT_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// A part of a border loop or of a feature line, simplified to few points: the corners, the ends and the midpoint.
class Border_arc
{
public:
  //! [pieces]
  static constexpr std::size_t max_pieces = 16;
  //! [pieces]
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // `fixed` is the only point that may be chosen, if given.
  explicit Border_arc(const std::vector<Vector>& points, std::size_t fixed = none)
  {
    std::vector<double> length(1, 0);
    for (std::size_t i = 1; i < points.size(); ++i)
      length.push_back(length.back() + internal::length(points[i] - points[i - 1]));
    const double whole = length.back();
    std::vector<std::size_t> kept(1, 0);
    for (std::size_t i = 1, piece = 0; i + 1 < points.size(); ++i) {
      // Of many points, keep the point of sharpest turn on each of several pieces of equal length.
      const std::size_t on = points.size() - 2 <= max_pieces ? i
                             : whole > 0 ? std::size_t(double(max_pieces) * (length[i] / whole)) + 1
                                         : 1;
      if (on != piece || i == fixed || kept.back() == fixed)
        kept.push_back(i);
      else if (turn(points, i) > turn(points, kept.back()))
        kept.back() = i;
      piece = on;
    }
    kept.push_back(points.size() - 1);
    for (std::size_t k = 0; k < kept.size(); ++k) {
      const std::size_t i = kept[k];
      if (k > 0 && length[kept[k - 1]] < 0.5 * whole && 0.5 * whole < length[i])
        add_half_way(points, length);
      if (i == fixed)
        fixed_ = points_.size();
      points_.push_back(points[i]);
      part_.push_back(whole > 0 ? length[i] / whole : 0.5);
    }
    if (!(whole > 0) && points_.size() == 2)
      add_half_way(points, length);
    length_ = whole;
  }

  std::size_t size() const { return points_.size(); }
  const Vector& operator[](std::size_t i) const { return points_[i]; }
  // Returns the position of the point: 0 at the begin of the arc, 1 at its end.
  double part(std::size_t i) const { return part_[i]; }
  double length() const { return length_; }
  bool may_be_chosen(std::size_t i) const { return fixed_ == none || fixed_ == i; }

private:
  // A measure that increases with the turning angle of the polyline.
  static double turn(const std::vector<Vector>& p, std::size_t i)
  {
    const Vector a = p[i] - p[i - 1], b = p[i + 1] - p[i];
    const double product = std::sqrt(dot(a, a) * dot(b, b));
    return product > 0 ? 1 - dot(a, b) / product : 0;
  }

  void add_half_way(const std::vector<Vector>& points, const std::vector<double>& length)
  {
    const double half = 0.5 * length.back();
    std::size_t i = 0;
    while (i + 2 < points.size() && length[i + 1] < half)
      ++i;
    const double edge = length[i + 1] - length[i];
    points_.push_back(points[i] + (edge > 0 ? (half - length[i]) / edge : 0.5) * (points[i + 1] - points[i]));
    part_.push_back(0.5);
  }

  std::vector<Vector> points_;
  std::vector<double> part_;
  double length_ = 0;
  std::size_t fixed_ = none;
};

// Chooses a point on each arc of a border loop such that the polygon of these points approximates the loop best:
// minimizes the integral along the loop of the squared distance from the corresponding side, by dynamic programming
// over the points of the arcs. A small multiple of the squared distance from the middle of the arc is added. It decides between
// nearly equal results, for example on a straight border, and keeps the points apart.
//
// Lines that are not loops end with arcs of which only one point may be chosen.
class Border_fit
{
public:
  explicit Border_fit(const std::vector<Border_arc>& arcs, bool is_loop = true) : arcs_(arcs)
  {
    const std::size_t sides = is_loop ? arcs.size() : arcs.size() - 1;
    for (std::size_t i = 0; i < sides; ++i)
      sides_.push_back(side_costs(arcs[i], arcs[(i + 1) % arcs.size()]));
  }

  // Returns the numbers of the chosen points.
  std::vector<std::size_t> run() const
  {
    std::vector<std::size_t> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t first = 0; first < arcs_[0].size(); ++first) {
      if (!arcs_[0].may_be_chosen(first))
        continue;
      const Chain chain = cheapest_chain(first);
      if (best.empty() || chain.cost < least) {
        least = chain.cost;
        best = chain.points;
      }
    }
    return best;
  }

private:
  typedef std::vector<std::vector<double> > Table; // for each point of an arc and each point of the next arc

  struct Chain
  {
    double cost;
    std::vector<std::size_t> points;
  };

  static double squared_distance(const Vector& p, const Vector& a, const Vector& b)
  {
    const double u = closest_on_segment(p, a, b);
    const Vector d = p - ((1 - u) * a + u * b);
    return dot(d, d);
  }

  // Returns the integral, along the segment from `p` to `q`, of the squared distance from the segment from `a` to `b`, by
  // Simpson's rule.
  static double integral(const Vector& p, const Vector& q, const Vector& a, const Vector& b)
  {
    return length(q - p) / 6 *
           (squared_distance(p, a, b) + 4 * squared_distance(0.5 * (p + q), a, b) + squared_distance(q, a, b));
  }

  static Table side_costs(const Border_arc& arc, const Border_arc& next)
  {
    Table costs(arc.size(), std::vector<double>(next.size()));
    for (std::size_t i = 0; i < arc.size(); ++i)
      for (std::size_t j = 0; j < next.size(); ++j) {
        double& cost = costs[i][j];
        for (std::size_t k = i; k + 1 < arc.size(); ++k)
          cost += integral(arc[k], arc[k + 1], arc[i], next[j]);
        for (std::size_t k = 0; k < j; ++k)
          cost += integral(next[k], next[k + 1], arc[i], next[j]);
        const double off = next.part(j) - 0.5, length = next.length();
        cost += centering_weight * off * off * length * length * length;
        if (!next.may_be_chosen(j))
          cost = std::numeric_limits<double>::infinity();
      }
    costs[arc.size() - 1][0] = std::numeric_limits<double>::infinity(); // the same point
    return costs;
  }

  // Returns the cheapest chain from point `first` of the first arc around the loop back to this point, or to the last arc.
  Chain cheapest_chain(std::size_t first) const
  {
    const std::size_t n = sides_.size();
    std::vector<std::vector<std::size_t> > from(n);
    std::vector<double> cost(arcs_[0].size(), std::numeric_limits<double>::infinity());
    cost[first] = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const Table& side = sides_[k];
      std::vector<double> after(side[0].size(), std::numeric_limits<double>::infinity());
      from[k].assign(after.size(), 0);
      for (std::size_t i = 0; i < cost.size(); ++i)
        for (std::size_t j = 0; j < after.size(); ++j)
          if (cost[i] + side[i][j] < after[j]) {
            after[j] = cost[i] + side[i][j];
            from[k][j] = i;
          }
      cost.swap(after);
    }
    const bool is_loop = n == arcs_.size();
    std::size_t at = is_loop ? first : std::size_t(std::min_element(cost.begin(), cost.end()) - cost.begin());
    Chain chain{cost[at], std::vector<std::size_t>(arcs_.size(), first)};
    if (!is_loop)
      chain.points[n] = at;
    for (std::size_t k = n; k-- > 1;)
      chain.points[k] = at = from[k][at];
    return chain;
  }

  static constexpr double centering_weight = 3e-4;
  const std::vector<Border_arc>& arcs_;
  std::vector<Table> sides_;
};

// Chooses the vertices of the clusters along a border loop. `cluster_after` holds, for each point of the loop, the cluster of the
// edge after it. `make_arc(places, cluster)` returns the arc of a cluster, and `set_vertex(cluster, point)` receives the result.
template <class MakeArc, class SetVertex>
void fit_border_loop(const std::vector<Index>& cluster_after, const MakeArc& make_arc, const SetVertex& set_vertex)
{
  const std::size_t n = cluster_after.size();
  std::size_t begin = 0; // the begin of a part of the loop that belongs to one cluster
  while (begin < n && cluster_after[begin] == cluster_after[(begin + n - 1) % n])
    ++begin;
  std::vector<Border_arc> arcs;
  std::vector<Index> clusters;
  for (std::size_t i = 0; i < n;) {
    clusters.push_back(cluster_after[(begin + i) % n]);
    std::vector<std::size_t> places;
    do
      places.push_back((begin + i++) % n);
    while (i < n && cluster_after[(begin + i) % n] == clusters.back());
    places.push_back((begin + i) % n);
    arcs.push_back(make_arc(places, clusters.back()));
  }
  const std::vector<std::size_t> chosen = Border_fit(arcs).run();
  for (std::size_t k = 0; k < arcs.size(); ++k)
    set_vertex(clusters[k], arcs[k][chosen[k]]);
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_BORDER_FIT_H
