// SPDX-License-Identifier: GPL-3.0-or-later

#include "render/picture.h"

#include "render/Bitmap_text.h"
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

constexpr std::size_t dot = 3, line_height = 14 * dot;

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

// Adds a line below the image, with the text in the middle.
Image captioned(const Image& image, const std::string& caption)
{
  const Bitmap_text text(caption, dot);
  Image result((std::max)(image.width, text.width() + line_height), image.height + line_height);
  const std::size_t left = (result.width - image.width) / 2;
  for (std::size_t y = 0; y < image.height; ++y)
    for (std::size_t x = 0; x < image.width; ++x)
      result.at(left + x, y) = image.at(x, y);
  text.draw(result, (result.width - text.width()) / 2, image.height + (line_height - text.height()) / 2);
  return result;
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
  return captioned(image, text);
}

} // namespace

std::string picture_bytes(const Mesh& input, const std::vector<std::size_t>& labels, const Mesh& result, const Vector& view,
                          const Vector& up, const std::function<void()>& poll)
{
  const Camera camera(std::vector<Point>(input.points().begin(), input.points().end()), view, up, 900);
  Image clusters = captioned(render(cluster_scene(input, labels), camera), "input, " + counted(input.number_of_vertices()));
  poll();
  Image coarse = captioned(render(mesh_scene(result), camera), "result, " + counted(result.number_of_vertices()));
  poll();
  return png_bytes(in_rows({{std::move(clusters), std::move(coarse), error_panel(input, result, camera, poll)}}));
}

} // namespace coarsen_mesh_tool
