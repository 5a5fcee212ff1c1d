// SPDX-License-Identifier: GPL-3.0-or-later

#include "patches.h"

#include "io/Number_property.h"

#include <map>

namespace coarsen_mesh_tool {
namespace {

std::vector<std::int64_t> numbered(const Mesh& mesh, const Mesh::Property_map<Face, std::string>& names)
{
  std::map<std::string, std::int64_t> numbers;
  std::vector<std::int64_t> result;
  for (const Face f : mesh.faces())
    result.push_back(numbers.emplace(names[f], std::int64_t(numbers.size())).first->second);
  return result;
}

} // namespace

std::optional<std::vector<std::int64_t> > patches(const Mesh& mesh, const std::string& field)
{
  const std::string name = field == "solid" ? "group" : field; // of STL
  for (const char* property : {material_property, group_property, object_property}) {
    const Found_property<Face, std::string> names(mesh, property);
    if (names && property == "f:" + name + " name")
      return numbered(mesh, names.map);
  }
  const Number_property<Face> numbers = number_property<Face>(mesh, field);
  if (!numbers || !numbers.is_whole())
    return std::nullopt;
  std::vector<std::int64_t> result;
  for (const Face f : mesh.faces())
    result.push_back(std::int64_t(numbers(f)));
  return result;
}

} // namespace coarsen_mesh_tool
