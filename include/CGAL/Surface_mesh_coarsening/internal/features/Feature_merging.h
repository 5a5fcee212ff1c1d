// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_MERGING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_MERGING_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_cells.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

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

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_MERGING_H
