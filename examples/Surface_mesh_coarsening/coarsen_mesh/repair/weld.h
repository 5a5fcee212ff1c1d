// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_WELD_H
#define COARSEN_MESH_WELD_H

#include "io/Mesh.h"

#include <cstddef>
#include <vector>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// Moves each point to the first point within `tolerance` that does not move itself, and returns the number of moved points.
std::size_t weld(std::vector<Point>& points, double tolerance);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_WELD_H
