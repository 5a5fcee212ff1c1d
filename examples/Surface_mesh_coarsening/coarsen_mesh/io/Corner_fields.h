// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_CORNER_FIELDS_H
#define COARSENING_SUPPORT_CORNER_FIELDS_H

#include "io/Number_property.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace coarsening_support {

// What corners have: their own, or the vertex's. A corner is a halfedge that points to it.
class Corner_fields
{
  const Mesh& mesh_;
  Found_property<Halfedge, Texture_point> texture_;
  Found_property<Halfedge, Vector> normal_;
  Texture_properties vertex_texture_;
  Normal_properties vertex_normal_;

public:
  typedef std::array<double, 3> Normal;

  explicit Corner_fields(const Mesh& mesh)
    : mesh_(mesh),
      texture_(mesh, texture_property),
      normal_(mesh, normal_property),
      vertex_texture_(mesh),
      vertex_normal_(mesh)
  {}

  bool has_texture() const { return texture_ || vertex_texture_; }
  bool has_normal() const { return normal_ || vertex_normal_; }

  Texture_point texture(Halfedge h) const
  {
    const Vertex v = mesh_.target(h);
    return texture_ ? texture_.map[h] : Texture_point{{vertex_texture_.u(v), vertex_texture_.v(v)}};
  }
  Normal normal(Halfedge h) const
  {
    const Vertex v = mesh_.target(h);
    return normal_ ? Normal{{normal_.map[h].x(), normal_.map[h].y(), normal_.map[h].z()}}
                   : Normal{{vertex_normal_.x(v), vertex_normal_.y(v), vertex_normal_.z(v)}};
  }
};

// Returns the texture coordinates of vertices; if there are none, those of the corners, if all corners at each vertex agree.
inline std::optional<std::vector<Texture_point> > texture_of_vertices(const Mesh& mesh)
{
  const Texture_properties of_vertices(mesh);
  const Found_property<Halfedge, Texture_point> of_corners(mesh, texture_property);
  if (!of_vertices && !of_corners)
    return std::nullopt;
  std::vector<Texture_point> result(mesh.number_of_vertices());
  if (of_vertices) {
    for (const Vertex v : mesh.vertices())
      result[std::size_t(v)] = {{of_vertices.u(v), of_vertices.v(v)}};
    return result;
  }
  for (const Face f : mesh.faces())
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
      result[std::size_t(mesh.target(h))] = of_corners.map[h];
  for (const Face f : mesh.faces())
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
      if (of_corners.map[h] != result[std::size_t(mesh.target(h))])
        return std::nullopt;
  return result;
}

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_CORNER_FIELDS_H
