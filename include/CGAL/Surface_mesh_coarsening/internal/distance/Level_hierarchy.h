// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_LEVEL_HIERARCHY_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_LEVEL_HIERARCHY_H

#include <CGAL/Surface_mesh_coarsening/internal/distance/Distance_estimate.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>
#include <CGAL/Surface_mesh_coarsening/internal/refinement/Merge_history.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The dual of a level in place.
struct Placed_level
{
  Cluster_labels labels;
  std::vector<Triangle> triangles;
  std::vector<Vector> positions;
};

// The levels of detail of a clustering, which is not changed as long as they are used.
class Level_hierarchy
{
public:
  explicit Level_hierarchy(const Clustering_state& state)
    : state_(state), history_(input_without_features(state), internal::labels(state), Index(state.number_of_clusters()),
                              state.cancellation())
  {}

  const Merge_history& history() const { return history_; }
  std::size_t finest() const { return history_.finest(); }
  std::size_t coarsest() const { return history_.coarsest(); }

  // The clusters of the `number` faces of the caller's mesh on a level; `level` where a component was left out.
  std::vector<Index> clusters_of_faces(std::size_t level, std::size_t number) const
  {
    const std::vector<Index> ancestors = history_.ancestors(finest(), level);
    std::vector<Index> clusters(number);
    for (std::size_t f = 0; f < number; ++f) {
      const std::size_t x = cluster_of_face(state_, Index(f));
      clusters[f] = x == finest() ? Index(level) : ancestors[history_.number(Index(x))];
    }
    return clusters;
  }

  Placed_level place(std::size_t level, const Placement_model& placement, bool with_repair,
                     const Output_coordinates& output_coordinates) const
  {
    Placed_level placed{labels(level), history_.triangles(level), {}};
    Repair_counts counts;
    placed.positions = place_vertices(Clustered_surface(state_.working_input(), placed.labels, level), placement, with_repair,
                                      output_coordinates, placed.triangles, counts, state_.cancellation());
    return placed;
  }

  // About how far a level in place is from the mesh, in the arrays' coordinates, or `least` if it is nearer than that.
  double estimate(const Placed_level& placed, double least = 0) const
  {
    return Distance_estimate(placed.labels, placed.positions, placed.triangles, state_.cancellation()).distance(least);
  }

private:
  static const Clustering_input& input_without_features(const Clustering_state& state)
  {
    if (state.working_input().cells)
      throw Invalid_input("clusters cannot be edited, nor merged to levels, where features are kept");
    return state.working_input();
  }

  Cluster_labels labels(std::size_t level) const
  {
    const Clustering_input& input = state_.working_input();
    const Cluster_labels& finest_labels = internal::labels(state_);
    const std::vector<Index> ancestors = history_.ancestors(finest(), level);
    Cluster_labels result(input.mesh);
    for (std::size_t f = 0; f < input.mesh.number_of_faces(); ++f)
      result.set(Index(f), ancestors[history_.number(finest_labels[Index(f)])]);
    result.recount();
    return result;
  }

  const Clustering_state& state_;
  Merge_history history_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_LEVEL_HIERARCHY_H
