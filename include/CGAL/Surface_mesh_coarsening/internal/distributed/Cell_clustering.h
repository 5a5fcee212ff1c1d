// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_CLUSTERING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_CLUSTERING_H

#include <CGAL/Surface_mesh_coarsening/internal/distributed/Cell_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Cell_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Cells.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Cluster_tasks.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Distributed_choice.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Word_routing.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Divides blocks into cells, and clusters the mesh of cells on rank 0.
class Cell_clustering
{
public:
  Cell_clustering(Rank_context& context, const Distributed_choice& choice, const Face_names& names, const Local_frame& frame,
                  const Morton_curve& curve)
    : context_(context), choice_(choice), names_(names), frame_(frame), curve_(curve)
  {}

  // Each own face in `blocks` receives its cell and, unless it has a density, its deviation. If the topology leaves too little
  // freedom to the cells, smaller cells are tried. Cells of level 0 are the faces.
  void run(Word_store& blocks, std::uint64_t number_of_faces)
  {
    for (level_ = level_of_cells(number_of_faces); !run_at_level(blocks); --level_)
      ;
  }

  Index level() const { return level_; }
  const Cluster_tasks& tasks() const { return tasks_; }
  const Linear_density& density() const { return density_; }
  // Returns the cluster of a cell of this rank.
  Index cluster_of_cell(Index cell) const { return Index(clusters_[cell]); }
  // Valid on rank 0:
  const Coarsening_report& report() const { return report_; }
  // Valid on rank 0 if the cells have level 0:
  Placed_dual& dual() { return dual_; }
  // Valid on rank 0 otherwise, if vertices are placed on the surface of cells:
  Cell_surface& surface() { return *surface_; }

private:
  static constexpr Index max_level = 6;
  static constexpr std::size_t cells_per_cluster = 12;

  // Returns the largest level with enough cells for each cluster: a neighborhood of level k has 1 + 3 k (k + 1) / 2 faces, and
  // the neighborhoods contain about three quarters of all faces.
  Index level_of_cells(std::uint64_t number_of_faces) const
  {
    const double faces_each = double(number_of_faces) / double(choice_.number_of_vertices) / double(cells_per_cluster);
    Index level = 0;
    while (level < max_level && faces_each >= (1 + 1.5 * (level + 1) * (level + 2)) / 0.75)
      ++level;
    return level;
  }

  // Returns whether clusters were found.
  bool run_at_level(Word_store& blocks)
  {
    // Rank 0 has one bin for the cells of each rank, because the order of the cells must not depend on the ranks.
    const std::size_t ranks = context_.number_of_ranks();
    const Bin_ranks bins(context_, ranks * ranks);
    Word_store all(ranks, context_.scratch);
    Word_routing routing(context_, bins, all);
    double largest = 0;
    routing.run([&] {
      std::size_t cells = 0;
      for_each_block(blocks.number_of_bins(), [&](std::size_t bin) {
        Patch patch = read_patch(blocks, bin, names_, context_.cancellation);
        if (!choice_.has_densities)
          compute_deviations(patch, largest);
        const Cells cells_of_block(patch, level_, context_.cancellation);
        cells_of_block.write([&](const Words& cell) { routing.send(context_.rank(), cell); });
        write_cells(patch, cells_of_block, cells, blocks, bin);
        cells += cells_of_block.size();
      });
    });
    choose_density(largest);
    std::vector<Words> outgoing(context_.number_of_ranks());
    bool is_found = true;
    Words tasks;
    on_all_ranks(context_.communicator, [&] {
      if (context_.rank() == 0)
        is_found = cluster_on_first_rank(all, outgoing, tasks);
    });
    boost::mpi::broadcast(context_.communicator, is_found, 0);
    if (!is_found)
      return false;
    broadcast_words(context_, tasks);
    tasks_ = Cluster_tasks(tasks);
    clusters_ = std::move(exchange(context_, outgoing)[0]);
    return true;
  }

  void compute_deviations(Patch& patch, double& largest) const
  {
    patch.faces.density = mean_normal_deviations(patch.mesh, context_.cancellation, choice_.execution);
    for (std::size_t f = 0; f < patch.faces.size(); ++f)
      if (patch.is_own(f))
        largest = (std::max)(largest, patch.faces.density[f]);
  }

  static void write_cells(Patch& patch, const Cells& cells_of_block, std::size_t first_cell, Word_store& blocks, std::size_t bin)
  {
    blocks.clear(bin);
    Face_record face;
    Words words;
    for (Index f = 0; f < patch.faces.size(); ++f) {
      patch.get(f, patch.mesh, face);
      if (face.is_own)
        face.cluster = Index(first_cell + cells_of_block.cell_of(f));
      face.is_center = cells_of_block.is_center(f);
      face.write(words);
      blocks.append(bin, words.data(), words.size());
    }
  }

  // The density of section 5.2, as in map_to_densities(). The largest deviation is a maximum, so it does not depend on blocks.
  void choose_density(double largest)
  {
    constexpr double flat = 1e-6;
    if (choice_.has_densities)
      return;
    const double largest_of_all = boost::mpi::all_reduce(context_.communicator, largest, boost::mpi::maximum<double>());
    density_ = {1, largest_of_all > flat ? (choice_.maximum_density - 1) / largest_of_all : 0};
  }

  // Writes the clusters of the cells of each rank.
  bool cluster_on_first_rank(Word_store& all, std::vector<Words>& outgoing, Words& tasks)
  {
    Cell_mesh mesh(density_);
    std::vector<std::size_t> end; // of the cells of each rank
    for (std::size_t rank = 0; rank < all.number_of_bins(); ++rank)
      all.read(rank, [&](const std::uint64_t* word, const std::uint64_t* last) { mesh.count(word, last); });
    mesh.reserve();
    for (std::size_t rank = 0; rank < all.number_of_bins(); ++rank) {
      all.read(rank, [&](const std::uint64_t* word, const std::uint64_t* last) { mesh.read(word, last); });
      all.clear(rank);
      end.push_back(mesh.number_of_cells());
    }
    Clustering_state state;
    state.visitor = choice_.visitor;
    state.execution = choice_.execution;
    state.energy = choice_.energy;
    state.frame = frame_;
    state.repairs_output = choice_.repairs_output;
    state.merges_by_area = choice_.merges_by_area;
    state.places_on_borders = choice_.places_on_borders;
    state.input.items = mesh.make(level_ == 0, context_.cancellation, choice_.execution);
    if (!cluster(state))
      return false;
    const std::vector<Index> clusters = clusters_of_base_faces(state);
    for (std::size_t rank = 0, x = 0; rank < end.size(); ++rank)
      for (; x < end[rank]; ++x)
        outgoing[rank].push_back(clusters[x]);
    tasks = Cluster_tasks(state.input.items, mesh.faces(), clusters, state.number_of_clusters(), curve_, faces_per_task(mesh))
              .words();
    if (level_ > 0 && choice_.places_on_cells())
      surface_ = std::make_unique<Cell_surface>(mesh, state.input.items.mesh);
    if (level_ == 0)
      dual_ = place(state, choice_.placement, choice_.output_coordinates(frame_));
    report_ = state.report;
    return true;
  }

  // Faces at the border of a task cannot move, so few faces of a task of few clusters could move.
  std::size_t faces_per_task(const Cell_mesh& mesh) const
  {
    if (choice_.faces_per_block)
      return *choice_.faces_per_block;
    std::size_t faces = 0;
    for (const Index n : mesh.faces())
      faces += n;
    const std::size_t enough = Distributed_choice::clusters_per_task * (faces / choice_.number_of_vertices);
    return (std::max)(Distributed_choice::default_faces_per_block,
                      (std::min)(enough, Distributed_choice::max_faces_per_task));
  }

  // Cells cannot be subdivided, because their faces are on other ranks.
  bool cluster(Clustering_state& state) const
  {
    try {
      seed(state, {Seeding::FOR_NUMBER, choice_.number_of_vertices});
      grow(state);
      if (level_ > 0 && &state.working_input() != &state.input.items)
        return false;
      minimize(state, choice_.end);
    } catch (const Unreachable_number_of_vertices&) {
      if (level_ == 0)
        throw;
      return false;
    }
    return true;
  }

  Rank_context& context_;
  const Distributed_choice& choice_;
  const Face_names& names_;
  const Local_frame& frame_;
  Morton_curve curve_;
  Index level_ = 0;
  Linear_density density_;
  Words clusters_; // of the cells of this rank
  Cluster_tasks tasks_;
  Coarsening_report report_;
  Placed_dual dual_;
  std::unique_ptr<Cell_surface> surface_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_CLUSTERING_H
