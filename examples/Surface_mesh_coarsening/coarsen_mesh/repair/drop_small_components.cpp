// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair/drop_small_components.h"

#include <CGAL/Surface_mesh_coarsening/exceptions.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <sstream>

namespace coarsen_mesh_tool {
namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;

// Of a polygon, the length of its vector area.
double area(const Mesh& mesh, Face f)
{
  const Halfedge first = mesh.halfedge(f);
  const Point& p = mesh.point(mesh.target(first));
  Vector sum = CGAL::NULL_VECTOR;
  for (const Halfedge h : mesh.halfedges_around_face(first))
    sum = sum + CGAL::cross_product(mesh.point(mesh.source(h)) - p, mesh.point(mesh.target(h)) - p);
  return std::hypot(sum.x(), sum.y(), sum.z()) / 2;
}

} // namespace

std::size_t drop_small_components(Mesh& mesh, double least_area)
{
  std::ostringstream text;
  text << least_area;
  if (!(least_area >= 0))
    throw SMC::Invalid_input("the minimum component area is " + text.str());
  if (least_area == 0)
    return 0;
  const std::size_t dropped = CGAL::Polygon_mesh_processing::keep_large_connected_components(
    mesh, least_area,
    CGAL::parameters::face_size_map(boost::make_function_property_map<Face>([&mesh](Face f) { return area(mesh, f); })));
  if (mesh.number_of_faces() == 0)
    throw SMC::Invalid_input("no component of the input has an area of " + text.str());
  return dropped;
}

} // namespace coarsen_mesh_tool
