// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_READ_COMMENTS_H
#define COARSENING_SUPPORT_READ_COMMENTS_H

#include "io/Mesh.h"

#include <string_view>

namespace coarsening_support {

// Reads the lines that begin with # and stand before the first element, which begins with one of `elements`. Later comments
// describe elements of the input, so they are left out.
void read_comments(std::string_view content, std::string_view elements, Soup& soup);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_READ_COMMENTS_H
