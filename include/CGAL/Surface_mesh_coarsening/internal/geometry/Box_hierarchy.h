// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_BOX_HIERARCHY_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_BOX_HIERARCHY_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

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

// Finds the boxes that overlap a given box, in logarithmic time if they are few. Boxes may grow, which the trees of CGAL do not
// support.
class Box_hierarchy
{
public:
  void build(std::vector<Bbox_3> boxes)
  {
    boxes_ = std::move(boxes);
    order_.resize(boxes_.size());
    place_of_.resize(boxes_.size());
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      order_[i] = Index(i);
    nodes_.assign(4 * boxes_.size() / max_boxes + 1, Bbox_3());
    if (!boxes_.empty())
      build(0, 0, boxes_.size());
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      place_of_[order_[i]] = i;
  }

  // Grows a box by another one.
  void grow(Index box, const Bbox_3& by)
  {
    boxes_[box] += by;
    for (std::size_t node = 0, first = 0, last = boxes_.size();;) {
      nodes_[node] += by;
      if (last - first <= max_boxes)
        return;
      const std::size_t middle = middle_of(first, last);
      const bool is_left = place_of_[box] < middle;
      node = 2 * node + (is_left ? 1 : 2);
      (is_left ? last : first) = middle;
    }
  }

  // Calls `visit` with the numbers of the boxes that overlap `region`.
  template <class Visit>
  void for_each_overlapping(const Bbox_3& region, const Visit& visit) const
  {
    if (!boxes_.empty())
      search(region, visit, 0, 0, boxes_.size());
  }

private:
  static constexpr std::size_t max_boxes = 16; // of a leaf; comparing them one by one takes less time than dividing them

  static std::size_t middle_of(std::size_t first, std::size_t last) { return first + (last - first) / 2; }

  // The children of node i are the nodes 2 i + 1 and 2 i + 2.
  void build(std::size_t node, std::size_t first, std::size_t last)
  {
    for (std::size_t i = first; i < last; ++i)
      nodes_[node] += boxes_[order_[i]];
    if (last - first <= max_boxes)
      return;
    const std::size_t middle = divide_boxes(boxes_, nodes_[node], order_, first, last);
    build(2 * node + 1, first, middle);
    build(2 * node + 2, middle, last);
  }

  template <class Visit>
  void search(const Bbox_3& region, const Visit& visit, std::size_t node, std::size_t first, std::size_t last) const
  {
    if (!do_overlap(region, nodes_[node]))
      return;
    if (last - first <= max_boxes) {
      for (std::size_t i = first; i < last; ++i)
        if (do_overlap(region, boxes_[order_[i]]))
          visit(order_[i]);
      return;
    }
    const std::size_t middle = middle_of(first, last);
    search(region, visit, 2 * node + 1, first, middle);
    search(region, visit, 2 * node + 2, middle, last);
  }

  std::vector<Bbox_3> boxes_, nodes_;
  std::vector<Index> order_;          // of the boxes, in the leaves
  std::vector<std::size_t> place_of_; // of each box in that order
};

// Boxes, each of which may change. One box is compared with all of them, coordinate by coordinate, by sums: compilers vectorize
// these, but not comparisons. For a few hundred boxes this takes less time than a tree.
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
    for (std::size_t k = 0; k < 6; ++k)
      sides_[k][i] = outward_sides(box)[k];
  }

  // Calls `visit` with the numbers of the boxes that overlap `box`, in order.
  template <class Visit>
  void for_each_overlapping(const Bbox_3& box, const Visit& visit) const
  {
    constexpr std::size_t at_a_time = 64;
    const std::array<double, 6> other = outward_sides(box);
    std::array<double, at_a_time> gaps; // the largest of those along the axes; not positive if boxes overlap
    for (std::size_t first = 0; first < sides_[0].size(); first += at_a_time) {
      const std::size_t number = (std::min)(at_a_time, sides_[0].size() - first);
      gaps.fill(-std::numeric_limits<double>::infinity());
      for (std::size_t k = 0; k < 6; ++k)
        for (std::size_t i = 0; i < number; ++i)
          gaps[i] = (std::max)(gaps[i], sides_[k][first + i] + other[(k + 3) % 6]);
      for (std::size_t i = 0; i < number; ++i)
        if (gaps[i] <= 0)
          visit(first + i);
    }
  }

private:
  // The smallest coordinates and the negative largest coordinates. The gap between two boxes along an axis is the sum of a number
  // of one box and the opposite number of the other.
  static std::array<double, 6> outward_sides(const Bbox_3& box)
  {
    return {{box.xmin(), box.ymin(), box.zmin(), -box.xmax(), -box.ymax(), -box.zmax()}};
  }

  std::array<std::vector<double>, 6> sides_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_BOX_HIERARCHY_H
