// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_LEVEL_HIERARCHY_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_LEVEL_HIERARCHY_H

#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>
#include <CGAL/Surface_mesh_coarsening/internal/refinement/Merge_history.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The dual of a level with its positions.
struct Placed_level
{
  Cluster_labels labels;
  std::vector<Triangle> triangles;
  std::vector<Vector> positions;
  Repair_counts counts;
};

// The levels of detail of a clustering, which must not change while they are in use.
class Level_hierarchy
{
public:
  explicit Level_hierarchy(const Clustering_state& state);

  std::size_t finest() const { return history_.finest(); }
  std::size_t coarsest() const { return history_.coarsest(); }

  // Returns the cluster of level `cluster` into which cluster `cluster` of the next finer level is merged.
  Index parent(Index cluster) const { return history_.parent(cluster); }

  // Returns, for each cluster of level `fine`, the cluster of level `coarse` that contains it.
  std::vector<Index> ancestors(std::size_t fine, std::size_t coarse) const;

  std::vector<Triangle> triangles(std::size_t level) const;

  // Returns the clusters of the `number` faces of the caller's mesh on a level.
  std::vector<Index> clusters_of_faces(std::size_t level, std::size_t number) const;

  Placed_level place(std::size_t level, const Placement_model& placement, bool with_repair,
                     const Output_coordinates& output_coordinates) const;

  // Estimates the distance between a placed level and the mesh, in coordinates of the arrays.
  double estimate(const Placed_level& placed) const;

private:
  Cluster_labels labels(std::size_t level) const;

  const Clustering_state& state_;
  Merge_history history_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#ifndef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#include <CGAL/Surface_mesh_coarsening/internal/distance/Level_hierarchy_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_LEVEL_HIERARCHY_H
