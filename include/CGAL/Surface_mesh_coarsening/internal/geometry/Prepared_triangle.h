// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_PREPARED_TRIANGLE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_PREPARED_TRIANGLE_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Surface_mesh_coarsening::internal {

// A triangle with precomputed gradients of the barycentric coordinates, for closest points to many points.
class Prepared_triangle
{
public:
  Prepared_triangle() {}
  Prepared_triangle(const Vector& a, const Vector& b, const Vector& c) : corners_{{a, b, c}}
  {
    const Vector ab = b - a, ac = c - a, n = cross(ab, ac);
    const double square = dot(n, n), longest = (std::max)(dot(ab, ab), dot(ac, ac)), least = flat * longest * longest;
    if (!(square > (std::max)(least, tiny))) {
      if (least > tiny)
        find_longest_side();
      return;
    }
    normal_ = (1 / std::sqrt(square)) * n;
    gradients_[0] = (1 / square) * cross(ac, n);
    gradients_[1] = (1 / square) * cross(n, ab);
    const Vector first = gradients_[0] + gradients_[1];
    heights_ = {{1 / std::sqrt(dot(first, first)), 1 / std::sqrt(dot(gradients_[0], gradients_[0])),
                 1 / std::sqrt(dot(gradients_[1], gradients_[1]))}};
    is_flat_ = false;
  }
  Prepared_triangle(const std::vector<Vector>& positions, const Triangle& t)
    : Prepared_triangle(positions[t[0]], positions[t[1]], positions[t[2]]) {}

  Foot_point closest(const Vector& p) const
  {
    if (is_flat_)
      return closest_on_flat(p);
    const Vector d = p - corners_[0];
    return closest(p, dot(normal_, d), dot(gradients_[0], d), dot(gradients_[1], d));
  }

  // Replaces `best` by the closest point if it is nearer. Returns whether it is. The planes of the triangle, and the planes
  // through its sides orthogonal to it, bound the distance from below.
  bool improve(const Vector& p, Foot_point& best) const
  {
    Foot_point foot;
    if (is_flat_) {
      foot = closest_on_flat(p);
    } else {
      const Vector d = p - corners_[0];
      const double across = dot(normal_, d), v = dot(gradients_[0], d), w = dot(gradients_[1], d);
      const double beside =
        (std::max)((std::max)(-v * heights_[1], -w * heights_[2]), (std::max)((v + w - 1) * heights_[0], 0.));
      if (!(across * across + beside * beside < best.squared_distance))
        return false;
      foot = closest(p, across, v, w);
    }
    if (!(foot.squared_distance < best.squared_distance))
      return false;
    best = foot;
    return true;
  }

  // Returns whether the sides are at least as far from the closest point as the point itself is. Then a triangle beyond a side is
  // not nearer, unless it folds back over this triangle by more than a right angle.
  bool is_far_from_sides(const Foot_point& foot) const
  {
    if (is_flat_)
      return false;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i)
      nearest = (std::min)(nearest, foot.barycentric[i] * heights_[i]);
    return nearest > 0 && nearest * nearest >= foot.squared_distance;
  }

  // The unit normal; zero for a triangle of almost no area.
  const Vector& normal() const { return normal_; }

private:
  // The square of the height of a triangle with longest side 1, below which rounding errors are too large.
  static constexpr double flat = 1e-20;
  // A square of this size has no finite reciprocal, or is inexact. A vertex far from all others makes such triangles.
  static constexpr double tiny = std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();

  void find_longest_side()
  {
    double longest = -1;
    for (int i = 0; i < 3; ++i) {
      const Vector side = corners_[std::size_t((i + 1) % 3)] - corners_[std::size_t(i)];
      if (dot(side, side) > longest) {
        longest = dot(side, side);
        longest_side_ = i;
      }
    }
  }

  Foot_point closest_on_flat(const Vector& p) const
  {
    if (longest_side_ < 0)
      return closest_on_triangle(p, corners_[0], corners_[1], corners_[2]);
    const std::size_t i = std::size_t(longest_side_), j = (i + 1) % 3;
    Foot_point best{{{1, 0, 0}}, -1};
    improve_on_side(p - corners_[i], corners_[j] - corners_[i], i, j, best);
    return best;
  }

  // `across` is the distance from the plane; `v` and `w` are the last two barycentric coordinates.
  Foot_point closest(const Vector& p, double across, double v, double w) const
  {
    const double u = 1 - v - w;
    if (u >= 0 && v >= 0 && w >= 0)
      return {{{u, v, w}}, across * across};
    // The closest point lies on a side that separates the point from the triangle.
    Foot_point best{{{1, 0, 0}}, -1};
    if (u < 0)
      improve_on_side(p - corners_[1], corners_[2] - corners_[1], 1, 2, best);
    if (v < 0)
      improve_on_side(p - corners_[2], corners_[0] - corners_[2], 2, 0, best);
    if (w < 0)
      improve_on_side(p - corners_[0], corners_[1] - corners_[0], 0, 1, best);
    return best;
  }

  std::array<Vector, 3> corners_;
  std::array<Vector, 2> gradients_; // of the last two barycentric coordinates
  Vector normal_{{0, 0, 0}};
  std::array<double, 3> heights_;
  bool is_flat_ = true;
  int longest_side_ = -1; // of a flat triangle whose other sides lie on it but for rounding errors, from this corner to the next
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_PREPARED_TRIANGLE_H
