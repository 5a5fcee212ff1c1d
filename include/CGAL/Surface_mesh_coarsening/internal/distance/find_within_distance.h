// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_FIND_WITHIN_DISTANCE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_FIND_WITHIN_DISTANCE_H

#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>

#include <cstddef>
#include <limits>

namespace CGAL::Surface_mesh_coarsening::internal {

// What a search looks for. If `max_vertices` is given and is too small for the distance, the result has this number of vertices.
struct Distance_goal
{
  static constexpr std::size_t any_number = (std::numeric_limits<std::size_t>::max)();
  double distance; // in the unit of length of the mesh
  Minimization_end end;
  std::size_t max_vertices = any_number;
};

// Searches for the fewest vertices within a distance. The clusters of the result remain in the state. Throws if even as many
// vertices as the mesh has are too far.
Placed_dual find_within_distance(Clustering_state& state, const Placement_model& placement,
                                 const Output_coordinates& output_coordinates, const Distance_goal& goal,
                                 Distance_report& report);

} // namespace CGAL::Surface_mesh_coarsening::internal

#ifndef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#include <CGAL/Surface_mesh_coarsening/internal/distance/find_within_distance_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_FIND_WITHIN_DISTANCE_H
