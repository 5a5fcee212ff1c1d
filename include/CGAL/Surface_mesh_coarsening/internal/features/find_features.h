// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FIND_FEATURES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FIND_FEATURES_H

#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/Run_context.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

struct Feature_edges;

// The features that the caller requests, except the borders of patches.
struct Feature_request
{
  struct Edge
  {
    Index face, corner; // the edge from the corner to the next corner
  };
  double angle = 180; // in degrees
  std::vector<Edge> edges;
  std::vector<Index> corners;
};

// Finds the features of the faces; returns null if there are none. `patches` is empty or holds the patch of each face of the
// caller's mesh.
std::shared_ptr<const Feature_edges> find_features(const Clustering_input& input, const Feature_request& request,
                                                   const std::vector<long long>& patches);

std::vector<Index> corners_of(const Feature_edges& edges);

// Replaces the items by cells that keep the features.
void make_cells(Featured_input& input, const Feature_edges& edges, const Run_context& context);

// Reads the patch of each face of the caller's mesh; empty if there is no map.
template <class FaceGraph, class PatchMap>
std::vector<long long> read_patches(const Numbering<FaceGraph>& n, const PatchMap& map)
{
  std::vector<long long> patches;
  patches.reserve(n.faces.size());
  for (const auto f : n.faces)
    patches.push_back(static_cast<long long>(get(map, f)));
  return patches;
}
template <class FaceGraph>
std::vector<long long> read_patches(const Numbering<FaceGraph>&, const CGAL::internal_np::Param_not_found&)
{
  return {};
}

// Reads the marked edges, each as the corner of a face where it begins.
template <class FaceGraph, class EdgeMap>
std::vector<Feature_request::Edge> read_edges(const FaceGraph& mesh, const Numbering<FaceGraph>& n,
                                              const Clustering_input& input, const EdgeMap& map)
{
  std::vector<Feature_request::Edge> edges;
  for (std::size_t f = 0; f < input.mesh.number_of_faces(); ++f)
    for (const auto h : halfedges_around_face(halfedge(n.faces[f], mesh), mesh))
      if (get(map, edge(h, mesh)))
        edges.push_back({Index(f), input.mesh.corner_of(Index(f), n.number_of(source(h, mesh)))});
  return edges;
}
template <class FaceGraph>
std::vector<Feature_request::Edge> read_edges(const FaceGraph&, const Numbering<FaceGraph>&, const Clustering_input&,
                                              const CGAL::internal_np::Param_not_found&)
{
  return {};
}

// Reads the marked vertices.
template <class FaceGraph, class VertexMap>
std::vector<Index> read_corners(const Numbering<FaceGraph>& n, const VertexMap& map)
{
  std::vector<Index> corners;
  for (std::size_t v = 0; v < n.vertices.size(); ++v)
    if (get(map, n.vertices[v]))
      corners.push_back(Index(v));
  return corners;
}
template <class FaceGraph>
std::vector<Index> read_corners(const Numbering<FaceGraph>&, const CGAL::internal_np::Param_not_found&)
{
  return {};
}

// Stores the coordinates of the corners in the frame, which converts them back without rounding.
template <class FaceGraph, class NamedParameters>
void keep_exact_corners(const FaceGraph& mesh, const NamedParameters& np, const Numbering<FaceGraph>& n,
                        const std::vector<Index>& corners, const Flat_mesh& m, Local_frame& frame)
{
  const auto coordinates = vertex_coordinates(mesh, np);
  auto exact = std::make_shared<Exact_points>();
  for (const Index v : corners)
    exact->emplace_back(m.points[v], coordinates(n.vertices[v]));
  std::sort(exact->begin(), exact->end());
  frame.exact = exact;
}

// Prepares the input for the features that the parameters request, if any. `patches` receives the patches of the faces.
template <class FaceGraph, class NamedParameters>
void read_features(const FaceGraph& mesh, const NamedParameters& np, const Numbering<FaceGraph>& n, Featured_input& input,
                   Local_frame& frame, std::vector<long long>& patches, const Run_context& context)
{
  Feature_request request;
  request.angle = choose_parameter(get_parameter(np, internal_np::feature_angle_p), Coarsening_defaults::feature_angle);
  if (!(request.angle >= 0 && request.angle <= 180))
    throw Invalid_input("the feature angle is " + number_text(request.angle) + " degrees, not in [0, 180]");
  patches = read_patches(n, get_parameter(np, CGAL::internal_np::face_patch));
  if (request.angle == 180 && patches.empty() && !has_parameter<CGAL::internal_np::edge_is_constrained_t, NamedParameters> &&
      !has_parameter<CGAL::internal_np::vertex_is_constrained_t, NamedParameters>)
    return;
  request.edges = read_edges(mesh, n, input.items, get_parameter(np, CGAL::internal_np::edge_is_constrained));
  request.corners = read_corners(n, get_parameter(np, CGAL::internal_np::vertex_is_constrained));
  const std::shared_ptr<const Feature_edges> edges = find_features(input.items, request, patches);
  if (!edges)
    return;
  keep_exact_corners(mesh, np, n, corners_of(*edges), input.items.mesh, frame);
  make_cells(input, *edges, context);
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#ifndef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#include <CGAL/Surface_mesh_coarsening/internal/features/find_features_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FIND_FEATURES_H
