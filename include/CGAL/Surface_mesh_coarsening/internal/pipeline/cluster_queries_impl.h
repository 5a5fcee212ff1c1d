// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_CLUSTER_QUERIES_IMPL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_CLUSTER_QUERIES_IMPL_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Minimization_state.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/cluster_queries.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>

namespace CGAL::Surface_mesh_coarsening::internal {

CGAL_SURFACE_MESH_COARSENING_INLINE std::vector<Cluster_report> cluster_reports(const Clustering_state& state,
                                                                                std::size_t faces)
{
  const std::size_t clusters = state.number_of_clusters();
  const Cluster_labels& current = labels(state);
  std::vector<Cluster_report> reports = state.energy->cluster_reports(state.working_input(), current, clusters);
  const Labelled_pieces pieces(state.featured_input(), current, clusters);
  const Clustered_faces clustered(pieces, clusters, state.context);
  for (std::size_t x = 0; x < clusters; ++x)
    reports[x].centroid = to_point(state.frame.to_mesh(clustered.cluster_centroid(x)));
  for (std::size_t f = 0; f < faces; ++f)
    ++reports[cluster_of_face(state, Index(f))].faces;
  return reports;
}

// Checks the cluster, and that the items of the clusters are the faces of the caller's mesh.
inline void check_move(const Clustering_state& state, std::size_t cluster)
{
  check_cluster(state, cluster);
  if (state.featured_input().cells || state.report.subdivided_components > 0)
    throw Invalid_input("single faces do not move where features are kept, or where faces are subdivided");
}

CGAL_SURFACE_MESH_COARSENING_INLINE bool boundary_counts_allow_move(const Clustering_state& state, Index face,
                                                                    std::size_t cluster)
{
  check_move(state, cluster);
  return labels(state)[face] != cluster && Valid_moves(*state.labels, nullptr).boundary_counts_allow(face, Index(cluster));
}

CGAL_SURFACE_MESH_COARSENING_INLINE bool guarantee_allows_move(Clustering_state& state, Index face, std::size_t cluster)
{
  check_move(state, cluster);
  return labels(state)[face] != cluster && Valid_moves(*state.labels, nullptr).may_move(face, Index(cluster));
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_CLUSTER_QUERIES_IMPL_H
