// SPDX-License-Identifier: GPL-3.0-or-later

#include "render/face_distances.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif
#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>

#include <cmath>

namespace coarsening_support {

std::vector<double> face_distances(const Mesh& mesh, const Mesh& triangles, const std::function<void()>& poll)
{
  typedef CGAL::Kernel_traits<Point>::Kernel Kernel;
  typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> Primitive;
#if CGAL_VERSION_NR >= 1060000000
  typedef CGAL::AABB_traits_3<Kernel, Primitive> Traits;
#else
  typedef CGAL::AABB_traits<Kernel, Primitive> Traits;
#endif
  // Squares of coordinates of any size are finite, and not all 0, when the meshes have size 1.
  CGAL::Bbox_3 box;
  for (Vertex v : mesh.vertices())
    box += mesh.point(v).bbox();
  const double size = std::hypot(box.x_span(), box.y_span(), box.z_span());
  const Point corner(box.xmin(), box.ymin(), box.zmin());
  if (!(size > 0 && std::isfinite(size)))
    return std::vector<double>(mesh.number_of_faces(), 0.);
  const auto scaled = [&](const Point& p) { return CGAL::ORIGIN + (p - corner) / size; };
  Mesh other = triangles;
  for (Vertex v : other.vertices())
    other.point(v) = scaled(other.point(v));
  std::vector<Face> with_area;
  for (Face f : other.faces())
    if (!CGAL::Polygon_mesh_processing::is_degenerate_triangle_face(f, other))
      with_area.push_back(f);
  if (with_area.empty())
    return std::vector<double>(mesh.number_of_faces(), 0.);
  const CGAL::AABB_tree<Traits> tree(with_area.begin(), with_area.end(), other);
  std::vector<double> result;
  result.reserve(mesh.number_of_faces());
  for (Face f : mesh.faces()) {
    if (result.size() % 1024 == 0)
      poll();
    Vector sum = CGAL::NULL_VECTOR;
    std::size_t corners = 0;
    for (Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) {
      sum = sum + (scaled(mesh.point(v)) - CGAL::ORIGIN);
      ++corners;
    }
    result.push_back(size * std::sqrt(tree.squared_distance(CGAL::ORIGIN + sum / double(corners))));
  }
  return result;
}

} // namespace coarsening_support
