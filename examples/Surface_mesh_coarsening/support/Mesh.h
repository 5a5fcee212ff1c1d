// SPDX-License-Identifier: GPL-3.0-or-later
//
// The mesh and soup types which the programs of this package share.

#ifndef COARSENING_SUPPORT_MESH_H
#define COARSENING_SUPPORT_MESH_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
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

// Holds polygons as they stand in a file: nothing is known yet about how they hang together.
struct Soup
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t> > polygons;
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_MESH_H
