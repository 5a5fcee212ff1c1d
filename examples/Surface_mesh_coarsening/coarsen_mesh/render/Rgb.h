// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_RGB_H
#define COARSENING_SUPPORT_RGB_H

#include <array>
#include <cstdint>

namespace coarsening_support {

// A color of 8 bits per channel, in sRGB.
using Rgb = std::array<std::uint8_t, 3>;

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_RGB_H
