// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_CLUSTER_BYTES_H
#define COARSEN_MESH_CLUSTER_BYTES_H

#include "io/Mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// Returns a PLY file of the mesh with the properties red, green, blue, alpha, label and density for each face.
std::string cluster_bytes(const Mesh& mesh, const std::vector<std::size_t>& labels, const std::vector<double>& densities);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_CLUSTER_BYTES_H
