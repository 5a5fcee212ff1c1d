// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_MORTON_CURVE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_MORTON_CURVE_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The position of a point on the Morton curve, whose binary digits are the digits of the three coordinates in turn.
class Morton_curve
{
public:
  static constexpr int bits = 20; // of each coordinate

  // For points of a box.
  Morton_curve(const Vector& low, const Vector& high) : low_(low)
  {
    double extent = 0;
    for (std::size_t i = 0; i < 3; ++i)
      extent = (std::max)(extent, high[i] - low[i]);
    scale_ = extent > 0 ? double(std::uint64_t(1) << bits) / extent : 0;
  }

  std::uint64_t operator()(const Vector& p) const
  {
    std::uint64_t place = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      constexpr double last = double((std::uint64_t(1) << bits) - 1);
      const std::uint64_t x = std::uint64_t((std::min)((std::max)(scale_ * (p[i] - low_[i]), 0.), last));
      place |= spread(x) << i;
    }
    return place;
  }

private:
  // Moves bit b to 3 b, by halves, quarters and so on.
  static std::uint64_t spread(std::uint64_t x)
  {
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
  }

  Vector low_;
  double scale_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_MORTON_CURVE_H
