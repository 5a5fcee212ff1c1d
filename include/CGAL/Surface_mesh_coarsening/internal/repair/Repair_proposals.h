// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_REPAIR_PROPOSALS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_REPAIR_PROPOSALS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Prepared_triangle.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Coarse_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Input_oracle.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

struct Vertex_move
{
  Index vertex;
  Vector to;
};

// A change of a placement: moves of vertices, or the flip of an edge.
struct Placement_change
{
  std::vector<Vertex_move> moves;
  Index flipped = NONE;
  int corner = 0;
};

// Returns the square root of the area of the triangles around a vertex.
inline double size_around(const Flippable_triangulation& coarse, const std::vector<Vector>& positions, Index v)
{
  double area = 0;
  for (const Index t : coarse.around(v))
    area += 0.5 * length(normal_of(positions, coarse.triangles()[t]));
  return std::sqrt(area);
}

// Proposes the changes that a repair tries at a few triangles.
class Repair_proposals
{
public:
  // `at_input_vertices`: whether vertices may move only to input vertices of their clusters.
  Repair_proposals(const Coarse_mesh& mesh, const Input_oracle& reference, bool at_input_vertices)
    : mesh_(mesh), surface_(reference.surface()), reference_(reference), positions_(mesh.positions()),
      at_input_vertices_(at_input_vertices)
  {}

  // `vertices` are the corners of the triangles `faulty`. `tries_faces` adds moves to faces of the clusters.
  std::vector<Placement_change> at(const std::vector<Index>& faulty, const std::vector<Index>& vertices, bool tries_faces) const
  {
    std::vector<Placement_change> changes;
    for (const Index v : vertices)
      for (const Vector& to : mesh_.is_on_border(v) ? places_on_line(v) : places_for(v, tries_faces))
        changes.push_back({{{v, to}}, NONE, 0});
    for (const Index t : faulty)
      for (int i = 0; i < 3; ++i) {
        const Index u = mesh_.across(t, i);
        if (u != NONE && mesh_.may_flip(t, i, u))
          changes.push_back({{}, t, i});
      }
    if (at_input_vertices_)
      return changes;
    add_common_moves(faulty, vertices, changes);
    for (Placement_change& change : changes)
      for (Vertex_move& move : change.moves)
        move.to = mesh_.within_bounds(move.vertex, without_last_digits(move.to));
    return changes;
  }

private:
  static constexpr std::size_t max_input_vertices = 24, max_input_faces = 12;

  // Returns possible positions of a vertex.
  std::vector<Vector> places_for(Index v, bool tries_faces) const
  {
    std::vector<Vector> places;
    if (at_input_vertices_) {
      for (const Index f : surface_.faces(v))
        for (const Index w : surface_.vertices(f))
          if (!surface_.is_on_cluster_boundary(w) &&
              std::find(places.begin(), places.end(), surface_.point(w)) == places.end() && places.size() < max_input_vertices)
            places.push_back(surface_.point(w));
      return places;
    }
    const Vector from = positions_[v], centroid = surface_.cluster_centroid(v),
                 middle = mesh_.mean_of_neighbors(v, positions_);
    for (const double part : {0.03, 0.1, 0.3, 0.6, 1.}) {
      places.push_back(from + part * (centroid - from));
      places.push_back(from + part * (middle - from));
    }
    const Clustered_faces::Range faces = surface_.faces(v);
    const std::size_t step = 1 + faces.size() / max_input_faces;
    for (std::size_t i = step / 2; tries_faces && i < faces.size(); i += step)
      places.push_back(surface_.centroid(faces.begin()[i]));
    for (const double part : {0.01, 0.03, 0.1, 0.25}) {
      const Vector out = part * size_around(mesh_, positions_, v) * reference_.normal(v);
      places.push_back(from + out);
      places.push_back(from - out);
    }
    return places;
  }

  // Returns positions towards the middle of the vertex's part of a feature line, where it was before the fit. Vertices on borders
  // that are no features are still there.
  std::vector<Vector> places_on_line(Index v) const
  {
    std::vector<Vector> places;
    const Vector from = positions_[v], middle = mesh_.border().place(v);
    if (!at_input_vertices_ && from != middle)
      for (const double part : {0.1, 0.3, 0.6, 1.})
        places.push_back(from + part * (middle - from));
    return places;
  }

  // Adds changes that move several vertices that are not on borders: all towards their centroids; the vertices of two triangles apart
  // or towards each other, each along the normals of its own surface.
  void add_common_moves(const std::vector<Index>& faulty, std::vector<Index> vertices, std::vector<Placement_change>& changes) const
  {
    const auto is_on_border = [this](Index v) { return mesh_.is_on_border(v); };
    vertices.erase(std::remove_if(vertices.begin(), vertices.end(), is_on_border), vertices.end());
    if (vertices.empty())
      return;
    for (const double part : {0.1, 0.3, 0.6, 1.}) {
      Placement_change change;
      for (const Index v : vertices)
        change.moves.push_back({v, positions_[v] + part * (surface_.cluster_centroid(v) - positions_[v])});
      changes.push_back(change);
    }
    for (const double part : {0.01, -0.01, 0.03, -0.03, 0.1, -0.1, 0.25, -0.25})
      for (std::size_t chosen = 0; chosen <= faulty.size(); ++chosen) { // one of the triangles, or all
        Placement_change change;
        for (const Index v : vertices)
          if (chosen == faulty.size() || mesh_.corner(faulty[chosen], v) >= 0)
            change.moves.push_back({v, positions_[v] + part * size_around(mesh_, positions_, v) * reference_.normal(v)});
        changes.push_back(change);
      }
  }

  const Coarse_mesh& mesh_;
  const Clustered_faces& surface_;
  const Input_oracle& reference_;
  const std::vector<Vector>& positions_;
  const bool at_input_vertices_;
};

// The squared distance of the clusters around some vertices from the coarse triangles there: the estimated sum over the clusters
// of their area times their mean squared distance. Remembers the nearest triangle of each sample, so a trial visits all
// triangles only for the samples whose nearest triangle it changes.
class Trial_distance
{
public:
  Trial_distance(const Coarse_mesh& mesh, const Clustered_faces& surface)
    : surface_(surface), coarse_(mesh), positions_(mesh.positions())
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
    in_balls_.clear();
    for (const Index t : triangles_)
      in_balls_.push_back(triangle_in_ball(t));
    for (const Index x : clusters)
      add_samples(x);
    comparisons_ += samples_.size() * triangles_.size();
    for (const Sample& s : samples_)
      current_ += s.weight * s.squared_distance;
  }

  // Returns the number of distances from triangles that were bounded or computed since the last call.
  std::size_t take_comparisons() { return std::exchange(comparisons_, 0); }

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
      comparisons_ += is_altered_[s.nearest] ? triangles_.size() : altered_.size();
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

  // A triangle and the ball around its centroid that contains it.
  struct Triangle_in_ball
  {
    Vector center;
    double radius;
    Prepared_triangle triangle;
  };

  struct Sample
  {
    Vector point;
    double weight, squared_distance;
    std::size_t nearest; // triangle, by its position in the list
  };

  struct Altered_triangle
  {
    std::size_t place;
    Triangle_in_ball before;
  };

  Triangle_in_ball triangle_in_ball(Index triangle) const
  {
    const Triangle& t = coarse_.triangles()[triangle];
    Triangle_in_ball result{(1. / 3) * (positions_[t[0]] + positions_[t[1]] + positions_[t[2]]), 0,
                            Prepared_triangle(positions_, t)};
    for (const Index v : t) {
      const Vector d = positions_[v] - result.center;
      result.radius = (std::max)(result.radius, dot(d, d));
    }
    result.radius = std::sqrt(result.radius);
    return result;
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
      altered_.push_back({i, in_balls_[i]});
      is_altered_[i] = true;
      in_balls_[i] = triangle_in_ball(t);
    }
  }

  void end_trial()
  {
    for (const Altered_triangle& a : altered_)
      in_balls_[a.place] = a.before;
  }

  double changed_distance(const Sample& s) const
  {
    std::size_t unused;
    if (is_altered_[s.nearest])
      return squared_distance(s.point, s.nearest, unused);
    Foot_point nearest{{{1, 0, 0}}, s.squared_distance};
    double distance = std::sqrt(s.squared_distance);
    for (const Altered_triangle& a : altered_)
      improve(s.point, a.place, nearest, distance);
    return nearest.squared_distance;
  }

  // Returns the squared distance from the nearest triangle. The search begins with triangle `first`.
  double squared_distance(const Vector& p, std::size_t first, std::size_t& last) const
  {
    Foot_point nearest = in_balls_[first].triangle.closest(p);
    double distance = std::sqrt(nearest.squared_distance);
    last = first;
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      if (i != first && improve(p, i, nearest, distance))
        last = i;
    return nearest.squared_distance;
  }

  // Skips a triangle whose ball is farther than the nearest triangle so far.
  bool improve(const Vector& p, std::size_t i, Foot_point& nearest, double& distance) const
  {
    const Vector d = p - in_balls_[i].center;
    const double reach = 1.000001 * (in_balls_[i].radius + distance);
    if (dot(d, d) > reach * reach || !in_balls_[i].triangle.improve(p, nearest))
      return false;
    distance = std::sqrt(nearest.squared_distance);
    return true;
  }

  const Clustered_faces& surface_;
  const Flippable_triangulation& coarse_;
  const std::vector<Vector>& positions_;
  std::vector<Index> triangles_; // in order
  std::vector<Triangle_in_ball> in_balls_;
  std::vector<Sample> samples_;
  std::vector<Altered_triangle> altered_;
  std::vector<char> is_altered_;
  double current_ = 0;
  std::size_t comparisons_ = 0;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_REPAIR_PROPOSALS_H
