// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_EXCEPTIONS_H
#define CGAL_SURFACE_MESH_COARSENING_EXCEPTIONS_H

#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// reports an input that violates a precondition: a mesh that is not a 2-manifold, or a coordinate, density or label that is
/// out of range. The message names the first invalid element and its value.
class Invalid_input
  : public std::invalid_argument
{
public:
  /// \param message names the invalid element and its value.
  explicit Invalid_input(const std::string& message) : std::invalid_argument(message) {}
};

/// \ingroup PkgSurfaceMeshCoarseningRef
/// reports a number of vertices that cannot be reached, because it is too small for the topology of the mesh, or larger than the
/// number of vertices of the mesh.
class Unreachable_number_of_vertices
  : public Invalid_input
{
public:
  /// \param message names the requested number and the reason.
  /// \param nearest is the attainable number of vertices nearest to the requested number.
  Unreachable_number_of_vertices(const std::string& message, std::size_t nearest)
    : Invalid_input(message), nearest_(nearest) {}

  /// returns the attainable number of vertices nearest to the requested number. The same call succeeds with this number.
  std::size_t nearest() const noexcept { return nearest_; }

private:
  std::size_t nearest_;
};

/// \ingroup PkgSurfaceMeshCoarseningRef
/// reports a distance for which no result was found.
class Unreachable_distance
  : public Invalid_input
{
public:
  /// \param message names the requested distance.
  /// \param nearest is the bound of the distance of the closest result found.
  Unreachable_distance(const std::string& message, double nearest) : Invalid_input(message), nearest_(nearest) {}

  /// returns the bound of the distance of the closest result found.
  double nearest() const noexcept { return nearest_; }

private:
  double nearest_;
};

/// \ingroup PkgSurfaceMeshCoarseningRef
/// reports that the visitor's `go_further()` returned `false`.
class Coarsening_cancelled
  : public std::runtime_error
{
public:
  Coarsening_cancelled() : std::runtime_error("the coarsening was cancelled by its visitor") {}
};

namespace internal {

// Returns the number as text of any magnitude; `std::to_string()` prints only six digits after the point.
inline std::string number_text(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

} // namespace internal
} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_EXCEPTIONS_H
