// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_RANK_CONTEXT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_RANK_CONTEXT_H

#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Face_record.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Typed_energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/Face_graph_filler.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Placement_model.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Keeps words in memory and, beyond a limit, in a file.
//
// The name of the file is removed as soon as the file is open, so the file vanishes when the process ends, also after a crash.
// Systems that cannot remove open files remove it when it is closed.
class Scratch_file
{
public:
  // The number of words of a slot; a larger chunk occupies several slots.
  static constexpr std::size_t slot_words = std::size_t(1) << 13;

  struct Chunk
  {
    Words words; // empty if they are in the file
    std::uint64_t slot;
    std::size_t size;
  };

  ~Scratch_file()
  {
    if (file_.is_open()) {
      file_.close();
      std::remove(name_.c_str());
    }
  }

  // Opens the file at the beginning, so that an unusable directory is reported before any work is done. Uses the first unused
  // name, because other ranks and other programs may use the same directory.
  void limit_memory(std::string directory, std::uint64_t max_words)
  {
    directory_ = std::move(directory);
    max_words_ = max_words;
    if (directory_.empty())
      return;
    std::FILE* created = nullptr;
    for (int i = 0; !created; ++i) {
      name_ = directory_ + "/coarsening_scratch_" + std::to_string(i);
      errno = 0;
      created = std::fopen(name_.c_str(), "wbx");
      check(created || errno == EEXIST, "create");
    }
    std::fclose(created);
    file_.rdbuf()->pubsetbuf(nullptr, 0);
    file_.open(name_, std::ios::in | std::ios::out | std::ios::binary);
    std::remove(name_.c_str());
    check(file_.good(), "open");
  }

  // Stores words, at least one, and clears `words`.
  Chunk store(Words& words)
  {
    Chunk chunk{Words(), 0, words.size()};
    if (directory_.empty() || words_ + words.size() <= max_words_) {
      words_ += words.size();
      chunk.words = std::move(words);
    } else {
      const std::uint64_t slots = number_of_slots(words.size());
      if (slots == 1 && !free_slots_.empty()) {
        chunk.slot = free_slots_.back();
        free_slots_.pop_back();
      } else {
        chunk.slot = slots_;
        slots_ += slots;
      }
      errno = 0;
      file_.seekp(position(chunk.slot));
      file_.write(reinterpret_cast<const char*>(words.data()), std::streamsize(words.size() * sizeof words[0]));
      file_.flush();
      check(file_.good(), "write to");
      bytes_written_ += words.size() * sizeof words[0];
    }
    words.clear();
    return chunk;
  }

  // Returns the words of a chunk, which may be in the buffer.
  const Words& read(const Chunk& chunk, Words& buffer)
  {
    if (!chunk.words.empty())
      return chunk.words;
    buffer.resize(chunk.size);
    errno = 0;
    file_.seekg(position(chunk.slot));
    file_.read(reinterpret_cast<char*>(buffer.data()), std::streamsize(chunk.size * sizeof buffer[0]));
    check(file_.good(), "read from");
    return buffer;
  }

  void release(const Chunk& chunk)
  {
    words_ -= chunk.words.size();
    if (chunk.words.empty())
      for (std::uint64_t i = 0; i < number_of_slots(chunk.size); ++i)
        free_slots_.push_back(chunk.slot + i);
  }

  std::uint64_t bytes_written() const { return bytes_written_; }

private:
  static std::uint64_t number_of_slots(std::size_t size) { return (size + slot_words - 1) / slot_words; }
  static std::streamoff position(std::uint64_t slot) { return std::streamoff(slot * slot_words * sizeof(std::uint64_t)); }

  void check(bool has_succeeded, const char* action) const
  {
    if (has_succeeded)
      return;
    const std::string reason = errno == 0 ? "" : ": " + std::generic_category().message(errno);
    throw std::runtime_error(std::string("cannot ") + action + " a scratch file in " + directory_ + reason);
  }

  std::string directory_, name_; // without a directory, all words are kept in memory
  std::uint64_t max_words_ = 0, words_ = 0, slots_ = 0, bytes_written_ = 0;
  std::vector<std::uint64_t> free_slots_;
  std::fstream file_;
};

// Returns the name of a face for messages, given its number in the sequence of all pieces.
typedef std::function<std::string(std::uint64_t)> Face_names;

// What all steps on a rank share: the choices of the caller, the threads and the visitor of this rank, the communicator, the
// scratch file, the number of bytes sent, and the frame of the mesh, when it is known. The choices are equal on all ranks, except
// the visitor and the scratch directory.
struct Rank_context : Run_context
{
  static constexpr std::size_t default_faces_per_block = std::size_t(1) << 18;

  const boost::mpi::communicator& communicator;
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
  Scratch_file scratch; // if it has no directory, all records are kept in memory
  std::uint64_t bytes_sent = 0;
  Local_frame frame;

  explicit Rank_context(const boost::mpi::communicator& c) : communicator(c) {}

  std::size_t rank() const { return std::size_t(communicator.rank()); }
  std::size_t number_of_ranks() const { return std::size_t(communicator.size()); }
  // Whether rank 0 fits or repairs vertices on the surface of cells.
  bool places_on_cells() const { return placement.fitted || repairs_output; }
};

// The parameters of distributed meshes that do not depend on the form of the pieces.
struct Distributed_parameters
  : Parameter_list<internal_np::face_density_t, internal_np::maximum_density_t, internal_np::cluster_weight_t,
                   internal_np::cluster_energy_t, internal_np::convergence_tolerance_t, internal_np::vertex_placement_t,
                   internal_np::repair_output_t, internal_np::face_cluster_t, internal_np::output_on_all_ranks_t,
                   internal_np::faces_per_block_t, internal_np::scratch_directory_t, internal_np::scratch_memory_t,
                   CGAL::internal_np::number_of_iterations_t, CGAL::internal_np::visitor_t>
{};

// Sets the choices of the caller, which refer to the placement and the parameters.
template <class ConcurrencyTag, class OutputTraits, class Placement, class NamedParameters>
void set_choices(Rank_context& context, std::size_t number_of_vertices, const Placement& placement, const NamedParameters& np)
{
  static_assert(is_local_placement<Placement> || is_fitted_placement<Placement>,
                "a placement of all vertices together, other than Fitted_placement, is not available for distributed meshes");
  static_cast<Run_context&>(context) = Run_context(ConcurrencyTag(), get_parameter(np, CGAL::internal_np::visitor));
  context.number_of_vertices = number_of_vertices;
  if constexpr (has_parameter<internal_np::faces_per_block_t, NamedParameters>) {
    context.faces_per_block = std::size_t(get_parameter(np, internal_np::faces_per_block_p));
    if (*context.faces_per_block == 0)
      throw Invalid_input("the number of faces per block is 0");
  }
  context.end = chosen_minimization_end(np);
  context.has_densities = has_parameter<internal_np::face_density_t, NamedParameters>;
  context.maximum_density = density_choice(np).maximum;
  context.energy = energy_model(chosen_energy<Energy_choice<NamedParameters> >(np));
  context.placement = placement_model(placement);
  context.repairs_output = choose_parameter(get_parameter(np, internal_np::repair_output_p), bool(context.placement.fitted));
  if (context.repairs_output && context.placement.is_at_input_vertices)
    throw Invalid_input("the parameter repair_output is not available for distributed meshes with a placement at input "
                        "vertices");
  context.output_coordinates = [](const Local_frame& frame) { return output_coordinates<OutputTraits>(frame); };
  context.wants_output_everywhere = choose_parameter(get_parameter(np, internal_np::output_on_all_ranks_p), false);
  context.wants_clusters = has_parameter<internal_np::face_cluster_t, NamedParameters>;
  if constexpr (has_parameter<internal_np::face_name_t, NamedParameters>)
    context.face_names = [&np](std::uint64_t face) { return get(get_parameter(np, internal_np::face_name), face); };
  const std::string directory(choose_parameter(get_parameter(np, internal_np::scratch_directory_p), std::string()));
  const auto bytes = std::uint64_t(choose_parameter(get_parameter(np, internal_np::scratch_memory_p), std::uint64_t(0)));
  context.scratch.limit_memory(directory, bytes / sizeof(std::uint64_t));
}

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

// Does the work of this rank, which must not wait for other ranks. If it throws on some ranks, all ranks throw the same
// exception. Of several messages, the alphabetically first of the first kind is selected.
inline void on_all_ranks(const boost::mpi::communicator& communicator, const std::function<void()>& work)
{
  enum { CANCELLED, UNREACHABLE, INVALID, OTHER, NONE_THROWN };
  typedef std::pair<int, std::pair<std::string, std::uint64_t> > Thrown; // the kind, the message, the nearest number of vertices
  Thrown own{NONE_THROWN, {}}, first;
  try {
    work();
  } catch (const Coarsening_cancelled&) {
    own.first = CANCELLED;
  } catch (const Unreachable_number_of_vertices& e) {
    own = {UNREACHABLE, {e.what(), e.nearest()}};
  } catch (const Invalid_input& e) {
    own = {INVALID, {e.what(), 0}};
  } catch (const std::exception& e) {
    own = {OTHER, {"rank " + std::to_string(communicator.rank()) + ": " + e.what(), 0}};
  }
  boost::mpi::all_reduce(communicator, own, first, boost::mpi::minimum<Thrown>());
  switch (first.first) {
  case NONE_THROWN: return;
  case CANCELLED: throw Coarsening_cancelled();
  case UNREACHABLE: throw Unreachable_number_of_vertices(first.second.first, std::size_t(first.second.second));
  case INVALID: throw Invalid_input(first.second.first);
  default: throw std::runtime_error(first.second.first);
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
