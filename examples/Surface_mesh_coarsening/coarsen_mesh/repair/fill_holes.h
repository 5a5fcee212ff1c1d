// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_FILL_HOLES_H
#define COARSEN_MESH_FILL_HOLES_H

#include "io/Mesh.h"

#include <cstddef>
#include <vector>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// A border loop, told by one of its vertices.
struct Hole
{
  std::size_t vertex, edges;
  double length;
};

struct Hole_filling
{
  std::size_t filled = 0, triangles_added = 0;
  std::size_t longer = 0;        // loops that are longer than what was to be filled
  std::vector<Hole> not_filled;  // loops that no triangulation was found for
};

// Fills the holes of the mesh whose border is at most `max_length` long with triangles between their vertices. The numbers
// of vertices and faces that are there stay.
Hole_filling fill_holes(Mesh& mesh, double max_length);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_FILL_HOLES_H
