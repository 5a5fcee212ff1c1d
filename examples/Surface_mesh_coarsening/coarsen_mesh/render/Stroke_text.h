// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_STROKE_TEXT_H
#define COARSENING_SUPPORT_STROKE_TEXT_H

#include "render/Image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace coarsening_support {

// A line of small letters, digits and signs for the captions of pictures, drawn with a round pen and smooth edges. Characters
// without a shape leave a gap.
class Stroke_text
{
public:
  // `height`: from the top of a b to the bottom of a g, in pixels.
  Stroke_text(const std::string& text, std::size_t height) : text_(text), height_(height), unit_(double(height) / (12 + 2 * pen)) {}

  std::size_t width() const
  {
    double width = 2 * pen - gap;
    for (const char c : text_)
      width += width_of(c) + gap;
    return text_.empty() ? 0 : std::size_t(std::ceil(width * unit_));
  }
  std::size_t height() const { return height_; }

  // Draws the line with its upper left corner at (x, y), clipped to the image.
  void draw(Image& image, std::size_t x, std::size_t y) const
  {
    const std::size_t width = this->width();
    std::vector<double> ink(width * height_, 0);
    double left = pen;
    for (const char c : text_) {
      for (const std::string& stroke : strokes_of(c))
        draw_stroke(stroke, left, width, ink);
      left += width_of(c) + gap;
    }
    for (std::size_t j = 0; j < height_ && y + j < image.height; ++j)
      for (std::size_t i = 0; i < width && x + i < image.width; ++i)
        for (std::uint8_t& channel : image.at(x + i, y + j))
          channel = std::uint8_t(std::lround(channel + ink[j * width + i] * (30. - channel)));
  }

private:
  typedef std::array<double, 2> Place;

  // In units of the shapes: the radius of the pen, and the distance of letters.
  static constexpr double pen = 0.6, gap = 2.6;

  // The strokes of a character. Two digits are a point: x, and y with the base line at 4, the top of an x at 10 and the top of a
  // b at 13. The first and the last point of a stroke are its ends, the others control a spline of degree two between them.
  static const std::vector<std::string>& strokes_of(char c)
  {
    static const std::map<char, std::vector<std::string> > shapes = {
      {'0', {"080d5d540408"}}, {'1', {"0b2d", "2d24"}}, {'2', {"0b0d5d5904", "0454"}}, {'3', {"0c1d5d5929", "2959541405"}},
      {'4', {"4d07", "0757", "4d44"}}, {'5', {"5d1d", "1d09", "091a5a541405"}}, {'6', {"4d1d0a07", "070a5a540407"}},
      {'7', {"0d5d", "5d14"}}, {'8', {"1b1d4d49191b", "060959540406"}}, {'9', {"5a5d0d07575a", "5a574414"}}, {'.', {"0404"}},
      {',', {"1402"}}, {'%', {"0b0d3d39090b", "464878744446", "7d04"}}, {'-', {"0747"}}, {'+', {"0747", "2529"}},
      {'(', {"2d0b0623"}}, {')', {"0d2b2603"}}, {'a', {"575a0a045457", "5a54"}}, {'b', {"0d04", "070a5a540407"}},
      {'c', {"594a0a044455"}}, {'d', {"5d54", "575a0a045457"}}, {'e', {"0757", "575a0a044455"}}, {'f', {"3d1d1b14", "0a3a"}},
      {'g', {"575a0a045457", "5a53511102"}}, {'h', {"0d04", "070a5a5854"}}, {'i', {"0a04", "0d0d"}}, {'j', {"2a232101", "2d2d"}},
      {'k', {"0d04", "4a06", "2854"}}, {'l', {"0d04"}}, {'m', {"0a04", "070a4a4844", "474a8a8884"}}, {'n', {"0a04", "070a5a5854"}},
      {'o', {"070a5a540407"}}, {'p', {"0a01", "070a5a540407"}}, {'q', {"5a51", "575a0a045457"}}, {'r', {"0a04", "070a3a"}},
      {'s', {"494a0a0747440405"}}, {'t', {"1d161434", "0a3a"}}, {'u', {"0a06045457", "5a54"}}, {'v', {"0a24", "244a"}},
      {'w', {"0a14", "143a", "3a54", "546a"}}, {'x', {"0a44", "4a04"}}, {'y', {"0a24", "4a11"}}, {'z', {"0a4a", "4a04", "0444"}}};
    static const std::vector<std::string> none;
    const auto found = shapes.find(c);
    return found == shapes.end() ? none : found->second;
  }

  static double digit(char c) { return c <= '9' ? c - '0' : c - 'a' + 10; }

  static double width_of(char c)
  {
    if (strokes_of(c).empty())
      return 2;
    double width = 0;
    for (const std::string& stroke : strokes_of(c))
      for (std::size_t i = 0; i < stroke.size(); i += 2)
        width = (std::max)(width, digit(stroke[i]));
    return width;
  }

  void draw_stroke(const std::string& stroke, double left, std::size_t width, std::vector<double>& ink) const
  {
    std::vector<Place> points;
    for (std::size_t i = 0; i + 1 < stroke.size(); i += 2)
      points.push_back({{unit_ * (left + digit(stroke[i])), unit_ * (pen + 13 - digit(stroke[i + 1]))}});
    if (points.size() == 2)
      return draw_line(points[0], points[1], width, ink);
    constexpr int pieces = 8;
    Place begin = points[0];
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const Place end = i + 2 == points.size() ? points[i + 1] : between(points[i], points[i + 1], 0.5);
      Place last = begin;
      for (int k = 1; k <= pieces; ++k) {
        const double t = double(k) / pieces;
        const Place next = between(between(begin, points[i], t), between(points[i], end, t), t);
        draw_line(last, next, width, ink);
        last = next;
      }
      begin = end;
    }
  }

  static Place between(const Place& p, const Place& q, double t)
  {
    return {{p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])}};
  }

  // A pixel has as much ink as the pen covers of it, approximately.
  void draw_line(const Place& p, const Place& q, std::size_t width, std::vector<double>& ink) const
  {
    const double radius = pen * unit_, length = std::hypot(q[0] - p[0], q[1] - p[1]);
    const auto first = [&](int i) { return std::size_t((std::max)(0., std::floor((std::min)(p[i], q[i]) - radius - 1))); };
    const auto last = [&](int i, std::size_t size) {
      return (std::min)(size, std::size_t((std::max)(0., std::ceil((std::max)(p[i], q[i]) + radius + 1))));
    };
    for (std::size_t j = first(1); j < last(1, height_); ++j)
      for (std::size_t i = first(0); i < last(0, width); ++i) {
        const double x = double(i) + 0.5 - p[0], y = double(j) + 0.5 - p[1];
        const double along = length > 0 ? (x * (q[0] - p[0]) + y * (q[1] - p[1])) / (length * length) : 0;
        const Place nearest = between(p, q, (std::min)(1., (std::max)(0., along)));
        const double distance = std::hypot(p[0] + x - nearest[0], p[1] + y - nearest[1]);
        double& here = ink[j * width + i];
        here = (std::max)(here, (std::min)(1., (std::max)(0., radius + 0.5 - distance)));
      }
  }

  std::string text_;
  std::size_t height_;
  double unit_;
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_STROKE_TEXT_H
