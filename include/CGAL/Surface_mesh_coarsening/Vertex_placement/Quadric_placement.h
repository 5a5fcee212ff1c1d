// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_QUADRIC_PLACEMENT_H
#define CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_QUADRIC_PLACEMENT_H

#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/quadric_position.h>

#include <cstddef>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningPlacements
/// \cgalModels `VertexPlacement`
///
/// places the vertex of a cluster at the minimum of the sum over its faces of area times squared distance from the plane of
/// the face (Valette, Kompatsiaris, Chassery: Adaptive polygonal mesh simplification with discrete centroidal Voronoi
/// diagrams, 2005). The vertex lies on sharp edges and corners of the cluster, and on curved surfaces.
///
/// In planar regions and along straight edges, the planes do not determine the position. There the vertex is close to the
/// centroid, because a small multiple of the squared distance from the centroid is added to the sum. The vertex is never farther
/// from the centroid of the cluster than the faces of the cluster are.
class Quadric_placement
{
public:
  /// may be called by several threads at a time.
  static constexpr bool may_run_in_parallel = true;

  /// the default value of `pull`.
  static constexpr double default_pull = 0.002;

  /// \param pull the weight of the squared distance from the centroid relative to the distances from the planes,
  /// positive and at most 1
  /// \throws Invalid_input if `pull` is out of range.
  explicit Quadric_placement(double pull = default_pull) : pull_(pull)
  {
    if (!(pull > 0 && pull <= 1))
      throw Invalid_input("the pull towards the centroid is " + internal::number_text(pull) + ", not in (0, 1]");
  }

  /// returns the position of the vertex of cluster `cluster`.
  Clustered_surface::Point_3 operator()(const Clustered_surface& surface, std::size_t cluster) const
  {
    return internal::to_point(internal::quadric_position(surface.clusters(), cluster, pull_));
  }

private:
  double pull_;
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_QUADRIC_PLACEMENT_H
