// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_CAPTIONED_H
#define COARSENING_SUPPORT_CAPTIONED_H

#include "render/Image.h"
#include "render/Stroke_text.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace coarsening_support {

// In pixels.
constexpr std::size_t text_height = 28, line_height = 42;

// Adds lines of text below the image, each in the middle.
inline Image captioned(const Image& image, const std::vector<std::string>& lines)
{
  std::size_t width = image.width;
  for (const std::string& line : lines)
    width = (std::max)(width, Stroke_text(line, text_height).width() + line_height);
  Image result(width, image.height + lines.size() * line_height);
  for (std::size_t y = 0; y < image.height; ++y)
    for (std::size_t x = 0; x < image.width; ++x)
      result.at((width - image.width) / 2 + x, y) = image.at(x, y);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Stroke_text text(lines[i], text_height);
    text.draw(result, (width - text.width()) / 2, image.height + i * line_height + (line_height - text.height()) / 2);
  }
  return result;
}

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_CAPTIONED_H
