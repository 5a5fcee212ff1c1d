// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SURFACE_MESH_COARSENING_PYTHON_ARRAY_MESH_H
#define SURFACE_MESH_COARSENING_PYTHON_ARRAY_MESH_H

#include "io/Mesh.h"

#include <pybind11/numpy.h>

#include <cstdint>
#include <vector>

namespace coarsening_python {

using namespace coarsening_support;
namespace py = pybind11;

// Arrays as passed by the Python part: contiguous, of these types.
typedef py::array_t<double, py::array::c_style> Number_array;
typedef py::array_t<std::int64_t, py::array::c_style> Integer_array;
typedef py::array_t<std::uint32_t, py::array::c_style> Index_array;

// Points and polygons, given by their sizes and the indices of their corners.
struct Mesh_arrays
{
  Number_array points;
  Index_array sizes, indices;
};

Soup to_soup(const Mesh_arrays& arrays);

// Builds a mesh. Vertices and faces keep their numbers, and the halfedge of a face begins at its first corner. Throws
// std::invalid_argument if it is no oriented 2-manifold. Both heed signals.
Mesh to_mesh(const Mesh_arrays& arrays);
Mesh checked_mesh(const Soup& soup);

Mesh_arrays to_arrays(const Soup& soup);
Soup to_soup(const Mesh& mesh);

// Returns for each edge of the mesh whether a row of the array has its ends. Throws std::invalid_argument for other rows.
std::vector<bool> marked_edges(const Mesh& mesh, const Integer_array& ends);

Number_array points_of(const Mesh& mesh);

// Of a triangle mesh.
Integer_array faces_of(const Mesh& mesh);

} // namespace coarsening_python

#endif // SURFACE_MESH_COARSENING_PYTHON_ARRAY_MESH_H
