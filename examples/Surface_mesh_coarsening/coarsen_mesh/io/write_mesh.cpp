// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write_mesh.h"

#include "io/Failure.h"
#include "io/soup_properties.h"

#include <CGAL/IO/STL.h>
#include <CGAL/boost/graph/IO/PLY.h>
#include <CGAL/boost/graph/IO/STL.h>

#include <charconv>
#include <cstddef>
#include <ios>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

namespace coarsen_mesh_tool {

namespace {

// Text with numbers in the shortest form that reads back the same.
class Text
{
  std::string bytes_;

public:
  Text& operator<<(char c)
  {
    bytes_ += c;
    return *this;
  }
  Text& operator<<(std::string_view words)
  {
    bytes_ += words;
    return *this;
  }
  template <class Number>
  Text& number(Number value)
  {
    char digits[32];
    bytes_.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
    return *this;
  }
  Text& point(const Point& p)
  {
    number(p.x()) << ' ';
    number(p.y()) << ' ';
    return number(p.z()) << '\n';
  }
  std::string bytes() && { return std::move(bytes_); }
};

// A line `keyword name` where the name changes.
void write_name(Text& text, std::string_view keyword, const std::string& name, std::string& last)
{
  if (name != last)
    text << keyword << ' ' << name << '\n';
  last = name;
}

std::string off_bytes(const Mesh& mesh)
{
  Text text;
  text << "OFF\n";
  text.number(mesh.number_of_vertices()) << ' ';
  text.number(mesh.number_of_faces()) << " 0\n";
  for (Vertex v : mesh.vertices())
    text.point(mesh.point(v));
  for (Face f : mesh.faces()) {
    text.number(mesh.degree(f));
    for (Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
      (text << ' ').number(std::size_t(mesh.target(h)));
    text << '\n';
  }
  return std::move(text).bytes();
}

// The texture points of a mesh, numbered from 1 in the order of its corners.
std::map<Texture_point, std::size_t> write_texture_points(const Mesh& mesh, const Found_property<Halfedge, Texture_point>& texture,
                                                          Text& text)
{
  std::map<Texture_point, std::size_t> numbers;
  if (texture)
    for (Face f : mesh.faces())
      for (Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
        if (numbers.emplace(texture.map[h], numbers.size() + 1).second)
          ((text << "vt ").number(texture.map[h][0]) << ' ').number(texture.map[h][1]) << '\n';
  return numbers;
}

std::string obj_bytes(const Mesh& mesh, const std::string& material_library)
{
  const Found_property<Halfedge, Texture_point> texture(mesh, texture_property);
  const Found_property<Face, std::string> material(mesh, material_property), group(mesh, group_property);
  Text text;
  if (!material_library.empty())
    text << "mtllib " << material_library << '\n';
  for (Vertex v : mesh.vertices())
    (text << "v ").point(mesh.point(v));
  const auto numbers = write_texture_points(mesh, texture, text);
  std::string last_material, last_group;
  for (Face f : mesh.faces()) {
    if (group)
      write_name(text, "g", group.map[f], last_group);
    if (material)
      write_name(text, "usemtl", material.map[f], last_material);
    text << 'f';
    for (Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      (text << ' ').number(std::size_t(mesh.target(h)) + 1);
      if (texture)
        (text << '/').number(numbers.at(texture.map[h]));
    }
    text << '\n';
  }
  return std::move(text).bytes();
}

std::string binary_bytes(const Mesh& mesh, const std::string& type)
{
  std::ostringstream os(std::ios::out | std::ios::binary);
  CGAL::IO::set_binary_mode(os);
  const bool done = type == "ply" ? CGAL::IO::write_PLY(os, mesh) : CGAL::IO::write_STL(os, mesh);
  if (!done || !os)
    throw Failure("the result", "cannot be written as " + type);
  return os.str();
}

} // namespace

std::string mesh_bytes(const Mesh& mesh, const std::string& type, const std::string& material_library)
{
  return type == "off" ? off_bytes(mesh) : type == "obj" ? obj_bytes(mesh, material_library) : binary_bytes(mesh, type);
}

} // namespace coarsen_mesh_tool
