// SPDX-License-Identifier: GPL-3.0-or-later
//
// What files hold of a result: formats other than OFF, OBJ and PLY have fewer digits than `double`.

#ifndef COARSEN_MESH_WRITTEN_H
#define COARSEN_MESH_WRITTEN_H

#include "io/Mesh.h"

#include <string>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// Whether files of this type hold all digits of coordinates.
bool stores_all_digits(const std::string& type);

// Whether files of this type hold the coordinates of the mesh in single precision, or with fewer digits.
bool rounds_coordinates(const Mesh& mesh, const std::string& type);

// Moves the vertices, which have coordinates in single precision if the type rounds, to where a file of this type has them, and
// returns the largest distance by which a vertex moves. Throws Failure if vertices coincide there.
double move_to_stored_points(Mesh& mesh, const std::string& file, const std::string& type);

// A warning if the numbers of the format move vertices by a visible part of the diagonal, else nothing. `moved` is what
// move_to_stored_points() has returned.
std::string rounding_text(const Mesh& mesh, const std::string& type, double moved);

// Throws Failure unless the bytes are read back as a surface with the vertices and faces of the mesh.
void check_written(const std::string& file, const std::string& type, const std::string& bytes, const Mesh& mesh);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_WRITTEN_H
