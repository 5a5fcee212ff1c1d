// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_BOUNDARY_EDGES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_BOUNDARY_EDGES_H

#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Blocks of nearby clusters, all with about the same number of clusters, by recursive coordinate bisection (Berger and Bokhari: A
// partitioning strategy for nonuniform problems on multiprocessors, 1987). They depend only on the points; ties are broken by the
// number of the cluster.
class Cluster_blocks
{
public:
  Cluster_blocks() {}

  // One point for each cluster.
  Cluster_blocks(std::vector<Vector> points, std::size_t blocks, const Run_context& context)
    : points_(std::move(points)), block_of_(points_.size(), 0), size_(blocks), context_(context)
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
    run_concurrently(context_, 2, [&](std::size_t part) {
      if (part == 0)
        bisect(begin, middle, first, half);
      else
        bisect(middle, end, first + half, blocks - half);
    });
  }

  std::size_t longest_side(const Index* begin, const Index* end) const
  {
    Bbox_3 box;
    for (const Index* x = begin; x != end; ++x)
      box += box_of_point(points_[*x]);
    const Vector side = high_corner(box) - low_corner(box);
    return std::size_t(std::max_element(side.begin(), side.end()) - side.begin());
  }

  std::vector<Vector> points_; // used only during the construction
  std::vector<Index> block_of_;
  std::size_t size_ = 1;
  Run_context context_;
};

// A count of moves.
typedef Index Move_time;

// An edge between two clusters.
struct Boundary_edge
{
  std::array<Index, 2> face;    // the face of smaller index first
  Index corner;                 // of the first face, before the edge
  std::array<Index, 2> cluster; // the clusters of the faces at the last look-up
  Move_time tested;             // 0: never
  Index terms;                  // the position of the terms of the two faces in a block; NONE if they are not stored

  bool is_inner() const { return cluster[0] == cluster[1]; }

  // Returns whether one of the clusters has changed since the last test. A face that changes its cluster changes both clusters.
  bool is_due(const std::vector<Move_time>& last_change) const
  {
    return (std::max)(last_change[cluster[0]], last_change[cluster[1]]) > tested;
  }

  void look_up(const Cluster_labels& labels) { cluster = {{labels[face[0]], labels[face[1]]}}; }
};

typedef std::vector<Boundary_edge> Boundary_edges;

// The set of listed edges, identified by their corners. Threads may insert and erase different edges at the same time.
class Listed_edges
{
public:
  explicit Listed_edges(std::size_t corners) : words_((corners + 63) / 64) { clear(); }

  void clear()
  {
    for (std::atomic<std::uint64_t>& word : words_)
      word.store(0, std::memory_order_relaxed);
  }

  // Returns whether the edge is new.
  bool insert(Index corner)
  {
    return (words_[corner / 64].fetch_or(bit(corner), std::memory_order_relaxed) & bit(corner)) == 0;
  }
  void erase(Index corner) { words_[corner / 64].fetch_and(~bit(corner), std::memory_order_relaxed); }

private:
  static std::uint64_t bit(Index corner) { return std::uint64_t(1) << (corner % 64); }

  std::vector<std::atomic<std::uint64_t> > words_;
};

// Lists all edges between clusters, face by face.
inline void list_boundary_edges(const Cluster_labels& labels, Boundary_edges& all, Listed_edges& listed,
                                const Run_context& context)
{
  const Flat_mesh& m = labels.mesh();
  all.clear();
  listed.clear();
  for_each_part<Boundary_edges>(
    context, m.number_of_faces(), 4096,
    [&](Boundary_edges& edges, std::size_t begin, std::size_t end) {
      edges.clear();
      for (Index f = Index(begin); f != end; ++f)
        for (const Index c : m.corners(f)) {
          const Index g = m.face_across[c];
          if (g != NONE && g > f && labels[g] != labels[f]) {
            edges.push_back({{{f, g}}, c, {{labels[f], labels[g]}}, 0, NONE});
            listed.insert(c);
          }
        }
    },
    [&](const Boundary_edges& edges) { all.insert(all.end(), edges.begin(), edges.end()); });
}

// Marks the two vertices of an edge.
inline void mark_ends(const Flat_mesh& m, const Boundary_edge& e, std::vector<char>& is_marked)
{
  is_marked[m.corner_vertex[e.corner]] = true;
  is_marked[m.corner_vertex[m.next_corner(e.face[0], e.corner)]] = true;
}

// Returns the edges of each block, and then the edges between blocks.
inline std::vector<Boundary_edges> distribute(const Boundary_edges& edges, const Cluster_blocks& blocks,
                                              const Run_context& context)
{
  const Index between = Index(blocks.size());
  std::vector<Index> block_of(edges.size());
  for_each_number(context.uninterrupted(), edges.size(), [&](Index i) {
    const std::array<Index, 2>& x = edges[i].cluster;
    block_of[i] = blocks[x[0]] == blocks[x[1]] ? blocks[x[0]] : between;
  });
  std::vector<std::size_t> number(blocks.size() + 1, 0);
  for (const Index b : block_of)
    ++number[b];
  std::vector<Boundary_edges> result(number.size());
  for (std::size_t b = 0; b < number.size(); ++b)
    result[b].reserve(number[b]);
  for (std::size_t i = 0; i < edges.size(); ++i)
    result[block_of[i]].push_back(edges[i]);
  return result;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_BOUNDARY_EDGES_H
