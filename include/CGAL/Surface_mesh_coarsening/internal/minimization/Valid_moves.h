// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_VALID_MOVES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_VALID_MOVES_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Dual_walk.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_rules.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/prefetch.h>

#include <algorithm>
#include <cstdlib>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Moves faces between clusters if the clusters remain closed discs and their dual remains a simplicial surface (section 7 of the
// paper).
class Valid_moves
{
public:
  // `rules`: the rules for features, null without features.
  Valid_moves(Cluster_labels& labels, Feature_rules* rules)
    : mesh_(labels.mesh()), labels_(labels), walk_(labels), rules_(rules) {}

  // Returns whether both clusters remain discs, features are kept, and the clusters may change.
  bool keeps_discs(Index f, Index to) const
  {
    return labels_.stays_disc_without(f) && labels_.stays_disc_with(f, to) && !labels_.is_frozen(labels_[f]) &&
           !labels_.is_frozen(to) && !labels_.is_pinned(f) && (!rules_ || rules_->may_take(f, to));
  }

  // The paper's check, as printed in section 7, for a triangle that shares edge c with the cluster. A move passes if count(V2) =
  // 0, if one of the other two edges, n and p, leads to the cluster, or if one of them leads to any other cluster and V2 does not
  // touch the cluster. The paper has no check for faces of more sides.
  bool boundary_counts_allow(Index f, Index to) const
  {
    const Index begin = mesh_.first_corner[f];
    if (mesh_.degree(f) != 3)
      return true;
    Index c = 0;
    while (c < 3 && labels_.label_across(begin + c) != to)
      ++c;
    if (c == 3)
      return false;
    const Index v2 = mesh_.corner_vertex[begin + (c + 2) % 3], from = labels_[f];
    const Index across_n = labels_.label_across(begin + (c + 1) % 3), across_p = labels_.label_across(begin + (c + 2) % 3);
    if (labels_.boundary_count(v2) == 0 || (across_n == to) != (across_p == to))
      return true;
    return (across_n != from) != (across_p != from) && !touches(v2, to);
  }

  // Prefetch the data that `keeps_discs()` reads of a face in three steps; each step reads data prefetched by the previous
  // step.
  BOOST_FORCEINLINE void prefetch_corners(Index f) const
  {
    prefetch(&mesh_.corner_vertex[mesh_.first_corner[f]]);
    prefetch(&mesh_.face_across[mesh_.first_corner[f]]);
  }
  BOOST_FORCEINLINE void prefetch_labels(Index f) const
  {
    for (const Index c : mesh_.corners(f)) {
      const Index v = mesh_.corner_vertex[c], g = mesh_.face_across[c];
      if (g != NONE)
        prefetch(&labels_.labels()[g]);
      prefetch(&labels_.boundary_counts()[v]);
      prefetch(&mesh_.first_in_star[v]);
    }
  }
  BOOST_FORCEINLINE void prefetch_stars(Index f) const
  {
    for (const Index c : mesh_.corners(f))
      prefetch(&mesh_.star[mesh_.first_in_star[mesh_.corner_vertex[c]]]);
  }

  // Moves face `f` if the move is valid. Returns whether the move was valid.
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
      move_back(f, from);
      return false;
    }
    return true;
  }

  // Returns whether the move is valid. Leaves the labels as they are.
  bool may_move(Index f, Index to)
  {
    const Index from = labels_[f];
    if (!move(f, to))
      return false;
    move_back(f, from);
    return true;
  }

private:
  void move_back(Index f, Index from)
  {
    if (rules_)
      rules_->change(f, from);
    labels_.move(f, from);
  }

  bool touches(Index v, Index cluster) const
  {
    for (Index i = mesh_.first_in_star[v]; i != mesh_.first_in_star[v + 1]; ++i)
      if (labels_[mesh_.star[i]] == cluster)
        return true;
    return false;
  }

  // Returns whether the dual does not change because the face borders on at most one other cluster X, and the meeting point of X
  // with the two clusters of the move only slides along the edge to X, from its end at `to` to its end at the cluster of the
  // face. The dual does not change if at most three clusters meet at a vertex, before and after the move. Where four clusters
  // meet, it does not change if the diagonal between the apex of the fan and the opposite cluster replaces that edge; section
  // smc_guarantee_moves of the manual gives the condition.
  bool only_slides(Index f, Index to) const
  {
    const Index begin = mesh_.first_corner[f], end = mesh_.first_corner[f + 1], from = labels_[f];
    Index before = labels_.label_across(end - 1);
    int others = 0;
    for (Index c = begin; c != end; ++c) {
      const Index after = labels_.label_across(c), v = mesh_.corner_vertex[c];
      others += after != from && after != to;
      if (others > 1 || !keeps_fan(f, to, v, before, after))
        return false;
      before = after;
    }
    return true;
  }

  // Returns whether this condition holds at vertex `v` of the face, between edges to clusters `x` and `y`.
  bool keeps_fan(Index f, Index to, Index v, Index x, Index y) const
  {
    const Index from = labels_[f];
    const auto change = [&](Index label) { return int(label == from) - int(label == to); };
    const int count = int(labels_.boundary_count(v)), difference = change(x) + change(y);
    const int larger = count + (std::max)(0, difference);
    if (larger != 4)
      return larger < 4;
    const Index first = mesh_.star[mesh_.first_in_star[v]];
    if (first == f)
      return false;
    return difference == 0 ? change(x) != 0 : std::abs(difference) == 1 && (labels_[first] == x || labels_[first] == y);
  }

  // All edges that a move adds to the dual belong to the cluster that has grown, so the dual remains simplicial if the
  // neighbors of this cluster still form a simple cycle.
  bool dual_stays_simplicial(Index f, Index from)
  {
    for (const Index c : mesh_.corners(f))
      if (labels_.label_across(c) == from)
        return walk_.first_link_defect({f, c}) == NONE;
    return false;
  }

  const Flat_mesh& mesh_;
  Cluster_labels& labels_;
  Dual_walk walk_;
  Feature_rules* rules_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_VALID_MOVES_H
