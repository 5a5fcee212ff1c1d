// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_PICTURE_H
#define COARSEN_MESH_PICTURE_H

#include "io/Mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// Returns a PNG file that shows the result on the left and the clusters of the input on the right, from the direction
// `view`, with `up` pointing up.
std::string picture_bytes(const Mesh& input, const std::vector<std::size_t>& labels, const Mesh& result,
                          const Vector& view, const Vector& up);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_PICTURE_H
