// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_DUAL_TRIANGLES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_DUAL_TRIANGLES_H

#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_set>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// An edge seen from the face on its left: the edge after corner `corner` of `face`.
struct Directed_edge
{
  Index face = NONE;
  Index corner = NONE;

  bool operator==(const Directed_edge& e) const { return corner == e.corner; }
};

// Computes the runs of equal labels around a vertex, counterclockwise, including the cap.
//
// In the dual triangulation, a vertex with d >= 3 runs is a fan of d - 2 triangles. The apex of the fan is the run of the first
// face of the star. Hence the dual triangulation depends on the clusters but not on their numbers, and a merge of two
// clusters contracts one of its edges. On the border, the first face is the clockwise end of the star, and only one triangle
// contains the cap, together with the two clusters that meet the border at this vertex.
inline void clusters_around_vertex(const Cluster_labels& labels, Index v, std::vector<Index>& runs)
{
  const Flat_mesh& m = labels.mesh();
  runs.clear();
  for (const Index f : m.faces_around(v)) {
    const Index label = labels[f];
    if (runs.empty() || runs.back() != label)
      runs.push_back(label);
  }
  if (m.is_on_border(v))
    runs.push_back(Cluster_labels::cap + m.loop[v]);
  else if (runs.size() > 1 && runs.back() == runs.front())
    runs.pop_back(); // the first run, the apex, continues across the end of the array
}

// A set of labels. Most sets are so small that a linear search is fastest.
class Label_set
{
public:
  void clear()
  {
    list_.clear();
    many_.clear();
  }
  std::size_t size() const { return list_.size(); }

  // Returns whether the label is new.
  bool insert(Index label)
  {
    if (list_.size() < few) {
      if (std::find(list_.begin(), list_.end(), label) != list_.end())
        return false;
    } else {
      if (many_.empty())
        many_.insert(list_.begin(), list_.end());
      if (!many_.insert(label).second)
        return false;
    }
    list_.push_back(label);
    return true;
  }

private:
  static constexpr std::size_t few = 32;
  std::vector<Index> list_;
  std::unordered_set<Index> many_;
};

// Walks along the boundary of a cluster that is a closed disc, and lists its neighbors in the dual triangulation in order.
class Dual_walk
{
public:
  explicit Dual_walk(const Cluster_labels& labels) : labels_(labels), mesh_(labels.mesh()) {}

  // Returns an edge of face `f` on the boundary of its cluster, if there is one.
  Directed_edge boundary_edge(Index f) const
  {
    for (const Index c : mesh_.corners(f))
      if (labels_.label_across(c) != labels_[f])
        return {f, c};
    return {};
  }

  // The edge that follows on the boundary of the cluster, counterclockwise.
  Directed_edge next_on_boundary(const Directed_edge e) const
  {
    return turn(e, mesh_.corner_vertex[mesh_.next_corner(e.face, e.corner)]);
  }

  // Calls `visit(label)` for each neighbor of the cluster in the dual triangulation, in order around it.
  template <class Visit>
  void along_link(const Directed_edge start, const Visit& visit)
  {
    Directed_edge e = start;
    do {
      const Index v = mesh_.corner_vertex[mesh_.next_corner(e.face, e.corner)];
      const Index front = labels_.label_across(e.corner);
      const Directed_edge leaving = turn(e, v);
      if (!link_at(v, e.face, front, labels_.label_across(leaving.corner), visit))
        return;
      e = leaving;
    } while (!(e == start));
  }

  // Returns the neighbor that prevents the cluster on the left of `start` from having a simple link: a neighbor that
  // occurs twice, or a second cap. Returns NONE if the link is a simple cycle of three or more neighbors, and the
  // cluster itself if the cycle is simple but shorter.
  Index first_link_defect(const Directed_edge start)
  {
    link_.clear();
    Index defect = NONE, loops = 0;
    along_link(start, [&](Index label) {
      const bool is_second_loop = Cluster_labels::is_cap(label) && ++loops > 1;
      if (!link_.insert(label) || is_second_loop)
        defect = label;
      return defect == NONE;
    });
    return defect == NONE && link_.size() < 3 ? labels_[start.face] : defect;
  }

private:
  // Visits the neighbors of the cluster of face `f` in the fan at `v`, except `front`. The boundary of the cluster arrives at `v`
  // along `front` and leaves `v` along `back`.
  template <class Visit>
  bool link_at(Index v, Index f, Index front, Index back, const Visit& visit)
  {
    if (front == back)
      return true;
    const Index apex = labels_[mesh_.star[mesh_.first_in_star[v]]];
    if (apex == labels_[f]) {
      clusters_around_vertex(labels_, v, runs_);
      for (std::size_t i = 2; i < runs_.size(); ++i)
        if (!visit(runs_[i]))
          return false;
      return true;
    }
    if (apex != front && apex != back && !visit(apex))
      return false;
    return visit(back);
  }

  // Returns the boundary edge that leaves `v`, given the boundary edge that arrives there. Turns clockwise over the faces of the
  // cluster, which are consecutive around `v`.
  Directed_edge turn(const Directed_edge e, Index v) const
  {
    Directed_edge leaving{e.face, mesh_.next_corner(e.face, e.corner)};
    while (labels_.label_across(leaving.corner) == labels_[e.face]) {
      const Index f = mesh_.face_across[leaving.corner];
      leaving = {f, mesh_.corner_of(f, v)};
    }
    return leaving;
  }

  const Cluster_labels& labels_;
  const Flat_mesh& mesh_;
  std::vector<Index> runs_;
  Label_set link_;
};

// Returns, for each side of a triangulated 2-manifold, the side of the same edge in the other triangle; NONE on the border. Side
// `3 t + i` goes from corner `i` of triangle `t` to the next corner. `source(side)` is the vertex where a side begins.
template <class Source>
std::vector<Index> opposite_sides(std::size_t triangles, std::size_t vertices, const Source& source)
{
  const auto target = [&](Index side) { return source(side % 3 == 2 ? side - 2 : side + 1); };
  const auto low = [&](Index side) { return (std::min)(source(side), target(side)); };
  const auto high = [&](Index side) { return (std::max)(source(side), target(side)); };
  const Bucketed_items<Index> by_low(numbers_below(Index(3 * triangles)), vertices, low);
  const Bucketed_items<Index> sorted(by_low.items(), vertices, high);
  std::vector<Index> opposite(3 * triangles, NONE);
  for (std::size_t k = 1; k < sorted.items().size(); ++k) {
    const Index s = sorted.items()[k - 1], r = sorted.items()[k];
    if (low(s) == low(r) && high(s) == high(r)) {
      opposite[s] = r;
      opposite[r] = s;
    }
  }
  return opposite;
}

typedef std::array<Index, 3> Triangle;

// Calls `visit(v, clusters)` for each vertex where three or more clusters meet, of all vertices or from `begin` to `end`.
// `clusters` are in counterclockwise order.
template <class Visit>
void for_each_meeting_point(const Cluster_labels& labels, const Visit& visit, Index begin = 0, Index end = NONE)
{
  std::vector<Index> runs;
  end = (std::min)(end, Index(labels.mesh().number_of_vertices()));
  for (Index v = begin; v < end; ++v) {
    if (labels.boundary_count(v) < 3)
      continue;
    clusters_around_vertex(labels, v, runs);
    if (Cluster_labels::is_cap(runs.back()))
      runs.pop_back();
    if (runs.size() > 2)
      visit(v, runs);
  }
}

// Returns the dual (section 8.3 of the paper) as triangles of cluster numbers, in the orientation of the mesh: a triangle for
// each vertex where three clusters meet, and a fan where more than three clusters meet.
inline std::vector<Triangle> dual_triangles(const Cluster_labels& labels, const Run_context& context = Run_context())
{
  std::vector<Triangle> triangles;
  for_each_part<std::vector<Triangle> >(
    context, labels.mesh().number_of_vertices(), 4096,
    [&](std::vector<Triangle>& part, std::size_t begin, std::size_t end) {
      part.clear();
      const auto add_fan = [&](Index, const std::vector<Index>& runs) {
        for (std::size_t i = 2; i < runs.size(); ++i)
          part.push_back({runs[0], runs[i - 1], runs[i]});
      };
      for_each_meeting_point(labels, add_fan, Index(begin), Index(end));
    },
    [&](const std::vector<Triangle>& part) { triangles.insert(triangles.end(), part.begin(), part.end()); });
  return triangles;
}

// The same for clusters of any origin: a fan that would repeat an edge gets another apex. If no apex avoids this, an exception is
// thrown; `name(x)` is the name of cluster `x` in its message.
template <class Name>
std::vector<Triangle> simplicial_dual_triangles(const Cluster_labels& labels, const Name& name)
{
  const auto side = [](Index a, Index b) { return (std::uint64_t(a) << 32) | b; };
  const auto edge = [&](Index a, Index b) { return side((std::min)(a, b), (std::max)(a, b)); };
  std::unordered_set<std::uint64_t> edges;
  for_each_meeting_point(labels, [&](Index, const std::vector<Index>& runs) {
    for (std::size_t i = 0; i < runs.size(); ++i)
      edges.insert(edge(runs[i], runs[(i + 1) % runs.size()]));
  });
  std::vector<Triangle> triangles;
  for_each_meeting_point(labels, [&](Index v, const std::vector<Index>& runs) {
    const std::size_t n = runs.size();
    std::size_t apex = 0;
    const auto repeats_edge = [&] {
      for (std::size_t i = 2; i + 1 < n; ++i)
        if (edges.count(edge(runs[apex], runs[(apex + i) % n])) != 0)
          return true;
      return false;
    };
    while (apex < n && repeats_edge())
      ++apex;
    if (apex == n)
      throw Invalid_input("the " + std::to_string(n) + " clusters around vertex " + std::to_string(v) + ", among them " +
                          name(runs[0]) + ", cannot be triangulated without repeating an edge");
    for (std::size_t i = 2; i < n; ++i) {
      triangles.push_back({runs[apex], runs[(apex + i - 1) % n], runs[(apex + i) % n]});
      if (i + 1 < n)
        edges.insert(edge(runs[apex], runs[(apex + i) % n]));
    }
  });
  std::vector<std::uint64_t> sides;
  sides.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      sides.push_back(side(t[i], t[(i + 1) % 3]));
  std::sort(sides.begin(), sides.end());
  const auto twice = std::adjacent_find(sides.begin(), sides.end());
  if (twice != sides.end())
    throw Invalid_input(name(Index(*twice >> 32)) + " and " + name(Index(*twice & NONE)) + " meet twice");
  return triangles;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_DUAL_TRIANGLES_H
