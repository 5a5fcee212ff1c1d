// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_SORT_UNIQUE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_SORT_UNIQUE_H

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

template <class Value>
void sort_unique(std::vector<Value>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_SORT_UNIQUE_H
