// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_QUADRIC_PLACEMENT_H
#define CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_QUADRIC_PLACEMENT_H

#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/face_geometry.h>

#include <Eigen/Core>
#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
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
  /// may be called by several threads at a time.
  static constexpr bool may_run_in_parallel = true;

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
    // One pass over the faces, with sums about a point of the first one.
    const Vector origin = surface.centroid(*surface.faces(cluster).begin());
    Vector moment{{0, 0, 0}}, b{{0, 0, 0}};
    double mass = 0, area = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    for (const Index f : surface.faces(cluster)) {
      const Vector at = surface.centroid(f) - origin, s = vector_area(surface.input().mesh, f);
      const double size = std::sqrt(dot(s, s)), face_mass = surface.input().mass(f);
      moment = moment + face_mass * at;
      mass += face_mass;
      if (!(size > 0))
        continue;
      const Vector n = (1 / size) * s;
      b = b + dot(n, at) * s;
      area += size;
      xx += s[0] * n[0];
      xy += s[0] * n[1];
      xz += s[0] * n[2];
      yy += s[1] * n[1];
      yz += s[1] * n[2];
      zz += s[2] * n[2];
    }
    if (!(area > 0) || !(mass >= (std::numeric_limits<double>::min)()))
      return surface.cluster_centroid(cluster);
    const Vector center = (1 / mass) * moment;
    Eigen::Matrix3d a;
    a << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    const Eigen::Vector3d right =
      Eigen::Vector3d(b[0], b[1], b[2]) - a * Eigen::Vector3d(center[0], center[1], center[2]);
    a.diagonal().array() += pull_ * area;
    const Eigen::Vector3d x = a.ldlt().solve(right);
    const double share = share_within_reach(surface, cluster, origin + center, x.squaredNorm());
    return surface.within_bounds(cluster, origin + center + share * Vector{{x[0], x[1], x[2]}});
  }

private:
  // The part of a movement away from the centroid, 1 or less, that does not lead farther than the faces go.
  static double share_within_reach(const Clustered_surface& surface, std::size_t cluster,
                                   const Clustered_surface::Point& center, double square)
  {
    using namespace internal;
    double reach = 0;
    for (const Index f : surface.faces(cluster))
      for (const Index v : surface.vertices(f)) {
        const Vector d = surface.point(v) - center;
        reach = (std::max)(reach, dot(d, d));
        if (reach >= square)
          return 1;
      }
    return std::sqrt(reach / square);
  }

  double pull_;
};

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_QUADRIC_PLACEMENT_H
