// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_UNIFORM_WEIGHT_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_UNIFORM_WEIGHT_H

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Additive_cluster_weight.h>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningWeights
/// \cgalModels `ClusterWeight`
///
/// The weight 1. The result is an ordinary centroidal Voronoi diagram with density, the baseline of figures 1 and 6 of
/// the paper (remark in section 5.2).
class Uniform_weight
  : public Additive_cluster_weight<Uniform_weight>
{
public:
  /// The sizes of clusters hardly depend on densities, so reclustering with other densities is not expected to help.
  static constexpr bool depends_on_densities = false;

  /// No data is stored per face.
  struct Face_data {};
  /// No data is stored per cluster.
  struct Cluster_data {};

  /// returns the data of a face.
  Face_data face_data(double /* density */, double /* area */) const { return {}; }
  /// adds a face to the data of a cluster.
  void add(Cluster_data&, const Face_data&) const {}
  /// removes a face from the data of a cluster.
  void remove(Cluster_data&, const Face_data&) const {}
  /// returns 1.
  double weight(const Cluster_data&, double /* mass */, std::size_t /* faces */) const { return 1; }
  /// returns whether the sum of the two inertias does not decrease, by a comparison of products.
  bool cannot_gain(const Trial_move& t) const
  {
    return (t.target_mass + t.face_mass) * t.source_mass * t.source_squared_distance <=
           (t.source_mass - t.face_mass) * t.target_mass * t.target_squared_distance;
  }
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_UNIFORM_WEIGHT_H
