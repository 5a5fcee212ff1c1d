// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_CLUSTER_GROWTH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_CLUSTER_GROWTH_H

#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_rules.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Selection of seeds (section 6 of the paper): traverses the faces in order, and takes a face as a seed if no face within `level`
// steps across edges belongs to the neighborhood of an earlier seed.
//
// Two neighborhoods of `level` steps are disjoint if and only if their centers are more than 2 * level steps apart. So each new
// seed marks the faces within 2 * level steps, and the test of a face reads only its mark. Marking stops at faces that an earlier
// seed reached in as few steps, because the earlier seed has marked all faces behind them. Seeds are far apart, so few of them
// reach a face, and the time is linear in the number of faces for every level.
class Seed_walk
{
public:
  explicit Seed_walk(const Flat_mesh& mesh, const Run_context& context = Run_context())
    : mesh_(mesh), context_(context), steps_(mesh.number_of_faces(), NONE) {}

  // Appends the seeds among the faces `candidates` to `seeds`.
  template <class FaceRange>
  void run(const FaceRange& candidates, Index level, std::vector<Index>& seeds)
  {
    for (const Index f : candidates) {
      context_.poll();
      if (steps_[f] == NONE)
        take(f, level, seeds);
    }
  }

  // Takes face `f` as a seed, independently of other seeds.
  void take(Index f, Index level, std::vector<Index>& seeds)
  {
    seeds.push_back(f);
    const Index reach = 2 * (std::min)(level, NONE / 4);
    queue_.assign(1, f);
    steps_[f] = 0;
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const Index next = steps_[queue_[i]] + 1;
      if (next > reach)
        break;
      context_.poll();
      for (const Index c : mesh_.corners(queue_[i])) {
        const Index g = mesh_.face_across[c];
        if (g != NONE && next < steps_[g]) {
          steps_[g] = next;
          queue_.push_back(g);
        }
      }
    }
  }

  // Clears the marks on the faces `candidates`.
  template <class FaceRange>
  void forget(const FaceRange& candidates)
  {
    steps_.resize(mesh_.number_of_faces(), NONE);
    for (const Index f : candidates)
      steps_[f] = NONE;
  }

  // Clears all marks and frees their memory until the next call of forget().
  void release() { steps_ = std::vector<Index>(); }

private:
  const Flat_mesh& mesh_;
  const Run_context context_;
  std::vector<Index> steps_; // the number of steps to the nearest seed found; NONE: none within reach
  std::vector<Index> queue_;
};

// Growth of the clusters (section 8.1 of the paper): the clusters take turns and take the adjacent free faces, one layer per
// round, until no face is free. A cluster takes a face only if it remains a closed disc, so neighborhoods of seeds that are not
// discs also become discs. The neighborhoods are disjoint; they are the first layers of this growth.
class Cluster_growth
{
public:
  explicit Cluster_growth(Cluster_labels& labels, const Run_context& context = Run_context(), Feature_rules* rules = nullptr)
    : labels_(labels), mesh_(labels.mesh()), context_(context), rules_(rules) {}

  Cluster_labels& labels() { return labels_; }
  const Run_context& context() const { return context_; }
  Feature_rules* rules() { return rules_; }

  // Makes free face `f` the seed of cluster `label`.
  void plant(Index f, Index label)
  {
    if (rules_)
      rules_->change(f, label);
    labels_.set(f, label);
    next_layer_.push_back(f);
  }

  void run()
  {
    while (!next_layer_.empty()) {
      layer_.swap(next_layer_);
      next_layer_.clear();
      for (const Index f : layer_) {
        context_.poll();
        for (const Index c : mesh_.corners(f)) {
          const Index g = mesh_.face_across[c];
          if (g != NONE && labels_[g] == NONE && labels_.stays_disc_with(g, labels_[f]) &&
              (!rules_ || rules_->may_take(g, labels_[f])))
            plant(g, labels_[f]);
        }
      }
    }
  }

  // Seeds new clusters with the remaining faces, one after the other: every cluster adjacent to them would have closed upon
  // itself. Returns the total number of clusters.
  template <class FaceRange>
  Index cover(const FaceRange& faces, Index number_of_clusters)
  {
    for (const Index f : faces)
      if (labels_[f] == NONE) {
        plant(f, number_of_clusters++);
        run();
      }
    return number_of_clusters;
  }

private:
  Cluster_labels& labels_;
  const Flat_mesh& mesh_;
  const Run_context context_;
  Feature_rules* rules_;
  std::vector<Index> layer_, next_layer_; // the faces of a layer whose neighbors are not visited yet
};

// Splits the clusters of a component, which are closed discs numbered from 0, until their dual is a simplicial surface, that
// is, until the neighbors of every cluster form a simple cycle. Each split divides a disc into smaller discs, so the splitting
// ends at the latest with clusters of one face. Faults that remain then are faults of the mesh itself.
//
// The clusters with the first numbers may be foreign: they have none of the faces, and they are neither checked nor split.
template <class FaceRange>
class Cluster_splitting
{
public:
  // `growth`: the growth of the clusters, which also grows their parts.
  Cluster_splitting(Cluster_growth& growth, const FaceRange& faces, Index number_of_clusters, Index foreign_clusters = 0)
    : growth_(growth), labels_(growth.labels()), walk_(labels_), faces_(faces), foreign_(foreign_clusters),
      clusters_(number_of_clusters) {}

  // Returns whether the clusters are valid. They are invalid if single faces remain faulty. With foreign clusters, faulty single
  // faces are ignored.
  bool run()
  {
    for (;;) {
      survey();
      if (!find_faulty_clusters())
        return false;
      if (to_split_.empty())
        return true;
      for (const Index x : to_split_)
        split(x);
      splits_ += to_split_.size();
    }
  }

  std::size_t number_of_splits() const { return splits_; }
  Index number_of_clusters() const { return clusters_; }

private:
  typedef std::vector<std::pair<Index, Index> > Faults;

  // Computes the size, a face, and a boundary edge of each cluster.
  void survey()
  {
    size_.assign(clusters_, 0);
    face_.assign(clusters_, NONE);
    edge_.assign(clusters_, Directed_edge());
    for (const Index f : faces_) {
      growth_.context().poll();
      const Index x = labels_[f];
      ++size_[x];
      if (face_[x] == NONE)
        face_[x] = f;
      if (edge_[x].face == NONE)
        edge_[x] = walk_.boundary_edge(f);
    }
  }

  // Returns whether a faulty cluster can be split.
  bool find_faulty_clusters()
  {
    to_split_.clear();
    std::vector<bool> listed(clusters_, false);
    for (const auto& [x, fault] : faults()) {
      const Index larger = cluster_to_split(x, fault);
      if (larger == NONE && foreign_ == 0)
        return false;
      if (larger != NONE && !listed[larger]) {
        listed[larger] = true;
        to_split_.push_back(larger);
      }
    }
    return true;
  }

  // Returns each faulty cluster together with the cluster that causes the fault, or with itself if it has no boundary or fewer
  // than three neighbors.
  Faults faults() const
  {
    Faults all;
    for_each_part<Faults>(
      growth_.context(), clusters_ - foreign_, 1024,
      [this](Faults& part, std::size_t begin, std::size_t end) {
        Dual_walk walk(labels_);
        part.clear();
        for (Index x = foreign_ + Index(begin); x != foreign_ + end; ++x) {
          const Index fault = edge_[x].face == NONE ? x : walk.first_link_defect(edge_[x]);
          if (fault != NONE)
            part.emplace_back(x, fault);
        }
      },
      [&all](const Faults& part) { all.insert(all.end(), part.begin(), part.end()); });
    return all;
  }

  // Returns the larger of the two faulty clusters. If both have a single face, returns a neighbor; NONE if the neighbors also
  // have a single face.
  Index cluster_to_split(Index x, Index fault)
  {
    Index largest = x;
    const auto consider = [&](Index y) {
      if (!Cluster_labels::is_cap(y) && size_[y] > size_[largest])
        largest = y;
      return true;
    };
    consider(fault);
    if (size_[largest] == 1 && edge_[x].face != NONE)
      walk_.along_link(edge_[x], consider);
    return size_[largest] == 1 ? NONE : largest;
  }

  // Grows two clusters from two distant faces of the cluster. If it has a feature corner, one of the faces is there.
  void split(Index x)
  {
    Feature_rules* const rules = growth_.rules();
    const Index corner = rules ? rules->corner_cell(x) : NONE;
    const std::vector<Index> faces = faces_in_bfs_order(labels_, corner == NONE ? face_[x] : corner);
    const std::vector<Index> back = corner == NONE ? faces_in_bfs_order(labels_, faces.back()) : faces;
    for (const Index f : faces) {
      if (rules)
        rules->change(f, NONE);
      labels_.set(f, NONE);
    }
    growth_.plant(back.front(), x);
    growth_.plant(back.back(), clusters_++);
    growth_.run();
    clusters_ = growth_.cover(faces, clusters_);
  }

  Cluster_growth& growth_;
  Cluster_labels& labels_;
  Dual_walk walk_;
  FaceRange faces_;
  const Index foreign_;
  Index clusters_;
  std::size_t splits_ = 0;
  std::vector<Index> size_, face_;
  std::vector<Directed_edge> edge_;
  std::vector<Index> to_split_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_CLUSTER_GROWTH_H
