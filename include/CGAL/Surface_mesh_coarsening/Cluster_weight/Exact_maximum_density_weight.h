// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_EXACT_MAXIMUM_DENSITY_WEIGHT_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_EXACT_MAXIMUM_DENSITY_WEIGHT_H

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningWeights
/// \cgalModels `ClusterWeight`
///
/// The largest density of a face of the cluster, \f$ \max_j \rho_j \f$ (section 5.3, formula (10) of the paper), without
/// the approximation of `Maximum_density_weight`. The class stores the sorted densities of each cluster. A move takes time
/// logarithmic in the number of faces of the cluster, and each face takes about 50 bytes.
class Exact_maximum_density_weight
{
public:
  /// The density.
  typedef double Face_data;
  /// The number of faces of the cluster for each density.
  typedef std::map<double, std::size_t> Cluster_data;

  /// returns the data of a face.
  Face_data face_data(double density, double /* area */) const { return density; }
  /// adds a face to the data of a cluster.
  void add(Cluster_data& data, Face_data density) const { ++data[density]; }
  /// removes a face from the data of a cluster.
  void remove(Cluster_data& data, Face_data density) const
  {
    const auto i = data.find(density);
    if (--i->second == 0)
      data.erase(i);
  }
  /// returns the largest density.
  double weight(const Cluster_data& data, double /* mass */, std::size_t /* faces */) const
  {
    return data.empty() ? 0 : data.rbegin()->first;
  }
  /// returns the largest density after a face of density `density` has joined.
  double weight_with(const Cluster_data& data, Face_data density, double mass, std::size_t faces) const
  {
    return (std::max)(weight(data, mass, faces), density);
  }
  /// returns the largest density after a face of density `density` has left.
  double weight_without(const Cluster_data& data, Face_data density, double mass, std::size_t faces) const
  {
    const auto largest = data.rbegin();
    if (density < largest->first || largest->second > 1)
      return weight(data, mass, faces);
    return data.size() == 1 ? 0 : std::next(largest)->first;
  }
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTER_WEIGHT_EXACT_MAXIMUM_DENSITY_WEIGHT_H
