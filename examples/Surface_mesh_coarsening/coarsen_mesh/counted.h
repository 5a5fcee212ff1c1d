// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_COUNTED_H
#define COARSEN_MESH_COUNTED_H

#include <cstddef>
#include <string>

namespace coarsen_mesh_tool {

inline std::string counted(std::size_t number, const std::string& noun)
{
  return std::to_string(number) + " " + noun + (number == 1 ? "" : "s");
}

inline std::string counted_vertices(std::size_t number)
{
  return std::to_string(number) + (number == 1 ? " vertex" : " vertices");
}

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_COUNTED_H
