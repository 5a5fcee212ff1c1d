// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_MINIMIZATION_STATE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_MINIMIZATION_STATE_H

#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Clustered_face.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_rules.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>

#include <boost/config.hpp>
#include <boost/type_traits/is_detected.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The sums of a cluster, with its energy.
template <class Energy>
struct Cluster_sums : Energy::Cluster_data
{
  Index faces = 0;
  double energy = 0;
};

// The optional members of the concept `ClusterEnergy`, and the results of the required ones.
template <class Energy>
using Energy_sums = typename Energy::Cluster_data;
template <class Energy>
using Energy_outcome = std::decay_t<decltype(std::declval<const Energy&>().energy(
  std::declval<const Energy_sums<Energy>&>(), std::size_t()))>;
template <class Energy>
using Trial_energy = decltype(std::declval<const Energy&>().energy_with(
  std::declval<const Energy_sums<Energy>&>(), std::declval<const typename Energy::Face_data&>(), std::size_t()));
template <class Energy>
using Quick_rejection = decltype(std::declval<const Energy&>().cannot_gain(
  std::declval<const Energy_sums<Energy>&>(), std::declval<const Energy_sums<Energy>&>(),
  std::declval<const typename Energy::Face_data&>()));
template <class Energy>
using Second_pass = decltype(std::declval<const Energy&>().set_center(std::declval<Energy_sums<Energy>&>()));
template <class Energy>
using Kept_outcome = decltype(std::declval<const Energy&>().keep(std::declval<Energy_sums<Energy>&>(),
                                                                 std::declval<const Energy_outcome<Energy>&>()));
template <class Energy>
using Mean_area = decltype(std::declval<Energy&>().set_mean_area(0.));

template <class Energy>
constexpr bool needs_mean_area = boost::is_detected_v<Mean_area, Energy>;

// Computes the energy of a cluster, also with an additional face or without a face, by a model of `ClusterEnergy`.
template <class Energy>
class Energy_evaluation
{
public:
  typedef typename Energy::Face_data Face;
  typedef Cluster_sums<Energy> Sums;
  typedef Energy_outcome<Energy> Outcome; // a number, or a class that converts to a number

  Energy_evaluation(const Energy& energy, const Clustering_input& input, std::size_t clusters)
    : energy_(energy), number_of_clusters_(clusters)
  {
    if constexpr (needs_mean_area<Energy>)
      energy_.set_mean_area(std::accumulate(input.area.begin(), input.area.end(), 0.) / double(clusters));
  }

  Face terms_of(const Clustering_input& input, Index f) const { return energy_.face_data(Clustered_face(input, f)); }

  // Computes all sums of the clusters.
  void add_up(const Clustering_input& input, const Cluster_labels& labels, std::vector<Sums>& clusters,
              const Run_context& context) const
  {
    constexpr bool has_two_passes = boost::is_detected_v<Second_pass, Energy>;
    clusters.assign(number_of_clusters_, Sums());
    const std::vector<Index>& cluster = labels.labels();
    if constexpr (has_two_passes) {
      for_each_in_groups(context, cluster, clusters.size(),
                         [&](Index f) { energy_.add_to_center(clusters[cluster[f]], Clustered_face(input, f)); });
      for (Sums& x : clusters)
        energy_.set_center(x);
    }
    for_each_in_groups(context, cluster, clusters.size(), [&](Index f) {
      Sums& x = clusters[cluster[f]];
      ++x.faces;
      if constexpr (has_two_passes)
        energy_.add_about_center(x, terms_of(input, f));
      else
        energy_.add(x, terms_of(input, f));
    });
    for (Sums& x : clusters)
      set(x, energy_.energy(x, x.faces));
  }

  Outcome outcome_with(const Sums& x, const Face& face) const
  {
    if constexpr (boost::is_detected_v<Trial_energy, Energy>)
      return energy_.energy_with(x, face, x.faces + 1);
    typename Energy::Cluster_data with = x;
    energy_.add(with, face);
    return energy_.energy(with, x.faces + 1);
  }

  Outcome outcome_without(const Sums& x, const Face& face) const
  {
    if constexpr (boost::is_detected_v<Trial_energy, Energy>)
      return energy_.energy_without(x, face, x.faces - 1);
    typename Energy::Cluster_data without = x;
    energy_.remove(without, face);
    return energy_.energy(without, x.faces - 1);
  }

  // The outcome of `outcome_with()` or `outcome_without()` is passed because energies are expensive to compute.
  void add(Sums& x, const Face& face, const Outcome& outcome) const
  {
    energy_.add(x, face);
    ++x.faces;
    set(x, outcome);
  }

  void remove(Sums& x, const Face& face, const Outcome& outcome) const
  {
    energy_.remove(x, face);
    --x.faces;
    set(x, outcome);
  }

  // Quick rejection: returns whether the move of a face from cluster `source` to cluster `target` certainly does not lower the
  // energy.
  bool cannot_gain(const Sums& source, const Sums& target, const Face& face) const
  {
    if constexpr (boost::is_detected_v<Quick_rejection, Energy>)
      return energy_.cannot_gain(source, target, face);
    return false;
  }

private:
  void set(Sums& x, const Outcome& outcome) const
  {
    if constexpr (boost::is_detected_v<Kept_outcome, Energy>)
      energy_.keep(x, outcome);
    x.energy = outcome;
  }

  Energy energy_;
  std::size_t number_of_clusters_;
};

// A count of moves.
typedef Index Move_time;

// An edge between two clusters.
struct Boundary_edge
{
  std::array<Index, 2> face;    // the face of smaller index first
  Index corner;                 // of the first face, before the edge
  std::array<Index, 2> cluster; // the clusters of the faces at the last look-up
  Move_time tested;             // 0: never
  Index terms;                  // the position of the terms of the two faces in a block; NONE if they are not stored
  bool is_postponed = false;    // whether a move has to wait for other blocks

  bool is_inner() const { return cluster[0] == cluster[1]; }

  // Returns whether one of the clusters has changed since the last test. A face that changes its cluster changes both clusters.
  bool is_due(const std::vector<Move_time>& last_change) const
  {
    return (std::max)(last_change[cluster[0]], last_change[cluster[1]]) > tested;
  }

  void look_up(const Cluster_labels& labels) { cluster = {{labels[face[0]], labels[face[1]]}}; }
};

typedef std::vector<Boundary_edge> Boundary_edges;

// The set of listed edges, identified by their corners. Threads may insert and erase different edges at the same time.
class Listed_edges
{
public:
  explicit Listed_edges(std::size_t corners) : words_((corners + 63) / 64) { clear(); }

  void clear()
  {
    for (std::atomic<std::uint64_t>& word : words_)
      word.store(0, std::memory_order_relaxed);
  }

  // Returns whether the edge is new.
  bool insert(Index corner)
  {
    return (words_[corner / 64].fetch_or(bit(corner), std::memory_order_relaxed) & bit(corner)) == 0;
  }
  void erase(Index corner) { words_[corner / 64].fetch_and(~bit(corner), std::memory_order_relaxed); }

private:
  static std::uint64_t bit(Index corner) { return std::uint64_t(1) << (corner % 64); }

  std::vector<std::atomic<std::uint64_t> > words_;
};

// The data that the blocks of a minimization share. Each block reads and writes the parts of its own clusters.
template <class Energy>
struct Minimization_state
{
  const Clustering_input& input;
  Cluster_labels& labels;
  Energy_evaluation<Energy> energy;
  std::vector<Cluster_sums<Energy> > clusters;
  std::vector<Move_time> last_change; // of each cluster
  Listed_edges listed;
  Feature_rules* rules; // null without features
  // For each vertex, whether clusters of several blocks meet there; empty if there is only one block.
  std::vector<char> is_shared;
  bool checks_boundary_counts = false; // whether moves must also pass the paper's check
};

// Prefetches memory. On a large mesh, faces along cluster boundaries lie far apart in memory; loops that prefetch
// several of them before reading the first wait once for all.
//
// Inlining is forced because g++ drops calls of functions without side effects.
BOOST_FORCEINLINE void prefetch([[maybe_unused]] const void* address)
{
#ifdef __GNUC__
  __builtin_prefetch(address);
#endif
}

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
    return (across_n != from) != (across_p != from) && !labels_.touches(v2, to);
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

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_MINIMIZATION_STATE_H
