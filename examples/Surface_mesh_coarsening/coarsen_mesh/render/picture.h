// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_PICTURE_H
#define COARSEN_MESH_PICTURE_H

#include "io/Mesh.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// Returns a PNG file with three panels, from the direction `view`, with `up` pointing up: the input with its clusters, the
// result, and the input colored by its distance from the result, each with a caption. `poll` is called often, and may throw.
std::string picture_bytes(const Mesh& input, const std::vector<std::size_t>& labels, const Mesh& result, const Vector& view,
                          const Vector& up, const std::function<void()>& poll);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_PICTURE_H
