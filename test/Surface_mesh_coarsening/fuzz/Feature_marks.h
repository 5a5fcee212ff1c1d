// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_FUZZ_FEATURE_MARKS_H
#define CGAL_SURFACE_MESH_COARSENING_FUZZ_FEATURE_MARKS_H

#include "Fuzz_bytes.h"
#include "build_mesh.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace fuzz {

// What is told about the features of a mesh, and what comes back about those of the output.
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

// What lines and regions have in common however fine they are.
struct Feature_topology
{
  std::vector<int> patches_of_regions;         // sorted
  std::vector<std::size_t> valences_of_corners; // sorted, where it is not 2
  std::size_t corners = 0;    // where lines end, meet or turn sharply, and those that are marked
  std::size_t components = 0; // of the lines
  long characteristic = 0;    // of the lines

  // Which turns are sharp is up to the library.
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
  return result + ", " + std::to_string(t.corners) + " corners, " + std::to_string(t.components) + " components, characteristic " +
         std::to_string(t.characteristic);
}

// The edges where a feature is. Those of the border are none.
inline std::set<Mesh::Edge_index> feature_edges(const Mesh& mesh, const Feature_marks& marks)
{
  std::set<Mesh::Edge_index> result;
  for (const auto e : mesh.edges())
    if (!mesh.is_border(e) && (marks.edges.at(e) || marks.patches.at(mesh.face(mesh.halfedge(e, 0))) !=
                                                      marks.patches.at(mesh.face(mesh.halfedge(e, 1)))))
      result.insert(e);
  return result;
}

inline Feature_topology feature_topology(const Mesh& mesh, const Feature_marks& marks)
{
  const std::set<Mesh::Edge_index> lines = feature_edges(mesh, marks);
  Feature_topology result;
  std::set<Mesh::Face_index> reached;
  for (const auto seed : mesh.faces()) {
    if (!reached.insert(seed).second)
      continue;
    result.patches_of_regions.push_back(marks.patches.at(seed));
    for (std::vector<Mesh::Face_index> stack(1, seed); !stack.empty();) {
      const Mesh::Face_index f = stack.back();
      stack.pop_back();
      for (const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
        const Mesh::Face_index g = mesh.face(mesh.opposite(h));
        if (g != Mesh::null_face() && !lines.count(mesh.edge(h)) && reached.insert(g).second)
          stack.push_back(g);
      }
    }
  }
  std::map<Mesh::Vertex_index, std::vector<Mesh::Vertex_index> > neighbors;
  for (const auto e : lines)
    for (int i = 0; i < 2; ++i)
      neighbors[mesh.vertex(e, i)].push_back(mesh.vertex(e, 1 - i));
  result.characteristic = long(neighbors.size()) - long(lines.size());
  for (const auto v : mesh.vertices()) {
    const auto star = neighbors.find(v);
    if (!mesh.is_isolated(v) && (marks.vertices.at(v) || (star != neighbors.end() && star->second.size() != 2)))
      ++result.corners;
  }
  std::set<Mesh::Vertex_index> on_lines;
  for (const auto& v : neighbors) {
    if (v.second.size() != 2)
      result.valences_of_corners.push_back(v.second.size());
    if (!on_lines.insert(v.first).second)
      continue;
    ++result.components;
    for (std::vector<Mesh::Vertex_index> stack(1, v.first); !stack.empty();) {
      const Mesh::Vertex_index x = stack.back();
      stack.pop_back();
      for (const auto y : neighbors[x])
        if (on_lines.insert(y).second)
          stack.push_back(y);
    }
  }
  std::sort(result.patches_of_regions.begin(), result.patches_of_regions.end());
  std::sort(result.valences_of_corners.begin(), result.valences_of_corners.end());
  return result;
}

} // namespace fuzz

#endif // CGAL_SURFACE_MESH_COARSENING_FUZZ_FEATURE_MARKS_H
