// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_faces.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/transfer_properties.h>
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

  // A field on the vertices, and a label on the faces.
  const auto height = input.add_property_map<Mesh::Vertex_index, double>("v:height").first;
  const auto side = input.add_property_map<Mesh::Face_index, std::string>("f:side").first;
  for (const auto v : input.vertices())
    height[v] = input.point(v).z();
  for (const auto f : input.faces())
    side[f] = input.point(input.target(input.halfedge(f))).x() < 0 ? "left" : "right";

  //! [provenance]
  const auto cluster = input.add_property_map<Mesh::Face_index, std::size_t>("f:cluster").first;
  const auto cluster_of_vertex = input.add_property_map<Mesh::Vertex_index, std::size_t>("v:cluster").first;
  const auto source = output.add_property_map<Mesh::Vertex_index, SMC::Surface_location<Mesh> >("v:source").first;
  SMC::coarsen_mesh(input, 500, output, SMC::parameters::face_cluster_map(cluster).vertex_to_cluster_map(cluster_of_vertex),
                    SMC::parameters::vertex_source_map(source));
  //! [provenance]
  const SMC::Cluster_faces<Mesh> faces_of(input, cluster, output.number_of_vertices());
  std::cout << "vertex 0 stands for " << faces_of.faces(0).size() << " faces and comes from "
            << source[*output.vertices().begin()].face << std::endl;

  //! [call]
  SMC::transfer_properties(input, cluster, output, {{"v:height", SMC::Transfer_policy::INTERPOLATED}});
  //! [call]

  // A conserved quantity: its integrals over the two meshes are equal.
  const auto thickness = input.add_property_map<Mesh::Face_index, double>("f:thickness", 0.25).first;
  const auto coarse_thickness = output.add_property_map<Mesh::Face_index, double>("f:thickness").first;
  SMC::Property_resampler<Mesh, Mesh> transfer(input, cluster, output);
  transfer.transfer_face_property(thickness, coarse_thickness, SMC::Transfer_policy::CONSERVATIVE);

  return CGAL::IO::write_polygon_mesh("coarse.ply", output) ? EXIT_SUCCESS : EXIT_FAILURE;
}
