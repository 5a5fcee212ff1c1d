// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_BOX_LIST_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_BOX_LIST_H

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Boxes, each of which may change. One box is compared with all of them, coordinate by coordinate, so that compilers vectorize
// the comparisons. For a few hundred boxes this takes less time than a tree.
class Box_list
{
public:
  void resize(std::size_t number)
  {
    for (std::vector<double>& side : sides_)
      side.resize(number);
  }

  void set(std::size_t i, const Bbox_3& box)
  {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sides_[axis][i] = (box.min)(int(axis));
      sides_[3 + axis][i] = (box.max)(int(axis));
    }
  }

  // Calls `visit` with the numbers of the boxes that overlap `box`, in order.
  template <class Visit>
  void for_each_overlapping(const Bbox_3& box, const Visit& visit) const
  {
    constexpr std::size_t at_a_time = 64;
    std::array<char, at_a_time> overlaps;
    for (std::size_t first = 0; first < sides_[0].size(); first += at_a_time) {
      const std::size_t number = (std::min)(at_a_time, sides_[0].size() - first);
      compare(box, first, number, overlaps.data());
      for (std::size_t i = 0; i < number; ++i)
        if (overlaps[i])
          visit(first + i);
    }
  }

private:
  void compare(const Bbox_3& box, std::size_t first, std::size_t number, char* overlaps) const
  {
    const double *x = sides_[0].data() + first, *y = sides_[1].data() + first, *z = sides_[2].data() + first,
                 *to_x = sides_[3].data() + first, *to_y = sides_[4].data() + first, *to_z = sides_[5].data() + first;
    for (std::size_t i = 0; i < number; ++i)
      overlaps[i] = char(int(x[i] <= box.xmax()) & int(y[i] <= box.ymax()) & int(z[i] <= box.zmax()) &
                         int(to_x[i] >= box.xmin()) & int(to_y[i] >= box.ymin()) & int(to_z[i] >= box.zmin()));
  }

  std::array<std::vector<double>, 6> sides_; // the smallest and the largest coordinates
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_BOX_LIST_H
