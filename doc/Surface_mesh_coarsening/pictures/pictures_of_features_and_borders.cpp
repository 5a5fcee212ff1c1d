// SPDX-License-Identifier: GPL-3.0-or-later
//
// Features off and on, borders, and holes that are kept or filled.

#include "Picture_kit.h"

#include "repair/fill_holes.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace coarsening_pictures {
namespace {

typedef Mesh::Property_map<Edge, bool> Marks;

Marks sharp_edges(Mesh& mesh)
{
  const Marks marks = mesh.add_property_map<Edge, bool>("e:is_sharp", false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, 30, marks);
  return marks;
}

// A result in pale lines with some in bold.
Image with_lines(const Mesh& mesh, const Marks& marks, const Camera& camera, bool smooth, double ink)
{
  Scene scene = make_scene(mesh, smooth, smooth ? pale : bluish, any_edge, 0.9, ink);
  add_bold(scene, mesh, [&](Edge e) { return marks[e]; });
  return drawn(scene, camera);
}

// Without features, the lines are the edges of 30 degrees and more that the result happens to have.
template <class Placement>
Image without_features(const Mesh& mesh, const Camera& camera, const Placement& placement)
{
  Mesh coarse;
  SMC::coarsen_mesh(mesh, fandisk_vertices, coarse, SMC::parameters::vertex_placement(placement));
  return with_lines(coarse, sharp_edges(coarse), camera, false, 0.45);
}

template <class Placement>
Image with_features(const Mesh& mesh, const Camera& camera, const Placement& placement, Labels& labels)
{
  Mesh coarse;
  const Marks marks = coarse.add_property_map<Edge, bool>("e:is_feature", false).first;
  labels.resize(mesh.number_of_faces());
  const auto clusters = boost::make_iterator_property_map(labels.begin(), get(CGAL::face_index, mesh));
  SMC::coarsen_mesh(mesh, fandisk_vertices, coarse,
                    SMC::parameters::feature_angle(30.).vertex_placement(placement).face_cluster_map(clusters),
                    SMC::parameters::edge_is_constrained_map(marks));
  return with_lines(coarse, marks, camera, false, 0.45);
}

void picture_features(const Setting& setting)
{
  Mesh mesh = read(setting, "fandisk.off");
  const Camera camera = fandisk_camera(mesh);
  const Marks lines = sharp_edges(mesh);
  Labels labels;
  const Image centroids = with_features(mesh, camera, SMC::Centroid_placement(), labels);
  Scene clusters = cluster_scene(mesh, labels);
  add_bold(clusters, mesh, [&](Edge e) { return lines[e]; });
  compose(setting.directory, "features",
          {{{with_lines(mesh, lines, camera, true, 0.2), "input, edges of 30 degrees and more", "", ""},
            {without_features(mesh, camera, SMC::Centroid_placement()), "without features, centroids", "", ""},
            {without_features(mesh, camera, SMC::Fitted_placement()), "without features, fitted", "", ""}},
           {{drawn(clusters, camera), "clusters astride the lines", "", ""},
            {centroids, "with features, centroids", "", ""},
            {with_features(mesh, camera, SMC::Fitted_placement(), labels), "with features, fitted", "", ""}}});
}

// A result with its border in bold.
Image with_border(const Mesh& mesh, const Camera& camera)
{
  Scene scene = mesh_scene(mesh);
  add_bold(scene, mesh, [&](Edge e) { return mesh.is_border(e); }, 2);
  return drawn(scene, camera);
}

void picture_borders(const Setting& setting)
{
  const Mesh mesh = read(setting, "lion-head.off");
  const Camera camera = camera_for(mesh, Vector(1.2, 0.2, -0.2), Vector(0, 1, 0));
  const Coarse coarse = coarsened<SMC::Weighted_area_weight>(mesh, 400, 10, SMC::Fitted_placement());
  compose(setting.directory, "borders",
          {{{polygons(mesh, camera), "input, " + vertices_of(mesh), "", ""},
            {drawn(cluster_scene(mesh, coarse.labels), camera), "clusters", "", ""},
            {with_border(coarse.mesh, camera), "result, " + vertices_of(coarse.mesh), "", ""}}});
}

void picture_holes(const Setting& setting)
{
  const Mesh mesh = read(setting, "mech-holes-shark.off");
  Mesh filled = mesh;
  const coarsen_mesh_tool::Hole_filling filling =
    coarsen_mesh_tool::fill_holes(filled, std::numeric_limits<double>::infinity());
  const Camera camera = camera_for(mesh, Vector(0.3, 0.5, 1), Vector(0, 1, 0));
  const auto result = [](const Mesh& input) {
    return coarsened<SMC::Weighted_area_weight>(input, 400, 10, SMC::Fitted_placement()).mesh;
  };
  const Mesh kept = result(mesh), without = result(filled);
  Scene scene = make_scene(mesh, true, pale, any_edge, 0.7, 0.35);
  add_bold(scene, mesh, [&](Edge e) { return mesh.is_border(e); }, 2);
  compose(setting.directory, "holes",
          {{{drawn(scene, camera), "input, " + vertices_of(mesh), "", ""},
            {with_border(kept, camera), "holes kept, " + vertices_of(kept), "", ""},
            {with_border(without, camera), std::to_string(filling.number(coarsen_mesh_tool::Hole_state::FILLED)) + " holes filled before, " + vertices_of(without), "",
             ""}}});
}

} // namespace

Pictures pictures_of_features_and_borders()
{
  return {{"features", picture_features}, {"borders", picture_borders}, {"holes", picture_holes}};
}

} // namespace coarsening_pictures
