// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_IS_VALID_CLUSTERING_H
#define CGAL_SURFACE_MESH_COARSENING_IS_VALID_CLUSTERING_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Clustering_check.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

#include <string>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// describes why labels of the faces of a mesh are not a valid clustering. The description of a valid clustering is empty.
///
/// A clustering is valid if
/// - the faces of each cluster form a closed disc: they are connected across edges, the faces around any vertex are
///   consecutive, and there are no holes;
/// - its dual triangulation is a simplicial surface: around a cluster, no neighbor occurs twice, there are at least
///   three neighbors, and the cluster meets the border of the mesh in at most one arc. Neighbors are the clusters across edges
///   and, where more than three clusters meet in a vertex, the clusters that the fan of triangles connects.
///
/// Then the dual triangulation is a 2-manifold with the Euler characteristic and the border loops of the mesh.
///
/// \tparam FaceGraph a model of `FaceListGraph`
/// \tparam FaceClusterMap a model of `ReadablePropertyMap` with the faces as keys and an integral value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a 2-manifold polygon mesh
/// \param clusters the labels, which may be any numbers
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": \smcParam{face_index_map} as in
/// `coarsen_mesh()`
///
/// \return the first fault, with the label of its cluster.
/// \throws Invalid_input if the mesh is not a 2-manifold.
template <class FaceGraph, class FaceClusterMap, class NamedParameters = parameters::Default_named_parameters>
std::string clustering_fault(const FaceGraph& mesh, const FaceClusterMap& clusters,
                             const NamedParameters& np = parameters::default_values())
{
  internal::accept_parameters<NamedParameters, internal::Order_parameters>();
  const internal::Numbering<FaceGraph> n = internal::numbering(mesh, np);
  const internal::Flat_mesh m = internal::flat_connectivity(mesh, n);
  internal::Cluster_labels labels(m);
  const auto names = internal::label_clusters(n, clusters, labels);
  internal::Clustering_check check(labels, names.size());
  return check.fault([&](std::size_t x) { return "cluster " + std::to_string(names[x]); });
}

/// \ingroup PkgSurfaceMeshCoarseningRef
/// returns whether labels of the faces of a mesh are a valid clustering, see `clustering_fault()`.
template <class FaceGraph, class FaceClusterMap, class NamedParameters = parameters::Default_named_parameters>
bool is_valid_clustering(const FaceGraph& mesh, const FaceClusterMap& clusters,
                         const NamedParameters& np = parameters::default_values())
{
  return clustering_fault(mesh, clusters, np).empty();
}

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_IS_VALID_CLUSTERING_H
