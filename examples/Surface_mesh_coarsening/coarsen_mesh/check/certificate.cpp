// SPDX-License-Identifier: GPL-3.0-or-later

#include "check/certificate.h"

#include "check/soup_fault.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <array>
#include <limits>

namespace coarsening_support {
namespace {

std::size_t component_of_edge(const Mesh& mesh, const std::vector<std::size_t>& of_face, Halfedge h)
{
  return of_face[mesh.is_border(h) ? mesh.face(mesh.opposite(h)) : mesh.face(h)];
}

void count_border_loops(const Mesh& mesh, Mesh_components& components)
{
  std::vector<bool> walked(mesh.num_halfedges(), false);
  for (Halfedge start : mesh.halfedges()) {
    if (!mesh.is_border(start) || walked[start])
      continue;
    ++components.counts[component_of_edge(mesh, components.of_face, start)].border_loops;
    for (Halfedge h = start; !walked[h]; h = mesh.next(h))
      walked[h] = true;
  }
}

using Triple = std::array<std::size_t, 3>;

// Rotates the triple so that its smallest number comes first.
Triple turned_to_smallest(Triple t)
{
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

// Returns the labels around an inner vertex, in the order of the faces' orientation, if there are three.
std::optional<Triple> triple_point(const Mesh& mesh, Vertex v, const std::vector<std::size_t>& labels)
{
  std::vector<std::size_t> runs;
  for (Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v))) {
    if (mesh.is_border(h))
      return std::nullopt;
    const std::size_t label = labels[mesh.face(h)];
    if (runs.empty() || runs.back() != label)
      runs.push_back(label);
  }
  if (runs.size() > 1 && runs.front() == runs.back())
    runs.pop_back();
  if (runs.size() != 3 || runs[0] == runs[2])
    return std::nullopt;
  return Triple{runs[2], runs[1], runs[0]}; // the circulator is opposite to the faces' orientation
}

// Returns whether most triangles of each component of the coarse mesh are oriented like the input where their three clusters
// meet. In a reversed component, all have the opposite orientation; in a correct one, flips of edges may move triangles, and
// may reverse one where three clusters lie around a handle.
bool is_orientation_kept(const Mesh& input, const std::vector<std::size_t>& labels, const Mesh& output,
                                const Mesh_components& components)
{
  std::vector<Triple> triangles;
  for (const auto& p : to_soup(output).polygons)
    if (p.size() == 3)
      triangles.push_back(turned_to_smallest({p[0], p[1], p[2]}));
  std::sort(triangles.begin(), triangles.end());
  const auto is_there = [&triangles](const Triple& t) {
    return std::binary_search(triangles.begin(), triangles.end(), turned_to_smallest(t));
  };
  std::vector<std::ptrdiff_t> facing(components.counts.size(), 0);
  for (Vertex v : input.vertices()) {
    const auto t = input.is_isolated(v) ? std::nullopt : triple_point(input, v, labels);
    if (!t || (*t)[0] >= components.of_vertex.size() || components.of_vertex[(*t)[0]] >= facing.size())
      continue;
    facing[components.of_vertex[(*t)[0]]] += is_there(*t) ? 1 : is_there({(*t)[0], (*t)[2], (*t)[1]}) ? -1 : 0;
  }
  return std::all_of(facing.begin(), facing.end(), [](std::ptrdiff_t n) { return n >= 0; });
}

} // namespace

Mesh_components mesh_components(const Mesh& mesh)
{
  Mesh_components result;
  const auto map = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  const std::size_t n = CGAL::Polygon_mesh_processing::connected_components(mesh, map);
  result.counts.resize(n);
  result.of_face.resize(mesh.num_faces());
  result.of_vertex.assign(mesh.num_vertices(), n); // n denotes an isolated vertex
  for (Face f : mesh.faces()) {
    result.of_face[f] = get(map, f);
    ++result.counts[get(map, f)].faces;
  }
  for (Edge e : mesh.edges())
    ++result.counts[component_of_edge(mesh, result.of_face, mesh.halfedge(e))].edges;
  for (Vertex v : mesh.vertices())
    if (!mesh.is_isolated(v)) {
      result.of_vertex[v] = component_of_edge(mesh, result.of_face, mesh.halfedge(v));
      ++result.counts[result.of_vertex[v]].vertices;
    }
  count_border_loops(mesh, result);
  return result;
}

Soup to_soup(const Mesh& mesh)
{
  Soup soup;
  soup.points.assign(mesh.points().begin(), mesh.points().end());
  soup.polygons.reserve(mesh.num_faces(), mesh.num_halfedges());
  for (Face f : mesh.faces()) {
    for (Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      soup.polygons.add_corner(v);
    soup.polygons.end_polygon();
  }
  return soup;
}

std::optional<std::string> triangle_mesh_fault(const Mesh& mesh)
{
  for (Vertex v : mesh.vertices())
    if (mesh.is_isolated(v))
      return "vertex " + std::to_string(static_cast<std::size_t>(v)) + " has no face";
  const Soup soup = to_soup(mesh);
  std::vector<Triple> triples;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    const auto& p = soup.polygons[f];
    if (p.size() != 3)
      return "face " + std::to_string(f) + " is not a triangle";
    triples.push_back({p[0], p[1], p[2]});
    std::sort(triples.back().begin(), triples.back().end());
  }
  std::sort(triples.begin(), triples.end());
  const auto twice = std::adjacent_find(triples.begin(), triples.end());
  if (twice != triples.end())
    return "two faces stand on the same vertices " + std::to_string((*twice)[0]) + ", " + std::to_string((*twice)[1]) +
           " and " + std::to_string((*twice)[2]);
  return soup_fault(soup);
}

Certificate certify(const Mesh& input, const std::vector<std::size_t>& labels, const Mesh& output,
                    std::size_t dropped_components, bool faces_are_whole)
{
  const Mesh_components before = mesh_components(input), after = mesh_components(output);
  const std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::vector<std::size_t> partner(before.counts.size(), none), source(after.counts.size(), none);
  std::vector<bool> dropped(before.counts.size(), true);
  Certificate result;
  for (Face f : input.faces()) {
    if (labels[f] != output.number_of_vertices())
      dropped[before.of_face[f]] = false;
    if (labels[f] >= after.of_vertex.size() || after.of_vertex[labels[f]] >= after.counts.size())
      continue;
    const std::size_t b = before.of_face[f], a = after.of_vertex[labels[f]];
    result.one_to_one =
      result.one_to_one && (partner[b] == none || partner[b] == a) && (source[a] == none || source[a] == b);
    partner[b] = a;
    source[a] = b;
  }
  result.one_to_one = result.one_to_one && std::count(source.begin(), source.end(), none) == 0 &&
                      std::size_t(std::count(dropped.begin(), dropped.end(), true)) == dropped_components;
  for (std::size_t b = 0; b < before.counts.size(); ++b) {
    result.components.push_back({before.counts[b], std::nullopt, dropped[b]});
    if (partner[b] != none)
      result.components.back().after = after.counts[partner[b]];
  }
  result.orientation_kept = !faces_are_whole || is_orientation_kept(input, labels, output, after);
  return result;
}

} // namespace coarsening_support
