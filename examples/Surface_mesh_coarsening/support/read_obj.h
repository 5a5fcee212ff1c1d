// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_READ_OBJ_H
#define COARSENING_SUPPORT_READ_OBJ_H

#include "Mesh.h"
#include "Text_scanner.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

namespace coarsening_support {

// What the format has beside vertices and faces.
inline bool is_other_obj_keyword(std::string_view word)
{
  static constexpr std::string_view keywords[] = {
    "vt",        "vn",        "vp",    "g",     "o",      "s",      "usemtl",   "mtllib",   "l",
    "p",         "deg",       "bmat",  "step",  "cstype", "curv",   "curv2",    "surf",     "parm",
    "trim",      "hole",      "scrv",  "sp",    "end",    "con",    "mg",       "bevel",    "c_interp",
    "d_interp",  "lod",       "usemap", "maplib", "call",  "csh",    "shadow_obj", "trace_obj", "ctech",
    "stech"};
  return std::find(std::begin(keywords), std::end(keywords), word) != std::end(keywords);
}

// The vertex in one of the forms V, V/T, V//N and V/T/N. Vertices count from 1; negative numbers count from the last one
// read, which is -1.
inline std::size_t obj_vertex(const Text_scanner& text, std::string_view word, std::size_t points)
{
  const std::string_view number = word.substr(0, word.find('/'));
  long long value = 0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), value);
  if (number.empty() || read.ec != std::errc() || read.ptr != number.data() + number.size())
    text.fail(Text_scanner::shown(word) + " stands where the number of a vertex was expected");
  if (value < 0)
    value += static_cast<long long>(points) + 1;
  return value < 1 ? no_vertex : static_cast<std::size_t>(value) - 1;
}

inline void read_obj(const std::string& content, Soup& soup)
{
  Text_scanner text(content.data(), content.data() + content.size(), '#', true);
  while (text.find_line()) {
    const std::string_view keyword = text.word();
    if (keyword == "v") {
      const double x = text.number("coordinate x of a vertex"), y = text.number("coordinate y of a vertex"),
                   z = text.number("coordinate z of a vertex");
      soup.points.emplace_back(x, y, z);
    } else if (keyword == "f" || keyword == "fo") {
      soup.polygons.emplace_back();
      for (std::string_view word = text.word(); !word.empty(); word = text.word())
        soup.polygons.back().push_back(obj_vertex(text, word, soup.points.size()));
      soup.polygons.back().shrink_to_fit();
    } else if (!is_other_obj_keyword(keyword))
      text.fail(Text_scanner::shown(keyword) + " is no keyword of OBJ");
    text.skip_line();
  }
}

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_READ_OBJ_H
