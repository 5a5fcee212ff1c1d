// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_WITHOUT_LAST_DIGITS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_WITHOUT_LAST_DIGITS_H

#include <CGAL/Surface_mesh_coarsening/internal/Flat_mesh.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Rounds the coordinates of a computed position to 43 binary digits of the largest. What differs by roundings alone, as of
// programs with fused operations and without, becomes the same: exact tests of whether triangles intersect would tell it apart
// where these just touch, as on symmetric meshes.
inline Vector without_last_digits(const Vector& p)
{
  const double largest = (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  if (!(largest > 0) || !std::isfinite(largest))
    return p;
  int exponent = 0;
  std::frexp(largest, &exponent);
  const int digits = 43 - exponent;
  Vector rounded;
  for (int k = 0; k < 3; ++k)
    rounded[k] = std::ldexp(std::nearbyint(std::ldexp(p[k], digits)), -digits) + 0.; // no negative zero
  return rounded;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_WITHOUT_LAST_DIGITS_H
