// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMC = CGAL::Surface_mesh_coarsening;

// Produces small triangles on one side of a model: the density increases tenfold with x.
int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh input, output;
  if (!CGAL::IO::read_polygon_mesh(name, input)) {
    std::cerr << "cannot read " << name << std::endl;
    return EXIT_FAILURE;
  }

  const CGAL::Bbox_3 box = PMP::bbox(input);
  auto density = input.add_property_map<Mesh::Face_index, double>("f:density").first;
  for (const Mesh::Face_index f : input.faces()) {
    const Kernel::Point_3 p = input.point(target(halfedge(f, input), input));
    density[f] = 1 + 9 * (p.x() - box.xmin()) / (box.xmax() - box.xmin());
  }
  SMC::coarsen_mesh(input, 500, output,
                    SMC::parameters::face_density_map(density).cluster_weight(SMC::Weighted_area_weight()));

  std::size_t on_the_dense_side = 0;
  for (const Mesh::Vertex_index v : output.vertices())
    if (output.point(v).x() > (box.xmin() + box.xmax()) / 2)
      ++on_the_dense_side;
  std::cout << on_the_dense_side << " of " << output.number_of_vertices() << " vertices on the dense side" << std::endl;
  return CGAL::IO::write_polygon_mesh("coarse.off", output) ? EXIT_SUCCESS : EXIT_FAILURE;
}
