// SPDX-License-Identifier: GPL-3.0-or-later
//
// Transferred properties, a bound of the distance, levels of detail.

#include "Picture_kit.h"

#include "render/face_distances.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_levels.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Property_resampler.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh_to_distance.h>


#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

namespace coarsening_pictures {
namespace {

typedef std::array<double, 3> Weights; // of the corners of a triangle, the first of which is the target of its halfedge

// Subdivides triangles so finely that colors can change within them.
Scene painted_scene(const Mesh& mesh, bool smooth, std::size_t parts, const std::function<Rgb(Face, const Weights&)>& color,
                    const std::function<bool(Edge)>& is_drawn, double width, double ink)
{
  Scene scene = make_scene(mesh, smooth, pale, is_drawn, width, ink);
  const std::vector<Scene::Triangle> whole = std::move(scene.triangles);
  scene.triangles.clear();
  const double n = double(parts);
  std::size_t number = 0;
  for (Face f : mesh.faces()) {
    const Scene::Triangle& t = whole[number++];
    const auto add = [&](const std::array<Weights, 3>& corners) {
      Scene::Triangle part;
      Weights middle = {0, 0, 0};
      for (std::size_t i = 0; i < 3; ++i) {
        Vector p = CGAL::NULL_VECTOR, normal = CGAL::NULL_VECTOR;
        for (std::size_t j = 0; j < 3; ++j) {
          p = p + corners[i][j] * (scene.points[t.vertices[j]] - CGAL::ORIGIN);
          normal = normal + corners[i][j] * t.normals[j];
          middle[j] += corners[i][j] / 3;
        }
        part.vertices[i] = scene.points.size();
        scene.points.push_back(CGAL::ORIGIN + p);
        part.normals[i] = unit(normal);
      }
      part.color = color(f, middle);
      scene.triangles.push_back(part);
    };
    const auto at = [n](std::size_t i, std::size_t j) { return Weights{double(i) / n, double(j) / n, (n - double(i + j)) / n}; };
    for (std::size_t i = 0; i < parts; ++i)
      for (std::size_t j = 0; i + j < parts; ++j) {
        add({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 1 < parts)
          add({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  return scene;
}

typedef std::array<double, 2> Texture_point;
typedef Mesh::Property_map<Halfedge, Texture_point> Texture;

// A wavy torus, with a texture from 0 to 1 in both directions that has seams along a meridian and a parallel.
Mesh waved_torus(std::size_t around, std::size_t across)
{
  Mesh mesh;
  std::vector<Vertex> grid;
  for (std::size_t i = 0; i < around; ++i)
    for (std::size_t j = 0; j < across; ++j) {
      const double u = 2 * CGAL_PI * double(i) / double(around), v = 2 * CGAL_PI * double(j) / double(across);
      const double r = 1 + 0.12 * std::cos(6 * u), ring = 2.4 + r * std::cos(v);
      grid.push_back(mesh.add_vertex(Point(ring * std::cos(u), ring * std::sin(u), r * std::sin(v))));
    }
  const Texture texture = mesh.add_property_map<Halfedge, Texture_point>("h:texture").first;
  const auto add = [&](const std::array<std::array<std::size_t, 2>, 3>& corners) {
    const auto vertex = [&](std::size_t k) { return grid[(corners[k][0] % around) * across + corners[k][1] % across]; };
    Halfedge h = mesh.halfedge(mesh.add_face(vertex(0), vertex(1), vertex(2)));
    while (mesh.target(h) != vertex(0))
      h = mesh.next(h);
    for (std::size_t k = 0; k < 3; ++k, h = mesh.next(h))
      texture[h] = {{double(corners[k][0]) / double(around), double(corners[k][1]) / double(across)}};
  };
  for (std::size_t i = 0; i < around; ++i)
    for (std::size_t j = 0; j < across; ++j) {
      add({{{{i, j}}, {{i + 1, j}}, {{i + 1, j + 1}}}});
      add({{{{i, j}}, {{i + 1, j + 1}}, {{i, j + 1}}}});
    }
  return mesh;
}

// Squares whose color changes across the texture, so that its seams are visible.
Rgb texture_color(double u, double v)
{
  const auto wrapped = [](double x) { return (std::min)(0.999999, (std::max)(0., x)); };
  const bool is_light = (int(24 * wrapped(u)) + int(8 * wrapped(v))) % 2 == 0;
  return from_hue(0.3 + 3.9 * wrapped(u), is_light ? 0.15 : 0.55, 0.98);
}

Texture texture_of(const Mesh& mesh)
{
  const auto found = mesh.property_map<Halfedge, Texture_point>("h:texture");
#if CGAL_VERSION_NR >= 1060000000
  return *found;
#else
  return found.first;
#endif
}

Image textured(const Mesh& mesh, const Camera& camera, std::size_t parts, double ink)
{
  const Texture texture = texture_of(mesh);
  const auto color = [&](Face f, const Weights& w) {
    Texture_point at = {{0, 0}};
    Halfedge h = mesh.halfedge(f);
    for (std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
      for (std::size_t c = 0; c < 2; ++c)
        at[c] += w[i] * texture[h][c];
    return texture_color(at[0], at[1]);
  };
  Scene scene = painted_scene(mesh, ink == 0, parts, color, any_edge, 0.9, ink);
  const auto is_seam = [&](Edge e) {
    const Halfedge h = mesh.halfedge(e, 0), g = mesh.halfedge(e, 1);
    return texture[h] != texture[mesh.prev(g)] || texture[g] != texture[mesh.prev(h)];
  };
  add_bold(scene, mesh, is_seam);
  return drawn(scene, camera);
}

// The field is a wave around a point, on vertices.
Image with_field(const Mesh& mesh, const std::vector<double>& field, const Camera& camera, std::size_t parts, double ink)
{
  const auto color = [&](Face f, const Weights& w) {
    double value = 0;
    Halfedge h = mesh.halfedge(f);
    for (std::size_t i = 0; i < 3; ++i, h = mesh.next(h))
      value += w[i] * field[mesh.target(h)];
    return scale_color(value);
  };
  return drawn(painted_scene(mesh, ink == 0, parts, color, any_edge, 0.9, ink), camera);
}

void picture_properties(const Setting& setting)
{
  const Mesh bunny = read(setting, "bunny00.off");
  const Camera camera = camera_for(bunny, Vector(0.2, 0.35, 1), Vector(0, 1, 0), 280);
  const Coarse coarse = coarsened<SMC::Weighted_area_weight>(bunny, 2000, 10, SMC::Fitted_placement());
  const Point center = *std::max_element(bunny.points().begin(), bunny.points().end(),
                                         [](const Point& p, const Point& q) { return p.y() < q.y(); });
  double size = 0;
  for (const Point& p : bunny.points())
    size = (std::max)(size, std::sqrt(CGAL::squared_distance(p, center)));
  std::vector<double> field, coarse_field(coarse.mesh.number_of_vertices());
  for (const Point& p : bunny.points())
    field.push_back(0.5 + 0.5 * std::cos(18 * std::sqrt(CGAL::squared_distance(p, center)) / size));
  const auto clusters = boost::make_iterator_property_map(coarse.labels.begin(), get(CGAL::face_index, bunny));
  SMC::Property_resampler<Mesh, Mesh>(bunny, clusters, coarse.mesh)
    .transfer_vertex_property(boost::make_iterator_property_map(field.begin(), get(CGAL::vertex_index, bunny)),
                              boost::make_iterator_property_map(coarse_field.begin(), get(CGAL::vertex_index, coarse.mesh)),
                              SMC::Transfer_policy::INTERPOLATED);

  const Mesh torus = waved_torus(240, 100);
  const Camera torus_camera = camera_for(torus, Vector(0.45, -0.75, 0.9), Vector(0, 0, 1), 280);
  Coarse ring = coarsened<SMC::Weighted_area_weight>(torus, 1000, 10, SMC::Fitted_placement());
  const Texture texture = ring.mesh.add_property_map<Halfedge, Texture_point>("h:texture").first;
  const auto ring_clusters = boost::make_iterator_property_map(ring.labels.begin(), get(CGAL::face_index, torus));
  SMC::Property_resampler<Mesh, Mesh>(torus, ring_clusters, ring.mesh).transfer_corner_property(texture_of(torus), texture);

  compose(setting.directory, "properties",
          {{{with_field(bunny, field, camera, 1, 0), "a field on " + vertices_of(bunny), "0", "1"},
            {with_field(coarse.mesh, coarse_field, camera, 8, 0.45), "and on " + vertices_of(coarse.mesh), "", ""}},
           {{textured(torus, torus_camera, 2, 0), "texture with its seams, " + vertices_of(torus), "", ""},
            {textured(ring.mesh, torus_camera, 16, 0.45), "and on " + vertices_of(ring.mesh), "", ""}}});
}

void picture_distance(const Setting& setting)
{
  const Mesh mesh = read(setting, "lion-head.off");
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  const double diagonal = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  const Camera camera = camera_for(mesh, Vector(-0.3, 0.3, 1), Vector(0, 1, 0));
  std::vector<std::vector<Panel> > rows(2);
  for (const double percent : {2., 0.5}) {
    Mesh coarse;
    const SMC::Distance_report report = SMC::coarsen_mesh_to_distance(
      mesh, percent / 100 * diagonal, coarse,
      SMC::parameters::cluster_weight(SMC::Weighted_area_weight()).maximum_density(10.).vertex_placement(SMC::Fitted_placement()));
    const std::vector<double> away = face_distances(mesh, coarse, [] {});
    const auto color = [&](Face f) { return scale_color(100 * away[f] / diagonal / percent); };
    rows[0].push_back({drawn(mesh_scene(coarse), camera), vertices_of(coarse), "", ""});
    rows[1].push_back({drawn(make_scene(mesh, true, color, no_edge, 1, 0), camera),
                       "at most " + rounded(percent, 1) + " %; proved: " +
                         rounded(100 * report.distance_bound / diagonal, 2) + " %",
                       "0", rounded(percent, 1) + " %"});
  }
  compose(setting.directory, "distance", rows);
}

// A cluster has the color of the coarsest cluster that contains it.
void picture_levels(const Setting& setting)
{
  const Mesh mesh = read(setting, "bunny00.off");
  const Camera camera = camera_for(mesh, Vector(0.2, 0.35, 1), Vector(0, 1, 0), 210);
  typedef SMC::Mwcvd_clustering<Mesh, SMC::Weighted_area_weight> Clustering;
  Clustering clustering(mesh, SMC::parameters::maximum_density(10.));
  clustering.seed(2400);
  clustering.grow();
  clustering.minimize();
  const SMC::Cluster_levels<Clustering> levels(clustering);

  const auto labels_on = [&](std::size_t level) {
    Labels labels(mesh.number_of_faces());
    levels.write_clusters(level, boost::make_iterator_property_map(labels.begin(), get(CGAL::face_index, mesh)));
    return labels;
  };
  const auto is_between = [&](const Labels& labels) {
    return [&](Edge e) { return labels[mesh.face(mesh.halfedge(e, 0))] != labels[mesh.face(mesh.halfedge(e, 1))]; };
  };
  const Labels coarsest = labels_on(150);
  const Labels colors = color_clusters(mesh, coarsest);
  std::vector<std::vector<Panel> > rows(2);
  for (const std::size_t level : {2400, 600, 150}) {
    const Labels labels = labels_on(level);
    Scene scene = make_scene(
      mesh, true, [&](Face f) { return palette_color(colors[coarsest[f]]); }, is_between(labels), 0.9, 0.5);
    add_bold(scene, mesh, is_between(coarsest), 1.6);
    rows[0].push_back({drawn(scene, camera), "", "", ""});
    Mesh result;
    levels.extract_dual_mesh(level, result, SMC::Fitted_placement());
    rows[1].push_back({drawn(mesh_scene(result), camera), vertices_of(result), "", ""});
  }
  compose(setting.directory, "levels", rows);
}

} // namespace

Pictures pictures_of_what_comes_next()
{
  return {{"properties", picture_properties}, {"distance", picture_distance}, {"levels", picture_levels}};
}

} // namespace coarsening_pictures
