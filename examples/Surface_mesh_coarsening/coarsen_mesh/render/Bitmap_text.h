// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_BITMAP_TEXT_H
#define COARSENING_SUPPORT_BITMAP_TEXT_H

#include "render/Image.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace coarsening_support {

// A line of small letters, digits and what stands in numbers, each of 5 by 7 dots, for the captions of pictures. A dot has
// `scale` by `scale` pixels. What has no shape here leaves a gap.
class Bitmap_text
{
  static constexpr std::size_t columns = 5, rows = 7, advance = columns + 1;

  std::string text;
  std::size_t scale;

public:
  Bitmap_text(const std::string& text, std::size_t scale) : text(text), scale(scale) {}

  std::size_t width() const { return text.empty() ? 0 : scale * (advance * text.size() - 1); }
  std::size_t height() const { return scale * rows; }

  // Draws it with its upper left corner at (x, y), clipped to the image.
  void draw(Image& image, std::size_t x, std::size_t y) const
  {
    for (std::size_t i = 0; i < text.size(); ++i)
      for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column)
          if (shape(text[i])[row] >> (columns - 1 - column) & 1)
            fill(image, x + scale * (advance * i + column), y + scale * row);
  }

private:
  typedef std::array<std::uint8_t, rows> Shape; // a row has a bit a dot, the left one highest

  void fill(Image& image, std::size_t x, std::size_t y) const
  {
    for (std::size_t j = y; j < y + scale && j < image.height; ++j)
      for (std::size_t i = x; i < x + scale && i < image.width; ++i)
        image.at(i, j) = Rgb{{30, 30, 30}};
  }

  static const Shape& shape(char c)
  {
    static const std::string known = "0123456789.,%-abcdefghijklmnopqrstuvwxyz";
    static const std::array<Shape, 40> shapes = {{
      {{14, 17, 19, 21, 25, 17, 14}}, {{4, 12, 4, 4, 4, 4, 14}},      {{14, 17, 1, 6, 8, 16, 31}},
      {{30, 1, 1, 14, 1, 1, 30}},     {{2, 6, 10, 18, 31, 2, 2}},     {{31, 16, 30, 1, 1, 17, 14}},
      {{6, 8, 16, 30, 17, 17, 14}},   {{31, 1, 2, 4, 8, 8, 8}},       {{14, 17, 17, 14, 17, 17, 14}},
      {{14, 17, 17, 15, 1, 2, 12}},   {{0, 0, 0, 0, 0, 12, 12}},      {{0, 0, 0, 0, 12, 4, 8}},
      {{25, 25, 2, 4, 8, 19, 19}},    {{0, 0, 0, 14, 0, 0, 0}},       {{0, 0, 14, 1, 15, 17, 15}},
      {{16, 16, 30, 17, 17, 17, 30}}, {{0, 0, 14, 16, 16, 17, 14}},   {{1, 1, 15, 17, 17, 17, 15}},
      {{0, 0, 14, 17, 31, 16, 14}},   {{6, 9, 8, 28, 8, 8, 8}},       {{0, 0, 15, 17, 15, 1, 14}},
      {{16, 16, 30, 17, 17, 17, 17}}, {{4, 0, 12, 4, 4, 4, 14}},      {{2, 0, 6, 2, 2, 18, 12}},
      {{16, 16, 18, 20, 24, 20, 18}}, {{12, 4, 4, 4, 4, 4, 14}},      {{0, 0, 26, 21, 21, 21, 21}},
      {{0, 0, 30, 17, 17, 17, 17}},   {{0, 0, 14, 17, 17, 17, 14}},   {{0, 0, 30, 17, 30, 16, 16}},
      {{0, 0, 15, 17, 15, 1, 1}},     {{0, 0, 22, 25, 16, 16, 16}},   {{0, 0, 15, 16, 14, 1, 30}},
      {{8, 8, 28, 8, 8, 9, 6}},       {{0, 0, 17, 17, 17, 19, 13}},   {{0, 0, 17, 17, 17, 10, 4}},
      {{0, 0, 17, 17, 21, 21, 10}},   {{0, 0, 17, 10, 4, 10, 17}},    {{0, 0, 17, 17, 15, 1, 14}},
      {{0, 0, 31, 2, 4, 8, 31}},
    }};
    static const Shape nothing = {{0, 0, 0, 0, 0, 0, 0}};
    const std::size_t at = known.find(c);
    return at == std::string::npos ? nothing : shapes[at];
  }
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_BITMAP_TEXT_H
