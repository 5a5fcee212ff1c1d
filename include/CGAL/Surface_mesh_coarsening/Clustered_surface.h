// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTERED_SURFACE_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTERED_SURFACE_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Coarse_features.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/Bucketed_items.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/boxes.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/vertex_bounds.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/rounding.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// The input of a vertex placement: the faces with their geometry, cluster by cluster.
///
/// Faces, vertices and clusters are numbered from 0. Coordinates are relative to a local origin near the center of the
/// mesh.
class Clustered_surface
{
public:
  /// A point, or a vector.
  typedef std::array<double, 3> Point;

  /// A range of numbers of faces or vertices.
  typedef Iterator_range<const std::uint32_t*> Range;

  /// \cond SKIP_IN_MANUAL
  Clustered_surface(const internal::Clustering_input& input, const internal::Cluster_labels& labels, std::size_t clusters,
                    internal::Execution execution = internal::Execution::SEQUENTIAL,
                    const internal::Coarse_features* features = nullptr,
                    const internal::Cancellation_point& cancellation = internal::Cancellation_point())
    : input_(input), labels_(labels), execution_(execution), features_(features), cancellation_(cancellation),
      faces_(internal::numbers_below(std::uint32_t(input.mesh.number_of_faces())), clusters,
             [&](std::uint32_t f) { return labels[f]; }, cancellation),
      bounds_(clusters)
  {
    internal::for_each_chunk(execution, clusters, 64, cancellation, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t x = begin; x < end; ++x)
        bounds_[x] = internal::vertex_bounds(input.mesh, faces(x));
    });
  }
  const internal::Clustering_input& input() const { return input_; }
  const internal::Cluster_labels& labels() const { return labels_; }
  internal::Execution execution() const { return execution_; }
  const internal::Coarse_features* features() const { return features_; }
  const internal::Cancellation_point& cancellation() const { return cancellation_; }
  /// \endcond

  /// returns the number of clusters.
  std::size_t number_of_clusters() const { return faces_.size(); }
  /// returns the faces of a cluster.
  Range faces(std::size_t cluster) const { return faces_[cluster]; }
  /// returns the vertices around a face, counterclockwise.
  Range vertices(std::size_t face) const
  {
    const internal::Flat_mesh& m = input_.mesh;
    return {m.corner_vertex.data() + m.first_corner[face], m.corner_vertex.data() + m.first_corner[face + 1]};
  }
  /// returns the position of a vertex.
  const Point& point(std::size_t vertex) const { return input_.mesh.points[vertex]; }
  /// returns whether a vertex lies on the boundary of its cluster, that is, between several clusters or on the border of
  /// the mesh.
  bool is_on_cluster_boundary(std::size_t vertex) const { return labels_.boundary_count(internal::Index(vertex)) != 0; }
  /// returns the centroid of a face.
  Point centroid(std::size_t face) const { return input_.centroid(internal::Index(face)); }
  /// returns the area of a face.
  double area(std::size_t face) const { return input_.area[face]; }
  /// returns the density of a face.
  double density(std::size_t face) const { return input_.density[face]; }

  /// returns the centroid (7) of a cluster: the mean of the centroids of its faces, weighted with density times area;
  /// unweighted if the faces have no area. Coordinates are rounded to 43 binary digits of the largest, so that they
  /// hardly ever depend on the compiler.
  Point cluster_centroid(std::size_t cluster) const
  {
    using namespace internal;
    Vector moment{{0, 0, 0}}, sum{{0, 0, 0}};
    double mass = 0;
    for (const Index f : faces(cluster)) {
      const Vector center = input_.centroid(f);
      moment = moment + input_.mass(f) * center;
      mass += input_.mass(f);
      sum = sum + center;
    }
    constexpr double least = (std::numeric_limits<double>::min)(); // its inverse is finite
    return without_last_digits(mass >= least ? (1 / mass) * moment : (1 / double(faces(cluster).size())) * sum);
  }

  /// returns the box that has to contain the vertex of a cluster: the bounding box of the vertices of its faces, enlarged by
  /// half its diagonal on all sides.
  const Bbox_3& vertex_bounds(std::size_t cluster) const { return bounds_[cluster]; }

  /// returns the point of `vertex_bounds()` closest to `p`, or the centroid of the cluster if `p` is not finite.
  Point within_bounds(std::size_t cluster, const Point& p) const
  {
    const bool is_finite = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
    return is_finite ? internal::closest_in_box(p, bounds_[cluster]) : cluster_centroid(cluster);
  }

private:
  const internal::Clustering_input& input_;
  const internal::Cluster_labels& labels_;
  const internal::Execution execution_;
  const internal::Coarse_features* features_; // null without features
  const internal::Cancellation_point cancellation_;
  internal::Bucketed_items<std::uint32_t> faces_; // of each cluster
  std::vector<Bbox_3> bounds_;                     // of each cluster's vertex
};

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTERED_SURFACE_H
