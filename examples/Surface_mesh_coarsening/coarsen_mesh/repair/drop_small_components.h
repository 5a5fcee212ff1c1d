// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_DROP_SMALL_COMPONENTS_H
#define COARSEN_MESH_DROP_SMALL_COMPONENTS_H

#include "io/Mesh.h"

#include <cstddef>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// Removes the connected components whose area is less than `least_area`, and returns their number. The mesh keeps the memory of
// the removed elements, so the other elements keep their numbers. Throws Invalid_input if no component would be left.
std::size_t drop_small_components(Mesh& mesh, double least_area);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_DROP_SMALL_COMPONENTS_H
