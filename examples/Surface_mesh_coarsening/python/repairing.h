// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SURFACE_MESH_COARSENING_PYTHON_REPAIRING_H
#define SURFACE_MESH_COARSENING_PYTHON_REPAIRING_H

#include "Array_mesh.h"

namespace coarsening_python {

// Repairs a mesh as the tool does, and fills holes up to the given length of their border. Returns points, sizes, indices, and
// the numbers of the repaired faults by description.
py::tuple repair_arrays(const Number_array& points, const Index_array& sizes, const Index_array& indices, double hole_length);

} // namespace coarsening_python

#endif // SURFACE_MESH_COARSENING_PYTHON_REPAIRING_H
