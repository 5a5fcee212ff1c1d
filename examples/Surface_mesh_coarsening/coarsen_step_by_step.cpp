// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
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
  Mesh input, output;
  if (!CGAL::IO::read_polygon_mesh(name, input)) {
    std::cerr << "cannot read " << name << std::endl;
    return EXIT_FAILURE;
  }

  SMC::Mwcvd_clustering<Mesh, SMC::Density_variance_weight> clustering(input, SMC::parameters::maximum_density(3.));
  std::cout << clustering.seed_from_level(3) << " seeds" << std::endl;

  clustering.grow();
  std::cout << clustering.number_of_clusters() << " clusters, energy " << clustering.energy() << std::endl;

  // Five single rounds, and then rounds to convergence.
  for (int round = 1; round <= 5 && clustering.minimize_round(); ++round)
    std::cout << "round " << round << ": energy " << clustering.energy() << std::endl;
  clustering.minimize();
  std::cout << "in the end: energy " << clustering.energy() << std::endl;

  clustering.extract_dual_mesh(output); // fitted to the input; other placements can be given
  return CGAL::IO::write_polygon_mesh("coarse.off", output) ? EXIT_SUCCESS : EXIT_FAILURE;
}
