// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_BOX_HIERARCHY_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_BOX_HIERARCHY_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/divide_boxes.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

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
    nodes_.assign(2 * boxes_.size() + 1, Bbox_3());
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
      if (last - first == 1)
        return;
      const std::size_t middle = middle_of(first, last);
      const bool is_left = place_of_[box] < middle;
      node = is_left ? node + 1 : node + 2 * (middle - first);
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
  static std::size_t middle_of(std::size_t first, std::size_t last) { return first + (last - first) / 2; }

  // The left child of a node is the next node. The right child follows all descendants of the left child.
  void build(std::size_t node, std::size_t first, std::size_t last)
  {
    for (std::size_t i = first; i < last; ++i)
      nodes_[node] += boxes_[order_[i]];
    if (last - first == 1)
      return;
    const std::size_t middle = divide_boxes(boxes_, nodes_[node], order_, first, last);
    build(node + 1, first, middle);
    build(node + 2 * (middle - first), middle, last);
  }

  template <class Visit>
  void search(const Bbox_3& region, const Visit& visit, std::size_t node, std::size_t first, std::size_t last) const
  {
    if (!do_overlap(region, nodes_[node]))
      return;
    if (last - first == 1) {
      visit(order_[first]);
      return;
    }
    const std::size_t middle = middle_of(first, last);
    search(region, visit, node + 1, first, middle);
    search(region, visit, node + 2 * (middle - first), middle, last);
  }

  std::vector<Bbox_3> boxes_, nodes_;
  std::vector<Index> order_;          // of the boxes, as leaves
  std::vector<std::size_t> place_of_; // of each box in that order
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_BOX_HIERARCHY_H
