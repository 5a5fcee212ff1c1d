// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arranges panels in rows with a caption below each; gnuplot writes the text.

#ifndef COARSENING_PICTURES_COMPOSITION_H
#define COARSENING_PICTURES_COMPOSITION_H

#include "render/Image.h"
#include "render/png_bytes.h"
#include "render/scale_color.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace coarsening_pictures {

using coarsening_support::Image;
using coarsening_support::Rgb;
using coarsening_support::draw_scale;
using coarsening_support::scale_color;

// Sizes are given for a screen of some 100 pixels per inch; pictures have so many pixels for each.
constexpr std::size_t resolution = 2;

struct Panel
{
  Image image;
  std::string caption;
  std::string scale_low, scale_high; // the ends of the color scale, if any
};

inline void write_file(const std::filesystem::path& file, const std::string& content)
{
  std::ofstream os(file, std::ios::binary);
  os << content;
  if (!os.flush())
    throw std::runtime_error("cannot write " + file.string());
}

// Fewer shades, which cannot be seen but make the files smaller; white stays white.
inline void posterize(Image& image)
{
  for (Rgb& pixel : image.pixels)
    for (std::uint8_t& channel : pixel)
      channel = static_cast<std::uint8_t>((channel + 4) / 8 * 255 / 32);
}

// Writes the panels as DIRECTORY/NAME_I.png, and DIRECTORY/NAME.gp, which composes them to DIRECTORY/figures/NAME.png.
inline void compose(const std::filesystem::path& directory, const std::string& name, std::vector<std::vector<Panel> > rows)
{
  const std::size_t caption_height = 26 * resolution, gap = 12 * resolution;
  std::size_t columns = 0, width = 0, total_height = 0;
  std::vector<std::size_t> heights;
  for (const auto& row : rows) {
    columns = (std::max)(columns, row.size());
    heights.push_back(0);
    for (const Panel& panel : row) {
      width = (std::max)(width, panel.image.width);
      heights.back() = (std::max)(heights.back(), panel.image.height);
    }
    total_height += heights.back() + caption_height;
  }
  const std::size_t total_width = columns * (width + gap);
  const auto at = [](double pixels, std::size_t total) { return std::to_string(pixels / double(total)); };
  std::string script = "set terminal pngcairo size " + std::to_string(total_width) + "," + std::to_string(total_height) +
                       " font 'DejaVu Sans,10' fontscale " + std::to_string(resolution) + "\nset output 'figures/" + name +
                       ".png'\nunset border\nunset tics\nunset key\nset multiplot\n";
  std::size_t number = 0, row_top = 0; // from the upper edge, as all that follows
  for (std::size_t r = 0; r < rows.size(); row_top += heights[r++] + caption_height)
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      Panel& panel = rows[r][c];
      Image& image = panel.image;
      const std::size_t left = c * (width + gap) + (width + gap - image.width) / 2;
      const std::size_t top = row_top + (heights[r] - image.height) / 2;
      posterize(image);
      const std::string file = name + "_" + std::to_string(number++) + ".png";
      script += "unset label\nset label '" + panel.caption + "' at screen " +
                at(double(c * (width + gap)) + double(width + gap) / 2, total_width) + "," +
                at(double(total_height) - double(row_top + heights[r] + 12 * resolution), total_height) + " center\n";
      if (!panel.scale_low.empty() && image.width > 160 * resolution && image.height > 20 * resolution) {
        const std::size_t x0 = (16 + 8 * panel.scale_low.size()) * resolution, x1 = x0 + 90 * resolution,
                          y0 = image.height - 10 * resolution, y1 = image.height, space = 6 * resolution;
        draw_scale(image, x0, x1, y0, y1);
        const std::string y = std::to_string(image.height - (y0 + y1) / 2);
        script += "set label '" + panel.scale_low + "' at first " + std::to_string(x0 - space) + "," + y +
                  " right front\nset label '" + panel.scale_high + "' at first " + std::to_string(x1 + space) + "," + y + " left front\n";
      }
      write_file(directory / file, coarsening_support::png_bytes(image));
      script += "set lmargin at screen " + at(double(left), total_width) + "\nset rmargin at screen " +
                at(double(left + image.width), total_width) + "\nset tmargin at screen " +
                at(double(total_height - top), total_height) + "\nset bmargin at screen " +
                at(double(total_height - top - image.height), total_height) + "\nset xrange [-0.5:" +
                std::to_string(image.width) + "-0.5]\nset yrange [-0.5:" + std::to_string(image.height) + "-0.5]\nplot '" +
                file + "' binary filetype=png with rgbimage\n";
    }
  write_file(directory / (name + ".gp"), script + "unset multiplot\n");
}

} // namespace coarsening_pictures

#endif // COARSENING_PICTURES_COMPOSITION_H
