// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coarsens meshes with the weights, maximum densities and placements, and prints as CSV the distance of the output from the
// input and the shape of its triangles. Distances are in percent of the diagonal of the bounding box, angles in degrees.

#include "support/Stopwatch.h"
#include "support/models.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Closest_vertex_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;
using coarsening_support::Mesh;

// A triangle with a smaller angle is a sliver.
constexpr double sliver = 20;

struct Row
{
  std::string model, weight;
  double maximum_density;
  std::size_t number;
};

double part_of_slivers(const Mesh& mesh)
{
  const SMC::internal::Triangle_mesh copy =
    SMC::internal::triangulated_copy(mesh, SMC::parameters::default_values());
  std::size_t slivers = 0;
  for (const auto f : copy.faces())
    slivers += SMC::internal::smallest_angle(copy, f) < sliver;
  return double(slivers) / double(copy.number_of_faces());
}

template <class Clustering, class Placement>
void place(const Row& row, const Mesh& mesh, Clustering& clustering, double seconds_before,
           const std::string& name, const Placement& placement)
{
  Mesh output;
  const benchmark_support::Stopwatch watch;
  clustering.extract_dual_mesh(output, placement);
  const double seconds = watch.seconds();
  const SMC::Coarsening_quality q = SMC::measure_coarsening(mesh, output);
  const SMC::Coarsening_report& report = clustering.report();
  const double percent = 100 / q.diagonal;
  std::cout << row.model << ',' << mesh.number_of_faces() << ',' << row.number << ',' << row.weight << ','
            << row.maximum_density << ',' << name << ',' << percent * q.rms_distance << ','
            << percent * q.maximum_distance << ',' << q.mean_smallest_angle << ',' << 100 * part_of_slivers(output)
            << ',' << report.intersections_found << ',' << report.intersections_left << ',' << q.self_intersections
            << ',' << report.reversals_found << ',' << report.reversals_left << ',' << seconds_before << ',' << seconds
            << std::endl;
}

template <class Weight>
void compare(Row row, const Mesh& mesh, const std::string& weight, double maximum_density)
{
  row.weight = weight;
  row.maximum_density = maximum_density;
  try {
    const benchmark_support::Stopwatch watch;
    SMC::Mwcvd_clustering<Mesh, Weight> clustering(mesh, SMC::parameters::maximum_density(maximum_density));
    clustering.seed(row.number);
    clustering.grow();
    clustering.minimize();
    const double seconds = watch.seconds();
    place(row, mesh, clustering, seconds, "centroid", SMC::Centroid_placement());
    place(row, mesh, clustering, seconds, "closest-vertex", SMC::Closest_vertex_placement());
    place(row, mesh, clustering, seconds, "quadric", SMC::Quadric_placement());
    place(row, mesh, clustering, seconds, "fitted", SMC::Fitted_placement());
  } catch (const std::exception& e) {
    std::cerr << row.model << ", " << row.number << " vertices: " << e.what() << std::endl;
  }
}

void compare(const Row& row, const Mesh& mesh)
{
  compare<SMC::Uniform_weight>(row, mesh, "uniform", 1);
  for (const double r : {10., 50.}) {
    compare<SMC::Weighted_area_weight>(row, mesh, "area", r);
    compare<SMC::Maximum_density_weight>(row, mesh, "maximum", r);
  }
  compare<SMC::Density_variance_weight>(row, mesh, "variance", 3);
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 3) {
    std::cerr << "usage: compare_placements PERCENT[,PERCENT...] FILE..." << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "model,faces,vertices,weight,maximum_density,placement,rms_%,maximum_%,mean_smallest_angle,"
               "angles_below_20_%,intersections_found,intersections_left,intersections_in_output,reversals_found,"
               "reversals_left,clustering_s,placement_s"
            << std::endl;
  try {
    for (int i = 2; i < argc; ++i) {
      const Mesh mesh = benchmark_support::read_model(argv[i]);
      const char* at = argv[1];
      for (char* end = nullptr;; at = end + 1) {
        const double percent = std::strtod(at, &end);
        const Row row{std::filesystem::path(argv[i]).stem().string(), "", 0,
                      std::size_t(percent / 100 * double(mesh.number_of_vertices()))};
        compare(row, mesh);
        if (*end != ',')
          break;
      }
    }
  } catch (const std::exception& e) {
    std::cerr << "compare_placements: " << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
