// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads a mesh file as a polygon soup. Whatever is wrong with the file comes out as one exception with one line of text.

#ifndef COARSENING_SUPPORT_READ_SOUP_H
#define COARSENING_SUPPORT_READ_SOUP_H

#include "Failure.h"
#include "Mesh.h"
#include "Muted_streams.h"
#include "file_type.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/OFF/File_header_OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <istream>
#include <iterator>
#include <new>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

namespace coarsening_support {

// CGAL's reader allocates what the header of an OFF file announces; a damaged header must not ask for all memory there is.
inline bool announces_too_much(std::istream& is, std::uintmax_t bytes)
{
  CGAL::File_header_OFF header;
  is >> header;
  const bool readable = static_cast<bool>(is);
  is.clear();
  is.seekg(0);
  return readable && (header.size_of_vertices() > bytes / 6 || header.size_of_facets() > bytes / 2);
}

// CGAL's reader takes for granted that the colors and texture coordinates which the keyword of a text OFF file announces
// are there in each line. Without the announcement it skips them, so that a line without them does no harm.
inline std::string without_announced_extras(std::istream& is)
{
  std::string content((std::istreambuf_iterator<char>(is)), std::istreambuf_iterator<char>());
  std::size_t begin = 0;
  while (begin < content.size() && (std::isspace(static_cast<unsigned char>(content[begin])) || content[begin] == '#'))
    begin = content[begin] == '#' ? (std::min)(content.find('\n', begin), content.size()) : begin + 1;
  const std::size_t line_end = (std::min)(content.find_first_of("\r\n", begin), content.size());
  const std::size_t end = (std::min)(content.find_first_of(" \t", begin), line_end);
  std::string keyword = content.substr(begin, end - begin);
  if (keyword.find("OFF") == std::string::npos ||
      content.substr(end, line_end - end).find("BINARY") != std::string::npos)
    return content;
  if (keyword.compare(0, 2, "ST") == 0)
    keyword.erase(0, 2);
  if (keyword.compare(0, 1, "C") == 0)
    keyword.erase(0, 1);
  return content.replace(begin, end - begin, keyword);
}

// CGAL's reader takes for granted that a property belongs to an element.
inline bool has_stray_property(std::istream& is)
{
  std::string word;
  for (std::string line; std::getline(is, line);) {
    word.clear();
    std::istringstream(line) >> word;
    if (word == "element" || word == "property" || word == "end_header")
      break;
  }
  is.clear();
  is.seekg(0);
  return word == "property";
}

inline bool read_by_type(std::istream& is, const std::string& type, Soup& soup)
{
  const auto np = CGAL::parameters::verbose(true);
  if (type == "off")
    return CGAL::IO::read_OFF(is, soup.points, soup.polygons, np);
  if (type == "obj")
    return CGAL::IO::read_OBJ(is, soup.points, soup.polygons, np);
  if (type == "ply")
    return CGAL::IO::read_PLY(is, soup.points, soup.polygons, np);
  return CGAL::IO::read_STL(is, soup.points, soup.polygons, np);
}

inline void check_readable(const std::string& file)
{
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (error)
    throw Failure(file, error.message());
  if (std::filesystem::is_directory(status))
    throw Failure(file, "is a directory");
  if (!std::filesystem::is_regular_file(status))
    throw Failure(file, "is not a regular file");
  errno = 0;
  if (!std::ifstream(file, std::ios::binary))
    throw Failure(file, errno ? std::generic_category().message(errno) : "cannot be opened");
  if (std::filesystem::file_size(file) == 0)
    throw Failure(file, "is empty");
}

// Reads the soup as it stands in the file, without any check of what its numbers mean.
inline Soup read_soup(const std::string& file)
{
  const std::string type = file_type(file);
  if (!is_mesh_file_type(type))
    throw Failure(file, "has no known mesh file type (.off, .obj, .ply, .stl)");
  check_readable(file);

  Soup soup;
  Muted_streams muted; // the readers report on the standard streams
  bool done = false;
  std::string reason;
  try {
    std::ifstream is(file, std::ios::binary);
    if (type == "off") {
      std::istringstream text(without_announced_extras(is), std::ios::in | std::ios::binary);
      if (announces_too_much(text, std::filesystem::file_size(file)))
        reason = "its header announces more than the file can hold";
      else
        done = read_by_type(text, type, soup);
    } else if (type == "ply" && has_stray_property(is))
      reason = "its header has a property before the first element";
    else
      done = read_by_type(is, type, soup);
  } catch (const std::bad_alloc&) {
    reason = "there is not enough memory for what the file announces";
  } catch (const std::exception& e) {
    reason = one_line(e.what());
  }
  if (!done && reason.empty())
    reason = muted.first_complaint();
  if (!done)
    throw Failure(file, "cannot be read as " + upper_case(type) + ": " +
                          (reason.empty() ? "it is damaged or incomplete" : reason));
  if (soup.polygons.empty())
    throw Failure(file, "has no faces");
  return soup;
}

// Drops the points that no polygon uses and returns how many there were.
inline std::size_t drop_unused_points(Soup& soup)
{
  const std::size_t unused = static_cast<std::size_t>(-1);
  std::vector<std::size_t> number(soup.points.size(), unused);
  for (const auto& polygon : soup.polygons)
    for (std::size_t v : polygon)
      number[v] = 0;
  std::size_t kept = 0;
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    if (number[v] != unused) {
      soup.points[kept] = soup.points[v];
      number[v] = kept++;
    }
  const std::size_t dropped = soup.points.size() - kept;
  soup.points.resize(kept);
  for (auto& polygon : soup.polygons)
    for (std::size_t& v : polygon)
      v = number[v];
  return dropped;
}

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_READ_SOUP_H
