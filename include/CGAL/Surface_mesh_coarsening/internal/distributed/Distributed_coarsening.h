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

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Calls `visit(number)` for each number of a report, with the numbers in its lists. The lists have their sizes already. The
// function names all members, so it does not compile if a member is added.
template <class Visit>
void for_each_number(Coarsening_report& report, const Visit& visit)
{
  auto& [level, seeds, clusters, splits, merges, rounds, moves, tests, refused_by_boundary_counts, refused_by_guarantee,
         initial_energy, final_energy, converged, subdivided_components, exchanged_vertices,
         intersections_found, intersections_left, intersecting_faces, reversals_found, reversals_left, narrow_faces, clusterings,
         feature_lines, feature_corners] = report;
  for (std::size_t* const count :
       {&level, &seeds, &clusters, &splits, &merges, &rounds, &moves, &tests, &refused_by_boundary_counts, &refused_by_guarantee,
        &subdivided_components, &exchanged_vertices, &intersections_found, &intersections_left,
        &reversals_found, &reversals_left, &clusterings, &feature_lines, &feature_corners})
    visit(*count);
  visit(initial_energy);
  visit(final_energy);
  visit(converged);
  for (auto& [first, second] : intersecting_faces) {
    visit(first);
    visit(second);
  }
  for (std::size_t& face : narrow_faces)
    visit(face);
}

// Sends the report of rank 0 to all ranks.
inline void broadcast_report(Rank_context& context, Coarsening_report& report)
{
  Words sizes{report.intersecting_faces.size(), report.narrow_faces.size()}, words;
  broadcast_words(context, sizes);
  report.intersecting_faces.resize(sizes[0]);
  report.narrow_faces.resize(sizes[1]);
  for_each_number(report, [&](auto& number) {
    if constexpr (std::is_same<decltype(number), double&>::value)
      words.push_back(to_word(number));
    else
      words.push_back(std::uint64_t(number));
  });
  broadcast_words(context, words);
  auto word = words.begin();
  for_each_number(report, [&](auto& number) {
    if constexpr (std::is_same<decltype(number), double&>::value)
      number = to_double(*word++);
    else
      number = static_cast<std::remove_reference_t<decltype(number)> >(*word++);
  });
}

// The pipeline across ranks. It divides blocks of faces along a space-filling curve into cells. Rank 0 clusters the mesh of
// cells. Tasks of nearby clusters are refined face by face. Then vertices are placed, and rank 0 triangulates. All results
// depend on blocks and clusters, but not on the ranks that hold them, nor on whether they are in memory or on disk.
class Distributed_coarsening
{
public:
  Distributed_coarsening(const boost::mpi::communicator& communicator, const Distributed_choice& choice)
    : choice_(choice), context_(communicator, Cancellation_point(choice_.visitor))
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
    choice_.visitor.stage_ends(Coarsening_stage::PREPARATION);
    Cell_clustering cells(context_, choice_, names, frame_, pieces.curve());
    cells.run(*blocks, pieces.number_of_faces());
    report_ = cells.report();
    if (choice_.wants_clusters)
      clusters_.assign(pieces.faces_of_piece(), NONE);
    if (cells.level() == 0)
      take_dual(cells, *blocks, pieces);
    else
      refine_and_place(cells, std::move(blocks), pieces, names);
    on_all_ranks(context_.communicator, [&] {
      if (context_.rank() == 0)
        report_placement(report_, triangles_, positions_, counts_);
    });
    if (choice_.wants_output_everywhere)
      broadcast_output();
    broadcast_report(context_, report_);
  }

  const Coarsening_report& report() const { return report_; }
  const Local_frame& frame() const { return frame_; }
  std::uint64_t bytes_sent() const { return context_.bytes_sent; }
  std::uint64_t bytes_of_scratch() const { return context_.scratch.bytes_written(); }
  // The clusters of the faces of the piece of this rank, on request.
  const std::vector<Index>& clusters_of_piece() const { return clusters_; }
  // True on rank 0, and on all ranks on request.
  bool has_output() const { return context_.rank() == 0 || choice_.wants_output_everywhere; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<Vector>& positions() const { return positions_; }

private:
  void begin_stage(Coarsening_stage stage) const
  {
    on_all_ranks(context_.communicator, [&] { choice_.visitor.stage_begins(stage); });
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
    Face_record face;
    routing.run([&] {
      for (std::size_t bin = 0; bin < blocks.number_of_bins(); ++bin)
        blocks.read(bin, [&](const std::uint64_t* word, const std::uint64_t* end) {
          while (word != end) {
            word = face.read(word);
            if (face.is_own)
              send_label(face.origin, cells.cluster_of_cell(face.cluster), pieces, routing);
          }
        });
    });
    read_labels(labels);
  }

  void refine_and_place(Cell_clustering& cells, std::unique_ptr<Word_store> blocks, const Piece_blocks& pieces,
                        const Face_names& names)
  {
    begin_stage(Coarsening_stage::MINIMIZATION);
    const Task_refinement refinement(context_, choice_, cells.tasks(), names);
    const Bin_ranks tasks(context_, cells.tasks().number[0]), ranks(context_, context_.number_of_ranks());
    auto faces = std::make_unique<Word_store>(tasks.number_of_own(), context_.scratch);
    send_to_tasks(cells, *blocks, tasks, *faces);
    blocks.reset();
    Shared_faces(context_, tasks).run(*faces);
    Word_store labels(1, context_.scratch);
    Dual_parts parts;
    const auto place = [&](const Patch& patch, const Patch_clusters& clusters, Word_routing& routing) {
      parts.add(patch, clusters, choice_, context_.cancellation);
      for (std::size_t f = 0; f < patch.faces.size(); ++f)
        if (patch.is_own(f))
          send_label(patch.faces.origin[f], patch.faces.cluster[f], pieces, routing);
    };
    report_.rounds += refinement.run(std::move(faces), ranks, labels, place);
    read_labels(labels);
    choice_.visitor.stage_ends(Coarsening_stage::MINIMIZATION);
    begin_stage(Coarsening_stage::TRIANGULATION);
    parts = gathered(parts);
    triangulate(parts);
    choice_.visitor.stage_ends(Coarsening_stage::TRIANGULATION);
    if (choice_.places_on_cells())
      place_on_cells(cells, parts);
  }

  void send_to_tasks(const Cell_clustering& cells, Word_store& blocks, const Bin_ranks& tasks, Word_store& faces)
  {
    Word_routing routing(context_, tasks, faces);
    Face_record face;
    Words words;
    routing.run([&] {
      for (std::size_t bin = 0; bin < blocks.number_of_bins(); ++bin) {
        blocks.read(bin, [&](const std::uint64_t* word, const std::uint64_t* end) {
          while (word != end) {
            word = face.read(word);
            if (!face.is_own)
              continue;
            face.cluster = cells.cluster_of_cell(face.cluster);
            face.density = cells.density()(face.density);
            face.write(words);
            routing.send(cells.tasks().task[0][face.cluster], words);
          }
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
    const std::uint64_t label = packed(Index(number), cluster);
    routing.send(rank, &label, 1);
  }

  void read_labels(const Word_store& labels)
  {
    on_all_ranks(context_.communicator, [&] {
      labels.read(0, [&](const std::uint64_t* word, const std::uint64_t* end) {
        for (; word != end; ++word)
          clusters_[high_half(*word)] = low_half(*word);
      });
    });
  }

  // Returns the parts of all ranks on rank 0.
  Dual_parts gathered(const Dual_parts& own)
  {
    const std::vector<Words> all = gather_words(context_, own.words());
    Dual_parts parts;
    on_all_ranks(context_.communicator, [&] {
      if (context_.rank() == 0)
        for (const Words& of_rank : all)
          parts.read(of_rank);
    });
    return parts;
  }

  void place_on_cells(Cell_clustering& cells, const Dual_parts& parts)
  {
    on_all_ranks(context_.communicator, [&] {
      if (context_.rank() == 0)
        counts_ = cells.surface().place(parts, choice_, choice_.output_coordinates(frame_), context_.cancellation, triangles_,
                                        positions_);
    });
  }

  void triangulate(Dual_parts& parts)
  {
    on_all_ranks(context_.communicator, [&] {
      if (context_.rank() != 0)
        return;
      report_.final_energy = parts.energy();
      triangles_ = parts.triangles();
      positions_ = parts.positions();
    });
  }

  void broadcast_output()
  {
    Words words;
    for (const Triangle& t : triangles_)
      words.insert(words.end(), {packed(t[0], t[1]), t[2]});
    for (const Vector& p : positions_)
      for (const double x : p)
        words.push_back(to_word(x));
    std::uint64_t triangles = triangles_.size();
    boost::mpi::broadcast(context_.communicator, triangles, 0);
    broadcast_words(context_, words);
    triangles_.clear();
    positions_.clear();
    std::size_t i = 0;
    for (; i < 2 * triangles; i += 2)
      triangles_.push_back({high_half(words[i]), low_half(words[i]), Index(words[i + 1])});
    for (; i < words.size(); i += 3)
      positions_.push_back({{to_double(words[i]), to_double(words[i + 1]), to_double(words[i + 2])}});
  }

  Distributed_choice choice_;
  Rank_context context_;
  Local_frame frame_;
  Coarsening_report report_;
  std::vector<Index> clusters_;
  std::vector<Triangle> triangles_;
  std::vector<Vector> positions_;
  Repair_counts counts_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_COARSENING_H
