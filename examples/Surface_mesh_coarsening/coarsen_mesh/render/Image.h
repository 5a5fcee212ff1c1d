// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_IMAGE_H
#define COARSENING_SUPPORT_IMAGE_H

#include "render/Rgb.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace coarsening_support {

// A picture of 8 bits per channel, rows from top to bottom, initially white.
struct Image
{
  std::size_t width = 0, height = 0;
  std::vector<Rgb> pixels;

  Image() = default;
  Image(std::size_t width, std::size_t height)
    : width(width),
      height(height),
      pixels(width * height, Rgb{{255, 255, 255}})
  {}

  Rgb& at(std::size_t x, std::size_t y) { return pixels[y * width + x]; }
  const Rgb& at(std::size_t x, std::size_t y) const { return pixels[y * width + x]; }
};

// Arranges pictures in rows, each centered in its cell.
inline Image in_rows(const std::vector<std::vector<Image> >& rows)
{
  std::size_t columns = 0, cell_width = 0, cell_height = 0;
  for (const auto& row : rows) {
    columns = (std::max)(columns, row.size());
    for (const Image& image : row) {
      cell_width = (std::max)(cell_width, image.width);
      cell_height = (std::max)(cell_height, image.height);
    }
  }
  Image result(columns * cell_width, rows.size() * cell_height);
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      const Image& image = rows[r][c];
      const std::size_t left = c * cell_width + (cell_width - image.width) / 2;
      const std::size_t top = r * cell_height + (cell_height - image.height) / 2;
      for (std::size_t y = 0; y < image.height; ++y)
        for (std::size_t x = 0; x < image.width; ++x)
          result.at(left + x, top + y) = image.at(x, y);
    }
  return result;
}

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_IMAGE_H
