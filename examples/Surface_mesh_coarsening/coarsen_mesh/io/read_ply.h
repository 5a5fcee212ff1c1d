// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_READ_PLY_H
#define COARSENING_SUPPORT_READ_PLY_H

#include "io/Mesh.h"
#include "io/Text_scanner.h"

#include <string>

namespace coarsening_support {

// Adds what a file of the format PLY holds, text or binary of either order of bytes. Throws Format_fault.
void read_ply(const std::string& content, Soup& soup, const Stop& stop = nullptr);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_READ_PLY_H
