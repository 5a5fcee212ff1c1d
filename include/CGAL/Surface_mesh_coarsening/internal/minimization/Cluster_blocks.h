// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_CLUSTER_BLOCKS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_CLUSTER_BLOCKS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Blocks of nearby clusters, all with about the same number of clusters, by recursive coordinate bisection (Berger and Bokhari: A
// partitioning strategy for nonuniform problems on multiprocessors, 1987). They depend only on the points; ties are broken by the
// number of the cluster.
class Cluster_blocks
{
public:
  Cluster_blocks() {}

  // One point for each cluster.
  Cluster_blocks(std::vector<Vector> points, std::size_t blocks, Execution execution)
    : points_(std::move(points)), block_of_(points_.size(), 0), size_(blocks), execution_(execution)
  {
    std::vector<Index> clusters(points_.size());
    std::iota(clusters.begin(), clusters.end(), Index(0));
    bisect(clusters.data(), clusters.data() + clusters.size(), 0, blocks);
    points_ = std::vector<Vector>();
  }

  std::size_t size() const { return size_; }
  Index operator[](Index cluster) const { return block_of_[cluster]; }

private:
  void bisect(Index* begin, Index* end, std::size_t first, std::size_t blocks)
  {
    if (blocks == 1) {
      for (Index* x = begin; x != end; ++x)
        block_of_[*x] = Index(first);
      return;
    }
    const std::size_t half = blocks / 2, axis = longest_side(begin, end);
    Index* const middle = begin + std::size_t(end - begin) * half / blocks;
    std::nth_element(begin, middle, end, [&](Index a, Index b) {
      return std::make_pair(points_[a][axis], a) < std::make_pair(points_[b][axis], b);
    });
    for_each_chunk(execution_, 2, 1, [&](std::size_t part, std::size_t, std::size_t) {
      if (part == 0)
        bisect(begin, middle, first, half);
      else
        bisect(middle, end, first + half, blocks - half);
    });
  }

  std::size_t longest_side(const Index* begin, const Index* end) const
  {
    const double inf = std::numeric_limits<double>::infinity();
    Vector low{{inf, inf, inf}}, high{{-inf, -inf, -inf}};
    for (const Index* x = begin; x != end; ++x)
      for (int i = 0; i < 3; ++i) {
        low[i] = (std::min)(low[i], points_[*x][i]);
        high[i] = (std::max)(high[i], points_[*x][i]);
      }
    const Vector side = high - low;
    return std::size_t(std::max_element(side.begin(), side.end()) - side.begin());
  }

  std::vector<Vector> points_; // used only during the construction
  std::vector<Index> block_of_;
  std::size_t size_ = 1;
  Execution execution_ = Execution::SEQUENTIAL;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_CLUSTER_BLOCKS_H
