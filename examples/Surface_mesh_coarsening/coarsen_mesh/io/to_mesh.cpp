// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/to_mesh.h"

#include <cstddef>
#include <vector>

namespace coarsening_support {
namespace {

typedef Edge_pairing::Side Side;

// The halfedges of edge i are 2 i and 2 i + 1; the first belongs to the side of lower number.
std::vector<Halfedge> halfedges_of_sides(const Edge_pairing& pairing, std::size_t sides, const Stop& stop)
{
  std::vector<Halfedge> result(sides);
  for (std::size_t i = 0; i < pairing.edges().size(); ++i) {
    stop_at(i, stop);
    const Side s = pairing.edges()[i];
    result[s] = Halfedge(Mesh::size_type(2 * i));
    if (pairing.twin(s) != Edge_pairing::none)
      result[pairing.twin(s)] = Halfedge(Mesh::size_type(2 * i + 1));
  }
  return result;
}

// Returns the border halfedge that leaves each vertex.
std::vector<Halfedge> link_faces(const Polygons& polygons, const Edge_pairing& pairing, const Stop& stop, Mesh& mesh)
{
  const std::vector<Vertex_number>& corners = polygons.corners();
  const std::vector<Halfedge> halfedges = halfedges_of_sides(pairing, corners.size(), stop);
  std::vector<Halfedge> border_from(mesh.number_of_vertices(), Mesh::null_halfedge());
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    stop_at(f, stop);
    const std::size_t begin = polygons.first_corner(f), end = polygons.first_corner(f + 1);
    const Face face{Mesh::size_type(f)};
    for (std::size_t s = begin; s < end; ++s) {
      const std::size_t next = s + 1 == end ? begin : s + 1;
      const Halfedge h = halfedges[s];
      const Vertex target(corners[next]);
      mesh.set_target(h, target);
      mesh.set_face(h, face);
      mesh.set_next(h, halfedges[next]);
      mesh.set_halfedge(target, h);
      if (pairing.twin(Side(s)) == Edge_pairing::none) {
        mesh.set_target(mesh.opposite(h), Vertex(corners[s]));
        border_from[target] = mesh.opposite(h);
      }
    }
    mesh.set_halfedge(face, halfedges[begin]);
  }
  return border_from;
}

} // namespace

Mesh to_mesh(const Soup& soup, const Edge_pairing& pairing, const Stop& stop)
{
  Mesh mesh;
  mesh.resize(Mesh::size_type(soup.points.size()), Mesh::size_type(pairing.edges().size()),
              Mesh::size_type(soup.polygons.size()));
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    mesh.point(Vertex(Mesh::size_type(v))) = soup.points[v];
  const std::vector<Halfedge> border_from = link_faces(soup.polygons, pairing, stop, mesh);
  for (const Halfedge h : border_from)
    if (h != Mesh::null_halfedge()) {
      mesh.set_next(h, border_from[mesh.target(h)]);
      mesh.set_halfedge(mesh.target(h), h);
    }
  return mesh;
}

Mesh to_mesh(const Soup& soup) { return to_mesh(soup, Edge_pairing(soup.polygons, soup.points.size())); }

} // namespace coarsening_support
