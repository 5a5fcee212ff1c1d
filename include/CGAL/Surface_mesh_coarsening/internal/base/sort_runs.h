// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_SORT_RUNS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_SORT_RUNS_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

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

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_SORT_RUNS_H
