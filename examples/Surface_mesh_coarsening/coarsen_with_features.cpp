// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <set>
#include <string>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

namespace SMC = CGAL::Surface_mesh_coarsening;

int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh input, output;
  if (!CGAL::IO::read_polygon_mesh(name, input)) {
    std::cerr << "cannot read " << name << std::endl;
    return EXIT_FAILURE;
  }

  //! [features]
  // Keeps edges of 30 degrees or more. The output maps mark them and the regions between them.
  auto is_feature = output.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  auto patch = output.add_property_map<Mesh::Face_index, int>("f:patch", 0).first;
  const SMC::Coarsening_report report =
    SMC::coarsen_mesh(input, 527, output,
                      SMC::parameters::feature_angle(30.).vertex_placement(SMC::Fitted_placement()),
                      SMC::parameters::edge_is_constrained_map(is_feature).face_patch_map(patch));
  //! [features]

  std::set<int> patches;
  for (const Mesh::Face_index f : output.faces())
    patches.insert(patch[f]);
  std::cout << report.feature_lines << " lines between " << report.feature_corners << " corners became "
            << std::count(is_feature.begin(), is_feature.end(), true) << " edges, between " << patches.size()
            << " regions" << std::endl;
  return EXIT_SUCCESS;
}
