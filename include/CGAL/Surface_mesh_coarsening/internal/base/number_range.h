// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_NUMBER_RANGE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_NUMBER_RANGE_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Index.h>

#include <CGAL/Iterator_range.h>

#include <boost/iterator/counting_iterator.hpp>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

typedef Iterator_range<boost::counting_iterator<Index> > Number_range;

// Returns the numbers from `begin` to `end`, without `end`.
inline Number_range number_range(Index begin, Index end)
{
  return {boost::counting_iterator<Index>(begin), boost::counting_iterator<Index>(end)};
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_NUMBER_RANGE_H
