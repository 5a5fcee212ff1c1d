// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_ANY_CLUSTER_ENERGY_H
#define CGAL_SURFACE_MESH_COARSENING_ANY_CLUSTER_ENERGY_H

#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Weighted_inertia_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Typed_energy_model.h>

#include <memory>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningEnergies
/// An energy that a program chooses when it runs. `coarsen_mesh()`, `coarsen_mesh_to_distance()` and `Mwcvd_clustering` take it
/// as a `ClusterEnergy`, and the result is that of the energy it holds. They are then compiled once for all energies. The
/// minimization takes the same time, since it is compiled for each energy.
class Any_cluster_energy
{
public:
  /// holds the default energy.
  Any_cluster_energy() : Any_cluster_energy(Weighted_inertia_energy<Weighted_area_weight>()) {}

  /// holds a copy of an energy.
  /// \tparam Energy a model of `ClusterEnergy`
  template <class Energy>
  explicit Any_cluster_energy(const Energy& energy) : model_(internal::energy_model(energy))
  {}

  /// \cond SKIP_IN_MANUAL
  operator std::shared_ptr<const internal::Energy_model>() const { return model_; }
  /// \endcond

private:
  std::shared_ptr<const internal::Energy_model> model_;
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_ANY_CLUSTER_ENERGY_H
