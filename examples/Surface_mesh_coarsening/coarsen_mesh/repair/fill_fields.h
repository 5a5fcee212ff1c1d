// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_FILL_FIELDS_H
#define COARSEN_MESH_FILL_FIELDS_H

#include "io/Mesh.h"

#include <cstddef>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// Gives faces that were added to a mesh, the ones from number `first` on, what a face next to them has, and their corners what a
// corner at the same vertex has.
void fill_fields(Mesh& mesh, std::size_t first);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_FILL_FIELDS_H
