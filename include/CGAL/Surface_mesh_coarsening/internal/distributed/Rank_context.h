// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_RANK_CONTEXT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_RANK_CONTEXT_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Visitor_handle.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Scratch_file.h>

#include <boost/mpi/communicator.hpp>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The data that all steps on a rank share: its communicator, its scratch file, and the number of bytes sent.
struct Rank_context
{
  const boost::mpi::communicator& communicator;
  Cancellation_point cancellation;
  Scratch_file scratch;
  std::uint64_t bytes_sent = 0;

  Rank_context(const boost::mpi::communicator& c, const Cancellation_point& p) : communicator(c), cancellation(p) {}

  std::size_t rank() const { return std::size_t(communicator.rank()); }
  std::size_t number_of_ranks() const { return std::size_t(communicator.size()); }
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_RANK_CONTEXT_H
