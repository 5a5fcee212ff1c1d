// SPDX-License-Identifier: GPL-3.0-or-later
//
// The code that does not depend on the types of meshes and maps, compiled once. Without this library, users include the same
// headers, and all their functions are inline.

#include <CGAL/Surface_mesh_coarsening/internal/distance/Level_hierarchy_impl.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/find_within_distance_impl.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/find_features_impl.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/complete_mesh_impl.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Weighted_energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages_impl.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/fit_vertices_impl.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/quadric_position_impl.h>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

template class Weighted_energy_model<Uniform_weight>;
template class Weighted_energy_model<Weighted_area_weight>;
template class Weighted_energy_model<Maximum_density_weight>;
template class Weighted_energy_model<Exact_maximum_density_weight>;
template class Weighted_energy_model<Density_variance_weight>;

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL
