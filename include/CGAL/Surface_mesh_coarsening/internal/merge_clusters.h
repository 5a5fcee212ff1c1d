// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MERGE_CLUSTERS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MERGE_CLUSTERS_H

#include <CGAL/Surface_mesh_coarsening/internal/Dual_walk.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Rounds a sum to 16 binary digits, so that sums which are equal but for rounding compare equal.
inline double rounded_for_comparison(double x)
{
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(mantissa, 16)), exponent - 16);
}

// Section 6 of the paper, fewer seeds: the three clusters around a vertex that have the smallest summed area become
// one, again and again, until each component has as many clusters as it should. Two are merged where one too many is
// left, or where only two meet.
//
// The dual of the clusters is a simplicial surface and stays one: merging two clusters contracts an edge of it, and is
// done if and only if they meet in a single arc, have exactly two neighbors in common (the link condition; Dey,
// Edelsbrunner, Guha, Nekhayev: Topology preserving edge contraction, 1999), and do not touch two border loops.
class Cluster_merging
{
public:
  // `areas` of the faces, the number of clusters wanted in each component, and whether no more than two clusters may be
  // merged at a time there. If so, the order of the merges does not depend on the number wanted.
  Cluster_merging(Cluster_labels& labels, Index number_of_clusters, const std::vector<double>& areas,
                  const std::vector<std::size_t>& wanted, const std::vector<bool>& two_by_two)
    : labels_(labels), mesh_(labels.mesh()), walk_(labels), wanted_(wanted), two_by_two_(two_by_two),
      count_(wanted.size(), 0),
      next_in_cluster_(mesh_.number_of_faces()), area_(number_of_clusters, 0), size_(number_of_clusters, 0),
      seed_(number_of_clusters, NONE), stamp_of_cluster_(number_of_clusters, 0)
  {
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f) {
      const Index x = labels_[Index(f)];
      if (size_[x] == 0) {
        ++count_[mesh_.component[f]];
        next_in_cluster_[f] = Index(f);
        seed_[x] = Index(f);
      } else {
        next_in_cluster_[f] = next_in_cluster_[seed_[x]];
        next_in_cluster_[seed_[x]] = Index(f);
      }
      ++size_[x];
      area_[x] += areas[f];
    }
  }

  // Returns the number of merges of two clusters.
  std::size_t run()
  {
    // A merge is tried again after one of its clusters has changed. What may make it possible farther off is looked for
    // when nothing is left to try.
    std::size_t merges = 0;
    for (std::size_t more = 1; more > 0; merges += more) {
      for (std::size_t v = 0; v < mesh_.number_of_vertices(); ++v)
        if (labels_.boundary_count(Index(v)) >= 3 && excess_at(Index(v)) > 0)
          enqueue(Index(v));
      more = work_off();
    }
    return merges;
  }

  std::size_t number_of_clusters(std::size_t component) const { return count_[component]; }

  // Renumbers the clusters without gaps, in their old order, and returns a seed face of each.
  std::vector<Index> compact()
  {
    std::vector<Index> seeds, number(size_.size(), NONE);
    for (std::size_t x = 0; x < size_.size(); ++x)
      if (size_[x] != 0) {
        number[x] = Index(seeds.size());
        seeds.push_back(seed_[x]);
      }
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f)
      labels_.set(Index(f), number[labels_[Index(f)]]);
    return seeds;
  }

private:
  std::size_t work_off()
  {
    std::size_t merges = 0;
    while (!queue_.empty()) {
      const Candidate candidate = queue_.top();
      queue_.pop();
      const Index v = candidate.second;
      if (labels_.boundary_count(v) < 3 || excess_at(v) == 0)
        continue;
      if (candidate.first < choose(v))
        enqueue(v); // the clusters have grown since
      else
        merges += merge_at(v);
    }
    return merges;
  }

  typedef std::pair<double, Index> Candidate; // summed area and vertex

  struct Pair
  {
    double area;
    std::size_t first, second; // in a group of clusters
  };

  Index component_of(Index v) const { return mesh_.component[mesh_.star[mesh_.first_in_star[v]]]; }

  std::size_t excess_at(Index v) const
  {
    const Index component = component_of(v);
    return count_[component] - (std::min)(count_[component], wanted_[component]);
  }

  void enqueue(Index v) { queue_.emplace(choose(v), v); }

  // Puts the two or three clusters that are merged at `v` into chosen_: of those that follow each other around it,
  // the ones of the smallest summed area. Returns that area.
  double choose(Index v)
  {
    runs_around(labels_, v, runs_);
    // On the border the runs are a row, elsewhere a cycle.
    const bool cyclic = !mesh_.is_on_border(v);
    const std::size_t n = cyclic ? runs_.size() : runs_.size() - 1;
    const bool three = excess_at(v) > 1 && !two_by_two_[component_of(v)];
    const std::size_t together = (std::min)(n, std::size_t(three ? 3 : 2));
    const std::size_t starts = cyclic ? n : n - together + 1;
    double smallest = 0;
    chosen_.clear();
    for (std::size_t i = 0; i < starts; ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < together; ++j)
        sum += area_[runs_[(i + j) % n]];
      sum = rounded_for_comparison(sum);
      if (chosen_.empty() || sum < smallest) {
        smallest = sum;
        chosen_.clear();
        for (std::size_t j = 0; j < together; ++j)
          chosen_.push_back(runs_[(i + j) % n]);
      }
    }
    return smallest;
  }

  // Merges the chosen clusters, or, where they may not be, any two that meet at `v`.
  std::size_t merge_at(Index v)
  {
    std::vector<Index> group = chosen_;
    Index merged = NONE;
    std::size_t merges = 0;
    while (group.size() > 1 && excess_at(v) > 0) {
      const Index x = merge_two_of(group, v);
      if (x == NONE)
        break;
      merged = x;
      ++merges;
    }
    if (merges == 0 && runs_.size() > group.size()) {
      group = clusters_at(v);
      merged = merge_two_of(group, v);
      merges = merged != NONE;
    }
    if (merges > 0)
      seed_[merged] = face_at(v, merged);
    return merges;
  }

  // The first face of cluster `x` around `v`.
  Index face_at(Index v, Index x) const
  {
    Index i = mesh_.first_in_star[v];
    while (labels_[mesh_.star[i]] != x)
      ++i;
    return mesh_.star[i];
  }

  std::vector<Index> clusters_at(Index v)
  {
    runs_around(labels_, v, runs_);
    std::vector<Index> clusters(runs_);
    if (Cluster_labels::is_beyond_border(clusters.back()))
      clusters.pop_back();
    return clusters;
  }

  // Merges the two neighbors at `v` among the clusters of the group that have the smallest summed area of those that may
  // be merged. Their place in the group is the one of the first. Returns the merged cluster, NONE if there is none.
  Index merge_two_of(std::vector<Index>& group, Index v)
  {
    pairs_.clear();
    for (std::size_t i = 0; i < group.size(); ++i)
      for (std::size_t j = i + 1; j < group.size(); ++j)
        if (j == i + 1 || (i == 0 && j == group.size() - 1))
          pairs_.push_back({rounded_for_comparison(area_[group[i]] + area_[group[j]]), i, j});
    std::stable_sort(pairs_.begin(), pairs_.end(), [](const Pair& a, const Pair& b) { return a.area < b.area; });
    for (const Pair& pair : pairs_) {
      const Directed_edge e = edge_between(v, group[pair.first], group[pair.second]);
      if (e.face != NONE && may_merge(e)) {
        const Index merged = merge(e);
        group[pair.first] = merged;
        group.erase(group.begin() + pair.second);
        return merged;
      }
    }
    return NONE;
  }

  // The edge at `v` between clusters `a` and `b`, seen from the one that is followed by the other.
  Directed_edge edge_between(Index v, Index a, Index b) const
  {
    for (Index i = mesh_.first_in_star[v]; i != mesh_.first_in_star[v + 1]; ++i) {
      const Index f = mesh_.star[i];
      if (labels_[f] != a && labels_[f] != b)
        continue;
      const Index c = mesh_.previous_corner(f, mesh_.corner_of(f, v));
      if (labels_.label_across(c) == (labels_[f] == a ? b : a))
        return {f, c};
    }
    return {};
  }

  bool may_merge(const Directed_edge e)
  {
    const Index b = labels_.label_across(e.corner);
    const Index g = mesh_.face_across[e.corner];
    const Index end = mesh_.corner_vertex[mesh_.next_corner(e.face, e.corner)];
    const Directed_edge opposite{g, mesh_.corner_of(g, end)};
    // One arc: going around `a`, contact with `b` begins once.
    std::size_t contacts = 0;
    bool along_b = true;
    walk_.along_boundary(e, [&](Index, const std::vector<Index>& runs) {
      const bool arrives = runs.front() == b;
      const bool touches = std::find(runs.begin(), runs.end(), b) != runs.end();
      contacts += touches && !arrives;
      along_b = along_b && arrives && runs.size() == 1;
      return contacts <= 1;
    });
    if (contacts > 1 || along_b)
      return false;
    walk_.collect_link(e, link_a_);
    walk_.collect_link(opposite, link_b_);
    return link_condition();
  }

  bool link_condition()
  {
    if (link_a_.size() + link_b_.size() < 7) // the cycle around both would be shorter than 3
      return false;
    ++stamp_;
    Index loop = NONE;
    for (const Index x : link_a_)
      if (Cluster_labels::is_beyond_border(x))
        loop = x;
      else
        stamp_of_cluster_[x] = stamp_;
    std::size_t common = 0;
    for (const Index x : link_b_) {
      if (Cluster_labels::is_beyond_border(x)) {
        if (loop != NONE && loop != x)
          return false;
        common += x == loop;
      } else {
        common += stamp_of_cluster_[x] == stamp_;
      }
    }
    return common == 2;
  }

  // Merges the clusters on both sides of `e` into the one of more faces, and returns it.
  Index merge(const Directed_edge e)
  {
    Index kept_face = e.face, gone_face = mesh_.face_across[e.corner];
    if (size_[labels_[kept_face]] < size_[labels_[gone_face]])
      std::swap(kept_face, gone_face);
    const Index kept = labels_[kept_face], gone = labels_[gone_face];
    Index f = gone_face;
    affected_.clear();
    do {
      for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1]; ++c)
        affected_.push_back(mesh_.corner_vertex[c]);
      labels_.move(f, kept);
      f = next_in_cluster_[f];
    } while (f != gone_face);
    std::swap(next_in_cluster_[kept_face], next_in_cluster_[gone_face]);
    size_[kept] += size_[gone];
    area_[kept] += area_[gone];
    size_[gone] = 0;
    --count_[mesh_.component[kept_face]];
    std::sort(affected_.begin(), affected_.end());
    affected_.erase(std::unique(affected_.begin(), affected_.end()), affected_.end());
    for (const Index v : affected_)
      if (labels_.boundary_count(v) >= 3 && excess_at(v) > 0)
        enqueue(v);
    return kept;
  }

  Cluster_labels& labels_;
  const Flat_mesh& mesh_;
  Dual_walk walk_;
  const std::vector<std::size_t>& wanted_;
  const std::vector<bool>& two_by_two_;
  std::vector<std::size_t> count_; // clusters per component
  std::vector<Index> next_in_cluster_; // a cycle through the faces of each cluster
  std::vector<double> area_;
  std::vector<Index> size_, seed_, stamp_of_cluster_;
  Index stamp_ = 0;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate> > queue_;
  std::vector<Index> runs_, chosen_, link_a_, link_b_, affected_;
  std::vector<Pair> pairs_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MERGE_CLUSTERS_H
