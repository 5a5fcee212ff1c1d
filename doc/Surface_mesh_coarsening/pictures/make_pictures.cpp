// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the pictures of the manual and the README, and the figures that they show:
//   make_pictures CGAL_MESHES DIRECTORY
// reads meshes of CGAL's data directory and writes panels, tables and scripts for gnuplot. The target `pictures` runs both.

#include "Composition.h"

#include "support/Scene.h"
#include "support/render.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Closest_vertex_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/compute_face_densities.h>
#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>

#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;
using namespace coarsening_support;
using coarsening_pictures::compose;
using coarsening_pictures::Panel;
using coarsening_pictures::write_file;

typedef std::vector<std::size_t> Labels;

const double panel_size = 300;
const std::size_t fandisk_vertices = 527;

struct Setting
{
  std::filesystem::path meshes, directory;
};

Mesh read(const Setting& setting, const std::string& name)
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh((setting.meshes / name).string(), mesh))
    throw std::runtime_error("cannot read " + (setting.meshes / name).string());
  return mesh;
}

std::string rounded(double value, int digits)
{
  std::ostringstream os;
  os.precision(digits);
  os << std::fixed << value;
  return os.str();
}

Camera camera_for(const Mesh& mesh, const Vector& view, const Vector& up)
{
  return Camera(std::vector<Point>(mesh.points().begin(), mesh.points().end()), view, up, panel_size);
}

Camera fandisk_camera(const Mesh& mesh) { return camera_for(mesh, Vector(1, 0.5, 0.8), Vector(0, 1, 0)); }

template <class Clustering>
Labels labels_of(const Mesh& mesh, const Clustering& clustering)
{
  Labels labels;
  for (Face f : mesh.faces())
    labels.push_back(clustering.cluster(f));
  return labels;
}

// A result with its clusters.
struct Coarse
{
  Mesh mesh;
  Labels labels;
};

template <class Weight>
Coarse coarsened(const Mesh& input, std::size_t vertices, double maximum_density)
{
  SMC::Mwcvd_clustering<Mesh, Weight> clustering(input, SMC::parameters::maximum_density(maximum_density));
  clustering.seed(vertices);
  clustering.grow();
  clustering.minimize();
  Coarse result;
  clustering.extract_dual_mesh(result.mesh);
  result.labels = labels_of(input, clustering);
  return result;
}

bool any_edge(Edge) { return true; }
bool no_edge(Edge) { return false; }

Rgb pale(Face) { return Rgb{{205, 212, 222}}; }

void picture_pipeline(const Setting& setting, const Mesh& mesh)
{
  const Camera camera = fandisk_camera(mesh);
  std::vector<double> densities(mesh.number_of_faces());
  SMC::compute_face_densities(mesh, boost::make_iterator_property_map(densities.begin(), get(CGAL::face_index, mesh)));
  const auto density_color = [&](Face f) { return coarsening_pictures::scale_color((densities[f] - 1) / 49); };

  SMC::Mwcvd_clustering<Mesh> clustering(mesh);
  clustering.seed(fandisk_vertices);
  std::vector<Face> seeds;
  clustering.seeds(std::back_inserter(seeds));
  // A face alone would hardly be seen.
  std::vector<bool> near_seed(mesh.number_of_faces(), false);
  for (Face seed : seeds) {
    near_seed[seed] = true;
    for (Face f : mesh.faces_around_face(mesh.halfedge(seed)))
      if (f != mesh.null_face())
        near_seed[f] = true;
  }
  const auto seed_color = [&](Face f) { return near_seed[f] ? Rgb{{205, 75, 15}} : pale(f); };
  const std::string number_of_seeds = std::to_string(seeds.size());

  clustering.grow();
  const Labels grown = labels_of(mesh, clustering);
  clustering.minimize();
  Mesh coarse;
  clustering.extract_dual_mesh(coarse);

  compose(setting.directory, "pipeline",
          {{{render(make_scene(mesh, true, pale, any_edge, 0.7, 0.55), camera),
             "input, " + std::to_string(mesh.number_of_vertices()) + " vertices", "", ""},
            {render(make_scene(mesh, true, density_color, no_edge, 1, 0), camera), "densities", "1", "50"},
            {render(make_scene(mesh, true, seed_color, no_edge, 1, 0), camera), number_of_seeds + " seeds", "", ""}},
           {{render(cluster_scene(mesh, grown), camera), "growth and merging", "", ""},
            {render(cluster_scene(mesh, labels_of(mesh, clustering)), camera), "minimization", "", ""},
            {render(mesh_scene(coarse), camera), "dual, " + std::to_string(coarse.number_of_vertices()) + " vertices",
             "", ""}}});
}

void picture_weights(const Setting& setting, const Mesh& mesh)
{
  const Camera camera = fandisk_camera(mesh);
  const Coarse area = coarsened<SMC::Weighted_area_weight>(mesh, fandisk_vertices, 50),
               maximum = coarsened<SMC::Maximum_density_weight>(mesh, fandisk_vertices, 50),
               variance = coarsened<SMC::Density_variance_weight>(mesh, fandisk_vertices, 3),
               uniform = coarsened<SMC::Uniform_weight>(mesh, fandisk_vertices, 50);
  std::vector<std::vector<Panel> > rows(2);
  const auto add = [&](const Coarse& coarse, const std::string& caption) {
    rows[0].push_back({render(cluster_scene(mesh, coarse.labels), camera), "", "", ""});
    rows[1].push_back({render(mesh_scene(coarse.mesh), camera), caption, "", ""});
  };
  add(area, "weighted area");
  add(maximum, "maximum density");
  add(variance, "density variance");
  compose(setting.directory, "weights", rows);
  rows.assign(2, {});
  add(uniform, "without weights (CVD)");
  add(area, "with weights (MWCVD)");
  compose(setting.directory, "cvd_and_mwcvd", rows);
}

void picture_placements(const Setting& setting, const Mesh& mesh)
{
  const Camera camera = fandisk_camera(mesh);
  SMC::Mwcvd_clustering<Mesh> clustering(mesh);
  clustering.seed(200);
  clustering.grow();
  clustering.minimize();
  std::vector<Panel> panels;
  const auto add = [&](const auto& placement, const std::string& name) {
    Mesh coarse;
    clustering.extract_dual_mesh(coarse, placement);
    const SMC::Coarsening_quality q = SMC::measure_coarsening(mesh, coarse, 30000);
    const auto color = [](Face) { return Rgb{{190, 208, 228}}; };
    panels.push_back({render(make_scene(coarse, false, color, any_edge, 1.1, 0.8), camera),
                      name + ", " + rounded(100 * q.rms_distance / q.diagonal, 2) + " %", "", ""});
  };
  add(SMC::Centroid_placement(), "centroid");
  add(SMC::Closest_vertex_placement(), "closest vertex");
  add(SMC::Quadric_placement(), "quadric");
  add(SMC::Fitted_placement(), "fitted");
  compose(setting.directory, "placements", {{panels[0], panels[1]}, {panels[2], panels[3]}});
}

// The edges of a polygon mesh, without those that its triangulation adds.
Image polygons(const Mesh& mesh, const Camera& camera)
{
  Labels faces;
  for (Face f : mesh.faces())
    faces.push_back(f);
  const Mesh triangles = triangulated(mesh, faces);
  const auto is_drawn = [&](Edge e) {
    return triangles.is_border(e) ||
           faces[triangles.face(triangles.halfedge(e, 0))] != faces[triangles.face(triangles.halfedge(e, 1))];
  };
  return render(make_scene(triangles, true, pale, is_drawn, 0.7, 0.55), camera);
}

void picture_of(const Setting& setting, const std::string& name, const Mesh& mesh, std::size_t vertices, const Camera& camera)
{
  const Coarse coarse = coarsened<SMC::Weighted_area_weight>(mesh, vertices, 20);
  compose(setting.directory, name,
          {{{polygons(mesh, camera), "input, " + std::to_string(mesh.number_of_faces()) + " faces", "", ""},
            {render(cluster_scene(mesh, coarse.labels), camera), "clusters", "", ""},
            {render(mesh_scene(coarse.mesh), camera), "result, " + std::to_string(coarse.mesh.number_of_vertices()) + " vertices",
             "", ""}}});
}

void picture_quads(const Setting& setting)
{
  Mesh mesh = read(setting, "torus_quad.off");
  CGAL::Subdivision_method_3::CatmullClark_subdivision(mesh, CGAL::parameters::number_of_iterations(4));
  picture_of(setting, "quads", mesh, 200, camera_for(mesh, Vector(1, 0.9, 0.8), Vector(0, 0, 1)));
}

void picture_borders(const Setting& setting)
{
  const Mesh mesh = read(setting, "lion-head.off");
  picture_of(setting, "borders", mesh, 400, camera_for(mesh, Vector(1.2, 0.2, -0.2), Vector(0, 1, 0)));
}

// What edge collapses have to reach.
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

void plot_error_and_shape(const Setting& setting, const Mesh& mesh)
{
  const std::string table = measured_placements<SMC::Uniform_weight>(mesh, 1) +
                            measured_placements<SMC::Weighted_area_weight>(mesh, 50) +
                            measured_placements<SMC::Maximum_density_weight>(mesh, 50) +
                            measured_placements<SMC::Density_variance_weight>(mesh, 3) +
                            measured(mesh, edge_collapsed(mesh, fandisk_vertices));
  write_file(setting.directory / "error_and_shape.dat", table);
  std::string script = R"(set terminal pngcairo size 760,480 font 'DejaVu Sans,10'
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

void plot_scaling(const Setting& setting, Mesh mesh)
{
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
  write_file(setting.directory / "scaling.gp", R"(set terminal pngcairo size 640,440 font 'DejaVu Sans,10'
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

int main(int argc, char* argv[])
{
  if (argc != 3) {
    std::cerr << "Usage: make_pictures CGAL_MESHES DIRECTORY\n";
    return EXIT_FAILURE;
  }
  try {
    const Setting setting{argv[1], argv[2]};
    std::filesystem::create_directories(setting.directory / "figures");
    const Mesh fandisk = read(setting, "fandisk.off");
    picture_pipeline(setting, fandisk);
    picture_weights(setting, fandisk);
    picture_placements(setting, fandisk);
    picture_borders(setting);
    picture_quads(setting);
    plot_error_and_shape(setting, fandisk);
    plot_scaling(setting, fandisk);
    return EXIT_SUCCESS;
  } catch (const std::exception& e) {
    std::cerr << "make_pictures: " << e.what() << "\n";
    return EXIT_FAILURE;
  }
}
