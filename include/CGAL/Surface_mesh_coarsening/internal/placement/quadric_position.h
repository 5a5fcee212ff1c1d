// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_QUADRIC_POSITION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_QUADRIC_POSITION_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Surface_mesh_coarsening::internal {

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

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_QUADRIC_POSITION_H
