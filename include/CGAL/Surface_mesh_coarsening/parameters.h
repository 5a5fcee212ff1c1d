// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_PARAMETERS_H
#define CGAL_SURFACE_MESH_COARSENING_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

#include <functional>

/// \file parameters.h
/// The named parameters of the package. A chain begins in `CGAL::Surface_mesh_coarsening::parameters` and continues
/// with parameters of this package and of CGAL in any order. All functions of the package also accept chains that contain only
/// parameters of CGAL.

namespace CGAL {
namespace Surface_mesh_coarsening {
/// \cond SKIP_IN_MANUAL
namespace internal_np {

#define CGAL_add_named_parameter(X, Y, Z) enum X { Y };
#include <CGAL/Surface_mesh_coarsening/internal/parameters_interface.h>
#undef CGAL_add_named_parameter

// Marks the tail of a pack. CGAL defines the `.name()` members of its class of named parameters in a header that a
// package outside the CGAL source tree cannot extend. The partial specialization for this tail below adds the members of this
// package.
template <class Rest>
struct Chain
  : Rest
{
  explicit Chain(const Rest& rest) : Rest(rest) {}
};

} // namespace internal_np
} // namespace Surface_mesh_coarsening

template <typename T, typename Tag, typename Rest>
struct Named_function_parameters<T, Tag, Surface_mesh_coarsening::internal_np::Chain<Rest> >
  : internal_np::Named_params_impl<T, Tag, Surface_mesh_coarsening::internal_np::Chain<Rest> >
{
  typedef internal_np::Named_params_impl<T, Tag, Surface_mesh_coarsening::internal_np::Chain<Rest> > base;
  typedef Named_function_parameters<T, Tag, Surface_mesh_coarsening::internal_np::Chain<Rest> > self;
  // CGAL 6 recognizes a pack by this name.
  typedef int CGAL_Named_function_parameters_class;

  Named_function_parameters(const T& value, const Rest& rest)
    : base(value, Surface_mesh_coarsening::internal_np::Chain<Rest>(rest))
  {}

private:
  template <typename K, typename X>
  using Longer = Named_function_parameters<K, X, Surface_mesh_coarsening::internal_np::Chain<self> >;

public:
#define CGAL_SURFACE_MESH_COARSENING_MEMBER(X, Z, Parameter, Kept, kept) \
  template <typename K>                                                 \
  Longer<Kept, X> Z(Parameter k) const                                  \
  {                                                                     \
    return Longer<Kept, X>(kept, *this);                                \
  }
#define CGAL_add_named_parameter(X, Y, Z) CGAL_SURFACE_MESH_COARSENING_MEMBER(internal_np::X, Z, const K&, K, k)
#define CGAL_add_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_extra_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_cref_only(X, Y, Z) \
  CGAL_SURFACE_MESH_COARSENING_MEMBER(internal_np::X, Z, const K&, std::reference_wrapper<const K>, std::cref(k))
#define CGAL_add_named_parameter_with_compatibility_ref_only(X, Y, Z) \
  CGAL_SURFACE_MESH_COARSENING_MEMBER(internal_np::X, Z, K&, std::reference_wrapper<K>, std::ref(k))
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
#undef CGAL_add_named_parameter_with_compatibility
#undef CGAL_add_extra_named_parameter_with_compatibility
#undef CGAL_add_named_parameter_with_compatibility_cref_only
#undef CGAL_add_named_parameter_with_compatibility_ref_only

#define CGAL_add_named_parameter(X, Y, Z) \
  CGAL_SURFACE_MESH_COARSENING_MEMBER(Surface_mesh_coarsening::internal_np::X, Z, const K&, K, k)
#include <CGAL/Surface_mesh_coarsening/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
#undef CGAL_SURFACE_MESH_COARSENING_MEMBER
};
/// \endcond

namespace Surface_mesh_coarsening {

/// The functions that begin a chain of named parameters.
namespace parameters {

using CGAL::parameters::Default_named_parameters;
using CGAL::parameters::default_values;

/// converts a pack of named parameters of CGAL, so that parameters of this package can follow:
/// `parameters::adopt(np).neighborhood_level(5)`.
template <class NamedParameters>
auto adopt(const NamedParameters& np)
{
  typedef internal_np::Chain<NamedParameters> Chain;
  return Named_function_parameters<bool, CGAL::internal_np::all_default_t, Chain>(true, np);
}

/// \cond SKIP_IN_MANUAL
#define CGAL_add_named_parameter(X, Y, Z) \
  template <typename K>                   \
  auto Z(const K& k)                      \
  {                                       \
    return adopt(default_values()).Z(k);  \
  }
#define CGAL_add_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_extra_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_cref_only(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_ref_only(X, Y, Z) \
  template <typename K>                                               \
  auto Z(K& k)                                                        \
  {                                                                   \
    return adopt(default_values()).Z(k);                              \
  }
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#include <CGAL/Surface_mesh_coarsening/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
#undef CGAL_add_named_parameter_with_compatibility
#undef CGAL_add_extra_named_parameter_with_compatibility
#undef CGAL_add_named_parameter_with_compatibility_cref_only
#undef CGAL_add_named_parameter_with_compatibility_ref_only
/// \endcond

} // namespace parameters
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_PARAMETERS_H
