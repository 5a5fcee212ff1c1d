// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_TRIAL_FAN_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_TRIAL_FAN_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Prepared_triangle.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Angle_worth.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// A few triangles that would replace other triangles in a change, with their samples of the input. One of their vertices may
// move to the position closest to the samples.
class Trial_fan
{
public:
  // The cosine of the largest angle between the normals of a triangle before and after the change.
  static constexpr double max_turn = 0.2;

  void clear()
  {
    triangles_.clear();
    samples_.clear();
  }

  // `free_corner` is the corner of the vertex that may move. The triangle must not turn away from the normal `reference`.
  void add_triangle(const Vector& a, const Vector& b, const Vector& c, int free_corner, const Vector& reference)
  {
    triangles_.push_back({{{a, b, c}}, std::size_t(free_corner), reference, {}});
  }

  void add_sample(const Vector& p) { samples_.push_back(p); }

  void move_to(const Vector& p)
  {
    for (Local_triangle& t : triangles_) {
      t.corner[t.free_corner] = p;
      t.prepared = Prepared_triangle(t.corner[0], t.corner[1], t.corner[2]);
    }
  }

  // Returns whether all triangles are properly oriented, and no angle is smaller than the angle with cosine `max_cosine`.
  // `min_turn_cosine` is the cosine of the largest angle between the normals of a triangle before and after the change.
  bool is_sound(double max_cosine, double min_turn_cosine = max_turn) const
  {
    for (const Local_triangle& t : triangles_) {
      const Vector n = cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]);
      if (!(dot(n, t.reference) > min_turn_cosine * std::sqrt(dot(n, n) * dot(t.reference, t.reference))) ||
          sharpest(t) > max_cosine)
        return false;
    }
    return true;
  }

  // Returns the sum of the worths of the smallest angles.
  double worth(const Angle_worth& worth) const
  {
    double sum = 0;
    for (const Local_triangle& t : triangles_)
      sum += worth(std::acos((std::min)(1., sharpest(t))));
    return sum;
  }

  // Returns the sum of the squared distances of the samples. `better` receives the best position of the free vertex, which is at
  // `p`, as estimated from the closest points.
  double squared_distances(const Vector& p, Vector& better) const
  {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double sum = 0, weight = 0;
    std::size_t nearest = 0;
    for (const Vector& s : samples_) {
      const Foot_point foot = closest(s, nearest);
      sum += foot.squared_distance;
      add_equation(s, foot, triangles_[nearest], matrix, right, weight);
    }
    better = p;
    if (weight > 0) {
      matrix.diagonal().array() += min_inertia * weight;
      const Eigen::Vector3d x = matrix.inverse() * right;
      if (x.allFinite())
        better = p + Vector{{x[0], x[1], x[2]}};
    }
    return sum;
  }

  // Returns the sum of the squared distances of the samples, or infinity if it is larger than `limit`.
  double squared_distances(double limit) const
  {
    double sum = 0;
    std::size_t nearest = 0;
    for (const Vector& s : samples_) {
      sum += closest(s, nearest).squared_distance;
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

  static double sharpest(const Local_triangle& t)
  {
    double largest = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector e = t.corner[(i + 1) % 3] - t.corner[i], f = t.corner[(i + 2) % 3] - t.corner[i];
      const double product = std::sqrt(dot(e, e) * dot(f, f));
      largest = (std::max)(largest, product > 0 ? dot(e, f) / product : 1);
    }
    return largest;
  }

  // Begins with the triangle that was nearest to the previous sample.
  Foot_point closest(const Vector& s, std::size_t& nearest) const
  {
    Foot_point best = triangles_[nearest].prepared.closest(s);
    const std::size_t first = nearest;
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      if (i != first && triangles_[i].prepared.improve(s, best))
        nearest = i;
    return best;
  }

  static void add_equation(const Vector& s, const Foot_point& foot, const Local_triangle& t, Eigen::Matrix3d& matrix,
                           Eigen::Vector3d& right, double& weight)
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
    const Eigen::Vector3d e(n[0], n[1], n[2]);
    matrix += part * part * ((1 - damping) * e * e.transpose() + damping * Eigen::Matrix3d::Identity());
    right += part * Eigen::Vector3d(d[0], d[1], d[2]);
    weight += part * part;
  }

  std::vector<Local_triangle> triangles_;
  std::vector<Vector> samples_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_TRIAL_FAN_H
