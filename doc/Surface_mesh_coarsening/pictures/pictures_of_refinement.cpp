// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the example refine_where_errors_are does, step by step. Its functions solve and estimate here as there.

#include "Picture_kit.h"

#define main main_of_the_example
#include "refine_where_errors_are.cpp"
#undef main

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace coarsening_pictures {
namespace {

std::vector<double> areas_of_clusters(const Mesh& mesh, const Labels& labels, std::size_t clusters)
{
  std::vector<double> areas(clusters, 0);
  for (Face f : mesh.faces())
    areas[labels[f]] += std::sqrt(face_normal(mesh, f).squared_length()) / 2;
  return areas;
}

struct Step
{
  Labels labels;
  std::vector<double> areas;
  Mesh coarse;
  Eigen::VectorXd solution;
};

template <class Clustering>
Step step_of(const Mesh& mesh, const Clustering& clustering, const Point& center, double size)
{
  Step step;
  step.labels = labels_of(mesh, clustering);
  step.areas = areas_of_clusters(mesh, step.labels, clustering.number_of_clusters());
  clustering.extract_dual_mesh(step.coarse);
  step.solution = solution_on(step.coarse, center, size);
  return step;
}

void picture_refinement(const Setting& setting)
{
  const Mesh mesh = read(setting, "fandisk.off");
  const Camera camera = camera_for(mesh, Vector(0.7, -0.4, -1), Vector(0, 1, 0));
  const Point center = mesh.point(*mesh.vertices().begin());
  double size = 0, total = 0;
  for (Vertex v : mesh.vertices())
    size = (std::max)(size, std::sqrt(CGAL::squared_distance(center, mesh.point(v))));
  for (Face f : mesh.faces())
    total += std::sqrt(face_normal(mesh, f).squared_length()) / 2;

  SMC::Mwcvd_clustering<Mesh> clustering(mesh, SMC::parameters::maximum_density(1.));
  clustering.seed(200);
  clustering.grow();
  clustering.minimize();
  std::vector<Step> steps;
  for (;;) {
    steps.push_back(step_of(mesh, clustering, center, size));
    if (steps.size() == 4)
      break;
    refine(clustering, estimated_errors(steps.back().coarse, steps.back().solution));
  }

  steps.erase(steps.begin() + 2); // three fit a page
  const double large = std::log(0.01), small = std::log(0.0003); // parts of the whole area
  std::vector<std::vector<Panel> > rows(2);
  for (const Step& step : steps) {
    const auto color = [&](Face f) {
      return scale_color((std::log(step.areas[step.labels[f]] / total) - large) / (small - large));
    };
    const auto is_drawn = [&](Edge e) {
      return step.labels[mesh.face(mesh.halfedge(e, 0))] != step.labels[mesh.face(mesh.halfedge(e, 1))];
    };
    const double greatest = step.solution.maxCoeff();
    const auto solution = [&](Face f) {
      double mean = 0;
      for (Vertex v : step.coarse.vertices_around_face(step.coarse.halfedge(f)))
        mean += step.solution[v] / 3;
      return scale_color(mean / greatest);
    };
    rows[0].push_back({render(make_scene(mesh, true, color, is_drawn, 1, 0.7), camera), "", "", ""});
    rows[1].push_back({render(make_scene(step.coarse, false, solution, any_edge, 1, 0.7), camera),
                       "solution, " + vertices_of(step.coarse), "", ""});
  }
  rows[0][0].caption = "part of the area in each cluster";
  rows[0][0].scale_low = "1 %";
  rows[0][0].scale_high = "0.03 %";
  rows[1][0].scale_low = "0";
  rows[1][0].scale_high = "largest";
  compose(setting.directory, "refinement", rows);
}

} // namespace

Pictures pictures_of_refinement() { return {{"refinement", picture_refinement}}; }

} // namespace coarsening_pictures
