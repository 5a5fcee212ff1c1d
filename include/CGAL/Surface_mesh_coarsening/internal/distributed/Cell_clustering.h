// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_CLUSTERING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_CLUSTERING_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Cell_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Cells.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Distributed_choice.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Dual_parts.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Task_refinement.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Word_routing.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/complete_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/subdivision.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/place_vertices.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// A surface that approximates the input, on one rank: each cell of several faces is a fan of triangles around a point of the
// cell. There are several triangles for each triangle of the coarse mesh, so all vertices can be fitted to this surface in place
// of the input, and the placement can be repaired. Its border is the border of the input, because the faces on the border are
// cells.
class Cell_surface
{
public:
  Cell_surface(const Cell_mesh& cells, Flat_mesh mesh) : cells_(std::move(mesh)), corner_across_(cells.corners_across())
  {
    if (cells_.corner_vertex.size() >= NONE / 6)
      throw Invalid_input("the mesh of cells has " + std::to_string(cells_.corner_vertex.size()) +
                          " corners, more than the " + std::to_string(NONE / 6 - 1) + " to which vertices can be fitted");
    for (std::vector<Index>* const unused : {&cells_.face_across, &cells_.first_in_star, &cells_.star, &cells_.loop})
      *unused = std::vector<Index>();
    const std::size_t size = cells_.number_of_faces();
    center_.reserve(size);
    cells_.points.reserve(cells_.points.size() + size);
    for (const Cell_mesh::Cell& cell : cells.cells()) {
      center_.push_back(cell.faces > 1 ? Index(cells_.points.size()) : NONE);
      if (cell.faces > 1)
        cells_.points.push_back(cell.center);
    }
    cell_of_center_.resize(size);
    std::iota(cell_of_center_.begin(), cell_of_center_.end(), Index(0));
    std::sort(cell_of_center_.begin(), cell_of_center_.end(),
              [&](Index x, Index y) { return cells.cells()[x].origin < cells.cells()[y].origin; });
  }

  // Fits the vertices to this surface if the placement does so, and repairs the placement on request. Called once. The parts know
  // the clusters of the faces that represent cells.
  Repair_counts place(const Dual_parts& parts, const Distributed_choice& choice, const Output_coordinates& output_coordinates,
                      std::vector<Triangle>& triangles, std::vector<Vector>& positions)
  {
    const Clustering_input input = make_input(choice.context);
    Cluster_labels labels(input.mesh);
    set_labels(parts, labels);
    labels.recount();
    std::vector<Bbox_3> bounds;
    for (const Dual_parts::Cluster_part& cluster : parts.clusters)
      bounds.push_back(cluster.bounds);
    const Clustered_faces surface(input, labels, bounds, choice.context);
    const Border_arcs border(surface);
    border.place(positions);
    if (choice.placement.from_start) {
      choice.context.stage_begins(Coarsening_stage::PLACEMENT);
      choice.placement.from_start(surface, border, triangles, positions);
      choice.context.stage_ends(Coarsening_stage::PLACEMENT);
    }
    if (!choice.repairs_output)
      return Repair_counts();
    Repair_budget budget(input.mesh.number_of_faces());
    return repair_placement(surface, border, choice.placement, output_coordinates, triangles, positions, budget);
  }

private:
  Clustering_input make_input(const Run_context& context)
  {
    first_face_.reserve(center_.size() + 1);
    first_face_.push_back(0);
    for (Index x = 0; x < center_.size(); ++x)
      first_face_.push_back(first_face_.back() + (center_[x] == NONE ? 1 : cells_.degree(x)));
    Clustering_input input;
    Flat_mesh& m = input.mesh;
    m.first_corner.reserve(first_face_.back() + 1);
    m.corner_vertex.reserve(3 * first_face_.back());
    m.face_across.reserve(3 * first_face_.back());
    m.first_corner.push_back(0);
    for (Index x = 0; x < center_.size(); ++x) {
      context.poll(cells_.degree(x));
      for (const Index c : cells_.corners(x))
        add_side(x, c, m);
      if (center_[x] == NONE)
        m.first_corner.push_back(Index(m.corner_vertex.size()));
    }
    m.points.swap(cells_.points);
    cells_ = Flat_mesh(); // frees its memory
    corner_across_ = std::vector<Index>();
    complete_stars(m, m.points.size(), context);
    compute_areas_and_centroids(input, context);
    input.density.assign(input.area.size(), 1);
    return input;
  }

  // Adds the triangle at a side of a cell, or the corner of a single face.
  void add_side(Index x, Index c, Flat_mesh& m) const
  {
    m.corner_vertex.push_back(cells_.corner_vertex[c]);
    const Index across = corner_across_[c];
    m.face_across.push_back(across == NONE ? NONE : face_of(face_of_corner(cells_, across), across));
    if (center_[x] == NONE)
      return;
    m.corner_vertex.push_back(cells_.corner_vertex[cells_.next_corner(x, c)]);
    m.face_across.push_back(face_of(x, cells_.next_corner(x, c)));
    m.corner_vertex.push_back(center_[x]);
    m.face_across.push_back(face_of(x, cells_.previous_corner(x, c)));
    m.first_corner.push_back(Index(m.corner_vertex.size()));
  }

  // Returns the face at the side of cell `x` that begins at a corner.
  Index face_of(Index x, Index c) const { return first_face_[x] + (center_[x] == NONE ? 0 : c - cells_.first_corner[x]); }

  // A face belongs to the cluster of the face that represents its cell. The parts have these faces in the order of their origins.
  void set_labels(const Dual_parts& parts, Cluster_labels& labels) const
  {
    for (std::size_t i = 0; i < cell_of_center_.size(); ++i)
      for (const Index f : number_range(first_face_[cell_of_center_[i]], first_face_[cell_of_center_[i] + 1]))
        labels.set(f, parts.centers[i].cluster);
  }

  Flat_mesh cells_;                   // without stars, and with points within cells
  std::vector<Index> corner_across_;  // of each corner
  std::vector<Index> center_;         // the vertex within each cell; NONE if the cell is a single face
  std::vector<Index> cell_of_center_; // the cells in the order of the origins of the faces that represent them
  std::vector<Index> first_face_;     // of each cell, and the total
};

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
  Index cluster_of_cell(Index cell) const { return clusters_[cell]; }
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
        Patch patch = read_patch(blocks, bin, names_, context_);
        if (!choice_.has_densities)
          compute_deviations(patch, largest);
        const Cells cells_of_block(patch, level_, context_);
        cells_of_block.write([&](const Cell_record& cell) { routing.send(context_.rank(), cell); });
        write_cells(patch, cells_of_block, cells, blocks, bin);
        cells += cells_of_block.size();
      });
    });
    choose_density(largest);
    std::vector<std::vector<Index> > outgoing(context_.number_of_ranks());
    bool is_found = true;
    on_first_rank(context_, [&] { is_found = cluster_on_first_rank(all, outgoing); });
    boost::mpi::broadcast(context_.communicator, is_found, 0);
    if (!is_found)
      return false;
    broadcast_records(context_, tasks_);
    clusters_ = std::move(exchange(context_, outgoing)[0]);
    return true;
  }

  void compute_deviations(Patch& patch, double& largest) const
  {
    const std::vector<double> deviations = mean_normal_deviations(patch.mesh, context_);
    for (std::size_t f = 0; f < deviations.size(); ++f) {
      patch.faces[f].density = deviations[f];
      if (patch.is_own(f))
        largest = (std::max)(largest, deviations[f]);
    }
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
      words.clear();
      write_record(face, words);
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
  bool cluster_on_first_rank(Word_store& all, std::vector<std::vector<Index> >& outgoing)
  {
    Cell_mesh mesh(density_);
    std::vector<std::size_t> end; // of the cells of each rank
    for (std::size_t rank = 0; rank < all.number_of_bins(); ++rank)
      all.read<Cell_record>(rank, [&](const Cell_record& cell) { mesh.count(cell); });
    mesh.reserve();
    for (std::size_t rank = 0; rank < all.number_of_bins(); ++rank) {
      all.read<Cell_record>(rank, [&](const Cell_record& cell) { mesh.add(cell); });
      all.clear(rank);
      end.push_back(mesh.cells().size());
    }
    Clustering_state state;
    state.context = choice_.context;
    state.energy = choice_.energy;
    state.frame = frame_;
    state.repairs_output = choice_.repairs_output;
    state.input.items = mesh.make(level_ == 0, context_);
    if (!cluster(state))
      return false;
    const std::vector<Index> clusters = clusters_of_base_faces(state);
    for (std::size_t rank = 0, begin = 0; rank < end.size(); begin = end[rank++])
      outgoing[rank].assign(clusters.begin() + std::ptrdiff_t(begin), clusters.begin() + std::ptrdiff_t(end[rank]));
    divide_clusters(state, mesh, clusters);
    if (level_ > 0 && choice_.places_on_cells())
      surface_ = std::make_unique<Cell_surface>(mesh, std::move(state.input.items.mesh));
    if (level_ == 0)
      dual_ = place(state, choice_.placement, choice_.output_coordinates(frame_));
    report_ = state.report;
    return true;
  }

  void divide_clusters(const Clustering_state& state, const Cell_mesh& mesh, const std::vector<Index>& cluster_of_cell)
  {
    std::vector<std::size_t> faces(state.number_of_clusters(), 0);
    std::vector<Vector> sum(faces.size(), Vector{{0, 0, 0}});
    for (Index x = 0; x < cluster_of_cell.size(); ++x) {
      const Index cluster = cluster_of_cell[x], faces_of_cell = mesh.cells()[x].faces;
      faces[cluster] += faces_of_cell;
      sum[cluster] = sum[cluster] + double(faces_of_cell) * state.input.items.centroid(x);
    }
    std::vector<std::uint64_t> places;
    for (std::size_t i = 0; i < faces.size(); ++i)
      places.push_back(curve_((1 / double(faces[i])) * sum[i]));
    tasks_ = divide_into_tasks(faces, places, faces_per_task(std::accumulate(faces.begin(), faces.end(), std::size_t(0))));
  }

  // Faces at the border of a task cannot move, so few faces of a task of few clusters could move.
  std::size_t faces_per_task(std::size_t number_of_faces) const
  {
    if (choice_.faces_per_block)
      return *choice_.faces_per_block;
    const std::size_t enough = Distributed_choice::clusters_per_task * (number_of_faces / choice_.number_of_vertices);
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
  std::vector<Index> clusters_; // of the cells of this rank
  Cluster_tasks tasks_;
  Coarsening_report report_;
  Placed_dual dual_;
  std::unique_ptr<Cell_surface> surface_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_CLUSTERING_H
