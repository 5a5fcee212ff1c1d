// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_CLUSTER_LABELS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_CLUSTER_LABELS_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <unordered_map>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The labels of the faces, the paper's boundary-edge count of each vertex (section 7), and the tests that keep every
// cluster a closed disc.
//
// Each border loop is capped by an additional cluster with label `cap` plus the number of the loop; no face has this label.
// Hence a border edge is an edge between two clusters, and the count of a vertex is either zero or the number of runs of equal
// labels around it.
class Cluster_labels
{
public:
  static constexpr Index cap = NONE / 2 + 1;
  static bool is_cap(Index label) { return label >= cap && label != NONE; }

  explicit Cluster_labels(const Flat_mesh& mesh)
    : mesh_(mesh), label_(mesh.number_of_faces(), NONE), boundary_count_(mesh.number_of_vertices(), 0)
  {
    for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      if (is_hub(Index(v)))
        faces_at_hub_[Index(v)];
  }

  const Flat_mesh& mesh() const { return mesh_; }
  Index operator[](Index f) const { return label_[f]; }
  void set(Index f, Index label)
  {
    if (!faces_at_hub_.empty())
      count_at_hubs(f, label);
    label_[f] = label;
  }
  const std::vector<Index>& labels() const { return label_; }
  // Returns whether faces may neither join nor leave a cluster.
  bool is_frozen(Index label) const { return label < is_frozen_.size() && is_frozen_[label]; }
  void freeze(Index label, bool is_frozen)
  {
    if (is_frozen && label >= is_frozen_.size())
      is_frozen_.resize(label + 1, false);
    if (label < is_frozen_.size())
      is_frozen_[label] = is_frozen;
  }
  // Returns whether a face may not change its cluster.
  bool is_pinned(Index f) const { return !is_pinned_.empty() && is_pinned_[f]; }
  void pin(Index f)
  {
    is_pinned_.resize(label_.size(), false);
    is_pinned_[f] = true;
  }
  Index boundary_count(Index v) const { return boundary_count_[v]; }
  const std::vector<Index>& boundary_counts() const { return boundary_count_; }

  // Returns the label on the other side of the edge after corner `c`.
  Index label_across(Index c) const
  {
    const Index g = mesh_.face_across[c];
    return g == NONE ? cap + mesh_.loop[mesh_.corner_vertex[c]] : label_[g];
  }

  bool touches(Index v, Index label) const
  {
    if (is_hub(v))
      return faces_at_hub_.find(v)->second.count(label) != 0;
    for (const Index f : mesh_.faces_around(v))
      if (label_[f] == label)
        return true;
    return false;
  }

  // Returns whether cluster `to`, a closed disc, remains a closed disc if face `f` joins: the part of the boundary of the face
  // that touches the cluster must be one arc that contains an edge and is not the whole boundary.
  bool stays_disc_with(Index f, Index to) const
  {
    return is_one_arc(f, [&](Index across) { return across == to; }, [&](Index v) { return touches(v, to); });
  }

  // Returns whether the cluster of face `f`, a closed disc, remains a closed disc if the face leaves: the part of the boundary of
  // the face on the boundary of the cluster must be one arc and not the whole boundary.
  bool stays_disc_without(Index f) const
  {
    const Index from = label_[f];
    return is_one_arc(
      f, [&](Index across) { return across != from; },
      [&](Index v) { return boundary_count_[v] != 0; }); // 0: case 0 of the paper
  }

  // Moves face `f` to another cluster and updates the counts of its vertices. The time depends only on the degree of the face.
  void move(Index f, Index to)
  {
    const Index from = label_[f];
    for (const Index c : mesh_.corners(f)) {
      const Index across = label_across(c);
      const Index before = across != from, after = across != to;
      boundary_count_[mesh_.corner_vertex[c]] += after - before;
      boundary_count_[mesh_.corner_vertex[mesh_.next_corner(f, c)]] += after - before;
    }
    set(f, to);
  }

  // Moves each face to its cluster in `labels`, as `move()` does.
  void move_all(const std::vector<Index>& labels)
  {
    for (std::size_t f = 0; f < labels.size(); ++f)
      if (label_[f] != labels[f])
        move(Index(f), labels[f]);
  }

  std::vector<Index> recounted() const
  {
    std::vector<Index> count(mesh_.number_of_vertices(), 0);
    for (std::size_t f = 0; f < label_.size(); ++f)
      for (const Index c : mesh_.corners(f))
        if (label_across(c) != label_[f]) {
          ++count[mesh_.corner_vertex[c]];
          // The other face of an inner edge counts its other end; a border edge has no other face.
          if (mesh_.face_across[c] == NONE)
            ++count[mesh_.corner_vertex[mesh_.next_corner(Index(f), c)]];
        }
    return count;
  }
  void recount() { boundary_count_ = recounted(); }

private:
  // A walk around a vertex of high valence, a hub, for each of its faces would take quadratic time. At a hub, the faces of each
  // label are counted instead, separately for each hub: threads that move faces at different hubs change different counts.
  static constexpr Index hub_valence = 64;
  bool is_hub(Index v) const { return mesh_.first_in_star[v + 1] - mesh_.first_in_star[v] > hub_valence; }
  typedef std::unordered_map<Index, Index> Faces_of_labels;

  // Returns whether the part of the boundary of face `f` that has the edges with `has_edge(label across)` and the vertices with
  // `has_vertex(v)` is one arc that contains an edge and is not the whole boundary.
  template <class Has_edge, class Has_vertex>
  bool is_one_arc(Index f, const Has_edge& has_edge, const Has_vertex& has_vertex) const
  {
    const Index begin = mesh_.first_corner[f], end = mesh_.first_corner[f + 1];
    Index edges = 0, arcs_begun = 0;
    bool previous = has_edge(label_across(end - 1));
    for (Index c = begin; c != end; ++c) {
      const bool edge = has_edge(label_across(c));
      edges += edge;
      // A vertex belongs to the part with either of its edges, or by itself.
      if (!previous && (edge || has_vertex(mesh_.corner_vertex[c])))
        ++arcs_begun;
      if (arcs_begun > 1)
        return false;
      previous = edge;
    }
    return edges > 0 && edges < end - begin && arcs_begun == 1;
  }

  void count_at_hubs(Index f, Index label)
  {
    for (const Index c : mesh_.corners(f)) {
      const Index v = mesh_.corner_vertex[c];
      if (!is_hub(v))
        continue;
      Faces_of_labels& faces = faces_at_hub_.find(v)->second;
      if (label_[f] != NONE) {
        const auto i = faces.find(label_[f]);
        if (--i->second == 0)
          faces.erase(i);
      }
      if (label != NONE)
        ++faces[label];
    }
  }

  const Flat_mesh& mesh_;
  std::vector<Index> label_;
  std::vector<Index> boundary_count_;
  std::vector<bool> is_frozen_; // per cluster, for the first clusters
  std::vector<bool> is_pinned_; // per face; empty if no face is pinned
  std::unordered_map<Index, Faces_of_labels> faces_at_hub_;
};

// Returns the faces of the cluster of face `f` in breadth-first order from `f`. The labels temporarily serve as marks, so the
// time depends only on the cluster.
inline std::vector<Index> faces_in_bfs_order(Cluster_labels& labels, Index f)
{
  const Flat_mesh& m = labels.mesh();
  const Index x = labels[f];
  std::vector<Index> faces;
  labels.set(f, NONE);
  flood_fill(m, f, faces, Run_context(), [&](Index, Index g) {
    if (labels[g] != x)
      return false;
    labels.set(g, NONE);
    return true;
  });
  for (const Index g : faces)
    labels.set(g, x);
  return faces;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_CLUSTER_LABELS_H
