// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_STAGES_IMPL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_STAGES_IMPL_H

#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Clustering_check.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_cells.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Minimization_state.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/place_and_exchange.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/vertex_numbers_impl.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Trial_fan.h>
#include <CGAL/Surface_mesh_coarsening/internal/refinement/Cluster_editing.h>
#include <CGAL/Surface_mesh_coarsening/internal/seeding/Initial_clustering.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL::Surface_mesh_coarsening::internal {

CGAL_SURFACE_MESH_COARSENING_INLINE Clustering_state::Clustering_state() = default;
CGAL_SURFACE_MESH_COARSENING_INLINE Clustering_state::~Clustering_state() = default;

CGAL_SURFACE_MESH_COARSENING_INLINE const Clustering_input& Clustering_state::base_input() const
{
  return input.cells ? input.cells->base() : input.items;
}

CGAL_SURFACE_MESH_COARSENING_INLINE const Featured_input& Clustering_state::featured_input() const
{
  return initial ? initial->input() : input;
}

CGAL_SURFACE_MESH_COARSENING_INLINE void forget_clusters(Clustering_state& state)
{
  state.seeding = Seeding();
  state.editing.reset();
  state.minimization.reset();
  state.labels.reset();
  state.initial.reset();
}

// A step that fails or is cancelled leaves no clusters, so the next step must seed or adopt labels.
template <class Step>
void all_or_nothing(Clustering_state& state, const Step& step)
{
  try {
    step();
  } catch (...) {
    forget_clusters(state);
    throw;
  }
}

inline void reset_report(Clustering_state& state)
{
  state.report = Coarsening_report();
  if (state.input.cells) {
    state.report.feature_lines = state.input.cells->graph().lines().size();
    state.report.feature_corners = state.input.cells->graph().number_of_corners();
  }
}

inline void begin_minimization(Clustering_state& state)
{
  labels(state);
  if (state.minimization)
    return;
  state.minimization = state.energy->minimization(state.featured_input(), *state.labels, state.number_of_clusters(),
                                                  state.follows_paper, state.context);
  state.report.initial_energy = state.report.final_energy = state.minimization->energy();
}

CGAL_SURFACE_MESH_COARSENING_INLINE void cluster_faces(Clustering_state& state)
{
  if (!has_vertex_cells(state.input))
    return;
  forget_clusters(state);
  state.input = with_items(state.input, Feature_cells::AT_FEATURES, state.context);
}

inline void choose_items(Clustering_state& state, const Seeding& seeding)
{
  if (!needs_vertex_cells(state, seeding))
    cluster_faces(state);
  else if (!has_vertex_cells(state.input))
    state.input = with_items(state.input, Feature_cells::AT_ALL_VERTICES, state.context);
}

inline void seed_items(Clustering_state& state, const Seeding& seeding)
{
  forget_clusters(state);
  reset_report(state);
  state.seeding = seeding;
  state.minimization_end = Minimization_end();
  state.initial = std::make_unique<Initial_clustering>(state.input, merging(state, seeding), state.report, state.context);
  all_or_nothing(state, [&] {
    if (seeding.kind == Seeding::AT_LEVEL) {
      const Index level = Index((std::min)(seeding.value, std::size_t(NONE / 4)));
      if (seeding.number == 0)
        state.initial->seed_from_level(level);
      else
        state.initial->seed_from_level(level, seeding.number);
      return;
    }
    if (state.subdivides_input)
      state.initial->subdivide(seeding.value, faces_per_cluster);
    state.initial->seed(seeding.value);
  });
}

// Calls a step. If the cells of vertices do not reach the number of clusters, calls `with_faces` instead, because faces can be
// subdivided.
template <class Step, class Step_with_faces>
void run_with_any_items(Clustering_state& state, const Step& step, const Step_with_faces& with_faces)
{
  const Seeding seeding = state.seeding;
  try {
    step();
  } catch (const Unreachable_number_of_vertices&) {
    if (!has_vertex_cells(state.input))
      throw;
    cluster_faces(state);
    seed_items(state, seeding);
    with_faces();
  }
}

CGAL_SURFACE_MESH_COARSENING_INLINE void seed(Clustering_state& state, const Seeding& seeding)
{
  state.context.stage_begins(Coarsening_stage::SEEDING);
  forget_clusters(state);
  choose_items(state, seeding);
  state.seeding = seeding;
  run_with_any_items(state, [&] { seed_items(state, seeding); }, [] {});
  state.context.stage_ends(Coarsening_stage::SEEDING);
}

CGAL_SURFACE_MESH_COARSENING_INLINE void grow(Clustering_state& state)
{
  if (!state.initial)
    throw std::logic_error("grow() was called before seed()");
  state.context.stage_begins(Coarsening_stage::GROWTH);
  state.editing.reset();
  state.minimization.reset();
  state.labels.reset();
  const auto grow_items = [&] {
    all_or_nothing(state, [&] { state.labels = std::make_unique<Cluster_labels>(state.initial->grow()); });
  };
  run_with_any_items(state, grow_items, grow_items);
  all_or_nothing(state, [&] { begin_minimization(state); });
  state.context.stage_ends(Coarsening_stage::GROWTH);
}

CGAL_SURFACE_MESH_COARSENING_INLINE void set_clusters(Clustering_state& state, std::unique_ptr<Cluster_labels> labels,
                                                      std::size_t number)
{
  forget_clusters(state);
  const std::string fault =
    Clustering_check(*labels, number).fault([](std::size_t x) { return "cluster " + std::to_string(x); });
  if (!fault.empty())
    throw Invalid_input(fault);
  labels->recount();
  reset_report(state);
  state.report.clusters = number;
  state.labels = std::move(labels);
  all_or_nothing(state, [&] { begin_minimization(state); });
}

// Returns whether anything changed.
inline bool run_rounds(Clustering_state& state, const Minimization_end& end)
{
  state.editing.reset();
  begin_minimization(state);
  Coarsening_report& report = state.report;
  const Minimization_progress progress = state.minimization->run(end);
  report.rounds += progress.rounds;
  report.moves += progress.moves;
  report.tests += progress.tests;
  report.refused_by_boundary_counts += progress.refused_by_boundary_counts;
  report.refused_by_guarantee += progress.refused_by_guarantee;
  report.final_energy = state.minimization->energy();
  report.converged = progress.moves == 0;
  state.context.round_done(report.rounds, progress.moves, report.final_energy);
  return progress.moves != 0;
}

CGAL_SURFACE_MESH_COARSENING_INLINE bool minimize_round(Clustering_state& state)
{
  const bool has_changed = run_rounds(state, {1, 0});
  std::size_t& max_rounds = state.minimization_end.max_rounds;
  max_rounds = (std::max)(max_rounds, state.report.rounds);
  return has_changed;
}

CGAL_SURFACE_MESH_COARSENING_INLINE void minimize(Clustering_state& state, const Minimization_end& end)
{
  begin_minimization(state);
  state.minimization_end = end;
  state.context.stage_begins(Coarsening_stage::MINIMIZATION);
  Coarsening_report& report = state.report;
  double energy = state.minimization->energy();
  // Moves that lower another energy would increase the residuals of quadrics.
  bool has_ended = state.initial && state.initial->is_merged_by_quadrics();
  report.converged = has_ended;
  const std::size_t rounds_before = report.rounds;
  for (std::size_t made = 0; made < end.max_rounds && !has_ended; made = report.rounds - rounds_before) {
    const std::size_t rounds = (std::min)(end.max_rounds - made, state.minimization->rounds_at_a_time());
    has_ended = !run_rounds(state, {rounds, end.tolerance}) || energy - report.final_energy <= end.tolerance * energy;
    energy = report.final_energy;
    report.converged = has_ended;
  }
  state.context.stage_ends(Coarsening_stage::MINIMIZATION);
}

CGAL_SURFACE_MESH_COARSENING_INLINE double energy(const Clustering_state& state)
{
  const Cluster_labels& current = labels(state);
  if (state.minimization)
    return state.minimization->energy();
  double sum = 0;
  for (const Cluster_report& x : state.energy->cluster_reports(state.working_input(), current, state.number_of_clusters()))
    sum += x.energy;
  return sum;
}

CGAL_SURFACE_MESH_COARSENING_INLINE const Cluster_labels& labels(const Clustering_state& state)
{
  if (!state.labels)
    throw std::logic_error("there are no clusters before grow() or set_clusters()");
  return *state.labels;
}

CGAL_SURFACE_MESH_COARSENING_INLINE std::vector<Index> seeds(const Clustering_state& state)
{
  std::vector<Index> faces;
  if (state.initial)
    for (const Index f : state.initial->seeds())
      faces.push_back(state.working_input().parent_of(f));
  return faces;
}

CGAL_SURFACE_MESH_COARSENING_INLINE std::size_t cluster_of_face(const Clustering_state& state, Index face)
{
  return cluster_of_face(state.featured_input(), labels(state), face);
}

CGAL_SURFACE_MESH_COARSENING_INLINE std::vector<Index> clusters_of_base_faces(const Clustering_state& state)
{
  const Clustering_input& base = state.base_input();
  std::vector<Index> clusters;
  clusters.reserve(base.mesh.number_of_faces());
  for (std::size_t f = 0; f < base.mesh.number_of_faces(); ++f)
    clusters.push_back(Index(cluster_of_face(state, base.parent_of(Index(f)))));
  return clusters;
}

CGAL_SURFACE_MESH_COARSENING_INLINE void check_cluster(const Clustering_state& state, std::size_t cluster)
{
  labels(state);
  if (cluster >= state.number_of_clusters())
    throw Invalid_input("there is no cluster " + std::to_string(cluster) + " of " +
                        std::to_string(state.number_of_clusters()));
}

CGAL_SURFACE_MESH_COARSENING_INLINE void freeze_cluster(Clustering_state& state, std::size_t cluster, bool is_frozen)
{
  check_cluster(state, cluster);
  state.seeding = Seeding(); // reclustering would not preserve the frozen cluster
  state.labels->freeze(Index(cluster), is_frozen);
}

CGAL_SURFACE_MESH_COARSENING_INLINE bool is_frozen(const Clustering_state& state, std::size_t cluster)
{
  check_cluster(state, cluster);
  return state.labels->is_frozen(Index(cluster));
}

inline bool edit_cluster(Clustering_state& state, std::size_t cluster, bool (Cluster_editing::*change)(Index))
{
  if (is_frozen(state, cluster))
    return false;
  if (state.featured_input().cells && state.featured_input().cells->has_features())
    throw Invalid_input("clusters cannot be edited, nor merged to levels, where features are kept");
  state.seeding = Seeding(); // reclustering would not repeat the change
  if (!state.editing)
    state.editing = std::make_unique<Cluster_editing>(state.featured_input(), *state.labels, Index(state.number_of_clusters()));
  bool is_possible = false;
  all_or_nothing(state, [&] { is_possible = ((*state.editing).*change)(Index(cluster)); });
  if (is_possible) {
    state.minimization.reset();
    state.report.clusters = state.editing->number_of_clusters();
    state.report.converged = false;
  }
  return is_possible;
}

CGAL_SURFACE_MESH_COARSENING_INLINE bool split_cluster(Clustering_state& state, std::size_t cluster)
{
  return edit_cluster(state, cluster, &Cluster_editing::split);
}

CGAL_SURFACE_MESH_COARSENING_INLINE bool remove_cluster(Clustering_state& state, std::size_t cluster)
{
  return edit_cluster(state, cluster, &Cluster_editing::remove);
}

CGAL_SURFACE_MESH_COARSENING_INLINE std::vector<Cluster_report> cluster_reports(const Clustering_state& state,
                                                                                std::size_t faces)
{
  const std::size_t clusters = state.number_of_clusters();
  const Cluster_labels& current = labels(state);
  std::vector<Cluster_report> reports = state.energy->cluster_reports(state.working_input(), current, clusters);
  const Labelled_pieces pieces(state.featured_input(), current, clusters);
  const Clustered_faces clustered(pieces, clusters, state.context);
  for (std::size_t x = 0; x < clusters; ++x)
    reports[x].centroid = to_point(state.frame.to_mesh(clustered.cluster_centroid(x)));
  for (std::size_t f = 0; f < faces; ++f)
    ++reports[cluster_of_face(state, Index(f))].faces;
  return reports;
}

// Checks the cluster, and that the items of the clusters are the faces of the caller's mesh.
inline void check_move(const Clustering_state& state, std::size_t cluster)
{
  check_cluster(state, cluster);
  if (state.featured_input().cells || state.report.subdivided_components > 0)
    throw Invalid_input("single faces do not move where features are kept, or where faces are subdivided");
}

CGAL_SURFACE_MESH_COARSENING_INLINE bool boundary_counts_allow_move(const Clustering_state& state, Index face,
                                                                    std::size_t cluster)
{
  check_move(state, cluster);
  return labels(state)[face] != cluster && Valid_moves(*state.labels, nullptr).boundary_counts_allow(face, Index(cluster));
}

CGAL_SURFACE_MESH_COARSENING_INLINE bool guarantee_allows_move(Clustering_state& state, Index face, std::size_t cluster)
{
  check_move(state, cluster);
  return labels(state)[face] != cluster && Valid_moves(*state.labels, nullptr).may_move(face, Index(cluster));
}

CGAL_SURFACE_MESH_COARSENING_INLINE Placed_dual place(const Clustering_state& state, const Placement_model& placement,
                                                      const Output_coordinates& output_coordinates)
{
  Repair_budget budget = repair_budget(state);
  return place(state, {placement, output_coordinates, budget});
}

// If pairs of intersecting triangles remain after the repair, the mesh is reclustered with other densities, without quadrics, which
// do not depend on densities. Vertices are not exchanged in these clusterings, because the exchange takes longer and the number of
// pairs decides among the results; they are exchanged in the end if few pairs remain.
CGAL_SURFACE_MESH_COARSENING_INLINE Placed_dual place_embedded(Clustering_state& state, const Placement_model& placement,
                                                               const Output_coordinates& output_coordinates)
{
  // Four times leave more pairs, because each spends a part of the budget.
  constexpr std::size_t max_repetitions = 2;
  Repair_budget budget = repair_budget(state);
  const Placement_request request{placement, output_coordinates, budget};
  Placed_dual first = place_and_exchange(state, request);
  if (!is_worth_reclustering(state, first, budget))
    return first;
  const std::vector<Index> first_labels = labels(state).labels();
  const std::size_t exchanged = state.report.exchanged_vertices;
  // Clusters that are not merged by quadrics are farther: by a third on the Dragon as scanned. A few pairs less do not justify that.
  const bool was_merged_by_quadrics = state.initial && state.initial->is_merged_by_quadrics();
  const std::size_t limit = was_merged_by_quadrics ? (first.number_left() + 1) / 2 : first.number_left();
  const Seeding first_seeding = state.seeding;
  Seeding seeding = first_seeding;
  seeding.may_use_quadrics = false;
  std::size_t clusterings = 1, fewest = limit;
  const std::vector<double> first_densities = state.base_input().density;
  std::vector<double> densities = first_densities, best_densities = densities;
  Placed_dual dual;
  do {
    raise_at_intersections(densities, state, clusterings == 1 ? first : dual);
    recluster(state, seeding, densities);
    budget.spend(placement_tests * first.triangles.size());
    dual = place(state, request);
    ++clusterings;
    if (dual.number_left() < fewest) {
      fewest = dual.number_left();
      best_densities = densities;
    }
  } while (clusterings <= max_repetitions && is_worth_reclustering(state, dual, budget));
  if (fewest == limit) {
    dual = return_to_first(state, first_seeding, first_densities, first_labels, std::move(first));
    state.report.exchanged_vertices = exchanged;
    ++clusterings;
  } else {
    budget = repair_budget(state, 2); // the selected result must not be worse than before
    if (dual.number_left() > fewest) {
      recluster(state, seeding, best_densities);
      ++clusterings;
      dual = place(state, request);
    }
    if (!has_many_intersections(state, dual) && may_exchange_vertices(state, placement))
      dual = place_with_exchange(state, request, &dual);
  }
  dual.clusterings = clusterings;
  return dual;
}

CGAL_SURFACE_MESH_COARSENING_INLINE void
report_placement(Coarsening_report& report, const std::vector<Triangle>& triangles, const std::vector<Vector>& positions,
                 const Repair_counts& counts, std::size_t clusterings)
{
  report.intersections_found = counts.intersections_found;
  report.intersections_left = counts.intersections_left.size();
  report.intersecting_faces.assign(counts.intersections_left.begin(), counts.intersections_left.end());
  report.reversals_found = counts.reversals_found;
  report.reversals_left = counts.reversals_left;
  report.narrow_faces = narrowest_triangles(positions, triangles);
  report.clusterings = clusterings;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_STAGES_IMPL_H
