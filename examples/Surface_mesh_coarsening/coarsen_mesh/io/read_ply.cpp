// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_ply.h"

#include "io/Byte_scanner.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace coarsening_support {
namespace {

typedef Number_type Ply_type;

unsigned size_of(Ply_type type)
{
  static constexpr unsigned sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<int>(type)];
}

bool is_integer(Ply_type type) { return type < Ply_type::FLOAT32; }

// What the values of a property are for.
enum class Ply_use { NONE, X, Y, Z, CORNERS, STRIP, TEXTURE, KEPT };

struct Ply_property
{
  bool is_list = false;
  Ply_type count_type = Ply_type::UINT8, type = Ply_type::FLOAT32;
  Ply_use use = Ply_use::NONE;
  std::size_t kept = 0; // number of kept values
};

struct Ply_element
{
  std::string name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;

  // The minimal size of an element.
  std::uint64_t min_bytes(bool binary) const
  {
    std::uint64_t bytes = 0;
    for (const Ply_property& p : properties)
      bytes += !binary ? 2 : p.is_list ? size_of(p.count_type) : size_of(p.type);
    return bytes;
  }
};

struct Ply_header
{
  bool binary = false, big_endian = false;
  std::vector<Ply_element> elements;
};

Ply_type ply_type(Text_scanner& text)
{
  static constexpr std::string_view names[][2] = {{"char", "int8"},     {"uchar", "uint8"}, {"short", "int16"},
                                                  {"ushort", "uint16"}, {"int", "int32"},   {"uint", "uint32"},
                                                  {"float", "float32"}, {"double", "float64"}};
  const std::string_view word = text.word();
  for (int i = 0; i < 8; ++i)
    if (word == names[i][0] || word == names[i][1])
      return static_cast<Ply_type>(i);
  text.fail(Text_scanner::shown(word) + " stands where a type of number was expected");
}

Ply_use ply_use(const Ply_element& element, const Ply_property& property, std::string_view name)
{
  if (element.name == "vertex" && !property.is_list && name.size() == 1 && name[0] >= 'x' && name[0] <= 'z')
    return static_cast<Ply_use>(static_cast<int>(Ply_use::X) + (name[0] - 'x'));
  if (element.name == "face" && property.is_list && (name == "vertex_indices" || name == "vertex_index"))
    return Ply_use::CORNERS;
  if (element.name == "tristrips" && property.is_list && (name == "vertex_indices" || name == "vertex_index"))
    return Ply_use::STRIP;
  if (element.name == "face" && property.is_list && name == "texcoord")
    return Ply_use::TEXTURE;
  const bool is_known = element.name == "vertex" || element.name == "face";
  return is_known && !property.is_list ? Ply_use::KEPT : Ply_use::NONE;
}

// Adds storage for the values of a property that is kept. Of several with the same name, the first is kept.
void keep_ply_property(Ply_element& element, Ply_property& property, std::string_view name, Soup& soup)
{
  std::vector<Soup_property>& kept = element.name == "vertex" ? soup.of_points : soup.of_polygons;
  for (const Soup_property& earlier : kept)
    if (earlier.name == name) {
      property.use = Ply_use::NONE;
      return;
    }
  property.kept = kept.size();
  kept.push_back({std::string(name), property.type, {}});
}

void read_ply_property(Text_scanner& text, Ply_header& header, Soup& soup)
{
  if (header.elements.empty())
    text.fail("there is a property before the first element");
  Ply_property property;
  property.is_list = text.next_word() == "list";
  if (property.is_list) {
    text.word();
    property.count_type = ply_type(text);
    if (!is_integer(property.count_type))
      text.fail("a list is counted by numbers that are not whole");
  }
  property.type = ply_type(text);
  const std::string_view name = text.word();
  if (name.empty())
    text.fail("a property has no name");
  property.use = ply_use(header.elements.back(), property, name);
  if ((property.use == Ply_use::CORNERS || property.use == Ply_use::STRIP) && !is_integer(property.type))
    text.fail("the numbers of vertices are of a type that is not whole");
  if (property.use == Ply_use::NONE && (header.elements.back().name == "vertex" || header.elements.back().name == "face"))
    soup.leave_out("the lists '" + escaped(name) + "' of " + (header.elements.back().name == "face" ? "faces" : "vertices"));
  for (const Ply_property& earlier : header.elements.back().properties)
    if (property.use != Ply_use::NONE && property.use != Ply_use::KEPT && property.use == earlier.use)
      text.fail("the property " + Text_scanner::shown(name) + " comes twice");
  if (property.use == Ply_use::KEPT)
    keep_ply_property(header.elements.back(), property, name, soup);
  header.elements.back().properties.push_back(property);
}

void read_ply_format(Text_scanner& text, Ply_header& header)
{
  const std::string_view format = text.word();
  header.big_endian = format == "binary_big_endian";
  header.binary = header.big_endian || format == "binary_little_endian";
  if (!header.binary && format != "ascii")
    text.fail(Text_scanner::shown(format) + " stands where ascii, binary_little_endian or binary_big_endian was expected");
  if (text.word() != "1.0")
    text.fail("the version of the format is not 1.0");
}

void read_ply_element(Text_scanner& text, Ply_header& header)
{
  const std::string_view name = text.word();
  if (name.empty())
    text.fail("an element has no name");
  const long long count = text.integer("the number of elements");
  if (count < 0)
    text.fail("the number of elements is " + std::to_string(count));
  for (const Ply_element& earlier : header.elements)
    if (earlier.name == name)
      text.fail("the element " + Text_scanner::shown(name) + " comes twice");
  header.elements.push_back({std::string(name), static_cast<std::size_t>(count), {}});
}

void check_ply_header(const Ply_header& header, const Text_scanner& text)
{
  const auto uses_of = [&](std::string_view element) {
    std::size_t number = 0;
    for (const Ply_element& e : header.elements)
      for (const Ply_property& p : e.properties)
        number += e.name == element && p.use >= Ply_use::X && p.use <= Ply_use::STRIP;
    return number;
  };
  if (uses_of("vertex") != 3)
    text.fail("the header has no element 'vertex' with the properties x, y and z");
  if (uses_of("face") + uses_of("tristrips") != 1)
    text.fail("the header has no element 'face' or 'tristrips' with a list vertex_indices, or both");
  for (const Ply_element& e : header.elements)
    text.check_count(static_cast<long long>(e.count), "elements " + Text_scanner::shown(e.name),
                     e.min_bytes(header.binary), text.bytes_left());
}

Ply_header read_ply_header(Text_scanner& text, Soup& soup)
{
  Ply_header header;
  if (!text.find_line() || text.word() != "ply")
    text.fail("the keyword ply is missing");
  text.end_line("the keyword ply");
  bool has_format = false;
  for (;;) {
    text.need_line("'end_header'");
    const std::string_view keyword = text.word();
    if (keyword == "comment" || keyword == "obj_info") {
      soup.notes.comments.emplace_back(text.rest_of_line());
      continue;
    }
    if (keyword == "end_header")
      break;
    if (keyword == "format") {
      read_ply_format(text, header);
      has_format = true;
    } else if (keyword == "element")
      read_ply_element(text, header);
    else if (keyword == "property")
      read_ply_property(text, header, soup);
    else
      text.fail(Text_scanner::shown(keyword) + " is no keyword of a header of PLY");
    text.end_line("the header of PLY needs");
  }
  if (!has_format)
    text.fail("the header does not say what the format is");
  check_ply_header(header, text);
  for (const Ply_element& element : header.elements)
    if (element.name != "vertex" && element.name != "face" && element.name != "tristrips" && element.count > 0)
      soup.leave_out("the elements '" + escaped(element.name) + "'");
  return header;
}

// The two sources of numbers have the same interface, for the functions below.
class Ply_text
{
  Text_scanner& text;

public:
  explicit Ply_text(Text_scanner& text) : text(text) {}

  template <class Words>
  void begin(const Words& what)
  {
    text.need_line(what);
  }
  template <class Words>
  void end(const Words& what)
  {
    text.end_line([&] { return "the properties of " + words_of(what); });
  }
  template <class Words>
  double number(Ply_type, const Words& what)
  {
    return text.number([&] { return "a number of " + words_of(what); });
  }
  template <class Words>
  long long integer(Ply_type, const Words& what)
  {
    return text.integer([&] { return "a whole number of " + words_of(what); });
  }
  void check_list(long long count, Ply_type) { text.check_count(count, "entries of a list", 2, text.bytes_left()); }
  template <class Words>
  void skip_list(long long count, Ply_type, const Words& what)
  {
    for (long long i = 0; i < count; ++i)
      if (text.word().empty())
        text.fail("a number of " + words_of(what) + " is missing");
  }
  template <class Words>
  void skip(Ply_type type, const Words& what)
  {
    skip_list(1, type, what);
  }
  void expect_end()
  {
    if (text.find_line())
      text.fail("the file goes on after all elements announced");
  }
};

class Ply_bytes
{
  Byte_scanner& bytes;

public:
  explicit Ply_bytes(Byte_scanner& bytes) : bytes(bytes) {}

  template <class Words>
  void begin(const Words&)
  {}
  template <class Words>
  void end(const Words&)
  {}
  template <class Words>
  double number(Ply_type type, const Words& what)
  {
    return type == Ply_type::FLOAT32   ? static_cast<double>(bytes.read<float>(what))
           : type == Ply_type::FLOAT64 ? bytes.read<double>(what)
                                       : static_cast<double>(integer(type, what));
  }
  template <class Words>
  long long integer(Ply_type type, const Words& what)
  {
    switch (type) {
    case Ply_type::INT8: return bytes.read<std::int8_t>(what);
    case Ply_type::UINT8: return bytes.read<std::uint8_t>(what);
    case Ply_type::INT16: return bytes.read<std::int16_t>(what);
    case Ply_type::UINT16: return bytes.read<std::uint16_t>(what);
    case Ply_type::INT32: return bytes.read<std::int32_t>(what);
    default: return bytes.read<std::uint32_t>(what);
    }
  }
  void check_list(long long count, Ply_type type) { bytes.check_count(count, "entries of a list", size_of(type)); }
  template <class Words>
  void skip_list(long long count, Ply_type type, const Words& what)
  {
    bytes.skip(static_cast<std::uint64_t>(count) * size_of(type), what);
  }
  template <class Words>
  void skip(Ply_type type, const Words& what)
  {
    bytes.skip(size_of(type), what);
  }
  void expect_end() { bytes.expect_end("all elements announced"); }
};

// A strip: each vertex makes a triangle with the two before it, turned around every other time; a negative number begins
// another strip. Repeated vertices change the direction: triangles that have one twice are left out.
template <class Source, class Words>
void read_ply_strip(Source& source, long long count, const Ply_property& property, const Words& what, Soup& soup)
{
  Vertex_number before[2] = {0, 0};
  for (long long i = 0, length = 0; i < count; ++i) {
    const long long v = source.integer(property.type, what);
    if (v < 0) {
      length = 0;
      continue;
    }
    const Vertex_number corner = to_vertex_number(static_cast<std::size_t>(v));
    if (length >= 2 && before[0] != before[1] && corner != before[0] && corner != before[1]) {
      soup.polygons.add_corner(before[length % 2 == 0 ? 0 : 1]);
      soup.polygons.add_corner(before[length % 2 == 0 ? 1 : 0]);
      soup.polygons.add_corner(corner);
      soup.polygons.end_polygon();
    }
    before[0] = before[1];
    before[1] = corner;
    ++length;
  }
}

// `texture` receives texture coordinates, which may come before the corners that they are for.
template <class Source, class Words>
void read_ply_list(Source& source, const Ply_property& property, const Words& what, Soup& soup, std::vector<double>& texture)
{
  const long long count = source.integer(property.count_type, what);
  source.check_list(count, property.type);
  if (property.use == Ply_use::STRIP) {
    read_ply_strip(source, count, property, what, soup);
    return;
  }
  if (property.use == Ply_use::TEXTURE) {
    for (long long i = 0; i < count; ++i)
      texture.push_back(source.number(property.type, what));
    return;
  }
  if (property.use != Ply_use::CORNERS) {
    source.skip_list(count, property.type, what);
    return;
  }
  for (long long i = 0; i < count; ++i) {
    const long long v = source.integer(property.type, what);
    soup.polygons.add_corner(v < 0 ? no_vertex : to_vertex_number(static_cast<std::size_t>(v)));
  }
  soup.polygons.end_polygon();
}

// Gives the last polygon its texture coordinates, if there are two for each corner.
void add_ply_texture(const std::vector<double>& texture, Soup& soup)
{
  const std::size_t f = soup.polygons.size() - 1;
  if (texture.size() == 2 * soup.polygons[f].size())
    for (std::size_t i = 0; i < texture.size(); i += 2) {
      const double u = texture[i], v = texture[i + 1];
      soup.texture_corners.add_corner(to_vertex_number(soup.texture_points.size()));
      soup.texture_points.push_back({{std::isfinite(u) ? u : 0, std::isfinite(v) ? v : 0}});
    }
  soup.texture_corners.end_polygon();
}

template <class Source>
void read_ply_elements(Source source, const Ply_header& header, std::size_t bytes_left, Soup& soup, const Stop& stop)
{
  for (const Ply_element& element : header.elements) {
    const bool is_vertex = element.name == "vertex";
    std::vector<Soup_property>& kept = is_vertex ? soup.of_points : soup.of_polygons;
    if (is_vertex)
      soup.points.reserve(element.count);
    if (element.name == "face")
      soup.polygons.reserve(element.count, (std::min)(3 * element.count, bytes_left));
    const bool has_texture = std::any_of(element.properties.begin(), element.properties.end(),
                                         [](const Ply_property& p) { return p.use == Ply_use::TEXTURE; });
    std::vector<double> texture;
    for (std::size_t i = 0; i < element.count; ++i) {
      stop_at(i, stop);
      const auto what = [&] { return element.name + " " + std::to_string(i); };
      double coordinates[3] = {0, 0, 0};
      source.begin(what);
      for (const Ply_property& property : element.properties)
        if (property.is_list)
          read_ply_list(source, property, what, soup, texture);
        else if (property.use == Ply_use::KEPT)
          kept[property.kept].values.push_back(source.number(property.type, what));
        else if (property.use != Ply_use::NONE)
          coordinates[static_cast<int>(property.use) - static_cast<int>(Ply_use::X)] =
            source.number(property.type, what);
        else
          source.skip(property.type, what);
      source.end(what);
      if (has_texture)
        add_ply_texture(texture, soup);
      texture.clear();
      if (is_vertex)
        soup.points.emplace_back(coordinates[0], coordinates[1], coordinates[2]);
    }
  }
  source.expect_end();
}

} // namespace

void read_ply(const std::string& content, Soup& soup, const Stop& stop)
{
  Text_scanner text(content.data(), content.data() + content.size());
  const Ply_header header = read_ply_header(text, soup);
  if (!header.binary) {
    text.end_line("'end_header'");
    read_ply_elements(Ply_text(text), header, text.bytes_left(), soup, stop);
    return;
  }
  Byte_scanner bytes = bytes_behind_line(text, content, header.big_endian);
  read_ply_elements(Ply_bytes(bytes), header, bytes.bytes_left(), soup, stop);
}

} // namespace coarsening_support
