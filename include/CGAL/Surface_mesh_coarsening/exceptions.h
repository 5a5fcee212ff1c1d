// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_EXCEPTIONS_H
#define CGAL_SURFACE_MESH_COARSENING_EXCEPTIONS_H

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// reports an input that breaks a precondition: a mesh that is not a 2-manifold, a coordinate or a density that is
/// not a number in range, a label out of range. The message names the first offending element and its value.
class Invalid_input
  : public std::invalid_argument
{
public:
  /// \param message names the offending element and its value.
  explicit Invalid_input(const std::string& message) : std::invalid_argument(message) {}
};

/// \ingroup PkgSurfaceMeshCoarseningRef
/// reports a number of vertices that cannot be reached: too small for the topology of the mesh, or larger than its
/// number of vertices.
class Unreachable_number_of_vertices
  : public Invalid_input
{
public:
  /// \param message says what was asked and why it cannot be reached.
  /// \param nearest is the nearest number of vertices that can.
  Unreachable_number_of_vertices(const std::string& message, std::size_t nearest)
    : Invalid_input(message), nearest_(nearest) {}

  /// returns the number of vertices nearest to the one asked for with which the same call succeeds.
  std::size_t nearest() const noexcept { return nearest_; }

private:
  std::size_t nearest_;
};

/// \ingroup PkgSurfaceMeshCoarseningRef
/// reports a distance that no result was found to keep to.
class Unreachable_distance
  : public Invalid_input
{
public:
  /// \param message says what was asked.
  /// \param nearest is the bound of the distance of the closest result that was found.
  Unreachable_distance(const std::string& message, double nearest) : Invalid_input(message), nearest_(nearest) {}

  /// returns the bound of the distance of the closest result that was found.
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

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_EXCEPTIONS_H
