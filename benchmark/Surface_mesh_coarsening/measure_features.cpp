// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coarsens a mesh with its features and without, and prints as CSV the distance between the lines of output and input, and
// between the surfaces. Distances are root mean squares in percent of the diagonal of the bounding box.

#include "support/line_distance.h"
#include "support/models.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;
using coarsening_support::Mesh;
typedef Mesh::Property_map<Mesh::Edge_index, bool> Marks;

struct Task
{
  Mesh mesh;
  Marks is_line;
  std::size_t number;
  double angle;
};

// Returns the marks of the lines.
template <class Weight, class Placement>
Marks coarsen(const Task& task, double angle, double maximum_density, Mesh& output)
{
  const Marks is_line = output.add_property_map<Mesh::Edge_index, bool>("e:line", false).first;
  SMC::Mwcvd_clustering<Mesh, Weight> clustering(
    task.mesh, SMC::parameters::maximum_density(maximum_density).feature_angle(angle));
  clustering.seed(task.number);
  clustering.grow();
  clustering.minimize();
  clustering.extract_dual_mesh(output, Placement(), SMC::parameters::edge_is_constrained_map(is_line));
  return is_line;
}

template <class Weight, class Placement>
void measure(const Task& task, const std::string& weight, double maximum_density, const std::string& placement)
{
  const double none = 180; // degrees
  Mesh with, without;
  const Marks is_coarse_line = coarsen<Weight, Placement>(task, task.angle, maximum_density, with);
  coarsen<Weight, Placement>(task, none, maximum_density, without);
  const SMC::Coarsening_quality q = SMC::measure_coarsening(task.mesh, with);
  const auto is_line = [&](Mesh::Edge_index e) { return task.is_line[e]; };
  const auto is_output_line = [&](Mesh::Edge_index e) { return is_coarse_line[e]; };
  const double percent = 100 / q.diagonal;
  std::cout << weight << ',' << maximum_density << ',' << placement << ','
            << percent * test::line_distance(task.mesh, is_line, with, is_output_line) << ','
            << percent * test::line_distance(with, is_output_line, task.mesh, is_line) << ',' << percent * q.rms_distance << ','
            << percent * SMC::measure_coarsening(task.mesh, without).rms_distance << std::endl;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 4) {
    std::cerr << "usage: measure_features FILE NUMBER_OF_VERTICES DEGREES" << std::endl;
    return EXIT_FAILURE;
  }
  try {
    Task task{benchmark_support::read_model(argv[1]), Marks(), std::strtoul(argv[2], nullptr, 10), std::strtod(argv[3], nullptr)};
    task.is_line = task.mesh.add_property_map<Mesh::Edge_index, bool>("e:line", false).first;
    CGAL::Polygon_mesh_processing::detect_sharp_edges(task.mesh, task.angle, task.is_line);
    std::cout.precision(4);
    std::cout << "weight,maximum_density,placement,lines_%,lines_back_%,surface_%,surface_without_features_%" << std::endl;
    measure<SMC::Maximum_density_weight, SMC::Centroid_placement>(task, "maximum", 50, "centroid");
    measure<SMC::Maximum_density_weight, SMC::Quadric_placement>(task, "maximum", 50, "quadric");
    measure<SMC::Maximum_density_weight, SMC::Fitted_placement>(task, "maximum", 50, "fitted");
    measure<SMC::Weighted_area_weight, SMC::Fitted_placement>(task, "area", 10, "fitted");
  } catch (const std::exception& e) {
    std::cerr << "measure_features: " << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
