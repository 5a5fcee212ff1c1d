// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_MAKE_SURFACE_CORRESPONDENCE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_MAKE_SURFACE_CORRESPONDENCE_H

#include <CGAL/Surface_mesh_coarsening/internal/transfer/Surface_correspondence.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/face_geometry.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

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

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_MAKE_SURFACE_CORRESPONDENCE_H
