// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_PREPARE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_PREPARE_H

#include <CGAL/Surface_mesh_coarsening/internal/features/find_features.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/Clustering_state.h>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The first stage: checks the mesh, copies it to arrays, and computes or reads densities and features (section 5.2).
template <class FaceGraph, class NamedParameters>
void prepare(const FaceGraph& mesh, const NamedParameters& np, Execution execution, Numbering<FaceGraph>& elements,
             Clustering_state& state)
{
  state.visitor = Visitor_handle(get_parameter(np, CGAL::internal_np::visitor));
  state.execution = execution;
  state.visitor.stage_begins(Coarsening_stage::PREPARATION);
  const Cancellation_point cancellation = state.cancellation();
  elements = numbering(mesh, np, cancellation);
  state.input.items = clustering_input(mesh, np, elements, state.frame, cancellation, execution);
  state.subdivides_input = choose_parameter(get_parameter(np, internal_np::subdivide_input_p), false);
  state.merges_by_area = choose_parameter(get_parameter(np, internal_np::merge_by_area_p), false);
  state.checks_boundary_counts = choose_parameter(get_parameter(np, internal_np::boundary_count_check_p), false);
  state.places_on_borders = choose_parameter(get_parameter(np, internal_np::place_on_borders_p), true);
  state.repairs_output = choose_parameter(get_parameter(np, internal_np::repair_output_p), true);
  constexpr bool has_densities = has_parameter<internal_np::face_density_t, NamedParameters>;
  const std::size_t default_feedback = has_densities ? 0 : Coarsening_defaults::error_feedback;
  state.exchange_rounds = choose_parameter(get_parameter(np, internal_np::error_feedback_p), default_feedback);
  state.max_local_repairs = choose_parameter(get_parameter(np, internal_np::local_repairs_p), Coarsening_defaults::local_repairs);
  state.dropped_components = drop_small_components(np, state.frame, state.input.items, cancellation);
  read_features(mesh, np, elements, state.input, state.frame, state.patches, cancellation);
  state.visitor.stage_ends(Coarsening_stage::PREPARATION);
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_PREPARE_H
