// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_MAJORITY_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_MAJORITY_H

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

template <class Value, class = void>
struct Is_ordered : std::false_type
{};
template <class Value>
struct Is_ordered<Value, std::void_t<decltype(std::declval<const Value&>() < std::declval<const Value&>())> >
  : std::true_type
{};

// Sums areas for each value.
template <class Value>
class Majority
{
public:
  void add(double area, const Value& value) { votes_.emplace_back(value, area); }
  bool empty() const { return votes_.empty(); }

  // Returns the value of largest area. Of several, returns the smallest if values are ordered, otherwise the first.
  Value value()
  {
    if constexpr (Is_ordered<Value>::value)
      std::stable_sort(votes_.begin(), votes_.end(), [](const Vote& a, const Vote& b) { return a.first < b.first; });
    std::size_t best = 0;
    double largest = -1;
    for (std::size_t i = 0; i < votes_.size();) {
      double area = 0;
      std::size_t j = i;
      if constexpr (Is_ordered<Value>::value) {
        for (; j < votes_.size() && !(votes_[i].first < votes_[j].first); ++j)
          area += votes_[j].second;
      } else {
        for (const Vote& vote : votes_)
          area += vote.first == votes_[i].first ? vote.second : 0;
        ++j;
      }
      if (area > largest) {
        largest = area;
        best = i;
      }
      i = j;
    }
    return votes_[best].first;
  }

private:
  typedef std::pair<Value, double> Vote;
  std::vector<Vote> votes_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_MAJORITY_H
