// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_FACES_IN_BFS_ORDER_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_FACES_IN_BFS_ORDER_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/flood_fill.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Returns the faces of the cluster of face `f` in breadth-first order from `f`. The labels temporarily serve as marks, so the
// time depends only on the cluster.
inline std::vector<Index> faces_in_bfs_order(Cluster_labels& labels, Index f)
{
  const Flat_mesh& m = labels.mesh();
  const Index x = labels[f];
  std::vector<Index> faces;
  labels.set(f, NONE);
  flood_fill(m, f, faces, Cancellation_point(), [&](Index, Index g) {
    if (labels[g] != x)
      return false;
    labels.set(g, NONE);
    return true;
  });
  for (const Index g : faces)
    labels.set(g, x);
  return faces;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_FACES_IN_BFS_ORDER_H
