// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_WEIGHTED_ENERGY_MODEL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_WEIGHTED_ENERGY_MODEL_H

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Exact_maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_minimization.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_model.h>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The optional member of the concept `ClusterWeight`.
template <class Weight, class = void>
constexpr bool depends_on_densities = true;
template <class Weight>
constexpr bool depends_on_densities<Weight, std::void_t<decltype(Weight::depends_on_densities)> > = Weight::depends_on_densities;

template <class Weight>
class Weighted_energy_model : public Energy_model
{
public:
  explicit Weighted_energy_model(const Weight& weight) : weight_(weight) {}

  std::unique_ptr<Minimization> minimization(const Featured_input& input, Cluster_labels& labels, std::size_t clusters,
                                             bool checks_boundary_counts, const Cancellation_point& cancellation,
                                             Execution execution) const override
  {
    return std::make_unique<Energy_minimization<Weight> >(input, labels, clusters, weight_, checks_boundary_counts, cancellation,
                                                          execution);
  }

  double energy(const Clustering_input& input, const Cluster_labels& labels, std::size_t clusters) const override
  {
    std::vector<Cluster_sums<Weight> > sums(clusters);
    Cluster_energy<Weight>(weight_).add_up(input, labels, sums, Cancellation_point());
    double energy = 0;
    for (const Cluster_sums<Weight>& x : sums)
      energy += x.energy;
    return energy;
  }

  bool depends_on_densities() const override { return internal::depends_on_densities<Weight>; }

private:
  Weight weight_;
};

#ifdef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
extern template class Weighted_energy_model<Uniform_weight>;
extern template class Weighted_energy_model<Weighted_area_weight>;
extern template class Weighted_energy_model<Maximum_density_weight>;
extern template class Weighted_energy_model<Exact_maximum_density_weight>;
extern template class Weighted_energy_model<Density_variance_weight>;
#endif

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_WEIGHTED_ENERGY_MODEL_H
