// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FIND_FEATURES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FIND_FEATURES_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The features that the caller requests.
struct Feature_request
{
  struct Edge
  {
    Index face, corner; // the edge from the corner to the next corner
  };
  double angle = 180; // in degrees
  std::vector<Edge> edges;
  std::vector<Index> corners;
  std::vector<long long> patches; // of the faces of the caller's mesh; empty if there is no map
};

// Replaces the items by cells that keep the features, if there are any, and returns the corners.
std::vector<Index> keep_features(Featured_input& input, const Feature_request& request, const Run_context& context);

// Reads the features that the parameters request. `m` is the mesh in arrays.
template <class FaceGraph, class NamedParameters>
Feature_request read_features(const FaceGraph& mesh, const NamedParameters& np, const Numbering<FaceGraph>& n, const Flat_mesh& m)
{
  Feature_request request;
  request.angle = choose_parameter(get_parameter(np, internal_np::feature_angle_p), Coarsening_defaults::feature_angle);
  if (!(request.angle >= 0 && request.angle <= 180))
    throw Invalid_input("the feature angle is " + number_text(request.angle) + " degrees, not in [0, 180]");
  if constexpr (has_parameter<CGAL::internal_np::face_patch_t, NamedParameters>)
    for (const auto f : n.faces)
      request.patches.push_back(static_cast<long long>(get(get_parameter(np, CGAL::internal_np::face_patch), f)));
  if constexpr (has_parameter<CGAL::internal_np::edge_is_constrained_t, NamedParameters>)
    for (std::size_t f = 0; f < n.faces.size(); ++f)
      for (const auto h : halfedges_around_face(halfedge(n.faces[f], mesh), mesh))
        if (get(get_parameter(np, CGAL::internal_np::edge_is_constrained), edge(h, mesh)))
          request.edges.push_back({Index(f), m.corner_of(Index(f), n.number_of(source(h, mesh)))});
  if constexpr (has_parameter<CGAL::internal_np::vertex_is_constrained_t, NamedParameters>)
    for (std::size_t v = 0; v < n.vertices.size(); ++v)
      if (get(get_parameter(np, CGAL::internal_np::vertex_is_constrained), n.vertices[v]))
        request.corners.push_back(Index(v));
  return request;
}

// Returns the coordinates of vertices with their points in `m`, for a frame that converts them back without rounding.
template <class FaceGraph, class NamedParameters>
std::shared_ptr<const Exact_points> exact_points(const FaceGraph& mesh, const NamedParameters& np, const Numbering<FaceGraph>& n,
                                                 const std::vector<Index>& vertices, const Flat_mesh& m)
{
  const auto coordinates = vertex_coordinates(mesh, np);
  auto exact = std::make_shared<Exact_points>();
  for (const Index v : vertices)
    exact->emplace_back(m.points[v], coordinates(n.vertices[v]));
  std::sort(exact->begin(), exact->end());
  return exact;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#ifndef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#include <CGAL/Surface_mesh_coarsening/internal/features/find_features_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FIND_FEATURES_H
