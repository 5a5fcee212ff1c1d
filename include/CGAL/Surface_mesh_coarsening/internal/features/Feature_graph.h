// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_GRAPH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_GRAPH_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <CGAL/utility.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The feature edges inside a mesh, and the corners, where feature lines end or meet.
struct Feature_edges
{
  typedef std::vector<std::vector<Index> > Neighbors; // per vertex, along feature edges

  std::vector<char> is_feature; // for the edge after each corner of a face; equal for both faces of the edge
  std::vector<char> is_corner;  // per vertex

  explicit Feature_edges(const Flat_mesh& m)
    : is_feature(m.corner_vertex.size(), false), is_corner(m.number_of_vertices(), false) {}

  bool empty() const
  {
    return std::count(is_feature.begin(), is_feature.end(), true) + std::count(is_corner.begin(), is_corner.end(), true) == 0;
  }

  // Calls `visit(v, w)` for each feature edge with its ends.
  template <class Visit>
  void for_each_edge(const Flat_mesh& m, const Visit& visit) const
  {
    for (std::size_t f = 0; f < m.number_of_faces(); ++f)
      for (const Index c : m.corners(f))
        if (is_feature[c] && f < m.face_across[c])
          visit(m.corner_vertex[c], m.corner_vertex[m.next_corner(Index(f), c)]);
  }

  // Returns the ends of the feature edges at each vertex.
  Neighbors neighbors(const Flat_mesh& m) const
  {
    Neighbors neighbors(m.number_of_vertices());
    for_each_edge(m, [&](Index v, Index w) {
      neighbors[v].push_back(w);
      neighbors[w].push_back(v);
    });
    return neighbors;
  }

  // Returns the features after a subdivision that keeps the vertices. `old_corner` is, for the edge after each new corner, the
  // corner before the edge that contains it; NONE for new edges.
  Feature_edges cut(const Flat_mesh& pieces, const std::vector<Index>& old_corner) const
  {
    Feature_edges result(pieces);
    std::copy(is_corner.begin(), is_corner.end(), result.is_corner.begin());
    for (std::size_t i = 0; i < old_corner.size(); ++i)
      result.is_feature[i] = old_corner[i] != NONE && is_feature[old_corner[i]];
    return result;
  }
};

// A feature line from corner to corner, or a loop. Its edges connect consecutive nodes.
struct Feature_line
{
  std::vector<Index> nodes; // including the corners at the ends; a loop lists each node once
  bool is_loop = false;
  // The number of its edges that must cross between clusters. With fewer crossings, its polyline would share an edge with
  // another polyline, or with itself.
  Index min_crossings = 1;

  Index node(std::size_t i) const { return nodes[i % nodes.size()]; } // again the first after the last
  std::size_t number_of_edges() const { return is_loop ? nodes.size() : nodes.size() - 1; }
};

// The vertices on feature lines: the nodes, corners first, then line by line.
class Feature_graph
{
public:
  Feature_graph(const Flat_mesh& m, const Feature_edges& edges) : node_of_vertex_(m.number_of_vertices(), NONE)
  {
    for (std::size_t v = 0; v < m.number_of_vertices(); ++v)
      if (edges.is_corner[v])
        add_node(Index(v), NONE);
    number_of_corners_ = nodes_.size();
    beside_corner_.resize(number_of_corners_);
    const Feature_edges::Neighbors neighbors = edges.neighbors(m);
    for (Index i = 0; i < number_of_corners_; ++i)
      for (const Index next : neighbors[vertex(i)]) {
        // Each line is traced from one end only; an edge between two corners is traced from the smaller corner.
        const Index node = node_of_vertex_[next];
        if (node == NONE || (is_corner(node) && next >= vertex(i)))
          trace(vertex(i), next, neighbors);
      }
    for (std::size_t v = 0; v < neighbors.size(); ++v)
      if (!neighbors[v].empty() && node_of_vertex_[v] == NONE)
        trace(Index(v), neighbors[v][0], neighbors);
    apportion_crossings(m);
  }

  std::size_t number_of_nodes() const { return nodes_.size(); }
  Index vertex(Index node) const { return nodes_[node].vertex; }
  // Returns NONE if the vertex is not a node.
  Index node_of_vertex(Index v) const { return v < node_of_vertex_.size() ? node_of_vertex_[v] : NONE; }
  bool is_corner(Index node) const { return node < number_of_corners_; }
  std::size_t number_of_corners() const { return number_of_corners_; }
  const std::vector<Feature_line>& lines() const { return lines_; }

  // For a node that is not a corner: its line, and the nodes before and after it.
  Index line(Index node) const { return nodes_[node].line; }
  Index before(Index node) const { return nodes_[node].before; }
  Index after(Index node) const { return nodes_[node].after; }

  // The first nodes of the lines that begin at a corner, other than corners.
  const std::vector<Index>& line_nodes_beside(Index corner) const { return beside_corner_[corner]; }

  // Returns whether every line has enough edges for its crossings.
  bool has_room() const
  {
    return std::all_of(lines_.begin(), lines_.end(),
                       [](const Feature_line& l) { return l.number_of_edges() >= l.min_crossings; });
  }

private:
  struct Node
  {
    Index vertex, line, before, after;
  };

  Index add_node(Index v, Index line)
  {
    nodes_.push_back({v, line, NONE, NONE});
    return node_of_vertex_[v] = Index(nodes_.size() - 1);
  }

  // Traces a line from a corner, or a loop from any vertex.
  void trace(Index start, Index next, const Feature_edges::Neighbors& neighbors)
  {
    Feature_line line;
    line.is_loop = node_of_vertex_[start] == NONE;
    line.nodes.push_back(line.is_loop ? add_node(start, Index(lines_.size())) : node_of_vertex_[start]);
    Index previous = start, at = next;
    while (node_of_vertex_[at] == NONE) {
      line.nodes.push_back(add_node(at, Index(lines_.size())));
      previous = std::exchange(at, neighbors[at][neighbors[at][0] == previous]);
    }
    if (!line.is_loop)
      line.nodes.push_back(node_of_vertex_[at]);
    const std::size_t n = line.nodes.size();
    for (std::size_t i = 0; i < n; ++i)
      if (!is_corner(line.nodes[i])) {
        nodes_[line.nodes[i]].before = line.nodes[(i + n - 1) % n];
        nodes_[line.nodes[i]].after = line.nodes[(i + 1) % n];
      }
    if (!line.is_loop && n > 2) {
      beside_corner_[line.nodes[0]].push_back(line.nodes[1]);
      beside_corner_[line.nodes[n - 1]].push_back(line.nodes[n - 2]);
    }
    lines_.push_back(std::move(line));
  }

  // A loop becomes at least a triangle. Among several lines between two corners, at most one may become a single edge, and none
  // if a part of the border also connects the corners.
  void apportion_crossings(const Flat_mesh& m)
  {
    std::vector<std::tuple<std::pair<Index, Index>, std::size_t, Index> > lines_by_ends;
    for (Index i = 0; i < number_of_corners_; ++i)
      if (m.is_on_border(vertex(i))) {
        Index v = m.next_on_border(vertex(i));
        while (node_of_vertex_[v] == NONE)
          v = m.next_on_border(v);
        lines_by_ends.emplace_back(make_sorted_pair(i, node_of_vertex_[v]), 0, NONE);
      }
    for (std::size_t l = 0; l < lines_.size(); ++l) {
      const std::vector<Index>& nodes = lines_[l].nodes;
      if (lines_[l].is_loop || nodes.front() == nodes.back())
        lines_[l].min_crossings = 3;
      else
        lines_by_ends.emplace_back(make_sorted_pair(nodes.front(), nodes.back()), nodes.size(), Index(l));
    }
    std::sort(lines_by_ends.begin(), lines_by_ends.end());
    for (std::size_t i = 1; i < lines_by_ends.size(); ++i) {
      const auto& [ends, size, line] = lines_by_ends[i];
      if (line != NONE && ends == std::get<0>(lines_by_ends[i - 1]))
        lines_[line].min_crossings = 2;
    }
  }

  std::size_t number_of_corners_ = 0;
  std::vector<Node> nodes_;
  std::vector<Index> node_of_vertex_;
  std::vector<std::vector<Index> > beside_corner_;
  std::vector<Feature_line> lines_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_GRAPH_H
