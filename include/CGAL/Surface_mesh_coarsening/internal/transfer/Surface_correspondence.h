// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_SURFACE_CORRESPONDENCE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_SURFACE_CORRESPONDENCE_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Bucketed_items.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Nearest_point_search.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// A clustered mesh and its coarse mesh in arrays, and the correspondence between their elements.
class Surface_correspondence
{
public:
  // Faces of cluster NONE have no correspondence. Coordinates of both meshes have the same origin.
  Surface_correspondence(Flat_mesh mesh, std::vector<double> areas, std::vector<Vector> centroids, std::vector<Index> clusters,
                    std::vector<Vector> positions, std::vector<Triangle> triangles)
    : mesh_(std::move(mesh)), area_(std::move(areas)), centroid_(std::move(centroids)), cluster_(std::move(clusters)),
      position_(std::move(positions)), triangles_(std::move(triangles)), around_(position_.size()),
      dual_area_(position_.size(), 0),
      faces_(numbers_below(Index(cluster_.size())), position_.size(), [this](Index f) { return cluster_[f]; }),
      search_(mesh_, faces_)
  {
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (const Index x : triangles_[t]) {
        around_[x].push_back(Index(t));
        dual_area_[x] += area_of_triangle(Index(t)) / 3;
      }
  }

  Surface_correspondence(const Surface_correspondence&) = delete; // its members refer to each other
  Surface_correspondence& operator=(const Surface_correspondence&) = delete;

  const Flat_mesh& mesh() const { return mesh_; }
  double area(Index f) const { return area_[f]; }
  Index cluster(Index f) const { return cluster_[f]; }
  const Vector& position(Index x) const { return position_[x]; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<Index>& around(Index x) const { return around_[x]; }
  std::size_t number_of_vertices() const { return position_.size(); }
  Bucketed_items<Index>::Range faces(Index x) const { return faces_[x]; }
  const Nearest_point_search& search() const { return search_; }

  // Returns a third of the area of the triangles around a vertex.
  double dual_area(Index x) const { return dual_area_[x]; }
  double area_of_triangle(Index t) const
  {
    const Vector n = normal_of(position_, triangles_[t]);
    return 0.5 * std::sqrt(dot(n, n));
  }
  Vector center(const std::array<Index, 2>& edge) const { return 0.5 * (position_[edge[0]] + position_[edge[1]]); }
  Vector center(const Triangle& t) const { return (1. / 3) * (position_[t[0]] + position_[t[1]] + position_[t[2]]); }

  // Returns the nearest point to each coarse vertex.
  const std::vector<Nearest_point>& sources()
  {
    if (sources_.empty())
      for (std::size_t x = 0; x < position_.size(); ++x)
        sources_.push_back(search_(position_[x], Index(x)));
    return sources_;
  }

  // Returns the point nearest to the center of an edge or a triangle, within the clusters of its ends or corners.
  // Closer points on the other side of a thin sheet do not correspond to it.
  template <class Clusters>
  Nearest_point triangle_source(const Clusters& clusters) const
  {
    const Vector p = center(clusters);
    Nearest_point nearest;
    for (const Index x : clusters)
      search_.improve_in(p, x, nearest);
    return nearest.face == NONE ? search_(p, clusters[0]) : nearest;
  }

  const std::vector<Nearest_point>& triangle_sources()
  {
    if (triangle_sources_.empty())
      for (const Triangle& t : triangles_)
        triangle_sources_.push_back(triangle_source(t));
    return triangle_sources_;
  }

  // Returns the nearest triangle to each face of the mesh, among the triangles around the vertex of its cluster; NONE if there
  // are none.
  const std::vector<Index>& triangles_of_faces()
  {
    if (triangle_of_face_.empty())
      for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f)
        triangle_of_face_.push_back(cluster_[f] == NONE ? NONE : nearest_around(cluster_[f], centroid_[f]));
    return triangle_of_face_;
  }

  // Returns the vertex that receives the values to be distributed over the dual cell of `x`: `x`, or the first vertex with
  // an area found from `x`. Depends on the arguments only.
  Index vertex_with_area(Index x) const
  {
    if (dual_area_[x] > 0)
      return x;
    std::vector<Index> queue(1, x);
    std::vector<bool> seen;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      if (dual_area_[queue[i]] > 0)
        return queue[i];
      seen.resize(position_.size(), false);
      seen[x] = true;
      for (const Index t : around_[queue[i]])
        for (const Index y : triangles_[t])
          if (!seen[y]) {
            seen[y] = true;
            queue.push_back(y);
          }
    }
    return x;
  }

private:
  Index nearest_around(Index x, const Vector& p) const
  {
    Index nearest = NONE;
    double least = 0;
    for (const Index t : around_[x]) {
      const Triangle& corners = triangles_[t];
      const double d =
        closest_on_triangle(p, position_[corners[0]], position_[corners[1]], position_[corners[2]]).squared_distance;
      if (nearest == NONE || d < least) {
        nearest = t;
        least = d;
      }
    }
    return nearest;
  }

  Flat_mesh mesh_;
  std::vector<double> area_;
  std::vector<Vector> centroid_;
  std::vector<Index> cluster_;
  std::vector<Vector> position_;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<Index> > around_;
  std::vector<double> dual_area_;
  Bucketed_items<Index> faces_; // per cluster
  Nearest_point_search search_;
  // Computed on demand:
  std::vector<Nearest_point> sources_, triangle_sources_;
  std::vector<Index> triangle_of_face_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_SURFACE_CORRESPONDENCE_H
