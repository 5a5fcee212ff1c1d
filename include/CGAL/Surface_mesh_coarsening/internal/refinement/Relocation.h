// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFINEMENT_RELOCATION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFINEMENT_RELOCATION_H

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The result of the relocation of a cluster.
enum class Relocation
{
  DONE,
  TOO_FAR,       // the distance would become too large
  NOT_FROM_HERE, // the cluster cannot be removed from its place
  NOT_THERE      // no cluster can be formed at the destination
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFINEMENT_RELOCATION_H
