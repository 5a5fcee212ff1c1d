// SPDX-License-Identifier: GPL-3.0-or-later
//
// A small software renderer: hidden surfaces by z-buffer, light in linear intensities, antialiasing by several samples
// per pixel.

#ifndef COARSENING_SUPPORT_RENDER_H
#define COARSENING_SUPPORT_RENDER_H

#include "render/Camera.h"
#include "render/Image.h"
#include "render/Scene.h"
#include "render/Visibility_buffer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace coarsening_support {

using Linear_color = std::array<double, 3>;

inline double to_linear(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }

inline double from_linear(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; }

inline Linear_color to_linear(const Rgb& c)
{
  return {to_linear(c[0] / 255.), to_linear(c[1] / 255.), to_linear(c[2] / 255.)};
}

inline Rgb from_linear(const Linear_color& c)
{
  Rgb result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = static_cast<std::uint8_t>(std::lround(255 * (std::min)(1., (std::max)(0., from_linear(c[i])))));
  return result;
}

// Computes the light on a surface from its unit normal in the camera's axes: a strong lamp from the upper left, a weak
// one from the right, the sky, and a soft gloss. The inner side of a surface is darker.
inline Linear_color lit(const Linear_color& color, const Vector& normal, bool inner_side)
{
  static const Vector key = unit(Vector(-0.45, 0.65, 0.75)), fill = unit(Vector(0.9, 0.1, 0.35));
  static const Vector halfway = unit(key + Vector(0, 0, 1));
  const Vector n = normal.z() < 0 ? -normal : normal;
  const double diffuse = 0.74 * (std::max)(0., n * key) + 0.26 * (std::max)(0., n * fill) + 0.21 + 0.07 * n.y();
  double gloss = (std::max)(0., n * halfway);
  for (int doublings = 0; doublings < 5; ++doublings)
    gloss *= gloss; // finally its 32nd power
  Linear_color result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = (inner_side ? 0.45 : 1.) * (color[i] * diffuse + 0.05 * gloss);
  return result;
}

class Renderer
{
  static constexpr std::size_t side = 3; // samples across a pixel
  static constexpr double samples = side * side;

  const Scene& scene;
  const Camera& camera;
  std::size_t width, height;
  std::vector<Vector> projected; // in samples
  std::vector<Linear_color> colors;
  Visibility_buffer buffer;

public:
  Renderer(const Scene& scene, const Camera& camera)
    : scene(scene),
      camera(camera),
      width(static_cast<std::size_t>(camera.width)),
      height(static_cast<std::size_t>(camera.height)),
      buffer(side * width, side * height)
  {
    for (const Point& p : scene.points)
      projected.push_back(static_cast<double>(side) * camera(p));
    for (const auto& t : scene.triangles)
      colors.push_back(to_linear(t.color));
  }

  Image operator()()
  {
    for (std::size_t i = 0; i < scene.triangles.size(); ++i)
      buffer.draw_triangle(corners(i), static_cast<std::uint32_t>(i));
    draw_lines();
    Image image(width, height);
    for (std::size_t y = 0; y < height; ++y)
      for (std::size_t x = 0; x < width; ++x)
        image.at(x, height - 1 - y) = pixel(x, y);
    return image;
  }

private:
  std::array<Vector, 3> corners(std::size_t triangle) const
  {
    const auto& v = scene.triangles[triangle].vertices;
    return {projected[v[0]], projected[v[1]], projected[v[2]]};
  }

  // Dense lines become thinner, so that the picture does not turn black.
  double thinning() const
  {
    double length = 1;
    for (const auto& line : scene.lines) {
      const Vector d = projected[line.from] - projected[line.to];
      length += std::sqrt(d.x() * d.x() + d.y() * d.y());
    }
    const double spacing = static_cast<double>(buffer.covered()) / length; // in samples
    return (std::max)(0.35, (std::min)(1., spacing / (2 * static_cast<double>(side))));
  }

  void draw_lines()
  {
    const double factor = 0.5 * static_cast<double>(side) * thinning();
    for (const auto& line : scene.lines)
      buffer.draw_line(projected[line.from], projected[line.to], factor * line.width,
                       static_cast<std::uint8_t>(255 * line.ink));
  }

  Linear_color sample(std::size_t x, std::size_t y) const
  {
    const std::uint32_t id = buffer.id(x, y);
    if (id == Visibility_buffer::nothing)
      return {1, 1, 1};
    const Barycentric weights(corners(id));
    const std::array<double, 3> w = weights(x, y);
    const auto& normals = scene.triangles[id].normals;
    const Vector normal = unit(camera.turned(w[0] * normals[0] + w[1] * normals[1] + w[2] * normals[2]));
    Linear_color result = lit(colors[id], normal, (weights.signed_area() < 0) != scene.inside_out);
    for (double& channel : result)
      channel *= 1 - buffer.ink(x, y) / 255.;
    return result;
  }

  Rgb pixel(std::size_t x, std::size_t y) const
  {
    Linear_color sum = {0, 0, 0};
    for (std::size_t j = 0; j < side; ++j)
      for (std::size_t i = 0; i < side; ++i) {
        const Linear_color s = sample(side * x + i, side * y + j);
        for (std::size_t c = 0; c < 3; ++c)
          sum[c] += s[c] / samples;
      }
    return from_linear(sum);
  }
};

inline Image render(const Scene& scene, const Camera& camera) { return Renderer(scene, camera)(); }

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_RENDER_H
