// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_MPI_RUN_REPORT_H
#define COARSEN_MESH_MPI_RUN_REPORT_H

#include "Input_slice.h"

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>

#include <boost/mpi/communicator.hpp>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace coarsen_mesh_mpi {

// Times, memory and traffic of all ranks, on rank 0.
class Run_report
{
public:
  explicit Run_report(const boost::mpi::communicator& ranks);

  // All ranks call this together, after the coarsening.
  void add(const Input_slice& slice, const CGAL::Surface_mesh_coarsening::Distributed_report& done);

  std::string json() const;
  std::string sentence() const;

private:
  struct Rank
  {
    std::uint64_t faces, bytes_sent, bytes_of_scratch, peak_memory;
    double cpu_seconds;
  };

  const boost::mpi::communicator& communicator_;
  std::chrono::steady_clock::time_point begin_;
  double seconds_ = 0;
  std::uint64_t faces_ = 0;
  CGAL::Surface_mesh_coarsening::Distributed_report done_;
  std::vector<Rank> ranks_;
};

} // namespace coarsen_mesh_mpi

#endif // COARSEN_MESH_MPI_RUN_REPORT_H
