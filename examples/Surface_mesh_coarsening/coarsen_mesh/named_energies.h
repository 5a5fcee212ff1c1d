// SPDX-License-Identifier: GPL-3.0-or-later
//
// The energies that a user chooses by name, for the tool, the Python module and the viewer.

#ifndef COARSEN_MESH_NAMED_ENERGIES_H
#define COARSEN_MESH_NAMED_ENERGIES_H

#include <CGAL/Surface_mesh_coarsening/Any_cluster_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Normal_deviation_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Quadric_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Weighted_inertia_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Exact_maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>

#include <string>
#include <utility>
#include <vector>

namespace coarsen_mesh_tool {

typedef std::vector<std::pair<std::string, CGAL::Surface_mesh_coarsening::Any_cluster_energy> > Named_energies;

template <class Weight>
CGAL::Surface_mesh_coarsening::Any_cluster_energy weighted_energy()
{
  using namespace CGAL::Surface_mesh_coarsening;
  return Any_cluster_energy(Weighted_inertia_energy<Weight>());
}

// Returns the weighted energies with the names of their weights.
inline const Named_energies& weighted_energies()
{
  using namespace CGAL::Surface_mesh_coarsening;
  static const Named_energies all = {{"uniform", weighted_energy<Uniform_weight>()},
                                     {"area", weighted_energy<Weighted_area_weight>()},
                                     {"maximum", weighted_energy<Maximum_density_weight>()},
                                     {"exact-maximum", weighted_energy<Exact_maximum_density_weight>()},
                                     {"variance", weighted_energy<Density_variance_weight>()}};
  return all;
}

// Returns the default energy, which has a weight, and the energies without a weight.
inline const Named_energies& energies()
{
  using namespace CGAL::Surface_mesh_coarsening;
  static const Named_energies all = {{"weighted", Any_cluster_energy()},
                                     {"quadric", Any_cluster_energy(Quadric_energy())},
                                     {"normals", Any_cluster_energy(Normal_deviation_energy())}};
  return all;
}

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_NAMED_ENERGIES_H
