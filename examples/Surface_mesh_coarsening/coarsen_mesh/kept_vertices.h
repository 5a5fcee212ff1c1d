// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_KEPT_VERTICES_H
#define COARSEN_MESH_KEPT_VERTICES_H

#include "Options.h"

#include <vector>

namespace coarsen_mesh_tool {

// For each vertex of the input, whether the options keep it: on borders, or marked by a field, or in a face that is marked. Empty
// if they keep none. Throws Failure if the input does not have the field.
std::vector<char> kept_vertices(const Mesh& input, const Options& options);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_KEPT_VERTICES_H
