// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_KERNEL_POINT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_KERNEL_POINT_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>

#include <CGAL/Simple_cartesian.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Placements take and return points of a kernel. `Vector` states why all other code does not.
inline Simple_cartesian<double>::Point_3 to_point(const Vector& p) { return {p[0], p[1], p[2]}; }
inline Vector to_vector(const Simple_cartesian<double>::Point_3& p) { return {{p.x(), p.y(), p.z()}}; }

inline std::vector<Simple_cartesian<double>::Point_3> to_points(const std::vector<Vector>& positions)
{
  std::vector<Simple_cartesian<double>::Point_3> points;
  points.reserve(positions.size());
  for (const Vector& p : positions)
    points.push_back(to_point(p));
  return points;
}

inline std::vector<Vector> to_vectors(const std::vector<Simple_cartesian<double>::Point_3>& points)
{
  std::vector<Vector> positions;
  positions.reserve(points.size());
  for (const auto& p : points)
    positions.push_back(to_vector(p));
  return positions;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_KERNEL_POINT_H
