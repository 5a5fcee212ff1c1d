// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_DISTANCE_REPORT_H
#define CGAL_SURFACE_MESH_COARSENING_DISTANCE_REPORT_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// Statistics of `coarsen_mesh_to_distance()`.
struct Distance_report
{
  /// the number of vertices of the output.
  std::size_t vertices = 0;
  /// whether the bound of the distance is at most the requested distance. If not, the maximum number of vertices ended the search.
  bool is_within_distance = true;
  /// an upper bound of the two-sided Hausdorff distance between the input and the output.
  double distance_bound = 0;
  /// the report of the clustering of which the output is the dual.
  Coarsening_report clustering;
  /// the number of clusterings that were minimized.
  std::size_t clusterings = 0;
  /// the number of times that a distance was bounded.
  std::size_t bounds = 0;
};

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_DISTANCE_REPORT_H
