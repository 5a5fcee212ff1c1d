// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_FACE_DISTANCES_H
#define COARSENING_SUPPORT_FACE_DISTANCES_H

#include "io/Mesh.h"

#include <functional>
#include <vector>

namespace coarsening_support {

// The distance of the middle of each face from the triangles of another mesh that have an area; 0 if none has. `poll` is called
// often, and may throw.
std::vector<double> face_distances(const Mesh& mesh, const Mesh& triangles, const std::function<void()>& poll);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_FACE_DISTANCES_H
