// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_RANK_CONTEXT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_RANK_CONTEXT_H

#include <CGAL/Surface_mesh_coarsening/defaults.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Scratch_file.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Typed_energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/Face_graph_filler.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Placement_model.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/serialization/string.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Returns the name of a face for messages, given its number in the sequence of all pieces.
typedef std::function<std::string(std::uint64_t)> Face_names;

// The choices of the caller, with the threads and the visitor of this rank. They are equal on all ranks, except the visitor and
// the scratch directory.
struct Distributed_choice : Run_context
{
  static constexpr std::size_t default_faces_per_block = std::size_t(1) << 18;

  std::size_t number_of_vertices = 0;
  std::optional<std::size_t> faces_per_block; // for blocks and tasks
  Minimization_end end;
  bool has_densities = false; // whether the caller passes densities
  double maximum_density = 0;
  std::shared_ptr<const Energy_model> energy;
  Placement_model placement;
  Face_names face_names; // empty: the names consist of the piece and the number in the piece
  std::function<Output_coordinates(const Local_frame&)> output_coordinates;
  bool repairs_output = false, wants_clusters = false, wants_output_everywhere = false;
  std::string scratch_directory; // if empty, all records are kept in memory
  std::uint64_t scratch_memory = 0; // the number of bytes of records that are kept in memory in spite of a scratch directory

  // Whether rank 0 fits or repairs vertices on the surface of cells.
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

// The choice refers to the placement and the parameters.
template <class ConcurrencyTag, class OutputTraits, class Placement, class NamedParameters>
Distributed_choice distributed_choice(std::size_t number_of_vertices, const Placement& placement, const NamedParameters& np)
{
  static_assert(is_local_placement<Placement> || has_start<Placement>,
                "a placement of all vertices together, other than Fitted_placement, is not available for distributed meshes");
  Distributed_choice choice;
  static_cast<Run_context&>(choice) = Run_context(ConcurrencyTag(), get_parameter(np, CGAL::internal_np::visitor));
  choice.number_of_vertices = number_of_vertices;
  if constexpr (has_parameter<internal_np::faces_per_block_t, NamedParameters>) {
    choice.faces_per_block = std::size_t(get_parameter(np, internal_np::faces_per_block_p));
    if (*choice.faces_per_block == 0)
      throw Invalid_input("the number of faces per block is 0");
  }
  choice.end = chosen_minimization_end(np);
  choice.has_densities = has_parameter<internal_np::face_density_t, NamedParameters>;
  choice.maximum_density = density_choice(np).maximum;
  choice.energy = energy_model(chosen_energy<Energy_choice<NamedParameters> >(np));
  choice.placement = placement_model(placement);
  choice.repairs_output = choose_parameter(get_parameter(np, internal_np::repair_output_p), bool(choice.placement.from_start));
  if (choice.repairs_output && choice.placement.is_at_input_vertices)
    throw Invalid_input("the parameter repair_output is not available for distributed meshes with a placement at input "
                        "vertices");
  choice.output_coordinates = [](const Local_frame& frame) { return output_coordinates<OutputTraits>(frame); };
  choice.wants_output_everywhere = choose_parameter(get_parameter(np, internal_np::output_on_all_ranks_p), false);
  choice.wants_clusters = has_parameter<internal_np::face_cluster_t, NamedParameters>;
  if constexpr (has_parameter<internal_np::face_name_t, NamedParameters>)
    choice.face_names = [&np](std::uint64_t face) { return get(get_parameter(np, internal_np::face_name), face); };
  choice.scratch_directory = choose_parameter(get_parameter(np, internal_np::scratch_directory_p), std::string());
  choice.scratch_memory = std::uint64_t(choose_parameter(get_parameter(np, internal_np::scratch_memory_p), std::uint64_t(0)));
  return choice;
}

// What all steps on a rank share: the choices of the caller, the communicator, the scratch file, the number of bytes sent, and
// the frame of the mesh, when it is known.
struct Rank_context : Distributed_choice
{
  const boost::mpi::communicator& communicator;
  Scratch_file scratch;
  std::uint64_t bytes_sent = 0;
  Local_frame frame;

  Rank_context(const boost::mpi::communicator& c, const Distributed_choice& choice) : Distributed_choice(choice), communicator(c)
  {}

  std::size_t rank() const { return std::size_t(communicator.rank()); }
  std::size_t number_of_ranks() const { return std::size_t(communicator.size()); }
};

// Sends the records of rank 0 to all ranks, in parts, because MPI counts the bytes of a message in an `int`.
template <class Record>
void broadcast_records(Rank_context& context, std::vector<Record>& records)
{
  static_assert(std::is_trivially_copyable<Record>::value);
  constexpr std::size_t max_bytes = std::size_t(1) << 30;
  std::size_t number = records.size();
  boost::mpi::broadcast(context.communicator, number, 0);
  records.resize(number);
  const std::size_t size = number * sizeof(Record);
  if (context.rank() == 0)
    context.bytes_sent += (context.number_of_ranks() - 1) * size;
  char* const bytes = reinterpret_cast<char*>(records.data());
  for (std::size_t begin = 0; begin < size; begin += max_bytes)
    boost::mpi::broadcast(context.communicator, bytes + begin, int((std::min)(max_bytes, size - begin)), 0);
}

// An exception that is sent to other ranks.
struct Remote_exception
{
  enum Kind : int { NONE_THROWN, OTHER, INVALID, UNREACHABLE, CANCELLED }; // the last kind has priority
  int kind = NONE_THROWN;
  std::string message;
  std::uint64_t nearest = 0; // the nearest number of vertices, for UNREACHABLE

  template <class Archive>
  void serialize(Archive& archive, unsigned)
  {
    archive & kind & message & nearest;
  }
};

// Does the work of this rank, which must not wait for other ranks. If it throws on some ranks, all ranks throw the same
// exception. Of several messages, the alphabetically first is selected.
inline void on_all_ranks(const boost::mpi::communicator& communicator, const std::function<void()>& work)
{
  Remote_exception own;
  try {
    work();
  } catch (const Coarsening_cancelled&) {
    own = {Remote_exception::CANCELLED, "", 0};
  } catch (const Unreachable_number_of_vertices& e) {
    own = {Remote_exception::UNREACHABLE, e.what(), e.nearest()};
  } catch (const Invalid_input& e) {
    own = {Remote_exception::INVALID, e.what(), 0};
  } catch (const std::exception& e) {
    own = {Remote_exception::OTHER, "rank " + std::to_string(communicator.rank()) + ": " + e.what(), 0};
  }
  if (boost::mpi::all_reduce(communicator, own.kind, boost::mpi::maximum<int>()) == Remote_exception::NONE_THROWN)
    return;
  std::vector<Remote_exception> all;
  boost::mpi::all_gather(communicator, own, all);
  const Remote_exception& e = *std::min_element(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return std::tie(b.kind, a.message) < std::tie(a.kind, b.message);
  });
  switch (e.kind) {
  case Remote_exception::CANCELLED: throw Coarsening_cancelled();
  case Remote_exception::UNREACHABLE: throw Unreachable_number_of_vertices(e.message, std::size_t(e.nearest));
  case Remote_exception::INVALID: throw Invalid_input(e.message);
  default: throw std::runtime_error(e.message);
  }
}

// Does work on rank 0. If it throws, all ranks throw the same exception.
inline void on_first_rank(const Rank_context& context, const std::function<void()>& work)
{
  on_all_ranks(context.communicator, [&] {
    if (context.rank() == 0)
      work();
  });
}

// Does the work of each block of this rank. If several blocks are invalid, the alphabetically first message is selected, so it
// does not depend on the distribution of the blocks.
template <class Work>
void for_each_block(std::size_t blocks, const Work& work)
{
  std::string first;
  for (std::size_t i = 0; i < blocks; ++i)
    try {
      work(i);
    } catch (const Unreachable_number_of_vertices&) {
      throw;
    } catch (const Invalid_input& e) {
      first = first.empty() ? e.what() : (std::min)(first, std::string(e.what()));
    }
  if (!first.empty())
    throw Invalid_input(first);
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_RANK_CONTEXT_H
