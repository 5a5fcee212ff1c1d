// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_TRIAL_FAN_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_TRIAL_FAN_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Prepared_triangle.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Fit_equations.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// No flip, exchange or improvement creates a smaller angle, unless the affected triangles already have one or are unfolded.
constexpr double min_angle = 10 * CGAL_PI / 180;
// Triangles with a smaller angle are narrow.
constexpr double narrow_angle = 25 * CGAL_PI / 180;

// Below this angle, narrowness grows faster, so that two narrow triangles are better than a degenerate one beside a good one. On
// planar faces no distance would decide between them.
constexpr double degenerate_angle = 3 * CGAL_PI / 180;

// Returns the amount by which the smallest angle of a triangle falls below `narrow_angle`; more for degenerate triangles.
inline double narrowness(double angle)
{
  constexpr double factor = 10;
  return (std::max)(0., narrow_angle - angle) + factor * (std::max)(0., degenerate_angle - angle);
}

// The exchange rate between angles and distance: the squared distance that the smallest angle of a triangle is worth.
struct Angle_worth
{
  double rate = 0;        // per radian
  double narrow_rate = 0; // per radian of narrowness, in addition

  double operator()(double angle) const { return rate * angle - narrow_rate * narrowness(angle); }
};

// The worth of one radian of narrowness, relative to the mean cost of a triangle.
constexpr double narrow_part = 2;

// Returns the triangles with an angle below `min_angle`.
inline std::vector<std::size_t> narrowest_triangles(const std::vector<Vector>& positions, const std::vector<Triangle>& triangles)
{
  std::vector<std::size_t> narrowest;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (smallest_angle(positions, triangles[t]) < min_angle)
      narrowest.push_back(t);
  return narrowest;
}

// A few triangles that would replace other triangles in a change, with their samples of the input. One of their vertices may
// move to the position closest to the samples.
class Trial_fan
{
public:
  // The cosine of the largest angle between the normals of a triangle before and after the change.
  static constexpr double max_turn = 0.2;

  // `free_corner` is the corner of the vertex that may move. The triangle must not turn away from the normal `reference`.
  void add_triangle(const Vector& a, const Vector& b, const Vector& c, int free_corner, const Vector& reference)
  {
    triangles_.push_back({{{a, b, c}}, std::size_t(free_corner), reference, {}});
    is_prepared_ = false;
  }

  // The search for the closest point begins on the triangle that was added last.
  void add_sample(const Vector& p) { samples_.push_back({p, triangles_.empty() ? 0 : triangles_.size() - 1}); }

  void move_to(const Vector& p)
  {
    for (Local_triangle& t : triangles_)
      t.corner[t.free_corner] = p;
    is_prepared_ = false;
  }

  // Returns whether all triangles are properly oriented, and no angle is smaller than the angle with cosine `max_cosine`.
  // `min_turn_cosine` is the cosine of the largest angle between the normals of a triangle before and after the change.
  bool is_sound(double max_cosine, double min_turn_cosine = max_turn) const
  {
    for (const Local_triangle& t : triangles_) {
      const Vector n = cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]);
      if (!(dot(n, t.reference) > min_turn_cosine * std::sqrt(dot(n, n) * dot(t.reference, t.reference))) ||
          sharpest_of(t.corner) > max_cosine)
        return false;
    }
    return true;
  }

  // Returns the sum of the worths of the smallest angles.
  double worth(const Angle_worth& worth) const
  {
    double sum = 0;
    for (const Local_triangle& t : triangles_)
      sum += worth(std::acos((std::min)(1., sharpest_of(t.corner))));
    return sum;
  }

  // Returns the sum of the squared distances of the samples. `better` receives the best position of the free vertex, which is at
  // `p`, as estimated from the closest points.
  double squared_distances(const Vector& p, Vector& better)
  {
    prepare();
    Equation equation;
    double sum = 0;
    for (Sample& s : samples_) {
      const Foot_point foot = closest(s);
      sum += foot.squared_distance;
      add_to(equation, s.position, foot, triangles_[s.triangle]);
    }
    better = p;
    if (equation.weight > 0) {
      equation.matrix.add(min_inertia * equation.weight, Symmetric_block::identity());
      const Vector& right = equation.right;
      const Eigen::Vector3d x = equation.matrix.matrix().inverse() * Eigen::Vector3d(right[0], right[1], right[2]);
      if (x.allFinite())
        better = p + Vector{{x[0], x[1], x[2]}};
    }
    return sum;
  }

  // Returns the sum of the squared distances of the samples, or infinity if it is larger than `limit`.
  double squared_distances(double limit)
  {
    prepare();
    double sum = 0;
    for (Sample& s : samples_) {
      sum += closest(s).squared_distance;
      if (sum > limit)
        return std::numeric_limits<double>::infinity();
    }
    return sum;
  }

private:
  // The weights of tangential movements and of all movements, as in the fit.
  static constexpr double damping = 0.02, min_inertia = 0.001;

  struct Local_triangle
  {
    std::array<Vector, 3> corner;
    std::size_t free_corner;
    Vector reference;
    Prepared_triangle prepared;
  };

  struct Sample
  {
    Vector position;
    std::size_t triangle; // the nearest one in the previous search
  };

  // The linear equation for the movement of the free vertex.
  struct Equation
  {
    Symmetric_block matrix;
    Vector right{{0, 0, 0}};
    double weight = 0;
  };

  void prepare()
  {
    if (is_prepared_)
      return;
    for (Local_triangle& t : triangles_)
      t.prepared = Prepared_triangle(t.corner[0], t.corner[1], t.corner[2]);
    is_prepared_ = true;
  }

  // Begins with the triangle that was nearest in the previous search.
  Foot_point closest(Sample& s) const
  {
    const std::size_t first = s.triangle;
    Foot_point best = triangles_[first].prepared.closest(s.position);
    if (triangles_[first].prepared.is_far_from_sides(best))
      return best;
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      if (i != first && triangles_[i].prepared.improve(s.position, best))
        s.triangle = i;
    return best;
  }

  static void add_to(Equation& equation, const Vector& s, const Foot_point& foot, const Local_triangle& t)
  {
    const Vector& b = foot.barycentric;
    const double part = b[t.free_corner];
    if (!(part > 0))
      return;
    const Vector d = s - (b[0] * t.corner[0] + b[1] * t.corner[1] + b[2] * t.corner[2]);
    const bool is_inside = b[0] > 0 && b[1] > 0 && b[2] > 0;
    Vector n = t.prepared.normal();
    if (!is_inside) {
      const double length = std::sqrt(dot(d, d));
      n = length > 0 ? (1 / length) * d : d;
    }
    equation.matrix.add(part * part, Symmetric_block::metric(n, damping));
    equation.right = equation.right + part * d;
    equation.weight += part * part;
  }

  std::vector<Local_triangle> triangles_;
  std::vector<Sample> samples_;
  bool is_prepared_ = false;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_TRIAL_FAN_H
