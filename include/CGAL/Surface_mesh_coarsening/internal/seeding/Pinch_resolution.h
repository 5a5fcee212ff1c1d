// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_PINCH_RESOLUTION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_PINCH_RESOLUTION_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/cut_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Corner_truncation.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Turns pinched clusters into discs. A cluster is pinched at a vertex if it results from the merge of two clusters that met only
// in this vertex, that is, in an edge of its fan. Corners are cut off the faces of the other clusters and moved to the pinched
// cluster.
//
// The pinched cluster is the cluster of the first face around the vertex, the apex of the fan. The segments between its
// parts are cut off from the vertex, except the last segment, which contains the border if the vertex lies on it. Along the
// cuts, the cluster meets the other clusters in the order of the fan, so the dual is the contracted fan.
class Pinch_resolution
{
public:
  Pinch_resolution(const Clustering_input& input, const Cluster_labels& labels) : input_(input), labels_(labels) {}

  // Returns the input with the corners cut off. `new_labels` receives the labels of its faces.
  Clustering_input run(std::vector<Index>& new_labels)
  {
    const Flat_mesh& m = input_.mesh;
    is_cut_.assign(m.corner_vertex.size(), false);
    for (Index v = 0; v < m.number_of_vertices(); ++v)
      choose_corners(v);
    Corner_truncation cutting(m, is_cut_);
    Flat_mesh cut_mesh = cutting.run();
    new_labels.clear();
    for (std::size_t i = 0; i < cutting.old_face().size(); ++i) {
      const Index f = cutting.old_face()[i], c = cutting.old_corner()[i];
      new_labels.push_back(c == NONE ? labels_[f] : label_of_first(m.corner_vertex[c]));
    }
    return cut_input(input_, std::move(cut_mesh), cutting.old_face());
  }

private:
  Index label_of_first(Index v) const { return labels_[input_.mesh.star[input_.mesh.first_in_star[v]]]; }

  void choose_corners(Index v)
  {
    const Flat_mesh& m = input_.mesh;
    const Index begin = m.first_in_star[v], end = m.first_in_star[v + 1];
    if (begin == end)
      return;
    const Index pinched = label_of_first(v);
    // The last segment follows the last part of the cluster. At an inner vertex, the cluster may continue across the end of the
    // sequence.
    Index last = end;
    if (!m.is_on_border(v))
      while (last != begin && labels_[m.star[last - 1]] == pinched)
        --last;
    while (last != begin && labels_[m.star[last - 1]] != pinched)
      --last;
    for (Index i = begin; i != last; ++i)
      if (labels_[m.star[i]] != pinched)
        is_cut_[m.corner_of(m.star[i], v)] = true;
  }

  const Clustering_input& input_;
  const Cluster_labels& labels_;
  std::vector<bool> is_cut_; // per corner
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_PINCH_RESOLUTION_H
