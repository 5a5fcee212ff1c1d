// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTER_ENERGY_NORMAL_DEVIATION_ENERGY_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTER_ENERGY_NORMAL_DEVIATION_ENERGY_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Moments.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningEnergies
/// \cgalModels `ClusterEnergy`
///
/// The deviation of normals. With unit normals \f$ n_j \f$ and masses \f$ m_j = \rho_j A_j \f$ of the faces of the cluster, the
/// energy is
/// \f[ \sum_j m_j - \left| \sum_j m_j n_j \right| + \frac{\lambda}{a} \sum_j m_j |g_j - z|^2. \f] The first two terms are half
/// the distance \f$ L^{2,1} \f$ of \cgalCite{CAD04},
/// \f$ \sum_j m_j |n_j - N|^2 \f$ for the best unit vector \f$ N \f$. The last term is the inertia about the centroid \f$ z \f$
/// in units of the mean area \f$ a \f$ of a cluster. It determines the clusters in flat regions, where normals do not deviate.
/// The two parts balance where normals turn by about \f$ \sqrt{\lambda} \f$ within a cluster.
class Normal_deviation_energy
/// \cond SKIP_IN_MANUAL
  : public internal::Regularized_energy
/// \endcond
{
public:
  /// The default value of \f$ \lambda \f$.
  static constexpr double default_regularization = 0.1;

  /// \param regularization the factor \f$ \lambda \f$ of the inertia, positive and finite
  /// \throws Invalid_input if `regularization` is out of range.
  explicit Normal_deviation_energy(double regularization = default_regularization)
    : internal::Regularized_energy(regularization, "energy of normals")
  {}

  /// \cond SKIP_IN_MANUAL
  // Moments of the centroids and of the unit normals. Where normals deviate little, the difference of the first two terms of the
  // formula would consist of rounding errors. The inertia of the normals about their mean gives the same value without this loss.
  struct Cluster_data
  {
    internal::Moments centroids, normals;
  };

  void set_mean_area(double area) { mean_area_ = area; }

  void add(Cluster_data& x, const Face_data& face) const
  {
    x.centroids.join(face.mass, face.centroid);
    x.normals.join(face.mass, face.normal);
  }
  void remove(Cluster_data& x, const Face_data& face) const
  {
    x.centroids.leave(face.mass, face.centroid);
    x.normals.leave(face.mass, face.normal);
  }

  double energy(const Cluster_data& x, std::size_t /* faces */) const
  {
    const double mass = x.normals.mass, inertia = x.normals.inertia;
    if (!(mass > 0 && mean_area_ > 0))
      return 0;
    // M - |sum m n| with |sum m n|^2 = M (M - D), where D is the inertia of the normals.
    const double deviation = inertia / (1 + std::sqrt((std::max)(0., 1 - inertia / mass)));
    return deviation + regularization_ / mean_area_ * x.centroids.inertia;
  }
  /// \endcond

private:
  double mean_area_ = 1;
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTER_ENERGY_NORMAL_DEVIATION_ENERGY_H
