// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads a mesh file as a polygon soup. Any fault of the file is reported by one exception with one line of text.

#ifndef COARSENING_SUPPORT_READ_SOUP_H
#define COARSENING_SUPPORT_READ_SOUP_H

#include "io/Mesh.h"
#include "io/Text_scanner.h"

#include <cstddef>
#include <string>

namespace coarsening_support {

// Parses the content of a file of the type to a soup, without checking the meaning of numbers. Memory is bounded by a small
// multiple of the content's size for any content, but with Assimp (assimp_formats.h), which also looks for other files beside
// `file`. Throws Format_fault.
Soup parse_soup(const std::string& content, const std::string& type, const Stop& stop = nullptr, const std::string& file = "");

// Reads the soup as it stands in the file, whose ending tells the type, or from standard input, for which the type stands. Throws
// Failure.
Soup read_soup(const std::string& file, const Stop& stop = nullptr, const std::string& type_of_stream = "");

// Removes the points that no polygon uses and returns their number.
std::size_t drop_unused_points(Soup& soup);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_READ_SOUP_H
