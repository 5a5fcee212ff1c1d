// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_CLOSEST_VERTEX_PLACEMENT_H
#define CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_CLOSEST_VERTEX_PLACEMENT_H

#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningPlacements
/// \cgalModels `VertexPlacement`
///
/// places the vertex of a cluster at the vertex of its faces that is closest to its centroid (Valette and Chassery:
/// Approximated centroidal Voronoi diagrams for uniform polygonal mesh coarsening, 2004). A vertex on the boundary to another
/// cluster is used only if the cluster has no other vertices.
class Closest_vertex_placement
{
public:
  /// may be called by several threads at a time.
  static constexpr bool may_run_in_parallel = true;
  /// places vertices at vertices of the input, which the repair preserves.
  static constexpr bool is_at_input_vertices = true;

  /// returns the position of the vertex of cluster `cluster`.
  Clustered_surface::Point_3 operator()(const Clustered_surface& surface, std::size_t cluster) const
  {
    const Clustered_surface::Point_3 center = surface.cluster_centroid(cluster);
    double nearest[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Clustered_surface::Point_3 position[2] = {center, center};
    for (const std::uint32_t f : surface.faces(cluster))
      for (const std::uint32_t v : surface.vertices(f)) {
        const bool shared = surface.is_on_cluster_boundary(v);
        const double d = squared_distance(surface.point(v), center);
        if (d < nearest[shared]) {
          nearest[shared] = d;
          position[shared] = surface.point(v);
        }
      }
    return nearest[0] < std::numeric_limits<double>::infinity() ? position[0] : position[1];
  }
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_CLOSEST_VERTEX_PLACEMENT_H
