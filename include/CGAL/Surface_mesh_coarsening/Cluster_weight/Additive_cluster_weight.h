// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_ADDITIVE_CLUSTER_WEIGHT_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_ADDITIVE_CLUSTER_WEIGHT_H

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_coarsening {

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

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_ADDITIVE_CLUSTER_WEIGHT_H
