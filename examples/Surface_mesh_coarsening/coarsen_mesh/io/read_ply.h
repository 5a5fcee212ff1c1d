// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_READ_PLY_H
#define COARSENING_SUPPORT_READ_PLY_H

#include "io/Mesh.h"
#include "io/Text_scanner.h"

#include <string>

namespace coarsening_support {

// Reads the content of a PLY file, text or binary in either byte order. Throws Format_fault.
void read_ply(const std::string& content, Soup& soup, const Stop& stop = nullptr);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_READ_PLY_H
