// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_PREFETCH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_PREFETCH_H

#include <boost/config.hpp>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Asks the caches for what is read soon. On a large mesh, faces at the edges between clusters lie far from each other in memory;
// loops that ask for several of them before they read the first wait once instead of each time.
//
// What does nothing else has to be inlined by force, too: g++ takes calls of it for calls without effect and drops them.
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
