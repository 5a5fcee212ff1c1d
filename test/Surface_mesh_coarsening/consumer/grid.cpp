// SPDX-License-Identifier: GPL-3.0-or-later

#include "grid.h"

// Not used here: an application may include the package in several of its sources.
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>

#include <CGAL/boost/graph/generators.h>

Mesh grid()
{
  Mesh mesh;
  CGAL::make_grid(30, 20, mesh);
  return mesh;
}
