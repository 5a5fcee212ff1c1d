// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads a mesh file as a polygon soup. Whatever is wrong with the file comes out as one exception with one line of text.

#ifndef COARSENING_SUPPORT_READ_SOUP_H
#define COARSENING_SUPPORT_READ_SOUP_H

#include "io/Mesh.h"
#include "io/Text_scanner.h"

#include <cstddef>
#include <string>

namespace coarsening_support {

// Makes a soup of the content of a file of the type, without any check of what its numbers mean. What it asks memory for is
// bounded by a small multiple of the content's size, whatever that says. Throws Format_fault.
Soup parse_soup(const std::string& content, const std::string& type, const Stop& stop = nullptr);

// Reads the soup as it stands in the file. Throws Failure.
Soup read_soup(const std::string& file, const Stop& stop = nullptr);

// Drops the points that no polygon uses and returns how many there were.
std::size_t drop_unused_points(Soup& soup);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_READ_SOUP_H
