// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_FILL_HOLES_H
#define COARSEN_MESH_FILL_HOLES_H

#include "io/Mesh.h"
#include "io/Text_scanner.h"

#include <cstddef>
#include <vector>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

enum class Hole_state { FILLED, LONGER, NOT_FILLED };

// A border loop, given by one of its vertices.
struct Hole
{
  std::size_t vertex, edges;
  double length;
  Hole_state state; // too long, or no triangulation was found
};

struct Hole_filling
{
  std::size_t triangles_added = 0;
  std::vector<Hole> holes;

  std::size_t number(Hole_state state) const;
};

// Fills the holes whose border is at most `most_length` long with triangles between their vertices. Existing vertices and
// faces keep their numbers. The time for a hole is nearly linear in its length.
Hole_filling fill_holes(Mesh& mesh, double most_length, const Stop& stop = nullptr);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_FILL_HOLES_H
