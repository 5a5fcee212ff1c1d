// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace SMC = CGAL::Surface_mesh_coarsening;

int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  const std::size_t number_of_vertices = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 527;

  Mesh input, output;
  if (!CGAL::IO::read_polygon_mesh(name, input)) {
    std::cerr << "cannot read " << name << std::endl;
    return EXIT_FAILURE;
  }
  try {
    const SMC::Coarsening_report report = SMC::coarsen_mesh(input, number_of_vertices, output);
    std::cout << input.number_of_vertices() << " -> " << output.number_of_vertices() << " vertices in " << report.rounds
              << " rounds" << std::endl;
  } catch (const SMC::Unreachable_number_of_vertices& e) {
    std::cerr << e.what() << "; possible is " << e.nearest() << std::endl;
    return EXIT_FAILURE;
  } catch (const SMC::Invalid_input& e) { // no 2-manifold, for example
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return CGAL::IO::write_polygon_mesh("coarse.off", output) ? EXIT_SUCCESS : EXIT_FAILURE;
}
