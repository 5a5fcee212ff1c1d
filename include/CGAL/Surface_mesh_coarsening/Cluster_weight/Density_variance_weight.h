// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_DENSITY_VARIANCE_WEIGHT_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_DENSITY_VARIANCE_WEIGHT_H

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Additive_cluster_weight.h>

#include <algorithm>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningWeights
/// \cgalModels `ClusterWeight`
///
/// One plus the sum of the squared deviations of the densities of the \f$ n \f$ faces of the cluster from their mean,
/// \f$ 1 + \sum_j \rho_j^2 - (\sum_j \rho_j)^2 / n \f$ (section 5.3, formulas (11) and (12) of the paper). Clusters
/// stretch along lines of high density. The weight is quadratic in the densities; the paper maps densities to \f$ [1, 3] \f$.
class Density_variance_weight
  : public Additive_cluster_weight<Density_variance_weight>
{
public:
  /// The density.
  typedef double Face_data;

  /// Sums over the faces of a cluster.
  struct Cluster_data
  {
    double sum = 0;            ///< of the densities
    double sum_of_squares = 0; ///< of the densities
  };

  /// returns the data of a face.
  Face_data face_data(double density, double /* area */) const { return density; }
  /// adds a face to the data of a cluster.
  void add(Cluster_data& data, Face_data density) const
  {
    data.sum += density;
    data.sum_of_squares += density * density;
  }
  /// removes a face from the data of a cluster.
  void remove(Cluster_data& data, Face_data density) const
  {
    data.sum -= density;
    data.sum_of_squares -= density * density;
  }
  /// returns the weight.
  double weight(const Cluster_data& data, double /* mass */, std::size_t faces) const
  {
    return 1 + (std::max)(0., data.sum_of_squares - data.sum * data.sum / double(faces));
  }
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_DENSITY_VARIANCE_WEIGHT_H
