// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_COARSENING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_COARSENING_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Cell_clustering.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Dual_parts.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Piece_blocks.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Shared_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Task_refinement.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Word_routing.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Word_store.h>

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
  Distributed_coarsening(const boost::mpi::communicator& communicator, const Distributed_choice& choice)
    : choice_(choice), context_(communicator, choice_.context)
  {
    on_all_ranks(communicator, [&] {
      context_.scratch.limit_memory(choice_.scratch_directory, choice_.scratch_memory / sizeof(std::uint64_t));
    });
  }

  void run(const Face_source& source)
  {
    check_agreement();
    begin_stage(Coarsening_stage::PREPARATION);
    Piece_blocks pieces(context_, source, choice_.face_names);
    pieces.measure();
    frame_ = pieces.frame();
    const Face_names names = [&](std::uint64_t face) { return pieces.name(face); };
    const std::vector<std::uint64_t> starts =
      pieces.find_blocks(choice_.faces_per_block.value_or(Distributed_choice::default_faces_per_block));
    const Bin_ranks bins(context_, starts.size());
    auto blocks = std::make_unique<Word_store>(bins.number_of_own(), context_.scratch);
    pieces.read(starts, bins, *blocks);
    Shared_faces(context_, bins).run(*blocks);
    context_.stage_ends(Coarsening_stage::PREPARATION);
    Cell_clustering cells(context_, choice_, names, frame_, pieces.curve());
    cells.run(*blocks, pieces.number_of_faces());
    Coarsening_report& report = report_;
    report = cells.report();
    if (choice_.wants_clusters)
      clusters_.assign(pieces.faces_of_piece(), NONE);
    if (cells.level() == 0)
      take_dual(cells, *blocks, pieces);
    else
      refine_and_place(cells, std::move(blocks), pieces, names);
    on_first_rank(context_, [&] { report_placement(report_, triangles_, positions_, counts_); });
    if (choice_.wants_output_everywhere) {
      broadcast_records(context_, triangles_);
      broadcast_records(context_, positions_);
    }
    boost::mpi::broadcast(context_.communicator, report, 0);
    report_.bytes_sent = context_.bytes_sent;
    report_.bytes_of_scratch = context_.scratch.bytes_written();
  }

  const Distributed_report& report() const { return report_; }
  const Local_frame& frame() const { return frame_; }
  // The clusters of the faces of the piece of this rank, on request.
  const std::vector<Index>& clusters_of_piece() const { return clusters_; }
  // True on rank 0, and on all ranks on request.
  bool has_output() const { return context_.rank() == 0 || choice_.wants_output_everywhere; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<Vector>& positions() const { return positions_; }

private:
  // The cluster of a face of a piece.
  struct Face_label
  {
    Index face, cluster;
  };

  void begin_stage(Coarsening_stage stage) const
  {
    on_all_ranks(context_.communicator, [&] { context_.stage_begins(stage); });
  }

  void check_agreement() const
  {
    check_equal(choice_.number_of_vertices, "number of vertices");
    check_equal(choice_.faces_per_block.value_or(0), "number of faces per block");
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
  void take_dual(Cell_clustering& cells, const Word_store& blocks, const Piece_blocks& pieces)
  {
    triangles_ = std::move(cells.dual().triangles);
    positions_ = std::move(cells.dual().positions);
    counts_ = std::move(cells.dual().counts);
    const Bin_ranks ranks(context_, context_.number_of_ranks());
    Word_store labels(1, context_.scratch);
    Word_routing routing(context_, ranks, labels);
    routing.run([&] {
      for (std::size_t bin = 0; bin < blocks.number_of_bins(); ++bin)
        blocks.read<Face_record>(bin, [&](const Face_record& face) {
          if (face.is_own)
            send_label(face.origin, cells.cluster_of_cell(face.cluster), pieces, routing);
        });
    });
    read_labels(labels);
  }

  void refine_and_place(Cell_clustering& cells, std::unique_ptr<Word_store> blocks, const Piece_blocks& pieces,
                        const Face_names& names)
  {
    begin_stage(Coarsening_stage::MINIMIZATION);
    const Task_refinement refinement(context_, choice_, cells.tasks(), names);
    const Bin_ranks tasks(context_, number_of_tasks(cells.tasks(), 0)), ranks(context_, context_.number_of_ranks());
    auto faces = std::make_unique<Word_store>(tasks.number_of_own(), context_.scratch);
    send_to_tasks(cells, *blocks, tasks, *faces);
    blocks.reset();
    Shared_faces(context_, tasks).run(*faces);
    Word_store labels(1, context_.scratch);
    Dual_parts parts;
    const auto place = [&](const Patch& patch, const Patch_clusters& clusters, Word_routing& routing) {
      parts.add(patch, clusters, choice_);
      for (std::size_t f = 0; f < patch.faces.size(); ++f)
        if (patch.is_own(f))
          send_label(patch.faces[f].origin, patch.faces[f].cluster, pieces, routing);
    };
    report_.rounds += refinement.run(std::move(faces), ranks, labels, place);
    read_labels(labels);
    context_.stage_ends(Coarsening_stage::MINIMIZATION);
    begin_stage(Coarsening_stage::TRIANGULATION);
    parts.gather(context_);
    on_first_rank(context_, [&] { take_parts(parts); });
    context_.stage_ends(Coarsening_stage::TRIANGULATION);
    on_first_rank(context_, [&] {
      if (choice_.places_on_cells())
        counts_ = cells.surface().place(parts, choice_, choice_.output_coordinates(frame_), triangles_, positions_);
    });
  }

  void send_to_tasks(const Cell_clustering& cells, Word_store& blocks, const Bin_ranks& tasks, Word_store& faces)
  {
    Word_routing routing(context_, tasks, faces);
    routing.run([&] {
      for (std::size_t bin = 0; bin < blocks.number_of_bins(); ++bin) {
        blocks.read<Face_record>(bin, [&](Face_record& face) {
          if (!face.is_own)
            return;
          face.cluster = cells.cluster_of_cell(face.cluster);
          face.density = cells.density()(face.density);
          routing.send(cells.tasks()[face.cluster][0], face);
        });
        blocks.clear(bin);
      }
    });
  }

  void send_label(std::uint64_t face, Index cluster, const Piece_blocks& pieces, Word_routing& routing) const
  {
    if (!choice_.wants_clusters)
      return;
    const auto [rank, number] = pieces.origin(face);
    routing.send(rank, Face_label{Index(number), cluster});
  }

  void read_labels(const Word_store& labels)
  {
    on_all_ranks(context_.communicator, [&] {
      labels.read<Face_label>(0, [&](const Face_label& label) { clusters_[label.face] = label.cluster; });
    });
  }

  void take_parts(const Dual_parts& parts)
  {
    report_.final_energy = 0;
    for (const Dual_parts::Cluster_part& cluster : parts.clusters)
      report_.final_energy += cluster.energy;
    for (const Dual_parts::Triangle_part& part : parts.triangles)
      triangles_.push_back(part.triangle);
    positions_ = parts.positions();
  }

  Distributed_choice choice_;
  Rank_context context_;
  Local_frame frame_;
  Distributed_report report_;
  std::vector<Index> clusters_;
  std::vector<Triangle> triangles_;
  std::vector<Vector> positions_;
  Repair_counts counts_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_COARSENING_H
