// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write_ply.h"

#include "io/Number_property.h"

#include <boost/endian/conversion.hpp>
#include <boost/integer.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <type_traits>
#include <vector>

namespace coarsen_mesh_tool {
namespace {

template <class Number>
void append(Number number, std::string& bytes)
{
  typename boost::uint_t<8 * sizeof(Number)>::exact bits;
  std::memcpy(&bits, &number, sizeof bits);
  bits = boost::endian::native_to_little(bits);
  char raw[sizeof bits];
  std::memcpy(raw, &bits, sizeof bits);
  bytes.append(raw, sizeof raw);
}

template <class Number>
constexpr const char* type_name()
{
  if constexpr (std::is_floating_point<Number>::value)
    return sizeof(Number) == 4 ? "float" : "double";
  else if constexpr (std::is_signed<Number>::value)
    return sizeof(Number) == 1 ? "char" : sizeof(Number) == 2 ? "short" : "int";
  else
    return sizeof(Number) == 1 ? "uchar" : sizeof(Number) == 2 ? "ushort" : "uint";
}

template <class Element>
struct Column
{
  std::string type, name;
  std::function<void(Element, std::string&)> append_value;
};

// The numbers that elements have, under their names in the mesh without the "v:" or "f:" before them.
template <class Element>
std::vector<Column<Element> > number_columns(const Mesh& mesh)
{
  std::vector<Column<Element> > columns;
  for (const std::string& name : mesh.properties<Element>())
    use_numbers<Element>(mesh, name, [&](const auto& map) {
      typedef typename std::decay_t<decltype(map)>::value_type Number;
      columns.push_back({type_name<Number>(), name.substr(2), [map](Element e, std::string& bytes) { append(map[e], bytes); }});
    });
  return columns;
}

template <class Element>
void declare(const std::vector<Column<Element> >& columns, std::string& header)
{
  for (const Column<Element>& column : columns)
    header += "property " + column.type + " " + column.name + "\n";
}

// The lengths of lists are of one byte if that is enough.
class List_lengths
{
  bool are_short_ = true;

public:
  explicit List_lengths(const Mesh& mesh)
  {
    for (const Face f : mesh.faces())
      are_short_ = are_short_ && 2 * mesh.degree(f) < 256;
  }
  const char* type() const { return are_short_ ? "uchar" : "uint"; }
  void append_length(std::size_t n, std::string& bytes) const
  {
    if (are_short_)
      append(static_cast<std::uint8_t>(n), bytes);
    else
      append(static_cast<std::uint32_t>(n), bytes);
  }
};

// Texture coordinates as MeshLab and others write them: a list for each face, with two numbers for each corner.
void append_texture(const Mesh& mesh, const Found_property<Halfedge, Texture_point>& texture, Face f, const List_lengths& lengths,
                    std::string& bytes)
{
  lengths.append_length(2 * mesh.degree(f), bytes);
  for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
    for (const double x : texture.map[h])
      append(static_cast<float>(x), bytes);
}

} // namespace

std::string ply_bytes(const Mesh& mesh, const File_notes& notes)
{
  const std::vector<Column<Vertex> > of_vertices = number_columns<Vertex>(mesh);
  const std::vector<Column<Face> > of_faces = number_columns<Face>(mesh);
  const Found_property<Halfedge, Texture_point> texture(mesh, texture_property);
  const List_lengths lengths(mesh);
  std::string bytes = "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& comment : notes.comments)
    bytes += "comment " + comment + "\n";
  bytes += "element vertex " + std::to_string(mesh.number_of_vertices()) +
           "\nproperty double x\nproperty double y\nproperty double z\n";
  declare(of_vertices, bytes);
  bytes += "element face " + std::to_string(mesh.number_of_faces()) + "\nproperty list " + lengths.type() +
           " int vertex_indices\n";
  if (texture)
    bytes += std::string("property list ") + lengths.type() + " float texcoord\n";
  declare(of_faces, bytes);
  bytes += "end_header\n";
  for (const Vertex v : mesh.vertices()) {
    for (int i = 0; i < 3; ++i)
      append(mesh.point(v)[i], bytes);
    for (const auto& column : of_vertices)
      column.append_value(v, bytes);
  }
  for (const Face f : mesh.faces()) {
    lengths.append_length(mesh.degree(f), bytes);
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
      append(static_cast<std::int32_t>(mesh.target(h)), bytes);
    if (texture)
      append_texture(mesh, texture, f, lengths, bytes);
    for (const auto& column : of_faces)
      column.append_value(f, bytes);
  }
  return bytes;
}

} // namespace coarsen_mesh_tool
