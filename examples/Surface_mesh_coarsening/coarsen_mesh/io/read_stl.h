// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_READ_STL_H
#define COARSENING_SUPPORT_READ_STL_H

#include "io/Mesh.h"
#include "io/Text_scanner.h"

#include <string>

namespace coarsening_support {

// Reads the content of an STL file, text or binary. Throws Format_fault.
void read_stl(const std::string& content, Soup& soup, const Stop& stop = nullptr);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_READ_STL_H
