// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_BOX_OF_RANKS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_BOX_OF_RANKS_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The bounding box of the points of all ranks. Minima and maxima do not depend on the order of their computation.
class Box_of_ranks
{
public:
  void add(const Vector& p)
  {
    for (std::size_t i = 0; i < 3; ++i) {
      low_and_negated_high_[i] = (std::min)(low_and_negated_high_[i], p[i]);
      low_and_negated_high_[i + 3] = (std::min)(low_and_negated_high_[i + 3], -p[i]);
    }
  }

  // The lowest and the highest coordinates.
  std::vector<Vector> ends_of_all(const boost::mpi::communicator& communicator) const
  {
    std::array<double, 6> all;
    boost::mpi::all_reduce(communicator, low_and_negated_high_.data(), 6, all.data(), boost::mpi::minimum<double>());
    return {{{all[0], all[1], all[2]}}, {{-all[3], -all[4], -all[5]}}};
  }

private:
  static constexpr double inf = std::numeric_limits<double>::infinity();

  std::array<double, 6> low_and_negated_high_{{inf, inf, inf, inf, inf, inf}};
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_BOX_OF_RANKS_H
