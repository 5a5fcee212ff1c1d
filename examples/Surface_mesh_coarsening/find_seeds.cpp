// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_coarsening/neighborhood_seeds.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace SMC = CGAL::Surface_mesh_coarsening;

int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(name, mesh)) {
    std::cerr << "cannot read " << name << std::endl;
    return EXIT_FAILURE;
  }
  for (std::size_t level = 0; level <= 8; ++level) {
    std::vector<Mesh::Face_index> seeds;
    SMC::neighborhood_seeds(mesh, level, std::back_inserter(seeds));
    std::cout << "level " << level << ": " << seeds.size() << " seeds" << std::endl;
  }
  return EXIT_SUCCESS;
}
