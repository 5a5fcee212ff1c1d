// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_ADDITIVE_CLUSTER_WEIGHT_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_ADDITIVE_CLUSTER_WEIGHT_H

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningWeights
/// completes a weight that is a function of sums over the faces of a cluster: given `add()`, `remove()` and
/// `weight()`, provides the other members that the concept `ClusterWeight` requires, the weight with one face more
/// or less. Both are computed on a copy of the cluster's data, which should therefore be small.
///
/// \tparam Derived the weight, derived from this class.
template <class Derived>
class Additive_cluster_weight
{
public:
  /// returns the weight of a cluster with data `data` after face `face` has joined it; `mass` and `faces` are its mass
  /// and number of faces then.
  template <class Cluster_data, class Face_data>
  double weight_with(Cluster_data data, const Face_data& face, double mass, std::size_t faces) const
  {
    derived().add(data, face);
    return derived().weight(data, mass, faces);
  }

  /// returns the weight of a cluster with data `data` after face `face` has left it; `mass` and `faces` are its mass
  /// and number of faces then.
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
