// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_BORDER_ARCS_H
#define CGAL_SURFACE_MESH_COARSENING_BORDER_ARCS_H

#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_coarsening {

namespace internal {

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

} // namespace internal

/// \ingroup PkgSurfaceMeshCoarseningRef
/// The border of the mesh, divided into arcs: one arc for each cluster on the border. The vertex of a cluster on the border lies
/// on its arc, so the border of the coarse mesh is inscribed in the border of the mesh. The positions on the arcs minimize the
/// distance between the two borders. An arc with a sharp corner has its vertex at the corner.
///
/// If features are kept, feature lines are divided into arcs in the same way, and a cluster with a feature corner has its
/// vertex at that corner.
class Border_arcs
{
public:
  /// \cond SKIP_IN_MANUAL
  // `with_border`: whether clusters on the border have their vertex on the border.
  explicit Border_arcs(const internal::Clustered_faces& surface, bool with_border = true)
    : mesh_(surface.input().mesh), labels_(surface.labels()), features_(surface.features()),
      place_of_(surface.number_of_clusters(), internal::NONE)
  {
    if (with_border)
      internal::for_each_border_loop(mesh_, internal::Run_context(),
                                     [this](const std::vector<Index>& loop) { place_on_border(loop); });
    if (features_)
      place_on_features(*features_);
  }
  /// \endcond

  /// returns whether a cluster contains a part of the border or of a feature.
  bool is_on_border(std::size_t cluster) const { return place_of_[cluster] != internal::NONE; }

  /// places the vertices of the clusters on the border or on features. Other positions do not change.
  void place(std::vector<Clustered_surface::Point_3>& positions) const
  {
    for (std::size_t x = 0; x < place_of_.size(); ++x)
      if (is_on_border(x))
        positions[x] = internal::to_point(places_[place_of_[x]]);
  }
  /// \cond SKIP_IN_MANUAL
  void place(std::vector<internal::Vector>& positions) const
  {
    for (std::size_t x = 0; x < place_of_.size(); ++x)
      if (is_on_border(x))
        positions[x] = places_[place_of_[x]];
  }

  // Returns the place on the border or on a feature of a cluster that contains a part of it.
  const internal::Vector& place(std::size_t cluster) const { return places_[place_of_[cluster]]; }
  /// \endcond

private:
  typedef internal::Index Index;
  typedef internal::Vector Vector;

  void place_on_border(const std::vector<Index>& loop)
  {
    std::vector<Index> cluster_after; // of the face at the border edge that begins at each vertex
    for (const Index v : loop)
      cluster_after.push_back(labels_[mesh_.star[mesh_.first_in_star[v]]]);
    internal::fit_border_loop(
      cluster_after,
      [&](const std::vector<std::size_t>& places, Index cluster) {
        std::vector<Index> vertices;
        for (const std::size_t i : places)
          vertices.push_back(loop[i]);
        return arc(vertices, cluster);
      },
      [this](Index cluster, const Vector& place) { set_place(cluster, place); });
  }

  void place_on_features(const internal::Coarse_features& features)
  {
    for (const internal::Coarse_features::Line& line : features.lines()) {
      std::vector<internal::Border_arc> arcs;
      for (const internal::Coarse_features::Arc& a : line.arcs)
        arcs.push_back(arc(a.vertices, a.cluster));
      const std::vector<std::size_t> chosen = internal::Border_fit(arcs, line.is_loop).run();
      for (std::size_t k = 0; k < arcs.size(); ++k)
        set_place(line.arcs[k].cluster, arcs[k][chosen[k]]);
    }
    for (std::size_t x = 0; x < features.corners().size(); ++x)
      if (features.corners()[x] != internal::NONE)
        set_place(Index(x), mesh_.points[features.corners()[x]]);
  }

  // Returns the part of a polyline in a cluster. Its vertex is the feature corner if there is one.
  internal::Border_arc arc(const std::vector<Index>& vertices, Index cluster) const
  {
    std::vector<Vector> points;
    std::size_t fixed = internal::Border_arc::none;
    for (const Index v : vertices) {
      if (features_ && features_->corners()[cluster] == v)
        fixed = points.size();
      points.push_back(mesh_.points[v]);
    }
    return internal::Border_arc(points, fixed);
  }

  void set_place(Index cluster, const Vector& place)
  {
    place_of_[cluster] = Index(places_.size());
    places_.push_back(place);
  }

  const internal::Flat_mesh& mesh_;
  const internal::Cluster_labels& labels_;
  const internal::Coarse_features* features_;
  std::vector<Index> place_of_; // per cluster; NONE inside and off features
  std::vector<Vector> places_;
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_BORDER_ARCS_H
