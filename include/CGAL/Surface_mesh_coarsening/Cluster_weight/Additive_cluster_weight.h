// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_ADDITIVE_CLUSTER_WEIGHT_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_ADDITIVE_CLUSTER_WEIGHT_H

#include <cstddef>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningWeights
/// completes a weight that is a function of sums over the faces of a cluster. The weight defines `add()`, `remove()` and
/// `weight()`. This class adds the two other functions that the concept `ClusterWeight` requires: the weight after a face has
/// joined, and the weight after a face has left. Both are computed on a copy of the data of the cluster, which should be small.
///
/// \tparam Derived the weight, derived from this class.
template <class Derived>
class Additive_cluster_weight
{
public:
  /// returns the weight of a cluster with data `data` after face `face` has joined. `mass` and `faces` are the mass of the
  /// cluster and the number of its faces after the move.
  template <class Cluster_data, class Face_data>
  double weight_with(Cluster_data data, const Face_data& face, double mass, std::size_t faces) const
  {
    derived().add(data, face);
    return derived().weight(data, mass, faces);
  }

  /// returns the weight of a cluster with data `data` after face `face` has left. `mass` and `faces` are the mass of the cluster
  /// and the number of its faces after the move.
  template <class Cluster_data, class Face_data>
  double weight_without(Cluster_data data, const Face_data& face, double mass, std::size_t faces) const
  {
    derived().remove(data, face);
    return derived().weight(data, mass, faces);
  }

private:
  const Derived& derived() const { return static_cast<const Derived&>(*this); }
};

/// \ingroup PkgSurfaceMeshCoarseningWeights
///
/// The moments of two clusters before a face moves from the first cluster, the source, to the second cluster, the target. A model
/// of `ClusterWeight` may conclude from these moments that the move does not lower the energy.
///
/// Consider a face of mass \f$ m \f$ at distance \f$ d \f$ from the centroid of a cluster of mass \f$ M \f$. If the face leaves
/// the cluster, the inertia of the cluster decreases by \f$ m M d^2 / (M - m) \f$. If the face joins the cluster, the inertia
/// increases by \f$ m M d^2 / (M + m) \f$.
struct Trial_move
{
  /// the mass of the face, which is density times area; it is smaller than the mass of the source.
  double face_mass;
  /// the mass of the source.
  double source_mass;
  /// the inertia (7) of the source about its centroid.
  double source_inertia;
  /// the squared distance between the centroids of the face and of the source.
  double source_squared_distance;
  /// the mass of the target.
  double target_mass;
  /// the inertia (7) of the target about its centroid.
  double target_inertia;
  /// the squared distance between the centroids of the face and of the target.
  double target_squared_distance;
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_ADDITIVE_CLUSTER_WEIGHT_H
