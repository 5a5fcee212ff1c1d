// SPDX-License-Identifier: GPL-3.0-or-later
//
// Formats other than OFF, OBJ, PLY and STL go through the library Assimp, in programs that are built with it.

#ifndef COARSENING_SUPPORT_ASSIMP_FORMATS_H
#define COARSENING_SUPPORT_ASSIMP_FORMATS_H

#include "io/Mesh.h"
#include "io/Text_scanner.h"

#include <string>

namespace coarsening_support {

// Whether Assimp reads, or writes, files with this ending; never in programs without it, and not for the formats that read_soup()
// reads by itself.
bool assimp_reads(const std::string& type);
bool assimp_writes(const std::string& type);

// Says in words, for the end of a message on a type that is unknown, what Assimp could do about it.
std::string assimp_hint(const std::string& type);

// Parses the content. Other files that it names are found beside `file`, unless that is empty. Assimp runs in a process of its
// own, with bounded time and memory: it may crash, and this program does not. Throws Format_fault.
void read_with_assimp(const std::string& content, const std::string& file, const std::string& type, Soup& soup, const Stop& stop);

// Returns what a file of this type holds for the mesh, in single precision. Throws Failure.
std::string assimp_bytes(const Mesh& mesh, const std::string& type);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_ASSIMP_FORMATS_H
