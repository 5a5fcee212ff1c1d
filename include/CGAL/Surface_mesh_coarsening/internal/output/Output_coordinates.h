// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_OUTPUT_COORDINATES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_OUTPUT_COORDINATES_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <functional>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Maps a position in the arrays to coordinates of the output, rounded to its number type.
typedef std::function<Vector(const Vector&)> Output_coordinates;

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_OUTPUT_COORDINATES_H
