// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_DUAL_TRIANGLES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_DUAL_TRIANGLES_H

#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/Visitor_handle.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Dual_walk.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

typedef std::array<Index, 3> Triangle;

// Calls `visit(v, clusters)` for each vertex from `begin` to `end` where three or more clusters meet. `clusters` are in
// counterclockwise order.
template <class Visit>
void for_each_meeting_point(const Cluster_labels& labels, Index begin, Index end, const Visit& visit)
{
  std::vector<Index> runs;
  for (Index v = begin; v != end; ++v) {
    if (labels.boundary_count(v) < 3)
      continue;
    clusters_around_vertex(labels, v, runs);
    if (Cluster_labels::is_cap(runs.back()))
      runs.pop_back();
    if (runs.size() > 2)
      visit(v, runs);
  }
}

template <class Visit>
void for_each_meeting_point(const Cluster_labels& labels, const Visit& visit)
{
  for_each_meeting_point(labels, 0, Index(labels.mesh().number_of_vertices()), visit);
}

// Returns the dual (section 8.3 of the paper) as triangles of cluster numbers, in the orientation of the mesh: a triangle for
// each vertex where three clusters meet, and a fan where more than three clusters meet.
inline std::vector<Triangle> dual_triangles(const Cluster_labels& labels,
                                            const Cancellation_point& cancellation = Cancellation_point(),
                                            Execution execution = Execution::SEQUENTIAL)
{
  constexpr std::size_t chunk = 4096;
  const std::size_t vertices = labels.mesh().number_of_vertices();
  std::vector<std::vector<Triangle> > parts((vertices + chunk - 1) / chunk);
  for_each_chunk(execution, vertices, chunk, cancellation, [&](std::size_t part, std::size_t begin, std::size_t end) {
    for_each_meeting_point(labels, Index(begin), Index(end), [&](Index, const std::vector<Index>& runs) {
      for (std::size_t i = 2; i < runs.size(); ++i)
        parts[part].push_back({runs[0], runs[i - 1], runs[i]});
    });
  });
  std::vector<Triangle> triangles;
  for (std::vector<Triangle>& part : parts) {
    triangles.insert(triangles.end(), part.begin(), part.end());
    part = std::vector<Triangle>();
  }
  return triangles;
}

// The same for clusters of any origin: a fan that would repeat an edge gets another apex. If no apex avoids this, an exception is
// thrown; `name(x)` is the name of cluster `x` in its message.
template <class Name>
class Simplicial_dual
{
public:
  Simplicial_dual(const Cluster_labels& labels, const Name& name) : labels_(labels), name_(name) {}

  std::vector<Triangle> triangles()
  {
    for_each_meeting_point(labels_, [&](Index, const std::vector<Index>& runs) {
      for (std::size_t i = 0; i < runs.size(); ++i)
        edges_.insert(key(runs[i], runs[(i + 1) % runs.size()]));
    });
    for_each_meeting_point(labels_, [&](Index v, const std::vector<Index>& runs) { add_fan(v, runs); });
    check_edges();
    return triangles_;
  }

private:
  static std::uint64_t key(Index a, Index b)
  {
    return (std::uint64_t((std::min)(a, b)) << 32) | (std::max)(a, b);
  }

  void add_fan(Index v, const std::vector<Index>& runs)
  {
    const std::size_t n = runs.size();
    for (std::size_t apex = 0; apex < n; ++apex) {
      bool is_free = true;
      for (std::size_t i = 2; i + 1 < n && is_free; ++i)
        is_free = edges_.count(key(runs[apex], runs[(apex + i) % n])) == 0;
      if (!is_free)
        continue;
      for (std::size_t i = 2; i < n; ++i) {
        triangles_.push_back({runs[apex], runs[(apex + i - 1) % n], runs[(apex + i) % n]});
        if (i + 1 < n)
          edges_.insert(key(runs[apex], runs[(apex + i) % n]));
      }
      return;
    }
    throw Invalid_input("the " + std::to_string(n) + " clusters around vertex " + std::to_string(v) +
                        ", among them " + name_(runs[0]) + ", cannot be triangulated without repeating an edge");
  }

  void check_edges() const
  {
    std::vector<std::uint64_t> directed;
    directed.reserve(3 * triangles_.size());
    for (const Triangle& t : triangles_)
      for (std::size_t i = 0; i < 3; ++i)
        directed.push_back((std::uint64_t(t[i]) << 32) | t[(i + 1) % 3]);
    std::sort(directed.begin(), directed.end());
    const auto twice = std::adjacent_find(directed.begin(), directed.end());
    if (twice != directed.end())
      throw Invalid_input(name_(Index(*twice >> 32)) + " and " + name_(Index(*twice & NONE)) + " meet twice");
  }

  const Cluster_labels& labels_;
  const Name& name_;
  std::unordered_set<std::uint64_t> edges_;
  std::vector<Triangle> triangles_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_DUAL_TRIANGLES_H
