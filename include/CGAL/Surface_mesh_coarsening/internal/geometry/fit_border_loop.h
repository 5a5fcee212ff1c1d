// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_FIT_BORDER_LOOP_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_FIT_BORDER_LOOP_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Border_fit.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Chooses the vertices of the clusters along a border loop. `cluster_after` holds, for each point of the loop, the cluster of the
// edge after it. `make_arc(places, cluster)` returns the arc of a cluster, and `set_vertex(cluster, point)` receives the result.
template <class MakeArc, class SetVertex>
void fit_border_loop(const std::vector<Index>& cluster_after, const MakeArc& make_arc, const SetVertex& set_vertex)
{
  const std::size_t n = cluster_after.size();
  std::size_t begin = 0; // the begin of a part of the loop that belongs to one cluster
  while (begin < n && cluster_after[begin] == cluster_after[(begin + n - 1) % n])
    ++begin;
  std::vector<Border_arc> arcs;
  std::vector<Index> clusters;
  for (std::size_t i = 0; i < n;) {
    clusters.push_back(cluster_after[(begin + i) % n]);
    std::vector<std::size_t> places;
    do
      places.push_back((begin + i++) % n);
    while (i < n && cluster_after[(begin + i) % n] == clusters.back());
    places.push_back((begin + i) % n);
    arcs.push_back(make_arc(places, clusters.back()));
  }
  const std::vector<std::size_t> chosen = Border_fit(arcs).run();
  for (std::size_t k = 0; k < arcs.size(); ++k)
    set_vertex(clusters[k], arcs[k][chosen[k]]);
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_FIT_BORDER_LOOP_H
