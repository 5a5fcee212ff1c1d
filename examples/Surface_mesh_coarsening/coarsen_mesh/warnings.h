// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_WARNINGS_H
#define COARSEN_MESH_WARNINGS_H

#include "Options.h"
#include "coarsening.h"
#include "input.h"

#include <string>
#include <vector>

namespace coarsen_mesh_tool {

// What the user may not expect, one line each: what the repair changed, faults that are left in the result, fields that the
// output does not have, threads that are not available.
std::vector<std::string> warnings_of(const Options& options, const Input& input, const Coarsening_result& result);

// What helps if a number of vertices is too small for the components of the input, in parentheses; nothing if it has
// one component.
std::string remedy_for_components(const Options& options, const Mesh& input);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_WARNINGS_H
