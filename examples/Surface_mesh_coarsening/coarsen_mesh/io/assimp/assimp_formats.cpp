// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/assimp_formats.h"

#include "io/assimp/export_format.h"
#include "io/file_type.h"

#include <assimp/Importer.hpp>

namespace coarsening_support {

bool assimp_reads(const std::string& type)
{
  return !type.empty() && !is_own_file_type(type) && Assimp::Importer().IsExtensionSupported("." + type);
}

// What is written is read back.
bool assimp_writes(const std::string& type) { return assimp_reads(type) && export_format(type).has_value(); }

std::string assimp_hint(const std::string&) { return ", and the library Assimp does not know that either"; }

} // namespace coarsening_support
