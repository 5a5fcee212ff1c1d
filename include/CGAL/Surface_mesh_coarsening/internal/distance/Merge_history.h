// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_MERGE_HISTORY_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_MERGE_HISTORY_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Dual_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Moments.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Merges pairs of valid clusters as long as the dual remains a simplicial surface, and records how to undo the merges. Each step
// selects the pair that increases the energy least.
//
// Clusters are renumbered: level n has the n clusters 0 to n - 1. Cluster k is absent from level k on; it is merged into its
// parent, which has a smaller number. A triangle of the dual is stored with its last corners before its removal. Beginning
// at the coarsest level, undoing a merge restores one or two triangles, and moves some corners of other triangles to the restored
// cluster.
class Merge_history
{
public:
  Merge_history(const Clustering_input& input, const Cluster_labels& labels, Index clusters, const Run_context& context)
    : context_(context),
      dual_(labels, numbers_below(Index(input.mesh.number_of_faces())), clusters),
      finest_(clusters),
      sums_(clusters),
      version_(clusters, 0)
  {
    add_up_moments(input, labels, sums_, context);
    merge_all();
    number_clusters();
    list_triangles();
  }

  std::size_t finest() const { return finest_; }
  std::size_t coarsest() const { return finest_ - parent_.size(); }
  // Returns the number of a cluster of the clustering in this history.
  Index number(Index cluster) const { return number_[cluster]; }
  // Returns the parent of a cluster that is not in the coarsest level.
  Index parent(Index number) const { return parent_[number - coarsest()]; }

  // Returns, for each cluster of level `from`, the cluster of level `n` that contains it.
  std::vector<Index> ancestors(std::size_t from, std::size_t n) const
  {
    std::vector<Index> result(from);
    std::iota(result.begin(), result.begin() + (std::min)(n, from), Index(0));
    for (std::size_t k = n; k < from; ++k)
      result[k] = result[parent(Index(k))];
    return result;
  }

  // Returns the triangles of a level, in time linear in the number of triangles.
  std::vector<Triangle> triangles(std::size_t n) const
  {
    std::vector<Triangle> result(last_.begin(), last_.begin() + first_triangle_[n - coarsest()]);
    for (std::size_t k = coarsest(); k < n; ++k)
      for (Index i = first_corner_[k - coarsest()]; i != first_corner_[k - coarsest() + 1]; ++i)
        result[corner_[i] / 3][corner_[i] % 3] = Index(k);
    return result;
  }

private:
  typedef Dual_surface::Edge Edge;

  struct Step
  {
    Index gone, kept;
    std::vector<Edge> moved;         // corners of the removed cluster
    std::array<Index, 2> removed;    // triangles
    std::array<Triangle, 2> corners; // of these
  };

  // A merge: its cost, the two clusters, the smaller number first, the sum of their versions, and their edge.
  typedef std::tuple<double, Index, Index, Index, Edge> Candidate;

  // The energy with the weight of formula (9). For a union of clusters, it follows from the sums of the clusters.
  static double energy(const Moments& s) { return s.mass * s.inertia; }

  std::pair<Index, Index> ends(Edge e) const { return (std::minmax)({dual_.source(e), dual_.target(e)}); }

  void enqueue(Edge e)
  {
    const Index a = dual_.source(e), b = dual_.target(e);
    if (!dual_.is_arc(e) || dual_.is_cap(a) || dual_.is_cap(b))
      return;
    const double cost = energy(joined(sums_[a], sums_[b])) - energy(sums_[a]) - energy(sums_[b]);
    queue_.emplace(rounded_for_comparison(cost), ends(e).first, ends(e).second, version_[a] + version_[b], e);
  }

  void merge_all()
  {
    for (std::size_t last = steps_.size() + 1; last != steps_.size();) {
      last = steps_.size();
      for (Index t = 0; t < dual_.number_of_triangles(); ++t)
        if (dual_.is_triangle(t))
          for (Edge e = 3 * t; e != 3 * t + 3; ++e)
            if (dual_.source(e) < dual_.target(e))
              enqueue(e);
      while (!queue_.empty()) {
        context_.poll();
        const auto [cost, a, b, versions, e] = queue_.top();
        queue_.pop();
        if (dual_.is_triangle(e / 3) && ends(e) == std::make_pair(a, b) && version_[a] + version_[b] == versions &&
            dual_.may_contract(e))
          merge(e);
      }
    }
  }

  // Removes the cluster with fewer neighbors, which keeps the records short.
  void merge(Edge e)
  {
    const auto neighbors = [this](Index x) {
      std::size_t n = 0;
      dual_.for_each_edge_from(x, [&](Edge) { ++n; });
      return n;
    };
    if (neighbors(dual_.target(e)) > neighbors(dual_.source(e)))
      e = dual_.opposite(e);
    const Index kept = dual_.source(e), gone = dual_.target(e), t = e / 3, other = dual_.opposite(e) / 3;
    steps_.push_back({gone, kept, {}, {{t, other}}, {{corners(t), corners(other)}}});
    dual_.for_each_edge_from(gone, [&](Edge f) { steps_.back().moved.push_back(f); });
    dual_.contract(e);
    sums_[kept] = joined(sums_[kept], sums_[gone]);
    version_[kept] += version_[gone] + 1;
    dual_.for_each_edge_from(kept, [&](Edge f) { enqueue(f); });
  }

  Triangle corners(Index t) const { return {{dual_.source(3 * t), dual_.source(3 * t + 1), dual_.source(3 * t + 2)}}; }

  void number_clusters()
  {
    number_.assign(finest_, NONE);
    parent_.resize(steps_.size());
    Index next = Index(finest_);
    for (const Step& s : steps_)
      number_[s.gone] = --next;
    next = 0;
    for (Index& x : number_)
      if (x == NONE)
        x = next++;
    for (const Step& s : steps_)
      parent_[number_[s.gone] - coarsest()] = number_[s.kept];
  }

  // Lists the triangles in the order of their restoration, without triangles at caps.
  void list_triangles()
  {
    std::vector<Index> place(dual_.number_of_triangles(), NONE);
    const auto list = [&](Index t, const Triangle& corners) {
      if (std::any_of(corners.begin(), corners.end(), [&](Index x) { return dual_.is_cap(x); }))
        return;
      place[t] = Index(last_.size());
      last_.push_back({number_[corners[0]], number_[corners[1]], number_[corners[2]]});
    };
    for (Index t = 0; t < place.size(); ++t)
      if (dual_.is_triangle(t))
        list(t, corners(t));
    first_triangle_.push_back(Index(last_.size()));
    first_corner_.push_back(0);
    for (; !steps_.empty(); steps_.pop_back()) {
      const Step& step = steps_.back();
      for (int i = 0; i < 2; ++i)
        list(step.removed[i], step.corners[i]);
      first_triangle_.push_back(Index(last_.size()));
      for (const Edge e : step.moved)
        if (place[e / 3] != NONE)
          corner_.push_back(3 * place[e / 3] + e % 3);
      first_corner_.push_back(Index(corner_.size()));
    }
    steps_.shrink_to_fit();
  }

  const Run_context context_;
  Dual_surface dual_;
  std::size_t finest_;
  std::vector<Moments> sums_;  // per cluster
  std::vector<Index> version_; // number of merges in each cluster
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate> > queue_;
  std::vector<Step> steps_;    // until the triangles are listed
  std::vector<Index> number_;  // per cluster of the clustering
  std::vector<Index> parent_;  // per cluster that is not in the coarsest level
  std::vector<Triangle> last_; // the corners of each triangle before its removal
  std::vector<Index> corner_;  // corners restored, merge by merge
  std::vector<Index> first_triangle_, first_corner_; // restored from each level to the next
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_MERGE_HISTORY_H
