// SPDX-License-Identifier: GPL-3.0-or-later

#include "render/picture.h"

#include "render/captioned.h"
#include "render/error_scene.h"
#include "render/face_distances.h"
#include "render/png_bytes.h"
#include "render/render.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace coarsen_mesh_tool {
namespace {

// With a comma between thousands.
std::string counted(std::size_t number)
{
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3)
    digits.insert(i - 3, ",");
  return digits + (number == 1 ? " vertex" : " vertices");
}

double diagonal_of(const Mesh& mesh)
{
  CGAL::Bbox_3 box;
  for (Vertex v : mesh.vertices())
    box += mesh.point(v).bbox();
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

// The input, each face in the color of its distance from the result, with the scale of the colors.
Image error_panel(const Mesh& input, const Mesh& result, const Camera& camera, const std::function<void()>& poll)
{
  const std::vector<double> distances = face_distances(input, result, poll);
  const double diagonal = diagonal_of(input), largest = *std::max_element(distances.begin(), distances.end());
  Image image = render(error_scene(input, distances), camera);
  if (image.width > 8 * line_height && image.height > line_height)
    draw_scale(image, image.width / 4, image.width - image.width / 4, image.height - line_height / 2,
               image.height - line_height / 4);
  char text[64];
  std::snprintf(text, sizeof text, "distance, 0 to %.2g %% of the diagonal", diagonal > 0 ? 100 * largest / diagonal : 0.);
  return captioned(image, {text});
}

} // namespace

std::string picture_bytes(const Mesh& input, const std::vector<std::size_t>& labels, const Mesh& result, const Vector& view,
                          const Vector& up, const std::function<void()>& poll)
{
  const Camera camera(std::vector<Point>(input.points().begin(), input.points().end()), view, up, 900);
  Image clusters = captioned(render(cluster_scene(input, labels), camera), {"input, " + counted(input.number_of_vertices())});
  poll();
  Image coarse = captioned(render(mesh_scene(result), camera), {"result, " + counted(result.number_of_vertices())});
  poll();
  return png_bytes(in_rows({{std::move(clusters), std::move(coarse), error_panel(input, result, camera, poll)}}));
}

} // namespace coarsen_mesh_tool
