// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_ACCEPTED_PARAMETERS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_ACCEPTED_PARAMETERS_H

#include <CGAL/Surface_mesh_coarsening/parameters.h>

#include <type_traits>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The tags of the named parameters that a function reads from a pack.
template <class... Tags>
struct Parameter_list
{
  template <class Tag>
  static constexpr bool has = (std::is_same<Tag, Tags>::value || ...);
};

template <class... Lists>
struct Parameter_lists
{
  template <class Tag>
  static constexpr bool has = (Lists::template has<Tag> || ...);
};

template <class Tag>
constexpr bool is_of_package = Parameter_list<CGAL::internal_np::vertex_point_t, CGAL::internal_np::geom_traits_t,
                                              CGAL::internal_np::face_index_t, CGAL::internal_np::visitor_t,
                                              CGAL::internal_np::number_of_iterations_t,
                                              CGAL::internal_np::edge_is_constrained_t,
                                              CGAL::internal_np::vertex_is_constrained_t,
                                              CGAL::internal_np::face_patch_t>::template has<Tag>;
#define CGAL_add_named_parameter(X, Y, Z) \
  template <>                             \
  inline constexpr bool is_of_package<internal_np::X> = true;
#include <CGAL/Surface_mesh_coarsening/internal/parameters_interface.h>
#undef CGAL_add_named_parameter

// Compilers print the tag with the sentence. Parameters that no function of the package has are accepted, because the same pack
// may be passed to functions of CGAL.
template <class Tag, class List>
constexpr bool check_parameter()
{
  static_assert(!is_of_package<Tag> || List::template has<Tag>,
                "this named parameter cannot be used in this pack of this function; the reference lists those that can");
  return true;
}

// Walks a pack from its last parameter to its first.
template <class List, class NamedParameters>
struct Checked_pack;
template <class List>
struct Checked_pack<List, CGAL::internal_np::No_property>
{
  static constexpr bool value = true;
};
template <class List, class Rest>
struct Checked_pack<List, Surface_mesh_coarsening::internal_np::Chain<Rest> > : Checked_pack<List, Rest>
{};
template <class List, class T, class Tag, class Rest>
struct Checked_pack<List, Named_function_parameters<T, Tag, Rest> >
{
  static constexpr bool value = check_parameter<Tag, List>() && Checked_pack<List, Rest>::value;
};

// Fails to compile if the pack holds a parameter that is in none of the lists.
template <class NamedParameters, class... Lists>
constexpr void accept_parameters()
{
  static_assert(Checked_pack<Parameter_lists<Lists...>, NamedParameters>::value, "");
}

struct Geometry_parameters
  : Parameter_list<CGAL::internal_np::vertex_point_t, CGAL::internal_np::geom_traits_t>
{};

struct Order_parameters
  : Parameter_list<CGAL::internal_np::face_index_t>
{};

struct Density_parameters
  : Parameter_list<internal_np::maximum_density_t, internal_np::border_densities_t>
{};

// The maps of features of a mesh, which are read or written.
struct Feature_map_parameters
  : Parameter_list<CGAL::internal_np::edge_is_constrained_t, CGAL::internal_np::vertex_is_constrained_t,
                   CGAL::internal_np::face_patch_t>
{};

// The parameters of all functions that cluster a mesh.
struct Clustering_parameters
  : Parameter_lists<Geometry_parameters, Order_parameters, Density_parameters, Feature_map_parameters,
                    Parameter_list<internal_np::face_density_t, internal_np::cluster_weight_t, internal_np::cluster_energy_t,
                                   internal_np::minimum_component_area_t, internal_np::subdivide_input_t,
                                   internal_np::repair_output_t, internal_np::error_feedback_t, internal_np::local_repairs_t,
                                   internal_np::feature_angle_t, internal_np::merge_by_area_t,
                                   internal_np::boundary_count_check_t, internal_np::place_on_borders_t,
                                   CGAL::internal_np::visitor_t> >
{};

// The parameters of all functions that compute a coarser mesh.
struct Coarsening_parameters
  : Parameter_lists<Clustering_parameters,
                    Parameter_list<CGAL::internal_np::number_of_iterations_t, internal_np::convergence_tolerance_t,
                                   internal_np::vertex_placement_t, internal_np::face_cluster_t,
                                   internal_np::vertex_to_cluster_t> >
{};

struct Output_parameters
  : Parameter_lists<Geometry_parameters, Feature_map_parameters, Parameter_list<internal_np::vertex_source_t> >
{};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_ACCEPTED_PARAMETERS_H
