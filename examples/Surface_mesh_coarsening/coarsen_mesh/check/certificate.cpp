// SPDX-License-Identifier: GPL-3.0-or-later

#include "check/certificate.h"

#include "check/soup_fault.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

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
using Ring = std::vector<std::size_t>; // neighbors in the order of the faces' orientation

// The neighbors of the clusters. The border counts as the neighbor `border`. A cluster whose boundary is not one loop has none.
std::vector<Ring> rings_of_clusters(const Mesh& mesh, const std::vector<std::size_t>& labels, std::size_t border)
{
  const auto label = [&](Halfedge h) { return mesh.is_border(h) ? border : labels[mesh.face(h)]; };
  const auto is_boundary = [&](Halfedge h) { return label(h) != label(mesh.opposite(h)); };
  std::vector<Ring> rings(border);
  std::vector<std::size_t> loops(border, 0);
  std::vector<bool> walked(mesh.num_halfedges(), false);
  for (Halfedge start : mesh.halfedges()) {
    const std::size_t x = label(start);
    if (walked[start] || x >= border || !is_boundary(start))
      continue;
    ++loops[x];
    for (Halfedge h = start; !walked[h];) {
      walked[h] = true;
      rings[x].push_back(label(mesh.opposite(h)));
      for (h = mesh.next(h); !is_boundary(h);)
        h = mesh.next(mesh.opposite(h));
    }
  }
  for (std::size_t x = 0; x < border; ++x)
    if (loops[x] > 1)
      rings[x].clear();
  return rings;
}

Ring ring_of_vertex(const Mesh& mesh, Vertex v, std::size_t border)
{
  Ring ring;
  const Halfedge start = mesh.opposite(mesh.halfedge(v));
  Halfedge h = start;
  do {
    ring.push_back(mesh.target(h));
    if (mesh.is_border(h))
      ring.push_back(border);
    h = mesh.opposite(mesh.prev(h));
  } while (h != start);
  return ring;
}

// The neighbors that have one place in a ring, sorted, with their places.
std::vector<std::pair<std::size_t, std::size_t> > places(Ring ring)
{
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  if (ring.size() > 1 && ring.front() == ring.back())
    ring.pop_back();
  std::vector<std::pair<std::size_t, std::size_t> > all, single;
  for (std::size_t i = 0; i < ring.size(); ++i)
    all.emplace_back(ring[i], i);
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < all.size(); ++i)
    if ((i == 0 || all[i - 1].first != all[i].first) && (i + 1 == all.size() || all[i + 1].first != all[i].first))
      single.push_back(all[i]);
  return single;
}

// Returns k - 2 if k >= 2 common neighbors have the same cyclic order in both rings, -(k - 2) if the order is opposite, and a
// number in between for other orders.
std::ptrdiff_t agreement(const Ring& of_cluster, const Ring& of_vertex)
{
  const auto of_neighbor = places(of_cluster);
  std::vector<std::size_t> common;
  for (const std::size_t neighbor : of_vertex) {
    const auto found = std::lower_bound(of_neighbor.begin(), of_neighbor.end(), std::make_pair(neighbor, std::size_t(0)));
    if (found != of_neighbor.end() && found->first == neighbor)
      common.push_back(found->second);
  }
  std::ptrdiff_t result = 0;
  for (std::size_t i = 0; i < common.size(); ++i)
    result += common[i] < common[(i + 1) % common.size()] ? 1 : -1;
  return common.size() < 3 ? 0 : result;
}

Vector area_vector(const Mesh& mesh, Face f)
{
  const Halfedge first = mesh.halfedge(f);
  const Point& p = mesh.point(mesh.target(first));
  Vector sum(0, 0, 0);
  for (Halfedge h = mesh.next(first); mesh.next(h) != first; h = mesh.next(h))
    sum += CGAL::cross_product(mesh.point(mesh.target(h)) - p, mesh.point(mesh.target(mesh.next(h))) - p);
  return sum;
}

// Returns, for each component of the coarse mesh, whether the normals of its vertices point away from the normals of their
// clusters: the sum of the dot products is less than half of its least possible value.
std::vector<bool> have_opposite_normals(const Mesh& input, const std::vector<std::size_t>& labels, const Mesh& output,
                                        const Mesh_components& components)
{
  std::vector<Vector> of_cluster(output.number_of_vertices(), Vector(0, 0, 0)), of_vertex = of_cluster;
  for (Face f : input.faces())
    if (labels[f] < of_cluster.size())
      of_cluster[labels[f]] += area_vector(input, f);
  for (Face f : output.faces())
    for (Vertex v : output.vertices_around_face(output.halfedge(f)))
      of_vertex[v] += area_vector(output, f);
  std::vector<double> sum(components.counts.size(), 0), largest = sum;
  for (Vertex v : output.vertices())
    if (!output.is_isolated(v)) {
      sum[components.of_vertex[v]] += of_cluster[v] * of_vertex[v];
      largest[components.of_vertex[v]] += std::sqrt(of_cluster[v].squared_length() * of_vertex[v].squared_length());
    }
  std::vector<bool> result;
  for (std::size_t c = 0; c < sum.size(); ++c)
    result.push_back(sum[c] < -0.5 * largest[c]);
  return result;
}

// Returns, for each component of the coarse mesh, whether its vertices have their neighbors in the same cyclic order as the
// clusters in the input. The flip of an edge removes a neighbor from the rings of two vertices and adds one to the rings of two
// others, so it does not change the order of the neighbors that remain. An exchange of vertices does not either, since it removes
// a neighbor and adds it elsewhere. Hence three common neighbors show the orientation unless one of them left the ring
// and came back at another place; the sum over all vertices decides. Coordinates play no part then: flat, folded and intersecting
// surfaces are no exceptions. If no vertex has three common neighbors left, as on flat faces of few vertices, normals decide if
// they are clearly opposite; on crumpled surfaces, whose normals show nothing, they are not.
std::vector<bool> keep_orientation(const Mesh& input, const std::vector<std::size_t>& labels, const Mesh& output,
                                   const Mesh_components& components)
{
  const std::size_t border = output.number_of_vertices();
  const std::vector<Ring> rings = rings_of_clusters(input, labels, border);
  std::vector<std::ptrdiff_t> sum(components.counts.size(), 0);
  for (Vertex v : output.vertices())
    if (!output.is_isolated(v))
      sum[components.of_vertex[v]] += agreement(rings[v], ring_of_vertex(output, v, border));
  const std::vector<bool> are_opposite = have_opposite_normals(input, labels, output, components);
  std::vector<bool> result;
  for (std::size_t c = 0; c < sum.size(); ++c)
    result.push_back(sum[c] > 0 || (sum[c] == 0 && !are_opposite[c]));
  return result;
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
                    bool faces_are_whole)
{
  const Mesh_components before = mesh_components(input), after = mesh_components(output);
  const std::size_t none = (std::numeric_limits<std::size_t>::max)();
  std::vector<std::size_t> partner(before.counts.size(), none), source(after.counts.size(), none);
  Certificate result;
  for (Face f : input.faces()) {
    if (labels[f] >= after.of_vertex.size() || after.of_vertex[labels[f]] >= after.counts.size())
      continue;
    const std::size_t b = before.of_face[f], a = after.of_vertex[labels[f]];
    result.one_to_one =
      result.one_to_one && (partner[b] == none || partner[b] == a) && (source[a] == none || source[a] == b);
    partner[b] = a;
    source[a] = b;
  }
  result.one_to_one = result.one_to_one && std::count(source.begin(), source.end(), none) == 0;
  const std::vector<bool> keeps_orientation =
    faces_are_whole ? keep_orientation(input, labels, output, after) : std::vector<bool>(after.counts.size(), true);
  for (std::size_t b = 0; b < before.counts.size(); ++b) {
    result.components.push_back({before.counts[b], std::nullopt, true});
    if (partner[b] != none) {
      result.components.back().after = after.counts[partner[b]];
      result.components.back().orientation_kept = keeps_orientation[partner[b]];
    }
  }
  return result;
}

std::optional<std::string> Certificate::change() const
{
  if (!one_to_one)
    return "its components do not correspond to the components of the input one to one";
  for (std::size_t i = 0; i < components.size(); ++i) {
    const Pair& p = components[i];
    const std::string component = "component " + std::to_string(i);
    const auto changed = [&](const char* what, auto from, auto to) {
      return component + " has " + what + " " + std::to_string(to) + " instead of " + std::to_string(from);
    };
    if (!p.after)
      return component + " is missing";
    if (p.before.genus() != p.after->genus())
      return changed("genus", p.before.genus(), p.after->genus());
    if (p.before.border_loops != p.after->border_loops)
      return changed("number of border loops", p.before.border_loops, p.after->border_loops);
    if (!p.orientation_kept)
      return component + " is reversed";
  }
  return std::nullopt;
}

} // namespace coarsening_support
