// SPDX-License-Identifier: GPL-3.0-or-later

#include "panels.h"

#include "render/error_scene.h"
#include "render/render.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace coarsening_viewer {
namespace {

std::string counted(const Mesh& mesh)
{
  return std::to_string(mesh.number_of_vertices()) + " vertices, " + std::to_string(mesh.number_of_faces()) + " faces";
}

std::string quality_text(const Coarse& coarse)
{
  const auto& q = coarse.quality;
  char text[160];
  std::snprintf(text, sizeof text, ", angles: mean of the smallest %.1f\xC2\xB0, least %.1f\xC2\xB0", q.mean_smallest_angle,
                q.smallest_angle);
  return counted(coarse.mesh) + text;
}

std::string error_text(const Coarse& coarse)
{
  const auto& q = coarse.quality;
  const double percent = q.diagonal > 0 ? 100 / q.diagonal : 0;
  char text[160];
  std::snprintf(text, sizeof text, "distance, %% of the diagonal: RMS %.3g, colors from 0 to %.3g", percent * q.rms_distance,
                percent * *std::max_element(coarse.distances.begin(), coarse.distances.end()));
  return text;
}

} // namespace

Panel_scenes::Panel_scenes(const Mesh& input) : input_(input)
{
  CGAL::Bbox_3 box;
  for (const Vertex v : input.vertices())
    box += input.point(v).bbox();
  center_ = Point((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2);
  const double radius = std::hypot(box.x_span(), box.y_span(), box.z_span()) / 2;
  constexpr int steps = 24;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j < 2 * steps; ++j) {
      const double a = CGAL_PI * i / steps, b = CGAL_PI * j / steps;
      sphere_.push_back(center_ + radius * Vector(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)));
    }
  scenes_[0] = std::make_unique<Scene>(error_scene(input, std::vector<double>(input.number_of_faces(), 0.)));
  for (auto& triangle : scenes_[0]->triangles)
    triangle.color = Rgb{{190, 208, 228}};
  captions_ = {{"input: " + counted(input), "clusters", "result", "error"}};
}

Panel_scenes::~Panel_scenes() {}

void Panel_scenes::show(const Coarse& coarse)
{
  scenes_[1] = std::make_unique<Scene>(cluster_scene(input_, coarse.labels));
  scenes_[2] = std::make_unique<Scene>(mesh_scene(coarse.mesh));
  scenes_[3] = std::make_unique<Scene>(error_scene(input_, coarse.distances));
  captions_[1] = "clusters: weight " + std::string(weight_names[coarse.choice.weight]) + ", placement " +
                 placement_names[coarse.choice.placement];
  captions_[2] = "result: " + quality_text(coarse);
  captions_[3] = "error: " + error_text(coarse);
}

std::string Panel_scenes::caption(std::size_t panel) const { return captions_[panel]; }

Image Panel_scenes::image(std::size_t panel, const View& view, std::size_t size) const
{
  if (!scenes_[panel])
    return Image(size, size);
  const Vector around(std::cos(view.tilt) * std::sin(view.turn), std::sin(view.tilt), std::cos(view.tilt) * std::cos(view.turn));
  const Vector from = view.z_is_up ? Vector(around.z(), around.x(), around.y()) : around;
  std::vector<Point> shown;
  for (const Point& p : sphere_)
    shown.push_back(center_ + (p - center_) / view.zoom);
  const Camera camera(shown, from, view.z_is_up ? Vector(0, 0, 1) : Vector(0, 1, 0), double(size));
  return render(*scenes_[panel], camera);
}

} // namespace coarsening_viewer
