// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_TEXT_WRITER_H
#define COARSEN_MESH_TEXT_WRITER_H

#include "io/Mesh.h"

#include <charconv>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// Text with numbers in the shortest form that reads back the same.
class Text_writer
{
  std::string bytes_;

public:
  Text_writer& operator<<(char c)
  {
    bytes_ += c;
    return *this;
  }
  Text_writer& operator<<(std::string_view words)
  {
    bytes_ += words;
    return *this;
  }
  template <class Number>
  Text_writer& number(Number value)
  {
    char digits[32];
    bytes_.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
    return *this;
  }
  Text_writer& coordinates(const Point& p)
  {
    number(p.x()) << ' ';
    number(p.y()) << ' ';
    return number(p.z());
  }
  void comments(const File_notes& notes)
  {
    for (const std::string& comment : notes.comments)
      *this << "# " << comment << '\n';
  }
  std::string bytes() && { return std::move(bytes_); }
};

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_TEXT_WRITER_H
