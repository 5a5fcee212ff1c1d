// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_WRITE_OFF_H
#define COARSEN_MESH_WRITE_OFF_H

#include "io/Mesh.h"

#include <string>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// With colors, normals and texture coordinates of vertices, and colors of faces, where the mesh has them.
std::string off_bytes(const Mesh& mesh, const File_notes& notes);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_WRITE_OFF_H
