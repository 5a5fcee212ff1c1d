// SPDX-License-Identifier: GPL-3.0-or-later

#include "patches.h"

#include "io/Number_property.h"

#include <map>
#include <type_traits>

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

// Returns the property map of names that the field means, if the mesh has it.
std::optional<std::string> property_of_names(const Mesh& mesh, const std::string& field)
{
  const std::string name = field == "solid" ? "group" : field; // of STL
  for (const char* property : {material_property, group_property, object_property})
    if (property == "f:" + name + " name" && Found_property<Face, std::string>(mesh, property))
      return property;
  return std::nullopt;
}

} // namespace

std::optional<std::vector<std::int64_t> > patches(const Mesh& mesh, const std::string& field)
{
  if (const auto names = property_of_names(mesh, field))
    return numbered(mesh, Found_property<Face, std::string>(mesh, names->c_str()).map);
  const Number_property<Face> numbers = number_property<Face>(mesh, field);
  if (!numbers || !numbers.is_whole())
    return std::nullopt;
  std::vector<std::int64_t> result;
  for (const Face f : mesh.faces())
    result.push_back(std::int64_t(numbers(f)));
  return result;
}

void write_patches(const Mesh& input, const std::vector<std::int64_t>& patch_of_input, const std::string& field,
                   const std::vector<std::int64_t>& patch_of_result, Mesh& result)
{
  std::map<std::int64_t, Face> some_face;
  for (const Face f : input.faces())
    some_face.emplace(patch_of_input[f], f);
  const auto write = [&](const auto& from, auto to) {
    for (const Face f : result.faces())
      to[f] = from[some_face.at(patch_of_result[f])];
  };
  if (const auto names = property_of_names(input, field))
    write(Found_property<Face, std::string>(input, names->c_str()).map,
          result.add_property_map<Face, std::string>(*names).first);
  else
    use_numbers<Face>(input, "f:" + field, [&](const auto& from) {
      typedef typename std::decay_t<decltype(from)>::value_type Number;
      write(from, result.add_property_map<Face, Number>("f:" + field).first);
    });
}

} // namespace coarsen_mesh_tool
