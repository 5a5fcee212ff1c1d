// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_MINIMIZATION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_MINIMIZATION_H

#include <CGAL/Surface_mesh_coarsening/internal/minimization/Boundary_edges.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Cluster_energy.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Minimization.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Valid_moves.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/Visitor_handle.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Sections 5.1 and 8.2 of the paper: in rounds over the edges between clusters, the face on one side joins the cluster
// across, whichever of the two faces lowers the energy more, as long as the clusters remain discs whose dual is a
// simplicial surface. All weights are weights of the current sums, so the energy is a function of the clustering and
// decreases with each move.
//
// For each batch of edges, a round first finds such moves with the current sums, which can run in parallel, and then
// makes, in the order of the edges, the moves that still lower the energy.
template <class Weight>
class Energy_minimization : public Minimization
{
  typedef Face_terms<Weight> Face;
  typedef Cluster_sums<Weight> Sums;
  typedef typename Cluster_energy<Weight>::Outcome Outcome;
  typedef Boundary_edges<Weight> Edges;

public:
  Energy_minimization(const Featured_input& input, Cluster_labels& labels, std::size_t number_of_clusters,
                      const Weight& weight, const Cancellation_point& cancellation, Execution execution)
    : input_(input.items), labels_(labels), energy_(weight), cancellation_(cancellation),
      execution_(execution), moves_(labels, number_of_clusters), clusters_(number_of_clusters),
      edges_(input.items, labels, energy_, number_of_clusters)
  {
    if (input.cells)
      moves_.keep_features(*input.cells);
    energy_.add_up(input_, labels_, clusters_, cancellation_, execution_);
    edges_.list_all(cancellation_, execution_);
  }

  // Runs one round. Returns the number of moves.
  std::size_t round() override
  {
    ++round_;
    // Repeated updates of sums accumulate rounding errors.
    if (round_ % 64 == 0)
      energy_.add_up(input_, labels_, clusters_, Cancellation_point(), execution_); // must not be interrupted
    std::size_t moves = run(in_last_round | in_this_round);
    // Edges between unchanged clusters were skipped, but other clusters, too, decide whether a move is valid. The
    // minimization ends when no edge at all has a move left.
    if (moves == 0)
      moves = run(at_any_time);
    edges_.end_round();
    CGAL_expensive_assertion(agrees_with_recount());
    return moves;
  }

  // Returns whether the boundary-edge counts and the sums agree with recomputed ones.
  bool agrees_with_recount() const
  {
    if (labels_.recounted() != labels_.boundary_counts())
      return false;
    std::vector<Sums> fresh(clusters_.size());
    energy_.add_up(input_, labels_, fresh, Cancellation_point());
    const auto agree = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); };
    for (std::size_t i = 0; i < clusters_.size(); ++i) {
      const Sums &x = clusters_[i], &y = fresh[i];
      if (x.faces != y.faces || !agree(x.mass, y.mass) || !agree(x.inertia, y.inertia) || !agree(x.energy, y.energy))
        return false;
    }
    return true;
  }

  double energy() const override
  {
    double sum = 0;
    for (const Sums& x : clusters_)
      sum += x.energy;
    return sum;
  }

  std::size_t tests() const override { return tests_; }

private:
  static constexpr double no_gain = -std::numeric_limits<double>::infinity();
  static constexpr std::size_t batch = 1024, edges_of_part = 32;

  // A face of an edge joins a cluster, the cluster of the other face when the move was found.
  struct Move
  {
    Index edge;
    int side;
    Index to;
  };

  // The sides of an edge whose faces would lower the energy by joining the cluster across, the better one first.
  struct Candidate
  {
    Index edge;
    int number;
    std::array<int, 2> side;
  };

  struct Part_of_batch
  {
    std::size_t tests;
    std::vector<Candidate> candidates;
    std::vector<Move> found;
  };

  // The two clusters after a move.
  struct Trial
  {
    double gain;      // decrease of the energy
    double scale;     // magnitude of the energy changes whose difference it is
    double magnitude; // magnitude of the energies whose differences these are
    Outcome without, with;
  };

  Trial trial(const Face& face, Index from, Index to) const
  {
    const Sums& source = clusters_[from];
    const Sums& target = clusters_[to];
    if (source.faces == 1 || energy_.cannot_gain(source, target, face))
      return {no_gain, 0, 0, {}, {}};
    const Outcome without = energy_.outcome_without(source, face), with = energy_.outcome_with(target, face);
    const double lost = source.energy - without.energy, won = with.energy - target.energy;
    return {lost - won, std::abs(lost) + std::abs(won), source.energy + target.energy + without.energy + with.energy, without,
            with};
  }

  // A gain counts only if it exceeds a small part of the terms whose difference it is. So moves between equal energies,
  // frequent on regular meshes, do not depend on rounding, and each move lowers the computed energy.
  static bool is_gain(const Trial& t) { return t.gain > 1e-7 * t.scale && t.gain > 1e-12 * t.magnitude; }
  static bool is_better(const Trial& t, const Trial& than)
  {
    return t.gain - than.gain > 1e-7 * (t.scale + than.scale);
  }

  // Visits the edges at clusters changed at one of the times.
  std::size_t run(Change_times times)
  {
    if (!edges_.is_complete()) // cancelled during listing
      edges_.list_all(cancellation_, execution_);
    std::size_t moves = 0;
    const std::size_t edges = edges_.size();
    for (std::size_t begin = 0, end; begin < edges; begin = end) {
      end = edges_.list_changed(begin, batch, times, tested_);
      cancellation_.poll(end - begin);
      find_moves();
      for (const Part_of_batch& part : parts_)
        for (const Move& m : part.found) {
          cancellation_.poll(); // a move takes longer than a test
          moves += make(m);
        }
    }
    if (moves > 0)
      edges_.update(cancellation_, execution_);
    return moves;
  }

  void find_moves()
  {
    parts_.resize((tested_.size() + edges_of_part - 1) / edges_of_part);
    for_each_chunk(execution_, tested_.size(), edges_of_part,
                   [this](std::size_t i, std::size_t begin, std::size_t end) { find_moves(begin, end, parts_[i]); });
    for (const Part_of_batch& part : parts_)
      tests_ += part.tests;
  }

  void find_moves(std::size_t begin, std::size_t end, Part_of_batch& part)
  {
    part.tests = 0;
    part.candidates.clear();
    part.found.clear();
    for (std::size_t j = begin; j < end; ++j)
      edges_.look_up(tested_[j]);
    for (std::size_t j = begin; j < end; ++j) {
      const std::array<Index, 2>& clusters = edges_.clusters(tested_[j]);
      if (clusters[0] == clusters[1])
        continue;
      ++part.tests;
      const Candidate candidate = candidate_at(tested_[j]);
      if (candidate.number == 0)
        continue;
      part.candidates.push_back(candidate);
      moves_.prefetch_corners(face_of(candidate));
    }
    for (const Candidate& x : part.candidates)
      moves_.prefetch_labels(face_of(x));
    for (const Candidate& x : part.candidates)
      moves_.prefetch_stars(face_of(x));
    for (const Candidate& x : part.candidates)
      for (int k = 0; k < x.number; ++k) {
        const Index to = edges_.clusters(x.edge)[1 - x.side[k]];
        if (moves_.keeps_discs(edges_.faces(x.edge)[x.side[k]], to)) {
          part.found.push_back({x.edge, x.side[k], to});
          break;
        }
      }
  }

  Index face_of(const Candidate& x) const { return edges_.faces(x.edge)[x.side[0]]; }

  // Section 8.2: of the three cases at an edge, unchanged or either face moved, returns the one of smallest energy.
  Candidate candidate_at(Index edge) const
  {
    const std::array<Index, 2>& clusters = edges_.clusters(edge);
    const typename Edges::Terms& terms = edges_.terms(edge);
    const std::array<Trial, 2> trials{{trial(terms[0], clusters[0], clusters[1]), trial(terms[1], clusters[1], clusters[0])}};
    const int better = is_better(trials[1], trials[0]);
    Candidate candidate{edge, 0, {{better, 1 - better}}};
    for (const int side : {better, 1 - better})
      if (is_gain(trials[side]))
        candidate.side[candidate.number++] = side;
    return candidate;
  }

  bool make(const Move& m)
  {
    const Index f = edges_.faces(m.edge)[m.side], from = labels_[f];
    const Face& face = edges_.terms(m.edge)[m.side];
    if (from == m.to)
      return false;
    const Trial t = trial(face, from, m.to);
    if (!is_gain(t) || !moves_.move(f, m.to))
      return false;
    Sums& source = clusters_[from];
    Sums& target = clusters_[m.to];
    CGAL_assertion_code(const double before = source.energy + target.energy;)
    energy_.remove(source, face, t.without);
    energy_.add(target, face, t.with);
    CGAL_assertion(source.energy + target.energy < before);
    edges_.note_change(from);
    edges_.note_change(m.to);
    edges_.note_edges(f, m.to);
    return true;
  }

  const Clustering_input& input_;
  Cluster_labels& labels_;
  Cluster_energy<Weight> energy_;
  Cancellation_point cancellation_;
  Execution execution_;
  Valid_moves moves_;
  std::vector<Sums> clusters_;
  Edges edges_;
  std::vector<Index> tested_; // edges of a batch
  std::vector<Part_of_batch> parts_;
  Index round_ = 0;
  std::size_t tests_ = 0;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_MINIMIZATION_H
