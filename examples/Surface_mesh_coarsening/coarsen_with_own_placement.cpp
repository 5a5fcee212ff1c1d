// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace SMC = CGAL::Surface_mesh_coarsening;

//! [placement]
// The centroid of the face of a cluster that is closest to the centroid of the cluster, a model of VertexPlacement: every
// vertex lies on the input.
class Central_face_placement
{
public:
  typedef SMC::Clustered_surface::Point_3 Point;

  Point operator()(const SMC::Clustered_surface& surface, std::size_t cluster) const
  {
    const Point center = surface.cluster_centroid(cluster);
    Point closest = center;
    double nearest = -1;
    for (const std::uint32_t f : surface.faces(cluster)) {
      const double d = CGAL::squared_distance(surface.centroid(f), center);
      if (nearest < 0 || d < nearest) {
        nearest = d;
        closest = surface.centroid(f);
      }
    }
    return closest;
  }
};
//! [placement]

int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh input, output;
  if (!CGAL::IO::read_polygon_mesh(name, input)) {
    std::cerr << "cannot read " << name << std::endl;
    return EXIT_FAILURE;
  }
  const SMC::Coarsening_report report =
    SMC::coarsen_mesh(input, 500, output, SMC::parameters::vertex_placement(Central_face_placement()));
  std::cout << report.intersections_found << " self-intersections found, " << report.intersections_left << " left"
            << std::endl;
  return CGAL::IO::write_polygon_mesh("coarse.off", output) ? EXIT_SUCCESS : EXIT_FAILURE;
}
