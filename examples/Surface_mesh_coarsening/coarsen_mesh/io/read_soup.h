// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads a mesh file as a polygon soup. Whatever is wrong with the file comes out as one exception with one line of text.

#ifndef COARSENING_SUPPORT_READ_SOUP_H
#define COARSENING_SUPPORT_READ_SOUP_H

#include "io/Failure.h"
#include "io/Mesh.h"
#include "io/file_bytes.h"
#include "io/file_type.h"
#include "io/read_obj.h"
#include "io/read_off.h"
#include "io/read_ply.h"
#include "io/read_stl.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace coarsening_support {

// A guess for users whose file has the wrong name.
inline std::string look_alike(const std::string& content, const std::string& type)
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

// Makes a soup of the content of a file of the type, without any check of what its numbers mean. What it asks memory for is
// bounded by a small multiple of the content's size, whatever that says. Throws Format_fault.
inline Soup parse_soup(const std::string& content, const std::string& type)
{
  Soup soup;
  if (type == "off")
    read_off(content, soup);
  else if (type == "obj")
    read_obj(content, soup);
  else if (type == "ply")
    read_ply(content, soup);
  else
    read_stl(content, soup);
  return soup;
}

// Reads the soup as it stands in the file. `stop` as in file_bytes().
inline Soup read_soup(const std::string& file, const std::function<void()>& stop = nullptr)
{
  const std::string type = file_type(file);
  if (!is_mesh_file_type(type))
    throw Failure(file, "has no known mesh file type (.off, .obj, .ply, .stl)");
  const std::string content = file_bytes(file, stop);
  Soup soup;
  try {
    soup = parse_soup(content, type);
  } catch (const Format_fault& e) {
    throw Failure(file, "cannot be read as " + upper_case(type) + ": " + e.what() + look_alike(content, type));
  }
  if (soup.polygons.empty())
    throw Failure(file, "has no faces");
  return soup;
}

// Drops the points that no polygon uses and returns how many there were.
inline std::size_t drop_unused_points(Soup& soup)
{
  const std::size_t unused = (std::numeric_limits<std::size_t>::max)();
  std::vector<std::size_t> number(soup.points.size(), unused);
  for (const auto& polygon : soup.polygons)
    for (std::size_t v : polygon)
      number[v] = 0;
  std::size_t kept = 0;
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    if (number[v] != unused) {
      soup.points[kept] = soup.points[v];
      for (Soup_property& property : soup.of_points)
        property.values[kept] = property.values[v];
      number[v] = kept++;
    }
  for (Soup_property& property : soup.of_points)
    property.values.resize(kept);
  const std::size_t dropped = soup.points.size() - kept;
  soup.points.resize(kept);
  for (auto& polygon : soup.polygons)
    for (std::size_t& v : polygon)
      v = number[v];
  return dropped;
}

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_READ_SOUP_H
