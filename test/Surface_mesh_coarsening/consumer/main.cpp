// SPDX-License-Identifier: GPL-3.0-or-later

#include "grid.h"

#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>

#include <cstdlib>

int main()
{
  const Mesh input = grid();
  Mesh output;
  const std::size_t number_of_vertices = 60;
  CGAL::Surface_mesh_coarsening::coarsen_mesh(input, number_of_vertices, output);
  return (output.number_of_vertices() == number_of_vertices) ? EXIT_SUCCESS : EXIT_FAILURE;
}
