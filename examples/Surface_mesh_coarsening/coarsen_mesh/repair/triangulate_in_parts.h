// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_TRIANGULATE_IN_PARTS_H
#define COARSEN_MESH_TRIANGULATE_IN_PARTS_H

#include "io/Mesh.h"
#include "io/Text_scanner.h"

#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <cstddef>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// The search among all triangulations takes time with the cube of the number of edges, a twentieth of a second for so many.
constexpr std::size_t most_edges_for_cubic_algorithm = 150;

// A visitor of CGAL's hole filling that lets it be stopped and bounds its time. It counts on where it is copied to.
class Step_counter : public CGAL::Polygon_mesh_processing::Hole_filling::Default_visitor
{
  const Stop* stop_;
  mutable std::size_t steps_ = 0;

  void count(std::size_t steps) const
  {
    constexpr std::size_t most_steps = 1000000;
    if (steps_ / 4096 != (steps_ + steps) / 4096 && *stop_)
      (*stop_)();
    steps_ += steps;
    if (steps_ > most_steps)
      throw Too_many_steps();
  }

public:
  struct Too_many_steps
  {};

  explicit Step_counter(const Stop& stop) : stop_(&stop) {}
  void quadratic_step() const { count(100); } // walks around an edge, for each of its facets
  void cubic_step() const { count(1); }
};

// Fills the hole that a border halfedge belongs to: its border is cut in two along a short diagonal, and each part again, until
// the parts can be triangulated. Returns the number of triangles; it is 0 if that did not work, and the mesh is as before.
std::size_t triangulate_in_parts(Mesh& mesh, Halfedge border, const Stop& stop);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_TRIANGULATE_IN_PARTS_H
