// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_FACES_OF_CLUSTERS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_FACES_OF_CLUSTERS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Visitor_handle.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Returns a face of each cluster: the first one among the seeds, or otherwise the first of all.
inline std::vector<Index> faces_of_clusters(const Cluster_labels& labels, std::size_t clusters, const std::vector<Index>& seeds,
                                            const Cancellation_point& cancellation)
{
  std::vector<Index> result(clusters, NONE);
  const auto offer = [&](Index f) {
    Index& face = result[labels[f]];
    if (face == NONE)
      face = f;
  };
  std::for_each(seeds.begin(), seeds.end(), offer);
  for (std::size_t f = 0; f < labels.labels().size(); ++f) {
    cancellation.poll();
    offer(Index(f));
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_FACES_OF_CLUSTERS_H
