// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_COMPONENT_CLUSTERING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_COMPONENT_CLUSTERING_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/subdivision.h>
#include <CGAL/Surface_mesh_coarsening/internal/seeding/Cluster_growth.h>
#include <CGAL/Surface_mesh_coarsening/internal/seeding/Cluster_merging.h>
#include <CGAL/Surface_mesh_coarsening/internal/seeding/Component_plan.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

struct Component_seeds
{
  std::vector<Index> faces;
  Index level = 0;
  std::size_t of_every_level = 0; // on features: the cells of corners, and one cell on each loop
};

struct Component_growth
{
  std::size_t clusters = 0; // 0 if there are too few faces or seeds
  std::size_t splits = 0, merges = 0;
  std::vector<Index> new_seeds; // of clusters that were merged by area
  bool is_pinched = false;      // whether without_pinches() must turn clusters into discs
};

// Clusters one connected component according to its plan: seeds, growth, splitting, merging.
class Component_clustering
{
public:
  Component_clustering(const Featured_input& input, bool merges_by_area, const Run_context& context)
    : input_(input.items), cells_(input.cells.get()), merges_by_area_(merges_by_area),
      has_vertex_cells_(has_vertex_cells(input)), context_(context), walk_(input.items.mesh, context) {}

  Component_seeds seeds(const Face_range& faces, const Component_plan& plan)
  {
    if (plan.level() != NONE)
      return seeds_of_level(faces, plan.level());
    if (has_vertex_cells_)
      return seeds_of_level(faces, 0);
    Component_seeds seeds = largest_level_of(faces, plan.min_seeds());
    if (plan.is_on_schedule())
      return seeds_of_level(faces, Component_plan::scheduled_level(seeds.level));
    // Merging from all faces takes long and gives no better result than merging from the next level.
    return seeds.level > 0 ? seeds : largest_level_of(faces, plan.wanted());
  }

  // Labels the faces from 0.
  Component_growth grow(Cluster_labels& labels, const Face_range& faces, const Component_seeds& seeds, const Component_plan& plan)
  {
    for (const Index f : faces)
      labels.set(f, NONE);
    if (faces.size() == input_.mesh.number_of_faces())
      walk_.release();
    std::optional<Feature_rules> rules;
    if (cells_) {
      rules.emplace(*cells_, labels);
      rules->begin(faces);
    }
    Cluster_growth growth(labels, context_, rules ? &*rules : nullptr);
    Index clusters = 0;
    for (const Index f : seeds.faces)
      growth.plant(f, clusters++);
    growth.run();
    Cluster_splitting<Face_range> splitting(growth, faces, growth.cover(faces, clusters));

    Component_growth result;
    if (!splitting.run() || !plan.may_begin_with(splitting.number_of_clusters()))
      return result;
    result.clusters = splitting.number_of_clusters();
    result.splits = splitting.number_of_splits();
    if (result.clusters <= plan.wanted())
      return result;
    Merging_method method;
    const bool by_quadrics = has_vertex_cells_ || plan.merges_by_quadrics();
    method.by_threes = !plan.is_on_schedule() && !by_quadrics;
    method.order = by_quadrics                            ? Merging::BY_QUADRICS
                   : merges_by_area_ || !method.by_threes ? Merging::BY_AREA
                                                          : Merging::BY_MASS;
    method.may_join_at_vertices = plan.from_pieces() && plan.is_on_schedule() && !cells_;
    Cluster_merging merging(input_, {labels, faces, splitting.number_of_clusters(), growth.rules()}, method, context_);
    result.merges = merging.run(plan.wanted());
    result.clusters -= result.merges;
    result.is_pinched = merging.has_pinches();
    merging.relabel();
    if (merges_by_area_)
      result.new_seeds = merging.new_seeds();
    return result;
  }

private:
  Component_seeds seeds_of_level(const Face_range& faces, Index level)
  {
    Component_seeds seeds;
    seeds.level = level;
    walk_.forget(faces);
    if (cells_)
      take_seeds_on_features(faces, seeds);
    walk_.run(faces, level, seeds.faces);
    return seeds;
  }

  // Takes all corners first, then the seeds on lines.
  void take_seeds_on_features(const Face_range& faces, Component_seeds& seeds)
  {
    std::vector<Index> on_lines;
    for (const Index f : faces) {
      const Index node = cells_->node(f);
      if (node == NONE)
        continue;
      if (cells_->graph().is_corner(node))
        walk_.take(f, seeds.level, seeds.faces);
      else
        on_lines.push_back(f);
    }
    seeds.of_every_level = seeds.faces.size();
    walk_.run(on_lines, seeds.level, seeds.faces);
    fill_gaps_on_lines(on_lines, seeds);
  }

  void fill_gaps_on_lines(const std::vector<Index>& cells_on_lines, Component_seeds& seeds)
  {
    const Feature_graph& graph = cells_->graph();
    std::vector<Index> lines, seeded;
    for (const Index f : cells_on_lines)
      lines.push_back(graph.line(cells_->node(f)));
    for (const Index f : seeds.faces)
      seeded.push_back(cells_->node(f));
    sort_unique(lines);
    sort_unique(seeded);
    for (const Index l : lines) {
      const std::vector<Index>& nodes = graph.lines()[l].nodes;
      const bool is_loop = graph.lines()[l].is_loop;
      const std::size_t n = nodes.size();
      seeds.of_every_level += is_loop;
      const auto is_seed = [&](std::size_t i) { return std::binary_search(seeded.begin(), seeded.end(), nodes[i % n]); };
      std::size_t first = 0;
      while (first < n && !is_seed(first))
        ++first;
      if (first == n) { // a loop: the ends of other lines are corners, which are seeds
        first = 0;
        walk_.take(cells_->cell(nodes[0]), 0, seeds.faces);
      }
      const std::size_t end = is_loop ? first + n : n - 1;
      for (std::size_t last = first, i = first + 1; i <= end; ++i)
        if (i == end || is_seed(i)) {
          take_between(nodes, last, i, seeds);
          last = i;
        }
    }
  }

  // Takes seeds at equal distances between two nodes of a line.
  void take_between(const std::vector<Index>& nodes, std::size_t first, std::size_t last, Component_seeds& seeds)
  {
    // Disjoint neighborhoods leave at most this number of nodes of a line between seeds, unless the line passes vertices of high
    // valence, whose faces are all neighbors.
    const std::size_t max_gap = 4 * std::size_t(seeds.level) + 2;
    const std::size_t parts = (last - first + max_gap - 1) / max_gap;
    for (std::size_t i = 1; i < parts; ++i)
      walk_.take(cells_->cell(nodes[(first + i * (last - first) / parts) % nodes.size()]), 0, seeds.faces);
  }

  // Returns the seeds of the largest level, near the expected level, with at least `wanted` seeds.
  Component_seeds largest_level_of(const Face_range& faces, std::size_t wanted)
  {
    // On a regular mesh, the neighborhood of level k has 1 + 3 k (k + 1) / 2 faces, and the neighborhoods contain about three
    // quarters of all faces.
    const double faces_each = 0.75 * double(faces.size()) / double(wanted);
    const Index level = faces_each <= 1 ? 0 : Index(std::lround(std::sqrt((faces_each - 1) / 1.5 + 0.25)));
    Component_seeds seeds = seeds_of_level(faces, level);
    if (seeds.faces.size() < wanted) {
      while (seeds.faces.size() < wanted && seeds.level > 0)
        seeds = seeds_of_level(faces, seeds.level - 1);
      return seeds;
    }
    while (seeds.faces.size() > (std::max)(seeds.of_every_level, std::size_t(1))) {
      Component_seeds fewer = seeds_of_level(faces, seeds.level + 1);
      if (fewer.faces.size() < wanted)
        break;
      seeds = std::move(fewer);
    }
    return seeds;
  }

  const Clustering_input& input_;
  const Feature_cells* cells_; // null without features
  bool merges_by_area_;
  bool has_vertex_cells_; // which are merged from single cells
  const Run_context context_;
  Seed_walk walk_;
};

// Turns pinched clusters into discs. A cluster is pinched at a vertex if it results from the merge of two clusters that met only
// in this vertex, that is, in an edge of its fan. Corners are cut off the faces of the other clusters and moved to the pinched
// cluster.
//
// The pinched cluster is the cluster of the first face around the vertex, the apex of the fan. The segments between its
// parts are cut off from the vertex, except the last segment, which contains the border if the vertex lies on it. Along the
// cuts, the cluster meets the other clusters in the order of the fan, so the dual is the contracted fan.
//
// Returns the input with the corners cut off. `new_labels` receives the labels of its faces.
inline Clustering_input without_pinches(const Clustering_input& input, const Cluster_labels& labels,
                                        std::vector<Index>& new_labels)
{
  const Flat_mesh& m = input.mesh;
  const auto label_of_first = [&](Index v) { return labels[m.star[m.first_in_star[v]]]; };
  std::vector<bool> is_cut(m.corner_vertex.size(), false);
  for (Index v = 0; v < m.number_of_vertices(); ++v) {
    const Index begin = m.first_in_star[v];
    Index last = m.first_in_star[v + 1];
    if (begin == last)
      continue;
    const Index pinched = label_of_first(v);
    // The last segment follows the last part of the cluster. At an inner vertex, the cluster may continue across the end of the
    // sequence.
    if (!m.is_on_border(v))
      while (last != begin && labels[m.star[last - 1]] == pinched)
        --last;
    while (last != begin && labels[m.star[last - 1]] != pinched)
      --last;
    for (Index i = begin; i != last; ++i)
      if (labels[m.star[i]] != pinched)
        is_cut[m.corner_of(m.star[i], v)] = true;
  }
  Corner_truncation cutting(m, is_cut);
  Flat_mesh cut_mesh = cutting.run();
  new_labels.clear();
  for (std::size_t i = 0; i < cutting.old_face().size(); ++i) {
    const Index c = cutting.old_corner()[cut_mesh.first_corner[i]];
    const bool is_cut_off = c != NONE && is_cut[c];
    new_labels.push_back(is_cut_off ? label_of_first(m.corner_vertex[c]) : labels[cutting.old_face()[i]]);
  }
  return cut_input(input, std::move(cut_mesh), cutting.old_face());
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_COMPONENT_CLUSTERING_H
