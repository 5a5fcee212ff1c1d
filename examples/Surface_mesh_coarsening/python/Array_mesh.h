// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SURFACE_MESH_COARSENING_PYTHON_ARRAY_MESH_H
#define SURFACE_MESH_COARSENING_PYTHON_ARRAY_MESH_H

#include "io/Mesh.h"

#include <pybind11/numpy.h>

#include <cstdint>

namespace coarsening_python {

using namespace coarsening_support;
namespace py = pybind11;

// Arrays as passed by the Python part: contiguous, of these types.
typedef py::array_t<double, py::array::c_style> Number_array;
typedef py::array_t<std::int64_t, py::array::c_style> Integer_array;
typedef py::array_t<std::uint32_t, py::array::c_style> Index_array;

// Builds a mesh from points and polygons, given by their sizes and the indices of their corners. Vertices and faces keep
// their numbers, and the halfedge of a face begins at its first corner. Throws std::invalid_argument if it is no oriented
// 2-manifold.
Mesh to_mesh(const Number_array& points, const Index_array& sizes, const Index_array& indices);

Number_array points_of(const Mesh& mesh);

// Of a triangle mesh.
Integer_array faces_of(const Mesh& mesh);

} // namespace coarsening_python

#endif // SURFACE_MESH_COARSENING_PYTHON_ARRAY_MESH_H
