// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_FILE_BYTES_H
#define COARSENING_SUPPORT_FILE_BYTES_H

#include "io/Text_scanner.h"

#include <string>

namespace coarsening_support {

// Reads a regular file or a pipe to its end. Calls `stop` after a signal has interrupted the reading, and between
// pieces.
std::string file_bytes(const std::string& file, const Stop& stop = nullptr);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_FILE_BYTES_H
