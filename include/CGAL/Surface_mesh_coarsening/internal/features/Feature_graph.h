// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_GRAPH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_GRAPH_H

#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_edges.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// A feature line from corner to corner, or a loop. Its edges connect consecutive nodes.
struct Feature_line
{
  std::vector<Index> nodes; // including the corners at the ends; a loop lists each node once
  bool is_loop = false;
  // The number of its edges that must cross between clusters. With fewer crossings, its polyline would share an edge with
  // another polyline, or with itself.
  Index min_crossings = 1;

  std::size_t number_of_edges() const { return is_loop ? nodes.size() : nodes.size() - 1; }
};

// The vertices on feature lines: the nodes, corners first, then line by line.
class Feature_graph
{
public:
  Feature_graph(const Flat_mesh& m, const Feature_edges& edges) : node_of_vertex_(m.number_of_vertices(), NONE)
  {
    add_corners(m, edges);
    const Neighbors neighbors = edges.neighbors(m);
    for (Index i = 0; i < number_of_corners_; ++i)
      for (const Index next : neighbors[vertex_[i]])
        trace_from_corner(vertex_[i], next, neighbors);
    for (std::size_t v = 0; v < neighbors.size(); ++v)
      if (!neighbors[v].empty() && node_of_vertex_[v] == NONE)
        trace_loop(Index(v), neighbors);
    apportion_crossings(m);
  }

  std::size_t number_of_nodes() const { return vertex_.size(); }
  Index vertex(Index node) const { return vertex_[node]; }
  // Returns NONE if the vertex is not a node.
  Index node_of_vertex(Index v) const { return v < node_of_vertex_.size() ? node_of_vertex_[v] : NONE; }
  bool is_corner(Index node) const { return node < number_of_corners_; }
  std::size_t number_of_corners() const { return number_of_corners_; }
  const std::vector<Feature_line>& lines() const { return lines_; }

  // For a node that is not a corner: its line, and the nodes before and after it.
  Index line(Index node) const { return line_[node]; }
  Index before(Index node) const { return before_[node]; }
  Index after(Index node) const { return after_[node]; }

  // The first nodes of the lines that begin at a corner, other than corners.
  const std::vector<Index>& line_nodes_beside(Index corner) const { return beside_corner_[corner]; }

  // Returns whether every line has enough edges for its crossings.
  bool has_room() const
  {
    return std::all_of(lines_.begin(), lines_.end(),
                       [](const Feature_line& l) { return l.number_of_edges() >= l.min_crossings; });
  }

private:
  typedef std::vector<std::vector<Index> > Neighbors;

  void add_corners(const Flat_mesh& m, const Feature_edges& edges)
  {
    for (std::size_t v = 0; v < m.number_of_vertices(); ++v)
      if (edges.is_corner[v])
        add_node(Index(v), NONE);
    number_of_corners_ = Index(vertex_.size());
    beside_corner_.resize(number_of_corners_);
  }

  Index add_node(Index v, Index line)
  {
    node_of_vertex_[v] = Index(vertex_.size());
    vertex_.push_back(v);
    line_.push_back(line);
    before_.push_back(NONE);
    after_.push_back(NONE);
    return node_of_vertex_[v];
  }

  static Index other(const std::vector<Index>& pair, Index v) { return pair[0] == v ? pair[1] : pair[0]; }

  // Each line is traced from one end only; an edge between two corners is traced from the smaller corner.
  void trace_from_corner(Index corner, Index next, const Neighbors& neighbors)
  {
    const bool is_corner = node_of_vertex_[next] != NONE && node_of_vertex_[next] < number_of_corners_;
    if (is_corner ? next < corner : node_of_vertex_[next] != NONE)
      return;
    Feature_line line;
    line.nodes.push_back(node_of_vertex_[corner]);
    Index previous = corner, at = next;
    while (node_of_vertex_[at] == NONE) {
      line.nodes.push_back(add_node(at, Index(lines_.size())));
      const Index onward = other(neighbors[at], previous);
      previous = at;
      at = onward;
    }
    line.nodes.push_back(node_of_vertex_[at]);
    add_line(line);
  }

  void trace_loop(Index start, const Neighbors& neighbors)
  {
    Feature_line line;
    line.is_loop = true;
    line.nodes.push_back(add_node(start, Index(lines_.size())));
    Index previous = start, at = neighbors[start][0];
    while (at != start) {
      line.nodes.push_back(add_node(at, Index(lines_.size())));
      const Index onward = other(neighbors[at], previous);
      previous = at;
      at = onward;
    }
    add_line(line);
  }

  void add_line(const Feature_line& line)
  {
    const std::size_t n = line.nodes.size();
    for (std::size_t i = 0; i < n; ++i)
      if (!is_corner(line.nodes[i])) {
        before_[line.nodes[i]] = line.nodes[(i + n - 1) % n];
        after_[line.nodes[i]] = line.nodes[(i + 1) % n];
      }
    if (!line.is_loop && n > 2) {
      beside_corner_[line.nodes[0]].push_back(line.nodes[1]);
      beside_corner_[line.nodes[n - 1]].push_back(line.nodes[n - 2]);
    }
    lines_.push_back(line);
  }

  // A loop becomes at least a triangle. Among several lines between two corners, at most one may become a single edge, and none
  // if a part of the border also connects the corners.
  void apportion_crossings(const Flat_mesh& m)
  {
    std::vector<std::tuple<Index, Index, std::size_t, Index> > ends;
    for (Index i = 0; i < number_of_corners_; ++i)
      if (m.is_on_border(vertex_[i])) {
        Index v = m.next_on_border(vertex_[i]);
        while (node_of_vertex_[v] == NONE)
          v = m.next_on_border(v);
        ends.emplace_back((std::min)(i, node_of_vertex_[v]), (std::max)(i, node_of_vertex_[v]), 0, NONE);
      }
    for (std::size_t l = 0; l < lines_.size(); ++l) {
      const Feature_line& line = lines_[l];
      if (line.is_loop || line.nodes.front() == line.nodes.back())
        lines_[l].min_crossings = 3;
      else
        ends.emplace_back((std::min)(line.nodes.front(), line.nodes.back()), (std::max)(line.nodes.front(), line.nodes.back()),
                          line.nodes.size(), Index(l));
    }
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 1; i < ends.size(); ++i)
      if (std::get<3>(ends[i]) != NONE && std::get<0>(ends[i]) == std::get<0>(ends[i - 1]) &&
          std::get<1>(ends[i]) == std::get<1>(ends[i - 1]))
        lines_[std::get<3>(ends[i])].min_crossings = 2;
  }

  Index number_of_corners_ = 0;
  std::vector<Index> vertex_, line_, before_, after_; // per node
  std::vector<Index> node_of_vertex_;
  std::vector<std::vector<Index> > beside_corner_;
  std::vector<Feature_line> lines_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_GRAPH_H
