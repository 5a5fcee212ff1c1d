// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_levels.h>
#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>
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
  Mesh input;
  if (!CGAL::IO::read_polygon_mesh(name, input)) {
    std::cerr << "cannot read " << name << std::endl;
    return EXIT_FAILURE;
  }

  typedef SMC::Mwcvd_clustering<Mesh> Clustering;
  Clustering clustering(input);
  clustering.seed(1600);
  clustering.grow();
  clustering.minimize();

  const SMC::Cluster_levels<Clustering> levels(clustering);
  for (std::size_t n = levels.finest(); n >= 50; n /= 2) {
    Mesh level;
    levels.extract_dual_mesh(n, level);
    const SMC::Coarsening_quality quality = SMC::measure_coarsening(input, level, 10000);
    std::cout << n << " vertices: distance " << 100 * quality.rms_distance / quality.diagonal << " % (RMS)" << std::endl;
    if (!CGAL::IO::write_polygon_mesh("level_" + std::to_string(n) + ".off", level))
      return EXIT_FAILURE;
  }

  // The vertex of level 400 that contains each vertex of level 800.
  std::vector<std::size_t> parents;
  levels.parents(800, 400, std::back_inserter(parents));
  std::cout << "vertex 799 of 800 is part of vertex " << parents[799] << " of 400" << std::endl;
  return EXIT_SUCCESS;
}
