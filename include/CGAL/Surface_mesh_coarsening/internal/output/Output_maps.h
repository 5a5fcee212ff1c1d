// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_OUTPUT_MAPS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_OUTPUT_MAPS_H

#include <CGAL/Surface_mesh_coarsening/Surface_location.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Coarse_features.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Calls `visit(x, arc)` for the edges of feature lines: `arc` is the arc of the line in the cluster after cluster `x`.
template <class Visit>
void for_each_line_edge(const Coarse_features* features, const Visit& visit)
{
  if (!features)
    return;
  for (const Coarse_features::Line& line : features->lines()) {
    const std::size_t n = line.arcs.size();
    for (std::size_t i = line.is_loop ? 0 : 1; i < n; ++i)
      visit(line.arcs[(i + n - 1) % n].cluster, line.arcs[i]);
  }
}

// A coarse mesh with the features that it keeps.
struct Featured_output
{
  const std::vector<Triangle>& triangles; // in the order of the faces
  const Coarse_features* features;        // null without features
  const Featured_input& input;
  const Cluster_labels& labels;          // of the clustered mesh
  const std::vector<long long>& patches; // of the faces of the caller's mesh, or of all; if empty, regions are numbered instead
};

// Returns the face on the left of an edge; NONE on the border.
inline Index face_left_of(const Flat_mesh& m, Index source, Index target)
{
  for (const Index f : m.faces_around(source))
    if (m.corner_vertex[m.next_corner(f, m.corner_of(f, source))] == target)
      return f;
  return NONE;
}

// Returns a face for each triangle of a coarse mesh, whose edges may have been flipped and whose vertices may have been exchanged.
// The face of a triangle at a line is on the same side of the line. The other triangles have the face of their neighbor, or NONE if
// their component has no lines.
inline std::vector<Index> faces_of_triangles(const Featured_output& coarse, const Flat_mesh& pieces, std::size_t clusters)
{
  const std::vector<Triangle>& triangles = coarse.triangles;
  std::map<std::pair<Index, Index>, Index> face_at_side; // of a triangle, from one cluster to the next
  for_each_line_edge(coarse.features, [&](Index previous, const Coarse_features::Arc& arc) {
    // The line enters the next cluster here.
    face_at_side[{previous, arc.cluster}] = face_left_of(pieces, arc.vertices[0], arc.vertices[1]);
    face_at_side[{arc.cluster, previous}] = face_left_of(pieces, arc.vertices[1], arc.vertices[0]);
  });
  std::vector<Index> face(triangles.size(), NONE), reached;
  for (std::size_t t = 0; t < face.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto found = face_at_side.find({triangles[t][i], triangles[t][(i + 1) % 3]});
      if (found != face_at_side.end())
        face[t] = found->second;
    }
    if (face[t] != NONE)
      reached.push_back(Index(t));
  }
  const auto source = [&](Index side) { return triangles[side / 3][side % 3]; };
  const std::vector<Index> opposite = opposite_sides(triangles.size(), clusters, source);
  for (std::size_t k = 0; k < reached.size(); ++k)
    for (Index side = 3 * reached[k]; side < 3 * reached[k] + 3; ++side) {
      const Index t = opposite[side] == NONE ? NONE : opposite[side] / 3;
      if (t == NONE || face[t] != NONE)
        continue;
      face[t] = face[reached[k]];
      reached.push_back(t);
    }
  return face;
}

// Returns the patches of the triangles of a coarse mesh: the patches of their faces. Lines separate patches.
inline std::vector<long long> patches_of_triangles(const Featured_output& coarse, std::size_t clusters)
{
  const Feature_cells* const cells = coarse.input.cells.get();
  const Clustering_input& pieces = cells ? cells->pieces() : coarse.input.items;
  std::vector<Index> face_of_cluster(clusters, NONE), regions; // regions between lines are the patches if none are given
  for (Index f = 0; f < pieces.mesh.number_of_faces(); ++f) {
    const Index label = coarse.labels[cells ? cells->polygon(f) : f];
    if (label < clusters)
      face_of_cluster[label] = f;
  }
  if (coarse.patches.empty() && cells) {
    regions.assign(cells->base().mesh.number_of_faces(), NONE);
    number_parts(cells->base().mesh, numbers_below(Index(regions.size())), regions, Run_context(),
                 [&](Index c, Index) { return !cells->edges().is_feature[c]; });
  }
  const std::vector<Index> faces = faces_of_triangles(coarse, pieces.mesh, clusters);
  std::vector<long long> result;
  for (std::size_t t = 0; t < faces.size(); ++t) {
    const Index f = faces[t] == NONE ? face_of_cluster[coarse.triangles[t][0]] : faces[t];
    result.push_back(!coarse.patches.empty() ? coarse.patches[coarse.patches.size() == 1 ? 0 : pieces.parent_of(f)]
                     : cells                 ? regions[cells->base_face(f)]
                                             : pieces.mesh.component[f]);
  }
  return result;
}

// Writes the maps that the parameters of the output request.
template <class Output, class NamedParameters>
void write_features(const Output& output, const NamedParameters& np, const Featured_output& coarse)
{
  typedef typename boost::graph_traits<Output>::vertex_descriptor Vertex;
  const std::vector<Vertex> v(vertices(output).begin(), vertices(output).end());
  const auto halfedge_between = [&](Index x, Index y) { return halfedge(v[x], v[y], output).first; };
  if constexpr (has_parameter<CGAL::internal_np::face_patch_t, NamedParameters>) {
    auto map = get_parameter(np, CGAL::internal_np::face_patch);
    typedef typename boost::property_traits<decltype(map)>::value_type Value;
    const std::vector<long long> patch = patches_of_triangles(coarse, v.size());
    for (std::size_t t = 0; t < patch.size(); ++t)
      put(map, face(halfedge_between(coarse.triangles[t][0], coarse.triangles[t][1]), output), static_cast<Value>(patch[t]));
  }
  if constexpr (has_parameter<CGAL::internal_np::edge_is_constrained_t, NamedParameters>) {
    auto map = get_parameter(np, CGAL::internal_np::edge_is_constrained);
    for (const auto e : edges(output))
      put(map, e, false);
    for_each_line_edge(coarse.features, [&](Index previous, const Coarse_features::Arc& arc) {
      put(map, edge(halfedge_between(previous, arc.cluster), output), true);
    });
  }
  if constexpr (has_parameter<CGAL::internal_np::vertex_is_constrained_t, NamedParameters>) {
    auto map = get_parameter(np, CGAL::internal_np::vertex_is_constrained);
    for (std::size_t i = 0; i < v.size(); ++i)
      put(map, v[i], coarse.features && coarse.features->corners()[i] != NONE);
  }
}

// Writes the cluster of each vertex of the input: among the clusters of the incident faces, the cluster of largest area there, and
// of equal areas the smallest number. Vertices without faces get `number`, the number of clusters.
template <class FaceGraph, class Map>
void write_vertex_clusters(const Numbering<FaceGraph>& numbering, const Clustering_input& input,
                           const std::vector<Index>& clusters, std::size_t number, const Map& map)
{
  if constexpr (is_given<Map>) {
    std::vector<std::pair<Index, double> > around;
    for (std::size_t v = 0; v < numbering.vertices.size(); ++v) {
      around.clear();
      for (const Index f : input.mesh.faces_around(v))
        around.emplace_back(clusters[f], input.area[f]);
      std::sort(around.begin(), around.end());
      Majority<Index> votes;
      for (const auto& [x, area] : around)
        votes.add(area, x);
      const Index selected = votes.empty() ? Index(number) : votes.value();
      put(map, numbering.vertices[v], typename boost::property_traits<Map>::value_type(selected));
    }
  }
}

// Throws Invalid_input if sources are requested and the output replaces the input.
template <class NamedParametersOut, class FaceGraph, class Output>
void check_input_stays(const FaceGraph& input, const Output& output)
{
  constexpr bool has_map = has_parameter<internal_np::vertex_source_t, NamedParametersOut>;
  if (has_map && static_cast<const void*>(&input) == static_cast<const void*>(&output))
    throw Invalid_input("a vertex_source_map was given, but the output is the input, which the sources would lie on");
}

// Writes the sources of the vertices on the input, if they are requested.
template <class Output, class FaceGraph, class Map>
void write_sources(const Output& output, std::vector<Surface_location<FaceGraph> > sources, const Map& map)
{
  if constexpr (is_given<Map>) {
    std::size_t i = 0;
    for (const auto v : vertices(output))
      put(map, v, std::move(sources[i++]));
  }
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_OUTPUT_MAPS_H
