// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/tags.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace SMC = CGAL::Surface_mesh_coarsening;

int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh input, on_one, on_many;
  if (!CGAL::IO::read_polygon_mesh(name, input)) {
    std::cerr << "cannot read " << name << std::endl;
    return EXIT_FAILURE;
  }
  SMC::coarsen_mesh<CGAL::Sequential_tag>(input, 527, on_one);
  SMC::coarsen_mesh<CGAL::Parallel_if_available_tag>(input, 527, on_many);

  // The points are equal, not just nearly equal.
  bool same = on_one.number_of_vertices() == on_many.number_of_vertices();
  for (const Mesh::Vertex_index v : on_one.vertices())
    same = same && on_one.point(v) == on_many.point(v);
  std::cout << (same ? "the same result" : "different results") << std::endl;
  return same ? EXIT_SUCCESS : EXIT_FAILURE;
}
