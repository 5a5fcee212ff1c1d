// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_WRITE_PLY_H
#define COARSEN_MESH_WRITE_PLY_H

#include "io/Mesh.h"

#include <string>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// In binary, with all numbers of vertices and faces, and texture coordinates of corners.
std::string ply_bytes(const Mesh& mesh, const File_notes& notes);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_WRITE_PLY_H
