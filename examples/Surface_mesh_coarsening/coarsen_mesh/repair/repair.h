// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_REPAIR_H
#define COARSEN_MESH_REPAIR_H

#include "io/Mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// Something that a repair did, and how often.
struct Repair_step
{
  std::string action;
  std::size_t count;
};

// Makes an oriented 2-manifold of the soup as far as CGAL's repair functions can, and returns the steps that changed
// something, in their order.
std::vector<Repair_step> repair(Soup& soup);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_REPAIR_H
