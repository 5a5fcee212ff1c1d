// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stages of the method, the weights and the placements.

#include "Picture_kit.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Closest_vertex_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/compute_face_densities.h>
#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>

#include <CGAL/subdivision_method_3.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace coarsening_pictures {
namespace {

Camera bunny_camera(const Mesh& mesh) { return camera_for(mesh, Vector(0.2, 0.35, 1), Vector(0, 1, 0), 290); }

void picture_pipeline(const Setting& setting)
{
  const Mesh mesh = read(setting, "fandisk.off");
  const Camera camera = fandisk_camera(mesh);
  std::vector<double> densities(mesh.number_of_faces());
  SMC::compute_face_densities(mesh, boost::make_iterator_property_map(densities.begin(), get(CGAL::face_index, mesh)),
                              SMC::parameters::maximum_density(50.));
  const auto density_color = [&](Face f) { return coarsening_pictures::scale_color((densities[f] - 1) / 49); };

  SMC::Mwcvd_clustering<Mesh, SMC::Maximum_density_weight> clustering(mesh, SMC::parameters::maximum_density(50.));
  clustering.seed(fandisk_vertices);
  std::vector<Face> seeds;
  clustering.seeds(std::back_inserter(seeds));
  std::vector<bool> is_seed(mesh.number_of_faces(), false);
  for (Face seed : seeds)
    is_seed[seed] = true;
  const auto seed_color = [&](Face f) { return is_seed[f] ? Rgb{{205, 75, 15}} : pale(f); };
  const std::string number_of_seeds = counted(seeds.size());

  clustering.grow();
  const Labels grown = labels_of(mesh, clustering);
  clustering.minimize();
  Mesh coarse;
  clustering.extract_dual_mesh(coarse, SMC::Centroid_placement());

  compose(setting.directory, "pipeline",
          {{{drawn(make_scene(mesh, true, pale, any_edge, 0.7, 0.55), camera),
             "input, " + vertices_of(mesh), "", ""},
            {drawn(make_scene(mesh, true, density_color, no_edge, 1, 0), camera), "densities", "1", "50"},
            {drawn(make_scene(mesh, true, seed_color, any_edge, 0.7, 0.3), camera), number_of_seeds + " seeds", "", ""}},
           {{drawn(cluster_scene(mesh, grown), camera), "growth and merging", "", ""},
            {drawn(cluster_scene(mesh, labels_of(mesh, clustering)), camera), "minimization", "", ""},
            {drawn(mesh_scene(coarse), camera), "dual, " + vertices_of(coarse), "", ""}}});
}

// Clusters above, results below.
struct Comparison
{
  const Mesh& mesh;
  const Camera& camera;
  std::vector<std::vector<Panel> > rows = std::vector<std::vector<Panel> >(2);

  void add(const Coarse& coarse, const std::string& caption)
  {
    rows[0].push_back({drawn(cluster_scene(mesh, coarse.labels), camera), "", "", ""});
    rows[1].push_back({drawn(mesh_scene(coarse.mesh), camera), caption, "", ""});
  }
};

void picture_weights(const Setting& setting)
{
  const Mesh mesh = read(setting, "fandisk.off");
  const Camera camera = fandisk_camera(mesh);
  Comparison comparison{mesh, camera};
  comparison.add(coarsened<SMC::Weighted_area_weight>(mesh, fandisk_vertices, 50), "weighted area");
  comparison.add(coarsened<SMC::Maximum_density_weight>(mesh, fandisk_vertices, 50), "maximum density");
  comparison.add(coarsened<SMC::Density_variance_weight>(mesh, fandisk_vertices, 3), "density variance");
  compose(setting.directory, "weights", comparison.rows);
}

void picture_cvd_and_mwcvd(const Setting& setting)
{
  const Mesh mesh = read(setting, "bunny00.off");
  const Camera camera = bunny_camera(mesh);
  Comparison comparison{mesh, camera};
  comparison.add(coarsened<SMC::Uniform_weight>(mesh, 594, 50), "without weights (CVD)");
  comparison.add(coarsened<SMC::Maximum_density_weight>(mesh, 594, 50), "maximum density (MWCVD)");
  compose(setting.directory, "cvd_and_mwcvd", comparison.rows);
}

void picture_placements(const Setting& setting)
{
  const Mesh mesh = read(setting, "fandisk.off");
  const Camera camera = fandisk_camera(mesh);
  SMC::Mwcvd_clustering<Mesh, SMC::Maximum_density_weight> clustering(mesh, SMC::parameters::maximum_density(50.));
  clustering.seed(200);
  clustering.grow();
  clustering.minimize();
  std::vector<Panel> panels;
  const auto add = [&](const auto& placement, const std::string& name) {
    Mesh coarse;
    clustering.extract_dual_mesh(coarse, placement);
    const SMC::Coarsening_quality q = SMC::measure_coarsening(mesh, coarse, 30000);
    panels.push_back({drawn(mesh_scene(coarse), camera),
                      name + ", " + rounded(100 * q.rms_distance / q.diagonal, 2) + " %", "", ""});
  };
  add(SMC::Centroid_placement(), "centroid");
  add(SMC::Closest_vertex_placement(), "closest vertex");
  add(SMC::Quadric_placement(), "quadric");
  add(SMC::Fitted_placement(), "fitted");
  compose(setting.directory, "placements", {{panels[0], panels[1]}, {panels[2], panels[3]}});
}

void picture_quads(const Setting& setting)
{
  Mesh mesh = read(setting, "torus_quad.off");
  CGAL::Subdivision_method_3::CatmullClark_subdivision(mesh, CGAL::parameters::number_of_iterations(4));
  const Camera camera = camera_for(mesh, Vector(1, 0.9, 0.8), Vector(0, 0, 1));
  const Coarse coarse = coarsened<SMC::Weighted_area_weight>(mesh, 200, 20);
  compose(setting.directory, "quads",
          {{{polygons(mesh, camera), "input, " + counted(mesh.number_of_faces()) + " faces", "", ""},
            {drawn(cluster_scene(mesh, coarse.labels), camera), "clusters", "", ""},
            {drawn(mesh_scene(coarse.mesh), camera), "result, " + vertices_of(coarse.mesh), "", ""}}});
}

// An overview of the package, with the defaults of the tool.
void picture_overview(const Setting& setting)
{
  const Mesh bunny = read(setting, "bunny00.off");
  const Camera camera = bunny_camera(bunny);
  const Coarse coarse = coarsened<SMC::Weighted_area_weight>(bunny, 1000, 10, SMC::Fitted_placement());
  compose(setting.directory, "overview",
          {{{polygons(bunny, camera), vertices_of(bunny), "", ""},
            {drawn(cluster_scene(bunny, coarse.labels), camera), counted(coarse.mesh.number_of_vertices()) + " clusters", "", ""},
            {drawn(mesh_scene(coarse.mesh), camera), vertices_of(coarse.mesh), "", ""}}});
}

} // namespace

Pictures pictures_of_the_method()
{
  return {{"overview", picture_overview},     {"pipeline", picture_pipeline},
          {"weights", picture_weights},       {"cvd_and_mwcvd", picture_cvd_and_mwcvd},
          {"placements", picture_placements}, {"quads", picture_quads}};
}

} // namespace coarsening_pictures
