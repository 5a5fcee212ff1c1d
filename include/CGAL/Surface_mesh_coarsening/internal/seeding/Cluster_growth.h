// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_CLUSTER_GROWTH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_CLUSTER_GROWTH_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_rules.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/Visitor_handle.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Growth of the clusters (section 8.1 of the paper): the clusters take turns and take the adjacent free faces, one layer per
// round, until no face is free. A cluster takes a face only if it remains a closed disc, so neighborhoods of seeds that are not
// discs also become discs. The neighborhoods are disjoint; they are the first layers of this growth.
class Cluster_growth
{
public:
  // `rules`: the rules for features, if any.
  explicit Cluster_growth(Cluster_labels& labels, const Cancellation_point& cancellation = Cancellation_point(),
                          Feature_rules* rules = nullptr)
    : labels_(labels),
      mesh_(labels.mesh()),
      cancellation_(cancellation),
      rules_(rules)
  {}

  // Makes free face `f` the seed of cluster `label`.
  void plant(Index f, Index label) { take(f, label); }

  void run()
  {
    while (!next_layer_.empty()) {
      layer_.swap(next_layer_);
      next_layer_.clear();
      for (const Index f : layer_) {
        cancellation_.poll();
        for (const Index c : mesh_.corners(f)) {
          const Index g = mesh_.face_across[c];
          if (g != NONE && labels_[g] == NONE && labels_.stays_disc_with(g, labels_[f]) &&
              (!rules_ || rules_->may_take(g, labels_[f])))
            take(g, labels_[f]);
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
  void take(Index f, Index label)
  {
    if (rules_)
      rules_->change(f, label);
    labels_.set(f, label);
    next_layer_.push_back(f);
  }

  Cluster_labels& labels_;
  const Flat_mesh& mesh_;
  Cancellation_point cancellation_;
  Feature_rules* rules_;
  std::vector<Index> layer_, next_layer_; // the faces of a layer whose neighbors are not visited yet
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_CLUSTER_GROWTH_H
