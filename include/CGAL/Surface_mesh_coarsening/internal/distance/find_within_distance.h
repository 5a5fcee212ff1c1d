// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_FIND_WITHIN_DISTANCE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_FIND_WITHIN_DISTANCE_H

#include <CGAL/Surface_mesh_coarsening/Distance_report.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The coarsest dual found within a distance.
struct Dual_within_distance
{
  std::vector<Triangle> triangles;
  std::vector<Vector> positions;
  std::vector<Index> clusters_of_base_faces;
};

// Searches the levels of a fine clustering for the coarsest dual within a distance; throws if there is none. `quick` is a
// placement that takes less time and is nearly as close. `vertices` is the maximum number of clusters.
Dual_within_distance find_within_distance(Clustering_state& state, const Placement_model& placement,
                                          const std::optional<Placement_model>& quick,
                                          const Output_coordinates& output_coordinates, double distance,
                                          const Minimization_end& end, std::size_t vertices, Distance_report& report);

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#ifndef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#include <CGAL/Surface_mesh_coarsening/internal/distance/find_within_distance_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_FIND_WITHIN_DISTANCE_H
