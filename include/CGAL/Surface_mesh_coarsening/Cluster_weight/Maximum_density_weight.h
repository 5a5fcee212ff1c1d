// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_MAXIMUM_DENSITY_WEIGHT_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_MAXIMUM_DENSITY_WEIGHT_H

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Additive_cluster_weight.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>

#include <cmath>
#include <string>

namespace CGAL {
namespace Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningWeights
/// \cgalModels `ClusterWeight`
///
/// The p-norm of the densities of the faces of the cluster, \f$ (\sum_j \rho_j^p)^{1/p} \f$, which approximates their
/// maximum (section 8.4, formulas (10) and (13) of the paper). Clusters stretch along lines of high density.
///
/// Powers of densities in \f$ [1, 50] \f$ span 17 decimal digits for `p` = 10: the sum is kept as a sum of two numbers,
/// so that it is not lost when the face of the highest density leaves the cluster.
class Maximum_density_weight
  : public Additive_cluster_weight<Maximum_density_weight>
{
public:
  /// The `p`-th power of the density.
  typedef double Face_data;

  /// A sum and what rounding has left out of it.
  struct Cluster_data
  {
    double sum = 0;   ///< the sum, rounded
    double error = 0; ///< what is missing in it
  };

  /// \param p the exponent, at least 1 and finite; the paper uses 10.
  /// \throws Invalid_input if it is not.
  explicit Maximum_density_weight(double p = 10) : p_(p)
  {
    if (!(p >= 1) || std::isinf(p))
      throw Invalid_input("the exponent of the maximum density weight is " + std::to_string(p));
  }

  /// returns what the weight needs of a face.
  Face_data face_data(double density, double /* area */) const { return std::pow(density, p_); }
  /// adds a face to the data of a cluster.
  void add(Cluster_data& data, Face_data power) const { accumulate(data, power); }
  /// takes a face from the data of a cluster.
  void remove(Cluster_data& data, Face_data power) const { accumulate(data, -power); }
  /// returns the p-norm.
  double weight(const Cluster_data& data, double /* mass */, std::size_t /* faces */) const
  {
    const double sum = data.sum + data.error;
    return sum > 0 ? std::pow(sum, 1 / p_) : 0;
  }

private:
  // Knuth's error-free sum.
  static void accumulate(Cluster_data& data, double x)
  {
    const double sum = data.sum + x, part = sum - data.sum;
    data.error += (data.sum - (sum - part)) + (x - part);
    data.sum = sum;
  }

  double p_;
};

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_MAXIMUM_DENSITY_WEIGHT_H
