// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/paper.h>
#include <CGAL/Surface_mesh_coarsening/vertex_number_range.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace SMC = CGAL::Surface_mesh_coarsening;

//! [visitor]
// Stops a coarsening after ten rounds, and counts the notifications.
struct Ten_rounds : SMC::Coarsening_visitor_base
{
  std::size_t rounds = 0, moves = 0;
  void round_done(std::size_t round, std::size_t moves_of_round, double /* energy */)
  {
    rounds = round;
    moves += moves_of_round;
  }
  bool go_further() const { return rounds < 10; }
};
//! [visitor]

int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh input, output;
  if (!CGAL::IO::read_polygon_mesh(name, input)) {
    std::cerr << "cannot read " << name << std::endl;
    return EXIT_FAILURE;
  }

  //! [weight]
  SMC::coarsen_mesh(input, 527, output,
                    SMC::parameters::cluster_weight(SMC::Weighted_area_weight()).maximum_density(20.));
  //! [weight]
  std::cout << "weighted area: " << output.number_of_vertices() << " vertices" << std::endl;

  //! [level]
  // Seeds and growth alone show quickly the result of a level.
  SMC::coarsen_mesh(input, output, SMC::parameters::neighborhood_level(4).number_of_iterations(0));
  //! [level]
  std::cout << "level 4: " << output.number_of_vertices() << " vertices" << std::endl;

  //! [ratio]
  SMC::coarsen_mesh(input, output, SMC::parameters::vertex_ratio(0.1));
  //! [ratio]

  //! [range]
  const SMC::Vertex_number_range range = SMC::vertex_number_range(input);
  std::cout << "from " << range.least << " to " << range.most << " vertices are possible" << std::endl;
  //! [range]

  //! [paper]
  // The method of the paper, with its largest density for this model.
  SMC::coarsen_mesh(input, output, SMC::parameters::paper(SMC::Maximum_density_weight(), 50).neighborhood_level(3));
  //! [paper]

  //! [placement]
  SMC::coarsen_mesh(input, 527, output, SMC::parameters::vertex_placement(SMC::Quadric_placement()));
  //! [placement]

  //! [repair]
  // A preview may have intersecting triangles, so it needs no repair.
  SMC::coarsen_mesh(input, 527, output, SMC::parameters::repair_output(false));
  //! [repair]

  //! [prepared]
  // As many vertices as in the input: faces of a copy are subdivided.
  SMC::coarsen_mesh(input, input.number_of_vertices(), output, SMC::parameters::subdivide_input(true).number_of_iterations(5));
  //! [prepared]
  std::cout << "subdivided: " << output.number_of_vertices() << " vertices" << std::endl;

  //! [maps]
  auto cluster = input.add_property_map<Mesh::Face_index, std::size_t>("f:cluster").first;
  auto count = input.add_property_map<Mesh::Vertex_index, int>("v:boundary_count").first;
  SMC::coarsen_mesh(input, 527, output,
                    SMC::parameters::face_cluster_map(cluster).vertex_boundary_count_map(count).number_of_iterations(3));
  std::vector<std::size_t> faces_of_vertex(output.number_of_vertices(), 0);
  for (const Mesh::Face_index f : input.faces())
    ++faces_of_vertex[cluster[f]]; // vertex i of the output represents cluster i
  const auto inside = std::count_if(input.vertices().begin(), input.vertices().end(),
                                    [&](Mesh::Vertex_index v) { return count[v] == 0; });
  //! [maps]
  std::cout << "up to " << *std::max_element(faces_of_vertex.begin(), faces_of_vertex.end()) << " faces in a cluster, "
            << inside << " vertices inside of clusters" << std::endl;

  //! [start]
  // Continues from these clusters with other densities.
  SMC::Mwcvd_clustering<Mesh> clustering(input, SMC::parameters::maximum_density(5.));
  clustering.set_clusters(cluster);
  clustering.minimize();
  clustering.extract_embedded_dual_mesh(output);
  //! [start]

  //! [order]
  // Faces are traversed in the order of a custom index: here from the last to the first.
  std::vector<std::size_t> place(input.number_of_faces());
  for (const Mesh::Face_index f : input.faces())
    place[f] = input.number_of_faces() - 1 - f;
  SMC::coarsen_mesh(input, 527, output,
                    SMC::parameters::face_index_map(CGAL::make_property_map(place)).number_of_iterations(3));
  //! [order]

  //! [points]
  // Coarsens a deformed mesh without a copy: its points are in a map.
  auto moved = input.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:moved").first;
  for (const Mesh::Vertex_index v : input.vertices()) {
    const Kernel::Point_3& p = input.point(v);
    moved[v] = Kernel::Point_3(p.x(), 2 * p.y(), p.z());
  }
  SMC::coarsen_mesh(input, 527, output, SMC::parameters::vertex_point_map(moved).geom_traits(Kernel()));
  //! [points]

  //! [chain]
  SMC::coarsen_mesh(input, 400, output,
                    SMC::parameters::vertex_point_map(moved) // one of CGAL's
                      .cluster_weight(SMC::Weighted_area_weight())
                      .face_cluster_map(cluster));
  //! [chain]

  //! [adopt]
  const auto of_cgal = CGAL::parameters::vertex_point_map(moved);
  SMC::coarsen_mesh(input, 400, output, SMC::parameters::adopt(of_cgal).maximum_density(20.));
  //! [adopt]

  //! [cancel]
  Ten_rounds visitor;
  try {
    SMC::coarsen_mesh(input, 527, output, SMC::parameters::visitor(std::ref(visitor)));
  } catch (const SMC::Coarsening_cancelled&) {
    std::cout << "cancelled after " << visitor.rounds << " rounds, " << visitor.moves << " moves" << std::endl;
  }
  //! [cancel]
  return EXIT_SUCCESS;
}
