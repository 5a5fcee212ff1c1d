// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_WEIGHTED_AREA_WEIGHT_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_WEIGHTED_AREA_WEIGHT_H

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Additive_cluster_weight.h>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningWeights
/// \cgalModels `ClusterWeight`
///
/// The area of the cluster, weighted by the densities of its faces, \f$ \sum_j \rho_j A_j \f$ (section 5.3, formula (9)
/// of the paper). Clusters of high density are small and compact.
class Weighted_area_weight
  : public Additive_cluster_weight<Weighted_area_weight>
{
public:
  /// No data is stored per face.
  struct Face_data {};
  /// No data is stored per cluster: its mass is the weight.
  struct Cluster_data {};

  /// returns the data of a face.
  Face_data face_data(double /* density */, double /* area */) const { return {}; }
  /// adds a face to the data of a cluster.
  void add(Cluster_data&, const Face_data&) const {}
  /// removes a face from the data of a cluster.
  void remove(Cluster_data&, const Face_data&) const {}
  /// returns the mass of the cluster.
  double weight(const Cluster_data&, double mass, std::size_t /* faces */) const { return mass; }
  /// returns whether the energy does not decrease. If \f$ M \f$ is the weight, the energy decreases if and only if
  /// \f$ I + M d^2 > I' + M' d'^2 \f$.
  bool cannot_gain(const Trial_move& t) const
  {
    return t.source_inertia + t.source_mass * t.source_squared_distance <=
           t.target_inertia + t.target_mass * t.target_squared_distance;
  }
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_WEIGHTED_AREA_WEIGHT_H
