// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_off.h"

#include "io/Byte_scanner.h"
#include "io/Row_numbers.h"
#include "io/read_comments.h"

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

// Behind the coordinates there may be a normal, a color and texture coordinates, in this order; behind the corners of a face a
// color.
void add_off_numbers(const Off_header& header, const Row_numbers& of_points, const Row_numbers& of_polygons, Soup& soup)
{
  const std::size_t normal = header.normal ? 3 : 0, texture = header.texture ? 2 : 0, width = of_points.width();
  const std::size_t color = width - (std::min)(width, normal + texture);
  const bool is_known = of_points.is_regular() && width == normal + texture + color &&
                        (header.color ? color == 3 || color == 4 : color == 0);
  if (is_known) {
    if (header.normal)
      of_points.add_numbers(0, {"nx", "ny", "nz"}, soup.of_points);
    of_points.add_colors(normal, color, soup.of_points, soup);
    if (header.texture)
      of_points.add_numbers(normal + color, {"s", "t"}, soup.of_points);
  } else if (!of_points.empty())
    soup.leave_out("the numbers behind the coordinates of vertices");
  if (of_polygons.is_regular() && (of_polygons.width() == 3 || of_polygons.width() == 4))
    of_polygons.add_colors(0, of_polygons.width(), soup.of_polygons, soup);
  else if (!of_polygons.empty())
    soup.leave_out("the numbers behind the corners of faces");
}

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
  Row_numbers of_points, of_polygons;
  for (std::size_t v = 0; v < points; ++v) {
    stop_at(v, stop);
    text.need_line([&] { return "vertex " + std::to_string(v) + " of the " + std::to_string(points) + " announced"; });
    const double x = text.number("coordinate x of a vertex"), y = text.number("coordinate y of a vertex"),
                 z = text.number("coordinate z of a vertex");
    soup.points.push_back(off_point(x, y, z, header.homogeneous ? text.number("coordinate w of a vertex") : 1));
    of_points.read_row(text);
  }
  for (std::size_t f = 0; f < polygons; ++f) {
    stop_at(f, stop);
    text.need_line([&] { return "face " + std::to_string(f) + " of the " + std::to_string(polygons) + " announced"; });
    const std::size_t corners = text.count("vertices of the face", 2);
    for (std::size_t i = 0; i < corners; ++i)
      soup.polygons.add_corner(text.vertex_number());
    soup.polygons.end_polygon();
    of_polygons.read_row(text);
  }
  if (text.find_line())
    text.fail("the file goes on after the " + std::to_string(points) + " vertices and " + std::to_string(polygons) +
              " faces announced");
  add_off_numbers(header, of_points, of_polygons, soup);
}

void read_binary_off(Byte_scanner& bytes, const Off_header& header, Soup& soup, const Stop& stop)
{
  const auto points = bytes.read<std::int32_t>("the number of vertices");
  const auto polygons = bytes.read<std::int32_t>("the number of faces");
  bytes.read<std::int32_t>("the number of edges");
  const unsigned extras = 3 * header.normal + 4 * header.color + 2 * header.texture;
  bytes.check_count(points, "vertices", 12 + 4 * header.homogeneous + 4 * extras);
  bytes.check_count(polygons, "faces", 8);
  soup.points.reserve(static_cast<std::size_t>(points));
  soup.polygons.reserve(static_cast<std::size_t>(polygons), bytes.bytes_left() / 4);
  const char *const vertex = "a vertex", *const face = "a face";
  Row_numbers of_points, of_polygons;
  double numbers[9];
  for (std::int32_t v = 0; v < points; ++v) {
    stop_at(static_cast<std::size_t>(v), stop);
    const double x = bytes.read<float>(vertex), y = bytes.read<float>(vertex), z = bytes.read<float>(vertex);
    soup.points.push_back(off_point(x, y, z, header.homogeneous ? bytes.read<float>(vertex) : 1));
    for (unsigned i = 0; i < extras; ++i)
      numbers[i] = bytes.read<float>(vertex);
    of_points.add_row(numbers, numbers + extras);
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
    for (std::int32_t i = 0; i < colors; ++i) {
      const double number = bytes.read<float>(face);
      if (i < 4)
        numbers[i] = number;
    }
    of_polygons.add_row(numbers, numbers + (std::min)(colors, 4));
  }
  bytes.expect_end("the " + std::to_string(points) + " vertices and " + std::to_string(polygons) + " faces announced");
  add_off_numbers(header, of_points, of_polygons, soup);
}

} // namespace

void read_off(const std::string& content, Soup& soup, const Stop& stop)
{
  Text_scanner text(content.data(), content.data() + content.size(), '#');
  const Off_header header = read_off_header(text);
  if (!header.binary) {
    read_comments(content, "0123456789", soup);
    read_text_off(text, header, soup, stop);
    return;
  }
  Byte_scanner bytes = bytes_behind_line(text, content, true);
  read_binary_off(bytes, header, soup, stop);
}

} // namespace coarsening_support
