// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_CONTAINERS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_CONTAINERS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>

#include <CGAL/Iterator_range.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/type_traits/has_less.hpp>

#include <algorithm>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

typedef Iterator_range<boost::counting_iterator<Index> > Number_range;

// Returns the numbers from `begin` to `end`, without `end`.
inline Number_range number_range(Index begin, Index end)
{
  return {boost::counting_iterator<Index>(begin), boost::counting_iterator<Index>(end)};
}

inline Number_range numbers_below(Index n) { return number_range(0, n); }

template <class Value>
void sort_unique(std::vector<Value>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

// Sorts values that mostly consist of a few sorted runs one after the other. Merging these is several times as fast as
// `std::sort`. No two values are equal.
template <class T, class Less>
void sort_runs(std::vector<T>& values, const Less& less)
{
  constexpr std::size_t min_mean_run = 64;
  std::vector<std::size_t> ends(1, 0);
  for (std::size_t i = 1; i <= values.size(); ++i)
    if (i == values.size() || less(values[i], values[i - 1]))
      ends.push_back(i);
  if (ends.size() > 2 + values.size() / min_mean_run) {
    std::sort(values.begin(), values.end(), less);
    return;
  }
  const auto at = [&](std::size_t run) { return values.begin() + std::ptrdiff_t(ends[run]); };
  while (ends.size() > 2) {
    std::vector<std::size_t> merged(1, 0);
    for (std::size_t run = 0; run + 1 < ends.size(); run += 2) {
      const std::size_t next = (std::min)(run + 2, ends.size() - 1);
      std::inplace_merge(at(run), at(run + 1), at(next), less);
      merged.push_back(ends[next]);
    }
    ends.swap(merged);
  }
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
  Bucketed_items(const Items& items, std::size_t groups, const Group_of& group_of, const Run_context& context = Run_context())
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
      context.poll();
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

private:
  std::vector<std::size_t> first_; // first item of each group
  std::vector<Item> items_;
};

// Sums areas for each value.
template <class Value>
class Majority
{
public:
  void add(double area, const Value& value)
  {
    if constexpr (is_ordered) {
      areas_[value] += area;
    } else {
      const auto i = std::find_if(areas_.begin(), areas_.end(), [&](const auto& x) { return x.first == value; });
      if (i == areas_.end())
        areas_.emplace_back(value, area);
      else
        i->second += area;
    }
  }
  bool empty() const { return areas_.empty(); }

  // Returns the value of largest area. Of several, returns the smallest if values are ordered, otherwise the first.
  const Value& value() const
  {
    const auto is_smaller = [](const auto& a, const auto& b) { return a.second < b.second; };
    return std::max_element(areas_.begin(), areas_.end(), is_smaller)->first;
  }

private:
  static constexpr bool is_ordered = boost::has_less<const Value&>::value;
  std::conditional_t<is_ordered, std::map<Value, double>, std::vector<std::pair<Value, double> > > areas_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_CONTAINERS_H
