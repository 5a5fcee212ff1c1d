// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_PAPER_H
#define CGAL_SURFACE_MESH_COARSENING_PAPER_H

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/parameters.h>

#include <cstddef>
#include <type_traits>

namespace CGAL::Surface_mesh_coarsening::parameters {

/// \cond SKIP_IN_MANUAL
// The maximum density that table 1 of the paper lists for most models.
template <class ClusterWeight>
constexpr double maximum_density_of_paper = std::is_same<ClusterWeight, Density_variance_weight>::value ? 3 : 50;
/// \endcond

/// begins a chain with the parameters of `paper()` that the constructor of `Mwcvd_clustering` accepts. To complete the method,
/// call `minimize(Coarsening_defaults::number_of_iterations, 0)` and `extract_dual_mesh(output, Centroid_placement())`.
template <class ClusterWeight>
auto paper_clustering(const ClusterWeight& weight, double maximum_density = maximum_density_of_paper<ClusterWeight>)
{
  //! [paper]
  return cluster_weight(weight)
    .maximum_density(maximum_density)
    .paper_rules(true) // sections 5.2, 6, 7 and 8.3
    .error_feedback(std::size_t(0))
    .repair_output(false);
  //! [paper]
}

/// begins a chain with the parameters that run `coarsen_mesh()` as in the paper, as closely as the guarantee of this package
/// permits: its densities, its reduction to a fixed number by area, its check of boundary-edge counts in rounds over the whole
/// mesh, its end when a round changes nothing, vertices at centroids, also on borders, and no repair. Page \ref smc_paper lists
/// what the package adds: discs during the growth, splits and merges, current sums, and the check of each move.
///
/// \param weight a weight of the paper: `Weighted_area_weight`, `Maximum_density_weight` or `Density_variance_weight`
/// \param maximum_density the paper's \f$ \rho_{new} \f$: 3 for the variance and 50 for the other weights, except for the area
/// on the Horse and the maximum on the Horse and the Dragon, where it is 5
template <class ClusterWeight>
auto paper(const ClusterWeight& weight, double maximum_density = maximum_density_of_paper<ClusterWeight>)
{
  return paper_clustering(weight, maximum_density).vertex_placement(Centroid_placement()).convergence_tolerance(0.);
}

} // namespace CGAL::Surface_mesh_coarsening::parameters

#endif // CGAL_SURFACE_MESH_COARSENING_PAPER_H
