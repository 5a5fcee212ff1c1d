// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_BUCKETED_ITEMS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_BUCKETED_ITEMS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Visitor_handle.h>

#include <CGAL/Iterator_range.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Returns the numbers below `n`.
template <class Number>
Iterator_range<boost::counting_iterator<Number> > numbers_below(Number n)
{
  return {boost::counting_iterator<Number>(0), boost::counting_iterator<Number>(n)};
}

// The items of several groups in two arrays, group by group. Items keep their order within a group. The construction takes linear
// time. Boost has such a structure only inside its compressed_sparse_row_graph, which sorts edges and cannot be cancelled.
template <class Item>
class Bucketed_items
{
public:
  typedef Iterator_range<const Item*> Range;

  // Omits items for which `group_of()` is not below the number of groups.
  template <class Items, class Group_of>
  Bucketed_items(const Items& items, std::size_t groups, const Group_of& group_of,
                 const Cancellation_point& cancellation = Cancellation_point())
    : first_(groups + 1, 0)
  {
    for (const Item& item : items)
      if (const std::size_t x = group_of(item); x < groups)
        ++first_[x + 1];
    for (std::size_t x = 0; x < groups; ++x)
      first_[x + 1] += first_[x];
    items_.resize(first_.back());
    std::vector<std::size_t> at(first_.begin(), first_.end() - 1);
    for (const Item& item : items) {
      cancellation.poll();
      if (const std::size_t x = group_of(item); x < groups)
        items_[at[x]++] = item;
    }
  }

  std::size_t size() const { return first_.size() - 1; }
  Range operator[](std::size_t group) const
  {
    return {items_.data() + first_[group], items_.data() + first_[group + 1]};
  }

  const std::vector<Item>& items() const { return items_; }

  // Sorts the items of each group.
  template <class Less>
  void sort_groups(const Less& less)
  {
    for (std::size_t x = 0; x < size(); ++x)
      std::sort(items_.data() + first_[x], items_.data() + first_[x + 1], less);
  }

private:
  std::vector<std::size_t> first_; // first item of each group
  std::vector<Item> items_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_BUCKETED_ITEMS_H
