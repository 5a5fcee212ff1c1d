// SPDX-License-Identifier: GPL-3.0-or-later

#include "all_ranks.h"

#include <CGAL/Surface_mesh_coarsening/exceptions.h>

#include <boost/mpi/collectives.hpp>
#include <boost/serialization/string.hpp>

#include <algorithm>
#include <exception>
#include <string>
#include <vector>

namespace coarsen_mesh_mpi {

void on_all_ranks(const boost::mpi::communicator& ranks, const std::function<void()>& work)
{
  std::string fault;
  try {
    work();
  } catch (const std::exception& e) {
    fault = e.what();
  }
  if (!boost::mpi::all_reduce(ranks, !fault.empty(), std::logical_or<bool>()))
    return;
  std::vector<std::string> faults;
  boost::mpi::all_gather(ranks, fault, faults);
  faults.erase(std::remove(faults.begin(), faults.end(), ""), faults.end());
  throw CGAL::Surface_mesh_coarsening::Invalid_input(*std::min_element(faults.begin(), faults.end()));
}

} // namespace coarsen_mesh_mpi
