// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_stl.h"

#include "io/Byte_scanner.h"
#include "io/file_type.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <string_view>
#include <vector>

namespace coarsening_support {
namespace {

// The format has triangles without shared vertices: equal points become one vertex, numbered by first occurrence. Points
// with a NaN coordinate are equal to none.
void merge_stl_corners(const std::vector<std::array<double, 3> >& corners, Soup& soup)
{
  const auto is_number = [&](std::size_t i) {
    return std::none_of(corners[i].begin(), corners[i].end(), [](double x) { return std::isnan(x); });
  };
  std::vector<std::size_t> order(corners.size()), first(corners.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::iota(first.begin(), first.end(), std::size_t(0));
  order.erase(std::remove_if(order.begin(), order.end(), [&](std::size_t i) { return !is_number(i); }), order.end());
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return corners[i] == corners[j] ? i < j : corners[i] < corners[j];
  });
  for (std::size_t k = 1; k < order.size(); ++k)
    if (corners[order[k]] == corners[order[k - 1]])
      first[order[k]] = first[order[k - 1]];
  std::vector<Vertex_number> number(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (first[i] == i) {
      number[i] = to_vertex_number(soup.points.size());
      soup.points.emplace_back(corners[i][0], corners[i][1], corners[i][2]);
    } else
      number[i] = number[first[i]];
    soup.polygons.add_corner(number[i]);
    if (i % 3 == 2)
      soup.polygons.end_polygon();
  }
}

void read_binary_stl(const std::string& content, std::vector<std::array<double, 3> >& corners, Soup& soup, const Stop& stop)
{
  const char* const begin = content.data();
  Byte_scanner bytes(begin, begin, begin + content.size(), false);
  bytes.skip(80, "the header");
  const auto triangles = bytes.read<std::uint32_t>("the number of triangles");
  bytes.check_count(triangles, "triangles", 50);
  corners.reserve(3 * static_cast<std::size_t>(triangles));
  const char* const triangle = "a triangle";
  for (std::uint32_t f = 0; f < triangles; ++f) {
    stop_at(f, stop);
    bytes.skip(12, triangle); // the normal
    for (int i = 0; i < 3; ++i) {
      const double x = bytes.read<float>(triangle), y = bytes.read<float>(triangle), z = bytes.read<float>(triangle);
      corners.push_back({x, y, z});
    }
    // CGAL and others write two blanks.
    constexpr std::uint16_t blanks = 0x2020;
    const auto attribute = bytes.read<std::uint16_t>(triangle);
    if (attribute != 0 && attribute != blanks)
      soup.leave_out("the attributes of triangles (often colors)");
  }
  bytes.expect_end("the " + std::to_string(triangles) + " triangles announced");
}

// Reads the expected words, in upper or lower case, across line ends.
void expect_stl_words(Text_scanner& text, std::initializer_list<std::string_view> words)
{
  for (const std::string_view word : words) {
    text.need_line([&] { return "'" + std::string(word) + "'"; });
    const std::string_view found = text.word();
    if (found != word && lower_case(std::string(found)) != word)
      text.fail(Text_scanner::shown(found) + " stands where '" + std::string(word) + "' was expected");
  }
}

// The words up to the end of the line, without words that would be no name in OBJ.
std::string solid_name(Text_scanner& text)
{
  std::string name;
  for (std::string_view word = text.word(); !word.empty(); word = text.word())
    (name += name.empty() ? "" : " ") += word;
  std::replace_if(name.begin(), name.end(), [](char c) { return c == '#' || c == '\\'; }, '_');
  return name;
}

std::array<double, 3> stl_vector(Text_scanner& text, const char* what)
{
  std::array<double, 3> result;
  for (double& x : result) {
    text.need_line(what);
    x = text.number(what);
  }
  return result;
}

// The solids are groups, unless none has a name.
void read_text_stl(const std::string& content, std::vector<std::array<double, 3> >& corners, Soup& soup, const Stop& stop)
{
  Text_scanner text(content.data(), content.data() + content.size());
  do {
    expect_stl_words(text, {"solid"});
    const std::string name = solid_name(text);
    text.skip_line();
    for (std::size_t f = 0;; ++f) {
      stop_at(f, stop);
      text.need_line("'endsolid'");
      const std::string_view word = text.word();
      const std::string keyword = lower_case(std::string(word));
      if (keyword == "endsolid")
        break;
      if (keyword != "facet")
        text.fail(Text_scanner::shown(word) + " stands where 'facet' or 'endsolid' was expected");
      expect_stl_words(text, {"normal"});
      for (int i = 0; i < 3; ++i) {
        text.need_line("a coordinate of a normal");
        text.word(); // often no number at all
      }
      expect_stl_words(text, {"outer", "loop"});
      for (int i = 0; i < 3; ++i) {
        expect_stl_words(text, {"vertex"});
        corners.push_back(stl_vector(text, "a coordinate of a vertex"));
      }
      expect_stl_words(text, {"endloop", "endfacet"});
    }
    text.skip_line();
    if (!soup.groups.empty() || !name.empty())
      soup.groups.resize(corners.size() / 3, name);
  } while (text.find_line());
}

// Both forms may begin with the word "solid". If the size fits the binary form, the file is binary.
bool is_binary_stl(const std::string& content)
{
  constexpr std::size_t header = 84;
  Text_scanner text(content.data(), content.data() + content.size());
  if (!text.find_line() || lower_case(std::string(text.next_word().substr(0, 5))) != "solid")
    return true;
  if (content.size() < header)
    return false;
  Byte_scanner bytes(content.data(), content.data() + 80, content.data() + content.size(), false);
  return header + 50 * std::uint64_t(bytes.read<std::uint32_t>("the number of triangles")) == content.size();
}

} // namespace

void read_stl(const std::string& content, Soup& soup, const Stop& stop)
{
  std::vector<std::array<double, 3> > corners;
  if (is_binary_stl(content))
    read_binary_stl(content, corners, soup, stop);
  else
    read_text_stl(content, corners, soup, stop);
  merge_stl_corners(corners, soup);
}

} // namespace coarsening_support
