// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_DISTRIBUTED_REPORT_H
#define CGAL_SURFACE_MESH_COARSENING_DISTRIBUTED_REPORT_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>

#include <cstdint>

namespace CGAL {
namespace Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// Statistics of the coarsening of a distributed mesh. The members of the base class are equal on all ranks. Its numbers of
/// seeds, splits, merges, moves and tests, and its initial energy, describe the clustering of cells. Unless the cells are the
/// faces, all intersecting pairs are counted, also where the input intersects itself, and reversed triangles face away from an
/// approximation of the input.
struct Distributed_report
  : Coarsening_report
{
  /// the number of bytes that this rank has sent to other ranks.
  std::uint64_t bytes_sent = 0;
  /// the number of bytes that this rank has written to its scratch file.
  std::uint64_t bytes_of_scratch = 0;
};

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_DISTRIBUTED_REPORT_H
