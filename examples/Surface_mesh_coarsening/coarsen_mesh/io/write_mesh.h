// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_WRITE_MESH_H
#define COARSEN_MESH_WRITE_MESH_H

#include "io/Mesh.h"

#include <string>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// Returns the content of a file of this type (off, obj, ply, stl) for the mesh. Numbers in OFF and OBJ have enough digits to
// be read back exactly; PLY and STL are binary. PLY has the numbers of vertices and faces, OBJ has texture coordinates,
// materials and groups.
std::string mesh_bytes(const Mesh& mesh, const std::string& type, const std::string& material_library = "");

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_WRITE_MESH_H
