// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_BOXES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_BOXES_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

inline Bbox_3 box_of_point(const Vector& p) { return Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]); }

inline Vector low_corner(const Bbox_3& box) { return {{box.xmin(), box.ymin(), box.zmin()}}; }
inline Vector high_corner(const Bbox_3& box) { return {{box.xmax(), box.ymax(), box.zmax()}}; }

inline double squared_diagonal(const Bbox_3& box)
{
  const Vector d = high_corner(box) - low_corner(box);
  return dot(d, d);
}

// Returns zero for points inside the box.
inline double squared_distance_from_box(const Vector& p, const Bbox_3& box)
{
  const Vector low = low_corner(box), high = high_corner(box);
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double d = (std::max)((std::max)(low[i] - p[i], p[i] - high[i]), 0.);
    sum += d * d;
  }
  return sum;
}

inline bool is_in_box(const Vector& p, const Bbox_3& box) { return squared_distance_from_box(p, box) == 0; }

inline Vector closest_in_box(const Vector& p, const Bbox_3& box)
{
  const Vector low = low_corner(box), high = high_corner(box);
  Vector result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = (std::min)((std::max)(p[i], low[i]), high[i]);
  return result;
}

// Returns the box with all sides moved outwards by `width`.
inline Bbox_3 grown(const Bbox_3& box, double width)
{
  return Bbox_3(box.xmin() - width, box.ymin() - width, box.zmin() - width, box.xmax() + width, box.ymax() + width,
                box.zmax() + width);
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_BOXES_H
