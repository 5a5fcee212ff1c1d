// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_CAMERA_H
#define COARSENING_SUPPORT_CAMERA_H

#include "io/Mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace coarsening_support {

inline Vector unit(const Vector& v)
{
  const double length = std::sqrt(v.squared_length());
  return length > 0 ? v / length : Vector(0, 0, 1);
}

// A parallel projection. `x` runs right, `y` up and `z` towards the viewer, all in pixels.
class Camera
{
  Vector right, up, toward;
  double scale = 1, shift_x = 0, shift_y = 0;

public:
  double width = 1, height = 1; // of the picture, in pixels

  // Looks at the points from the direction `from`, with `pole` pointing up as far as possible. The longer side of the
  // picture has `size` pixels, the other side fits the points.
  Camera(const std::vector<Point>& points, const Vector& from, Vector pole, double size) : toward(unit(from))
  {
    if (std::abs(unit(pole) * toward) > 0.999) // along the view: use another axis
      pole = std::abs(toward.z()) < 0.9 ? Vector(0, 0, 1) : Vector(0, 1, 0);
    right = unit(CGAL::cross_product(pole, toward));
    up = CGAL::cross_product(toward, right);

    const double inf = std::numeric_limits<double>::infinity();
    double low_x = inf, high_x = -inf, low_y = inf, high_y = -inf;
    for (const Point& p : points) {
      const Vector q = (*this)(p);
      low_x = (std::min)(low_x, q.x());
      high_x = (std::max)(high_x, q.x());
      low_y = (std::min)(low_y, q.y());
      high_y = (std::max)(high_y, q.y());
    }
    const double extent = (std::max)(high_x - low_x, high_y - low_y);
    const double margin = 0.04 * size;
    if (!std::isfinite(extent)) { // differences of coordinates overflow: nothing can be shown
      scale = 0;
      width = height = size;
      return;
    }
    scale = extent > 0 ? (size - 2 * margin) / extent : 1;
    width = (std::max)(0.4 * size, std::ceil(scale * (high_x - low_x) + 2 * margin));
    height = (std::max)(0.4 * size, std::ceil(scale * (high_y - low_y) + 2 * margin));
    shift_x = width / 2 - scale * (low_x + high_x) / 2;
    shift_y = height / 2 - scale * (low_y + high_y) / 2;
  }

  Vector operator()(const Point& p) const
  {
    const Vector v(p.x(), p.y(), p.z());
    return Vector(scale * (v * right) + shift_x, scale * (v * up) + shift_y, scale * (v * toward));
  }

  // Expresses a direction in the camera's axes.
  Vector turned(const Vector& v) const { return Vector(v * right, v * up, v * toward); }
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_CAMERA_H
