// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_INDEX_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_INDEX_H

#include <cstdint>
#include <limits>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The number of a face, corner, vertex or cluster in the arrays.
typedef std::uint32_t Index;

constexpr Index NONE = (std::numeric_limits<Index>::max)();

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_INDEX_H
