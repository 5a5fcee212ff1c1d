// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_VECTOR_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_VECTOR_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// A point or a vector inside the package. It consists of plain numbers instead of a kernel type, because coordinates are set one
// by one, summed, and sent between ranks as they lie in memory, and the caller's kernel must not affect their rounding.
typedef std::array<double, 3> Vector;

inline Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator*(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double squared_length(const Vector& a) { return dot(a, a); }
inline double length(const Vector& a) { return std::sqrt(dot(a, a)); }
inline double largest_coordinate(const Vector& a) { return (std::max)({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])}); }
inline Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Bbox_3 box_of_point(const Vector& p) { return Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]); }

inline Vector low_corner(const Bbox_3& box) { return {{box.xmin(), box.ymin(), box.zmin()}}; }
inline Vector high_corner(const Bbox_3& box) { return {{box.xmax(), box.ymax(), box.zmax()}}; }

inline double squared_diagonal(const Bbox_3& box) { return squared_length(high_corner(box) - low_corner(box)); }

inline Vector closest_in_box(const Vector& p, const Bbox_3& box)
{
  const Vector low = low_corner(box), high = high_corner(box);
  Vector result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = (std::min)((std::max)(p[i], low[i]), high[i]);
  return result;
}

// Returns zero for points inside the box.
inline double squared_distance_from_box(const Vector& p, const Bbox_3& box) { return squared_length(p - closest_in_box(p, box)); }

// Returns the box with all sides moved outwards by `width`.
inline Bbox_3 grown(const Bbox_3& box, double width)
{
  return Bbox_3(box.xmin() - width, box.ymin() - width, box.zmin() - width, box.xmax() + width, box.ymax() + width,
                box.zmax() + width);
}

// These functions map values that differ only by rounding errors to equal values, for example in programs with and without fused
// operations. Exceptions are the rare values halfway between two results.

// Rounds to a multiple of the last of the first `digits` binary digits of `largest`.
inline double rounded_like(double x, double largest, int digits)
{
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(x, digits - exponent)), exponent - digits) + 0.; // no negative zero
}

// Rounds a sum so coarsely that only noticeable differences count.
//! [comparison]
inline double rounded_for_comparison(double sum) { return rounded_like(sum, sum, 16); }
//! [comparison]

// Rounds the coordinates of a computed position to 43 binary digits relative to the largest coordinate. Otherwise exact
// intersection tests would detect rounding errors where triangles just touch, as on symmetric meshes.
inline Vector without_last_digits(const Vector& p)
{
  const double largest = largest_coordinate(p);
  if (!(largest > 0) || !std::isfinite(largest))
    return p;
  //! [digits]
  return {{rounded_like(p[0], largest, 43), rounded_like(p[1], largest, 43), rounded_like(p[2], largest, 43)}};
  //! [digits]
}

// Pairs of points in coordinates of the arrays, sorted, and in coordinates of the mesh.
typedef std::vector<std::pair<Vector, Vector> > Exact_points;

// The frame of the arrays: point of the mesh = origin + 2^exponent * coordinates, exact for the listed points.
struct Local_frame
{
  Vector origin{{0, 0, 0}};
  int exponent = 0;
  std::shared_ptr<const Exact_points> exact;

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
      q[i] = std::clamp(x, -largest, largest);
    }
    return q;
  }

  // Convert lengths and areas.
  double length_to_local(double length) const { return std::ldexp(length, -exponent); }
  double length_to_mesh(double length) const { return std::ldexp(length, exponent); }
};

// Translates the points to the center of their bounding box, so that energies do not lose digits if the mesh is far from the
// origin. If sixth powers of the size and of much smaller details would not all be within the range of double, the points are
// scaled to a size of about 1 by a power of two, which causes no rounding.
inline Local_frame to_local_frame(std::vector<Vector>& points, const std::vector<Index>& first_in_star,
                                  const Run_context& context)
{
  Local_frame frame;
  Bbox_3 box;
  for (std::size_t v = 0; v < points.size(); ++v) {
    context.poll();
    if (first_in_star[v] == first_in_star[v + 1])
      continue;
    for (std::size_t i = 0; i < 3; ++i)
      if (!std::isfinite(points[v][i]))
        throw Invalid_input("coordinate " + std::to_string(i) + " of vertex " + std::to_string(v) + " is " +
                            number_text(points[v][i]));
    box += box_of_point(points[v]);
  }
  const Vector low = low_corner(box), high = high_corner(box);
  double extent = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (low[i] <= high[i]) {
      frame.origin[i] = 0.5 * low[i] + 0.5 * high[i];
      extent = (std::max)(extent, 0.5 * high[i] - 0.5 * low[i]);
    }
  const int exponent = extent > 0 ? std::ilogb(extent) : 0;
  if (exponent > 128 || exponent < -64)
    frame.exponent = exponent;
  for (Vector& p : points) {
    context.poll();
    p = frame.to_local(p);
  }
  return frame;
}

// Maps a position in the arrays to coordinates of the output, rounded to its number type.
typedef std::function<Vector(const Vector&)> Output_coordinates;

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_VECTOR_H
