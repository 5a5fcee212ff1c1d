// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_DUAL_SURFACE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_DUAL_SURFACE_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The dual of the clusters of a component: a closed triangulated surface whose vertices are the clusters and the caps of the
// border loops. The contraction of an edge merges two clusters without access to their faces.
//
// The dual remains a simplicial surface of the same topology if an edge is contracted only where its ends have exactly
// two common neighbors (the link condition; Dey, Edelsbrunner, Guha, Nekhayev: Topology preserving edge contraction,
// 1999). Two border loops remain separate if no cluster touches both.
class Dual_surface
{
public:
  typedef Index Edge; // halfedge 3 t + i goes from corner i of triangle t to the next corner

  // The clusters of the faces `faces` of a component are valid and numbered from 0.
  template <class FaceRange>
  Dual_surface(const Cluster_labels& labels, const FaceRange& faces, Index clusters, const Run_context& context = Run_context())
    : clusters_(clusters)
  {
    add_triangles(labels, faces, context);
    for (Edge e = Edge(source_.size()); e-- > 0;)
      edge_of_[source_[e]] = e;
    opposite_ = opposite_sides(source_.size() / 3, edge_of_.size(), [this](Edge e) { return source_[e]; });
    CGAL_assertion(std::find(opposite_.begin(), opposite_.end(), NONE) == opposite_.end());
    stamp_of_.assign(edge_of_.size(), 0);
    loop_of_.assign(clusters, NONE);
    for (Edge e = 0; e < source_.size(); ++e)
      if (is_cap(source_[e]) && !is_cap(target(e)))
        loop_of_[target(e)] = source_[e];
  }

  std::size_t number_of_triangles() const { return source_.size() / 3; }
  bool is_triangle(Index t) const { return source_[3 * t] != NONE; }
  bool is_cap(Index x) const { return x >= clusters_; }

  // The vertex of the mesh around which the clusters of a triangle lie.
  Index vertex(Index t) const { return vertex_[t]; }

  static Edge next(Edge e) { return e % 3 == 2 ? e - 2 : e + 1; }
  static Edge previous(Edge e) { return e % 3 == 0 ? e + 2 : e - 1; }
  Index source(Edge e) const { return source_[e]; }
  Index target(Edge e) const { return source_[next(e)]; }
  Edge opposite(Edge e) const { return opposite_[e]; }
  // Returns whether the clusters at the ends meet in an arc, not only in the fan around a vertex of the mesh.
  bool is_arc(Edge e) const { return is_arc_[e]; }

  // Calls `visit(e)` for each edge that leaves `x`.
  template <class Visit>
  void for_each_edge_from(Index x, const Visit& visit) const
  {
    Edge e = edge_of_[x];
    do {
      visit(e);
      e = opposite_[previous(e)];
    } while (e != edge_of_[x]);
  }

  // Returns whether the two clusters at the ends of an edge may be merged.
  bool may_contract(Edge e)
  {
    const Index a = source_[e], b = target(e);
    if (is_cap(a) || is_cap(b))
      return false;
    if (loop_of_[a] != NONE && loop_of_[b] != NONE && loop_of_[a] != loop_of_[b])
      return false;
    ++stamp_;
    std::size_t of_a = 0, of_b = 0, common = 0;
    for_each_edge_from(a, [&](Edge f) {
      stamp_of_[target(f)] = stamp_;
      ++of_a;
    });
    for_each_edge_from(b, [&](Edge f) {
      common += stamp_of_[target(f)] == stamp_;
      ++of_b;
    });
    // The link of the merged cluster needs three neighbors.
    return common == 2 && of_a + of_b >= 7 && !tip_is_enclosed(e) && !tip_is_enclosed(opposite_[e]);
  }

  // Merges the ends of `e`. The merged cluster keeps the number of the source of `e`.
  void contract(Edge e)
  {
    const Index kept = source_[e], gone = target(e);
    const Edge o = opposite_[e];
    for_each_edge_from(gone, [&](Edge f) { source_[f] = kept; });
    if (loop_of_[kept] == NONE)
      loop_of_[kept] = loop_of_[gone];
    edge_of_[kept] = remove_triangle(e);
    remove_triangle(o);
    edge_of_[gone] = NONE;
  }

private:
  // Returns whether the third cluster of the triangle of `e` meets the two clusters at the ends of `e` in arcs, and no other
  // clusters in arcs. In this case the two clusters must not be merged: the merged cluster would touch itself at the vertex whose
  // fan contributes the other neighbors of the third cluster.
  bool tip_is_enclosed(Edge e) const
  {
    const Index tip = source_[previous(e)];
    if (is_cap(tip) || !is_arc_[next(e)] || !is_arc_[previous(e)])
      return false;
    std::size_t arcs = 0;
    Edge f = previous(e);
    do {
      arcs += is_arc_[f] ? 1 : 0;
      f = opposite_[previous(f)];
    } while (f != previous(e) && arcs <= 2);
    return arcs == 2;
  }

  // Removes the triangle of `e` and glues its two other edges. Returns a glued edge that leaves the source of `e`.
  Edge remove_triangle(Edge e)
  {
    const Edge first = opposite_[next(e)], second = opposite_[previous(e)]; // from the tip, and to the tip
    const Index tip = source_[previous(e)];
    CGAL_assertion(source_[first] == tip && source_[second] == source_[e]);
    opposite_[first] = second;
    opposite_[second] = first;
    is_arc_[first] = is_arc_[second] = is_arc_[first] || is_arc_[second];
    edge_of_[tip] = first;
    for (Edge f : {e, next(e), previous(e)})
      source_[f] = NONE;
    return second;
  }

  template <class FaceRange>
  void add_triangles(const Cluster_labels& labels, const FaceRange& faces, const Run_context& context)
  {
    const Flat_mesh& m = labels.mesh();
    struct Fan_triangle
    {
      Triangle corners;
      Index vertex;
      bool is_first, is_last;
    };
    for_each_part<std::vector<Fan_triangle> >(
      context, faces.size(), 4096,
      [&](std::vector<Fan_triangle>& part, std::size_t begin, std::size_t end) {
        part.clear();
        std::vector<Index> runs;
        for (auto f = faces.begin() + begin; f != faces.begin() + end; ++f)
          for (const Index c : m.corners(*f)) {
            const Index v = m.corner_vertex[c];
            if (m.star[m.first_in_star[v]] != *f)
              continue; // the star of the vertex begins at another face
            clusters_around_vertex(labels, v, runs);
            for (std::size_t i = 2; i < runs.size(); ++i)
              part.push_back({{runs[0], runs[i - 1], runs[i]}, v, i == 2, i + 1 == runs.size()});
          }
      },
      [&](const std::vector<Fan_triangle>& part) {
        for (const Fan_triangle& t : part) {
          source_.insert(source_.end(), t.corners.begin(), t.corners.end());
          vertex_.push_back(t.vertex);
          is_arc_.insert(is_arc_.end(), {t.is_first, true, t.is_last});
        }
      });
    // The loops of the component are numbered after the clusters.
    std::vector<Index> loops;
    std::copy_if(source_.begin(), source_.end(), std::back_inserter(loops), Cluster_labels::is_cap);
    sort_unique(loops);
    for (Index& x : source_)
      if (Cluster_labels::is_cap(x))
        x = clusters_ + Index(std::lower_bound(loops.begin(), loops.end(), x) - loops.begin());
    edge_of_.assign(clusters_ + loops.size(), NONE);
  }

  Index clusters_;
  std::vector<Index> source_;   // per edge; NONE if the triangle is removed
  std::vector<Index> vertex_;   // per triangle
  std::vector<Edge> opposite_;
  std::vector<char> is_arc_;    // per edge
  std::vector<Edge> edge_of_;   // an edge that leaves each vertex
  std::vector<Index> loop_of_;  // the loop that each cluster touches
  std::vector<Index> stamp_of_;
  Index stamp_ = 0;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_DUAL_SURFACE_H
