// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTER_ENERGY_QUADRIC_ENERGY_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTER_ENERGY_QUADRIC_ENERGY_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Moments.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningEnergies
/// \cgalModels `ClusterEnergy`
///
/// The residual of the quadric of the cluster. With unit normals \f$ n_j \f$ and masses \f$ m_j = \rho_j A_j \f$ of its faces,
/// the energy is
/// \f[ \min_x \sum_j m_j \left( (n_j \cdot (x - g_j))^2 + \lambda |x - g_j|^2 \right). \f] The first term sums the squared
/// distances of a point from the planes of the faces, as the quadrics of \cgalCite{GH97} do;
/// \cgalCite{VCP08} introduced such quadrics into a clustering of faces. Where the surface bends in one direction only, clusters
/// are longer in the other direction. The second term is \f$ \lambda \f$ times the inertia. It determines the clusters in flat
/// regions, where all quadrics vanish, and makes them well shaped there. The two terms balance where normals turn by about
/// \f$ 2 \sqrt{\lambda} \f$ within a cluster.
class Quadric_energy
/// \cond SKIP_IN_MANUAL
  : public internal::Regularized_energy
/// \endcond
{
public:
  /// The default value of \f$ \lambda \f$.
  static constexpr double default_regularization = 0.1;

  /// \param regularization the factor \f$ \lambda \f$ of the inertia, positive and finite
  /// \throws Invalid_input if `regularization` is out of range.
  explicit Quadric_energy(double regularization = default_regularization)
    : internal::Regularized_energy(regularization, "quadric energy")
  {}

  /// \cond SKIP_IN_MANUAL
  // The sums of m n n^T (upper triangle), m d n and m d^2, where d is the distance of a plane from an origin in the cluster. Sums
  // about an origin far from the cluster would lose the digits that form the residual.
  struct Cluster_data : internal::Moments
  {
    std::array<double, 6> matrix{};
    internal::Vector vector{{0, 0, 0}}, origin{{0, 0, 0}};
    double constant = 0;
    bool has_origin = false;
  };

  void add(Cluster_data& x, const Face_data& face) const
  {
    if (!x.has_origin) {
      x.origin = face.centroid;
      x.has_origin = true;
    }
    x.join(face.mass, face.centroid);
    accumulate(x, face, face.mass);
  }
  void remove(Cluster_data& x, const Face_data& face) const
  {
    x.leave(face.mass, face.centroid);
    accumulate(x, face, -face.mass);
  }

  // Returns the sums of the union of two clusters, about the origin of the first one.
  static Cluster_data joined(const Cluster_data& x, const Cluster_data& y)
  {
    using namespace internal;
    Cluster_data sum = x;
    static_cast<Moments&>(sum) = internal::joined(x, y);
    const Vector d = x.origin - y.origin;
    const std::array<double, 6>& a = y.matrix;
    const Vector ad{{a[0] * d[0] + a[1] * d[1] + a[2] * d[2], a[1] * d[0] + a[3] * d[1] + a[4] * d[2],
                     a[2] * d[0] + a[4] * d[1] + a[5] * d[2]}};
    for (std::size_t i = 0; i < 6; ++i)
      sum.matrix[i] += a[i];
    sum.vector = sum.vector + y.vector - ad;
    sum.constant += y.constant - 2 * dot(d, y.vector) + dot(d, ad);
    return sum;
  }

  double energy(const Cluster_data& x, std::size_t /* faces */) const
  {
    const double pull = regularization_ * x.mass;
    if (!(pull > 0))
      return 0;
    using namespace internal;
    // The residual is the value of the quadric at the centroid minus the gain of the step to the optimum.
    const Vector center = x.centroid - x.origin;
    const std::array<double, 6>& a = x.matrix;
    const Vector slope{{x.vector[0] - a[0] * center[0] - a[1] * center[1] - a[2] * center[2],
                        x.vector[1] - a[1] * center[0] - a[3] * center[1] - a[4] * center[2],
                        x.vector[2] - a[2] * center[0] - a[4] * center[1] - a[5] * center[2]}};
    const double at_center = x.constant - dot(x.vector, center) - dot(slope, center);
    return regularization_ * x.inertia + (std::max)(0., at_center - gain(a, pull, slope));
  }
  /// \endcond

private:
  static void accumulate(Cluster_data& x, const Face_data& face, double mass)
  {
    using namespace internal;
    const Vector &n = face.normal, s = mass * n;
    const double d = dot(n, face.centroid - x.origin);
    std::array<double, 6>& a = x.matrix;
    a[0] += s[0] * n[0];
    a[1] += s[0] * n[1];
    a[2] += s[0] * n[2];
    a[3] += s[1] * n[1];
    a[4] += s[1] * n[2];
    a[5] += s[2] * n[2];
    x.vector = x.vector + d * s;
    x.constant += mass * d * d;
  }

  // Returns s^T (A + pull I)^-1 s by Cholesky factorization. Up to rounding errors, the pivots are at least `pull`.
  static double gain(const std::array<double, 6>& a, double pull, const internal::Vector& s)
  {
    const auto pivot = [pull](double x) { return std::sqrt((std::max)(x, pull)); };
    const double p0 = pivot(a[0] + pull), l10 = a[1] / p0, l20 = a[2] / p0;
    const double p1 = pivot(a[3] + pull - l10 * l10), l21 = (a[4] - l20 * l10) / p1;
    const double p2 = pivot(a[5] + pull - l20 * l20 - l21 * l21);
    const double y0 = s[0] / p0, y1 = (s[1] - l10 * y0) / p1, y2 = (s[2] - l20 * y0 - l21 * y1) / p2;
    return y0 * y0 + y1 * y1 + y2 * y2;
  }
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTER_ENERGY_QUADRIC_ENERGY_H
