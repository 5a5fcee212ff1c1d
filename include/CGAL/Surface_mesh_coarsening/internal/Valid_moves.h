// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_VALID_MOVES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_VALID_MOVES_H

#include <CGAL/Surface_mesh_coarsening/internal/Dual_walk.h>
#include <CGAL/Surface_mesh_coarsening/internal/Feature_rules.h>
#include <CGAL/Surface_mesh_coarsening/internal/prefetch.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Section 7 of the paper: moves faces between clusters if the clusters remain closed discs, and their dual a simplicial
// surface.
class Valid_moves
{
public:
  Valid_moves(Cluster_labels& labels, std::size_t number_of_clusters)
    : mesh_(labels.mesh()), labels_(labels), walk_(labels), stamp_of_cluster_(number_of_clusters, 0) {}

  // From now on follows the rules for features.
  void keep_features(const Feature_cells& cells)
  {
    rules_.emplace(cells, labels_);
    rules_->count(stamp_of_cluster_.size());
  }

  // Whether both clusters remain discs, features what they are, and the clusters are free to change.
  bool keeps_discs(Index f, Index to) const
  {
    return labels_.stays_disc_without(f) && labels_.stays_disc_with(f, to) && !labels_.is_frozen(labels_[f]) &&
           !labels_.is_frozen(to) && (!rules_ || rules_->may_take(f, to));
  }

  // What `keeps_discs()` reads of a face, in three steps, each of which reads what the one before has asked for.
  BOOST_FORCEINLINE void prefetch_corners(Index f) const
  {
    prefetch(&mesh_.corner_vertex[mesh_.first_corner[f]]);
    prefetch(&mesh_.face_across[mesh_.first_corner[f]]);
  }
  BOOST_FORCEINLINE void prefetch_labels(Index f) const
  {
    for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1]; ++c) {
      const Index v = mesh_.corner_vertex[c], g = mesh_.face_across[c];
      if (g != NONE)
        prefetch(&labels_.labels()[g]);
      prefetch(&labels_.boundary_counts()[v]);
      prefetch(&mesh_.first_in_star[v]);
    }
  }
  BOOST_FORCEINLINE void prefetch_stars(Index f) const
  {
    for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1]; ++c)
      prefetch(&mesh_.star[mesh_.first_in_star[mesh_.corner_vertex[c]]]);
  }

  // Moves face `f` if it may move. Returns whether it did.
  bool move(Index f, Index to)
  {
    const Index from = labels_[f];
    if (!keeps_discs(f, to))
      return false;
    const bool dual_may_change = !only_slides(f, to);
    if (rules_)
      rules_->change(f, to);
    labels_.move(f, to);
    if (dual_may_change && !dual_stays_simplicial(f, from)) {
      if (rules_)
        rules_->change(f, from);
      labels_.move(f, from);
      return false;
    }
    return true;
  }

private:
  // Whether no vertex where more than three clusters meet is involved, before or after, and the face borders on at
  // most one cluster more. Then the move slides a point where three clusters meet at the most, and the dual remains
  // what it was.
  bool only_slides(Index f, Index to) const
  {
    const Index begin = mesh_.first_corner[f], end = mesh_.first_corner[f + 1], from = labels_[f];
    const auto change = [&](Index c) {
      const Index across = labels_.label_across(c);
      return int(across == from) - int(across == to);
    };
    int others = 0, previous = change(end - 1);
    for (Index c = begin; c != end; ++c) {
      const int next = change(c);
      const Index count = labels_.boundary_count(mesh_.corner_vertex[c]);
      others += next == 0;
      if (others > 1 || count > 3 || Index(int(count) + previous + next) > 3)
        return false;
      previous = next;
    }
    return true;
  }

  // All edges that a move adds to the dual belong to the cluster that has grown: the dual remains simplicial if the
  // neighbors of that cluster still form a simple cycle.
  bool dual_stays_simplicial(Index f, Index from)
  {
    for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1]; ++c)
      if (labels_.label_across(c) == from)
        return walk_.fault_of_link({f, c}, stamp_of_cluster_, stamp_) == NONE;
    return false;
  }

  const Flat_mesh& mesh_;
  Cluster_labels& labels_;
  Dual_walk walk_;
  std::optional<Feature_rules> rules_;
  std::vector<Index> stamp_of_cluster_;
  Index stamp_ = 0;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_VALID_MOVES_H
