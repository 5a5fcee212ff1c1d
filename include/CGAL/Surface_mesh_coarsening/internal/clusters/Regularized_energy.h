// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_REGULARIZED_ENERGY_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_REGULARIZED_ENERGY_H

#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Clustered_face.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/number_text.h>

#include <cmath>
#include <string>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The base class of energies that measure planes, to which a multiple of the inertia is added.
class Regularized_energy
{
public:
  struct Face_data
  {
    double mass;
    Vector centroid, normal;
  };

  Face_data face_data(const Clustered_face& face) const { return {face.mass(), face.plain_centroid(), face.plain_normal()}; }

protected:
  Regularized_energy(double regularization, const std::string& energy) : regularization_(regularization)
  {
    if (!(regularization > 0) || std::isinf(regularization))
      throw Invalid_input("the regularization of the " + energy + " is " + number_text(regularization));
  }

  double regularization_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_REGULARIZED_ENERGY_H
