// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_CHOICE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_CHOICE_H

#include <CGAL/Surface_mesh_coarsening/defaults.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Patch.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Typed_energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/Face_graph_filler.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Placement_model.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The energies of all clusters, for any weight.
typedef std::function<std::vector<double>(const Clustering_input&, const Cluster_labels&, std::size_t)> Cluster_energies;

// The choices of the caller. They are equal on all ranks, except the visitor and the scratch directory.
struct Distributed_choice
{
  static constexpr std::size_t default_faces_per_block = std::size_t(1) << 18, max_faces_per_task = std::size_t(1) << 21;
  static constexpr std::size_t clusters_per_task = 1000;

  std::size_t number_of_vertices = 0;
  std::optional<std::size_t> faces_per_block; // for blocks and tasks
  Minimization_end end;
  bool has_densities = false; // whether the caller passes densities
  double maximum_density = 0;
  Run_context context;
  std::shared_ptr<const Energy_model> energy;
  Cluster_energies energies;
  Placement_model placement;
  Face_names face_names;
  std::function<Output_coordinates(const Local_frame&)> output_coordinates;
  bool repairs_output = false, wants_clusters = false, wants_output_everywhere = false;
  std::string scratch_directory; // if empty, all records are kept in memory
  std::uint64_t scratch_memory = 0; // the number of bytes of records that are kept in memory in spite of a scratch directory

  // Whether rank 0 places vertices on the surface of cells.
  bool places_on_cells() const { return placement.from_start || repairs_output; }
};

// The parameters of distributed meshes that do not depend on the form of the pieces.
struct Distributed_parameters
  : Parameter_list<internal_np::face_density_t, internal_np::maximum_density_t, internal_np::cluster_weight_t,
                   internal_np::cluster_energy_t, internal_np::convergence_tolerance_t, internal_np::vertex_placement_t,
                   internal_np::repair_output_t, internal_np::face_cluster_t, internal_np::output_on_all_ranks_t,
                   internal_np::faces_per_block_t, internal_np::scratch_directory_t, internal_np::scratch_memory_t,
                   CGAL::internal_np::number_of_iterations_t, CGAL::internal_np::visitor_t>
{};

template <class NamedParameters>
Minimization_end distributed_minimization_end(const NamedParameters& np)
{
  const double tolerance =
    choose_parameter(get_parameter(np, internal_np::convergence_tolerance_p), Coarsening_defaults::convergence_tolerance);
  if (!(tolerance >= 0))
    throw Invalid_input("the convergence tolerance is " + std::to_string(tolerance));
  return {std::size_t(choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations),
                                       Coarsening_defaults::number_of_iterations)),
          tolerance};
}

// Reads the placement, and whether it is repaired.
template <class Placement, class NamedParameters>
void read_placement(const Placement& placement, const NamedParameters& np, Distributed_choice& choice)
{
  choice.placement = placement_model(placement);
  if (!choice.placement.local && !choice.placement.from_start)
    throw Invalid_input("a placement of all vertices together, other than Fitted_placement, is not available for distributed "
                        "meshes");
  choice.repairs_output =
    choose_parameter(get_parameter(np, internal_np::repair_output_p), bool(choice.placement.from_start));
  if (choice.repairs_output && choice.placement.is_at_input_vertices)
    throw Invalid_input("the parameter repair_output is not available for distributed meshes with a placement at input "
                        "vertices");
}

// The choice refers to the placement and the parameters.
template <class ConcurrencyTag, class OutputFaceGraph, class Placement, class NamedParametersIn, class NamedParametersOut>
Distributed_choice distributed_choice(std::size_t number_of_vertices, const Placement& placement, const NamedParametersIn& np_in,
                                      const NamedParametersOut&)
{
  Distributed_choice choice;
  choice.number_of_vertices = number_of_vertices;
  if constexpr (has_parameter<internal_np::faces_per_block_t, NamedParametersIn>) {
    choice.faces_per_block = std::size_t(get_parameter(np_in, internal_np::faces_per_block_p));
    if (*choice.faces_per_block == 0)
      throw Invalid_input("the number of faces per block is 0");
  }
  choice.end = distributed_minimization_end(np_in);
  choice.has_densities = has_parameter<internal_np::face_density_t, NamedParametersIn>;
  choice.maximum_density = density_choice(np_in).maximum;
  choice.context = Run_context(ConcurrencyTag(), get_parameter(np_in, CGAL::internal_np::visitor));
  const auto energy = chosen_energy<Energy_choice<NamedParametersIn> >(np_in);
  choice.energy = energy_model(energy);
  choice.energies = [energy](const Clustering_input& input, const Cluster_labels& labels, std::size_t clusters) {
    return cluster_energies(energy, input, labels, clusters);
  };
  read_placement(placement, np_in, choice);
  choice.output_coordinates = [](const Local_frame& frame) {
    return output_coordinates<typename GetGeomTraits<OutputFaceGraph, NamedParametersOut>::type>(frame);
  };
  choice.wants_output_everywhere = choose_parameter(get_parameter(np_in, internal_np::output_on_all_ranks_p), false);
  choice.wants_clusters = has_parameter<internal_np::face_cluster_t, NamedParametersIn>;
  if constexpr (has_parameter<internal_np::face_name_t, NamedParametersIn>)
    choice.face_names = [&np_in](std::uint64_t face) { return get(get_parameter(np_in, internal_np::face_name), face); };
  choice.scratch_directory = choose_parameter(get_parameter(np_in, internal_np::scratch_directory_p), std::string());
  choice.scratch_memory = std::uint64_t(choose_parameter(get_parameter(np_in, internal_np::scratch_memory_p), std::uint64_t(0)));
  return choice;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_CHOICE_H
