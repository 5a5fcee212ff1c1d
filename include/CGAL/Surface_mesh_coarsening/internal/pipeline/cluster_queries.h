// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_CLUSTER_QUERIES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_CLUSTER_QUERIES_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/Clustering_state.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Returns the statistics of the clusters of a mesh with `faces` faces.
std::vector<Cluster_report> cluster_reports(const Clustering_state& state, std::size_t faces);

// The answers of the two checks whether a face of the caller's mesh may join a cluster: the paper's check of boundary-edge counts
// and the guarantee. They throw if the items of the clustering are not faces.
bool boundary_counts_allow_move(const Clustering_state& state, Index face, std::size_t cluster);
bool guarantee_allows_move(Clustering_state& state, Index face, std::size_t cluster);

} // namespace CGAL::Surface_mesh_coarsening::internal

#ifndef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/cluster_queries_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_CLUSTER_QUERIES_H
