// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_TRIAL_DISTANCE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_TRIAL_DISTANCE_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/sort_unique.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The squared distance of the clusters around some vertices from the coarse triangles there: the estimated sum over the clusters
// of their area times their mean squared distance. Remembers the nearest triangle of each sample, so a trial visits all
// triangles only for the samples whose nearest triangle it changes.
class Trial_distance
{
public:
  Trial_distance(const Clustered_faces& surface, const Flippable_triangulation& coarse, const std::vector<Vector>& positions)
    : surface_(surface), coarse_(coarse), positions_(positions)
  {}

  // Measures the distance of the clusters of some vertices and of the clusters around them. Vertices of very many triangles are
  // omitted, because they would take quadratic time.
  void measure_around(const std::vector<Index>& vertices)
  {
    std::vector<Index> clusters;
    for (const Index v : vertices)
      for (const Index t : coarse_.around(v))
        clusters.insert(clusters.end(), coarse_.triangles()[t].begin(), coarse_.triangles()[t].end());
    sort_unique(clusters);
    triangles_.clear();
    for (const Index v : clusters)
      triangles_.insert(triangles_.end(), coarse_.around(v).begin(), coarse_.around(v).end());
    sort_unique(triangles_);
    samples_.clear();
    current_ = 0;
    if (triangles_.size() > max_triangles)
      return;
    balls_.clear();
    for (const Index t : triangles_)
      balls_.push_back(ball_around(t));
    for (const Index x : clusters)
      add_samples(x);
    for (const Sample& s : samples_)
      current_ += s.weight * s.squared_distance;
  }

  // Returns the distance of the measured positions.
  double current() const { return current_; }

  // Returns the distance after a change of some triangles. Stops when it exceeds `limit`.
  double changed(const std::vector<Index>& altered, double limit = std::numeric_limits<double>::infinity())
  {
    if (samples_.empty())
      return 0;
    begin_trial(altered);
    double sum = 0;
    for (const Sample& s : samples_) {
      sum += s.weight * changed_distance(s);
      if (sum >= limit)
        break;
    }
    end_trial();
    return sum;
  }

private:
  static constexpr std::size_t max_samples = 24;   // of a cluster
  static constexpr std::size_t max_triangles = 500;

  struct Ball
  {
    Vector center;
    double radius;
  };

  struct Sample
  {
    Vector point;
    double weight, squared_distance;
    std::size_t nearest; // triangle, by its position in the list
  };

  struct Altered_ball
  {
    std::size_t place;
    Ball before;
  };

  Ball ball_around(Index triangle) const
  {
    const Triangle& t = coarse_.triangles()[triangle];
    Ball ball{(1. / 3) * (positions_[t[0]] + positions_[t[1]] + positions_[t[2]]), 0};
    for (const Index v : t) {
      const Vector d = positions_[v] - ball.center;
      ball.radius = (std::max)(ball.radius, dot(d, d));
    }
    ball.radius = std::sqrt(ball.radius);
    return ball;
  }

  void add_samples(Index cluster)
  {
    const Clustered_faces::Range faces = surface_.faces(cluster);
    const std::size_t step = 1 + faces.size() / max_samples;
    for (std::size_t i = 0; i < faces.size(); i += step) {
      const Index f = faces.begin()[i];
      Sample s{surface_.centroid(f), double(step) * surface_.area(f), 0, samples_.empty() ? 0 : samples_.back().nearest};
      s.squared_distance = squared_distance(s.point, s.nearest, s.nearest);
      samples_.push_back(s);
    }
  }

  void begin_trial(const std::vector<Index>& altered)
  {
    is_altered_.assign(triangles_.size(), false);
    altered_.clear();
    for (const Index t : altered) {
      const auto place = std::lower_bound(triangles_.begin(), triangles_.end(), t);
      if (place == triangles_.end() || *place != t)
        continue;
      const std::size_t i = std::size_t(place - triangles_.begin());
      altered_.push_back({i, balls_[i]});
      is_altered_[i] = true;
      balls_[i] = ball_around(t);
    }
  }

  void end_trial()
  {
    for (const Altered_ball& a : altered_)
      balls_[a.place] = a.before;
  }

  double changed_distance(const Sample& s) const
  {
    std::size_t unused;
    if (is_altered_[s.nearest])
      return squared_distance(s.point, s.nearest, unused);
    double nearest = s.squared_distance, distance = std::sqrt(nearest);
    for (const Altered_ball& a : altered_)
      improve(s.point, a.place, nearest, distance);
    return nearest;
  }

  // Returns the squared distance from the nearest triangle. The search begins with triangle `first`.
  double squared_distance(const Vector& p, std::size_t first, std::size_t& last) const
  {
    double nearest = to(p, first, std::numeric_limits<double>::infinity()), distance = std::sqrt(nearest);
    last = first;
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      if (i != first && improve(p, i, nearest, distance))
        last = i;
    return nearest;
  }

  // Skips a triangle whose bounding ball is farther than the nearest triangle so far.
  bool improve(const Vector& p, std::size_t i, double& nearest, double& distance) const
  {
    const Vector d = p - balls_[i].center;
    const double reach = 1.000001 * (balls_[i].radius + distance);
    if (dot(d, d) > reach * reach)
      return false;
    const double square = to(p, i, nearest);
    if (!(square < nearest))
      return false;
    nearest = square;
    distance = std::sqrt(square);
    return true;
  }

  double to(const Vector& p, std::size_t i, double limit) const
  {
    const Triangle& t = coarse_.triangles()[triangles_[i]];
    return closest_on_triangle(p, positions_[t[0]], positions_[t[1]], positions_[t[2]], limit).squared_distance;
  }

  const Clustered_faces& surface_;
  const Flippable_triangulation& coarse_;
  const std::vector<Vector>& positions_;
  std::vector<Index> triangles_; // in order
  std::vector<Ball> balls_;      // around these triangles
  std::vector<Sample> samples_;
  std::vector<Altered_ball> altered_;
  std::vector<char> is_altered_;
  double current_ = 0;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_TRIAL_DISTANCE_H
