// SPDX-License-Identifier: GPL-3.0-or-later
//
// The mesh and soup types of the programs of this package.

#ifndef COARSENING_SUPPORT_MESH_H
#define COARSENING_SUPPORT_MESH_H

#include "io/Polygons.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace coarsening_support {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;
using Face = Mesh::Face_index;

// A type of number in a file.
enum class Number_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64 };

// Numbers in a file for points or polygons, one for each.
struct Soup_property
{
  std::string name;
  Number_type type;
  std::vector<double> values;
};

// What a file says of itself.
struct File_notes
{
  std::vector<std::string> material_libraries, comments;
};

// Holds polygons as they stand in a file: nothing is known yet about how they hang together.
struct Soup
{
  std::vector<Point> points;
  Polygons polygons;
  std::vector<Soup_property> of_points = {}, of_polygons = {};
  // Texture coordinates and their indices at the corners of each polygon: one list per polygon, empty if it has none, or no
  // lists at all.
  std::vector<std::array<double, 2> > texture_points = {};
  Polygons texture_corners = {};
  std::vector<Vector> normals = {};
  Polygons normal_corners = {};
  std::vector<std::string> materials = {}, groups = {}, objects = {}; // of each polygon, if there are any
  File_notes notes = {};
  std::vector<std::string> left_out = {}; // in words, what the file has and the soup has not

  void leave_out(const std::string& field)
  {
    if (std::find(left_out.begin(), left_out.end(), field) == left_out.end())
      left_out.push_back(field);
  }
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_MESH_H
