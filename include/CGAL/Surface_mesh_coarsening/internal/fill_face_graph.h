// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FILL_FACE_GRAPH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FILL_FACE_GRAPH_H

#include <CGAL/Surface_mesh_coarsening/internal/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/named_parameters.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// A position in the arrays in the coordinates of the mesh.
inline Vector to_mesh_coordinates(const Frame& frame, const Vector& p)
{
  Vector q;
  for (int i = 0; i < 3; ++i)
    q[i] = frame.origin[i] + (frame.exponent == 0 ? p[i] : std::ldexp(p[i], frame.exponent));
  return q;
}

template <class GeomTraits>
std::vector<typename GeomTraits::Point_3> to_points(const std::vector<Vector>& positions, const Frame& frame,
                                                    const GeomTraits& traits)
{
  typedef typename GeomTraits::FT FT;
  const auto construct = traits.construct_point_3_object();
  std::vector<typename GeomTraits::Point_3> points;
  points.reserve(positions.size());
  for (const Vector& position : positions) {
    const Vector p = to_mesh_coordinates(frame, position);
    points.push_back(construct(FT(p[0]), FT(p[1]), FT(p[2])));
  }
  return points;
}

// Gives the coordinates that a position in the arrays has in the output.
template <class GeomTraits>
auto output_coordinates(const Frame& frame)
{
  return [frame](const Vector& p) {
    Vector q = to_mesh_coordinates(frame, p);
    for (double& x : q)
      x = CGAL::to_double(typename GeomTraits::FT(x));
    return q;
  };
}

// Removes all elements. `clear()` of a `Surface_mesh` removes its property maps, too; the caller may hold some.
template <class Graph>
auto remove_elements(Graph& graph, int) -> decltype(graph.clear_without_removing_property_maps())
{
  graph.clear_without_removing_property_maps();
}

template <class Graph>
void remove_elements(Graph& graph, long)
{
  clear(graph);
}

// Replaces `output` by the surface of the triangles.
template <class Output, class NamedParameters>
void fill_face_graph(const std::vector<Vector>& positions, const Frame& frame,
                     const std::vector<Triangle>& triangles, Output& output, const NamedParameters& np)
{
  typedef typename GetGeomTraits<Output, NamedParameters>::type Traits;
  const Traits traits = choose_parameter<Traits>(get_parameter(np, CGAL::internal_np::geom_traits));
  const auto points = to_points(positions, frame, traits);
  std::vector<std::array<std::size_t, 3> > polygons;
  polygons.reserve(triangles.size());
  for (const Triangle& t : triangles)
    polygons.push_back({{t[0], t[1], t[2]}});
  const auto point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                          get_property_map(CGAL::vertex_point, output));
  remove_elements(output, 0);
  Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, polygons, output, CGAL::parameters::default_values(),
                                                        CGAL::parameters::vertex_point_map(point_map));
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FILL_FACE_GRAPH_H
