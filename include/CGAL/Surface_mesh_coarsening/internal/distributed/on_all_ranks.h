// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_ON_ALL_RANKS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_ON_ALL_RANKS_H

#include <CGAL/Surface_mesh_coarsening/exceptions.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/serialization/string.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// An exception that is sent to other ranks.
struct Remote_exception
{
  enum Kind : int { NONE_THROWN, OTHER, INVALID, UNREACHABLE, CANCELLED }; // the last kind has priority
  int kind = NONE_THROWN;
  std::string message;
  std::uint64_t nearest = 0; // the nearest number of vertices, for UNREACHABLE
};

inline Remote_exception caught(const std::function<void()>& work, int rank)
{
  try {
    work();
  } catch (const Coarsening_cancelled&) {
    return {Remote_exception::CANCELLED, "", 0};
  } catch (const Unreachable_number_of_vertices& e) {
    return {Remote_exception::UNREACHABLE, e.what(), e.nearest()};
  } catch (const Invalid_input& e) {
    return {Remote_exception::INVALID, e.what(), 0};
  } catch (const std::exception& e) {
    return {Remote_exception::OTHER, "rank " + std::to_string(rank) + ": " + e.what(), 0};
  }
  return {};
}

[[noreturn]] inline void rethrow(const Remote_exception& e)
{
  if (e.kind == Remote_exception::CANCELLED)
    throw Coarsening_cancelled();
  if (e.kind == Remote_exception::UNREACHABLE)
    throw Unreachable_number_of_vertices(e.message, std::size_t(e.nearest));
  if (e.kind == Remote_exception::INVALID)
    throw Invalid_input(e.message);
  throw std::runtime_error(e.message);
}

// If some ranks have thrown, all ranks throw the same exception. Of several messages, the alphabetically first is selected.
inline void throw_on_all_ranks(const boost::mpi::communicator& communicator, const Remote_exception& own)
{
  const int kind = boost::mpi::all_reduce(communicator, own.kind, boost::mpi::maximum<int>());
  if (kind == Remote_exception::NONE_THROWN)
    return;
  std::vector<std::string> messages;
  std::vector<int> kinds;
  std::vector<std::uint64_t> nearest;
  boost::mpi::all_gather(communicator, own.message, messages);
  boost::mpi::all_gather(communicator, own.kind, kinds);
  boost::mpi::all_gather(communicator, own.nearest, nearest);
  std::size_t first = messages.size();
  for (std::size_t i = 0; i < messages.size(); ++i)
    if (kinds[i] == kind && (first == messages.size() || messages[i] < messages[first]))
      first = i;
  rethrow({kind, messages[first], nearest[first]});
}

// Does the work of this rank, which must not wait for other ranks. If it throws on some ranks, all ranks throw the same
// exception.
inline void on_all_ranks(const boost::mpi::communicator& communicator, const std::function<void()>& work)
{
  throw_on_all_ranks(communicator, caught(work, communicator.rank()));
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

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_ON_ALL_RANKS_H
