// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_SPLIT_CLUSTERS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_SPLIT_CLUSTERS_H

#include <CGAL/Surface_mesh_coarsening/internal/Dual_walk.h>
#include <CGAL/Surface_mesh_coarsening/internal/faces_outward.h>
#include <CGAL/Surface_mesh_coarsening/internal/grow_clusters.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Splits the clusters of a component, all of them closed discs and numbered from 0, until their dual is a simplicial
// surface: until the neighbors of every cluster form a simple cycle. Each split makes two or more smaller discs of one, so
// this ends, at the latest with clusters of one face; what is wrong then lies in the mesh itself.
template <class FaceRange>
class Cluster_splitting
{
public:
  Cluster_splitting(Cluster_labels& labels, const FaceRange& faces, Index number_of_clusters,
                    const Checkpoint& checkpoint = Checkpoint(), Feature_rules* rules = nullptr)
    : labels_(labels), mesh_(labels.mesh()), walk_(labels), growth_(labels, checkpoint, rules), checkpoint_(checkpoint),
      rules_(rules), faces_(faces),
      clusters_(number_of_clusters) {}

  // Returns whether the clusters are valid now. They are not if clusters of one face are at fault.
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
  // Size, a face, and a boundary edge of each cluster.
  void survey()
  {
    size_.assign(clusters_, 0);
    face_.assign(clusters_, NONE);
    edge_.assign(clusters_, Directed_edge());
    stamp_of_cluster_.resize(clusters_, 0);
    for (const Index f : faces_) {
      checkpoint_.pass();
      const Index x = labels_[f];
      ++size_[x];
      if (face_[x] == NONE)
        face_[x] = f;
      if (edge_[x].face == NONE)
        edge_[x] = walk_.boundary_edge(f);
    }
  }

  // Returns whether they can be split.
  bool find_faulty_clusters()
  {
    to_split_.clear();
    std::vector<bool> listed(clusters_, false);
    for (Index x = 0; x < clusters_; ++x) {
      const Index fault = edge_[x].face == NONE ? x : walk_.fault_of_link(edge_[x], stamp_of_cluster_, stamp_);
      if (fault == NONE)
        continue;
      const Index larger = cluster_to_split(x, fault);
      if (larger == NONE)
        return false;
      if (!listed[larger]) {
        listed[larger] = true;
        to_split_.push_back(larger);
      }
    }
    return true;
  }

  // The larger of the two at fault; a neighbor, where both have a single face; NONE, where those have, too.
  Index cluster_to_split(Index x, Index fault)
  {
    Index largest = x;
    const auto consider = [&](Index y) {
      if (!Cluster_labels::is_beyond_border(y) && size_[y] > size_[largest])
        largest = y;
      return true;
    };
    consider(fault);
    if (size_[largest] == 1 && edge_[x].face != NONE)
      walk_.along_link(edge_[x], consider);
    return size_[largest] == 1 ? NONE : largest;
  }

  // Grows the cluster anew from two faces far apart, of which one is at the corner if it has a feature corner.
  void split(Index x)
  {
    const Index corner = rules_ ? rules_->corner_cell(x) : NONE;
    const std::vector<Index> faces = faces_outward(labels_, corner == NONE ? face_[x] : corner);
    const std::vector<Index> back = corner == NONE ? faces_outward(labels_, faces.back()) : faces;
    for (const Index f : faces) {
      if (rules_)
        rules_->change(f, NONE);
      labels_.set(f, NONE);
    }
    growth_.plant(back.front(), x);
    growth_.plant(back.back(), clusters_++);
    growth_.run();
    clusters_ = growth_.cover(faces, clusters_);
  }

  Cluster_labels& labels_;
  const Flat_mesh& mesh_;
  Dual_walk walk_;
  Cluster_growth growth_;
  Checkpoint checkpoint_;
  Feature_rules* rules_;
  FaceRange faces_;
  Index clusters_;
  std::size_t splits_ = 0;
  std::vector<Index> size_, face_;
  std::vector<Directed_edge> edge_;
  std::vector<Index> to_split_, stamp_of_cluster_;
  Index stamp_ = 0;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_SPLIT_CLUSTERS_H
