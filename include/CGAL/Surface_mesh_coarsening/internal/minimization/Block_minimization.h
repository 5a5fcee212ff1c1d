// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_BLOCK_MINIMIZATION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_BLOCK_MINIMIZATION_H

#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Minimization_state.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The minimization (section 8.2 of the paper) of a block: rounds over the edges between its clusters. The face on one of the two
// sides joins the cluster on the other side, whichever lowers the energy more, if both clusters remain discs and the dual remains
// a simplicial surface.
//
// A face moves only if none of its vertices is shared with another block, and if it is not part of a feature. Section
// smc_blocks of the manual proves that the moves of a block then neither read nor write data that moves of another block write.
template <class Energy>
class Block_minimization
{
  typedef typename Energy::Face_data Face;
  typedef Cluster_sums<Energy> Sums;
  typedef typename Energy_evaluation<Energy>::Outcome Outcome;
  typedef Minimization_state<Energy> State;

public:
  // `edges` are the edges between clusters of the block. `now` is a time after all previous changes and tests.
  Block_minimization(State& state, Boundary_edges& edges, Move_time now, Shared_cancellation_point& cancellation)
    : state_(state), mesh_(state.input.mesh), labels_(state.labels), cancellation_(cancellation),
      moves_(state.labels, state.rules), edges_(edges), now_(now)
  {}

  // Runs at most `max_rounds` rounds, until a round moves no face or lowers the energy by at most `least_gain`. Returns what was
  // done since the last call.
  Minimization_progress run(std::size_t max_rounds, double least_gain)
  {
    std::size_t moves;
    double gain;
    do {
      moves = progress_.moves;
      gain = round();
      ++progress_.rounds;
    } while (progress_.rounds < max_rounds && progress_.moves != moves && gain > least_gain && !is_cancelled_);
    return std::exchange(progress_, {});
  }

  // Runs one round. Returns the decrease of the energy.
  double round()
  {
    const double before = gain_;
    const Index size = Index(edges_.size());
    for (Index i = 0; i < size && !is_cancelled_;) {
      const Index first = i;
      for (due_.clear(); i < size && due_.size() < batch; ++i)
        if (edges_[i].is_due(state_.last_change))
          due_.push_back(i);
      is_cancelled_ = !cancellation_.poll(i - first);
      find_moves();
      for (const Move& m : found_)
        make(m);
    }
    append_new();
    return gain_ - before;
  }

  // Ends the minimization of the block. Edges within clusters leave the list. Edges at which a face could not move because of
  // other blocks or features are appended to `postponed`.
  void finish(Boundary_edges& postponed)
  {
    std::size_t n = 0;
    for (Boundary_edge e : edges_) {
      const bool is_due = e.is_due(state_.last_change);
      e.look_up(labels_);
      if (e.is_inner()) {
        state_.listed.erase(e.corner);
        continue;
      }
      e.terms = NONE;
      if (is_due || e.is_postponed)
        e.tested = 0;
      if (std::exchange(e.is_postponed, false))
        postponed.push_back(e);
      else
        edges_[n++] = e;
    }
    edges_.resize(n);
    edges_.shrink_to_fit(); // saves memory, because there are many blocks
  }

  std::size_t moves() const { return progress_.moves; }
  Move_time now() const { return now_; }

private:
  static constexpr double no_gain = -std::numeric_limits<double>::infinity();
  static constexpr Index batch = 32;

  // A face of an edge joins a cluster: the cluster of the other face at the time when the move was found.
  struct Move
  {
    Index edge;
    int side;
    Index to;
  };

  // The sides of an edge whose faces would lower the energy by joining the other cluster, the better side first.
  struct Candidate
  {
    Index edge;
    int number;
    std::array<int, 2> side;
  };

  typedef std::array<Face, 2> Terms;

  // The result of a move for the two clusters.
  struct Trial
  {
    double gain;      // the decrease of the energy
    double scale;     // the scale of the two changes of energy whose difference is the gain
    double magnitude; // the magnitude of the energies whose differences are these changes
    Outcome without, with;
  };

  BOOST_FORCEINLINE Trial trial(const Face& face, Index from, Index to) const
  {
    const Sums& source = state_.clusters[from];
    const Sums& target = state_.clusters[to];
    if (source.faces == 1 || state_.energy.cannot_gain(source, target, face))
      return {no_gain, 0, 0, {}, {}};
    const Outcome without = state_.energy.outcome_without(source, face), with = state_.energy.outcome_with(target, face);
    const double less = without, more = with, lost = source.energy - less, won = more - target.energy;
    return {lost - won, std::abs(lost) + std::abs(won), source.energy + target.energy + less + more, without, with};
  }

  // A gain that is this small relative to the terms of its difference counts as none. So moves between equal energies, which are
  // frequent on regular meshes, do not depend on rounding errors, and each move lowers the computed energy.
  //! [gain]
  static bool is_gain(const Trial& t) { return t.gain > 1e-7 * t.scale && t.gain > 1e-12 * t.magnitude; }
  static bool is_better(const Trial& t, const Trial& than)
  {
    return t.gain - than.gain > 1e-7 * (t.scale + than.scale);
  }
  //! [gain]

  // Returns the terms of the faces at an edge, which are computed when they are first needed.
  const Terms& terms(Boundary_edge& e)
  {
    if (e.terms == NONE) {
      if (free_terms_.empty()) {
        free_terms_.push_back(Index(terms_.size()));
        terms_.emplace_back();
      }
      e.terms = free_terms_.back();
      free_terms_.pop_back();
      terms_[e.terms] = {{state_.energy.terms_of(state_.input, e.face[0]), state_.energy.terms_of(state_.input, e.face[1])}};
    }
    return terms_[e.terms];
  }

  void find_moves()
  {
    candidates_.clear();
    found_.clear();
    for (const Index i : due_)
      prefetch_faces(edges_[i]);
    for (const Index i : due_)
      prefetch_points(edges_[i]);
    for (const Index i : due_)
      find_candidate(i);
    for (const Candidate& x : candidates_)
      moves_.prefetch_labels(face_of(x));
    for (const Candidate& x : candidates_)
      moves_.prefetch_stars(face_of(x));
    for (const Candidate& x : candidates_)
      find_move(x);
  }

  // Prefetch the data that the test of an edge reads, in two steps; the second step reads data prefetched by the first.
  BOOST_FORCEINLINE void prefetch_faces(const Boundary_edge& e) const
  {
    for (const Index f : e.face) {
      prefetch(&labels_.labels()[f]);
      if (e.terms != NONE)
        continue;
      prefetch(&state_.input.density[f]);
      prefetch(&state_.input.area[f]);
      if (!state_.input.item_centroid.empty())
        prefetch(&state_.input.item_centroid[f]);
      prefetch(&mesh_.corner_vertex[mesh_.first_corner[f]]);
    }
  }
  BOOST_FORCEINLINE void prefetch_points(const Boundary_edge& e) const
  {
    if (e.terms != NONE || !state_.input.item_centroid.empty())
      return;
    for (const Index f : e.face)
      for (const Index c : mesh_.corners(f))
        prefetch(&mesh_.points[mesh_.corner_vertex[c]]);
  }

  // Selects, as section 8.2 does, the case of smallest energy at an edge: no move, or a move of either face.
  void find_candidate(Index i)
  {
    Boundary_edge& e = edges_[i];
    e.look_up(labels_);
    e.tested = now_;
    e.is_postponed = false;
    if (e.is_inner()) {
      state_.listed.erase(e.corner);
      if (e.terms != NONE)
        free_terms_.push_back(e.terms);
      return;
    }
    ++progress_.tests;
    const Terms& terms = this->terms(e);
    const std::array<Trial, 2> trials{{trial(terms[0], e.cluster[0], e.cluster[1]), trial(terms[1], e.cluster[1], e.cluster[0])}};
    const int better = is_better(trials[1], trials[0]);
    Candidate candidate{i, 0, {{better, 1 - better}}};
    for (const int side : {better, 1 - better})
      if (is_gain(trials[side]))
        candidate.side[candidate.number++] = side;
    if (candidate.number == 0)
      return;
    candidates_.push_back(candidate);
    moves_.prefetch_corners(face_of(candidate));
  }

  void find_move(const Candidate& x)
  {
    Boundary_edge& e = edges_[x.edge];
    for (int k = 0; k < x.number; ++k) {
      const Index f = e.face[x.side[k]], to = e.cluster[1 - x.side[k]];
      if (must_wait(f)) {
        e.is_postponed = true;
      } else if (state_.checks_boundary_counts && !moves_.boundary_counts_allow(f, to)) {
        ++progress_.refused_by_boundary_counts;
      } else if (moves_.keeps_discs(f, to)) {
        found_.push_back({x.edge, x.side[k], to});
        return;
      } else {
        ++progress_.refused_by_guarantee;
      }
    }
  }

  bool must_wait(Index f) const
  {
    if (state_.is_shared.empty())
      return false;
    return mesh_.any_corner(f, [this](Index c) { return state_.is_shared[mesh_.corner_vertex[c]]; }) ||
           (state_.rules != nullptr && state_.rules->is_on_feature(f));
  }

  Index face_of(const Candidate& x) const { return edges_[x.edge].face[x.side[0]]; }

  void make(const Move& m)
  {
    const Index f = edges_[m.edge].face[m.side], from = labels_[f];
    const Face& face = terms(edges_[m.edge])[m.side];
    if (from == m.to)
      return;
    const Trial t = trial(face, from, m.to);
    if (!is_gain(t) || (state_.checks_boundary_counts && !moves_.boundary_counts_allow(f, m.to)))
      return;
    if (!moves_.move(f, m.to)) {
      ++progress_.refused_by_guarantee;
      return;
    }
    Sums& source = state_.clusters[from];
    Sums& target = state_.clusters[m.to];
    CGAL_assertion_code(const double before = source.energy + target.energy;)
    state_.energy.remove(source, face, t.without);
    state_.energy.add(target, face, t.with);
    CGAL_assertion(source.energy + target.energy < before);
    gain_ += t.gain;
    ++progress_.moves;
    state_.last_change[from] = state_.last_change[m.to] = ++now_;
    note_edges(f, m.to);
  }

  // Lists the edges of a face that has joined cluster `to`, because they may lie between clusters now.
  void note_edges(Index f, Index to)
  {
    for (const Index c : mesh_.corners(f)) {
      const Index g = mesh_.face_across[c];
      if (g == NONE || labels_[g] == to)
        continue;
      const Index corner = f < g ? c : mesh_.opposite_corner(f, c);
      if (state_.listed.insert(corner))
        new_edges_.push_back({{{(std::min)(f, g), (std::max)(f, g)}}, corner, {{NONE, NONE}}, 0, NONE});
    }
  }

  // Removes edges within a cluster, and appends edges between clusters that moves have created.
  void append_new()
  {
    const auto is_inner = [](const Boundary_edge& e) { return e.is_inner(); };
    edges_.erase(std::remove_if(edges_.begin(), edges_.end(), is_inner), edges_.end());
    for (Boundary_edge& e : new_edges_) {
      e.look_up(labels_);
      if (e.is_inner())
        state_.listed.erase(e.corner);
      else
        edges_.push_back(e);
    }
    new_edges_.clear();
  }

  State& state_;
  const Flat_mesh& mesh_;
  Cluster_labels& labels_;
  Shared_cancellation_point& cancellation_;
  Valid_moves moves_;
  Boundary_edges& edges_;
  Boundary_edges new_edges_;
  std::vector<Terms> terms_;      // of the faces at edges that have been tested
  std::vector<Index> free_terms_; // the terms of removed edges
  std::vector<Index> due_;
  std::vector<Candidate> candidates_;
  std::vector<Move> found_;
  Move_time now_;
  double gain_ = 0;
  Minimization_progress progress_; // since the last call of `run()`
  bool is_cancelled_ = false;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_BLOCK_MINIMIZATION_H
