// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_ROUNDING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_ROUNDING_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// What differs by roundings alone, as of programs with fused operations and without, becomes the same, but for the rare values
// in the middle between two.

// Rounds to a multiple of what the last of the first `digits` binary digits of `largest` stands for.
inline double rounded_like(double x, double largest, int digits)
{
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(x, digits - exponent)), exponent - digits) + 0.; // no negative zero
}

// A sum, rounded so far that only sums which differ noticeably are compared as different.
inline double rounded_for_comparison(double sum) { return rounded_like(sum, sum, 16); }

// A computed position, whose coordinates are rounded to 43 binary digits of the largest. Exact tests of whether triangles
// intersect would tell the differences apart where these just touch, as on symmetric meshes.
inline Vector without_last_digits(const Vector& p)
{
  const double largest = (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  if (!(largest > 0) || !std::isfinite(largest))
    return p;
  return {{rounded_like(p[0], largest, 43), rounded_like(p[1], largest, 43), rounded_like(p[2], largest, 43)}};
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_ROUNDING_H
