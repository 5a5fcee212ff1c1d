// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_soup.h"

#include "io/Descriptor.h"
#include "io/Failure.h"
#include "io/assimp_formats.h"
#include "io/file_bytes.h"
#include "io/file_type.h"
#include "io/read_obj.h"
#include "io/read_off.h"
#include "io/read_ply.h"
#include "io/read_stl.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

namespace coarsening_support {
namespace {

// Guesses the format for users whose file has the wrong name.
std::string look_alike(const std::string& content, const std::string& type)
{
  Text_scanner text(content.data(), content.data() + content.size(), '#');
  if (!text.find_line())
    return "";
  const std::string word = lower_case(std::string(text.word()));
  std::string other;
  if (word == "ply" || word == "off")
    other = word;
  else if (word == "solid")
    other = "stl";
  else if (word == "v")
    other = "obj";
  return other.empty() || other == type ? "" : " (it looks like " + upper_case(other) + ")";
}

// Not a pipe, which can be read once only.
bool is_in_directory(const std::string& file)
{
  std::error_code error;
  return file != standard_stream && std::filesystem::is_regular_file(file, error);
}

} // namespace

Soup parse_soup(const std::string& content, const std::string& type, const Stop& stop, const std::string& file)
{
  Soup soup;
  if (type == "off")
    read_off(content, soup, stop);
  else if (type == "obj")
    read_obj(content, soup, stop);
  else if (type == "ply")
    read_ply(content, soup, stop);
  else if (type == "stl")
    read_stl(content, soup, stop);
  else
    read_with_assimp(content, file, type, soup, stop);
  return soup;
}

Soup read_soup(const std::string& file, const Stop& stop, const std::string& type_of_stream)
{
  const std::string type = file == standard_stream ? type_of_stream : file_type(file);
  if (!is_own_file_type(type) && !assimp_reads(type))
    throw Failure(file, "has no known mesh file type (.off, .obj, .ply, .stl)" + assimp_hint(type));
  const std::string content = file_bytes(file, stop);
  Soup soup;
  try {
    soup = parse_soup(content, type, stop, is_in_directory(file) ? file : "");
  } catch (const Format_fault& e) {
    throw Failure(file, "cannot be read as " + upper_case(type) + ": " + e.what() + look_alike(content, type));
  }
  if (soup.polygons.empty())
    throw Failure(file, "has no faces");
  return soup;
}

std::size_t drop_unused_points(Soup& soup)
{
  std::vector<char> is_used(soup.points.size(), false);
  for (const Vertex_number v : soup.polygons.corners())
    is_used[v] = true;
  const auto dropped = static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), false));
  if (dropped == 0)
    return 0;
  std::vector<Vertex_number> number(soup.points.size());
  Vertex_number kept = 0;
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    if (is_used[v]) {
      soup.points[kept] = soup.points[v];
      for (Soup_property& property : soup.of_points)
        property.values[kept] = property.values[v];
      number[v] = kept++;
    }
  for (Soup_property& property : soup.of_points)
    property.values.resize(kept);
  soup.points.resize(kept);
  for (Vertex_number& v : soup.polygons.corners())
    v = number[v];
  return dropped;
}

} // namespace coarsening_support
