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

// Section 8.1 of the paper: the clusters in turn take the free faces next to them, a layer a round, until no face is
// free. A cluster takes a face only if it stays a closed disc, which also makes discs of those neighborhoods of seeds
// that are none. Neighborhoods being disjoint, they are the first layers of this growth.
class Cluster_growth
{
public:
  // `rules`: those for features, where there are some.
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

  // Covers what the growth had to leave free because every cluster next to it would have closed upon itself: one of
  // the free faces after the other seeds a new cluster. Returns the number of clusters, new ones included.
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
  std::vector<Index> layer_, next_layer_; // faces taken whose neighbors have not been looked at
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_CLUSTER_GROWTH_H
