// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_PATCHES_H
#define COARSEN_MESH_PATCHES_H

#include "io/Mesh.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// The number of the patch of each face: faces with the same material, group, solid or object, or with the same of the whole numbers of this
// name, are of one patch. Nothing if the mesh has no such field.
std::optional<std::vector<std::int64_t> > patches(const Mesh& mesh, const std::string& field);

// Writes the values of the field to the faces of the result, whose patches are known. A majority of the faces nearby, as for other
// fields, may be of another patch.
void write_patches(const Mesh& input, const std::vector<std::int64_t>& patch_of_input, const std::string& field,
                   const std::vector<std::int64_t>& patch_of_result, Mesh& result);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_PATCHES_H
