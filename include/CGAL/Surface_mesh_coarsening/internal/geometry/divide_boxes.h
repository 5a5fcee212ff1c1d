// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_DIVIDE_BOXES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_DIVIDE_BOXES_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Twice the coordinate of the center of a box.
inline double doubled_center(const Bbox_3& box, int axis) { return (box.min)(axis) + (box.max)(axis); }

// Reorders the numbers of some boxes such that the centers of the first half precede the centers of the second half along the
// longest side of `extent`. Numbers decide between equal centers. Returns the beginning of the second half.
inline std::size_t divide_boxes(const std::vector<Bbox_3>& boxes, const Bbox_3& extent, std::vector<Index>& numbers,
                                std::size_t begin, std::size_t end)
{
  const double spans[3] = {extent.x_span(), extent.y_span(), extent.z_span()};
  const int axis = int(std::max_element(spans, spans + 3) - spans);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return numbers.begin() + std::ptrdiff_t(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](Index i, Index j) {
    const double a = doubled_center(boxes[i], axis), b = doubled_center(boxes[j], axis);
    return a < b || (a == b && i < j);
  });
  return middle;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_DIVIDE_BOXES_H
