// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_off.h"

#include "io/Byte_scanner.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace coarsening_support {
namespace {

// The first line: [ST][C][N][4]OFF [BINARY].
struct Off_header
{
  bool texture = false, color = false, normal = false, homogeneous = false, binary = false;
};

Off_header read_off_header(Text_scanner& text)
{
  Off_header header;
  text.need_line("the keyword OFF");
  std::string_view keyword = text.next_word();
  if (std::isdigit(static_cast<unsigned char>(keyword[0])) && keyword.find("OFF") == std::string_view::npos)
    return header; // the keyword may be missing
  const std::string_view word = text.word();
  keyword = word;
  const auto take = [&keyword](std::string_view prefix) {
    const bool found = keyword.substr(0, prefix.size()) == prefix;
    if (found)
      keyword.remove_prefix(prefix.size());
    return found;
  };
  header.texture = take("ST");
  header.color = take("C");
  header.normal = take("N");
  header.homogeneous = take("4");
  if (keyword == "nOFF")
    text.fail("points of any number of dimensions (nOFF) cannot be read");
  if (keyword != "OFF")
    text.fail(Text_scanner::shown(word) + " stands where the keyword OFF was expected");
  if (text.next_word() == "BINARY") {
    text.word();
    text.end_line("OFF BINARY");
    header.binary = true;
  }
  return header;
}

Point off_point(double x, double y, double z, double w) { return Point(x / w, y / w, z / w); }

// Colors and other data may follow the coordinates and the vertices of a face on the same line.
void read_text_off(Text_scanner& text, const Off_header& header, Soup& soup, const Stop& stop)
{
  text.need_line("the number of vertices");
  const std::size_t points = text.count("vertices", 6); // "0 0 0" and the end of the line
  text.need_line("the number of faces");
  const std::size_t polygons = text.count("faces", 2);
  if (!text.next_word().empty())
    text.integer("the number of edges");
  text.end_line("the numbers of vertices, faces and edges");
  soup.points.reserve(points);
  soup.polygons.reserve(polygons, (std::min)(3 * polygons, text.bytes_left() / 2));
  for (std::size_t v = 0; v < points; ++v) {
    stop_at(v, stop);
    text.need_line([&] { return "vertex " + std::to_string(v) + " of the " + std::to_string(points) + " announced"; });
    const double x = text.number("coordinate x of a vertex"), y = text.number("coordinate y of a vertex"),
                 z = text.number("coordinate z of a vertex");
    soup.points.push_back(off_point(x, y, z, header.homogeneous ? text.number("coordinate w of a vertex") : 1));
    text.skip_line();
  }
  for (std::size_t f = 0; f < polygons; ++f) {
    stop_at(f, stop);
    text.need_line([&] { return "face " + std::to_string(f) + " of the " + std::to_string(polygons) + " announced"; });
    const std::size_t corners = text.count("vertices of the face", 2);
    for (std::size_t i = 0; i < corners; ++i)
      soup.polygons.add_corner(text.vertex_number());
    soup.polygons.end_polygon();
    text.skip_line();
  }
  if (text.find_line())
    text.fail("the file goes on after the " + std::to_string(points) + " vertices and " + std::to_string(polygons) +
              " faces announced");
}

void read_binary_off(Byte_scanner& bytes, const Off_header& header, Soup& soup, const Stop& stop)
{
  const auto points = bytes.read<std::int32_t>("the number of vertices");
  const auto polygons = bytes.read<std::int32_t>("the number of faces");
  bytes.read<std::int32_t>("the number of edges");
  const unsigned extras = 4 * (3 * header.normal + 4 * header.color + 2 * header.texture);
  bytes.check_count(points, "vertices", 12 + 4 * header.homogeneous + extras);
  bytes.check_count(polygons, "faces", 8);
  soup.points.reserve(static_cast<std::size_t>(points));
  soup.polygons.reserve(static_cast<std::size_t>(polygons), bytes.bytes_left() / 4);
  const char *const vertex = "a vertex", *const face = "a face";
  for (std::int32_t v = 0; v < points; ++v) {
    stop_at(static_cast<std::size_t>(v), stop);
    const double x = bytes.read<float>(vertex), y = bytes.read<float>(vertex), z = bytes.read<float>(vertex);
    soup.points.push_back(off_point(x, y, z, header.homogeneous ? bytes.read<float>(vertex) : 1));
    bytes.skip(extras, vertex);
  }
  for (std::int32_t f = 0; f < polygons; ++f) {
    stop_at(static_cast<std::size_t>(f), stop);
    const auto corners = bytes.read<std::int32_t>(face);
    bytes.check_count(corners, "vertices of a face", 4);
    for (std::int32_t i = 0; i < corners; ++i) {
      const auto v = bytes.read<std::int32_t>(face);
      soup.polygons.add_corner(v < 0 ? no_vertex : static_cast<Vertex_number>(v));
    }
    soup.polygons.end_polygon();
    const auto colors = bytes.read<std::int32_t>(face);
    bytes.check_count(colors, "color components of a face", 4);
    bytes.skip(4 * static_cast<std::uint64_t>(colors), face);
  }
  bytes.expect_end("the " + std::to_string(points) + " vertices and " + std::to_string(polygons) + " faces announced");
}

} // namespace

void read_off(const std::string& content, Soup& soup, const Stop& stop)
{
  const char* const begin = content.data();
  const char* const end = begin + content.size();
  Text_scanner text(begin, end, '#');
  const Off_header header = read_off_header(text);
  if (!header.binary) {
    read_text_off(text, header, soup, stop);
    return;
  }
  const char* at = text.position();
  if (at != end && *at == '\r')
    ++at;
  if (at != end && *at == '\n')
    ++at;
  Byte_scanner bytes(begin, at, end, true);
  read_binary_off(bytes, header, soup, stop);
}

} // namespace coarsening_support
