// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_PNG_BYTES_H
#define COARSENING_SUPPORT_PNG_BYTES_H

#include "render/Image.h"

#include <boost/gil.hpp>
#include <boost/gil/extension/io/png.hpp>

#include <cstddef>
#include <ios>
#include <sstream>
#include <string>

namespace coarsening_support {

// Encodes the picture as a PNG file.
inline std::string png_bytes(const Image& image)
{
  namespace gil = boost::gil;
  const auto* first = reinterpret_cast<const gil::rgb8_pixel_t*>(image.pixels.data());
  static_assert(sizeof(gil::rgb8_pixel_t) == sizeof(Rgb), "both are three bytes");
  const auto view =
    gil::interleaved_view(image.width, image.height, first, static_cast<std::ptrdiff_t>(image.width * sizeof(Rgb)));
  std::ostringstream os(std::ios::out | std::ios::binary);
  gil::write_view(os, view, gil::png_tag());
  return os.str();
}

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_PNG_BYTES_H
