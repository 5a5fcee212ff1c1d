// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write_off.h"

#include "io/Corner_fields.h"
#include "io/Number_property.h"
#include "io/Text_writer.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace coarsen_mesh_tool {
namespace {

template <class Element>
void write_color(const Color_properties<Element>& color, Element e, Text_writer& text)
{
  for (const Number_property<Element>* part : {&color.red, &color.green, &color.blue})
    (text << ' ').number(part->byte(e));
  (text << ' ').number(color.alpha ? color.alpha.byte(e) : 255);
}

} // namespace

std::string off_bytes(const Mesh& mesh, const File_notes& notes)
{
  const Color_properties<Vertex> color(mesh);
  const Color_properties<Face> face_color(mesh);
  const Normal_properties normal(mesh);
  const std::optional<std::vector<Texture_point> > texture = texture_of_vertices(mesh);
  Text_writer text;
  text << (texture ? "ST" : "") << (color ? "C" : "") << (normal ? "N" : "") << "OFF\n";
  text.comments(notes);
  text.number(mesh.number_of_vertices()) << ' ';
  text.number(mesh.number_of_faces()) << " 0\n";
  for (const Vertex v : mesh.vertices()) {
    text.coordinates(mesh.point(v));
    if (normal)
      for (const Number_property<Vertex>* n : {&normal.x, &normal.y, &normal.z})
        (text << ' ').number((*n)(v));
    if (color)
      write_color(color, v, text);
    if (texture)
      for (const double x : (*texture)[std::size_t(v)])
        (text << ' ').number(x);
    text << '\n';
  }
  for (const Face f : mesh.faces()) {
    text.number(mesh.degree(f));
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
      (text << ' ').number(std::size_t(mesh.target(h)));
    if (face_color)
      write_color(face_color, f, text);
    text << '\n';
  }
  return std::move(text).bytes();
}

} // namespace coarsen_mesh_tool
