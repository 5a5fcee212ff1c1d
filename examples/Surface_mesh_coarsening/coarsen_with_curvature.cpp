// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#if __has_include(<CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>)
#  include <CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMC = CGAL::Surface_mesh_coarsening;

// The root of the sum of the squared principal curvatures at each vertex.
std::vector<double> curvatures(Mesh& mesh)
{
  std::vector<double> result;
#if __has_include(<CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>)
  typedef PMP::Principal_curvatures_and_directions<Kernel> Curvatures;
  const auto map = mesh.add_property_map<Mesh::Vertex_index, Curvatures>("v:curvatures").first;
  PMP::interpolated_corrected_curvatures(mesh, CGAL::parameters::vertex_principal_curvatures_and_directions_map(map));
  for (const Mesh::Vertex_index v : mesh.vertices())
    result.push_back(std::hypot(map[v].min_curvature, map[v].max_curvature));
#else
  // Before CGAL 6: the dihedral angle of an edge times its length is the integral of the curvature across it; half of it,
  // and a third of the triangles, belong to the vertex.
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    double turn = 0, area = 0;
    for (const Mesh::Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(v))) {
      if (!mesh.is_border(h))
        area += PMP::face_area(mesh.face(h), mesh) / 3;
      if (mesh.is_border(mesh.edge(h)))
        continue;
      const Kernel::Point_3 &p = mesh.point(mesh.source(h)), &q = mesh.point(v);
      const double angle = CGAL::approximate_dihedral_angle(p, q, mesh.point(mesh.target(mesh.next(h))),
                                                            mesh.point(mesh.target(mesh.next(mesh.opposite(h)))));
      turn += (180 - std::abs(angle)) * CGAL_PI / 180 * std::sqrt(CGAL::squared_distance(p, q)) / 2;
    }
    result.push_back(area > 0 ? turn / area : 0);
  }
#endif
  return result;
}

double rms(const Mesh& input, const Mesh& output)
{
  const SMC::Coarsening_quality quality = SMC::measure_coarsening(input, output);
  return 100 * quality.rms_distance / quality.diagonal;
}

// Derives densities from the curvature instead of the deviation of normals, and compares the two.
int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh input, output;
  if (!CGAL::IO::read_polygon_mesh(name, input)) {
    std::cerr << "cannot read " << name << std::endl;
    return EXIT_FAILURE;
  }

  const std::vector<double> curvature = curvatures(input);
  double mean = 0;
  for (const double c : curvature)
    mean += c / double(curvature.size());
  auto density = input.add_property_map<Mesh::Face_index, double>("f:density").first;
  for (const Mesh::Face_index f : input.faces()) {
    double sum = 0;
    for (const Mesh::Vertex_index v : input.vertices_around_face(input.halfedge(f)))
      sum += curvature[v] / 3;
    density[f] = std::clamp(mean > 0 ? sum / mean : 1, 0.2, 10.); // at most 50 times the density of flat parts
  }

  const auto common = SMC::parameters::cluster_weight(SMC::Weighted_area_weight()).vertex_placement(SMC::Quadric_placement());
  SMC::coarsen_mesh(input, input.number_of_vertices() / 10, output, common);
  std::cout << "RMS distance with densities from normals: " << rms(input, output) << " % of the diagonal" << std::endl;
  SMC::coarsen_mesh(input, input.number_of_vertices() / 10, output, common.face_density_map(density));
  std::cout << "from curvature: " << rms(input, output) << " %" << std::endl;
  return CGAL::IO::write_polygon_mesh("coarse.off", output) ? EXIT_SUCCESS : EXIT_FAILURE;
}
