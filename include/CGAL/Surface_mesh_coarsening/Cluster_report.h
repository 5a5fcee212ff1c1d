// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTER_REPORT_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTER_REPORT_H

#include <CGAL/Simple_cartesian.h>

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// Statistics of one cluster, see `Mwcvd_clustering::cluster_reports()`.
struct Cluster_report
{
  /// the number of faces `f` of the mesh for which `Mwcvd_clustering::cluster(f)` returns the cluster.
  std::size_t faces = 0;
  /// the centroid (7): the mean of the centroids of the faces, weighted by density times area, or unweighted if the faces have no
  /// area. Coordinates are rounded to 43 binary digits relative to the largest one.
  Simple_cartesian<double>::Point_3 centroid = Simple_cartesian<double>::Point_3(0, 0, 0);
  /// the weight in the energy (8); 1 if a `ClusterEnergy` without a weight was chosen.
  double weight = 1;
  /// the energy of the cluster, a summand of `Mwcvd_clustering::energy()`.
  double energy = 0;
};

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTER_REPORT_H
