// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write_mesh.h"

#include "io/Failure.h"
#include "io/soup_properties.h"

#include <CGAL/IO/STL.h>
#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/boost/graph/IO/PLY.h>
#include <CGAL/boost/graph/IO/STL.h>

#include <cstddef>
#include <ios>
#include <map>
#include <sstream>

namespace coarsen_mesh_tool {

namespace {

// A line `keyword name` where the name changes.
void write_name(std::ostream& os, const char* keyword, const std::string& name, std::string& last)
{
  if (name != last)
    os << keyword << ' ' << name << '\n';
  last = name;
}

bool write_obj_with_properties(std::ostream& os, const Mesh& mesh, const std::string& material_library)
{
  const Found_property<Halfedge, Texture_point> texture(mesh, texture_property);
  const Found_property<Face, std::string> material(mesh, material_property), group(mesh, group_property);
  if (!texture && !material && !group)
    return false;
  if (!material_library.empty())
    os << "mtllib " << material_library << '\n';
  for (Vertex v : mesh.vertices())
    os << "v " << mesh.point(v) << '\n';
  std::map<Texture_point, std::size_t> numbers;
  if (texture)
    for (Face f : mesh.faces())
      for (Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
        if (numbers.emplace(texture.map[h], numbers.size() + 1).second)
          os << "vt " << texture.map[h][0] << ' ' << texture.map[h][1] << '\n';
  std::string last_material, last_group;
  for (Face f : mesh.faces()) {
    if (group)
      write_name(os, "g", group.map[f], last_group);
    if (material)
      write_name(os, "usemtl", material.map[f], last_material);
    os << 'f';
    for (Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      os << ' ' << std::size_t(mesh.target(h)) + 1;
      if (texture)
        os << '/' << numbers.at(texture.map[h]);
    }
    os << '\n';
  }
  return true;
}

} // namespace

std::string mesh_bytes(const Mesh& mesh, const std::string& type, const std::string& material_library)
{
  std::ostringstream os(std::ios::out | std::ios::binary);
  os.precision(17);
  if (type == "obj" && write_obj_with_properties(os, mesh, material_library))
    return os.str();
  const auto np = CGAL::parameters::stream_precision(17);
  bool done = false;
  if (type == "off")
    done = CGAL::IO::write_OFF(os, mesh, np);
  else if (type == "obj")
    done = CGAL::IO::write_OBJ(os, mesh, np);
  else {
    CGAL::IO::set_binary_mode(os);
    done = type == "ply" ? CGAL::IO::write_PLY(os, mesh) : CGAL::IO::write_STL(os, mesh);
  }
  if (!done || !os)
    throw Failure("the result", "cannot be written as " + type);
  return os.str();
}

} // namespace coarsen_mesh_tool
