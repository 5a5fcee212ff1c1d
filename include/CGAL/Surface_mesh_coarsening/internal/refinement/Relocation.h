// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFINEMENT_RELOCATION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFINEMENT_RELOCATION_H

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The result of moving a cluster to another place.
enum class Relocation
{
  DONE,
  TOO_FAR,       // the distance would become too large
  NOT_FROM_HERE, // the cluster cannot go
  NOT_THERE      // there can be no other cluster where it shall go to
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFINEMENT_RELOCATION_H
