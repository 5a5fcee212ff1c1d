// SPDX-License-Identifier: GPL-3.0-or-later
//
// The clusters and solutions written by the example refine_where_errors_are.

#include "Picture_kit.h"

#include "io/soup_properties.h"

#include <CGAL/Surface_mesh/IO/PLY.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace coarsening_pictures {
namespace {

Mesh read_with_properties(const std::filesystem::path& file)
{
  std::ifstream is(file, std::ios::binary);
  Mesh mesh;
  if (!CGAL::IO::read_PLY(is, mesh))
    throw std::runtime_error("cannot read " + file.string());
  return mesh;
}

struct Step
{
  Mesh mesh, coarse;
  Labels labels;
  std::vector<double> areas, solution; // of the clusters, and of the vertices
};

Step step_of(const Setting& setting, int number)
{
  const std::string ending = "_" + std::to_string(number) + ".ply";
  Step step{read_with_properties(setting.directory / ("clusters" + ending)),
            read_with_properties(setting.directory / ("solution" + ending)), {}, {}, {}};
  const Found_property<Face, std::uint32_t> cluster(step.mesh, "f:cluster");
  const Found_property<Vertex, double> solution(step.coarse, "v:solution");
  if (!cluster || !solution)
    throw std::runtime_error("the example has not written clusters and solutions");
  step.areas.assign(step.coarse.number_of_vertices(), 0);
  for (Face f : step.mesh.faces()) {
    step.labels.push_back(cluster.map[f]);
    step.areas[cluster.map[f]] += std::sqrt(face_normal(step.mesh, f).squared_length()) / 2;
  }
  for (Vertex v : step.coarse.vertices())
    step.solution.push_back(solution.map[v]);
  return step;
}

void picture_refinement(const Setting& setting)
{
  std::vector<Step> steps;
  for (int number : {0, 1, 3}) // three fit a page
    steps.push_back(step_of(setting, number));
  const Camera camera = camera_for(steps[0].mesh, Vector(0.7, -0.4, -1), Vector(0, 1, 0));
  double total = 0;
  for (double area : steps[0].areas)
    total += area;
  const double large = std::log(0.01), small = std::log(0.0003); // parts of the whole area
  std::vector<std::vector<Panel> > rows(2);
  for (const Step& step : steps) {
    const auto color = [&](Face f) {
      return scale_color((std::log(step.areas[step.labels[f]] / total) - large) / (small - large));
    };
    const auto is_drawn = [&](Edge e) {
      return step.labels[step.mesh.face(step.mesh.halfedge(e, 0))] != step.labels[step.mesh.face(step.mesh.halfedge(e, 1))];
    };
    const double greatest = *std::max_element(step.solution.begin(), step.solution.end());
    const auto solution = [&](Face f) {
      double mean = 0;
      for (Vertex v : step.coarse.vertices_around_face(step.coarse.halfedge(f)))
        mean += step.solution[v] / 3;
      return scale_color(mean / greatest);
    };
    rows[0].push_back({drawn(make_scene(step.mesh, true, color, is_drawn, 1, 0.7), camera), "", "", ""});
    rows[1].push_back({drawn(make_scene(step.coarse, false, solution, any_edge, 1, 0.7), camera),
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
