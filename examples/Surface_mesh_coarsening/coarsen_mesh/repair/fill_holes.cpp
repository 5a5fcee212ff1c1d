// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair/fill_holes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/version.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <iterator>

namespace coarsen_mesh_tool {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

// The triangulation of a hole compares positions exactly.
using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

std::vector<Face> triangulate(Mesh& mesh, Halfedge h)
{
  std::vector<Face> patch;
  const auto points = boost::make_function_property_map<Vertex, Exact_kernel::Point_3>([&mesh](Vertex v) {
    const Point& p = mesh.point(v);
    return Exact_kernel::Point_3(p.x(), p.y(), p.z());
  });
  const auto np = CGAL::parameters::vertex_point_map(points).geom_traits(Exact_kernel());
#if CGAL_VERSION_NR >= 1060000000
  PMP::triangulate_hole(mesh, h, np.face_output_iterator(std::back_inserter(patch)));
#else
  PMP::triangulate_hole(mesh, h, std::back_inserter(patch), np);
#endif
  return patch;
}

Hole measured(const Mesh& mesh, Halfedge start)
{
  Hole hole{static_cast<std::size_t>(mesh.target(start)), 0, 0};
  Halfedge h = start;
  do {
    const Vector side = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h));
    hole.length += std::hypot(side.x(), side.y(), side.z());
    ++hole.edges;
    h = mesh.next(h);
  } while (h != start);
  return hole;
}

// Whether a triangle in the hole would stand on the vertices of the only face around it.
bool is_lone_triangle(const Mesh& mesh, Halfedge h, const Hole& hole)
{
  return hole.edges == 3 && mesh.face(mesh.opposite(h)) == mesh.face(mesh.opposite(mesh.next(h)));
}

} // namespace

Hole_filling fill_holes(Mesh& mesh, double max_length)
{
  Hole_filling result;
  std::vector<bool> seen(mesh.num_halfedges(), false);
  std::vector<Halfedge> starts;
  for (Halfedge h : mesh.halfedges())
    if (mesh.is_border(h) && !seen[h]) {
      starts.push_back(h);
      for (Halfedge g = h; !seen[g]; g = mesh.next(g))
        seen[g] = true;
    }
  for (Halfedge h : starts) {
    const Hole hole = measured(mesh, h);
    if (!(hole.length <= max_length)) {
      ++result.longer;
      continue;
    }
    const std::size_t patch = is_lone_triangle(mesh, h, hole) ? 0 : triangulate(mesh, h).size();
    if (patch == 0)
      result.not_filled.push_back(hole);
    else {
      ++result.filled;
      result.triangles_added += patch;
    }
  }
  return result;
}

} // namespace coarsen_mesh_tool
