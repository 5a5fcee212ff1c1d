// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_RULES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_RULES_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_cells.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The rules of features for clusters. A cluster contains either no cell of a feature, or the cells of one contiguous part of
// one line, or the cell of one corner with contiguous parts of lines that begin there. A line keeps the number of crossings
// between clusters that it needs. Clusters on a line must not reach the border, because the border would also determine the
// position of their vertex.
//
// Cells without a cluster count as separate clusters.
class Feature_rules
{
public:
  Feature_rules(const Feature_cells& cells, const Cluster_labels& labels)
    : cells_(cells), labels_(labels), crossings_(cells.graph().lines().size(), 0) {}

  const Feature_cells& cells() const { return cells_; }

  // Begins with the faces of whole components, without clusters.
  template <class FaceRange>
  void begin(const FaceRange& faces)
  {
    clusters_.clear();
    for (const Index f : faces)
      if (is_on_line(cells_.node(f))) {
        const Index line = cells_.graph().line(cells_.node(f));
        crossings_[line] = Index(cells_.graph().lines()[line].number_of_edges());
      }
  }

  // Begins with existing clusters.
  void count(std::size_t number_of_clusters)
  {
    clusters_.assign(number_of_clusters, Cluster());
    for (std::size_t f = 0; f < labels_.labels().size(); ++f)
      add(Index(f), labels_[Index(f)]);
    const Feature_graph& graph = cells_.graph();
    for (std::size_t l = 0; l < crossings_.size(); ++l) {
      const std::vector<Index>& nodes = graph.lines()[l].nodes;
      crossings_[l] = graph.lines()[l].is_loop && is_crossing(nodes.back(), nodes.front());
      for (std::size_t i = 1; i < nodes.size(); ++i)
        crossings_[l] += is_crossing(nodes[i - 1], nodes[i]);
    }
  }

  // Returns whether the face is part of a feature. Moves of other faces affect only their two clusters.
  bool is_on_feature(Index f) const { return cells_.node(f) != NONE; }

  // Returns whether face `f` may join the adjacent cluster `to`, and leave its cluster if it has one.
  bool may_take(Index f, Index to) const
  {
    const Cluster& target = cluster(to);
    const Index node = cells_.node(f);
    if (node == NONE)
      return target.nodes == 0 || !cells_.is_at_border(f) || target.corner_is_on_border;
    if (cells_.graph().is_corner(node) || (target.faces_at_border > 0 && !target.corner_is_on_border))
      return false;
    const Index line = cells_.graph().line(node);
    const int beside_target = nodes_beside(node, to), beside_source = nodes_beside(node, labels_[f]);
    return beside_target == (target.nodes > 0 ? 1 : 0) && beside_source < 2 &&
           int(crossings_[line]) + beside_source - beside_target >= int(cells_.graph().lines()[line].min_crossings);
  }

  // Records that face `f` will leave its cluster, if any, for cluster `to`; NONE stands for no cluster.
  void change(Index f, Index to)
  {
    const Index node = cells_.node(f), from = labels_[f];
    if (is_on_line(node)) {
      Index& crossings = crossings_[cells_.graph().line(node)];
      crossings = Index(int(crossings) + nodes_beside(node, from) - nodes_beside(node, to));
    } else if (node != NONE) {
      for (const Index other : cells_.graph().line_nodes_beside(node)) {
        Index& crossings = crossings_[cells_.graph().line(other)];
        const Index label = labels_[cells_.cell(other)];
        crossings += label != NONE && label == from;
        crossings -= label != NONE && label == to;
      }
    }
    remove(f, from);
    add(f, to);
  }

  // Returns the corner cell of a cluster; NONE without a corner.
  Index corner_cell(Index x) const { return x < clusters_.size() ? clusters_[x].corner_cell : NONE; }

private:
  struct Cluster
  {
    Index nodes = 0, faces_at_border = 0, corner_cell = NONE;
    bool corner_is_on_border = false;
  };

  const Cluster& cluster(Index x) const
  {
    static const Cluster none;
    return x < clusters_.size() ? clusters_[x] : none;
  }

  bool is_on_line(Index node) const { return node != NONE && !cells_.graph().is_corner(node); }

  bool is_crossing(Index node, Index next) const
  {
    const Index x = labels_[cells_.cell(node)], y = labels_[cells_.cell(next)];
    return x != y || x == NONE;
  }

  // Counts the nodes adjacent to `node` on its line that belong to cluster `x`.
  int nodes_beside(Index node, Index x) const
  {
    if (x == NONE)
      return 0;
    const Feature_graph& graph = cells_.graph();
    return int(labels_[cells_.cell(graph.before(node))] == x) + int(labels_[cells_.cell(graph.after(node))] == x);
  }

  void add(Index f, Index x)
  {
    if (x == NONE)
      return;
    if (x >= clusters_.size())
      clusters_.resize(x + 1);
    Cluster& c = clusters_[x];
    const Index node = cells_.node(f);
    c.faces_at_border += cells_.is_at_border(f);
    c.nodes += node != NONE;
    if (node != NONE && cells_.graph().is_corner(node)) {
      c.corner_cell = f;
      c.corner_is_on_border = cells_.is_on_border(node);
    }
  }

  void remove(Index f, Index x)
  {
    if (x == NONE)
      return;
    Cluster& c = clusters_[x];
    c.faces_at_border -= cells_.is_at_border(f);
    c.nodes -= cells_.node(f) != NONE;
    if (c.corner_cell == f) {
      c.corner_cell = NONE;
      c.corner_is_on_border = false;
    }
  }

  const Feature_cells& cells_;
  const Cluster_labels& labels_;
  std::vector<Cluster> clusters_;
  std::vector<Index> crossings_; // per line
};

// Decides which clusters of a component may be merged under the rules for features. Two clusters on features may be merged only
// if a line crosses between them, and not if both have corners.
class Feature_merging
{
public:
  template <class FaceRange>
  Feature_merging(const Feature_cells& cells, const Cluster_labels& labels, const FaceRange& faces, Index clusters)
    : clusters_(clusters), spare_(cells.graph().lines().size(), 0)
  {
    const Feature_graph& graph = cells.graph();
    for (const Index f : faces) {
      Cluster& x = clusters_[labels[f]];
      const Index node = cells.node(f);
      x.is_at_border = x.is_at_border || cells.is_at_border(f);
      if (node == NONE)
        continue;
      x.has_feature = true;
      if (graph.is_corner(node)) {
        x.has_corner = true;
        x.corner_is_on_border = cells.is_on_border(node);
      }
    }
    const Index component = faces.begin() == faces.end() ? NONE : component_of(*faces.begin(), labels);
    for (std::size_t l = 0; l < graph.lines().size(); ++l) {
      const Feature_line& line = graph.lines()[l];
      if (component_of(cells.cell(line.nodes[0]), labels) != component)
        continue;
      spare_[l] = -long(line.min_crossings);
      const std::size_t n = line.nodes.size();
      for (std::size_t i = line.is_loop ? 0 : 1; i < n; ++i)
        add_edge(labels[cells.cell(line.nodes[(i + n - 1) % n])], labels[cells.cell(line.nodes[i])], Index(l));
    }
  }

  // `cluster_of(x)` is the cluster into which `x` has been merged.
  template <class ClusterOf>
  bool may_merge(Index a, Index b, const ClusterOf& cluster_of) const
  {
    const Cluster &x = clusters_[a], &y = clusters_[b];
    if (keeps_off_border(x) ? y.is_at_border : keeps_off_border(y) && x.is_at_border)
      return false;
    if (!x.has_feature || !y.has_feature)
      return true;
    if (x.has_corner && y.has_corner)
      return false;
    const Index other = x.has_corner ? a : b;
    for (const Crossing& c : (x.has_corner ? y : x).crossings)
      if (cluster_of(c.other) == other)
        return spare_[c.line] > 0;
    return false;
  }

  // Records that cluster `gone` is merged into cluster `kept`.
  template <class ClusterOf>
  void merge(Index kept, Index gone, const ClusterOf& cluster_of)
  {
    Cluster &x = clusters_[kept], &y = clusters_[gone];
    const auto erase_to = [&](std::vector<Crossing>& crossings, Index other) {
      const auto is_to_other = [&](const Crossing& c) { return cluster_of(c.other) == other; };
      const auto i = std::find_if(crossings.begin(), crossings.end(), is_to_other);
      if (i == crossings.end())
        return;
      spare_[i->line] -= other == gone;
      crossings.erase(i);
    };
    erase_to(x.crossings, gone);
    erase_to(y.crossings, kept);
    x.crossings.insert(x.crossings.end(), y.crossings.begin(), y.crossings.end());
    y.crossings.clear();
    x.has_feature = x.has_feature || y.has_feature;
    x.has_corner = x.has_corner || y.has_corner;
    x.is_at_border = x.is_at_border || y.is_at_border;
    x.corner_is_on_border = x.corner_is_on_border || y.corner_is_on_border;
  }

private:
  struct Crossing
  {
    Index other, line;
  };
  struct Cluster
  {
    bool has_feature = false, has_corner = false, is_at_border = false, corner_is_on_border = false;
    std::vector<Crossing> crossings;
  };

  static bool keeps_off_border(const Cluster& x) { return x.has_feature && !x.corner_is_on_border; }

  static Index component_of(Index face, const Cluster_labels& labels) { return labels.mesh().component[face]; }

  void add_edge(Index x, Index y, Index line)
  {
    if (x == y)
      return;
    ++spare_[line];
    clusters_[x].crossings.push_back({y, line});
    clusters_[y].crossings.push_back({x, line});
  }

  std::vector<Cluster> clusters_;
  std::vector<long> spare_; // the number of crossings of each line that are not required
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_RULES_H
