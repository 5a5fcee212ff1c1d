// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_TYPED_ENERGY_MODEL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_TYPED_ENERGY_MODEL_H

#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Normal_deviation_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Quadric_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Weighted_inertia_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Exact_maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_minimization.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_model.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The energies of the clusters, by a model of `ClusterEnergy`.
template <class Energy>
std::vector<double> cluster_energies(const Energy& energy, const Clustering_input& input, const Cluster_labels& labels,
                                     std::size_t clusters)
{
  std::vector<Cluster_sums<Energy> > sums(clusters);
  Energy_evaluation<Energy>(energy, input, clusters).add_up(input, labels, sums, Cancellation_point());
  std::vector<double> energies;
  for (const Cluster_sums<Energy>& x : sums)
    energies.push_back(x.energy);
  return energies;
}

template <class Energy>
class Typed_energy_model : public Energy_model
{
public:
  explicit Typed_energy_model(const Energy& energy) : energy_(energy) {}

  std::unique_ptr<Minimization> minimization(const Featured_input& input, Cluster_labels& labels, std::size_t clusters,
                                             bool checks_boundary_counts, const Cancellation_point& cancellation,
                                             Execution execution) const override
  {
    return std::make_unique<Energy_minimization<Energy> >(input, labels, clusters, energy_, checks_boundary_counts, cancellation,
                                                          execution);
  }

  double energy(const Clustering_input& input, const Cluster_labels& labels, std::size_t clusters) const override
  {
    double sum = 0;
    for (const double x : cluster_energies(energy_, input, labels, clusters))
      sum += x;
    return sum;
  }

  bool depends_on_densities() const override { return internal::depends_on_densities<Energy>; }

private:
  Energy energy_;
};

#ifdef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
extern template class Typed_energy_model<Weighted_inertia_energy<Uniform_weight> >;
extern template class Typed_energy_model<Weighted_inertia_energy<Weighted_area_weight> >;
extern template class Typed_energy_model<Weighted_inertia_energy<Maximum_density_weight> >;
extern template class Typed_energy_model<Weighted_inertia_energy<Exact_maximum_density_weight> >;
extern template class Typed_energy_model<Weighted_inertia_energy<Density_variance_weight> >;
extern template class Typed_energy_model<Quadric_energy>;
extern template class Typed_energy_model<Normal_deviation_energy>;
#endif

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_TYPED_ENERGY_MODEL_H
