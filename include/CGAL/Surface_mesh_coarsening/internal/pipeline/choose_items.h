// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_CHOOSE_ITEMS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_CHOOSE_ITEMS_H

#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_cells.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/Clustering_state.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Placement_model.h>

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Returns the same input with the cells of all vertices as items, or with faces as items, except at features.
inline Featured_input with_items(const Featured_input& input, Feature_cells::Extent extent,
                                 const Cancellation_point& cancellation)
{
  const Clustering_input& base = input.cells ? input.cells->base() : input.items;
  const Feature_edges edges = input.cells ? input.cells->edges() : Feature_edges(base.mesh);
  if (extent == Feature_cells::AT_FEATURES && edges.empty())
    return {base, nullptr};
  return Feature_cells::run(base, edges, cancellation, extent);
}

// Other placements than the fit do not return the vertices of single cells.
template <class Placement>
void choose_items_for(const Placement& placement, Clustering_state& state)
{
  if constexpr (exchanges_vertices<Placement>)
    state.share_for_cells = placement.exchanges() ? min_share_of_cells : 0;
  else
    state.may_cluster_cells = false;
}

// Returns whether the cells of vertices serve better than faces. A face is half a vertex, so clusters of few faces have vertices
// off the surface.
inline bool needs_vertex_cells(const Clustering_state& state, const Seeding& seeding)
{
  std::size_t vertices = 0;
  for (const Component& c : state.base_input().mesh.components)
    vertices += c.max_clusters();
  return state.may_cluster_cells && seeding.may_use_cells && seeding.kind == Seeding::FOR_NUMBER && !state.subdivides_input &&
         double(seeding.value) > state.share_for_cells * double(vertices);
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_CHOOSE_ITEMS_H
