// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_TRIANGULATE_IN_PARTS_H
#define COARSEN_MESH_TRIANGULATE_IN_PARTS_H

#include "io/Mesh.h"
#include "io/Text_scanner.h"

#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <cstddef>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// The search among all triangulations takes time cubic in the number of edges, 0.05 seconds for this number.
constexpr std::size_t most_edges_for_cubic_algorithm = 150;

// A visitor of CGAL's hole filling that stops it on request and bounds its time. Copies share the count.
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

// Fills the hole of a border halfedge: divides its border along a short diagonal, and each part again, until the parts can be
// triangulated. Returns the number of triangles, or 0 if this failed; the mesh then does not change.
std::size_t triangulate_in_parts(Mesh& mesh, Halfedge border, const Stop& stop);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_TRIANGULATE_IN_PARTS_H
