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

namespace CGAL::Surface_mesh_coarsening::internal {

struct Clustered_arrays
{
  Flat_mesh mesh;
  std::vector<double> area;
  std::vector<Vector> centroid;
  std::vector<Index> cluster; // per face; NONE if it corresponds to nothing
  Local_frame frame;
};

template <class FaceGraph, class NamedParameters, class FaceClusterMap, class CoarseNumbering>
Clustered_arrays clustered_arrays(const FaceGraph& mesh, const NamedParameters& np, const Numbering<FaceGraph>& n,
                                  const FaceClusterMap& map, const CoarseNumbering& coarse)
{
  Clustered_arrays result;
  result.mesh = flat_connectivity(mesh, n);
  if (n.faces.empty() || coarse.faces.empty())
    throw Invalid_input("there is nothing to transfer between meshes of which one has no faces");
  result.frame = copy_points(mesh, np, n, result.mesh);
  for (std::size_t f = 0; f < n.faces.size(); ++f) {
    const Face_geometry g = face_geometry(result.mesh, Index(f));
    result.area.push_back(g.area);
    result.centroid.push_back(g.centroid);
    const std::size_t x = std::size_t(get(map, n.faces[f])), clusters = coarse.vertices.size();
    if (x > clusters)
      throw Invalid_input("the cluster of face " + std::to_string(f) + " is " + std::to_string(x) + ", but the coarse mesh has " +
                          std::to_string(clusters) + " vertices");
    result.cluster.push_back(x == clusters ? NONE : Index(x));
  }
  if (std::all_of(result.cluster.begin(), result.cluster.end(), [](Index x) { return x == NONE; }))
    throw Invalid_input("no face has a cluster");
  return result;
}

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
  const auto coordinates = vertex_coordinates(mesh, np);
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

// A clustered mesh and its coarse mesh in arrays, and the correspondence between their elements.
class Surface_correspondence : public Clustered_arrays
{
public:
  template <class CoarseFaceGraph, class NamedParameters>
  Surface_correspondence(Clustered_arrays clustered, const CoarseFaceGraph& coarse, const Numbering<CoarseFaceGraph>& n,
                         const NamedParameters& np)
    : Clustered_arrays(std::move(clustered)), position_(points_in_frame(coarse, np, n, frame)),
      triangles_(numbered_triangles(coarse, n)), around_(position_.size()), dual_area_(position_.size(), 0),
      faces_(numbers_below(Index(cluster.size())), position_.size(), [this](Index f) { return cluster[f]; }),
      search_(mesh, faces_)
  {
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (const Index x : triangles_[t]) {
        around_[x].push_back(Index(t));
        dual_area_[x] += 0.5 * length(normal_of(position_, triangles_[t])) / 3;
      }
  }

  Surface_correspondence(const Surface_correspondence&) = delete; // its members refer to each other
  Surface_correspondence& operator=(const Surface_correspondence&) = delete;

  const std::vector<Vector>& positions() const { return position_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<Index>& around(Index x) const { return around_[x]; }
  Bucketed_items<Index>::Range faces(Index x) const { return faces_[x]; }
  const Nearest_point_search& search() const { return search_; }

  // Returns a third of the area of the triangles around a vertex.
  double dual_area(Index x) const { return dual_area_[x]; }
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
      for (std::size_t f = 0; f < cluster.size(); ++f)
        triangle_of_face_.push_back(cluster[f] == NONE ? NONE : nearest_around(cluster[f], centroid[f]));
    return triangle_of_face_;
  }

  // Returns the vertex that receives the values to be distributed over the dual cell of `x`: `x`, or the first vertex with
  // an area found from `x`. Depends on the arguments only.
  Index vertex_with_area(Index x) const
  {
    if (dual_area_[x] > 0)
      return x;
    std::vector<Index> queue(1, x);
    std::vector<bool> seen(position_.size(), false);
    seen[x] = true;
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (const Index t : around_[queue[i]])
        for (const Index y : triangles_[t]) {
          if (seen[y])
            continue;
          if (dual_area_[y] > 0)
            return y;
          seen[y] = true;
          queue.push_back(y);
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
    : surfaces_(surfaces), mesh_(surfaces.mesh), is_seam_(is_seam), stamp_(mesh_.number_of_faces(), NONE),
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
      const auto [found, is_new] = nearest_in_sector.emplace(sector, Nearest_point());
      if (is_new)
        found->second = nearest_in(x, is_cut ? sector : NONE);
      visit(t, found->second);
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
      for (const Index c : mesh_.corners(f))
        is_cut = is_cut || (is_seam_[c] && mesh_.face_across[c] != NONE && stamp_[mesh_.face_across[c]] == x);
    if (!is_cut)
      return false;
    Index sectors = 0;
    for (const Index first : faces_) {
      if (sector_[first] != NONE)
        continue;
      sector_[first] = sectors;
      flood_fill(mesh_, first, reached_, Run_context(), [&](Index c, Index g) {
        const bool is_new = !is_seam_[c] && stamp_[g] == x && sector_[g] == NONE;
        if (is_new)
          sector_[g] = sectors;
        return is_new;
      });
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
        improve(mesh_, surfaces_.positions()[x], f, nearest);
    return nearest.face == NONE ? surfaces_.search()(surfaces_.positions()[x], x) : nearest;
  }

  Surface_correspondence& surfaces_;
  const Flat_mesh& mesh_;
  const std::vector<bool>& is_seam_;
  std::vector<Index> stamp_, sector_; // per face
  std::vector<Index> faces_, reached_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_SURFACE_CORRESPONDENCE_H
