// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_VISIBILITY_BUFFER_H
#define COARSENING_SUPPORT_VISIBILITY_BUFFER_H

#include "io/Mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace coarsening_support {

// The barycentric coordinates of a projected triangle, as functions of the position in the picture.
class Barycentric
{
  std::array<double, 3> dx, dy, at_origin;
  double area2;

public:
  explicit Barycentric(const std::array<Vector, 3>& p)
    : area2((p[1].x() - p[0].x()) * (p[2].y() - p[0].y()) - (p[1].y() - p[0].y()) * (p[2].x() - p[0].x()))
  {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector &a = p[(i + 1) % 3], &b = p[(i + 2) % 3];
      dx[i] = (a.y() - b.y()) / area2;
      dy[i] = (b.x() - a.x()) / area2;
      at_origin[i] = -(dx[i] * a.x() + dy[i] * a.y());
    }
  }

  // Twice the projected area; negative if the triangle is seen from behind.
  double signed_area() const { return area2; }

  // The coordinates of the center of a sample.
  std::array<double, 3> operator()(std::size_t column, std::size_t row) const
  {
    const double x = static_cast<double>(column) + 0.5, y = static_cast<double>(row) + 0.5;
    return {dx[0] * x + dy[0] * y + at_origin[0], dx[1] * x + dy[1] * y + at_origin[1],
            dx[2] * x + dy[2] * y + at_origin[2]};
  }
};

// A z-buffer that stores for each sample the number of the visible triangle, and whether a line covers it. All
// coordinates are in samples, `y` up, `z` towards the viewer.
class Visibility_buffer
{
public:
  static constexpr std::uint32_t nothing = (std::numeric_limits<std::uint32_t>::max)();

private:
  std::size_t width, height;
  std::vector<float> depth;
  std::vector<std::uint32_t> ids;
  std::vector<std::uint8_t> inks;

  struct Box
  {
    std::size_t x0, x1, y0, y1; // half-open
  };

  static std::size_t clamped(double v, std::size_t limit)
  {
    return !(v > 0) ? 0 : v >= static_cast<double>(limit) ? limit : static_cast<std::size_t>(v);
  }

  // The samples whose centers can lie within the bounds.
  Box box(double x0, double x1, double y0, double y1) const
  {
    return {clamped(std::floor(x0 - 0.5), width), clamped(std::floor(x1 + 0.5) + 1, width),
            clamped(std::floor(y0 - 0.5), height), clamped(std::floor(y1 + 0.5) + 1, height)};
  }

public:
  Visibility_buffer(std::size_t width, std::size_t height)
    : width(width),
      height(height),
      depth(width * height, -std::numeric_limits<float>::infinity()),
      ids(width * height, nothing),
      inks(width * height, 0)
  {}

  std::uint32_t id(std::size_t x, std::size_t y) const { return ids[y * width + x]; }
  std::uint8_t ink(std::size_t x, std::size_t y) const { return inks[y * width + x]; }

  // Returns the number of covered samples.
  std::size_t covered() const
  {
    return ids.size() - static_cast<std::size_t>(std::count(ids.begin(), ids.end(), nothing));
  }

  void draw_triangle(const std::array<Vector, 3>& p, std::uint32_t id)
  {
    const Barycentric weights(p);
    if (!(std::abs(weights.signed_area()) > 0))
      return;
    constexpr double least = -1e-9; // leaves no gaps between neighbors
    const auto xs = std::minmax({p[0].x(), p[1].x(), p[2].x()});
    const auto ys = std::minmax({p[0].y(), p[1].y(), p[2].y()});
    const Box b = box(xs.first, xs.second, ys.first, ys.second);
    for (std::size_t y = b.y0; y < b.y1; ++y)
      for (std::size_t x = b.x0; x < b.x1; ++x) {
        const std::array<double, 3> w = weights(x, y);
        if (w[0] < least || w[1] < least || w[2] < least)
          continue;
        const float z = static_cast<float>(w[0] * p[0].z() + w[1] * p[1].z() + w[2] * p[2].z());
        const std::size_t i = y * width + x;
        if (z > depth[i]) {
          depth[i] = z;
          ids[i] = id;
        }
      }
  }

  // Draws a line with round ends. It lies on the surface, so it is visible unless it is farther behind than the surface
  // can slope over the line's width.
  void draw_line(const Vector& a, const Vector& b, double half_width, std::uint8_t ink)
  {
    const double dx = b.x() - a.x(), dy = b.y() - a.y(), length2 = dx * dx + dy * dy;
    const float tolerance = static_cast<float>(3 * half_width + 1);
    const Box bounds = box((std::min)(a.x(), b.x()) - half_width, (std::max)(a.x(), b.x()) + half_width,
                           (std::min)(a.y(), b.y()) - half_width, (std::max)(a.y(), b.y()) + half_width);
    const double reach = std::abs(dy) > 0 ? half_width * std::sqrt(length2) / std::abs(dy) : 0; // along a row
    for (std::size_t y = bounds.y0; y < bounds.y1; ++y) {
      std::size_t x0 = bounds.x0, x1 = bounds.x1;
      if (reach > 0) {
        const double middle = a.x() + dx * (static_cast<double>(y) + 0.5 - a.y()) / dy;
        x0 = (std::max)(x0, clamped(std::floor(middle - reach - 0.5), width));
        x1 = (std::min)(x1, clamped(std::floor(middle + reach + 0.5) + 1, width));
      }
      for (std::size_t x = x0; x < x1; ++x) {
        const double px = static_cast<double>(x) + 0.5 - a.x(), py = static_cast<double>(y) + 0.5 - a.y();
        const double t = length2 > 0 ? (std::max)(0., (std::min)(1., (px * dx + py * dy) / length2)) : 0;
        const double ex = px - t * dx, ey = py - t * dy;
        if (ex * ex + ey * ey > half_width * half_width)
          continue;
        const std::size_t i = y * width + x;
        const float z = static_cast<float>((1 - t) * a.z() + t * b.z());
        if (ids[i] != nothing && z + tolerance > depth[i])
          inks[i] = (std::max)(inks[i], ink);
      }
    }
  }
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_VISIBILITY_BUFFER_H
