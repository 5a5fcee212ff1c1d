// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BOUNDING_BOX_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BOUNDING_BOX_H

#include <CGAL/Surface_mesh_coarsening/internal/Flat_mesh.h>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Of points that are added one by one.
struct Bounding_box
{
  Vector low{{infinity(), infinity(), infinity()}}, high{{-infinity(), -infinity(), -infinity()}};

  static double infinity() { return (std::numeric_limits<double>::infinity)(); }
  void add(const Vector& p)
  {
    for (int i = 0; i < 3; ++i) {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
  }
  bool overlaps(const Bounding_box& other) const
  {
    for (int i = 0; i < 3; ++i)
      if (low[i] > other.high[i] || other.low[i] > high[i])
        return false;
    return true;
  }
  double squared_distance(const Vector& p) const
  {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const double d = (std::max)((std::max)(low[i] - p[i], p[i] - high[i]), 0.);
      sum += d * d;
    }
    return sum;
  }
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_BOUNDING_BOX_H
