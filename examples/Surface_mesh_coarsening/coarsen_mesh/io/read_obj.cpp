// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_obj.h"

#include "io/Row_numbers.h"
#include "io/read_comments.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <vector>

namespace coarsening_support {
namespace {

// What the format has beside vertices and faces with normals, textures, materials and groups, in words.
const char* other_obj_field(std::string_view keyword)
{
  struct Field
  {
    std::string_view keyword;
    const char* words;
  };
  static constexpr Field fields[] = {{"s", "smoothing groups"}, {"l", "lines"}, {"p", "points"},
                                     {"mg", "merging groups"}, {"bevel", "settings of the display"},
                                     {"c_interp", "settings of the display"}, {"d_interp", "settings of the display"},
                                     {"lod", "settings of the display"}, {"usemap", "texture maps"},
                                     {"maplib", "texture maps"}, {"shadow_obj", "shadows and reflections"},
                                     {"trace_obj", "shadows and reflections"}, {"call", "other files"}, {"csh", "other files"}};
  for (const Field& field : fields)
    if (field.keyword == keyword)
      return field.words;
  static constexpr std::string_view free_form[] = {"vp",   "deg",  "bmat", "step", "cstype", "curv", "curv2", "surf",
                                                   "parm", "trim", "hole", "scrv", "sp",     "end",  "con",   "ctech",
                                                   "stech"};
  return std::find(std::begin(free_form), std::end(free_form), keyword) != std::end(free_form) ? "free-form geometry" : nullptr;
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

// A number behind the first or second slash of a corner V/T/N; `no_vertex` if it has none.
Vertex_number obj_attribute(std::string_view word, int slashes, std::size_t number_of_them)
{
  for (; slashes > 0; --slashes) {
    const std::size_t slash = word.find('/');
    if (slash == std::string_view::npos)
      return no_vertex;
    word.remove_prefix(slash + 1);
  }
  const std::string_view number = word.substr(0, word.find('/'));
  long long value = 0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), value);
  if (number.empty() || read.ec != std::errc() || read.ptr != number.data() + number.size())
    return no_vertex;
  if (value < 0)
    value += static_cast<long long>(number_of_them) + 1;
  return value < 1 || value > static_cast<long long>(number_of_them) ? no_vertex
                                                                     : to_vertex_number(static_cast<std::size_t>(value) - 1);
}

// The polygons that have got no attributes so far have none.
void end_corners(Polygons& corners, std::size_t polygons)
{
  while (corners.size() < polygons)
    corners.end_polygon();
}

// What the corners of a face have is kept if each of them has it.
void add_corners(const std::vector<Vertex_number>& attributes, const Soup& soup, Polygons& corners)
{
  if (std::find(attributes.begin(), attributes.end(), no_vertex) != attributes.end())
    return;
  end_corners(corners, soup.polygons.size() - 1);
  corners.push_back(attributes);
}

struct Obj_corners
{
  std::vector<Vertex_number> texture, normals;
};

void read_obj_face(Text_scanner& text, Soup& soup, Obj_corners& corners)
{
  corners.texture.clear();
  corners.normals.clear();
  for (std::string_view word = text.word(); !word.empty(); word = text.word()) {
    soup.polygons.add_corner(obj_vertex(text, word, soup.points.size()));
    corners.texture.push_back(obj_attribute(word, 1, soup.texture_points.size()));
    corners.normals.push_back(obj_attribute(word, 2, soup.normals.size()));
  }
  soup.polygons.end_polygon();
  add_corners(corners.texture, soup, soup.texture_corners);
  add_corners(corners.normals, soup, soup.normal_corners);
}

void read_obj_point(Text_scanner& text, Soup& soup, Row_numbers& behind)
{
  const double x = text.number("coordinate x of a vertex"), y = text.number("coordinate y of a vertex"),
               z = text.number("coordinate z of a vertex");
  soup.points.emplace_back(x, y, z);
  behind.read_row(text);
}

void read_obj_normal(Text_scanner& text, Soup& soup)
{
  double n[3];
  for (double& x : n)
    if (!text.try_number(x) || !std::isfinite(x))
      x = 0;
  soup.normals.emplace_back(n[0], n[1], n[2]);
}

// Where all corners at a vertex have the same normal, it is the vertex's, as other formats have it.
void give_normals_to_points(Soup& soup)
{
  const Polygons& corners = soup.normal_corners;
  if (corners.corners().size() != soup.polygons.corners().size())
    return;
  std::vector<Vertex_number> normal(soup.points.size(), no_vertex);
  for (std::size_t c = 0; c < corners.corners().size(); ++c) {
    const Vertex_number v = soup.polygons.corners()[c], n = corners.corners()[c];
    if (v >= normal.size() || (normal[v] != no_vertex && soup.normals[normal[v]] != soup.normals[n]))
      return;
    normal[v] = n;
  }
  static const char* const names[] = {"nx", "ny", "nz"};
  for (int i = 0; i < 3; ++i) {
    soup.of_points.push_back({names[i], Number_type::FLOAT64, {}});
    for (const Vertex_number n : normal)
      soup.of_points.back().values.push_back(n == no_vertex ? 0 : soup.normals[n][i]);
  }
  soup.normals.clear();
  soup.normal_corners.clear();
}

// Behind the coordinates there may be a color, with or without an opacity, and nothing else that is known.
void add_numbers_behind_points(const Row_numbers& numbers, Soup& soup)
{
  if (numbers.is_regular() && (numbers.width() == 3 || numbers.width() == 4))
    numbers.add_colors(0, numbers.width(), soup.of_points, soup);
  else if (!numbers.empty())
    soup.leave_out("the numbers behind the coordinates of vertices");
}

// The words up to the end of the line: names may have blanks.
std::string name_of(Text_scanner& text)
{
  std::string name;
  for (std::string_view word = text.word(); !word.empty(); word = text.word())
    (name += name.empty() ? "" : " ") += word;
  return name;
}

void read_obj_texture_point(Text_scanner& text, Soup& soup)
{
  const double u = text.number("coordinate u of a texture point"),
               v = text.next_word().empty() ? 0 : text.number("coordinate v of a texture point");
  double depth = 0;
  if (!text.next_word().empty() && text.try_number(depth) && depth != 0)
    soup.leave_out("third coordinates of textures");
  soup.texture_points.push_back({{std::isfinite(u) ? u : 0, std::isfinite(v) ? v : 0}});
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
  read_comments(content, "vf", soup);
  Text_scanner text(content.data(), content.data() + content.size(), '#', true);
  std::string material, group, object;
  Obj_corners corners;
  Row_numbers behind_points;
  for (std::size_t line = 0; text.find_line(); ++line) {
    stop_at(line, stop);
    const std::string_view keyword = text.word();
    if (keyword == "v") {
      read_obj_point(text, soup, behind_points);
    } else if (keyword == "f" || keyword == "fo") {
      read_obj_face(text, soup, corners);
    } else if (keyword == "vn") {
      read_obj_normal(text, soup);
    } else if (keyword == "vt") {
      read_obj_texture_point(text, soup);
    } else if (keyword == "usemtl") {
      name_polygons(soup.materials, material, soup);
      material = name_of(text);
    } else if (keyword == "g") {
      name_polygons(soup.groups, group, soup);
      group = name_of(text);
    } else if (keyword == "o") {
      name_polygons(soup.objects, object, soup);
      object = name_of(text);
    } else if (keyword == "mtllib") {
      soup.notes.material_libraries.push_back(name_of(text));
    } else {
      const char* const field = other_obj_field(keyword);
      if (field == nullptr)
        text.fail(Text_scanner::shown(keyword) + " is no keyword of OBJ");
      const bool says_off = keyword == "s" && (text.next_word() == "off" || text.next_word() == "0");
      if (!says_off)
        soup.leave_out(field);
    }
    text.skip_line();
  }
  name_polygons(soup.materials, material, soup);
  name_polygons(soup.groups, group, soup);
  name_polygons(soup.objects, object, soup);
  if (!soup.texture_corners.empty())
    end_corners(soup.texture_corners, soup.polygons.size());
  if (!soup.normal_corners.empty())
    end_corners(soup.normal_corners, soup.polygons.size());
  give_normals_to_points(soup);
  add_numbers_behind_points(behind_points, soup);
}

} // namespace coarsening_support
