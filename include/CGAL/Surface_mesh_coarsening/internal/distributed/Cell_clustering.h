// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_CLUSTERING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_CLUSTERING_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Cells.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Task_refinement.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Record_bins.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
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

namespace CGAL::Surface_mesh_coarsening::internal {

// A surface that approximates the input, on one rank. Its border is the border of the input, because the faces on the border are
// cells, so it places the vertices there. With fans, each cell of several faces is a fan of triangles around a point of the cell.
// Then there are several triangles for each triangle of the coarse mesh, so all vertices can be fitted to this surface in place
// of the input, and the placement can be repaired.
class Cell_surface
{
public:
  Cell_surface(std::vector<Cell> cells, Flat_mesh mesh, bool has_fans)
    : cells_(std::move(cells)), mesh_(std::move(mesh)), has_fans_(has_fans)
  {
    if (has_fans && mesh_.corner_vertex.size() >= NONE / 6)
      throw Invalid_input("the mesh of cells has " + std::to_string(mesh_.corner_vertex.size()) + " corners, more than the " +
                          std::to_string(NONE / 6 - 1) + " to which vertices can be fitted");
    for (std::vector<Index>* const unused : {&mesh_.first_in_star, &mesh_.star, &mesh_.loop})
      *unused = std::vector<Index>();
  }

  // Places the vertices on the border, fits all vertices to this surface if the placement does so, and repairs the placement on
  // request. Called once. The parts know the clusters of the faces that represent cells.
  void place(const Dual_parts& parts, const Rank_context& context, Placed_dual& dual)
  {
    Clustering_input input;
    std::vector<Index> cell_of, cluster_of_cell;
    {
      std::vector<char> is_fan;
      for (const Cell& cell : cells_)
        is_fan.push_back(has_fans_ && cell.faces > 1);
      Star_subdivision cutting(mesh_, std::move(is_fan));
      input.mesh = cutting.run([this](Index x) { return cells_[x].center; }, context);
      cell_of = cutting.old_face();
    }
    mesh_ = Flat_mesh(); // frees its memory
    compute_areas_and_centroids(input, context);
    input.density.assign(input.area.size(), 1);
    for (const Cell& cell : cells_)
      cluster_of_cell.push_back(parts.cluster_at(cell.origin));
    Cluster_labels labels(input.mesh);
    for (Index f = 0; f < cell_of.size(); ++f)
      labels.set(f, cluster_of_cell[cell_of[f]]);
    labels.recount();
    std::vector<Bbox_3> bounds;
    for (const Dual_parts::Cluster_part& cluster : parts.clusters)
      bounds.push_back(cluster.bounds);
    const Clustered_faces surface(input, labels, bounds, context);
    const Border_arcs border(surface);
    border.place(dual.positions);
    if (context.placement.fitted) {
      context.stage_begins(Coarsening_stage::PLACEMENT);
      fit_vertices_from(surface, border, *context.placement.fitted, dual.triangles, dual.positions);
      context.stage_ends(Coarsening_stage::PLACEMENT);
    }
    if (!context.repairs_output)
      return;
    Repair_budget budget(input.mesh.number_of_faces());
    dual.counts = repair_placement({surface, border, context.placement}, context.output_coordinates(context.frame),
                                   dual.triangles, dual.positions, budget);
  }

private:
  std::vector<Cell> cells_;
  Flat_mesh mesh_; // without stars
  bool has_fans_;
};

// The clusters of the cells.
struct Cell_clusters
{
  Index level = 0; // cells of level 0 are the faces
  Linear_density density;
  std::vector<Index> clusters; // of the cells of this rank
  Cluster_tasks tasks;
  // On rank 0:
  Coarsening_report report;
  Placed_dual dual;                      // if the cells have level 0
  std::unique_ptr<Cell_surface> surface; // otherwise, if vertices are placed on it or on its border
};

// Divides blocks into cells, and clusters the mesh of cells on rank 0.
class Cell_clustering
{
public:
  Cell_clustering(Rank_context& context, const Morton_curve& curve) : context_(context), curve_(curve) {}

  // Each own face in `blocks` receives its cell and, unless it has a density, its deviation. If the topology leaves too little
  // freedom to the cells, smaller cells are tried.
  Cell_clusters run(Record_bins& blocks, std::uint64_t number_of_faces)
  {
    for (result_.level = level_of_cells(number_of_faces); !run_at_level(blocks); --result_.level)
      ;
    return std::move(result_);
  }

private:
  static constexpr Index max_level = 6;
  static constexpr std::size_t cells_per_cluster = 12;

  // Returns the largest level with enough cells for each cluster: a neighborhood of level k has 1 + 3 k (k + 1) / 2 faces, and
  // the neighborhoods contain about three quarters of all faces.
  Index level_of_cells(std::uint64_t number_of_faces) const
  {
    const double faces_each = double(number_of_faces) / double(context_.number_of_vertices) / double(cells_per_cluster);
    Index level = 0;
    while (level < max_level && faces_each >= (1 + 1.5 * (level + 1) * (level + 2)) / 0.75)
      ++level;
    return level;
  }

  // Returns whether clusters were found.
  bool run_at_level(Record_bins& blocks)
  {
    // Rank 0 has one bin for the cells of each rank, because the order of the cells must not depend on the ranks.
    Record_bins all(context_, context_.number_of_ranks() * context_.number_of_ranks());
    double largest = 0;
    all.fill([&] {
      std::size_t cells = 0;
      for_each_block(blocks.number_of_own(), [&](std::size_t i) {
        Patch patch = take_patch(blocks, i, context_);
        if (!context_.has_densities)
          compute_deviations(patch, largest);
        const Cells cells_of_block(patch, result_.level, context_);
        cells_of_block.for_each_record([&](const Cell_record& cell) { all.send(context_.rank(), cell); });
        Face_record face;
        for (Index f = 0; f < patch.faces.size(); ++f) {
          patch.get(f, face);
          if (face.is_own)
            face.cluster = Index(cells + cells_of_block.cell_of(f));
          face.is_center = cells_of_block.is_center(f);
          blocks.send(blocks.first_own() + i, face);
        }
        cells += cells_of_block.size();
      });
    });
    choose_density(largest);
    Record_bins clusters(context_, context_.number_of_ranks());
    clusters.fill([&] {
      if (context_.rank() == 0)
        cluster_on_first_rank(all, clusters);
    });
    broadcast_records(context_, result_.tasks);
    if (result_.tasks.empty())
      return false;
    on_all_ranks(context_.communicator, [&] {
      clusters.read<std::uint64_t>(0, [&](std::uint64_t cluster) { result_.clusters.push_back(Index(cluster)); });
    });
    return true;
  }

  void compute_deviations(Patch& patch, double& largest) const
  {
    const std::vector<double> deviations = mean_normal_deviations(patch.mesh(), context_);
    for (std::size_t f = 0; f < deviations.size(); ++f) {
      patch.faces[f].density = deviations[f];
      if (patch.is_own(f))
        largest = (std::max)(largest, deviations[f]);
    }
  }

  // The density of section 5.2, as in map_to_densities(). The largest deviation is a maximum, so it does not depend on blocks.
  void choose_density(double largest)
  {
    constexpr double flat = 1e-6;
    if (context_.has_densities)
      return;
    const double largest_of_all = boost::mpi::all_reduce(context_.communicator, largest, boost::mpi::maximum<double>());
    result_.density = {1, largest_of_all > flat ? (context_.maximum_density - 1) / largest_of_all : 0};
  }

  // Sends the clusters of the cells of each rank, or nothing if no clusters are found.
  void cluster_on_first_rank(Record_bins& all, Record_bins& clusters_of_ranks)
  {
    Cell_mesh mesh(all, result_.density, result_.level == 0, context_);
    Clustering_state state;
    state.context = context_;
    state.energy = context_.energy;
    state.frame = context_.frame;
    state.repairs_output = context_.repairs_output;
    state.input.items = std::move(mesh.input);
    if (!cluster(state))
      return;
    const std::vector<Index> clusters = clusters_of_base_faces(state);
    for (std::size_t x = 0, rank = 0; x < clusters.size(); ++x) {
      while (x == mesh.ends[rank])
        ++rank;
      clusters_of_ranks.send(rank, std::uint64_t(clusters[x]));
    }
    divide_clusters(state, mesh, clusters);
    const std::vector<Component>& components = state.input.items.mesh.components;
    const bool has_border = std::any_of(components.begin(), components.end(), [](const Component& x) { return x.loops > 0; });
    if (result_.level == 0)
      result_.dual = place(state, context_.placement, context_.output_coordinates(context_.frame));
    else if (context_.places_on_cells() || has_border)
      result_.surface = std::make_unique<Cell_surface>(std::move(mesh.cells), std::move(state.input.items.mesh),
                                                       context_.places_on_cells());
    result_.report = state.report;
  }

  void divide_clusters(const Clustering_state& state, const Cell_mesh& mesh, const std::vector<Index>& cluster_of_cell)
  {
    std::vector<std::size_t> faces(state.number_of_clusters(), 0);
    std::vector<Vector> sum(faces.size(), Vector{{0, 0, 0}});
    for (Index x = 0; x < cluster_of_cell.size(); ++x) {
      const Index cluster = cluster_of_cell[x], faces_of_cell = mesh.cells[x].faces;
      faces[cluster] += faces_of_cell;
      sum[cluster] = sum[cluster] + double(faces_of_cell) * state.input.items.centroid(x);
    }
    std::vector<std::uint64_t> places;
    for (std::size_t i = 0; i < faces.size(); ++i)
      places.push_back(curve_((1 / double(faces[i])) * sum[i]));
    result_.tasks = divide_into_tasks(faces, places, faces_per_task(std::accumulate(faces.begin(), faces.end(), std::size_t(0))));
  }

  // Faces at the border of a task cannot move, so few faces of a task of few clusters could move.
  std::size_t faces_per_task(std::size_t number_of_faces) const
  {
    if (context_.faces_per_block)
      return *context_.faces_per_block;
    constexpr std::size_t clusters_per_task = 1000, max_faces = std::size_t(1) << 21;
    const std::size_t enough = clusters_per_task * (number_of_faces / context_.number_of_vertices);
    return (std::max)(Rank_context::default_faces_per_block, (std::min)(enough, max_faces));
  }

  // Cells cannot be subdivided, because their faces are on other ranks.
  bool cluster(Clustering_state& state) const
  {
    try {
      seed(state, {Seeding::FOR_NUMBER, context_.number_of_vertices});
      grow(state);
      if (result_.level > 0 && &state.working_input() != &state.input.items)
        return false;
      minimize(state, context_.end);
    } catch (const Unreachable_number_of_vertices&) {
      if (result_.level == 0)
        throw;
      return false;
    }
    return true;
  }

  Rank_context& context_;
  const Morton_curve& curve_;
  Cell_clusters result_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_CLUSTERING_H
