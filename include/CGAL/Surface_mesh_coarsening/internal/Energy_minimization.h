// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_ENERGY_MINIMIZATION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_ENERGY_MINIMIZATION_H

#include <CGAL/Surface_mesh_coarsening/internal/Chunked_list.h>
#include <CGAL/Surface_mesh_coarsening/internal/Cluster_energy.h>
#include <CGAL/Surface_mesh_coarsening/internal/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/Valid_moves.h>
#include <CGAL/Surface_mesh_coarsening/internal/Visitor_handle.h>
#include <CGAL/Surface_mesh_coarsening/internal/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Sections 5.1 and 8.2 of the paper: in rounds over the edges between clusters, the face on one side or on the other
// joins the cluster across, whichever lowers the energy more, as long as the clusters remain discs whose dual is a
// simplicial surface. All weights are those of the current sums, so the energy is a function of the clustering and
// falls with each move.
//
// What a test needs of the two faces at an edge is kept with the edge: edges between clusters are few, and they are gone through
// in order, which is kinder to caches than the faces are.
//
// Batch by batch of edges, a round first looks for such moves, at the sums as they are, which can be done for many edges at
// a time, and then makes those in the order of the edges that still lower the energy.
template <class Weight>
class Energy_minimization
{
  typedef Face_terms<Weight> Face;
  typedef Cluster_sums<Weight> Sums;

public:
  Energy_minimization(const Clustering_input& input, Cluster_labels& labels, std::size_t number_of_clusters,
                      const Weight& weight, const Checkpoint& checkpoint, Execution execution)
    : input_(input), mesh_(input.mesh), labels_(labels), energy_(weight), checkpoint_(checkpoint),
      execution_(execution), moves_(labels, number_of_clusters), clusters_(number_of_clusters), round_of_change_(number_of_clusters, 0)
  {
    if (input.cells)
      moves_.keep_features(*input.cells);
    energy_.add_up(input_, labels_, clusters_, checkpoint_);
    list_boundary_edges();
  }

  // One round. Returns the number of moves.
  std::size_t round()
  {
    ++round_;
    // Sums that are updated again and again drift by roundings.
    if (round_ % 64 == 0)
      energy_.add_up(input_, labels_, clusters_, Checkpoint()); // must not end half done
    std::size_t moves = run(false);
    // Edges were passed over whose two clusters had not changed. Whether a move is allowed depends on others, too:
    // the end is reached when no edge at all has a move left.
    if (moves == 0)
      moves = run(true);
    CGAL_expensive_assertion(agrees_with_recount());
    return moves;
  }

  // Whether the boundary-edge counts and the sums are those that counting and adding up from scratch gives.
  bool agrees_with_recount() const
  {
    if (labels_.recounted() != labels_.boundary_counts())
      return false;
    std::vector<Sums> fresh(clusters_.size());
    energy_.add_up(input_, labels_, fresh, Checkpoint());
    const auto agree = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); };
    for (std::size_t i = 0; i < clusters_.size(); ++i) {
      const Sums &x = clusters_[i], &y = fresh[i];
      if (x.faces != y.faces || !agree(x.mass, y.mass) || !agree(x.inertia, y.inertia) || !agree(x.energy, y.energy))
        return false;
    }
    return true;
  }

  double energy() const
  {
    double sum = 0;
    for (const Sums& x : clusters_)
      sum += x.energy;
    return sum;
  }

  std::size_t tests() const { return tests_; }

private:
  static constexpr double no_gain = -std::numeric_limits<double>::infinity();
  static constexpr std::size_t batch = 1024, part_of_batch = 128; // edges

  // An edge between two faces, that of the smaller index first, by its corner in that.
  struct Plain_edge
  {
    std::array<Index, 2> face;
    Index corner;
  };

  struct Edge
  {
    std::array<Face, 2> data;
    std::array<Index, 2> face;
    Index corner;
  };

  // A face of an edge joins a cluster, that of the other face when the move was found.
  struct Move
  {
    Index edge;
    int side;
    Index to;
  };

  // What a move would make of the energies of the two clusters.
  struct Trial
  {
    int side;
    Index to;
    double gain;      // by which the energy falls
    double scale;     // of the changes of energy that it is the difference of
    double magnitude; // of the energies that these are the difference of
  };

  Trial trial(const Edge& e, int side, Index to) const
  {
    const Sums& source = clusters_[labels_[e.face[side]]];
    const Sums& target = clusters_[to];
    const Face& face = e.data[side];
    if (source.faces == 1 || energy_.cannot_gain(source, target, face))
      return {side, to, no_gain, 0, 0};
    const double without = energy_.energy_without(source, face), with = energy_.energy_with(target, face);
    const double lost = source.energy - without, won = with - target.energy;
    return {side, to, lost - won, std::abs(lost) + std::abs(won), source.energy + target.energy + without + with};
  }

  // Gains this small, relative to what they are the difference of, are taken for none. So moves between equal
  // energies, frequent on regular meshes, do not depend on roundings, and each move lowers the energy as computed.
  static bool is_gain(const Trial& t) { return t.gain > 1e-7 * t.scale && t.gain > 1e-12 * t.magnitude; }
  static bool is_better(const Trial& t, const Trial& than)
  {
    return t.gain - than.gain > 1e-7 * (t.scale + than.scale);
  }

  void list_boundary_edges()
  {
    is_listed_.assign(mesh_.corner_vertex.size(), false);
    for (Index f = 0; f < Index(mesh_.number_of_faces()); ++f) {
      checkpoint_.pass();
      for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1]; ++c) {
        const Index g = mesh_.face_across[c];
        if (g != NONE && g > f && labels_[g] != labels_[f])
          list({{{f, g}}, c});
      }
    }
  }

  std::size_t run(bool all)
  {
    std::size_t moves = 0;
    const std::size_t edges = edges_.size();
    for (std::size_t begin = 0; begin < edges; begin += batch) {
      checkpoint_.pass((std::min)(edges - begin, batch));
      find_moves(begin, (std::min)(edges, begin + batch), all);
      for (const std::vector<Move>& found : found_)
        for (const Move& m : found) {
          checkpoint_.pass(); // a move takes longer than to look for one
          moves += make(m);
        }
    }
    if (moves > 0)
      update_list();
    return moves;
  }

  // Section 8.2: of the three cases at an edge, as it is or either face moved, the one of the smallest energy.
  void find_moves(std::size_t first, std::size_t last, bool all)
  {
    found_.resize((last - first + part_of_batch - 1) / part_of_batch);
    tested_.assign(found_.size(), 0);
    for_each_chunk(execution_, last - first, part_of_batch, [&](std::size_t i, std::size_t begin, std::size_t end) {
      found_[i].clear();
      for (std::size_t j = begin; j < end; ++j) {
        const Edge& e = edges_[first + j];
        const Index x = labels_[e.face[0]], y = labels_[e.face[1]];
        if (x == y || (!all && round_of_change_[x] + 1 < round_ && round_of_change_[y] + 1 < round_))
          continue;
        ++tested_[i];
        Trial first_trial = trial(e, 0, y), second_trial = trial(e, 1, x);
        if (is_better(second_trial, first_trial))
          std::swap(first_trial, second_trial);
        for (const Trial& t : {first_trial, second_trial})
          if (is_gain(t) && moves_.keeps_discs(e.face[t.side], t.to)) {
            found_[i].push_back({Index(first + j), t.side, t.to});
            break;
          }
      }
    });
    for (const std::size_t n : tested_)
      tests_ += n;
  }

  bool make(const Move& m)
  {
    const Edge e = edges_[m.edge];
    const Index f = e.face[m.side], from = labels_[f];
    if (from == m.to || !is_gain(trial(e, m.side, m.to)) || !moves_.move(f, m.to))
      return false;
    accept(f, e.data[m.side], from, m.to);
    return true;
  }

  void accept(Index f, const Face& data, Index from, Index to)
  {
    Sums& source = clusters_[from];
    Sums& target = clusters_[to];
    CGAL_assertion_code(const double before = source.energy + target.energy;)
    energy_.remove(source, data);
    energy_.add(target, data);
    CGAL_assertion(source.energy + target.energy < before);
    round_of_change_[from] = round_of_change_[to] = round_;
    for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1]; ++c) {
      const Index g = mesh_.face_across[c];
      if (g == NONE || labels_[g] == to)
        continue;
      const Index corner = f < g ? c : mesh_.corner_of(g, mesh_.corner_vertex[mesh_.next_corner(f, c)]);
      if (!is_listed_[corner]) {
        is_listed_[corner] = true;
        new_edges_.push_back({{{(std::min)(f, g), (std::max)(f, g)}}, corner});
      }
    }
  }

  // Edges that came to lie within a cluster leave the list at the end of a round; those that came to lie between two, and still
  // do, are added.
  void update_list()
  {
    const auto is_inner = [&](const auto& e) { return labels_[e.face[0]] == labels_[e.face[1]]; };
    edges_.remove_if([&](const Edge& e) {
      if (is_inner(e))
        is_listed_[e.corner] = false;
      return is_inner(e);
    });
    for (const Plain_edge& e : new_edges_)
      if (is_inner(e))
        is_listed_[e.corner] = false;
      else
        list(e);
    new_edges_.clear();
  }

  void list(const Plain_edge& e)
  {
    is_listed_[e.corner] = true;
    edges_.push_back(Edge{{{energy_.terms_of(input_, e.face[0]), energy_.terms_of(input_, e.face[1])}}, e.face, e.corner});
  }

  const Clustering_input& input_;
  const Flat_mesh& mesh_;
  Cluster_labels& labels_;
  Cluster_energy<Weight> energy_;
  Checkpoint checkpoint_;
  Execution execution_;
  Valid_moves moves_;
  std::vector<Sums> clusters_;
  std::vector<Index> round_of_change_;     // of each cluster
  Chunked_list<Edge> edges_;               // between clusters
  std::vector<Plain_edge> new_edges_;      // that came to lie between clusters in this round
  std::vector<bool> is_listed_;            // per corner
  std::vector<std::vector<Move> > found_;  // per part of a batch
  std::vector<std::size_t> tested_;        // per part of a batch
  Index round_ = 0;
  std::size_t tests_ = 0;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_ENERGY_MINIMIZATION_H
