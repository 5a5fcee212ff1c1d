// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_FACES_IN_BFS_ORDER_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_FACES_IN_BFS_ORDER_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The faces of the cluster of face `f` in the order of a breadth-first walk from there, in time that depends on the cluster
// alone: the labels serve as marks on the way.
inline std::vector<Index> faces_in_bfs_order(Cluster_labels& labels, Index f)
{
  const Flat_mesh& m = labels.mesh();
  const Index x = labels[f];
  std::vector<Index> queue(1, f);
  labels.set(f, NONE);
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (Index c = m.first_corner[queue[i]]; c != m.first_corner[queue[i] + 1]; ++c) {
      const Index g = m.face_across[c];
      if (g != NONE && labels[g] == x) {
        labels.set(g, NONE);
        queue.push_back(g);
      }
    }
  for (const Index g : queue)
    labels.set(g, x);
  return queue;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_FACES_IN_BFS_ORDER_H
