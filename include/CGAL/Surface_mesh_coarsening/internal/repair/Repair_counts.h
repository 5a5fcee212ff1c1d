// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_REPAIR_COUNTS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_REPAIR_COUNTS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The numbers of faults before and after a repair.
struct Repair_counts
{
  std::size_t intersections_found = 0, reversals_found = 0, reversals_left = 0;
  std::vector<std::pair<Index, Index> > intersections_left; // pairs of triangles
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_REPAIR_COUNTS_H
