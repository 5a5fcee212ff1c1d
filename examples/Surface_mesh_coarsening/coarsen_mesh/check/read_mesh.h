// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_READ_MESH_H
#define COARSENING_SUPPORT_READ_MESH_H

#include "io/Mesh.h"

#include <string>

namespace coarsening_support {

// Reads a mesh without unused points. Throws Failure if the file cannot be read, or is no oriented 2-manifold.
Mesh read_mesh(const std::string& file);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_READ_MESH_H
