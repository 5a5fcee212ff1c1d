// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_COARSENING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_COARSENING_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Cell_clustering.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Dual_parts.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Piece_blocks.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Task_refinement.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Rank_context.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Record_bins.h>

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
// Boost.Serialization calls this function. It names all members, so it does not compile if a member is added.
template <class Archive>
void serialize(Archive& archive, Coarsening_report& report, unsigned)
{
  auto& [level, seeds, clusters, splits, merges, rounds, moves, tests, refused_by_boundary_counts, refused_by_guarantee,
         initial_energy, final_energy, converged, subdivided_components, exchanged_vertices,
         intersections_found, intersections_left, intersecting_faces, reversals_found, reversals_left, narrow_faces, clusterings,
         feature_lines, feature_corners] = report;
  archive & level & seeds & clusters & splits & merges & rounds & moves & tests & refused_by_boundary_counts &
    refused_by_guarantee & initial_energy & final_energy & converged & subdivided_components & exchanged_vertices &
    intersections_found & intersections_left & intersecting_faces & reversals_found & reversals_left & narrow_faces &
    clusterings & feature_lines & feature_corners;
}

namespace internal {

// The pipeline across ranks. It divides blocks of faces along a space-filling curve into cells. Rank 0 clusters the mesh of
// cells. Tasks of nearby clusters are refined face by face. Then vertices are placed, and rank 0 triangulates. All results
// depend on blocks and clusters, but not on the ranks that hold them, nor on whether they are in memory or on disk.
class Distributed_coarsening
{
public:
  Distributed_coarsening(const boost::mpi::communicator& communicator, const Distributed_choice& choice, Face_source source)
    : context_(communicator, choice), pieces_(context_, std::move(source)), labels_(context_, context_.number_of_ranks())
  {
    on_all_ranks(communicator, [&] {
      context_.scratch.limit_memory(choice.scratch_directory, choice.scratch_memory / sizeof(std::uint64_t));
    });
  }

  void run()
  {
    check_equal(context_.number_of_vertices, "number of vertices");
    check_equal(context_.faces_per_block.value_or(0), "number of faces per block");
    begin_stage(Coarsening_stage::PREPARATION);
    pieces_.measure();
    std::unique_ptr<Record_bins> blocks =
      pieces_.read(context_.faces_per_block.value_or(Distributed_choice::default_faces_per_block));
    share_faces(context_, *blocks);
    context_.stage_ends(Coarsening_stage::PREPARATION);
    Cell_clusters cells = Cell_clustering(context_, pieces_.curve()).run(*blocks, pieces_.number_of_faces());
    Coarsening_report& report = report_;
    report = cells.report;
    if (cells.level == 0)
      take_dual(cells, *blocks);
    else
      refine_and_place(cells, std::move(blocks));
    on_all_ranks(context_.communicator, [&] {
      clusters_.assign(context_.wants_clusters ? pieces_.faces_of_piece() : 0, NONE);
      labels_.read<Face_label>(0, [&](const Face_label& label) { clusters_[label.face] = label.cluster; });
    });
    on_first_rank(context_, [&] { report_placement(report_, dual_.triangles, dual_.positions, dual_.counts); });
    if (context_.wants_output_everywhere) {
      broadcast_records(context_, dual_.triangles);
      broadcast_records(context_, dual_.positions);
    }
    boost::mpi::broadcast(context_.communicator, report, 0);
    report_.bytes_sent = context_.bytes_sent;
    report_.bytes_of_scratch = context_.scratch.bytes_written();
  }

  const Distributed_report& report() const { return report_; }
  const Local_frame& frame() const { return context_.frame; }
  // The clusters of the faces of the piece of this rank, on request.
  const std::vector<Index>& clusters_of_piece() const { return clusters_; }
  // True on rank 0, and on all ranks on request.
  bool has_output() const { return context_.rank() == 0 || context_.wants_output_everywhere; }
  const Placed_dual& dual() const { return dual_; }

private:
  // The cluster of a face of a piece.
  struct Face_label
  {
    Index face, cluster;
  };

  void send_label(std::uint64_t face, Index cluster)
  {
    if (!context_.wants_clusters)
      return;
    const auto [rank, number] = pieces_.origin(face);
    labels_.send(rank, Face_label{Index(number), cluster});
  }

  void begin_stage(Coarsening_stage stage) const
  {
    on_all_ranks(context_.communicator, [&] { context_.stage_begins(stage); });
  }

  void check_equal(std::uint64_t value, const char* what) const
  {
    const std::uint64_t min = boost::mpi::all_reduce(context_.communicator, value, boost::mpi::minimum<std::uint64_t>());
    const std::uint64_t max = boost::mpi::all_reduce(context_.communicator, value, boost::mpi::maximum<std::uint64_t>());
    if (min != max)
      throw Invalid_input(std::string("the ") + what + " is " + std::to_string(min) + " on one rank and " + std::to_string(max) +
                          " on another");
  }

  // Used if the cells are the faces; then rank 0 has placed the vertices.
  void take_dual(Cell_clusters& cells, const Record_bins& blocks)
  {
    dual_ = std::move(cells.dual);
    labels_.fill([&] {
      for (std::size_t i = 0; i < blocks.number_of_own(); ++i)
        blocks.read<Face_record>(i, [&](const Face_record& face) {
          if (face.is_own)
            send_label(face.origin, cells.clusters[face.cluster]);
        });
    });
  }

  void refine_and_place(Cell_clusters& cells, std::unique_ptr<Record_bins> blocks)
  {
    begin_stage(Coarsening_stage::MINIMIZATION);
    auto tasks = std::make_unique<Record_bins>(context_, number_of_tasks(cells.tasks, 0));
    send_to_first_tasks(cells, *blocks, *tasks);
    blocks.reset();
    Dual_parts parts;
    const auto receive = [&](const Patch& patch, const Patch_clusters& clusters) {
      parts.add(patch, clusters, context_);
      for (const Face_data& face : patch.faces)
        if (face.is_own)
          send_label(face.origin, face.cluster);
    };
    report_.rounds += refine_tasks(context_, cells.tasks, std::move(tasks), labels_, receive);
    context_.stage_ends(Coarsening_stage::MINIMIZATION);
    begin_stage(Coarsening_stage::TRIANGULATION);
    parts.gather(context_);
    on_first_rank(context_, [&] {
      report_.final_energy = 0;
      for (const Dual_parts::Cluster_part& cluster : parts.clusters) {
        report_.final_energy += cluster.energy;
        dual_.positions.push_back(cluster.position);
      }
      for (const Dual_parts::Triangle_part& part : parts.triangles)
        dual_.triangles.push_back(part.triangle);
    });
    context_.stage_ends(Coarsening_stage::TRIANGULATION);
    on_first_rank(context_, [&] {
      if (cells.surface)
        cells.surface->place(parts, context_, dual_);
    });
  }

  static void send_to_first_tasks(const Cell_clusters& cells, Record_bins& blocks, Record_bins& tasks)
  {
    tasks.fill([&] {
      for (std::size_t i = 0; i < blocks.number_of_own(); ++i) {
        blocks.read<Face_record>(i, [&](Face_record& face) {
          if (!face.is_own)
            return;
          face.cluster = cells.clusters[face.cluster];
          face.density = cells.density(face.density);
          tasks.send(cells.tasks[face.cluster][0], face);
        });
        blocks.clear(i);
      }
    });
  }

  Rank_context context_;
  Piece_blocks pieces_;
  Record_bins labels_; // the clusters of all faces, in the bins of their pieces
  Distributed_report report_;
  std::vector<Index> clusters_;
  Placed_dual dual_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_COARSENING_H
