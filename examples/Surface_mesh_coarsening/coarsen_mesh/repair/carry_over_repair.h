// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_CARRY_OVER_REPAIR_H
#define COARSEN_MESH_CARRY_OVER_REPAIR_H

#include "io/Mesh.h"

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// Gives a repaired soup, which has points and polygons, what the soup has beside them. A point has what the first one at the same
// place had; a polygon has what the one with the same corners had, or the first one that it shares most corners with.
void carry_over_repair(const Soup& soup, Soup& repaired);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_CARRY_OVER_REPAIR_H
