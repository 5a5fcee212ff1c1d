// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Additive_cluster_weight.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace SMC = CGAL::Surface_mesh_coarsening;

//! [weight]
// The mean density of the faces of a cluster, a model of ClusterWeight.
class Mean_density_weight
  : public SMC::Additive_cluster_weight<Mean_density_weight>
{
public:
  typedef double Face_data;
  typedef double Cluster_data;

  Face_data face_data(double density, double /* area */) const { return density; }
  void add(Cluster_data& sum, Face_data density) const { sum += density; }
  void remove(Cluster_data& sum, Face_data density) const { sum -= density; }
  double weight(Cluster_data sum, double /* mass */, std::size_t faces) const { return sum / double(faces); }
};
//! [weight]

int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh input, output;
  if (!CGAL::IO::read_polygon_mesh(name, input)) {
    std::cerr << "cannot read " << name << std::endl;
    return EXIT_FAILURE;
  }
  const SMC::Coarsening_report report =
    SMC::coarsen_mesh(input, 500, output, SMC::parameters::cluster_weight(Mean_density_weight()));
  std::cout << "energy " << report.initial_energy << " -> " << report.final_energy << std::endl;
  return CGAL::IO::write_polygon_mesh("coarse.off", output) ? EXIT_SUCCESS : EXIT_FAILURE;
}
