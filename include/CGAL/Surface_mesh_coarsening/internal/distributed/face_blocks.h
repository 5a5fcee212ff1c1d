// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_BLOCKS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_BLOCKS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Index.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Morton_curve.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Divides the curve into blocks of at most `max_faces` faces, unless more faces have the same position. Returns the first
// position of each block. Cubes of an octree with few enough faces are joined in order as long as they fit into a block.
// `places` has the positions of the faces of this rank; `sum(own)` returns the sums of numbers over all ranks.
template <class Sum>
std::vector<std::uint64_t> block_starts(std::vector<std::uint64_t> places, std::size_t max_faces, const Sum& sum)
{
  std::sort(places.begin(), places.end());
  struct Cube
  {
    std::uint64_t first, faces;
  };
  std::vector<Cube> leaves, open(1, {0, (std::numeric_limits<std::uint64_t>::max)()});
  for (int level = Morton_curve::bits; level > 0 && !open.empty(); --level) {
    const std::uint64_t side = std::uint64_t(1) << (3 * (level - 1)); // the number of positions in a child
    std::vector<std::uint64_t> own;
    for (const Cube& cube : open)
      for (std::uint64_t child = 0; child < 8; ++child) {
        const std::uint64_t first = cube.first + child * side;
        own.push_back(std::uint64_t(std::lower_bound(places.begin(), places.end(), first + side) -
                                    std::lower_bound(places.begin(), places.end(), first)));
      }
    const std::vector<std::uint64_t> all = sum(own);
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

// Returns the block of a position on the curve.
inline Index block_of(const std::vector<std::uint64_t>& starts, std::uint64_t place)
{
  return Index(std::upper_bound(starts.begin(), starts.end(), place) - starts.begin() - 1);
}

// Returns the rank of one of `bins` bins, blocks or others: consecutive runs of bins belong to consecutive ranks.
inline std::size_t rank_of_bin(std::size_t bin, std::size_t bins, std::size_t ranks) { return bin * ranks / bins; }

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_BLOCKS_H
