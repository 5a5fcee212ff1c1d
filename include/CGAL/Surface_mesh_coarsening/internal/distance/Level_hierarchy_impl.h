// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_LEVEL_HIERARCHY_IMPL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_LEVEL_HIERARCHY_IMPL_H

#include <CGAL/Surface_mesh_coarsening/internal/base/inline.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/Distance_estimate.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/Level_hierarchy.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/place_vertices.h>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The faces with geometry; the items may be cells without geometry.
inline const Clustering_input& pieces_of(const Clustering_state& state)
{
  const Featured_input& input = state.featured_input();
  return input.cells ? input.cells->pieces() : input.items;
}

inline const Clustering_input& input_without_features(const Clustering_state& state)
{
  if (state.featured_input().cells && state.featured_input().cells->has_features())
    throw Invalid_input("clusters cannot be edited, nor merged to levels, where features are kept");
  return state.working_input();
}

CGAL_SURFACE_MESH_COARSENING_INLINE Level_hierarchy::Level_hierarchy(const Clustering_state& state)
  : state_(state), history_(input_without_features(state), internal::labels(state), Index(state.number_of_clusters()),
                            state.cancellation())
{}

CGAL_SURFACE_MESH_COARSENING_INLINE std::vector<Index> Level_hierarchy::ancestors(std::size_t fine, std::size_t coarse) const
{
  return history_.ancestors(fine, coarse);
}

CGAL_SURFACE_MESH_COARSENING_INLINE std::vector<Triangle> Level_hierarchy::triangles(std::size_t level) const
{
  return history_.triangles(level);
}

CGAL_SURFACE_MESH_COARSENING_INLINE std::vector<Index> Level_hierarchy::clusters_of_faces(std::size_t level,
                                                                                          std::size_t number) const
{
  const std::vector<Index> of_cluster = history_.ancestors(finest(), level);
  std::vector<Index> clusters(number);
  for (std::size_t f = 0; f < number; ++f) {
    const std::size_t x = cluster_of_face(state_, Index(f));
    clusters[f] = x == finest() ? Index(level) : of_cluster[history_.number(Index(x))];
  }
  return clusters;
}

CGAL_SURFACE_MESH_COARSENING_INLINE Cluster_labels Level_hierarchy::labels(std::size_t level) const
{
  const Feature_cells* const cells = state_.featured_input().cells.get();
  const Clustering_input& pieces = pieces_of(state_);
  const Cluster_labels& finest_labels = internal::labels(state_);
  const std::vector<Index> of_cluster = history_.ancestors(finest(), level);
  Cluster_labels result(pieces.mesh);
  for (std::size_t f = 0; f < pieces.mesh.number_of_faces(); ++f)
    result.set(Index(f), of_cluster[history_.number(finest_labels[cells ? cells->polygon(Index(f)) : Index(f)])]);
  result.recount();
  return result;
}

CGAL_SURFACE_MESH_COARSENING_INLINE Placed_level Level_hierarchy::place(std::size_t level, const Placement_model& placement,
                                                                        bool with_repair,
                                                                        const Output_coordinates& output_coordinates) const
{
  Placed_level placed{labels(level), history_.triangles(level), {}, {}};
  const Clustered_faces surface(pieces_of(state_), placed.labels, level);
  placed.positions = place_vertices(surface, Border_arcs(surface, state_.places_on_borders), placement, with_repair,
                                    output_coordinates, placed.triangles, placed.counts, state_.cancellation());
  return placed;
}

CGAL_SURFACE_MESH_COARSENING_INLINE double Level_hierarchy::estimate(const Placed_level& placed) const
{
  return Distance_estimate(placed.labels, placed.positions, placed.triangles, state_.cancellation()).distance();
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_LEVEL_HIERARCHY_IMPL_H
