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
#include <CGAL/Surface_mesh_coarsening/defaults.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_minimization.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_model.h>

#include <boost/type_traits/is_detected.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The sums of the clusters, by a model of `ClusterEnergy`.
template <class Energy>
std::vector<Cluster_sums<Energy> > cluster_sums(const Energy& energy, const Clustering_input& input,
                                                const Cluster_labels& labels, std::size_t clusters)
{
  std::vector<Cluster_sums<Energy> > sums;
  Energy_evaluation<Energy>(energy, input, clusters).add_up(input, labels, sums, Run_context());
  return sums;
}

// The weight of a cluster; 1 if the energy has no weight.
template <class Energy>
double weight_of(const Cluster_sums<Energy>&) { return 1; }
template <class Weight>
double weight_of(const Cluster_sums<Weighted_inertia_energy<Weight> >& x) { return x.weight; }

template <class Energy>
class Typed_energy_model : public Energy_model
{
public:
  explicit Typed_energy_model(const Energy& energy) : energy_(energy) {}

  std::unique_ptr<Minimization> minimization(const Featured_input& input, Cluster_labels& labels, std::size_t clusters,
                                             bool checks_boundary_counts, const Run_context& context) const override
  {
    return std::make_unique<Energy_minimization<Energy> >(
      input, labels, Energy_evaluation<Energy>(energy_, input.items, clusters), checks_boundary_counts, context);
  }

  std::vector<Cluster_report> cluster_reports(const Clustering_input& input, const Cluster_labels& labels,
                                              std::size_t clusters) const override
  {
    std::vector<Cluster_report> reports(clusters);
    const std::vector<Cluster_sums<Energy> > sums = cluster_sums(energy_, input, labels, clusters);
    for (std::size_t x = 0; x < clusters; ++x) {
      reports[x].weight = weight_of(sums[x]);
      reports[x].energy = sums[x].energy;
    }
    return reports;
  }

  bool depends_on_densities() const override { return internal::depends_on_densities<Energy>; }

  bool is_default() const override { return std::is_same<Energy, Weighted_inertia_energy<Weighted_area_weight> >::value; }

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

// Whether a type holds an energy with its type erased, as `Any_cluster_energy` does.
template <class Choice>
constexpr bool holds_energy_model = std::is_convertible<const Choice&, std::shared_ptr<const Energy_model> >::value;

// Whether a type is, or holds, a model of `ClusterEnergy`; otherwise it is a model of `ClusterWeight`.
template <class Choice>
constexpr bool is_energy = holds_energy_model<Choice> || boost::is_detected_v<Energy_outcome, Choice>;

// The energy or the weight in a pack of named parameters.
template <class NamedParameters>
using Energy_choice = Parameter_type<internal_np::cluster_energy_t, NamedParameters,
                                     Parameter_type<internal_np::cluster_weight_t, NamedParameters, Weighted_area_weight> >;

// Returns the energy; `Choice` is the type of the energy or of a weight.
template <class Choice, class NamedParameters>
auto chosen_energy(const NamedParameters& np)
{
  constexpr bool has_energy = has_parameter<internal_np::cluster_energy_t, NamedParameters>;
  constexpr bool has_weight = has_parameter<internal_np::cluster_weight_t, NamedParameters>;
  static_assert(!has_energy || !has_weight, "cluster_energy and cluster_weight cannot both be given");
  static_assert(is_energy<Choice> ? !has_weight : !has_energy,
                "the class has an energy where a cluster_weight is given, or a weight where a cluster_energy is given");
  if constexpr (is_energy<Choice>)
    return choose_parameter<Choice>(get_parameter(np, internal_np::cluster_energy_p));
  else
    return Weighted_inertia_energy<Choice>(choose_parameter<Choice>(get_parameter(np, internal_np::cluster_weight_p)));
}

inline Minimization_end minimization_end(std::size_t max_rounds, double tolerance)
{
  if (!(tolerance >= 0))
    throw Invalid_input("the convergence tolerance is " + std::to_string(tolerance));
  return {max_rounds, tolerance};
}

template <class NamedParameters>
Minimization_end chosen_minimization_end(const NamedParameters& np)
{
  return minimization_end(
    std::size_t(choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations),
                                 Coarsening_defaults::number_of_iterations)),
    choose_parameter(get_parameter(np, internal_np::convergence_tolerance_p), Coarsening_defaults::convergence_tolerance));
}

template <class Energy>
std::shared_ptr<const Energy_model> energy_model(const Energy& energy)
{
  if constexpr (holds_energy_model<Energy>)
    return energy;
  else
    return std::make_shared<Typed_energy_model<Energy> >(energy);
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_TYPED_ENERGY_MODEL_H
