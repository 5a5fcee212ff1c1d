// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_ROUNDING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_ROUNDING_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// These functions map values that differ only by rounding errors to equal values, for example in programs with and without fused
// operations. Exceptions are the rare values halfway between two results.

// Rounds to a multiple of the last of the first `digits` binary digits of `largest`.
inline double rounded_like(double x, double largest, int digits)
{
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(x, digits - exponent)), exponent - digits) + 0.; // no negative zero
}

// Rounds a sum so coarsely that only noticeable differences count.
//! [comparison]
inline double rounded_for_comparison(double sum) { return rounded_like(sum, sum, 16); }
//! [comparison]

// Rounds the coordinates of a computed position to 43 binary digits relative to the largest coordinate. Otherwise exact
// intersection tests would detect rounding errors where triangles just touch, as on symmetric meshes.
inline Vector without_last_digits(const Vector& p)
{
  const double largest = (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  if (!(largest > 0) || !std::isfinite(largest))
    return p;
  //! [digits]
  return {{rounded_like(p[0], largest, 43), rounded_like(p[1], largest, 43), rounded_like(p[2], largest, 43)}};
  //! [digits]
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_ROUNDING_H
