// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_CLUSTERED_FACES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_CLUSTERED_FACES_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Coarse_features.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Placements take and return points of a kernel. `Vector` states why all other code does not.
inline Simple_cartesian<double>::Point_3 to_point(const Vector& p) { return {p[0], p[1], p[2]}; }
inline Vector to_vector(const Simple_cartesian<double>::Point_3& p) { return {{p.x(), p.y(), p.z()}}; }

inline std::vector<Simple_cartesian<double>::Point_3> to_points(const std::vector<Vector>& positions)
{
  std::vector<Simple_cartesian<double>::Point_3> points;
  points.reserve(positions.size());
  for (const Vector& p : positions)
    points.push_back(to_point(p));
  return points;
}

inline std::vector<Vector> to_vectors(const std::vector<Simple_cartesian<double>::Point_3>& points)
{
  std::vector<Vector> positions;
  positions.reserve(points.size());
  for (const auto& p : points)
    positions.push_back(to_vector(p));
  return positions;
}

// The faces and their geometry, cluster by cluster: the data behind `Clustered_surface`, with points as `Vector`.
class Clustered_faces
{
public:
  typedef Iterator_range<const std::uint32_t*> Range;

  Clustered_faces(const Clustering_input& input, const Cluster_labels& labels, std::size_t clusters,
                  const Run_context& context = Run_context(), const Coarse_features* features = nullptr)
    : input_(input), labels_(labels), context_(context), features_(features),
      faces_(numbers_below(std::uint32_t(input.mesh.number_of_faces())), clusters, [&](std::uint32_t f) { return labels[f]; },
             context),
      bounds_(clusters)
  {
    for_each_chunk(context, clusters, 64, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t x = begin; x < end; ++x)
        bounds_[x] = internal::vertex_bounds(input.mesh, faces(x));
    });
  }

  Clustered_faces(const Labelled_pieces& pieces, std::size_t clusters, const Run_context& context)
    : Clustered_faces(pieces.input(), pieces.labels(), clusters, context, pieces.features())
  {
    pieces_ = &pieces;
    single_vertex_ = pieces.single_vertices();
    number_of_cells_ = pieces.number_of_cells();
  }

  // For a surface that approximates the input: the vertices have given bounds, and clusters may have no faces.
  Clustered_faces(const Clustering_input& input, const Cluster_labels& labels, std::vector<Bbox_3> bounds,
                  const Run_context& context)
    : input_(input), labels_(labels), context_(context), features_(nullptr),
      faces_(numbers_below(std::uint32_t(input.mesh.number_of_faces())), bounds.size(),
             [&](std::uint32_t f) { return labels[f]; }, context),
      bounds_(std::move(bounds)), is_approximate_(true)
  {}

  const Clustering_input& input() const { return input_; }
  const Cluster_labels& labels() const { return labels_; }
  const Run_context& context() const { return context_; }
  const Coarse_features* features() const { return features_; }
  // See `Labelled_pieces`.
  const Flat_mesh& whole_mesh() const { return pieces_ ? pieces_->whole_mesh() : input_.mesh; }
  Index whole_face(Index face) const { return pieces_ ? pieces_->whole_face(face) : face; }

  // Whether the faces approximate the input. They may intersect where the input does not.
  bool is_approximate() const { return is_approximate_; }
  std::size_t number_of_clusters() const { return faces_.size(); }
  Range faces(std::size_t cluster) const { return faces_[cluster]; }
  const Bucketed_items<std::uint32_t>& faces() const { return faces_; }
  // The vertices around a face, counterclockwise.
  Range vertices(std::size_t face) const
  {
    const Flat_mesh& m = input_.mesh;
    return {m.corner_vertex.data() + m.first_corner[face], m.corner_vertex.data() + m.first_corner[face + 1]};
  }
  const Vector& point(std::size_t vertex) const { return input_.mesh.points[vertex]; }
  Vector centroid(std::size_t face) const { return input_.centroid(Index(face)); }
  double area(std::size_t face) const { return input_.area[face]; }
  bool is_on_cluster_boundary(std::size_t vertex) const { return labels_.boundary_count(Index(vertex)) != 0; }

  // The centroid (7) of a cluster: see `Clustered_surface::cluster_centroid()`. For a cluster without faces, the middle of its
  // bounds.
  Vector cluster_centroid(std::size_t cluster) const
  {
    if (faces(cluster).empty())
      return without_last_digits(0.5 * (low_corner(bounds_[cluster]) + high_corner(bounds_[cluster])));
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

  // Whether the clusters consist of the cells of vertices.
  bool has_cells() const { return number_of_cells_ > 0; }
  // The number of clusters relative to the number of cells.
  double clusters_per_cell() const { return double(number_of_clusters()) / double(number_of_cells_); }
  // The vertex whose cell is the cluster; NONE for clusters of faces, and for clusters of several cells.
  Index single_vertex(std::size_t cluster) const { return single_vertex_.empty() ? NONE : single_vertex_[cluster]; }

  const Bbox_3& vertex_bounds(std::size_t cluster) const { return bounds_[cluster]; }

  Vector within_bounds(std::size_t cluster, const Vector& p) const
  {
    const bool is_finite = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
    return is_finite ? closest_in_box(p, bounds_[cluster]) : cluster_centroid(cluster);
  }

private:
  const Clustering_input& input_;
  const Cluster_labels& labels_;
  const Run_context context_;
  const Coarse_features* features_; // null without features
  Bucketed_items<std::uint32_t> faces_; // of each cluster
  std::vector<Bbox_3> bounds_;          // of each cluster's vertex
  std::vector<Index> single_vertex_;    // of each cluster; empty if faces are clustered
  std::size_t number_of_cells_ = 0;
  bool is_approximate_ = false;
  const Labelled_pieces* pieces_ = nullptr; // null if no pieces were given
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_CLUSTERED_FACES_H
