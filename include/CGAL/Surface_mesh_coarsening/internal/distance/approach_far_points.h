// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_APPROACH_FAR_POINTS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_APPROACH_FAR_POINTS_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// A point of a triangle of the coarse mesh that is far from a point of the mesh, which lies at the offset from it. One of the two
// is the point of its surface nearest to the other.
struct Far_point
{
  Index triangle;
  Vector barycentric, offset;
};

// Moves vertices so that far points come nearer than `distance`. Vertices on the border stay.
inline void approach_far_points(const std::vector<Far_point>& far, double distance, const Clustered_faces& surface,
                                const Border_arcs& border, const std::vector<Triangle>& triangles, std::vector<Vector>& positions)
{
  // A vertex between several far points cannot approach all of them at once.
  constexpr double goal = 0.8;
  std::vector<Vector> moves(positions.size(), Vector{{0, 0, 0}});
  for (const Far_point& p : far) {
    const double part = 1 - goal * distance / std::sqrt(dot(p.offset, p.offset));
    for (int i = 0; i < 3; ++i) {
      const Vector move = part * p.barycentric[i] / dot(p.barycentric, p.barycentric) * p.offset;
      Vector& longest = moves[triangles[p.triangle][i]];
      if (dot(move, move) > dot(longest, longest))
        longest = move;
    }
  }
  for (std::size_t x = 0; x < moves.size(); ++x)
    if (!border.is_on_border(x))
      positions[x] = surface.within_bounds(x, positions[x] + moves[x]);
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_APPROACH_FAR_POINTS_H
