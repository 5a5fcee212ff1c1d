// SPDX-License-Identifier: GPL-3.0-or-later
//
// The code that does not depend on the types of meshes and maps, compiled once. Without this library, users include the same
// headers, and all their functions are inline.

// First, because GCC does not inline `sqrt()` if gmpxx.h, which CGAL includes, declares functions of this name before.
#include <cmath>

#include <CGAL/Surface_mesh_coarsening/internal/distance/Level_hierarchy_impl.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/find_within_distance_impl.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/find_features_impl.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input_impl.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Typed_energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages_impl.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/fit_vertices_impl.h>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

template class Typed_energy_model<Weighted_inertia_energy<Uniform_weight> >;
template class Typed_energy_model<Weighted_inertia_energy<Weighted_area_weight> >;
template class Typed_energy_model<Weighted_inertia_energy<Maximum_density_weight> >;
template class Typed_energy_model<Weighted_inertia_energy<Exact_maximum_density_weight> >;
template class Typed_energy_model<Weighted_inertia_energy<Density_variance_weight> >;
template class Typed_energy_model<Quadric_energy>;
template class Typed_energy_model<Normal_deviation_energy>;

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL
