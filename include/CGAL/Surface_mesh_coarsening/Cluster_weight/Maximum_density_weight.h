// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_MAXIMUM_DENSITY_WEIGHT_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_MAXIMUM_DENSITY_WEIGHT_H

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Additive_cluster_weight.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>

#include <cmath>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningWeights
/// \cgalModels `ClusterWeight`
///
/// The p-norm of the densities of the faces of the cluster, \f$ (\sum_j \rho_j^p)^{1/p} \f$, which approximates their
/// maximum (section 8.4, formulas (10) and (13) of the paper). Clusters stretch along lines of high density.
///
/// For `p` = 10, the powers of densities in \f$ [1, 50] \f$ span 17 decimal digits. The sum is stored as a sum of two
/// numbers, so it remains accurate when the face of highest density leaves the cluster.
class Maximum_density_weight
  : public Additive_cluster_weight<Maximum_density_weight>
{
public:
  /// The `p`-th power of the density.
  typedef double Face_data;

  /// A sum with its rounding error.
  struct Cluster_data
  {
    double sum = 0;   ///< the sum, rounded
    double error = 0; ///< its rounding error
  };

  /// \param p the exponent, at least 1 and finite; the paper uses 10.
  /// \throws Invalid_input if `p` is out of range.
  explicit Maximum_density_weight(double p = 10)
    : p_(p), inverse_of_p_(1 / p), whole_p_(p >= 1 && p <= 64 && p == std::floor(p) ? unsigned(p) : 0)
  {
    if (!(p >= 1) || std::isinf(p))
      throw Invalid_input("the exponent of the maximum density weight is " + internal::number_text(p));
  }

  /// returns the data of a face.
  Face_data face_data(double density, double /* area */) const
  {
    return whole_p_ != 0 ? whole_power(density, whole_p_) : std::pow(density, p_);
  }
  /// adds a face to the data of a cluster.
  void add(Cluster_data& data, Face_data power) const { accumulate(data, power); }
  /// removes a face from the data of a cluster.
  void remove(Cluster_data& data, Face_data power) const { accumulate(data, -power); }
  /// returns the p-norm.
  double weight(const Cluster_data& data, double /* mass */, std::size_t /* faces */) const
  {
    const double sum = data.sum + data.error;
    return sum > 0 ? std::pow(sum, inverse_of_p_) : 0;
  }

  /// \cond SKIP_IN_MANUAL
  // Lower bounds of the weights after a face has joined and after a face has left; `weight` is the current weight. For
  // q = 1 / p and the share t of the face in the sum, (1 + t)^q >= 1 + q t - q (1 - q) t^2 / 2, and
  // (1 - t)^q >= 1 / (1 + q t / (1 - t)).
  double min_weight_with(const Cluster_data& data, Face_data power, double weight) const
  {
    const double sum = data.sum + data.error, q = inverse_of_p_;
    if (!(power < sum))
      return weight * rounding;
    const double t = power / sum;
    return weight * (1 + q * t * (1 - 0.5 * (1 - q) * t)) * rounding;
  }
  double min_weight_without(const Cluster_data& data, Face_data power, double weight) const
  {
    const double sum = data.sum + data.error, rest = sum - power;
    return rest > 1e-6 * sum ? weight * (p_ * rest / (p_ * rest + power)) * rounding : 0;
  }
  /// \endcond

private:
  static constexpr double rounding = 1 - 1e-8; // exceeds the rounding errors of sum and weight

  static double whole_power(double x, unsigned n)
  {
    double power = 1;
    for (; n != 0; n /= 2, x *= x)
      if (n % 2 == 1)
        power *= x;
    return power;
  }

  // Knuth's error-free sum.
  static void accumulate(Cluster_data& data, double x)
  {
    const double sum = data.sum + x, part = sum - data.sum;
    data.error += (data.sum - (sum - part)) + (x - part);
    data.sum = sum;
  }

  double p_, inverse_of_p_;
  unsigned whole_p_; // `p` if it is an integer; otherwise 0
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_MAXIMUM_DENSITY_WEIGHT_H
