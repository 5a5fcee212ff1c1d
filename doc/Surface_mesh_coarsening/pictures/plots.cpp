// SPDX-License-Identifier: GPL-3.0-or-later
//
// The plots of error against shape and of time against size, and their figures.

#include "Picture_kit.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Closest_vertex_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>

#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/subdivision_method_3.h>

#include <cstddef>
#include <ctime>
#include <iostream>
#include <string>

namespace coarsening_pictures {
namespace {

// The stop predicate of edge collapses.
struct Few_edges_left
{
  std::size_t edges;
  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile&, std::size_t, std::size_t current) const
  {
    return current <= edges;
  }
};

Mesh edge_collapsed(Mesh mesh, std::size_t vertices)
{
  const std::size_t removed = 3 * (mesh.number_of_vertices() - vertices);
  CGAL::Surface_mesh_simplification::edge_collapse(mesh, Few_edges_left{mesh.number_of_edges() - removed});
  mesh.collect_garbage();
  return mesh;
}

// One line of a table: distance in % of the diagonal, and the mean of the smallest angles.
std::string measured(const Mesh& input, const Mesh& coarse)
{
  const SMC::Coarsening_quality q = SMC::measure_coarsening(input, coarse, 50000);
  return rounded(100 * q.rms_distance / q.diagonal, 4) + " " + rounded(q.mean_smallest_angle, 2) + "\n";
}

// A block for each weight: a line for each placement.
template <class Weight>
std::string measured_placements(const Mesh& mesh, double maximum_density)
{
  SMC::Mwcvd_clustering<Mesh, Weight> clustering(mesh, SMC::parameters::maximum_density(maximum_density));
  clustering.seed(fandisk_vertices);
  clustering.grow();
  clustering.minimize();
  std::string table;
  const auto add = [&](const auto& placement) {
    Mesh coarse;
    clustering.extract_dual_mesh(coarse, placement);
    table += measured(mesh, coarse);
  };
  add(SMC::Centroid_placement());
  add(SMC::Closest_vertex_placement());
  add(SMC::Quadric_placement());
  add(SMC::Fitted_placement());
  return table + "\n\n";
}

void plot_error_and_shape(const Setting& setting)
{
  const Mesh mesh = read(setting, "fandisk.off");
  const std::string table = measured_placements<SMC::Uniform_weight>(mesh, 1) +
                            measured_placements<SMC::Weighted_area_weight>(mesh, 50) +
                            measured_placements<SMC::Maximum_density_weight>(mesh, 50) +
                            measured_placements<SMC::Density_variance_weight>(mesh, 3) +
                            measured(mesh, edge_collapsed(mesh, fandisk_vertices));
  write_file(setting.directory / "error_and_shape.dat", table);
  std::string script = R"(set terminal pngcairo size 1520,960 font 'DejaVu Sans,10' fontscale 2 linewidth 2 pointscale 2
set output 'figures/error_and_shape.png'
set xlabel 'RMS distance, % of the diagonal'
set ylabel 'mean smallest angle, degrees'
set logscale x
set yrange [15:55]
set grid
set key outside right
array color[4] = ['#666666', '#1b7fbd', '#d95f02', '#1b9e77']
array weight[4] = ['uniform', 'area', 'maximum', 'variance']
array mark[4] = [7, 5, 9, 13]
array place[4] = ['centroid', 'closest vertex', 'quadric', 'fitted']
plot for [w=1:4] 'error_and_shape.dat' index w-1 using 1:2 with lines lc rgb color[w] lw 2 title weight[w], \
  for [w=1:4] for [p=1:4] 'error_and_shape.dat' index w-1 every ::p-1::p-1 using 1:2 with points pt mark[p] ps 1.4 \
    lc rgb color[w] notitle, \
  for [p=1:4] NaN with points pt mark[p] ps 1.4 lc rgb 'black' title place[p], \
  'error_and_shape.dat' index 4 using 1:2 with points pt 3 ps 1.8 lw 2 lc rgb '#aa0044' title 'edge collapse'
)";
  write_file(setting.directory / "error_and_shape.gp", script);
  std::cout << "RMS distance and mean smallest angle; uniform, area, maximum, variance; edge collapse\n" << table;
}

double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

template <class Function>
std::string timed(const Function& function)
{
  const double begin = processor_seconds();
  function();
  return " " + rounded(processor_seconds() - begin, 3);
}

void plot_scaling(const Setting& setting)
{
  Mesh mesh = read(setting, "fandisk.off");
  std::string table;
  for (int level = 0; level < 4; ++level) {
    if (level > 0)
      CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
    const std::size_t vertices = mesh.number_of_vertices() / 100;
    table += std::to_string(mesh.number_of_faces());
    table += timed([&] { coarsened<SMC::Uniform_weight>(mesh, vertices, 1); });
    table += timed([&] { coarsened<SMC::Weighted_area_weight>(mesh, vertices, 50); });
    table += timed([&] { coarsened<SMC::Maximum_density_weight>(mesh, vertices, 50); });
    table += timed([&] { edge_collapsed(mesh, vertices); }) + "\n";
  }
  write_file(setting.directory / "scaling.dat", table);
  write_file(setting.directory / "scaling.gp", R"(set terminal pngcairo size 1280,880 font 'DejaVu Sans,10' fontscale 2 linewidth 2 pointscale 2
set output 'figures/scaling.png'
set xlabel 'faces of the input'
set ylabel 'processor seconds'
set logscale xy
set format x '10^{%L}'
set grid
set key left top
plot 'scaling.dat' using 1:2 with linespoints lw 2 pt 7 lc rgb '#666666' title 'uniform', \
  '' using 1:3 with linespoints lw 2 pt 7 lc rgb '#1b7fbd' title 'area', \
  '' using 1:4 with linespoints lw 2 pt 7 lc rgb '#d95f02' title 'maximum', \
  '' using 1:5 with linespoints lw 2 pt 3 lc rgb '#aa0044' title 'edge collapse', \
  '' using 1:($1 * 1e-5) with lines dt 2 lc rgb 'black' title '10 microseconds a face'
)");
  std::cout << "faces, processor seconds of uniform, area, maximum, edge collapse\n" << table;
}

} // namespace

Pictures plots() { return {{"error_and_shape", plot_error_and_shape}, {"scaling", plot_scaling}}; }

} // namespace coarsening_pictures
