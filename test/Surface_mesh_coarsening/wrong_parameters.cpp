// SPDX-License-Identifier: GPL-3.0-or-later
//
// Does not compile: each call has a named parameter that the function, or the pack, cannot use. The test `wrong_parameters`
// looks for the sentence, and for the tag of each parameter.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh_to_distance.h>
#include <CGAL/Surface_mesh_coarsening/compute_face_densities.h>

#ifdef WITH_DISTRIBUTED_MESHES
#include <CGAL/Surface_mesh_coarsening/coarsen_distributed_mesh.h>

#include <array>
#include <cstdint>
#include <vector>
#endif

#include <string>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

namespace SMC = CGAL::Surface_mesh_coarsening;
namespace p = CGAL::Surface_mesh_coarsening::parameters;

void call(const Mesh& input, Mesh& output, Mesh::Property_map<Mesh::Vertex_index, SMC::Surface_location<Mesh> > sources,
          Mesh::Property_map<Mesh::Face_index, double> densities, Mesh::Property_map<Mesh::Vertex_index, double> counts,
          Mesh::Property_map<Mesh::Face_index, std::string> names)
{
  SMC::coarsen_mesh(input, 9, output, p::vertex_source_map(sources));
  SMC::coarsen_mesh(input, 9, output, p::maximum_density(3.).vertex_ratio(0.1));
  SMC::coarsen_mesh(input, 9, output, p::default_values(), p::repair_output(true));
  SMC::coarsen_mesh(input, 9, output, p::default_values(), CGAL::parameters::number_of_iterations(3));
  SMC::coarsen_mesh_to_distance(input, 0.1, output, p::neighborhood_level(3));
  SMC::compute_face_densities(input, densities, p::error_feedback(3));
  SMC::Mwcvd_clustering<Mesh> clustering(input, p::vertex_placement(SMC::Fitted_placement()));
  clustering.extract_dual_mesh(output, SMC::Fitted_placement(), p::face_density_map(densities));
  SMC::coarsen_mesh(input, 9, output, p::cluster_weight(SMC::Weighted_area_weight()).cluster_energy(SMC::Quadric_energy()));
  SMC::Mwcvd_clustering<Mesh> of_weight(input, p::cluster_energy(SMC::Quadric_energy()));
  SMC::coarsen_mesh(input, output);
  SMC::coarsen_mesh(input, output, 100);
  SMC::coarsen_mesh(input, 9, output, p::face_density_map(counts));
  SMC::coarsen_mesh(input, 9, output, p::face_cluster_map(names));
  SMC::coarsen_mesh(input, output, p::neighborhood_level(3).vertex_ratio(0.1));
  SMC::coarsen_mesh(input, output, CGAL::parameters::number_of_iterations(3).neighborhood_level(3)); // without adopt()
}

#ifdef WITH_DISTRIBUTED_MESHES
struct Placement_of_all
{
  void operator()(const SMC::Clustered_surface&, const SMC::Border_arcs&, std::vector<std::array<std::uint32_t, 3> >&,
                  std::vector<SMC::Clustered_surface::Point_3>&) const;
};

void call(const boost::mpi::communicator& ranks, const Mesh& piece, Mesh& output,
          Mesh::Property_map<Mesh::Vertex_index, std::uint64_t> numbers, Mesh::Property_map<Mesh::Face_index, double> densities)
{
  SMC::coarsen_distributed_mesh(ranks, piece, numbers, 9, output, p::feature_angle(30.));
  SMC::coarsen_distributed_mesh(ranks, piece, numbers, 9, output, p::vertex_placement(Placement_of_all()));
  SMC::coarsen_distributed_faces(ranks, [](const auto&) {}, 9, output, p::face_density_map(densities));
}
#endif
