// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair/fill_holes.h"

#include "repair/fill_fields.h"
#include "repair/triangulate_in_parts.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/version.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace coarsen_mesh_tool {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

// The triangulation of a hole compares positions exactly.
using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// Returns the number of triangles, 0 if no triangulation was found.
std::size_t triangulate_by_cgal(Mesh& mesh, Halfedge h, std::size_t edges, const Stop& stop)
{
  std::vector<Face> patch;
  const auto points = boost::make_function_property_map<Vertex, Exact_kernel::Point_3>([&mesh](Vertex v) {
    const Point& p = mesh.point(v);
    return Exact_kernel::Point_3(p.x(), p.y(), p.z());
  });
  const Step_counter counter(stop);
  const auto np = CGAL::parameters::vertex_point_map(points)
                    .geom_traits(Exact_kernel())
                    .do_not_use_cubic_algorithm(edges > most_edges_for_cubic_algorithm)
                    .visitor(counter);
  try {
#if CGAL_VERSION_NR >= 1060000000
    PMP::triangulate_hole(mesh, h, np.face_output_iterator(std::back_inserter(patch)));
#else
    PMP::triangulate_hole(mesh, h, std::back_inserter(patch), np);
#endif
  } catch (const Step_counter::Too_many_steps&) {
  }
  return patch.size();
}

// Whether CGAL's triangulation of a long border would take time with the square of the number of its edges: it does for each of
// them that is not in the Delaunay triangulation of its vertices.
bool is_too_jagged(const Mesh& mesh, Halfedge start, std::size_t edges, const Stop& stop)
{
  typedef CGAL::Delaunay_triangulation_3<Exact_kernel> Delaunay;
  constexpr std::size_t most_steps = 2000000;
  Delaunay delaunay;
  std::vector<Delaunay::Vertex_handle> vertices;
  Halfedge h = start;
  do {
    if (stop && vertices.size() % 64 == 0)
      stop();
    const Point& p = mesh.point(mesh.target(h));
    const Exact_kernel::Point_3 q(p.x(), p.y(), p.z());
    vertices.push_back(vertices.empty() ? delaunay.insert(q) : delaunay.insert(q, vertices.back()));
    h = mesh.next(h);
  } while (h != start);
  std::size_t missing = 0;
  for (std::size_t i = 0; i < edges; ++i) {
    Delaunay::Cell_handle cell;
    int a, b;
    const Delaunay::Vertex_handle u = vertices[i], v = vertices[(i + 1) % edges];
    missing += u == v || !delaunay.is_edge(u, v, cell, a, b);
  }
  return missing > most_steps / edges;
}

std::size_t triangulate(Mesh& mesh, Halfedge h, std::size_t edges, const Stop& stop)
{
  if (edges <= most_edges_for_cubic_algorithm)
    return triangulate_by_cgal(mesh, h, edges, stop);
  const std::size_t triangles = is_too_jagged(mesh, h, edges, stop) ? 0 : triangulate_by_cgal(mesh, h, edges, stop);
  return triangles > 0 ? triangles : triangulate_in_parts(mesh, h, stop);
}

Hole measured(const Mesh& mesh, Halfedge start)
{
  Hole hole{static_cast<std::size_t>(mesh.target(start)), 0, 0, Hole_state::LONGER};
  Halfedge h = start;
  do {
    const Vector side = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h));
    hole.length += std::hypot(side.x(), side.y(), side.z());
    ++hole.edges;
    h = mesh.next(h);
  } while (h != start);
  return hole;
}

// Returns whether a triangle in the hole would have the vertices of the only face around it.
bool is_lone_triangle(const Mesh& mesh, Halfedge h, const Hole& hole)
{
  return hole.edges == 3 && mesh.face(mesh.opposite(h)) == mesh.face(mesh.opposite(mesh.next(h)));
}

std::vector<Halfedge> starts_of_border_loops(const Mesh& mesh)
{
  std::vector<bool> seen(mesh.num_halfedges(), false);
  std::vector<Halfedge> starts;
  for (Halfedge h : mesh.halfedges())
    if (mesh.is_border(h) && !seen[h]) {
      starts.push_back(h);
      for (Halfedge g = h; !seen[g]; g = mesh.next(g))
        seen[g] = true;
    }
  return starts;
}

} // namespace

std::size_t Hole_filling::number(Hole_state state) const
{
  return static_cast<std::size_t>(
    std::count_if(holes.begin(), holes.end(), [state](const Hole& hole) { return hole.state == state; }));
}

Hole_filling fill_holes(Mesh& mesh, double most_length, const Stop& stop)
{
  Hole_filling result;
  const std::size_t faces = mesh.number_of_faces();
  for (Halfedge h : starts_of_border_loops(mesh)) {
    if (stop)
      stop();
    Hole hole = measured(mesh, h);
    if (hole.length <= most_length) {
      const std::size_t triangles = is_lone_triangle(mesh, h, hole) ? 0 : triangulate(mesh, h, hole.edges, stop);
      hole.state = triangles > 0 ? Hole_state::FILLED : Hole_state::NOT_FILLED;
      result.triangles_added += triangles;
    }
    result.holes.push_back(hole);
  }
  fill_fields(mesh, faces);
  return result;
}

} // namespace coarsen_mesh_tool
