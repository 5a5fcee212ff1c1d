// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_LOCAL_FRAME_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_LOCAL_FRAME_H

#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/Index.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/Visitor_handle.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/number_text.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Pairs of points in coordinates of the arrays, sorted, and in coordinates of the mesh.
typedef std::vector<std::pair<Vector, Vector> > Exact_points;

// The frame of the arrays: point of the mesh = origin + 2^exponent * coordinates, exact for the listed points.
struct Local_frame
{
  Vector origin{{0, 0, 0}};
  int exponent = 0;
  std::shared_ptr<const Exact_points> exact;

  // Converts from coordinates of the mesh to coordinates of the arrays.
  Vector to_local(const Vector& p) const
  {
    Vector q;
    for (std::size_t i = 0; i < 3; ++i)
      q[i] = exponent == 0 ? p[i] - origin[i] : std::ldexp(p[i] - origin[i], -exponent);
    return q;
  }

  // The inverse conversion. Near the end of the range of double, positions outside the mesh may overflow; they are clamped to the
  // largest number.
  Vector to_mesh(const Vector& p) const
  {
    if (exact) {
      const auto is_before = [](const Exact_points::value_type& known, const Vector& v) { return known.first < v; };
      const auto known = std::lower_bound(exact->begin(), exact->end(), p, is_before);
      if (known != exact->end() && known->first == p)
        return known->second;
    }
    constexpr double largest = (std::numeric_limits<double>::max)();
    Vector q;
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = origin[i] + (exponent == 0 ? p[i] : std::ldexp(p[i], exponent));
      q[i] = (std::min)((std::max)(x, -largest), largest);
    }
    return q;
  }

  // Convert lengths and areas.
  double length_to_local(double length) const { return std::ldexp(length, -exponent); }
  double length_to_mesh(double length) const { return std::ldexp(length, exponent); }
  double area_to_local(double area) const { return std::ldexp(area, -2 * exponent); }
};

// Translates the points to the center of their bounding box, so that energies do not lose digits if the mesh is far from the
// origin. If the sixth power of the size would exceed the range of double, the points are scaled to a size of about 1 by a
// power of two, which causes no rounding.
inline Local_frame to_local_frame(std::vector<Vector>& points, const std::vector<Index>& first_in_star,
                            const Cancellation_point& cancellation)
{
  Local_frame frame;
  const double inf = std::numeric_limits<double>::infinity();
  Vector low{{inf, inf, inf}}, high{{-inf, -inf, -inf}};
  for (std::size_t v = 0; v < points.size(); ++v) {
    cancellation.poll();
    for (std::size_t i = 0; i < 3; ++i) {
      if (first_in_star[v] == first_in_star[v + 1])
        continue;
      if (!std::isfinite(points[v][i]))
        throw Invalid_input("coordinate " + std::to_string(i) + " of vertex " + std::to_string(v) + " is " +
                            number_text(points[v][i]));
      low[i] = (std::min)(low[i], points[v][i]);
      high[i] = (std::max)(high[i], points[v][i]);
    }
  }
  double extent = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (low[i] <= high[i]) {
      frame.origin[i] = 0.5 * low[i] + 0.5 * high[i];
      extent = (std::max)(extent, 0.5 * high[i] - 0.5 * low[i]);
    }
  const int exponent = extent > 0 ? std::ilogb(extent) : 0;
  if (exponent > 128 || exponent < -128)
    frame.exponent = exponent;
  for (Vector& p : points) {
    cancellation.poll();
    p = frame.to_local(p);
  }
  return frame;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_LOCAL_FRAME_H
