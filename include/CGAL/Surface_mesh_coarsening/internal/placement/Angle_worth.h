// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_ANGLE_WORTH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_ANGLE_WORTH_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// No flip, exchange or improvement creates a smaller angle, unless the affected triangles already have one.
constexpr double min_angle = 10 * CGAL_PI / 180;
// Triangles with a smaller angle are narrow.
constexpr double narrow_angle = 25 * CGAL_PI / 180;

// Returns the amount by which the smallest angle of a triangle falls below `narrow_angle`.
inline double narrowness(double angle) { return (std::max)(0., narrow_angle - angle); }

// The exchange rate between angles and distance: the squared distance that the smallest angle of a triangle is worth.
struct Angle_worth
{
  double rate = 0;        // per radian
  double narrow_rate = 0; // per radian of narrowness, in addition

  double operator()(double angle) const { return rate * angle - narrow_rate * narrowness(angle); }
};

// Returns the triangles with an angle below `min_angle`.
inline std::vector<std::size_t> narrowest_triangles(const std::vector<Vector>& positions, const std::vector<Triangle>& triangles)
{
  std::vector<std::size_t> narrowest;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (smallest_angle(positions, triangles[t]) < min_angle)
      narrowest.push_back(t);
  return narrowest;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_ANGLE_WORTH_H
