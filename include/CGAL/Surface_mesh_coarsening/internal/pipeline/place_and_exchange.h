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
  return repair_placement({*surface.faces, surface.border, placement}, output_coordinates, dual.triangles, dual.positions,
                          budget);
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
  dual.positions = place_vertices({*surface->faces, surface->border, placement}, dual.triangles);
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

// Places the vertices, exchanges some of them together with their clusters, and repairs the placement.
class Exchanging_placement
{
public:
  Exchanging_placement(Clustering_state& state, const Placement_model& placement, const Output_coordinates& output_coordinates,
                       Repair_budget& budget)
    : state_(state), placement_(placement), output_coordinates_(output_coordinates), budget_(budget),
      clusters_(state.featured_input(), *state.labels, Index(state.number_of_clusters()))
  {}

  // Selects the better placement, with or without exchange.
  Placed_dual run()
  {
    try {
      place_and_exchange();
      const std::size_t exchanged = clusters_.number();
      const bool keeps_exchanges = exchanged > 0 && !restore_plain_placement_if_better();
      if (keeps_exchanges) {
        state_.minimization.reset();
        state_.editing.reset();
      }
      state_.report.exchanged_vertices = keeps_exchanges ? exchanged : 0;
      return std::move(dual_);
    } catch (...) {
      clusters_.undo();
      throw;
    }
  }

private:
  static constexpr std::size_t max_repairs_by_exchange = 5;

  void place_and_exchange()
  {
    const Run_context& context = state_.context;
    context.stage_begins(Coarsening_stage::TRIANGULATION);
    surface_ = bordered_surface(state_, dual_);
    dual_.triangles = dual_triangles(labels(state_), context);
    context.stage_ends(Coarsening_stage::TRIANGULATION);
    context.stage_begins(Coarsening_stage::PLACEMENT);
    dual_.positions.resize(state_.number_of_clusters());
    surface_->border.place(dual_.positions);
    plain_ = placement_.exchanging(*surface_->faces, surface_->border, dual_.triangles, dual_.positions, relocation());
    context.stage_ends(Coarsening_stage::FEEDBACK);
    if (clusters_.number() > 0)
      surface_ = bordered_surface(state_, dual_);
    CGAL_assertion(stay_on_components(*surface_->faces, dual_.triangles));
    const std::vector<Vector> fitted = dual_.positions;
    repair(dual_);
    for (std::size_t i = 0; i < max_repairs_by_exchange && is_worth_repairing(state_, dual_, budget_); ++i)
      if (!repair_by_exchange())
        break;
    movement_by_repair_ = mean_movement(fitted, dual_.positions);
    context.throw_if_cancelled();
  }

  Vertex_relocation relocation() { return vertex_relocation(state_, *surface_->faces, clusters_); }

  void repair(Placed_dual& dual) const
  {
    dual.counts = repair_exchanged(state_, *surface_, placement_, output_coordinates_, dual, budget_);
  }

  // Relocates vertices to the triangles that still intersect. Returns whether fewer pairs remain; otherwise nothing changes.
  bool repair_by_exchange()
  {
    budget_.spend(placement_tests * dual_.triangles.size());
    const std::vector<Index> old_labels = labels(state_).labels();
    std::vector<Index> triangles;
    for (const auto& pair : dual_.counts.intersections_left)
      triangles.insert(triangles.end(), {pair.first, pair.second});
    sort_unique(triangles);
    Placed_dual next = with_vertices_at(triangles);
    if (next.number_left() < dual_.number_left()) {
      dual_ = std::move(next);
      return true;
    }
    clusters_.take_labels(old_labels);
    surface_ = bordered_surface(state_, dual_);
    return false;
  }

  // Relocates a vertex from elsewhere to each of some triangles, and repeats the repair of the placement.
  Placed_dual with_vertices_at(const std::vector<Index>& triangles)
  {
    Placed_dual next;
    next.triangles = dual_.triangles;
    next.positions = dual_.positions;
    Vertex_relocation to_triangles = relocation();
    to_triangles.destinations = triangles;
    state_.context.stage_begins(Coarsening_stage::FEEDBACK);
    placement_.exchanging(*surface_->faces, surface_->border, next.triangles, next.positions, to_triangles);
    state_.context.stage_ends(Coarsening_stage::FEEDBACK);
    surface_ = bordered_surface(state_, next);
    repair(next);
    next.counts.intersections_found = dual_.counts.intersections_found;
    next.counts.reversals_found = dual_.counts.reversals_found;
    return next;
  }

  // Replaces the placement by the placement without exchange in two cases: many intersections remain and the other placement has
  // fewer, or it has no more intersections and a smaller distance. Returns whether the placement was replaced.
  bool restore_plain_placement_if_better()
  {
    const bool has_many = has_many_intersections(state_, dual_);
    if (!has_many &&
        (budget_.is_spent() || !plain_may_be_closer() ||
         is_closer(*clustered_faces(state_, dual_), dual_.triangles, dual_.positions, plain_.triangles, plain_.positions)))
      return false;
    const std::vector<Index> labels_of_dual = labels(state_).labels();
    clusters_.undo();
    budget_.spend(placement_tests * dual_.triangles.size());
    Placed_dual plain = place(state_, placement_, output_coordinates_, budget_);
    const std::size_t left = plain.number_left();
    if ((has_many && left < dual_.number_left()) ||
        (left <= dual_.number_left() && is_closer(*clustered_faces(state_, plain), plain.triangles, plain.positions,
                                                  dual_.triangles, dual_.positions))) {
      dual_ = std::move(plain);
      return true;
    }
    clusters_.take_labels(labels_of_dual);
    return false;
  }

  // Returns whether the placement without exchange may be closer than the repaired placement. Except for its flips, the repair
  // increases the root mean square distance by no more than the vertices move.
  bool plain_may_be_closer() const
  {
    constexpr double max_part = 0.1; // of the vertices
    const std::size_t found = dual_.counts.intersections_found + dual_.counts.reversals_found;
    const bool is_small = double(found) < max_part * double(state_.number_of_clusters());
    return found > 0 && !(is_small && std::sqrt(plain_.error_after_exchange) + movement_by_repair_ < std::sqrt(plain_.error));
  }

  Clustering_state& state_;
  const Placement_model& placement_;
  const Output_coordinates& output_coordinates_;
  Repair_budget& budget_;
  Cluster_relocation clusters_;
  std::unique_ptr<Bordered_surface> surface_; // with the current clusters
  Placed_dual dual_;
  Plain_fit plain_;               // without exchange, before the repair
  double movement_by_repair_ = 0; // the root mean square over the vertices
};

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

// Places the vertices, with exchanges if possible, and repairs the placement.
inline Placed_dual place_and_exchange(Clustering_state& state, const Placement_model& placement,
                                      const Output_coordinates& output_coordinates, Repair_budget& budget)
{
  return may_exchange_vertices(state, placement) ? Exchanging_placement(state, placement, output_coordinates, budget).run()
                                                 : place(state, placement, output_coordinates, budget);
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_PLACE_AND_EXCHANGE_H
