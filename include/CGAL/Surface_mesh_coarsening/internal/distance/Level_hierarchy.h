// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_LEVEL_HIERARCHY_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_LEVEL_HIERARCHY_H

#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/Merge_history.h>

#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The dual of a level with its positions.
struct Placed_level
{
  Cluster_labels labels;
  std::vector<Triangle> triangles;
  std::vector<Vector> positions;
};

// The levels of detail of a clustering, which must not change while they are in use.
class Level_hierarchy
{
public:
  explicit Level_hierarchy(const Clustering_state& state);

  const Merge_history& history() const { return history_; }

  // Returns the clusters of the faces of the caller's mesh, which has `number` faces, on a level.
  std::vector<Index> clusters_of_faces(std::size_t level, std::size_t number) const;

  Placed_level place(std::size_t level, const Placement_model& placement, const Output_coordinates& output_coordinates) const;

  // Estimates the distance between a placed level and the mesh, in coordinates of the arrays.
  double estimate(const Placed_level& placed) const;

private:
  const Clustering_state& state_;
  Merge_history history_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#ifndef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#include <CGAL/Surface_mesh_coarsening/internal/distance/Level_hierarchy_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_LEVEL_HIERARCHY_H
