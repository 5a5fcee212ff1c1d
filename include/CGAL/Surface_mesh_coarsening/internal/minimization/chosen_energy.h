// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_CHOSEN_ENERGY_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_CHOSEN_ENERGY_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Typed_energy_model.h>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Whether a type is a model of `ClusterEnergy`; otherwise it is a model of `ClusterWeight`.
template <class Choice, class = void>
constexpr bool is_energy = false;
template <class Choice>
constexpr bool is_energy<Choice, std::void_t<Energy_outcome<Choice> > > = true;

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

template <class Energy>
std::shared_ptr<const Energy_model> energy_model(const Energy& energy)
{
  return std::make_shared<Typed_energy_model<Energy> >(energy);
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_CHOSEN_ENERGY_H
