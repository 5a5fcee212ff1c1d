// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_obj.h"


#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <vector>

namespace coarsening_support {
namespace {

// The data of the format other than vertices and faces.
bool is_other_obj_keyword(std::string_view word)
{
  static constexpr std::string_view keywords[] = {
    "vt",        "vn",        "vp",    "g",     "o",      "s",      "usemtl",   "mtllib",   "l",
    "p",         "deg",       "bmat",  "step",  "cstype", "curv",   "curv2",    "surf",     "parm",
    "trim",      "hole",      "scrv",  "sp",    "end",    "con",    "mg",       "bevel",    "c_interp",
    "d_interp",  "lod",       "usemap", "maplib", "call",  "csh",    "shadow_obj", "trace_obj", "ctech",
    "stech"};
  return std::find(std::begin(keywords), std::end(keywords), word) != std::end(keywords);
}

// Reads the vertex in one of the forms V, V/T, V//N and V/T/N. Vertices count from 1; negative numbers count back from
// the last one read, which is -1.
Vertex_number obj_vertex(const Text_scanner& text, std::string_view word, std::size_t points)
{
  const std::string_view number = word.substr(0, word.find('/'));
  long long value = 0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), value);
  if (number.empty() || read.ec != std::errc() || read.ptr != number.data() + number.size())
    text.fail(Text_scanner::shown(word) + " stands where the number of a vertex was expected");
  if (value < 0)
    value += static_cast<long long>(points) + 1;
  return value < 1 ? no_vertex : to_vertex_number(static_cast<std::size_t>(value) - 1);
}

// Reads the texture point of a corner, in the form V/T or V/T/N; `no_vertex` if it has none.
Vertex_number obj_texture_point(std::string_view word, std::size_t points)
{
  const std::size_t slash = word.find('/');
  if (slash == std::string_view::npos)
    return no_vertex;
  const std::string_view rest = word.substr(slash + 1), number = rest.substr(0, rest.find('/'));
  long long value = 0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), value);
  if (number.empty() || read.ec != std::errc() || read.ptr != number.data() + number.size())
    return no_vertex;
  if (value < 0)
    value += static_cast<long long>(points) + 1;
  return value < 1 || value > static_cast<long long>(points) ? no_vertex
                                                                         : to_vertex_number(static_cast<std::size_t>(value) - 1);
}

// The polygons so far have no texture points.
void end_texture_corners(Soup& soup, std::size_t polygons)
{
  while (soup.texture_corners.size() < polygons)
    soup.texture_corners.end_polygon();
}

// Keeps the texture points of a face if each of its corners has one.
void read_obj_face(Text_scanner& text, Soup& soup, std::vector<Vertex_number>& texture)
{
  texture.clear();
  for (std::string_view word = text.word(); !word.empty(); word = text.word()) {
    soup.polygons.add_corner(obj_vertex(text, word, soup.points.size()));
    texture.push_back(obj_texture_point(word, soup.texture_points.size()));
  }
  soup.polygons.end_polygon();
  if (soup.texture_points.empty() || std::find(texture.begin(), texture.end(), no_vertex) != texture.end())
    return;
  end_texture_corners(soup, soup.polygons.size() - 1);
  soup.texture_corners.push_back(texture);
}

// Assigns its name to the polygons since the last one.
void name_polygons(std::vector<std::string>& names, const std::string& name, const Soup& soup)
{
  if (!names.empty() || !name.empty())
    names.resize(soup.polygons.size(), name);
}

} // namespace

void read_obj(const std::string& content, Soup& soup, const Stop& stop)
{
  Text_scanner text(content.data(), content.data() + content.size(), '#', true);
  std::string material, group;
  std::vector<Vertex_number> texture;
  for (std::size_t line = 0; text.find_line(); ++line) {
    stop_at(line, stop);
    const std::string_view keyword = text.word();
    if (keyword == "v") {
      const double x = text.number("coordinate x of a vertex"), y = text.number("coordinate y of a vertex"),
                   z = text.number("coordinate z of a vertex");
      soup.points.emplace_back(x, y, z);
    } else if (keyword == "f" || keyword == "fo") {
      read_obj_face(text, soup, texture);
    } else if (keyword == "vt") {
      const double u = text.number("coordinate u of a texture point"),
                   v = text.next_word().empty() ? 0 : text.number("coordinate v of a texture point");
      soup.texture_points.push_back({{std::isfinite(u) ? u : 0, std::isfinite(v) ? v : 0}});
    } else if (keyword == "usemtl") {
      name_polygons(soup.materials, material, soup);
      material = std::string(text.word());
    } else if (keyword == "g") {
      name_polygons(soup.groups, group, soup);
      group = std::string(text.word());
    } else if (keyword == "mtllib") {
      soup.material_library = std::string(text.word());
    } else if (!is_other_obj_keyword(keyword))
      text.fail(Text_scanner::shown(keyword) + " is no keyword of OBJ");
    text.skip_line();
  }
  name_polygons(soup.materials, material, soup);
  name_polygons(soup.groups, group, soup);
  if (!soup.texture_points.empty())
    end_texture_corners(soup, soup.polygons.size());
}

} // namespace coarsening_support
