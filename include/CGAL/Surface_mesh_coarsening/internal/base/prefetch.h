// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_PREFETCH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_PREFETCH_H

#include <boost/config.hpp>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Prefetches memory. On a large mesh, faces along cluster boundaries lie far apart in memory; loops that prefetch
// several of them before reading the first wait once for all.
//
// Inlining is forced because g++ drops calls of functions without side effects.
BOOST_FORCEINLINE void prefetch(const void* address)
{
#ifdef __GNUC__
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_PREFETCH_H
