// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_SURFACE_CORRESPONDENCE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_SURFACE_CORRESPONDENCE_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Nearest_point_search.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
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
  double area_of_triangle(Index t) const { return 0.5 * length(normal_of(position_, triangles_[t])); }
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

// Returns the corners of the faces of a triangle mesh, in the order of the numbering.
template <class FaceGraph>
std::vector<Triangle> numbered_triangles(const FaceGraph& mesh, const Numbering<FaceGraph>& n)
{
  std::vector<Triangle> triangles;
  for (const auto f : n.faces) {
    std::vector<Index> corners;
    for (const auto h : halfedges_around_face(halfedge(f, mesh), mesh))
      corners.push_back(n.number_of(source(h, mesh)));
    if (corners.size() != 3)
      throw Invalid_input("face " + std::to_string(triangles.size()) + " of the coarse mesh has " +
                          std::to_string(corners.size()) + " sides");
    triangles.push_back({{corners[0], corners[1], corners[2]}});
  }
  return triangles;
}

// Returns the points of a mesh in the frame of another mesh.
template <class FaceGraph, class NamedParameters>
std::vector<Vector> points_in_frame(const FaceGraph& mesh, const NamedParameters& np, const Numbering<FaceGraph>& n,
                                    const Local_frame& frame)
{
  const Vertex_coordinates<FaceGraph, NamedParameters> coordinates(mesh, np);
  std::vector<Vector> positions;
  positions.reserve(n.vertices.size());
  for (const auto v : n.vertices) {
    const Vector q = coordinates(v);
    for (std::size_t i = 0; i < 3; ++i)
      if (!std::isfinite(q[i]))
        throw Invalid_input("coordinate " + std::to_string(i) + " of vertex " + std::to_string(positions.size()) +
                            " of the coarse mesh is " + std::to_string(q[i]));
    positions.push_back(frame.to_local(q));
  }
  return positions;
}

template <class FaceGraph, class FaceClusterMap, class NamedParameters1, class CoarseFaceGraph, class NamedParameters2>
Surface_correspondence make_surface_correspondence(const FaceGraph& mesh, const Numbering<FaceGraph>& n,
                                                   const FaceClusterMap& map, const NamedParameters1& np1,
                                                   const CoarseFaceGraph& coarse, const Numbering<CoarseFaceGraph>& coarse_n,
                                                   const NamedParameters2& np2)
{
  Flat_mesh m = flat_connectivity(mesh, n);
  if (n.faces.empty() || coarse_n.faces.empty())
    throw Invalid_input("there is nothing to transfer between meshes of which one has no faces");
  const Local_frame frame = copy_points(mesh, np1, n, m);
  std::vector<double> areas;
  std::vector<Vector> centroids;
  std::vector<Index> clusters;
  bool is_any = false;
  for (std::size_t f = 0; f < n.faces.size(); ++f) {
    const Face_geometry g = face_geometry(m, Index(f));
    areas.push_back(g.area);
    centroids.push_back(g.centroid);
    const std::size_t x = std::size_t(get(map, n.faces[f]));
    if (x > coarse_n.vertices.size())
      throw Invalid_input("the cluster of face " + std::to_string(f) + " is " + std::to_string(x) + ", but the coarse mesh has " +
                          std::to_string(coarse_n.vertices.size()) + " vertices");
    clusters.push_back(x == coarse_n.vertices.size() ? NONE : Index(x));
    is_any = is_any || clusters.back() != NONE;
  }
  if (!is_any)
    throw Invalid_input("no face has a cluster");
  return Surface_correspondence(std::move(m), std::move(areas), std::move(centroids), std::move(clusters),
                           points_in_frame(coarse, np2, coarse_n, frame), numbered_triangles(coarse, coarse_n));
}

// Finds the points from which the corners of coarse triangles take values if the values have seams.
//
// Around a coarse vertex, seams divide the faces of its cluster and of the adjacent clusters into sectors. A triangle
// there belongs to the sector of the face nearest to its center, and its corner takes the value at the nearest point of
// this sector. So all triangles on the same side of a seam have the same value at the vertex, and no value mixes the two
// sides.
class Chart_sectors
{
public:
  // `is_seam` states, for each corner of the mesh, whether the edge after it is a seam.
  Chart_sectors(Surface_correspondence& surfaces, const std::vector<bool>& is_seam)
    : surfaces_(surfaces), mesh_(surfaces.mesh()), is_seam_(is_seam), stamp_(mesh_.number_of_faces(), NONE),
      sector_(mesh_.number_of_faces(), NONE)
  {}

  // Calls `visit(triangle, nearest point)` for each triangle around a vertex.
  template <class Visit>
  void for_each_corner_at(Index x, const Visit& visit)
  {
    collect(x);
    const bool is_cut = number_sectors(x);
    std::map<Index, Nearest_point> nearest_in_sector;
    for (const Index t : surfaces_.around(x)) {
      const Index face = surfaces_.triangle_sources()[t].face;
      const Index sector = is_cut && stamp_[face] == x ? sector_[face] : 0;
      const auto found = nearest_in_sector.find(sector);
      visit(t, found != nearest_in_sector.end()
                 ? found->second
                 : nearest_in_sector.emplace(sector, nearest_in(x, is_cut ? sector : NONE)).first->second);
    }
  }

private:
  // Collects the faces of the cluster and of its neighbors.
  void collect(Index x)
  {
    std::vector<Index> clusters(1, x);
    for (const Index t : surfaces_.around(x))
      clusters.insert(clusters.end(), surfaces_.triangles()[t].begin(), surfaces_.triangles()[t].end());
    sort_unique(clusters);
    faces_.clear();
    for (const Index y : clusters)
      for (const Index f : surfaces_.faces(y)) {
        faces_.push_back(f);
        stamp_[f] = x;
        sector_[f] = NONE;
      }
  }

  // Returns whether there is a seam.
  bool number_sectors(Index x)
  {
    bool is_cut = false;
    for (const Index f : faces_)
      for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1] && !is_cut; ++c)
        is_cut = is_seam_[c] && mesh_.face_across[c] != NONE && stamp_[mesh_.face_across[c]] == x;
    if (!is_cut)
      return false;
    Index sectors = 0;
    for (const Index first : faces_) {
      if (sector_[first] != NONE)
        continue;
      sector_[first] = sectors;
      stack_.assign(1, first);
      while (!stack_.empty()) {
        const Index f = stack_.back();
        stack_.pop_back();
        for (const Index c : mesh_.corners(f)) {
          const Index g = mesh_.face_across[c];
          if (g != NONE && !is_seam_[c] && stamp_[g] == x && sector_[g] == NONE) {
            sector_[g] = sectors;
            stack_.push_back(g);
          }
        }
      }
      ++sectors;
    }
    return true;
  }

  // Searches all faces if the sector is NONE.
  Nearest_point nearest_in(Index x, Index sector) const
  {
    Nearest_point nearest;
    for (const Index f : faces_)
      if (sector == NONE || sector_[f] == sector)
        improve(mesh_, surfaces_.position(x), f, nearest);
    return nearest.face == NONE ? surfaces_.search()(surfaces_.position(x), x) : nearest;
  }

  Surface_correspondence& surfaces_;
  const Flat_mesh& mesh_;
  const std::vector<bool>& is_seam_;
  std::vector<Index> stamp_, sector_; // per face
  std::vector<Index> faces_, stack_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_SURFACE_CORRESPONDENCE_H
