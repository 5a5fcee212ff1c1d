// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_REPAIR_H
#define COARSEN_MESH_REPAIR_H

#include "io/Mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// A step of a repair and its count.
struct Repair_step
{
  std::string action;
  std::size_t count;
  bool needs_warning; // of what was duplicated, removed or separated
};

// Repairs the soup to an oriented 2-manifold as far as CGAL's repair functions can, and returns the steps that
// changed it, in order. Points within `tolerance` of each other are merged like coincident ones.
std::vector<Repair_step> repair(Soup& soup, double tolerance = 0);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_REPAIR_H
