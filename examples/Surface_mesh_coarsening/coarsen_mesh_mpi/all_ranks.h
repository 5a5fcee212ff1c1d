// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_MPI_ALL_RANKS_H
#define COARSEN_MESH_MPI_ALL_RANKS_H

#include <boost/mpi/communicator.hpp>

#include <functional>

namespace coarsen_mesh_mpi {

// Does the work of this rank. If it throws on some ranks, all throw Invalid_input with the same message.
void on_all_ranks(const boost::mpi::communicator& ranks, const std::function<void()>& work);

} // namespace coarsen_mesh_mpi

#endif // COARSEN_MESH_MPI_ALL_RANKS_H
