// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_CENTROID_PLACEMENT_H
#define CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_CENTROID_PLACEMENT_H

#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningPlacements
/// \cgalModels `VertexPlacement`
///
/// places the vertex of a cluster at its centroid (section 8.3 of the paper).
class Centroid_placement
{
public:
  /// may be called by several threads at a time.
  static constexpr bool may_run_in_parallel = true;

  /// returns the position of the vertex of cluster `cluster`.
  Clustered_surface::Point_3 operator()(const Clustered_surface& surface, std::size_t cluster) const
  {
    return surface.cluster_centroid(cluster);
  }
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_CENTROID_PLACEMENT_H
