// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_COARSE_FEATURES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_COARSE_FEATURES_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_cells.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The features in the dual of clusters that satisfy Feature_rules. Corners are vertices, and lines are polylines of the
// edges between the clusters that they cross.
class Coarse_features
{
public:
  // A part of a line in one cluster, as a polyline of vertices of the pieces of faces.
  struct Arc
  {
    Index cluster;
    std::vector<Index> vertices;
  };
  struct Line
  {
    std::vector<Arc> arcs; // unless the line is a loop, the first arc begins and the last arc ends at a corner
    bool is_loop = false;
  };

  // `labels` are the labels of the pieces.
  Coarse_features(const Feature_cells& cells, const Cluster_labels& labels, std::size_t clusters)
    : cells_(cells), labels_(labels), corner_of_(clusters, NONE)
  {
    const Feature_graph& graph = cells.graph();
    for (Index i = 0; i < graph.number_of_corners(); ++i)
      corner_of_[label(i)] = graph.vertex(i);
    for (const Feature_line& line : graph.lines())
      add_line(line);
    std::sort(edges_.begin(), edges_.end());
  }

  // The vertex at the corner of each cluster; NONE without a corner.
  const std::vector<Index>& corners() const { return corner_of_; }
  const std::vector<Line>& lines() const { return lines_; }
  bool is_edge(Index x, Index y) const { return std::binary_search(edges_.begin(), edges_.end(), key(x, y)); }

private:
  static std::uint64_t key(Index x, Index y) { return (std::uint64_t((std::min)(x, y)) << 32) | (std::max)(x, y); }

  Index label(Index node) const
  {
    const Flat_mesh& m = cells_.pieces().mesh;
    return labels_[m.star[m.first_in_star[cells_.graph().vertex(node)]]];
  }

  void add_line(const Feature_line& line)
  {
    const std::size_t n = line.nodes.size();
    std::size_t begin = 0; // if the line is a loop, it begins at a crossing
    while (line.is_loop && begin < n && label(line.nodes[begin]) == label(line.nodes[(begin + n - 1) % n]))
      ++begin;
    Line coarse;
    coarse.is_loop = line.is_loop;
    for (std::size_t i = 0; i < n; ++i) {
      const Index node = line.nodes[(begin + i) % n];
      const bool has_previous = i > 0 || line.is_loop;
      const Index previous = has_previous ? line.nodes[(begin + i + n - 1) % n] : NONE;
      if (i == 0 || label(node) != label(previous)) {
        coarse.arcs.push_back({label(node), {}});
        if (has_previous)
          coarse.arcs.back().vertices.push_back(cells_.middle(previous, node));
      }
      coarse.arcs.back().vertices.push_back(cells_.graph().vertex(node));
      if (i + 1 == n && !line.is_loop)
        break;
      const Index next = line.nodes[(begin + i + 1) % n];
      if (label(next) != label(node)) {
        coarse.arcs.back().vertices.push_back(cells_.middle(node, next));
        edges_.push_back(key(label(node), label(next)));
      }
    }
    lines_.push_back(coarse);
  }

  const Feature_cells& cells_;
  const Cluster_labels& labels_;
  std::vector<Index> corner_of_;
  std::vector<Line> lines_;
  std::vector<std::uint64_t> edges_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_COARSE_FEATURES_H
