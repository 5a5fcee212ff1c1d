// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DUAL_WALK_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DUAL_WALK_H

#include <CGAL/Surface_mesh_coarsening/internal/Cluster_labels.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// An edge seen from a face that lies on its left: the edge after corner `corner` of `face`.
struct Directed_edge
{
  Index face = NONE;
  Index corner = NONE;

  bool operator==(const Directed_edge& e) const { return corner == e.corner; }
};

// The runs of equal labels around a vertex, counterclockwise, the one beyond the border among them.
//
// In the dual triangulation a vertex with d >= 3 runs is a fan of d - 2 triangles. Its apex is the run of the first
// face of the star. So the dual triangulation is a function of the clusters, whatever their numbers are, and merging
// two clusters contracts an edge of it. On the border the first face is the clockwise end of the star, and the only
// triangle with the run beyond the border is the one of the two clusters that meet the border here.
inline void runs_around(const Cluster_labels& labels, Index v, std::vector<Index>& runs)
{
  const Flat_mesh& m = labels.mesh();
  runs.clear();
  for (Index i = m.first_in_star[v]; i != m.first_in_star[v + 1]; ++i) {
    const Index label = labels[m.star[i]];
    if (runs.empty() || runs.back() != label)
      runs.push_back(label);
  }
  if (m.is_on_border(v))
    runs.push_back(Cluster_labels::beyond_border + m.loop[v]);
  else if (runs.size() > 1 && runs.back() == runs.front())
    runs.pop_back(); // the apex, which is the first run, goes on over the end of the array
}

// Walks along the boundary of a cluster that is a closed disc, and tells which clusters follow each other around its
// vertex in the dual triangulation.
class Dual_walk
{
public:
  explicit Dual_walk(const Cluster_labels& labels) : labels_(labels), mesh_(labels.mesh()) {}

  // An edge of face `f` on the boundary of its cluster; none if there is none.
  Directed_edge boundary_edge(Index f) const
  {
    for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1]; ++c)
      if (labels_.label_across(c) != labels_[f])
        return {f, c};
    return {};
  }

  // Calls `at_vertex(v, runs)` for each vertex on the boundary of the cluster on the left of `start`: `runs` are the
  // labels around it, counterclockwise, from the one across the edge that arrives to the one across the edge that
  // leaves. Ends early if `at_vertex` returns false.
  template <class AtVertex>
  void along_boundary(const Directed_edge start, const AtVertex& at_vertex)
  {
    Directed_edge e = start;
    do {
      const Index v = mesh_.corner_vertex[mesh_.next_corner(e.face, e.corner)];
      e = turn(e, v);
      if (!at_vertex(v, runs_))
        return;
    } while (!(e == start));
  }

  // Calls `visit(label)` for each neighbor of the cluster in the dual triangulation, in order around it.
  template <class Visit>
  void along_link(const Directed_edge start, const Visit& visit)
  {
    const Index cluster = labels_[start.face];
    along_boundary(start, [&](Index v, const std::vector<Index>& runs) {
      return runs.size() < 2 || link_at(cluster, v, runs, visit);
    });
  }

  void collect_link(const Directed_edge start, std::vector<Index>& link)
  {
    link.clear();
    along_link(start, [&](Index label) { link.push_back(label); return true; });
  }

  // The neighbor that keeps the cluster on the left of `start` from having a simple link: one that comes twice, or
  // what lies beyond a second border loop. NONE if the link is a simple cycle of three or more neighbors; the
  // cluster itself if it is simple but shorter.
  Index fault_of_link(const Directed_edge start, std::vector<Index>& stamp_of_cluster, Index& stamp)
  {
    ++stamp;
    Index fault = NONE, length = 0, loops = 0;
    along_link(start, [&](Index label) {
      ++length;
      if (Cluster_labels::is_beyond_border(label)) {
        if (++loops > 1)
          fault = label;
      } else if (stamp_of_cluster[label] == stamp) {
        fault = label;
      } else {
        stamp_of_cluster[label] = stamp;
      }
      return fault == NONE;
    });
    return fault == NONE && length < 3 ? labels_[start.face] : fault;
  }

private:
  template <class Visit>
  bool link_at(Index cluster, Index v, const std::vector<Index>& runs, const Visit& visit) const
  {
    const Index apex = labels_[mesh_.star[mesh_.first_in_star[v]]];
    if (apex == cluster) {
      for (std::size_t i = 1; i < runs.size(); ++i)
        if (!visit(runs[i]))
          return false;
      return true;
    }
    if (apex != runs.front() && apex != runs.back() && !visit(apex))
      return false;
    return visit(runs.back());
  }

  // From the boundary edge that arrives at `v` to the one that leaves it, filling runs_ on the way.
  Directed_edge turn(const Directed_edge e, Index v)
  {
    const Index begin = mesh_.first_in_star[v], end = mesh_.first_in_star[v + 1], label = labels_[e.face];
    Index i = mesh_.position_in_star(v, e.face);
    runs_.clear();
    for (;;) {
      if (++i == end) {
        i = begin;
        if (mesh_.is_on_border(v))
          runs_.push_back(Cluster_labels::beyond_border + mesh_.loop[v]);
      }
      const Index here = labels_[mesh_.star[i]];
      if (here == label)
        return {mesh_.star[i], mesh_.corner_of(mesh_.star[i], v)};
      if (runs_.empty() || runs_.back() != here)
        runs_.push_back(here);
    }
  }

  const Cluster_labels& labels_;
  const Flat_mesh& mesh_;
  std::vector<Index> runs_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DUAL_WALK_H
