// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_SURFACE_FIT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_SURFACE_FIT_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Fit_equations.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Input_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Line_fits.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Fits a triangle mesh, one vertex per cluster, to the faces of the clusters, by the squared distances of samples of both
// surfaces from the other: alternately looks for the closest points of the samples, and solves for the movements that
// bring them closest. Closest points are looked for nearby only, so that they stay on the same side of thin parts.
class Surface_fit
{
public:
  Surface_fit(const Clustered_surface& surface, const Border_arcs& border, Flippable_triangulation& coarse,
              std::vector<Vector>& positions)
    : input_(surface.input().mesh), execution_(surface.execution()), border_(border), coarse_(coarse), positions_(positions),
      lines_(surface, positions),
      of_triangle_(coarse.triangles().size()), back_(coarse.triangles().size())
  {
    const std::vector<Input_point> points = input_.samples(samples_per_triangle * of_triangle_.size(), area_);
    samples_.reserve(points.size());
    for (const Input_point& p : points)
      samples_.push_back({p, surface.labels()[p.face], NONE, {}});
    sample_weight_ = samples_.empty() ? 0 : area_ / double(samples_.size());
  }

  // Finds the closest points of the samples of the input on the triangles around, and of those of the triangles on the input.
  void find_feet()
  {
    for (std::vector<Index>& list : of_triangle_)
      list.clear();
    for_each_chunk(execution_, samples_.size(), 256, [this](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        find_foot(samples_[i]);
    });
    for (std::size_t i = 0; i < samples_.size(); ++i)
      of_triangle_[samples_[i].triangle].push_back(Index(i));
    for_each_chunk(execution_, back_.size(), 64, [this](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t)
        back_[t] = feet_of(coarse_.triangles()[t], lists_around(Index(t)), max_steps);
    });
    lines_.find_feet();
  }

  // Moves the vertices, but for those on the border and at corners, to where the sum of the squared distances is smallest as far
  // as it can be told from the closest points. Where that leaves a vertex free to slide, it does so towards the middle of its
  // neighbors.
  void move_vertices()
  {
    const std::vector<Triangle>& triangles = coarse_.triangles();
    Fit_equations equations(triangles, positions_.size());
    std::vector<Hold> holds(positions_.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
      add_triangle(Index(t), equations, holds);
    lines_.add_to(equations, coarse_, line_width * std::sqrt(area_ / double(positions_.size())), damping);
    const double mean_size = 2 * area_ / double(triangles.size());
    const double shape = area_ > 0 ? shape_part * sum_of_squared_distances() / area_ / mean_size : 0;
    const double inertia = min_inertia * area_ / double(positions_.size());
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      equations.add_vertex(Index(v), {{0, 0, 0}}, inertia);
      if (border_.is_on_border(v)) {
        if (!lines_.is_on_line(Index(v)))
          equations.fix(Index(v));
        continue;
      }
      const Vector d = way_to_middle(Index(v));
      equations.add_vertex(Index(v), d, shape * holds[v].weight);
      equations.add_force(Index(v), free_part(holds[v].normals, d), damping * holds[v].squared_weight);
    }
    move_by(equations.solve(100, 1e-3));
  }

  // The sum over the samples of the input of their part of the area times the squared distance.
  double sum_of_squared_distances() const
  {
    double sum = 0;
    for (const Sample& s : samples_)
      sum += sample_weight_ * s.foot.squared_distance;
    return sum;
  }

  // What a triangle adds to the sums of both directions.
  double cost(Index t) const
  {
    double sum = cost_of(back_[t]);
    for (const Index i : of_triangle_[t])
      sum += sample_weight_ * samples_[i].foot.squared_distance;
    return sum;
  }

  // What two other triangles in the place of `t` and `u` would add; or more than `limit`, if that can be told early.
  double cost_instead(Index t, Index u, const Triangle& first, const Triangle& second, double limit) const
  {
    double sum = 0;
    for (const Index old : {t, u})
      for (const Index i : of_triangle_[old]) {
        const Vector& p = samples_[i].point.position;
        sum += sample_weight_ * (std::min)(foot_on(p, first).squared_distance, foot_on(p, second).squared_distance);
      }
    if (sum > limit)
      return sum;
    const Lists lists{{&of_triangle_[t], &of_triangle_[u]}, 2};
    return sum + cost_of(feet_of(first, lists, 1)) + cost_of(feet_of(second, lists, 1));
  }

  // Finds the closest points of the samples of two triangles anew after these two have changed.
  void redistribute(Index t, Index u)
  {
    std::vector<Index> list;
    list.swap(of_triangle_[t]);
    list.insert(list.end(), of_triangle_[u].begin(), of_triangle_[u].end());
    of_triangle_[u].clear();
    for (const Index i : list) {
      Sample& s = samples_[i];
      const Foot_point on_t = foot_on(s.point.position, coarse_.triangles()[t]);
      const Foot_point on_u = foot_on(s.point.position, coarse_.triangles()[u]);
      const bool nearer = on_u.squared_distance < on_t.squared_distance;
      s.foot = nearer ? on_u : on_t;
      s.triangle = nearer ? u : t;
      of_triangle_[s.triangle].push_back(i);
    }
    const Lists lists{{&of_triangle_[t], &of_triangle_[u]}, 2};
    back_[t] = feet_of(coarse_.triangles()[t], lists, 1);
    back_[u] = feet_of(coarse_.triangles()[u], lists, 1);
  }

private:
  static constexpr std::size_t samples_per_triangle = 16;
  static constexpr int max_steps = 3;
  static constexpr int max_halvings = 5;
  // The weight of sideways movements of samples. They do not change the distance as long as they are small.
  static constexpr double damping = 0.02;
  // The weight of the way to the middle of the neighbors, where the coarse mesh is as far off as it is wide.
  static constexpr double shape_part = 3;
  // Eigenvalues of the normals around a vertex that are smaller than this part of the largest leave it free to slide.
  static constexpr double free_part_below = 0.01;
  static constexpr double min_inertia = 0.001;
  // Lines count as strips of this width, where 1 is about the length of an edge.
  static constexpr double line_width = 1;

  struct Sample
  {
    Input_point point;
    Index cluster;
    Index triangle; // where its foot is; NONE before the first search
    Foot_point foot;
  };

  // A point of a coarse triangle and its closest point on the input.
  struct Back_sample
  {
    Vector barycentric;
    Vector foot;
    double weight = 0;
    double squared_distance = 0;
  };
  typedef std::array<Back_sample, 6> Back_samples;

  // Samples among which to look for the one closest to a point.
  struct Lists
  {
    std::array<const std::vector<Index>*, 4> lists;
    std::size_t number;
  };

  // What holds a vertex: the weights of the samples around, and the sum of the squares of their normals.
  struct Hold
  {
    double weight = 0, squared_weight = 0;
    Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
  };

  Foot_point foot_on(const Vector& p, const Triangle& t) const
  {
    return closest_on_triangle(p, positions_[t[0]], positions_[t[1]], positions_[t[2]]);
  }

  // Triangles may not turn by more than a right angle: the vertices of those that would go half as far.
  void move_by(std::vector<Vector> moves)
  {
    const std::vector<Vector> before = positions_;
    std::vector<bool> goes_too_far(positions_.size());
    for (int i = 0; i < max_halvings; ++i) {
      for (std::size_t v = 0; v < positions_.size(); ++v)
        positions_[v] = before[v] + moves[v];
      goes_too_far.assign(positions_.size(), false);
      for (const Triangle& t : coarse_.triangles())
        if (dot(normal_of(before, t), normal_of(positions_, t)) < 0)
          for (const Index v : t)
            goes_too_far[v] = true;
      for (std::size_t v = 0; v < positions_.size(); ++v)
        if (goes_too_far[v])
          moves[v] = 0.5 * moves[v];
    }
    for (std::size_t v = 0; v < positions_.size(); ++v)
      positions_[v] = before[v] + moves[v];
  }

  // First among the triangles around the vertex of the cluster, later from where the foot was before, around the corner
  // nearest to it, as far as that leads.
  void find_foot(Sample& s) const
  {
    const bool is_first = s.triangle == NONE;
    if (is_first)
      s.triangle = coarse_.around(s.cluster).front();
    s.foot = foot_on(s.point.position, coarse_.triangles()[s.triangle]);
    if (is_first)
      improve_foot(s, s.cluster);
    for (int step = 0; step < 10; ++step) {
      const Index from = s.triangle;
      const Vector& b = s.foot.barycentric;
      const std::size_t nearest = std::size_t(std::max_element(b.begin(), b.end()) - b.begin());
      improve_foot(s, coarse_.triangles()[from][nearest]);
      if (s.triangle == from)
        break;
    }
  }

  void improve_foot(Sample& s, Index vertex) const
  {
    for (const Index t : coarse_.around(vertex)) {
      if (t == s.triangle)
        continue;
      const Foot_point foot = foot_on(s.point.position, coarse_.triangles()[t]);
      if (foot.squared_distance < s.foot.squared_distance) {
        s.foot = foot;
        s.triangle = t;
      }
    }
  }

  Lists lists_around(Index t) const
  {
    Lists lists{{&of_triangle_[t], nullptr, nullptr, nullptr}, 1};
    for (int i = 0; i < 3; ++i) {
      const Index u = coarse_.across(t, i);
      if (u != NONE)
        lists.lists[lists.number++] = &of_triangle_[u];
    }
    return lists;
  }

  // The points of the quadrature of degree 4 on a triangle, and their closest points on the input, looked for around the
  // samples in the lists.
  Back_samples feet_of(const Triangle& t, const Lists& lists, int steps) const
  {
    constexpr double near[2] = {0.445948490915965, 0.091576213509771}, part[2] = {0.223381589678011, 0.109951743655322};
    const Vector n = normal_of(positions_, t);
    const double area = 0.5 * std::sqrt(dot(n, n));
    Back_samples back;
    for (int i = 0; i < 6; ++i) {
      Back_sample& s = back[std::size_t(i)];
      s.barycentric = {{near[i / 3], near[i / 3], near[i / 3]}};
      s.barycentric[std::size_t(i % 3)] = 1 - 2 * near[i / 3];
      const Vector p = point_of(t, s.barycentric);
      const Index start = face_of_nearest(p, lists);
      if (start == NONE)
        continue;
      const Input_surface::Closest closest = input_.closest_from(p, start, steps);
      s.foot = closest.point.position;
      s.squared_distance = closest.squared_distance;
      s.weight = area * part[i / 3];
    }
    return back;
  }

  static double cost_of(const Back_samples& back)
  {
    double sum = 0;
    for (const Back_sample& s : back)
      sum += s.weight * s.squared_distance;
    return sum;
  }

  Index face_of_nearest(const Vector& p, const Lists& lists) const
  {
    Index face = NONE;
    double nearest = 0;
    for (std::size_t l = 0; l < lists.number; ++l)
      for (const Index i : *lists.lists[l]) {
        const Vector d = samples_[i].point.position - p;
        if (face == NONE || dot(d, d) < nearest) {
          nearest = dot(d, d);
          face = samples_[i].point.face;
        }
      }
    return face;
  }

  Vector point_of(const Triangle& t, const Vector& b) const
  {
    return b[0] * positions_[t[0]] + b[1] * positions_[t[1]] + b[2] * positions_[t[2]];
  }

  // Samples whose foot is inside the triangle are held across it, others across the way to their foot. How much a vertex is
  // held is told by those of the input: ways back from chords of sharp edges have directions of their own.
  void add_triangle(Index t, Fit_equations& equations, std::vector<Hold>& holds) const
  {
    const Triangle& corner = coarse_.triangles()[t];
    const Vector doubled = normal_of(positions_, corner);
    const double length = std::sqrt(dot(doubled, doubled)), tiny = 1e-9 * std::sqrt(length);
    const Vector normal = length > 0 ? (1 / length) * doubled : doubled;
    Eigen::Matrix3d inside = Eigen::Matrix3d::Zero();
    const auto add = [&](const Vector& b, const Vector& d, bool is_inside, double weight, bool holds_vertices) {
      const double distance = std::sqrt(dot(d, d));
      const Vector n = is_inside || !(distance > tiny) ? normal : (1 / distance) * d;
      const Eigen::Vector3d w(b[0], b[1], b[2]), e(n[0], n[1], n[2]);
      if (is_inside)
        inside += weight * w * w.transpose();
      else
        equations.add_stiffness(t, weight * w * w.transpose(), n, damping);
      for (std::size_t k = 0; k < 3; ++k) {
        equations.add_force(corner[k], d, weight * b[k]);
        Hold& hold = holds[corner[k]];
        hold.weight += weight * b[k];
        if (holds_vertices) {
          hold.squared_weight += weight * b[k] * b[k];
          hold.normals += weight * b[k] * b[k] * e * e.transpose();
        }
      }
    };
    for (const Index i : of_triangle_[t]) {
      const Sample& s = samples_[i];
      const Vector& b = s.foot.barycentric;
      add(b, s.point.position - point_of(corner, b), b[0] > 0 && b[1] > 0 && b[2] > 0, sample_weight_, true);
    }
    for (const Back_sample& s : back_[t])
      if (s.weight > 0)
        add(s.barycentric, s.foot - point_of(corner, s.barycentric), false, s.weight, false);
    equations.add_stiffness(t, inside, normal, damping);
  }

  // From a vertex to the mean of its neighbors, along the surface.
  Vector way_to_middle(Index v) const
  {
    Vector normal{{0, 0, 0}};
    for (const Index t : coarse_.around(v))
      normal = normal + normal_of(positions_, coarse_.triangles()[t]);
    const Vector d = coarse_.mean_of_neighbors(v, positions_) - positions_[v];
    const double square = dot(normal, normal);
    return square > 0 ? d - (dot(d, normal) / square) * normal : d;
  }

  // The part of `d` in the directions in which no sample holds a vertex.
  static Vector free_part(const Eigen::Matrix3d& normals, const Vector& d)
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normals);
    const double largest = solver.eigenvalues()[2];
    Vector part{{0, 0, 0}};
    if (!(largest > 0))
      return part;
    for (int i = 0; i < 3; ++i) {
      const double freedom = 1 - solver.eigenvalues()[i] / (free_part_below * largest);
      const Vector e{{solver.eigenvectors()(0, i), solver.eigenvectors()(1, i), solver.eigenvectors()(2, i)}};
      if (freedom > 0)
        part = part + (freedom * dot(d, e)) * e;
    }
    return part;
  }

  Input_surface input_;
  Execution execution_;
  const Border_arcs& border_;
  Flippable_triangulation& coarse_;
  std::vector<Vector>& positions_;
  Line_fits lines_;
  double area_ = 0, sample_weight_ = 0;
  std::vector<Sample> samples_;
  std::vector<std::vector<Index> > of_triangle_; // samples whose foot lies on each triangle
  std::vector<Back_samples> back_;               // samples of each triangle
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_SURFACE_FIT_H
