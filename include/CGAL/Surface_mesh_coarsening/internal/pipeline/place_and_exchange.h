// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_PLACE_AND_EXCHANGE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_PLACE_AND_EXCHANGE_H

#include <CGAL/Surface_mesh_coarsening/internal/output/place_vertices.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Coarse_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Vertex_exchange.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/fit_vertices.h>
#include <CGAL/Surface_mesh_coarsening/internal/refinement/Cluster_editing.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Each placement after the first takes about as long as this number of exact tests for each triangle.
constexpr std::size_t placement_tests = 1000;

// Restores the clusters of a placement, after the same clustering has been computed again without relocated clusters.
inline void restore_clusters(Clustering_state& state, const std::vector<Index>& old_labels, Placed_dual& dual)
{
  state.labels->move_all(old_labels);
  state.minimization.reset();
  dual.pieces = std::make_unique<Labelled_pieces>(state.featured_input(), labels(state), state.number_of_clusters());
}

// The surface with its current clusters, and the positions of vertices on its border and features.
struct Bordered_surface
{
  Bordered_surface(const Clustering_state& state, const Labelled_pieces& pieces)
    : faces(pieces, state.number_of_clusters(), state.context),
      border(faces, !state.follows_paper)
  {}

  Clustered_faces faces;
  Border_arcs border;
};

inline std::unique_ptr<Bordered_surface> bordered_surface(const Clustering_state& state, Placed_dual& dual)
{
  dual.pieces = std::make_unique<Labelled_pieces>(state.featured_input(), labels(state), state.number_of_clusters());
  return std::make_unique<Bordered_surface>(state, *dual.pieces);
}

// Returns one of some parts of the budget.
inline Repair_budget repair_budget(const Clustering_state& state, std::size_t parts = 1)
{
  return Repair_budget(state.base_input().mesh.number_of_faces(), parts);
}

// Returns whether more than one pair of triangles for a hundred clusters intersect. Fewer do not justify another clustering of the
// whole mesh, and an exchange rarely leaves as few if there are more.
inline bool has_many_intersections(const Clustering_state& state, const Placed_dual& dual)
{
  return 100 * dual.number_left() > state.number_of_clusters();
}

// What places and repairs vertices.
struct Placement_request
{
  const Placement_model& placement;
  const Output_coordinates& output_coordinates;
  Repair_budget& budget;
};

// Repairs a placement if the output is to be repaired.
inline void repair(const Clustering_state& state, const Bordered_surface& surface, const Placement_request& request, Placed_dual& dual)
{
  if (state.repairs_output)
    dual.counts = repair_placement({surface.faces, surface.border, request.placement}, request.output_coordinates,
                                   dual.triangles, dual.positions, request.budget);
  state.context.throw_if_cancelled();
}

// Places the vertices and repairs the placement.
inline Placed_dual place(const Clustering_state& state, const Placement_request& request)
{
  state.context.stage_begins(Coarsening_stage::TRIANGULATION);
  Placed_dual dual;
  const std::unique_ptr<Bordered_surface> surface = bordered_surface(state, dual);
  dual.triangles = dual_triangles(labels(state), state.context);
  state.context.stage_ends(Coarsening_stage::TRIANGULATION);
  dual.positions = place_vertices({surface->faces, surface->border, request.placement}, dual.triangles);
  repair(state, *surface, request, dual);
  return dual;
}

// Returns whether each triangle joins clusters of one component, so that a vertex lies on the component of its cluster.
inline bool stay_on_components(const Clustered_faces& surface, const std::vector<Triangle>& triangles)
{
  const auto component = [&](Index x) { return surface.input().mesh.component[*surface.faces(x).begin()]; };
  return std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return component(t[0]) == component(t[1]) && component(t[1]) == component(t[2]);
  });
}

// Repairs a mesh whose clusters may have been relocated.
inline Repair_counts repair_exchanged(const Clustering_state& state, const Placement_request& request, Coarse_mesh& mesh)
{
  if (!state.repairs_output)
    return Repair_counts();
  const Labelled_pieces pieces(state.featured_input(), labels(state), state.number_of_clusters());
  const Clustered_faces surface(pieces, state.number_of_clusters(), state.context);
  CGAL_assertion(stay_on_components(surface, mesh.triangles()));
  const Repair_counts counts = Placement_repair(mesh, surface, request.output_coordinates, request.budget).run(request.placement);
  state.context.throw_if_cancelled();
  return counts;
}

// Exchanges vertices, so that vertices are inserted at triangles that intersect after a repair, which has left the feet up to date.
inline void exchange_at_intersections(Coarse_mesh& mesh, const Repair_counts& counts)
{
  constexpr double worth_of_fault = 200; // of a triangle without intersection, relative to the mean cost of a triangle
  mesh.context().stage_begins(Coarsening_stage::FEEDBACK);
  const double worth = worth_of_fault * mesh.mean_cost();
  std::vector<double> bonus(mesh.triangles().size(), 0);
  for (const auto& pair : counts.intersections_left)
    for (const Index t : {pair.first, pair.second})
      bonus[t] = worth;
  Vertex_exchange(mesh).run(mesh.worth(rate_of_repaired), bonus);
  mesh.context().stage_ends(Coarsening_stage::FEEDBACK);
}

// Exchanges vertices where triangles intersect, and repairs again, while this reduces the number of pairs. A second attempt begins
// with the result of the first. `counts` are the counts of the first repair.
inline void remove_intersections(const Clustering_state& state, const Placement_request& request, Coarse_mesh& mesh,
                                 Repair_counts& counts)
{
  constexpr int max_passes = 4, max_passes_without_gain = 2;
  std::size_t relocated = mesh.clusters().number();
  std::vector<Triangle> best_triangles = mesh.triangles();
  std::vector<Vector> best_positions = mesh.positions();
  Repair_counts now = counts;
  int without_gain = 0;
  for (int i = 0; i < max_passes && without_gain < max_passes_without_gain && !now.intersections_left.empty(); ++i) {
    if (request.budget.is_spent())
      break;
    exchange_at_intersections(mesh, now);
    now = repair_exchanged(state, request, mesh);
    ++without_gain;
    if (now.intersections_left.size() < counts.intersections_left.size()) {
      without_gain = 0;
      relocated = mesh.clusters().number();
      best_triangles = mesh.triangles();
      best_positions = mesh.positions();
      counts.intersections_left = now.intersections_left;
      counts.reversals_left = now.reversals_left;
    }
  }
  if (without_gain > 0) {
    mesh.clusters().undo_all_after(relocated);
    mesh.restore(best_triangles, best_positions);
  }
}

// Fits the vertices, exchanges some of them together with their clusters, and repairs the mesh. `plain` is as below.
inline Placed_dual fit_and_exchange(const Clustering_state& state, const Placement_request& request, const Placed_dual* plain,
                                    Cluster_relocation& clusters)
{
  const Run_context& context = state.context;
  Placed_dual dual;
  context.stage_begins(Coarsening_stage::TRIANGULATION);
  const std::unique_ptr<Bordered_surface> surface = bordered_surface(state, dual);
  const std::vector<Triangle> triangles = dual_triangles(labels(state), context);
  context.stage_ends(Coarsening_stage::TRIANGULATION);
  context.stage_begins(Coarsening_stage::PLACEMENT);
  dual.positions.resize(state.number_of_clusters());
  surface->border.place(dual.positions);
  Fit_choice choice = *request.placement.fitted;
  choice.exchange_rounds = state.exchange_rounds;
  Coarse_mesh mesh(surface->faces, surface->border, triangles, dual.positions, &clusters);
  fit_vertices(mesh, choice);
  context.stage_ends(Coarsening_stage::FEEDBACK);
  if (!plain || !clusters.is_undone())
    dual.counts = repair_exchanged(state, request, mesh);
  if (!plain && !clusters.is_undone() && dual.number_left() > 0)
    remove_intersections(state, request, mesh, dual.counts);
  dual.triangles = mesh.triangles();
  return dual;
}

// Places the vertices, exchanges some of them together with their clusters, and repairs the placement. If this fails, nothing
// changes. `plain` may be the repaired placement of these clusters without exchanges: it is the result if exchanges are undone or
// leave more pairs of intersecting triangles.
inline Placed_dual place_with_exchange(Clustering_state& state, const Placement_request& request, Placed_dual* plain)
{
  Cluster_relocation clusters(state.featured_input(), *state.labels, Index(state.number_of_clusters()));
  try {
    Placed_dual dual = fit_and_exchange(state, request, plain, clusters);
    if (plain && (clusters.is_undone() || dual.number_left() > plain->number_left())) {
      clusters.undo();
      state.report.exchanged_vertices = 0;
      return std::move(*plain);
    }
    if (clusters.number() > 0) {
      dual.pieces = std::make_unique<Labelled_pieces>(state.featured_input(), labels(state), state.number_of_clusters());
      state.minimization.reset();
      state.editing.reset();
    }
    state.report.exchanged_vertices = clusters.number();
    return dual;
  } catch (...) {
    clusters.undo();
    throw;
  }
}

// Returns whether the clusters of cells are so many that only the distance counts.
inline bool has_dense_cells(const Clustering_state& state)
{
  return has_vertex_cells(state.input) &&
         double(state.number_of_clusters()) > min_share_of_dense * double(labels(state).labels().size());
}

inline bool may_exchange_vertices(const Clustering_state& state, const Placement_model& placement)
{
  return placement.fitted && state.exchange_rounds > 0 && state.minimization_end.max_rounds > 0 &&
         state.seeding.kind != Seeding::BY_CALLER && !has_dense_cells(state);
}

// Places the vertices, with exchanges if possible, and repairs the placement.
inline Placed_dual place_and_exchange(Clustering_state& state, const Placement_request& request)
{
  return may_exchange_vertices(state, request.placement) ? place_with_exchange(state, request, nullptr) : place(state, request);
}

// Seeds, grows and minimizes as before, with other densities.
inline void recluster(Clustering_state& state, const Seeding& seeding, const std::vector<double>& densities)
{
  const Minimization_end end = state.minimization_end;
  forget_clusters(state);
  if (state.input.cells) {
    Clustering_input base = state.input.cells->base();
    base.density = densities;
    state.input = Feature_cells::run(base, state.input.cells->edges(), state.context, state.input.cells->extent());
  } else {
    state.input.items.density = densities;
  }
  seed(state, seeding);
  grow(state);
  minimize(state, end);
}

// Returns whether other densities are likely to reduce the number of intersections. They are not if it exceeds half the number of
// clusters.
inline bool is_worth_reclustering(const Clustering_state& state, const Placed_dual& dual, const Repair_budget& budget)
{
  return has_many_intersections(state, dual) && 2 * dual.number_left() <= state.number_of_clusters() && !budget.is_spent() &&
         state.seeding.kind != Seeding::BY_CALLER && state.energy->depends_on_densities() && !has_vertex_cells(state.input);
}

// Raises the densities of the faces in clusters whose vertices belong to intersecting triangles.
inline void raise_at_intersections(std::vector<double>& densities, const Clustering_state& state, const Placed_dual& dual)
{
  std::vector<char> is_at_fault(state.number_of_clusters(), false);
  for (const auto& pair : dual.counts.intersections_left)
    for (const Index t : {pair.first, pair.second})
      for (const Index x : dual.triangles[t])
        is_at_fault[x] = true;
  const Clustering_input& pieces = dual.pieces->input();
  std::vector<char> is_raised(densities.size(), false);
  for (std::size_t p = 0; p < pieces.mesh.number_of_faces(); ++p)
    if (is_at_fault[dual.pieces->labels()[Index(p)]])
      is_raised[pieces.parent_of(Index(p))] = true;
  for (std::size_t f = 0; f < densities.size(); ++f)
    if (is_raised[f])
      densities[f] = (std::min)(4 * densities[f], largest_density);
}

// Returns the clusters of the first densities, and their placement after the exchange of vertices.
inline Placed_dual return_to_first(Clustering_state& state, const Seeding& seeding, const std::vector<double>& densities,
                                   const std::vector<Index>& first, Placed_dual dual)
{
  recluster(state, seeding, densities);
  restore_clusters(state, first, dual);
  return dual;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_PLACE_AND_EXCHANGE_H
