// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write_obj.h"

#include "io/Corner_fields.h"
#include "io/Text_writer.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace coarsen_mesh_tool {
namespace {

// A line `keyword name` where the name changes.
void write_name(Text_writer& text, std::string_view keyword, const std::string& name, std::string& last)
{
  if (name != last)
    text << keyword << ' ' << name << '\n';
  last = name;
}

// The values that corners have, numbered from 1 in the order in which the corners need them.
template <class Value>
class Numbered_values
{
  std::map<Value, std::size_t> numbers_;

public:
  // `value(h)` is that of the corner which a halfedge points to.
  template <class Read>
  Numbered_values(const Mesh& mesh, std::string_view keyword, const Read& value, Text_writer& text)
  {
    for (const Face f : mesh.faces())
      for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
        const Value x = value(h);
        if (!numbers_.emplace(x, numbers_.size() + 1).second)
          continue;
        text << keyword;
        for (const double number : x)
          (text << ' ').number(number);
        text << '\n';
      }
  }
  std::size_t operator[](const Value& value) const { return numbers_.at(value); }
};

void write_vertices(const Mesh& mesh, Text_writer& text)
{
  const Color_properties<Vertex> color(mesh);
  for (const Vertex v : mesh.vertices()) {
    (text << "v ").coordinates(mesh.point(v));
    if (color)
      for (const Number_property<Vertex>* part : {&color.red, &color.green, &color.blue})
        (text << ' ').number(part->byte(v) / 255.);
    text << '\n';
  }
}

void write_faces(const Mesh& mesh, Text_writer& text)
{
  const Corner_fields fields(mesh);
  const auto texture = [&](Halfedge h) { return fields.texture(h); };
  const auto normal = [&](Halfedge h) { return fields.normal(h); };
  std::optional<Numbered_values<Texture_point> > textures;
  std::optional<Numbered_values<Corner_fields::Normal> > normals;
  if (fields.has_texture())
    textures.emplace(mesh, "vt", texture, text);
  if (fields.has_normal())
    normals.emplace(mesh, "vn", normal, text);
  const Found_property<Face, std::string> material(mesh, material_property), group(mesh, group_property),
    object(mesh, object_property);
  std::string last_material, last_group, last_object;
  for (const Face f : mesh.faces()) {
    if (object)
      write_name(text, "o", object.map[f], last_object);
    if (group)
      write_name(text, "g", group.map[f], last_group);
    if (material)
      write_name(text, "usemtl", material.map[f], last_material);
    text << 'f';
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      (text << ' ').number(std::size_t(mesh.target(h)) + 1);
      if (textures)
        (text << '/').number((*textures)[texture(h)]);
      if (normals)
        (text << (textures ? "/" : "//")).number((*normals)[normal(h)]);
    }
    text << '\n';
  }
}

} // namespace

std::string obj_bytes(const Mesh& mesh, const File_notes& notes)
{
  Text_writer text;
  text.comments(notes);
  for (const std::string& libraries : notes.material_libraries)
    text << "mtllib " << libraries << '\n';
  write_vertices(mesh, text);
  write_faces(mesh, text);
  return std::move(text).bytes();
}

} // namespace coarsen_mesh_tool
