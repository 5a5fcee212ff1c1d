// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_MODEL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_MODEL_H

#include <CGAL/Surface_mesh_coarsening/Cluster_report.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Featured_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Minimization.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The energy of a clustering with its type erased: the stages of the pipeline are compiled once for all energies.
class Energy_model
{
public:
  virtual ~Energy_model() = default;
  virtual std::unique_ptr<Minimization> minimization(const Featured_input& input, Cluster_labels& labels,
                                                     std::size_t clusters, bool checks_boundary_counts,
                                                     const Cancellation_point& cancellation,
                                                     Execution execution) const = 0;
  // Computes the energies and weights of the clusters; the other members remain empty.
  virtual std::vector<Cluster_report> cluster_reports(const Clustering_input& input, const Cluster_labels& labels,
                                                      std::size_t clusters) const = 0;
  virtual bool depends_on_densities() const = 0;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_MODEL_H
