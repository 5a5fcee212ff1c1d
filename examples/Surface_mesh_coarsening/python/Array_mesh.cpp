// SPDX-License-Identifier: GPL-3.0-or-later

#include "Array_mesh.h"

#include "check/soup_fault.h"
#include "io/Edge_pairing.h"
#include "io/to_mesh.h"
#include "Signal_check.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

namespace coarsening_python {

Soup to_soup(const Mesh_arrays& arrays)
{
  const Index_array &sizes = arrays.sizes, &indices = arrays.indices;
  std::uint64_t corners = 0; // cannot wrap: sizes have 32 bits
  for (py::ssize_t f = 0; f < sizes.size(); ++f)
    corners += sizes.data()[f];
  if (corners != std::uint64_t(indices.size()) || arrays.points.ndim() != 2 || arrays.points.shape(1) != 3)
    throw std::invalid_argument("the arrays of points, sizes and indices do not match");
  Soup soup;
  soup.points.reserve(std::size_t(arrays.points.shape(0)));
  const auto p = arrays.points.unchecked<2>();
  for (py::ssize_t i = 0; i < p.shape(0); ++i)
    soup.points.emplace_back(p(i, 0), p(i, 1), p(i, 2));
  soup.polygons.reserve(std::size_t(sizes.size()), std::size_t(indices.size()));
  const std::uint32_t* corner = indices.data();
  for (py::ssize_t f = 0; f < sizes.size(); ++f) {
    for (const std::uint32_t* const end = corner + sizes.data()[f]; corner != end; ++corner)
      soup.polygons.add_corner(*corner);
    soup.polygons.end_polygon();
  }
  return soup;
}

Mesh to_mesh(const Mesh_arrays& arrays) { return checked_mesh(to_soup(arrays)); }

Mesh checked_mesh(const Soup& soup)
{
  const py::gil_scoped_release unlock;
  Signal_check check;
  const Stop stop = std::ref(check);
  std::optional<Edge_pairing> pairing;
  if (const auto fault = soup_fault(soup, pairing, stop))
    throw std::invalid_argument("the mesh is not an oriented 2-manifold: " + *fault);
  return coarsening_support::to_mesh(soup, *pairing, stop);
}

Mesh_arrays to_arrays(const Soup& soup)
{
  const Polygons& polygons = soup.polygons;
  Mesh_arrays arrays{Number_array({py::ssize_t(soup.points.size()), py::ssize_t(3)}), Index_array(py::ssize_t(polygons.size())),
                     Index_array(py::ssize_t(polygons.corners().size()))};
  auto p = arrays.points.mutable_unchecked<2>();
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    for (int i = 0; i < 3; ++i)
      p(py::ssize_t(v), i) = soup.points[v][i];
  for (std::size_t f = 0; f < polygons.size(); ++f)
    arrays.sizes.mutable_data()[f] = std::uint32_t(polygons[f].size());
  std::copy(polygons.corners().begin(), polygons.corners().end(), arrays.indices.mutable_data());
  return arrays;
}

Soup to_soup(const Mesh& mesh)
{
  Soup soup;
  for (const Vertex v : mesh.vertices())
    soup.points.push_back(mesh.point(v));
  for (const Face f : mesh.faces()) {
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
      soup.polygons.add_corner(mesh.source(h));
    soup.polygons.end_polygon();
  }
  return soup;
}

std::vector<bool> marked_edges(const Mesh& mesh, const Integer_array& ends)
{
  std::vector<bool> marks(mesh.number_of_edges(), false);
  const auto end = ends.unchecked<2>();
  for (py::ssize_t i = 0; i < end.shape(0); ++i) {
    const auto is_vertex = [&](std::int64_t v) { return v >= 0 && std::uint64_t(v) < mesh.number_of_vertices(); };
    const Halfedge h = is_vertex(end(i, 0)) && is_vertex(end(i, 1)) && !mesh.is_isolated(Vertex(std::uint32_t(end(i, 0))))
                         ? mesh.halfedge(Vertex(std::uint32_t(end(i, 0))), Vertex(std::uint32_t(end(i, 1))))
                         : Mesh::null_halfedge();
    if (h == Mesh::null_halfedge())
      throw std::invalid_argument("keep_edges have the vertices " + std::to_string(end(i, 0)) + " and " +
                                  std::to_string(end(i, 1)) + " in row " + std::to_string(i) + ", which are no edge of the mesh");
    marks[mesh.edge(h)] = true;
  }
  return marks;
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
