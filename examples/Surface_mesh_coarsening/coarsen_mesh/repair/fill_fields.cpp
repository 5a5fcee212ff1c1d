// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair/fill_fields.h"

#include "io/Number_property.h"

#include <string>
#include <utility>
#include <vector>

namespace coarsen_mesh_tool {
namespace {

// For each added face, in the order in which they are reached from the others, the face that it is reached from.
std::vector<std::pair<Face, Face> > faces_and_sources(const Mesh& mesh, std::size_t first)
{
  std::vector<bool> is_reached(mesh.number_of_faces(), false);
  std::vector<std::pair<Face, Face> > result;
  const auto reach_from = [&](Face f) {
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const Face g = mesh.face(mesh.opposite(h));
      if (g != Mesh::null_face() && std::size_t(g) >= first && !is_reached[g]) {
        is_reached[g] = true;
        result.emplace_back(g, f);
      }
    }
  };
  for (std::size_t f = 0; f < first; ++f)
    reach_from(Face(Mesh::size_type(f)));
  for (std::size_t i = 0; i < result.size(); ++i)
    reach_from(Face(result[i].first));
  return result;
}

template <class Value>
void fill_corners(const char* name, std::size_t first, Mesh& mesh)
{
  const Found_property<Halfedge, Value> found(mesh, name);
  if (!found)
    return;
  auto map = found.map;
  for (std::size_t f = first; f < mesh.number_of_faces(); ++f)
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(Face(Mesh::size_type(f)))))
      for (const Halfedge g : mesh.halfedges_around_target(h))
        if (!mesh.is_border(g) && std::size_t(mesh.face(g)) < first) {
          map[h] = map[g];
          break;
        }
}

} // namespace

void fill_fields(Mesh& mesh, std::size_t first)
{
  const auto pairs = faces_and_sources(mesh, first);
  const auto fill = [&pairs](auto map) {
    for (const auto& [face, source] : pairs)
      map[face] = map[source];
  };
  for (const std::string& name : mesh.properties<Face>()) {
    use_numbers<Face>(mesh, name, fill);
    const Found_property<Face, std::string> names(mesh, name.c_str());
    if (names)
      fill(names.map);
  }
  fill_corners<Texture_point>(texture_property, first, mesh);
  fill_corners<Vector>(normal_property, first, mesh);
}

} // namespace coarsen_mesh_tool
