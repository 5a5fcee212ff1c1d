// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_QUADRIC_PLACEMENT_H
#define CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_QUADRIC_PLACEMENT_H

#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/face_geometry.h>

#include <Eigen/Core>
#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL {
namespace Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningPlacements
/// \cgalModels `VertexPlacement`
///
/// places the vertex of a cluster where the sum over its faces of area times squared distance from the plane of the face is
/// smallest (Valette, Kompatsiaris, Chassery: Adaptive polygonal mesh simplification with discrete centroidal Voronoi
/// diagrams, 2005): on edges and in corners where the cluster has some, and on the surface where it is curved.
///
/// Where the planes do not determine a position, in a plane and along a straight edge, it is the one nearest the centroid: a
/// small part of the squared distance from the centroid is added to the sum. The vertex does not go farther away from the
/// centroid of the cluster than its faces do.
class Quadric_placement
{
public:
  /// \param pull the weight of the squared distance from the centroid, relative to that from the planes; positive and at
  /// most 1.
  /// \throws Invalid_input if it is not.
  explicit Quadric_placement(double pull = 0.002) : pull_(pull)
  {
    if (!(pull > 0 && pull <= 1))
      throw Invalid_input("the pull towards the centroid is " + std::to_string(pull) + ", not in (0, 1]");
  }

  /// returns the position of the vertex of cluster `cluster`.
  Clustered_surface::Point operator()(const Clustered_surface& surface, std::size_t cluster) const
  {
    using namespace internal;
    const Vector center = surface.cluster_centroid(cluster);
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    double area = 0, radius = 0;
    for (const Index f : surface.faces(cluster)) {
      for (const Index v : surface.vertices(f)) {
        const Vector d = surface.point(v) - center;
        radius = (std::max)(radius, dot(d, d));
      }
      const Vector s = vector_area(surface.input().mesh, f);
      const double size = std::sqrt(dot(s, s));
      if (!(size > 0))
        continue;
      const Eigen::Vector3d n = Eigen::Vector3d(s[0], s[1], s[2]) / size;
      a += size * n * n.transpose();
      b += size * dot(s, surface.centroid(f) - center) / size * n;
      area += size;
    }
    if (!(area > 0))
      return center;
    a += pull_ * area * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d x = a.ldlt().solve(b);
    const double length = x.norm(), reach = std::sqrt(radius);
    return center + (length > reach ? reach / length : 1.) * Vector{{x[0], x[1], x[2]}};
  }

private:
  double pull_;
};

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_QUADRIC_PLACEMENT_H
