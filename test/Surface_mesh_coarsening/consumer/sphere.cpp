// SPDX-License-Identifier: GPL-3.0-or-later

#include "sphere.h"

// Not used here: an application may include the package in several of its sources.
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>

#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

Mesh sphere()
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Mesh::Point>(mesh);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(3));
  return mesh;
}
