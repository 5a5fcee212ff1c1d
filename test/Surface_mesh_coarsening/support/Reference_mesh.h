// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_TEST_REFERENCE_MESH_H
#define CGAL_SURFACE_MESH_COARSENING_TEST_REFERENCE_MESH_H

#include "generate_meshes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

// The oracle of the tests. It uses no header of the library.
namespace reference {

typedef std::vector<std::size_t> Labels;
typedef std::array<std::size_t, 3> Triangle;
constexpr std::size_t none = std::size_t(-1);

// The topology of a component, which determines compact oriented surfaces.
struct Topology
{
  std::size_t vertices = 0, edges = 0, faces = 0, loops = 0;
  long characteristic() const { return long(vertices) - long(edges) + long(faces); }
  long genus() const { return (2 - characteristic() - long(loops)) / 2; }
  bool same_surface_as(const Topology& t) const { return characteristic() == t.characteristic() && loops == t.loops; }
};

class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t n) : parent_(n)
  {
    for (std::size_t i = 0; i < n; ++i)
      parent_[i] = i;
  }
  std::size_t find(std::size_t x)
  {
    while (parent_[x] != x)
      x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  void unite(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

private:
  std::vector<std::size_t> parent_;
};

// A polygon mesh, oriented and 2-manifold, by its directed edges.
class Reference_mesh
{
public:
  struct Edge
  {
    std::size_t source, target, left, right; // `right` is none on the border
  };

  explicit Reference_mesh(const generated::Soup& soup) : soup_(soup), across_(soup.polygons.size())
  {
    std::unordered_map<std::uint64_t, std::size_t> left;
    for (std::size_t f = 0; f < polygons().size(); ++f)
      for_each_side(f, [&](std::size_t, std::size_t a, std::size_t b) {
        if (!left.insert({key(a, b), f}).second)
          throw std::logic_error("directed edge " + std::to_string(a) + " " + std::to_string(b) + " comes twice");
      });
    for (std::size_t f = 0; f < polygons().size(); ++f)
      for_each_side(f, [&](std::size_t, std::size_t a, std::size_t b) {
        const auto found = left.find(key(b, a));
        const std::size_t g = found == left.end() ? none : found->second;
        across_[f].push_back(g);
        if (g == none || f < g)
          edges_.push_back({a, b, f, g});
      });
    order_stars();
    find_components();
  }

  const generated::Soup& soup() const { return soup_; }
  const std::vector<generated::Polygon>& polygons() const { return soup_.polygons; }
  const std::vector<Edge>& edges() const { return edges_; }
  std::size_t number_of_faces() const { return soup_.polygons.size(); }
  std::size_t number_of_vertices() const { return soup_.points.size(); }
  // Returns the face across the `i`-th side, which leads from the `i`-th vertex to the next.
  std::size_t across(std::size_t f, std::size_t i) const { return across_[f][i]; }
  const std::vector<std::size_t>& faces_across(std::size_t f) const { return across_[f]; }
  // Returns the faces around a vertex, counterclockwise: around an inner vertex from its face of smallest number,
  // around a border vertex from the face whose border edge leaves the vertex.
  const std::vector<std::size_t>& star(std::size_t v) const { return star_[v]; }
  bool on_border(std::size_t v) const { return on_border_[v]; }
  const std::vector<std::size_t>& component() const { return component_; }
  const std::vector<Topology>& topologies() const { return topologies_; }

private:
  static std::uint64_t key(std::size_t a, std::size_t b) { return (std::uint64_t(a) << 32) | b; }

  template <class Function>
  void for_each_side(std::size_t f, const Function& function) const
  {
    const generated::Polygon& p = polygons()[f];
    for (std::size_t i = 0; i < p.size(); ++i)
      function(i, p[i], p[(i + 1) % p.size()]);
  }

  std::size_t place(std::size_t f, std::size_t v) const
  {
    const generated::Polygon& p = polygons()[f];
    return std::size_t(std::find(p.begin(), p.end(), v) - p.begin());
  }

  void order_stars()
  {
    std::vector<std::size_t> corners(number_of_vertices(), 0), first(number_of_vertices(), none);
    on_border_.assign(number_of_vertices(), false);
    star_.resize(number_of_vertices());
    for (std::size_t f = 0; f < number_of_faces(); ++f)
      for_each_side(f, [&](std::size_t i, std::size_t a, std::size_t) {
        ++corners[a];
        if (across_[f][i] == none) {
          on_border_[a] = true;
          first[a] = f;
        } else if (first[a] == none)
          first[a] = f;
      });
    for (std::size_t v = 0; v < number_of_vertices(); ++v) {
      std::size_t f = first[v];
      while (f != none && star_[v].size() < corners[v] && (star_[v].empty() || f != first[v])) {
        star_[v].push_back(f);
        const std::size_t degree = polygons()[f].size();
        f = across_[f][(place(f, v) + degree - 1) % degree];
      }
      if (star_[v].size() != corners[v])
        throw std::logic_error("vertex " + std::to_string(v) + " is not a manifold vertex");
    }
  }

  void find_components()
  {
    Disjoint_sets sets(number_of_faces()), loops(number_of_vertices());
    for (const Edge& e : edges_)
      if (e.right == none)
        loops.unite(e.source, e.target);
      else
        sets.unite(e.left, e.right);
    std::vector<std::size_t> number(number_of_faces(), none);
    component_.resize(number_of_faces());
    for (std::size_t f = 0; f < number_of_faces(); ++f) {
      std::size_t& n = number[sets.find(f)];
      if (n == none) {
        n = topologies_.size();
        topologies_.push_back({});
      }
      component_[f] = n;
      ++topologies_[n].faces;
    }
    for (const Edge& e : edges_)
      ++topologies_[component_[e.left]].edges;
    for (std::size_t v = 0; v < number_of_vertices(); ++v)
      if (!star_[v].empty()) {
        ++topologies_[component_[star_[v].front()]].vertices;
        if (on_border_[v] && loops.find(v) == v)
          ++topologies_[component_[star_[v].front()]].loops;
      }
  }

  generated::Soup soup_;
  std::vector<std::vector<std::size_t> > across_;
  std::vector<Edge> edges_;
  std::vector<std::vector<std::size_t> > star_;
  std::vector<bool> on_border_;
  std::vector<std::size_t> component_;
  std::vector<Topology> topologies_;
};

// The clusters of labels, numbered from 0 without gaps.
inline std::size_t number_of_clusters(const Labels& labels)
{
  return labels.empty() ? 0 : 1 + *std::max_element(labels.begin(), labels.end());
}

// Returns the boundary-edge count of each vertex: edges between two clusters or on the border.
inline std::vector<std::size_t> boundary_counts(const Reference_mesh& m, const Labels& labels)
{
  std::vector<std::size_t> count(m.number_of_vertices(), 0);
  for (const Reference_mesh::Edge& e : m.edges())
    if (e.right == none || labels[e.left] != labels[e.right]) {
      ++count[e.source];
      ++count[e.target];
    }
  return count;
}

// Describes why a cluster is no closed disc; empty if it is one. A set of faces of a 2-manifold, closed under edges and
// vertices, is a disc if it is a connected 2-manifold with border of Euler characteristic 1. It is a 2-manifold if the
// faces around each vertex form one fan: then the inner edges there are one less than the faces, or as many if the fan is
// closed.
inline std::string fault_of_discs(const Reference_mesh& m, const Labels& labels)
{
  const std::size_t n = number_of_clusters(labels);
  std::vector<long> characteristic(n, 0);
  std::vector<std::size_t> faces(n, 0);
  for (const std::size_t x : labels) {
    ++characteristic[x];
    ++faces[x];
  }
  for (std::size_t x = 0; x < n; ++x)
    if (faces[x] == 0)
      return "cluster " + std::to_string(x) + " is empty";
  Disjoint_sets sets(labels.size());
  std::vector<std::size_t> joins(n, 0);
  for (const Reference_mesh::Edge& e : m.edges()) {
    --characteristic[labels[e.left]];
    if (e.right == none)
      continue;
    if (labels[e.left] != labels[e.right])
      --characteristic[labels[e.right]];
    else if (sets.find(e.left) != sets.find(e.right)) {
      sets.unite(e.left, e.right);
      ++joins[labels[e.left]];
    }
  }
  for (std::size_t x = 0; x < n; ++x)
    if (joins[x] + 1 != faces[x])
      return "cluster " + std::to_string(x) + " is not connected";
  std::vector<std::pair<std::size_t, long> > fans; // cluster, and faces less inner edges, around a vertex
  for (std::size_t v = 0; v < m.number_of_vertices(); ++v) {
    const std::vector<std::size_t>& star = m.star(v);
    fans.clear();
    const auto entry = [&](std::size_t x) -> long& {
      for (auto& fan : fans)
        if (fan.first == x)
          return fan.second;
      fans.push_back({x, 0});
      return fans.back().second;
    };
    for (std::size_t i = 0; i < star.size(); ++i) {
      ++entry(labels[star[i]]);
      const bool last = i + 1 == star.size();
      if (!(last && m.on_border(v)) && labels[star[i]] == labels[star[last ? 0 : i + 1]])
        --entry(labels[star[i]]);
    }
    for (const auto& fan : fans) {
      if (fan.second > 1)
        return "cluster " + std::to_string(fan.first) + " touches itself at vertex " + std::to_string(v);
      ++characteristic[fan.first];
    }
  }
  for (std::size_t x = 0; x < n; ++x)
    if (characteristic[x] != 1)
      return "cluster " + std::to_string(x) + " has Euler characteristic " + std::to_string(characteristic[x]);
  return {};
}

// Returns the dual triangles by the rule of the package: where d >= 3 clusters meet, a fan from the cluster of the
// first face of the star.
inline std::vector<Triangle> dual_triangles(const Reference_mesh& m, const Labels& labels)
{
  std::vector<Triangle> triangles;
  std::vector<std::size_t> runs;
  for (std::size_t v = 0; v < m.number_of_vertices(); ++v) {
    runs.clear();
    for (const std::size_t f : m.star(v))
      if (runs.empty() || runs.back() != labels[f])
        runs.push_back(labels[f]);
    if (!m.on_border(v) && runs.size() > 1 && runs.front() == runs.back())
      runs.pop_back();
    for (std::size_t i = 2; i < runs.size(); ++i)
      triangles.push_back({runs[0], runs[i - 1], runs[i]});
  }
  return triangles;
}

// Checks whether triangles on vertices `0` to `n - 1` form a simplicial 2-manifold without isolated vertices.
class Triangle_surface
{
public:
  Triangle_surface(const std::vector<Triangle>& triangles, std::size_t n)
    : first_(n + 1, 0),
      next_on_border_(n, none),
      component_(n, none)
  {
    for (const Triangle& t : triangles)
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
        fault_ = "a triangle has a vertex twice";
        return;
      }
    gather_links(triangles);
    for (std::size_t a = 0; a < n && fault_.empty(); ++a)
      check_link(a);
    if (fault_.empty())
      find_components(triangles);
  }

  const std::string& fault() const { return fault_; }
  // If there is no fault:
  const std::vector<Topology>& topologies() const { return topologies_; }
  std::size_t component(std::size_t vertex) const { return component_[vertex]; }

private:
  // The sides opposite to each vertex, as pairs in the orientation of their triangles.
  void gather_links(const std::vector<Triangle>& triangles)
  {
    for (const Triangle& t : triangles)
      for (int i = 0; i < 3; ++i)
        ++first_[t[i] + 1];
    for (std::size_t i = 1; i < first_.size(); ++i)
      first_[i] += first_[i - 1];
    sides_.resize(3 * triangles.size());
    std::vector<std::size_t> at(first_.begin(), first_.end() - 1);
    for (const Triangle& t : triangles)
      for (int i = 0; i < 3; ++i)
        sides_[at[t[i]]++] = {t[(i + 1) % 3], t[(i + 2) % 3]};
  }

  // The link is one path or one cycle.
  void check_link(std::size_t a)
  {
    const auto begin = sides_.begin() + first_[a], end = sides_.begin() + first_[a + 1];
    const std::string name = "dual vertex " + std::to_string(a);
    if (begin == end) {
      fault_ = name + " is isolated";
      return;
    }
    const auto leaving = [&](std::size_t b) {
      return std::find_if(begin, end, [b](const auto& side) { return side.first == b; });
    };
    const auto arriving = [&](std::size_t b) {
      return std::find_if(begin, end, [b](const auto& side) { return side.second == b; });
    };
    auto start = begin;
    for (auto i = begin; i != end; ++i) {
      if (leaving(i->first) != i || arriving(i->second) != i) {
        fault_ = name + " has a repeated edge";
        return;
      }
      if (arriving(i->first) == end)
        start = i;
    }
    const bool is_path = arriving(start->first) == end;
    std::size_t length = 0;
    auto i = start;
    do {
      ++length;
      i = leaving(i->second);
    } while (i != end && i != start);
    if (length != std::size_t(end - begin) || (!is_path && length < 3))
      fault_ = name + " is not a manifold vertex";
    if (is_path)
      next_on_border_[a] = start->first;
  }

  void find_components(const std::vector<Triangle>& triangles)
  {
    const std::size_t n = component_.size();
    Disjoint_sets sets(n);
    for (const Triangle& t : triangles) {
      sets.unite(t[0], t[1]);
      sets.unite(t[1], t[2]);
    }
    for (std::size_t a = 0; a < n; ++a) {
      std::size_t& c = component_[sets.find(a)];
      if (c == none) {
        c = topologies_.size();
        topologies_.push_back({});
      }
      component_[a] = c;
      ++topologies_[c].vertices;
    }
    std::vector<std::size_t> corners(topologies_.size(), 0), border_edges(topologies_.size(), 0);
    for (const Triangle& t : triangles) {
      ++topologies_[component_[t[0]]].faces;
      corners[component_[t[0]]] += 3;
    }
    std::vector<bool> done(n, false);
    for (std::size_t a = 0; a < n; ++a) {
      if (next_on_border_[a] == none)
        continue;
      ++border_edges[component_[a]];
      topologies_[component_[a]].loops += !done[a];
      for (std::size_t b = a; !done[b]; b = next_on_border_[b])
        done[b] = true;
    }
    for (std::size_t c = 0; c < topologies_.size(); ++c)
      topologies_[c].edges = (corners[c] + border_edges[c]) / 2;
  }

  std::vector<std::size_t> first_;
  std::vector<std::pair<std::size_t, std::size_t> > sides_;
  std::vector<std::size_t> next_on_border_, component_;
  std::vector<Topology> topologies_;
  std::string fault_;
};

// Describes why triangles are no surface of the topology of the mesh, component by component; `component_of_vertex`
// maps each vertex to its component of the mesh.
inline std::string fault_of_surface(const Reference_mesh& m, const std::vector<Triangle>& triangles,
                                    const std::vector<std::size_t>& component_of_vertex)
{
  const Triangle_surface surface(triangles, component_of_vertex.size());
  if (!surface.fault().empty())
    return surface.fault();
  if (surface.topologies().size() != m.topologies().size())
    return "the dual has " + std::to_string(surface.topologies().size()) + " components";
  for (std::size_t a = 0; a < component_of_vertex.size(); ++a)
    if (!surface.topologies()[surface.component(a)].same_surface_as(m.topologies()[component_of_vertex[a]]))
      return "the component of dual vertex " + std::to_string(a) + " has another topology";
  return {};
}

// Describes why labels are no valid clustering: a cluster that is no closed disc, or a dual that is not a surface of
// the topology of the mesh.
inline std::string fault_of_clustering(const Reference_mesh& m, const Labels& labels)
{
  const std::string fault = fault_of_discs(m, labels);
  if (!fault.empty())
    return fault;
  std::vector<std::size_t> component(number_of_clusters(labels));
  for (std::size_t f = 0; f < labels.size(); ++f)
    component[labels[f]] = m.component()[f];
  return fault_of_surface(m, dual_triangles(m, labels), component);
}

} // namespace reference

#endif // CGAL_SURFACE_MESH_COARSENING_TEST_REFERENCE_MESH_H
