// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_NUMBER_TABLE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_NUMBER_TABLE_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Index.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Assigns consecutive indices to 64-bit numbers, from 0, in the order of their first occurrence. The table uses open addressing;
// the maps of the standard library take several times the memory and the time.
class Number_table
{
public:
  Index index(std::uint64_t number)
  {
    if (2 * numbers_.size() >= slots_.size())
      grow();
    const std::size_t slot = find(number);
    if (slots_[slot] == NONE) {
      slots_[slot] = Index(numbers_.size());
      numbers_.push_back(number);
    }
    return slots_[slot];
  }

  // The numbers in the order of their indices.
  const std::vector<std::uint64_t>& numbers() const { return numbers_; }

private:
  std::size_t find(std::uint64_t number) const
  {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = std::size_t((number * 0x9e3779b97f4a7c15u) >> 32) & mask;
    while (slots_[slot] != NONE && numbers_[slots_[slot]] != number)
      slot = (slot + 1) & mask;
    return slot;
  }

  void grow()
  {
    slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), NONE);
    for (std::size_t i = 0; i < numbers_.size(); ++i)
      slots_[find(numbers_[i])] = Index(i);
  }

  std::vector<Index> slots_;
  std::vector<std::uint64_t> numbers_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_NUMBER_TABLE_H
