// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_BLOCKS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_BLOCKS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Index.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
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

// The position of a point on the Morton curve, whose binary digits are the digits of the three coordinates in turn.
class Morton_curve
{
public:
  static constexpr int bits = 20; // of each coordinate

  // For points of a box.
  Morton_curve(const Vector& low, const Vector& high) : low_(low)
  {
    double extent = 0;
    for (std::size_t i = 0; i < 3; ++i)
      extent = (std::max)(extent, high[i] - low[i]);
    scale_ = extent > 0 ? double(std::uint64_t(1) << bits) / extent : 0;
  }

  std::uint64_t operator()(const Vector& p) const
  {
    std::uint64_t place = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      constexpr double last = double((std::uint64_t(1) << bits) - 1);
      const std::uint64_t x = std::uint64_t((std::min)((std::max)(scale_ * (p[i] - low_[i]), 0.), last));
      place |= spread(x) << i;
    }
    return place;
  }

private:
  // Moves bit b to 3 b, by halves, quarters and so on.
  static std::uint64_t spread(std::uint64_t x)
  {
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
  }

  Vector low_;
  double scale_;
};

// Divides the curve into blocks of at most `max_faces` faces, unless more faces have the same position. Returns the first
// position of each block. Cubes of an octree with few enough faces are joined in order as long as they fit into a block.
inline std::vector<std::uint64_t> block_starts(const boost::mpi::communicator& communicator, std::vector<std::uint64_t> places,
                                               std::size_t max_faces)
{
  std::sort(places.begin(), places.end());
  struct Cube
  {
    std::uint64_t first, faces;
  };
  std::vector<Cube> leaves, open(1, {0, (std::numeric_limits<std::uint64_t>::max)()});
  for (int level = Morton_curve::bits; level > 0 && !open.empty(); --level) {
    const std::uint64_t side = std::uint64_t(1) << (3 * (level - 1)); // the number of positions in a child
    std::vector<std::uint64_t> own, all(8 * open.size());
    for (const Cube& cube : open)
      for (std::uint64_t child = 0; child < 8; ++child) {
        const std::uint64_t first = cube.first + child * side;
        own.push_back(std::uint64_t(std::lower_bound(places.begin(), places.end(), first + side) -
                                    std::lower_bound(places.begin(), places.end(), first)));
      }
    boost::mpi::all_reduce(communicator, own.data(), int(own.size()), all.data(), std::plus<std::uint64_t>());
    std::vector<Cube> divided;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Cube child{open[i / 8].first + i % 8 * side, all[i]};
      if (child.faces > max_faces && level > 1)
        divided.push_back(child);
      else if (child.faces > 0)
        leaves.push_back(child);
    }
    open.swap(divided);
  }
  std::sort(leaves.begin(), leaves.end(), [](const Cube& a, const Cube& b) { return a.first < b.first; });
  std::vector<std::uint64_t> starts;
  std::uint64_t faces = 0;
  for (const Cube& leaf : leaves) {
    if (starts.empty() || faces + leaf.faces > max_faces) {
      starts.push_back(leaf.first);
      faces = 0;
    }
    faces += leaf.faces;
  }
  return starts;
}

inline Index block_of(const std::vector<std::uint64_t>& starts, std::uint64_t place)
{
  return Index(std::upper_bound(starts.begin(), starts.end(), place) - starts.begin() - 1);
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_BLOCKS_H
