// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_COARSENING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_COARSENING_H

#include <CGAL/Surface_mesh_coarsening/internal/distributed/Cells.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Cell_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Cluster_tasks.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Dual_parts.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Regrouping.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/face_blocks.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Local_frame.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// What the caller has chosen, equal on all ranks but for the visitor.
struct Distributed_choice
{
  std::size_t number_of_vertices = 0;
  std::optional<std::size_t> faces_per_block; // blocks and tasks
  Minimization_end end;
  bool has_densities = false; // of its own
  double maximum_density = 0;
  Execution execution = Execution::SEQUENTIAL;
  Visitor_handle visitor;
  std::shared_ptr<const Energy_model> energy;
  Cluster_energies energies;
  Placement_model placement;
};

// The pipeline across ranks. Blocks of faces along a space-filling curve are divided into cells; rank 0 clusters the mesh of
// cells; clusters that lie together are refined face by face, in two divisions in turn; then vertices are placed, and rank 0
// triangulates. Whatever is computed depends on blocks and clusters, not on the ranks that they are on.
class Distributed_coarsening
{
public:
  Distributed_coarsening(const boost::mpi::communicator& communicator, const Distributed_choice& choice)
    : communicator_(communicator),
      choice_(choice),
      cancellation_(choice_.visitor)
  {}

  void run(Face_set faces)
  {
    check_agreement();
    begin_stage(Coarsening_stage::PREPARATION);
    const Box_of_all box = to_frame(faces);
    make_blocks(faces, Morton_curve(box));
    compute_densities();
    choice_.visitor.stage_ends(Coarsening_stage::PREPARATION);
    cluster_cells(Morton_curve(box));
    if (level_ > 0)
      refine_and_place();
    broadcast_report();
  }

  const Coarsening_report& report() const { return report_; }
  const Local_frame& frame() const { return frame_; }
  // On rank 0:
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<Vector>& positions() const { return positions_; }

  // The clusters of the faces of the piece of this rank.
  std::vector<Index> clusters_of_piece(std::size_t faces_of_piece)
  {
    std::vector<Words> outgoing(std::size_t(communicator_.size()));
    for (const Patch& patch : patches_)
      for (std::size_t f = 0; f < patch.faces.size(); ++f)
        if (patch.is_own[f])
          outgoing[patch.faces.origin[f].piece].push_back(packed(patch.faces.origin[f].face, patch.faces.cluster[f]));
    std::vector<Index> clusters(faces_of_piece, NONE);
    for (const Words& words : exchange(communicator_, outgoing))
      for (const std::uint64_t word : words)
        clusters[high_half(word)] = low_half(word);
    return clusters;
  }

private:
  static constexpr Index max_level = 6;
  static constexpr std::size_t cells_per_cluster = 12, clusters_per_task = 1000;
  static constexpr std::size_t phases = 4, max_rounds_of_phase = 20;
  static constexpr std::size_t default_faces_per_block = std::size_t(1) << 18, max_faces_per_task = std::size_t(1) << 22;

  void begin_stage(Coarsening_stage stage) const
  {
    on_all_ranks(communicator_, [&] { choice_.visitor.stage_begins(stage); });
  }

  void check_agreement() const
  {
    check_equal(choice_.number_of_vertices, "number of vertices");
    check_equal(choice_.faces_per_block.value_or(0), "number of faces per block");
  }

  void check_equal(std::uint64_t value, const char* what) const
  {
    const std::uint64_t min = boost::mpi::all_reduce(communicator_, value, boost::mpi::minimum<std::uint64_t>());
    const std::uint64_t max = boost::mpi::all_reduce(communicator_, value, boost::mpi::maximum<std::uint64_t>());
    if (min != max)
      throw Invalid_input(std::string("the ") + what + " is " + std::to_string(min) + " on one rank and " + std::to_string(max) +
                          " on another");
  }

  bool is_first() const { return communicator_.rank() == 0; }

  // Moves the points to the local frame of the whole mesh and returns their box there.
  Box_of_all to_frame(Face_set& faces)
  {
    if (boost::mpi::all_reduce(communicator_, std::uint64_t(faces.size()), std::plus<std::uint64_t>()) == 0)
      throw Invalid_input("the input has no faces");
    const Box_of_all box = box_of_all(communicator_, faces.point);
    std::vector<Vector> ends{box.low, box.high};
    frame_ = to_local_frame(ends, {0, 1, 2}, Cancellation_point());
    for (Vector& p : faces.point)
      p = frame_.to_local(p);
    return {ends[0], ends[1]};
  }

  void make_blocks(Face_set& faces, const Morton_curve& curve)
  {
    for (std::size_t f = 0; f < faces.size(); ++f)
      faces.place[f] = curve(faces.mean_of_corners(f));
    const std::vector<std::uint64_t> starts =
      block_starts(communicator_, faces.place, choice_.faces_per_block.value_or(default_faces_per_block));
    std::vector<Index> block;
    for (const std::uint64_t place : faces.place)
      block.push_back(block_of(starts, place));
    patches_ = Regrouping(communicator_, faces, block, Index(starts.size())).run(cancellation_);
    faces = Face_set();
  }

  // Section 5.2: the largest deviation of all is a maximum, which does not depend on blocks.
  void compute_densities()
  {
    if (choice_.has_densities)
      return;
    double largest = 0, largest_of_all = 0;
    std::vector<std::vector<double> > deviations;
    on_all_ranks(communicator_, [&] {
      for (const Patch& patch : patches_) {
        deviations.push_back(mean_normal_deviations(patch.mesh, cancellation_, choice_.execution));
        for (std::size_t f = 0; f < patch.is_own.size(); ++f)
          if (patch.is_own[f])
            largest = (std::max)(largest, deviations.back()[f]);
      }
    });
    boost::mpi::all_reduce(communicator_, largest, largest_of_all, boost::mpi::maximum<double>());
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      map_to_densities(deviations[i], largest_of_all, choice_.maximum_density);
      patches_[i].faces.density.swap(deviations[i]);
    }
  }

  std::uint64_t number_of_faces() const
  {
    std::uint64_t own = 0;
    for (const Patch& patch : patches_)
      own += std::uint64_t(std::count(patch.is_own.begin(), patch.is_own.end(), char(true)));
    return boost::mpi::all_reduce(communicator_, own, std::plus<std::uint64_t>());
  }

  // The cells of the largest level that leaves enough of them for each cluster: a neighborhood of level k has
  // 1 + 3 k (k + 1) / 2 faces, and some three quarters of all faces lie in one.
  Index level_of_cells() const
  {
    const double faces_each = double(number_of_faces()) / double(choice_.number_of_vertices) / double(cells_per_cluster);
    Index level = 0;
    while (level < max_level && faces_each >= (1 + 1.5 * (level + 1) * (level + 2)) / 0.75)
      ++level;
    return level;
  }

  // Tries smaller cells where the topology leaves too little freedom to cells. Cells of level 0 are the faces.
  void cluster_cells(const Morton_curve& curve)
  {
    for (level_ = level_of_cells(); !cluster_cells_of(level_, curve); --level_)
      ;
  }

  // Returns whether clusters were found.
  bool cluster_cells_of(Index level, const Morton_curve& curve)
  {
    std::vector<Cells> cells;
    Words words;
    on_all_ranks(communicator_, [&] {
      cells.reserve(patches_.size());
      for (const Patch& patch : patches_) {
        cells.emplace_back(patch, level, cancellation_);
        cells.back().write(patch.faces.density, words);
      }
    });
    const std::vector<Words> all = gather_words(communicator_, std::move(words));
    std::vector<Words> outgoing(std::size_t(communicator_.size()));
    bool is_found = true;
    Words tasks;
    on_all_ranks(communicator_, [&] {
      if (is_first())
        is_found = cluster_on_first_rank(all, level, curve, outgoing, tasks);
    });
    boost::mpi::broadcast(communicator_, is_found, 0);
    if (!is_found)
      return false;
    broadcast_words(communicator_, tasks);
    tasks_ = Cluster_tasks(tasks);
    std::size_t next = 0;
    const Words labels = exchange(communicator_, outgoing)[0];
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      for (Index f = 0; f < patches_[i].is_own.size(); ++f)
        if (patches_[i].is_own[f])
          patches_[i].faces.cluster[f] = Index(labels[next + cells[i].cell_of(f)]);
      next += cells[i].size();
    }
    return true;
  }

  // Writes the clusters of the cells of each rank.
  bool cluster_on_first_rank(const std::vector<Words>& all, Index level, const Morton_curve& curve, std::vector<Words>& outgoing,
                             Words& tasks)
  {
    Cell_mesh mesh;
    std::vector<std::size_t> end; // of the cells of each rank
    for (const Words& words : all) {
      mesh.read(words);
      end.push_back(mesh.number_of_cells());
    }
    Clustering_state state;
    state.visitor = choice_.visitor;
    state.execution = choice_.execution;
    state.energy = choice_.energy;
    state.frame = frame_;
    state.repairs_output = false;
    state.input.items = mesh.make(level == 0, cancellation_, choice_.execution);
    if (!cluster(state, level))
      return false;
    const std::vector<Index> clusters = clusters_of_base_faces(state);
    for (std::size_t rank = 0, x = 0; rank < end.size(); ++rank)
      for (; x < end[rank]; ++x)
        outgoing[rank].push_back(clusters[x]);
    const std::size_t number = state.number_of_clusters();
    tasks = Cluster_tasks(state.input.items, mesh.faces(), clusters, number, curve, faces_per_task(mesh)).words();
    if (level == 0) {
      const Placed_dual dual = place(state, choice_.placement, Output_coordinates());
      triangles_ = dual.triangles;
      positions_ = dual.positions;
    }
    report_ = state.report;
    return true;
  }

  // What lies at the border of a task cannot move, so a task of few clusters would leave little to be moved.
  std::size_t faces_per_task(const Cell_mesh& mesh) const
  {
    if (choice_.faces_per_block)
      return *choice_.faces_per_block;
    std::size_t faces = 0;
    for (const Index n : mesh.faces())
      faces += n;
    const std::size_t enough = clusters_per_task * (faces / choice_.number_of_vertices);
    return (std::max)(default_faces_per_block, (std::min)(enough, max_faces_per_task));
  }

  // Cells cannot be cut: they stand for faces that are elsewhere.
  bool cluster(Clustering_state& state, Index level) const
  {
    try {
      seed(state, {Seeding::FOR_NUMBER, choice_.number_of_vertices});
      grow(state);
      if (level > 0 && &state.working_input() != &state.input.items)
        return false;
      minimize(state, choice_.end);
    } catch (const Unreachable_number_of_vertices&) {
      if (level == 0)
        throw;
      return false;
    }
    return true;
  }

  // Regroups the faces so that all faces of the clusters of a task are together.
  void go_to_tasks(std::size_t division)
  {
    Face_set faces = own_faces(patches_);
    std::vector<Index> task;
    for (const Index x : faces.cluster)
      task.push_back(tasks_.task[division][x]);
    patches_ = Regrouping(communicator_, faces, task, tasks_.number[division]).run(cancellation_);
  }

  void refine_and_place()
  {
    begin_stage(Coarsening_stage::MINIMIZATION);
    const bool is_one_task = tasks_.number[0] == 1;
    std::vector<std::unique_ptr<Patch_clusters> > clusters;
    std::size_t rounds = 0;
    for (std::size_t phase = 0; phase < (is_one_task ? 1 : phases); ++phase) {
      clusters.clear();
      go_to_tasks(is_one_task ? 0 : phase % 2);
      Minimization_end end = choice_.end;
      if (!is_one_task)
        end.max_rounds = (std::min)(end.max_rounds, max_rounds_of_phase);
      std::size_t rounds_of_phase = 0;
      on_all_ranks(communicator_, [&] {
        for (Patch& patch : patches_) {
          clusters.push_back(std::make_unique<Patch_clusters>(patch));
          rounds_of_phase =
            (std::max)(rounds_of_phase, clusters.back()->minimize(*choice_.energy, end, cancellation_, choice_.execution));
        }
      });
      rounds += boost::mpi::all_reduce(communicator_, rounds_of_phase, boost::mpi::maximum<std::size_t>());
    }
    choice_.visitor.stage_ends(Coarsening_stage::MINIMIZATION);
    report_.rounds += rounds;
    place_clusters(clusters);
  }

  void place_clusters(const std::vector<std::unique_ptr<Patch_clusters> >& clusters)
  {
    begin_stage(Coarsening_stage::TRIANGULATION);
    Words words;
    on_all_ranks(communicator_, [&] {
      Dual_parts parts;
      for (std::size_t i = 0; i < patches_.size(); ++i)
        parts.add(patches_[i], *clusters[i], choice_.placement, choice_.energies, choice_.execution, cancellation_);
      words = parts.words();
    });
    const std::vector<Words> all = gather_words(communicator_, std::move(words));
    on_all_ranks(communicator_, [&] {
      if (!is_first())
        return;
      Dual_parts parts;
      for (const Words& of_rank : all)
        parts.read(of_rank);
      report_.final_energy = parts.energy();
      triangles_ = parts.triangles();
      positions_ = parts.positions();
    });
    choice_.visitor.stage_ends(Coarsening_stage::TRIANGULATION);
  }

  void broadcast_report()
  {
    static_assert(std::is_trivially_copyable<Coarsening_report>::value, "the report is sent byte by byte");
    boost::mpi::broadcast(communicator_, reinterpret_cast<char*>(&report_), int(sizeof report_), 0);
  }

  const boost::mpi::communicator& communicator_;
  Distributed_choice choice_;
  Cancellation_point cancellation_;
  Local_frame frame_;
  std::vector<Patch> patches_;
  Index level_ = 0; // of the cells
  Cluster_tasks tasks_;
  Coarsening_report report_;
  std::vector<Triangle> triangles_;
  std::vector<Vector> positions_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_COARSENING_H
