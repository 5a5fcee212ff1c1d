// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_MINIMIZATION_STATE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_MINIMIZATION_STATE_H

#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_rules.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Boundary_edges.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_evaluation.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The data that the blocks of a minimization share. Each block reads and writes the parts of its own clusters.
template <class Energy>
struct Minimization_state
{
  const Clustering_input& input;
  Cluster_labels& labels;
  Energy_evaluation<Energy> energy;
  std::vector<Cluster_sums<Energy> > clusters;
  std::vector<Move_time> last_change; // of each cluster, and of `nowhere()`
  Listed_edges listed;
  Feature_rules* rules; // null without features
  // For each vertex, whether clusters of several blocks meet there; empty if there is only one block.
  std::vector<char> is_shared;
  bool checks_boundary_counts = false; // whether moves must also pass the paper's check

  // The index that stands for no cluster.
  Index nowhere() const { return Index(clusters.size()); }
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_MINIMIZATION_STATE_H
