// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_QUADRIC_PLACEMENT_H
#define CGAL_SURFACE_MESH_COARSENING_VERTEX_PLACEMENT_QUADRIC_PLACEMENT_H

#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Surface_mesh_coarsening {

namespace internal {

// Returns the largest fraction, at most 1, of a movement away from the centroid that does not leave the extent of the faces.
inline double share_within_reach(const Clustered_faces& surface, std::size_t cluster,
                                 const Vector& center, double square)
{
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

// The position that minimizes the quadric of a cluster: see `Quadric_placement`.
inline Vector quadric_position(const Clustered_faces& surface, std::size_t cluster, double pull)
{
  // A single pass over the faces, with sums about a point of the first face.
  const Vector origin = surface.centroid(*surface.faces(cluster).begin());
  Vector moment{{0, 0, 0}}, b{{0, 0, 0}};
  double mass = 0, area = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  for (const Index f : surface.faces(cluster)) {
    const Vector at = surface.centroid(f) - origin, s = vector_area(surface.input().mesh, f);
    const double size = length(s), face_mass = surface.input().mass(f);
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
  a.diagonal().array() += pull * area;
  const Eigen::Vector3d x = a.ldlt().solve(right);
  const double share = share_within_reach(surface, cluster, origin + center, x.squaredNorm());
  return surface.within_bounds(cluster, origin + center + share * Vector{{x[0], x[1], x[2]}});
}

} // namespace internal

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
