// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh_to_distance.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
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

  //! [distance]
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(input);
  const double diagonal = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  const SMC::Distance_report report = SMC::coarsen_mesh_to_distance(input, 0.02 * diagonal, output);
  std::cout << report.vertices << " vertices keep within " << 100 * report.distance_bound / diagonal
            << " % of the diagonal" << std::endl;
  //! [distance]
  return CGAL::IO::write_polygon_mesh("coarse.off", output) ? EXIT_SUCCESS : EXIT_FAILURE;
}
