// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write_mesh.h"

#include "io/Corner_fields.h"
#include "io/Failure.h"
#include "io/Number_property.h"
#include "io/assimp_formats.h"
#include "io/file_type.h"
#include "io/read_soup.h"
#include "io/write_obj.h"
#include "io/write_off.h"
#include "io/write_ply.h"

#include <CGAL/IO/STL.h>
#include <CGAL/boost/graph/IO/STL.h>

#include <algorithm>
#include <ios>
#include <sstream>

namespace coarsen_mesh_tool {

namespace {

std::string stl_bytes(const Mesh& mesh)
{
  std::ostringstream os(std::ios::out | std::ios::binary);
  CGAL::IO::set_binary_mode(os);
  if (!CGAL::IO::write_STL(os, mesh) || !os)
    throw Failure("the result", "cannot be written as stl");
  return os.str();
}

struct Field
{
  std::string words;
  std::vector<std::string> types; // of files that have it
};

bool is_one_of(const std::string& name, const std::vector<std::string>& names)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

Field field_of_vertices(const Mesh& mesh, const std::string& name)
{
  if (is_one_of(name, {"v:red", "v:green", "v:blue"}) && Color_properties<Vertex>(mesh))
    return {"the colors of vertices", {"ply", "off", "obj"}};
  if (name == "v:alpha" && Color_properties<Vertex>(mesh))
    return {"the opacities of vertices", {"ply", "off"}};
  if (is_one_of(name, {"v:nx", "v:ny", "v:nz"}) && Normal_properties(mesh))
    return {"the normals of vertices", {"ply", "off", "obj"}};
  if (is_one_of(name, {"v:s", "v:t", "v:u", "v:v", "v:texture_u", "v:texture_v"}) && Texture_properties(mesh))
    return {"the texture coordinates of vertices", {"ply", "off", "obj"}};
  return {"the numbers '" + escaped(name.substr(2)) + "' of vertices", {"ply"}};
}

Field field_of_faces(const Mesh& mesh, const std::string& name)
{
  if (is_one_of(name, {"f:red", "f:green", "f:blue", "f:alpha"}) && Color_properties<Face>(mesh))
    return {"the colors of faces", {"ply", "off"}};
  if (name == material_property)
    return {"the materials of faces", {"obj"}};
  if (name == group_property)
    return {"the groups of faces", {"obj"}};
  if (name == object_property)
    return {"the names of objects", {"obj"}};
  return {"the numbers '" + escaped(name.substr(2)) + "' of faces", {"ply"}};
}

// The fields of a mesh, several of which may be one field in words.
std::vector<Field> fields(const Mesh& mesh, const File_notes& notes)
{
  static const Mesh plain;
  const bool corners_agree = !Texture_properties(mesh) && texture_of_vertices(mesh);
  std::vector<Field> result;
  for (const std::string& name : mesh.properties<Vertex>())
    if (!is_one_of(name, plain.properties<Vertex>()))
      result.push_back(field_of_vertices(mesh, name));
  for (const std::string& name : mesh.properties<Face>())
    if (!is_one_of(name, plain.properties<Face>()))
      result.push_back(field_of_faces(mesh, name));
  for (const std::string& name : mesh.properties<Halfedge>())
    if (name == texture_property)
      result.push_back({"the texture coordinates of corners",
                        corners_agree ? std::vector<std::string>{"ply", "off", "obj"} : std::vector<std::string>{"ply", "obj"}});
    else if (name == normal_property)
      result.push_back({"the normals of corners", {"obj"}});
  if (!notes.material_libraries.empty())
    result.push_back({"the names of material libraries", {"obj"}});
  if (!notes.comments.empty())
    result.push_back({"the comments", {"ply", "off", "obj"}});
  return result;
}

// The fields, in words, that are read back from a file that Assimp has written, found by writing a triangle.
std::vector<std::string> fields_that_return(const std::string& type)
{
  Mesh mesh;
  mesh.add_face(mesh.add_vertex(Point(0, 0, 0)), mesh.add_vertex(Point(1, 0, 0)), mesh.add_vertex(Point(0, 1, 0)));
  for (const char* name : {"v:red", "v:green", "v:blue", "v:alpha"})
    mesh.add_property_map<Vertex, double>(name, 0.5);
  for (const char* name : {"v:nx", "v:ny", "v:nz"})
    mesh.add_property_map<Vertex, double>(name, name[3] == 'z');
  mesh.add_property_map<Halfedge, Texture_point>(texture_property, Texture_point{{0.25, 0.75}});
  const std::string material = "stone";
  mesh.add_property_map<Face, std::string>(material_property, material);
  const Soup soup = parse_soup(assimp_bytes(mesh, type), type);
  const auto has = [&](const char* name) {
    return std::any_of(soup.of_points.begin(), soup.of_points.end(), [&](const Soup_property& p) { return p.name == name; });
  };
  std::vector<std::string> result;
  if (has("red"))
    result.push_back("the colors of vertices");
  if (has("alpha"))
    result.push_back("the opacities of vertices");
  if (soup.materials == std::vector<std::string>{material})
    result.push_back("the materials of faces");
  if (has("nx"))
    result.insert(result.end(), {"the normals of vertices", "the normals of corners"});
  if (!soup.texture_points.empty())
    result.insert(result.end(), {"the texture coordinates of vertices", "the texture coordinates of corners"});
  return result;
}

} // namespace

std::string mesh_bytes(const Mesh& mesh, const std::string& type, const File_notes& notes)
{
  return type == "off"   ? off_bytes(mesh, notes)
         : type == "obj" ? obj_bytes(mesh, notes)
         : type == "ply" ? ply_bytes(mesh, notes)
         : type == "stl" ? stl_bytes(mesh)
                         : assimp_bytes(mesh, type);
}

std::vector<std::string> fields_without_room(const Mesh& mesh, const std::string& type, const File_notes& notes)
{
  std::vector<std::string> result;
  const std::vector<std::string> kept_by_assimp = is_own_file_type(type) ? std::vector<std::string>() : fields_that_return(type);
  for (const Field& field : fields(mesh, notes))
    if (!is_one_of(type, field.types) && !is_one_of(field.words, kept_by_assimp) && !is_one_of(field.words, result))
      result.push_back(field.words);
  return result;
}

} // namespace coarsen_mesh_tool
