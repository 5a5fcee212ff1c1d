// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_WRITE_OBJ_H
#define COARSEN_MESH_WRITE_OBJ_H

#include "io/Mesh.h"

#include <string>
#include <vector>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// The order in which faces are written: grouped by object, group and material, in the order in which the names occur first.
std::vector<Face> obj_face_order(const Mesh& mesh);

// With colors of vertices, normals, texture coordinates, materials and groups, where the mesh has them.
std::string obj_bytes(const Mesh& mesh, const File_notes& notes);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_WRITE_OBJ_H
