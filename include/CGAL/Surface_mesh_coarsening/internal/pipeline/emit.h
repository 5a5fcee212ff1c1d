// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_EMIT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_EMIT_H

#include <CGAL/Surface_mesh_coarsening/internal/output/Face_graph_filler.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/Output_maps.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The last stage: fills the output. Calls `before` after all steps that can fail, while the output is still unchanged.
template <class Output, class NamedParameters, class Before>
void emit(Clustering_state& state, const Placed_dual& dual, Output& output, const NamedParameters& np, const Before& before)
{
  report_placement(state.report, dual.triangles, dual.positions, dual.counts, dual.clusterings);
  Face_graph_filler<Output, NamedParameters> filler(dual.positions, state.frame, dual.triangles, output, np,
                                                    state.cancellation());
  state.visitor.throw_if_cancelled();
  before(dual.positions);
  filler.commit();
  write_features(output, np, dual.triangles, dual.pieces->features(), state.featured_input(), labels(state), state.patches);
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_EMIT_H
