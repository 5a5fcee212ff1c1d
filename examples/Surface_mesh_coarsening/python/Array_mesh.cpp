// SPDX-License-Identifier: GPL-3.0-or-later

#include "Array_mesh.h"

#include "check/soup_fault.h"
#include "io/Edge_pairing.h"
#include "io/to_mesh.h"

#include <cstddef>
#include <optional>
#include <stdexcept>

namespace coarsening_python {

Mesh to_mesh(const Number_array& points, const Index_array& sizes, const Index_array& indices)
{
  std::uint64_t corners = 0; // cannot wrap: sizes have 32 bits
  for (py::ssize_t f = 0; f < sizes.size(); ++f)
    corners += sizes.data()[f];
  if (corners != std::uint64_t(indices.size()) || points.ndim() != 2 || points.shape(1) != 3)
    throw std::invalid_argument("the arrays of points, sizes and indices do not match");
  Soup soup;
  soup.points.reserve(std::size_t(points.shape(0)));
  const auto p = points.unchecked<2>();
  for (py::ssize_t i = 0; i < p.shape(0); ++i)
    soup.points.emplace_back(p(i, 0), p(i, 1), p(i, 2));
  soup.polygons.reserve(std::size_t(sizes.size()), std::size_t(indices.size()));
  const std::uint32_t* corner = indices.data();
  for (py::ssize_t f = 0; f < sizes.size(); ++f) {
    for (const std::uint32_t* const end = corner + sizes.data()[f]; corner != end; ++corner)
      soup.polygons.add_corner(*corner);
    soup.polygons.end_polygon();
  }
  const py::gil_scoped_release unlock;
  std::optional<Edge_pairing> pairing;
  if (const auto fault = soup_fault(soup, pairing))
    throw std::invalid_argument("the mesh is not an oriented 2-manifold: " + *fault);
  return to_mesh(soup, *pairing);
}

Number_array points_of(const Mesh& mesh)
{
  Number_array result({py::ssize_t(mesh.number_of_vertices()), py::ssize_t(3)});
  auto p = result.mutable_unchecked<2>();
  for (const Vertex v : mesh.vertices())
    for (int i = 0; i < 3; ++i)
      p(py::ssize_t(v), i) = mesh.point(v)[i];
  return result;
}

Integer_array faces_of(const Mesh& mesh)
{
  Integer_array result({py::ssize_t(mesh.number_of_faces()), py::ssize_t(3)});
  std::int64_t* corner = result.mutable_data();
  for (const Face f : mesh.faces())
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      *corner++ = std::int64_t(v);
  return result;
}

} // namespace coarsening_python
