// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_FUZZ_FEATURE_MARKS_H
#define CGAL_SURFACE_MESH_COARSENING_FUZZ_FEATURE_MARKS_H

#include "Fuzz_bytes.h"
#include "build_mesh.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace fuzz {

// The features marked in a mesh, and the features reported for the output.
struct Feature_marks
{
  std::map<Mesh::Edge_index, bool> edges;
  std::map<Mesh::Vertex_index, bool> vertices;
  std::map<Mesh::Face_index, int> patches;

  explicit Feature_marks(const Mesh& mesh)
  {
    for (const auto e : mesh.edges())
      edges[e] = false;
    for (const auto v : mesh.vertices())
      vertices[v] = false;
    for (const auto f : mesh.faces())
      patches[f] = 0;
  }

  void mark(Bytes& bytes)
  {
    const std::size_t kinds = bytes.next();
    if (kinds % 2 == 1)
      for (auto& e : edges)
        e.second = bytes.next() % 4 == 3;
    if (kinds / 2 % 4 == 3)
      for (auto& v : vertices)
        v.second = bytes.next() % 16 == 15;
    if (kinds / 8 % 2 == 1)
      for (auto& p : patches)
        p.second = int(bytes.next() % 8) / 3;
  }
};

// The properties of lines and regions that do not depend on resolution.
struct Feature_topology
{
  std::vector<int> patches_of_regions;         // sorted
  std::vector<std::size_t> valences_of_corners; // sorted, where it is not 2
  std::size_t corners = 0;    // where lines end, meet or turn sharply, and marked ones
  std::size_t components = 0; // of the lines
  long characteristic = 0;    // of the lines

  // The library decides which turns are sharp.
  bool is_kept_in(const Feature_topology& t) const
  {
    return patches_of_regions == t.patches_of_regions && valences_of_corners == t.valences_of_corners &&
           corners <= t.corners && components == t.components && characteristic == t.characteristic;
  }
};

inline std::string to_string(const Feature_topology& t)
{
  std::string result = "regions";
  for (const int patch : t.patches_of_regions)
    result += ' ' + std::to_string(patch);
  result += ", valences";
  for (const std::size_t valence : t.valences_of_corners)
    result += ' ' + std::to_string(valence);
  return result + ", " + std::to_string(t.corners) + " corners, " + std::to_string(t.components) +
         " components, characteristic " + std::to_string(t.characteristic);
}

// Whether each edge is a feature. Border edges are not.
inline std::map<Mesh::Edge_index, bool> feature_edges(const Mesh& mesh, const Feature_marks& marks)
{
  std::map<Mesh::Edge_index, bool> result;
  for (const auto e : mesh.edges())
    result[e] = !mesh.is_border(e) && (marks.edges.at(e) || marks.patches.at(mesh.face(mesh.halfedge(e, 0))) !=
                                                              marks.patches.at(mesh.face(mesh.halfedge(e, 1))));
  return result;
}

inline Feature_topology feature_topology(const Mesh& mesh, const Feature_marks& marks)
{
  std::map<Mesh::Edge_index, bool> is_feature = feature_edges(mesh, marks);
  Feature_topology result;

  std::map<Mesh::Face_index, std::size_t> region;
  result.patches_of_regions.resize(CGAL::Polygon_mesh_processing::connected_components(
    mesh, boost::make_assoc_property_map(region),
    CGAL::parameters::edge_is_constrained_map(boost::make_assoc_property_map(is_feature))));
  for (const auto& r : region)
    result.patches_of_regions[r.second] = marks.patches.at(r.first);
  std::sort(result.patches_of_regions.begin(), result.patches_of_regions.end());

  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> lines(mesh.num_vertices());
  for (const auto& e : is_feature)
    if (e.second)
      add_edge(mesh.vertex(e.first, 0).idx(), mesh.vertex(e.first, 1).idx(), lines);
  std::size_t off_lines = 0; // removed vertices among them
  for (std::size_t i = 0; i < num_vertices(lines); ++i)
    off_lines += degree(i, lines) == 0;
  for (const auto v : mesh.vertices()) {
    const std::size_t valence = degree(v.idx(), lines);
    if (valence != 0 && valence != 2)
      result.valences_of_corners.push_back(valence);
    result.corners += !mesh.is_isolated(v) && (marks.vertices.at(v) || (valence != 0 && valence != 2));
  }
  std::sort(result.valences_of_corners.begin(), result.valences_of_corners.end());
  std::vector<std::size_t> component(num_vertices(lines));
  result.components = boost::connected_components(lines, component.data()) - off_lines;
  result.characteristic = long(num_vertices(lines) - off_lines) - long(num_edges(lines));
  return result;
}

} // namespace fuzz

#endif // CGAL_SURFACE_MESH_COARSENING_FUZZ_FEATURE_MARKS_H
