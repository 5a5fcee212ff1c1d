// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_PLACE_AND_EXCHANGE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_PLACE_AND_EXCHANGE_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/place_vertices.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/fit_vertices.h>
#include <CGAL/Surface_mesh_coarsening/internal/refinement/Cluster_relocation.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Each placement after the first takes about as long as this number of exact tests for each triangle.
constexpr std::size_t placement_tests = 1000;

// Returns the surface with its current clusters.
inline std::unique_ptr<Clustered_faces> clustered_faces(const Clustering_state& state, Placed_dual& dual)
{
  dual.pieces = std::make_unique<Labelled_pieces>(state.featured_input(), labels(state), state.number_of_clusters());
  return std::make_unique<Clustered_faces>(*dual.pieces, state.number_of_clusters(), state.context);
}

// The surface with its current clusters, and the positions of vertices on its border and features.
struct Bordered_surface
{
  Bordered_surface(std::unique_ptr<Clustered_faces> surface, bool places_on_borders)
    : faces(std::move(surface)),
      border(*faces, places_on_borders)
  {}

  std::unique_ptr<Clustered_faces> faces;
  Border_arcs border;
};

inline std::unique_ptr<Bordered_surface> bordered_surface(const Clustering_state& state, Placed_dual& dual)
{
  return std::make_unique<Bordered_surface>(clustered_faces(state, dual), !state.follows_paper);
}

// Returns one of some parts of the budget.
inline Repair_budget repair_budget(const Clustering_state& state, std::size_t parts = 1)
{
  return Repair_budget(state.base_input().mesh.number_of_faces(), parts);
}

// Returns whether pairs of triangles still intersect, and are at most half as many as the clusters.
inline bool is_worth_repairing(const Clustering_state& state, const Placed_dual& dual, const Repair_budget& budget)
{
  return dual.number_left() > 0 && 2 * dual.number_left() <= state.number_of_clusters() && !budget.is_spent();
}

// Returns whether there are more than one for a thousand clusters. Fewer do not justify another placement or clustering of the
// whole mesh.
inline bool has_many_intersections(const Clustering_state& state, const Placed_dual& dual)
{
  return 1000 * dual.number_left() > state.number_of_clusters();
}

// Returns the functions by which the placement relocates clusters while it exchanges vertices.
inline Vertex_relocation vertex_relocation(const Clustering_state& state, const Clustered_faces& surface,
                                           Cluster_relocation& clusters)
{
  Vertex_relocation relocation;
  relocation.rounds = state.exchange_rounds;
  relocation.begins = [&state] {
    state.context.stage_ends(Coarsening_stage::PLACEMENT);
    state.context.stage_begins(Coarsening_stage::FEEDBACK);
  };
  relocation.relocate = [&](Index x, Index into, const std::vector<Index>& faces) { return clusters.relocate(x, into, faces); };
  relocation.undo = [&] { clusters.undo(); };
  relocation.within_bounds = [&](Index x, const Vector& p) {
    return clusters.has_changed(x) ? closest_in_box(p, clusters.vertex_bounds(x)) : surface.within_bounds(x, p);
  };
  return relocation;
}

// Repairs a placement if the output is to be repaired.
inline Repair_counts repaired(const Clustering_state& state, const Bordered_surface& surface, const Placement_model& placement,
                              const Output_coordinates& output_coordinates, Placed_dual& dual, Repair_budget& budget)
{
  if (!state.repairs_output)
    return Repair_counts();
  return repair_placement(*surface.faces, surface.border, placement, output_coordinates, dual.triangles, dual.positions, budget);
}

// Places the vertices and repairs the placement.
inline Placed_dual place(const Clustering_state& state, const Placement_model& placement,
                         const Output_coordinates& output_coordinates, Repair_budget& budget)
{
  state.context.stage_begins(Coarsening_stage::TRIANGULATION);
  Placed_dual dual;
  const std::unique_ptr<Bordered_surface> surface = bordered_surface(state, dual);
  dual.triangles = dual_triangles(labels(state), state.context);
  state.context.stage_ends(Coarsening_stage::TRIANGULATION);
  dual.positions = place_vertices(*surface->faces, surface->border, placement, dual.triangles);
  dual.counts = repaired(state, *surface, placement, output_coordinates, dual, budget);
  state.context.throw_if_cancelled();
  return dual;
}

// Moves the vertices into their bounds and repairs the placement.
inline Repair_counts repair_exchanged(const Clustering_state& state, const Bordered_surface& surface,
                                      const Placement_model& placement, const Output_coordinates& output_coordinates,
                                      Placed_dual& dual, Repair_budget& budget)
{
  for (std::size_t x = 0; x < dual.positions.size(); ++x)
    dual.positions[x] = surface.faces->within_bounds(x, dual.positions[x]);
  return repaired(state, surface, placement, output_coordinates, dual, budget);
}

// Relocates a vertex from elsewhere to each of some triangles, and repeats the repair of the placement.
inline Placed_dual with_vertices_at(const std::vector<Index>& triangles, Clustering_state& state,
                                    const Placement_model& placement, const Output_coordinates& output_coordinates,
                                    Cluster_relocation& clusters, std::unique_ptr<Bordered_surface>& surface,
                                    const Placed_dual& dual, Repair_budget& budget)
{
  Placed_dual next;
  next.triangles = dual.triangles;
  next.positions = dual.positions;
  Vertex_relocation relocation = vertex_relocation(state, *surface->faces, clusters);
  relocation.destinations = triangles;
  state.context.stage_begins(Coarsening_stage::FEEDBACK);
  placement.exchanging(*surface->faces, surface->border, next.triangles, next.positions, relocation);
  state.context.stage_ends(Coarsening_stage::FEEDBACK);
  surface = bordered_surface(state, next);
  next.counts = repair_exchanged(state, *surface, placement, output_coordinates, next, budget);
  next.counts.intersections_found = dual.counts.intersections_found;
  next.counts.reversals_found = dual.counts.reversals_found;
  return next;
}

// Relocates vertices to the triangles that still intersect. Returns whether fewer pairs remain; otherwise nothing changes.
inline bool repair_by_exchange(Clustering_state& state, const Placement_model& placement,
                               const Output_coordinates& output_coordinates, Cluster_relocation& clusters,
                               std::unique_ptr<Bordered_surface>& surface, Placed_dual& dual, Repair_budget& budget)
{
  budget.spend(placement_tests * dual.triangles.size());
  const std::vector<Index> old_labels = labels(state).labels();
  std::vector<Index> triangles;
  for (const auto& pair : dual.counts.intersections_left)
    triangles.insert(triangles.end(), {pair.first, pair.second});
  sort_unique(triangles);
  Placed_dual next = with_vertices_at(triangles, state, placement, output_coordinates, clusters, surface, dual, budget);
  const bool is_better = next.number_left() < dual.number_left();
  if (is_better) {
    dual = std::move(next);
  } else {
    clusters.take_labels(old_labels);
    surface = bordered_surface(state, dual);
  }
  return is_better;
}

// Returns the root mean square of the movements of vertices.
inline double mean_movement(const std::vector<Vector>& from, const std::vector<Vector>& to)
{
  double sum = 0;
  for (std::size_t x = 0; x < from.size(); ++x) {
    const Vector d = to[x] - from[x];
    sum += dot(d, d);
  }
  return std::sqrt(sum / double(from.size()));
}

// Returns whether each triangle joins clusters of one component, so that a vertex lies on the component of its cluster.
inline bool stay_on_components(const Clustered_faces& surface, const std::vector<Triangle>& triangles)
{
  const auto component = [&](Index x) { return surface.input().mesh.component[*surface.faces(x).begin()]; };
  return std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return component(t[0]) == component(t[1]) && component(t[1]) == component(t[2]);
  });
}

constexpr std::size_t max_repairs_by_exchange = 5;

// Places the vertices, exchanges some of them together with their clusters, and repairs the placement. `plain` receives the fit
// without exchange, before the repair.
inline Placed_dual place_and_exchange(Clustering_state& state, const Placement_model& placement,
                                      const Output_coordinates& output_coordinates, Cluster_relocation& clusters,
                                      Repair_budget& budget, Plain_fit& plain)
{
  state.context.stage_begins(Coarsening_stage::TRIANGULATION);
  Placed_dual dual;
  std::unique_ptr<Bordered_surface> surface = bordered_surface(state, dual);
  dual.triangles = dual_triangles(labels(state), state.context);
  state.context.stage_ends(Coarsening_stage::TRIANGULATION);
  state.context.stage_begins(Coarsening_stage::PLACEMENT);
  dual.positions.resize(state.number_of_clusters());
  surface->border.place(dual.positions);
  plain = placement.exchanging(*surface->faces, surface->border, dual.triangles, dual.positions,
                               vertex_relocation(state, *surface->faces, clusters));
  state.context.stage_ends(Coarsening_stage::FEEDBACK);
  if (clusters.number() > 0)
    surface = bordered_surface(state, dual);
  CGAL_assertion(stay_on_components(*surface->faces, dual.triangles));
  const std::vector<Vector> fitted = dual.positions;
  dual.counts = repair_exchanged(state, *surface, placement, output_coordinates, dual, budget);
  bool is_better = true;
  for (std::size_t i = 0; i < max_repairs_by_exchange && is_better && is_worth_repairing(state, dual, budget); ++i)
    is_better = repair_by_exchange(state, placement, output_coordinates, clusters, surface, dual, budget);
  dual.movement_by_repair = mean_movement(fitted, dual.positions);
  state.context.throw_if_cancelled();
  return dual;
}

// Returns whether the clusters of cells are so many that only the distance counts.
inline bool has_dense_cells(const Clustering_state& state)
{
  return has_vertex_cells(state.input) &&
         double(state.number_of_clusters()) > min_share_of_dense * double(labels(state).labels().size());
}

inline bool may_exchange_vertices(const Clustering_state& state, const Placement_model& placement)
{
  return placement.exchanging && state.exchange_rounds > 0 && state.minimization_end.max_rounds > 0 &&
         state.seeding.kind != Seeding::BY_CALLER && !has_dense_cells(state);
}

// Returns whether the placement without exchange may be closer than a repaired placement. Except for its flips, the repair
// increases the root mean square distance by no more than the vertices move.
inline bool may_be_closer_without(const Clustering_state& state, const Placed_dual& dual, const Plain_fit& plain)
{
  constexpr double max_part = 0.1; // of the vertices
  const std::size_t found = dual.counts.intersections_found + dual.counts.reversals_found;
  const bool is_small = double(found) < max_part * double(state.number_of_clusters());
  return found > 0 && !(is_small && std::sqrt(plain.error_after_exchange) + dual.movement_by_repair < std::sqrt(plain.error));
}

// Replaces a repaired placement by the placement without exchange in two cases: many intersections remain and the other
// placement has fewer, or it has no more intersections and a smaller distance. `unrepaired` is the placement without exchange
// before its repair. Returns whether the placement was replaced.
inline bool is_better_plain(Clustering_state& state, const Placement_model& placement,
                            const Output_coordinates& output_coordinates, Cluster_relocation& clusters, Repair_budget& budget,
                            const Plain_fit& unrepaired, Placed_dual& dual)
{
  if (clusters.number() == 0)
    return false;
  const bool has_many = has_many_intersections(state, dual);
  if (!has_many && (budget.is_spent() || !may_be_closer_without(state, dual, unrepaired) ||
                    is_closer(*clustered_faces(state, dual), dual.triangles, dual.positions, unrepaired.triangles,
                              unrepaired.positions)))
    return false;
  const std::vector<Index> labels_of_dual = labels(state).labels();
  clusters.undo();
  budget.spend(placement_tests * dual.triangles.size());
  Placed_dual plain = place(state, placement, output_coordinates, budget);
  const std::size_t left = plain.number_left();
  if ((has_many && left < dual.number_left()) ||
      (left <= dual.number_left() && is_closer(*clustered_faces(state, plain), plain.triangles, plain.positions,
                                               dual.triangles, dual.positions))) {
    dual = std::move(plain);
    return true;
  }
  clusters.take_labels(labels_of_dual);
  return false;
}

// Selects the better placement, with or without exchange.
inline Placed_dual place_and_exchange(Clustering_state& state, const Placement_model& placement,
                                      const Output_coordinates& output_coordinates, Repair_budget& budget)
{
  if (!may_exchange_vertices(state, placement))
    return place(state, placement, output_coordinates, budget);
  Cluster_relocation clusters(state.featured_input(), *state.labels, Index(state.number_of_clusters()));
  try {
    Plain_fit plain;
    Placed_dual dual = place_and_exchange(state, placement, output_coordinates, clusters, budget, plain);
    std::size_t exchanged = clusters.number();
    if (is_better_plain(state, placement, output_coordinates, clusters, budget, plain, dual))
      exchanged = 0;
    if (exchanged > 0) {
      state.minimization.reset();
      state.editing.reset();
    }
    state.report.exchanged_vertices = exchanged;
    return dual;
  } catch (...) {
    clusters.undo();
    throw;
  }
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_PLACE_AND_EXCHANGE_H
