// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_DUAL_WALK_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_DUAL_WALK_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>

#include <algorithm>
#include <cstddef>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

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

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_DUAL_WALK_H
