// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_WRITE_MESH_H
#define COARSEN_MESH_WRITE_MESH_H

#include "io/Mesh.h"

#include <string>
#include <vector>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// Returns what a file of this type (off, obj, ply, stl, or what Assimp writes) holds for the mesh, with all of its fields that
// the format has. OFF and OBJ have as many digits as read back the same; PLY and STL are binary.
std::string mesh_bytes(const Mesh& mesh, const std::string& type, const File_notes& notes = File_notes());

// The fields of the mesh, in words, that a file of this type cannot hold.
std::vector<std::string> fields_without_room(const Mesh& mesh, const std::string& type, const File_notes& notes);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_WRITE_MESH_H
