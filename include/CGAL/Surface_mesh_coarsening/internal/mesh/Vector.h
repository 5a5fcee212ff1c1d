// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_VECTOR_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_VECTOR_H

#include <array>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// A point or a vector inside the package. It consists of plain numbers instead of a kernel type, because coordinates are set one
// by one, summed, and sent between ranks as they lie in memory, and the caller's kernel must not affect their rounding.
typedef std::array<double, 3> Vector;

inline Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator*(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_VECTOR_H
