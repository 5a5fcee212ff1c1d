// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTER_FACES_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTER_FACES_H

#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <string>

namespace CGAL::Surface_mesh_coarsening {
/// \cond SKIP_IN_MANUAL
namespace internal {

// The member `faces` of the class below hides the function of the mesh.
template <class FaceGraph>
auto faces_of(const FaceGraph& mesh) { return faces(mesh); }

} // namespace internal
/// \endcond

/// \ingroup PkgSurfaceMeshCoarseningRef
/// The inverse of a face cluster map: the faces of each cluster.
///
/// The `i`-th vertex of the output of `coarsen_mesh()` represents cluster `i`.
///
/// \tparam FaceGraph a model of `FaceListGraph`
template <class FaceGraph>
class Cluster_faces
{
public:
  /// The face descriptor of the mesh.
  typedef typename boost::graph_traits<FaceGraph>::face_descriptor face_descriptor;

  /// A range of faces.
  typedef Iterator_range<const face_descriptor*> Range;

  /// sorts the faces by cluster, in time linear in the number of faces.
  ///
  /// \tparam FaceClusterMap a model of `ReadablePropertyMap` with the faces as keys and an integral value type
  /// \param mesh the mesh
  /// \param clusters the clusters, as written by `coarsen_mesh()`
  /// \param number_of_clusters the number of clusters. Faces with this label belong to no cluster
  /// \throws Invalid_input if a label is larger than the number of clusters.
  template <class FaceClusterMap>
  Cluster_faces(const FaceGraph& mesh, const FaceClusterMap& clusters, std::size_t number_of_clusters)
    : faces_(internal::faces_of(mesh), number_of_clusters, [&](const face_descriptor& f) {
        const std::size_t x = std::size_t(get(clusters, f));
        if (x > number_of_clusters)
          throw Invalid_input("a face has cluster " + std::to_string(x) + " of " + std::to_string(number_of_clusters));
        return x;
      })
  {}

  /// returns the number of clusters.
  std::size_t size() const { return faces_.size(); }
  /// returns the faces of a cluster, in the order of the mesh.
  Range faces(std::size_t cluster) const { return faces_[cluster]; }

private:
  internal::Bucketed_items<face_descriptor> faces_;
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTER_FACES_H
