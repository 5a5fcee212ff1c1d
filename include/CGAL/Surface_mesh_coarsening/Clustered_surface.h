// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTERED_SURFACE_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTERED_SURFACE_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// The input of a vertex placement: the faces and their geometry, cluster by cluster.
///
/// Faces, vertices and clusters are numbered from 0. Coordinates are relative to a local origin near the center of the
/// mesh.
class Clustered_surface
{
public:
  /// the kernel of the points, independent of the kernel of the mesh
  typedef Simple_cartesian<double> Kernel;

  /// the type of points
  typedef Kernel::Point_3 Point_3;

  /// a range of numbers of faces or vertices
  typedef Iterator_range<const std::uint32_t*> Range;

  /// \cond SKIP_IN_MANUAL
  explicit Clustered_surface(const internal::Clustered_faces& clusters) : clusters_(clusters) {}
  const internal::Clustered_faces& clusters() const { return clusters_; }
  /// \endcond

  /// returns the number of clusters.
  std::size_t number_of_clusters() const { return clusters_.number_of_clusters(); }
  /// returns the faces of a cluster.
  Range faces(std::size_t cluster) const { return clusters_.faces(cluster); }
  /// returns the vertices around a face, counterclockwise.
  Range vertices(std::size_t face) const { return clusters_.vertices(face); }
  /// returns the position of a vertex.
  Point_3 point(std::size_t vertex) const { return internal::to_point(clusters_.point(vertex)); }
  /// returns whether a vertex lies on the boundary of its cluster: between several clusters, or on the border of the mesh.
  bool is_on_cluster_boundary(std::size_t vertex) const { return clusters_.is_on_cluster_boundary(vertex); }
  /// returns the centroid of a face.
  Point_3 centroid(std::size_t face) const { return internal::to_point(clusters_.centroid(face)); }
  /// returns the area of a face.
  double area(std::size_t face) const { return clusters_.area(face); }
  /// returns the density of a face.
  double density(std::size_t face) const { return clusters_.input().density[face]; }

  /// returns the centroid (7) of a cluster: the mean of the centroids of its faces, weighted by density times area, or unweighted
  /// if the faces have no area. Coordinates are rounded to 43 binary digits relative to the largest one, so they rarely depend on
  /// the compiler.
  Point_3 cluster_centroid(std::size_t cluster) const { return internal::to_point(clusters_.cluster_centroid(cluster)); }

  /// returns the bounds of the vertex of a cluster: the bounding box of the vertices of its faces, enlarged by half its diagonal
  /// on all sides.
  const Bbox_3& vertex_bounds(std::size_t cluster) const { return clusters_.vertex_bounds(cluster); }

  /// returns the point of `vertex_bounds()` closest to `p`, or the centroid of the cluster if `p` is not finite.
  Point_3 within_bounds(std::size_t cluster, const Point_3& p) const
  {
    return internal::to_point(clusters_.within_bounds(cluster, internal::to_vector(p)));
  }

private:
  const internal::Clustered_faces& clusters_;
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTERED_SURFACE_H
