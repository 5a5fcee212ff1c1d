// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_FIND_WITHIN_DISTANCE_IMPL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_FIND_WITHIN_DISTANCE_IMPL_H

#include <CGAL/Surface_mesh_coarsening/internal/base/inline.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/Distance_search.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/find_within_distance.h>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

CGAL_SURFACE_MESH_COARSENING_INLINE Dual_within_distance
find_within_distance(Clustering_state& state, const Placement_model& placement, const std::optional<Placement_model>& quick,
                     const Output_coordinates& output_coordinates, double distance, const Minimization_end& end,
                     std::size_t vertices, Distance_report& report)
{
  Distance_search search(state, placement, quick, output_coordinates, distance, end, vertices, report);
  search.run();
  return {search.triangles(), search.positions(), search.clusters_of_base_faces()};
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_FIND_WITHIN_DISTANCE_IMPL_H
