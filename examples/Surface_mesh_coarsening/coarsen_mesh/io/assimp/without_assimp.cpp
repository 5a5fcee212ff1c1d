// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Failure.h"
#include "io/assimp_formats.h"

namespace coarsening_support {

bool assimp_reads(const std::string&) { return false; }

bool assimp_writes(const std::string&) { return false; }

std::string assimp_hint(const std::string& type)
{
  for (const char* common : {"3ds", "3mf", "dae", "fbx", "glb", "gltf", "x3d"})
    if (type == common)
      return ": the format " + type + " takes a program that is built with the library Assimp";
  return "";
}

void read_with_assimp(const std::string&, const std::string&, const std::string&, Soup&, const Stop&)
{
  throw Format_fault("the program", "is built without the library Assimp");
}

std::string assimp_bytes(const Mesh&, const std::string&)
{
  throw Failure("the result", "cannot be written: the program is built without the library Assimp");
}

} // namespace coarsening_support
