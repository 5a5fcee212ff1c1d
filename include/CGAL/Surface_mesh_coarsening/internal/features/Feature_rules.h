// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_RULES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_RULES_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_cells.h>

#include <algorithm>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The rules of features for clusters. A cluster contains either no cell of a feature, or the cells of one contiguous part of
// one line, or the cell of one corner with contiguous parts of lines that begin there. A line keeps the number of crossings
// between clusters that it needs. Clusters on a line must not reach the border, because the border would also determine the
// position of their vertex.
//
// Cells without a cluster count as separate clusters.
class Feature_rules
{
public:
  // What a cluster has of the features.
  struct Cluster
  {
    long nodes = 0, faces_at_border = 0;
    Index corner_cell = NONE;
    bool corner_is_on_border = false;

    bool may_reach_border() const { return nodes == 0 || corner_is_on_border; }
  };

  Feature_rules(const Feature_cells& cells, const Cluster_labels& labels)
    : cells_(cells), labels_(labels), crossings_(cells.graph().lines().size(), 0) {}

  const Feature_cells& cells() const { return cells_; }
  const Cluster_labels& labels() const { return labels_; }
  const std::vector<Cluster>& clusters() const { return clusters_; }

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
      count(Index(f), labels_[Index(f)], 1);
    const Feature_graph& graph = cells_.graph();
    for (std::size_t l = 0; l < crossings_.size(); ++l) {
      const Feature_line& line = graph.lines()[l];
      crossings_[l] = 0;
      for (std::size_t i = 0; i < line.number_of_edges(); ++i) {
        const Index x = labels_[cells_.cell(line.node(i))], y = labels_[cells_.cell(line.node(i + 1))];
        crossings_[l] += x != y || x == NONE;
      }
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
      return target.may_reach_border() || !cells_.is_at_border(f);
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
    count(f, from, -1);
    count(f, to, 1);
  }

  // Returns the corner cell of a cluster; NONE without a corner.
  Index corner_cell(Index x) const { return cluster(x).corner_cell; }

private:
  const Cluster& cluster(Index x) const
  {
    static const Cluster none;
    return x < clusters_.size() ? clusters_[x] : none;
  }

  bool is_on_line(Index node) const { return node != NONE && !cells_.graph().is_corner(node); }

  // Counts the nodes adjacent to `node` on its line that belong to cluster `x`.
  int nodes_beside(Index node, Index x) const
  {
    if (x == NONE)
      return 0;
    const Feature_graph& graph = cells_.graph();
    return int(labels_[cells_.cell(graph.before(node))] == x) + int(labels_[cells_.cell(graph.after(node))] == x);
  }

  // Adds face `f` to the counts of cluster `x`, or removes it with `by` = -1.
  void count(Index f, Index x, int by)
  {
    if (x == NONE)
      return;
    if (x >= clusters_.size())
      clusters_.resize(x + 1);
    Cluster& c = clusters_[x];
    const Index node = cells_.node(f);
    c.faces_at_border += cells_.is_at_border(f) ? by : 0;
    c.nodes += node != NONE ? by : 0;
    if (node != NONE && cells_.graph().is_corner(node)) {
      c.corner_cell = by > 0 ? f : NONE;
      c.corner_is_on_border = by > 0 && cells_.is_on_border(node);
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
  // `rules` know the clusters of the faces of component `component`.
  Feature_merging(const Feature_rules& rules, Index component)
    : clusters_(rules.clusters()), crossings_(clusters_.size()), spare_(rules.cells().graph().lines().size(), 0)
  {
    const Cluster_labels& labels = rules.labels();
    for (std::size_t l = 0; l < spare_.size(); ++l) {
      const Feature_line& line = rules.cells().graph().lines()[l];
      const auto cell = [&](std::size_t i) { return rules.cells().cell(line.node(i)); };
      if (labels.mesh().component[cell(0)] != component)
        continue;
      spare_[l] = -long(line.min_crossings);
      for (std::size_t i = 0; i < line.number_of_edges(); ++i) {
        const Index x = labels[cell(i)], y = labels[cell(i + 1)];
        if (x == y)
          continue;
        ++spare_[l];
        crossings_[x].push_back({y, Index(l)});
        crossings_[y].push_back({x, Index(l)});
      }
    }
  }

  // `cluster_of(x)` is the cluster into which `x` has been merged.
  template <class ClusterOf>
  bool may_merge(Index a, Index b, const ClusterOf& cluster_of) const
  {
    const Feature_rules::Cluster &x = clusters_[a], &y = clusters_[b];
    if (x.may_reach_border() ? x.faces_at_border > 0 && !y.may_reach_border() : y.faces_at_border > 0)
      return false;
    if (x.nodes == 0 || y.nodes == 0)
      return true;
    if (x.corner_cell != NONE && y.corner_cell != NONE)
      return false;
    const bool has_corner = x.corner_cell != NONE;
    for (const Crossing& c : crossings_[has_corner ? b : a])
      if (cluster_of(c.other) == (has_corner ? a : b))
        return spare_[c.line] > 0;
    return false;
  }

  // Records that cluster `gone` is merged into cluster `kept`.
  template <class ClusterOf>
  void merge(Index kept, Index gone, const ClusterOf& cluster_of)
  {
    const auto erase = [&](Index from, Index to) {
      std::vector<Crossing>& crossings = crossings_[from];
      const auto is_to_other = [&](const Crossing& c) { return cluster_of(c.other) == to; };
      const auto i = std::find_if(crossings.begin(), crossings.end(), is_to_other);
      if (i == crossings.end())
        return;
      spare_[i->line] -= to == gone;
      crossings.erase(i);
    };
    erase(kept, gone);
    erase(gone, kept);
    crossings_[kept].insert(crossings_[kept].end(), crossings_[gone].begin(), crossings_[gone].end());
    crossings_[gone].clear();
    Feature_rules::Cluster &x = clusters_[kept], &y = clusters_[gone];
    x.nodes += y.nodes;
    x.faces_at_border += y.faces_at_border;
    x.corner_cell = (std::min)(x.corner_cell, y.corner_cell);
    x.corner_is_on_border = x.corner_is_on_border || y.corner_is_on_border;
  }

private:
  struct Crossing
  {
    Index other, line;
  };

  std::vector<Feature_rules::Cluster> clusters_;
  std::vector<std::vector<Crossing> > crossings_; // per cluster
  std::vector<long> spare_;                       // the number of crossings of each line that are not required
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_RULES_H
