// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_SCALE_COLOR_H
#define COARSENING_SUPPORT_SCALE_COLOR_H

#include "render/Image.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace coarsening_support {

// From pale to dark for t from 0 to 1, also for eyes that see no colors.
inline Rgb scale_color(double t)
{
  static const double stops[4][3] = {{255, 250, 225}, {253, 190, 75}, {205, 75, 15}, {95, 25, 20}};
  const double at = 3 * (std::min)(1., (std::max)(0., t));
  const std::size_t i = (std::min)(std::size_t(2), static_cast<std::size_t>(at));
  Rgb result;
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = static_cast<std::uint8_t>(std::lround(stops[i][c] + (at - double(i)) * (stops[i + 1][c] - stops[i][c])));
  return result;
}

// A bar of these colors, from left to right.
inline void draw_scale(Image& image, std::size_t x0, std::size_t x1, std::size_t y0, std::size_t y1)
{
  for (std::size_t y = y0; y < y1; ++y)
    for (std::size_t x = x0; x < x1; ++x)
      image.at(x, y) = scale_color(double(x - x0) / double(x1 - x0 - 1));
}

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_SCALE_COLOR_H
