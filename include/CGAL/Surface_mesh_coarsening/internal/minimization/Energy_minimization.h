// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_MINIMIZATION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_MINIMIZATION_H

#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Moments.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Block_minimization.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Boundary_edges.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_model.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The minimization (sections 5.1 and 8.2 of the paper), in rounds over the edges between clusters. The face on one of the two
// sides joins the cluster on the other side, whichever lowers the energy more, as long as the clusters remain discs whose dual is
// a simplicial surface. All energies are computed from the current sums, so the energy is a function of the clustering and
// decreases with each move.
//
// If there are many clusters, they are divided into blocks, each of which runs several rounds independently, in parallel. An edge
// whose face could not move because of another block belongs to a block of a second division next. The few edges that are
// postponed again are processed in order. The two divisions alternate. With the paper's check, the rounds run over the whole
// mesh, as in the paper.
template <class Energy>
class Energy_minimization : public Minimization
{
  typedef Cluster_sums<Energy> Sums;
  typedef Block_minimization<Energy> Block;

public:
  Energy_minimization(const Featured_input& input, Cluster_labels& labels, const Energy_evaluation<Energy>& energy,
                      bool checks_boundary_counts, const Run_context& context)
    : labels_(labels), context_(context), shared_cancellation_(context),
      state_{input.items, labels, energy, {}, {}, Listed_edges(input.items.mesh.corner_vertex.size()), nullptr, {},
             checks_boundary_counts}
  {
    add_up(context_);
    const std::size_t clusters = state_.clusters.size();
    if (input.cells) {
      rules_.emplace(*input.cells, labels);
      rules_->count(clusters);
      state_.rules = &*rules_;
    }
    if (clusters >= 2 * clusters_per_block && !checks_boundary_counts)
      divide(clusters / clusters_per_block);
  }

  std::size_t rounds_at_a_time() const override { return is_divided() ? 5 : 1; }

  Minimization_progress run(const Minimization_end& end) override
  {
    shared_cancellation_.begin();
    //! [recount]
    // Repeated updates accumulate rounding errors in the sums.
    if (rounds_since_sums_ >= 64)
      add_up(context_.uninterrupted());
    //! [recount]
    Minimization_progress progress = run_rounds(end);
    // A round skips edges whose two clusters have not changed. Other clusters also determine whether a move is valid, so the
    // minimization has ended only if no edge at all permits a move.
    if (progress.moves == 0) {
      progress.rounds = 0;
      for (Boundary_edge& e : edges_)
        e.tested = 0;
      progress += run_rounds(end);
    }
    rounds_since_sums_ += progress.rounds;
    CGAL_expensive_assertion(agrees_with_recount() && has_all_edges());
    return progress;
  }

  // Returns whether the boundary-edge counts and the sums agree with a computation from scratch.
  bool agrees_with_recount() const
  {
    if (labels_.recounted() != labels_.boundary_counts())
      return false;
    std::vector<Sums> fresh;
    state_.energy.add_up(state_.input, labels_, fresh, Run_context());
    double mean = 0;
    for (const Sums& x : fresh)
      mean += x.energy / double(fresh.size());
    for (std::size_t i = 0; i < fresh.size(); ++i) {
      const Sums &x = state_.clusters[i], &y = fresh[i];
      if (x.faces != y.faces || !(std::abs(x.energy - y.energy) <= 1e-9 * (y.energy + mean)))
        return false;
    }
    return true;
  }

  // Returns whether the edges between clusters are listed, each once.
  bool has_all_edges() const
  {
    Boundary_edges all;
    Listed_edges listed(state_.input.mesh.corner_vertex.size());
    list_boundary_edges(labels_, all, listed, Run_context());
    std::vector<Index> expected, corners;
    for (const Boundary_edge& e : all)
      expected.push_back(e.corner);
    for (const Boundary_edge& e : edges_)
      if (!e.is_inner() && labels_[e.face[0]] != labels_[e.face[1]])
        corners.push_back(e.corner);
    std::sort(expected.begin(), expected.end());
    std::sort(corners.begin(), corners.end());
    return corners == expected;
  }

  double energy() const override
  {
    double sum = 0;
    for (const Sums& x : state_.clusters)
      sum += x.energy;
    return sum;
  }

private:
  // Smaller blocks have many edges to other blocks. Larger blocks exceed the caches and leave threads without work.
  static constexpr std::size_t clusters_per_block = 384;

  bool is_divided() const { return divisions_[0].size() > 1; }

  void add_up(const Run_context& context)
  {
    state_.energy.add_up(state_.input, labels_, state_.clusters, context);
    rounds_since_sums_ = 0;
  }

  // Divides the clusters in two orthogonal frames whose planes intersect at large angles, so nearly every cluster at the border
  // of a block in one frame is inside a block in the other. Coordinates that differ only by rounding errors of fused operations
  // count as equal.
  void divide(std::size_t blocks)
  {
    std::vector<Moments> clusters(state_.clusters.size());
    add_up_centroids(state_.input, labels_, clusters, context_);
    std::vector<Vector> straight, oblique;
    for (const Moments& x : clusters) {
      const Vector p = without_last_digits(x.centroid);
      straight.push_back(p);
      oblique.push_back({p[0] + 2 * p[1] + 2 * p[2], 2 * p[0] + p[1] - 2 * p[2], 2 * p[0] - 2 * p[1] + p[2]});
    }
    divisions_ = {{Cluster_blocks(std::move(straight), blocks, context_), Cluster_blocks(std::move(oblique), blocks, context_)}};
  }

  Minimization_progress run_rounds(const Minimization_end& end)
  {
    if (!is_complete_) {
      whole_.reset();
      list_boundary_edges(labels_, edges_, state_.listed, context_);
      begin_time();
    }
    is_complete_ = false; // in case the minimization is cancelled
    const Minimization_progress progress = is_divided() ? run_blocks(end) : run_whole(end);
    is_complete_ = true;
    return progress;
  }

  void begin_time()
  {
    now_ = 1;
    state_.last_change.assign(state_.clusters.size(), now_);
    state_.last_change.push_back(0);
  }

  Minimization_progress run_whole(const Minimization_end& end)
  {
    if (!whole_)
      whole_.emplace(state_, edges_, now_, shared_cancellation_);
    return whole_->run(end.max_rounds, end.tolerance * energy());
  }

  Minimization_progress run_blocks(const Minimization_end& end)
  {
    look_up_edges();
    const double least_gain_per_edge = end.tolerance * energy() / double(edges_.size());
    Minimization_progress progress;
    Boundary_edges waiting = std::move(edges_), done;
    for (const Cluster_blocks& blocks : divisions_)
      progress += run_division(blocks, end.max_rounds, least_gain_per_edge, waiting, done);
    std::swap(divisions_[0], divisions_[1]);
    Part last;
    last.edges.swap(waiting);
    run_part(last, end.max_rounds, least_gain_per_edge);
    progress += take(last, done, waiting);
    edges_.swap(done);
    return progress;
  }

  // Removes edges that now lie within a cluster, and begins a new time.
  void look_up_edges()
  {
    for_each_number(context_.uninterrupted(), edges_.size(), [&](Index i) {
      Boundary_edge& e = edges_[i];
      e.tested = e.is_due(state_.last_change) ? 0 : 1;
      e.look_up(labels_);
      if (e.is_inner())
        state_.listed.erase(e.corner);
    });
    const auto is_inner = [](const Boundary_edge& e) { return e.is_inner(); };
    edges_.erase(std::remove_if(edges_.begin(), edges_.end(), is_inner), edges_.end());
    begin_time();
  }

  // The edges of a block, and the result of its minimization.
  struct Part
  {
    Boundary_edges edges, postponed;
    Minimization_progress progress;
    Move_time now = 0;
  };

  // Runs the blocks of a division on the waiting edges.
  Minimization_progress run_division(const Cluster_blocks& blocks, std::size_t max_rounds, double least_gain_per_edge,
                                     Boundary_edges& waiting, Boundary_edges& done)
  {
    std::vector<Boundary_edges> distributed = distribute(waiting, blocks, context_);
    waiting = std::move(distributed.back());
    share_vertices(blocks, waiting, done);
    std::vector<Part> parts(blocks.size());
    run_concurrently(context_, parts.size(), [&](std::size_t i) {
      parts[i].edges.swap(distributed[i]);
      run_part(parts[i], max_rounds, least_gain_per_edge);
    });
    state_.is_shared.clear();
    Minimization_progress progress;
    std::size_t number = done.size() + waiting.size();
    for (const Part& part : parts)
      number += part.edges.size() + part.postponed.size();
    if (number > done.capacity())
      done.reserve(number + number / 16); // the remaining memory is reserved later
    for (Part& part : parts)
      progress += take(part, done, waiting);
    return progress;
  }

  void share_vertices(const Cluster_blocks& blocks, const Boundary_edges& between, const Boundary_edges& done)
  {
    const Flat_mesh& m = state_.input.mesh;
    state_.is_shared.assign(m.number_of_vertices(), false);
    for (const Boundary_edge& e : between)
      mark_ends(m, e, state_.is_shared);
    for (const Boundary_edge& e : done)
      if (blocks[labels_[e.face[0]]] != blocks[labels_[e.face[1]]])
        mark_ends(m, e, state_.is_shared);
  }

  void run_part(Part& part, std::size_t max_rounds, double least_gain_per_edge)
  {
    Block block(state_, part.edges, now_, shared_cancellation_);
    part.progress = block.run(max_rounds, least_gain_per_edge * double(part.edges.size()));
    block.finish(part.postponed);
    part.now = block.now();
  }

  const Minimization_progress& take(Part& part, Boundary_edges& done, Boundary_edges& waiting)
  {
    done.insert(done.end(), part.edges.begin(), part.edges.end());
    waiting.insert(waiting.end(), part.postponed.begin(), part.postponed.end());
    Boundary_edges().swap(part.edges); // frees memory
    now_ = (std::max)(now_, part.now);
    return part.progress;
  }

  Cluster_labels& labels_;
  const Run_context context_;
  Shared_cancellation_point shared_cancellation_;
  std::optional<Feature_rules> rules_;
  Minimization_state<Energy> state_;
  std::array<Cluster_blocks, 2> divisions_;
  Boundary_edges edges_;
  bool is_complete_ = false;
  std::optional<Block> whole_; // a block of all edges, if clusters are not divided
  Move_time now_ = 1;
  std::size_t rounds_since_sums_ = 0;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_MINIMIZATION_H
