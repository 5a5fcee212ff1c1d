// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_SOUP_PROPERTIES_H
#define COARSENING_SUPPORT_SOUP_PROPERTIES_H

#include "io/Mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace coarsening_support {

typedef std::array<double, 2> Texture_point;

// The names of the properties for textures and materials.
constexpr const char* texture_property = "h:texture";
constexpr const char* normal_property = "h:normal";
constexpr const char* material_property = "f:material name";
constexpr const char* group_property = "f:group name";
constexpr const char* object_property = "f:object name";

template <class Element, class Number>
void add_numbers(const std::string& name, const std::vector<double>& values, Mesh& mesh)
{
  const auto map = mesh.add_property_map<Element, Number>(name).first;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if constexpr (std::is_integral<Number>::value)
      map[Element(Mesh::size_type(i))] =
        std::abs(values[i]) < 1e18 ? static_cast<Number>(static_cast<std::int64_t>(values[i])) : 0;
    else
      map[Element(Mesh::size_type(i))] = static_cast<Number>(values[i]);
  }
}

template <class Element>
void add_property(const std::string& prefix, const Soup_property& p, Mesh& mesh)
{
  const std::string name = prefix + p.name;
  if (p.name == "point" || p.name == "removed" || p.name == "connectivity") // built-in properties of the mesh
    return;
  switch (p.type) {
  case Number_type::INT8: return add_numbers<Element, std::int8_t>(name, p.values, mesh);
  case Number_type::UINT8: return add_numbers<Element, std::uint8_t>(name, p.values, mesh);
  case Number_type::INT16: return add_numbers<Element, std::int16_t>(name, p.values, mesh);
  case Number_type::UINT16: return add_numbers<Element, std::uint16_t>(name, p.values, mesh);
  case Number_type::INT32: return add_numbers<Element, std::int32_t>(name, p.values, mesh);
  case Number_type::UINT32: return add_numbers<Element, std::uint32_t>(name, p.values, mesh);
  case Number_type::FLOAT32: return add_numbers<Element, float>(name, p.values, mesh);
  case Number_type::FLOAT64: return add_numbers<Element, double>(name, p.values, mesh);
  }
}

inline void add_names(const char* name, const std::vector<std::string>& names, Mesh& mesh)
{
  if (names.empty())
    return;
  const auto map = mesh.add_property_map<Face, std::string>(name).first;
  for (std::size_t f = 0; f < names.size(); ++f)
    map[Face(Mesh::size_type(f))] = names[f];
}

// Gives the halfedges at the corners of faces what `corners` says they have of `values`.
template <class Value>
void add_corner_values(const Soup& soup, const Polygons& corners, const std::vector<Value>& values, const char* name,
                       const Value& none, Mesh& mesh)
{
  if (corners.corners().empty())
    return;
  const auto map = mesh.add_property_map<Halfedge, Value>(name, none).first;
  for (std::size_t f = 0; f < corners.size(); ++f) {
    if (corners[f].empty())
      continue;
    // The first halfedge of the face leaves its first corner, or a later one.
    Halfedge h = mesh.halfedge(Face(Mesh::size_type(f)));
    while (Vertex_number(mesh.target(h)) != soup.polygons[f][0])
      h = mesh.next(h);
    for (const Vertex_number t : corners[f]) {
      map[h] = values[t];
      h = mesh.next(h);
    }
  }
}

// Adds the properties of a soup to the mesh that to_mesh() has built from it.
inline void add_properties(const Soup& soup, Mesh& mesh)
{
  for (const Soup_property& p : soup.of_points)
    add_property<Vertex>("v:", p, mesh);
  for (const Soup_property& p : soup.of_polygons)
    add_property<Face>("f:", p, mesh);
  add_corner_values(soup, soup.texture_corners, soup.texture_points, texture_property, Texture_point{{0, 0}}, mesh);
  add_corner_values(soup, soup.normal_corners, soup.normals, normal_property, Vector(0, 0, 0), mesh);
  add_names(material_property, soup.materials, mesh);
  add_names(group_property, soup.groups, mesh);
  add_names(object_property, soup.objects, mesh);
}

// Returns the property map of this name and type; converts to false if there is none.
template <class Element, class Value>
struct Found_property
{
  Mesh::Property_map<Element, Value> map;
  bool found = false;

  Found_property(const Mesh& mesh, const char* name)
  {
    const auto result = mesh.property_map<Element, Value>(name);
    if constexpr (std::is_same<std::decay_t<decltype(result)>, std::pair<Mesh::Property_map<Element, Value>, bool> >::value) {
      map = result.first;
      found = result.second;
    } else { // from CGAL 6 on
      found = bool(result);
      if (found)
        map = *result;
    }
  }
  explicit operator bool() const { return found; }
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_SOUP_PROPERTIES_H
