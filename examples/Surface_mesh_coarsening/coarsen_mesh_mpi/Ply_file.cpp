// SPDX-License-Identifier: GPL-3.0-or-later

#include "Ply_file.h"

#include <CGAL/Surface_mesh_coarsening/exceptions.h>

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <sstream>
#include <system_error>

namespace coarsen_mesh_mpi {
namespace {

using CGAL::Surface_mesh_coarsening::Invalid_input;

std::size_t size_of(Ply_type type)
{
  static constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8, 8, 8};
  return sizes[static_cast<int>(type)];
}

bool is_whole(Ply_type type) { return type != Ply_type::FLOAT32 && type != Ply_type::FLOAT64; }

bool is_type(const std::string& word, Ply_type& type)
{
  static const char* const names[][2] = {
    {"char", "int8"},   {"uchar", "uint8"},   {"short", "int16"},    {"ushort", "uint16"},  {"int", "int32"},
    {"uint", "uint32"}, {"float", "float32"}, {"double", "float64"}, {"int64", "longlong"}, {"uint64", "ulonglong"}};
  for (int i = 0; i < 10; ++i)
    if (word == names[i][0] || word == names[i][1]) {
      type = static_cast<Ply_type>(i);
      return true;
    }
  return false;
}

template <class T>
T value_of(const char* bytes, bool swaps_bytes)
{
  std::array<char, sizeof(T)> copy;
  std::copy(bytes, bytes + sizeof(T), copy.begin());
  if (swaps_bytes)
    std::reverse(copy.begin(), copy.end());
  T value;
  std::memcpy(&value, copy.data(), sizeof value);
  return value;
}

// Reads a property of a header, after its keyword.
bool read_property(std::istringstream& words, Ply_property& property)
{
  std::string type;
  words >> type;
  property.is_list = type == "list";
  if (property.is_list) {
    words >> type;
    if (!is_type(type, property.count_type) || !is_whole(property.count_type))
      return false;
    words >> type;
  }
  return is_type(type, property.type) && bool(words >> property.name);
}

} // namespace

File_window::File_window(const std::string& name) : name_(name)
{
  errno = 0;
  file_.open(name, std::ios::binary);
  file_.seekg(0, std::ios::end);
  const std::streamoff size = file_ ? std::streamoff(file_.tellg()) : -1;
  if (size < 0)
    throw Invalid_input(name + ": cannot be read" + (errno == 0 ? "" : ": " + std::generic_category().message(errno)));
  size_ = std::uint64_t(size);
}

const char* File_window::bytes(std::uint64_t at, std::size_t n, std::size_t at_least)
{
  if (at > size_ || n > size_ - at)
    return nullptr;
  if (at < first_ || at + n > first_ + window_.size()) {
    window_.resize(std::size_t((std::min)(std::uint64_t((std::max)(n, at_least)), size_ - at)));
    first_ = at;
    file_.seekg(std::streamoff(at));
    file_.read(window_.data(), std::streamsize(window_.size()));
    if (!file_)
      throw Invalid_input(name_ + ": cannot be read from byte " + std::to_string(at) + " on");
  }
  return window_.data() + (at - first_);
}

Ply_file::Ply_file(const std::string& name) : window_(name), vertex_window_(name) { read_header(); }

void Ply_file::fail(const std::string& reason) const { throw Invalid_input(name() + ": " + reason); }

void Ply_file::read_header()
{
  constexpr std::uint64_t max_size = 1 << 16;
  const std::size_t size = std::size_t((std::min)(max_size, window_.size()));
  const std::string start(size == 0 ? "" : window_.bytes(0, size), size);
  const std::size_t end = start.find("end_header");
  const std::size_t end_of_line = end == std::string::npos ? end : start.find('\n', end);
  if (start.compare(0, 3, "ply") != 0 || end_of_line == std::string::npos)
    fail("is not a PLY file");
  struct Element
  {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Ply_property> properties;
  };
  std::vector<Element> elements;
  std::istringstream lines(start.substr(0, end));
  std::string format;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "format")
      words >> format;
    if (keyword == "element") {
      elements.emplace_back();
      std::string count;
      words >> elements.back().name >> count;
      if (count.empty() || count.size() > 18 || count.find_first_not_of("0123456789") != std::string::npos)
        fail("the header says '" + line + "'");
      elements.back().count = std::stoull(count);
    }
    if (keyword == "property") {
      Ply_property property;
      if (elements.empty() || !read_property(words, property))
        fail("the header says '" + line + "'");
      elements.back().properties.push_back(property);
    }
  }
  if (format != "binary_little_endian" && format != "binary_big_endian")
    fail("is not a binary PLY file, which can be read in parts");
  swaps_bytes_ = (format == "binary_little_endian") != (boost::endian::order::native == boost::endian::order::little);
  std::uint64_t position = end_of_line + 1;
  for (const Element& element : elements)
    read_element(element.name, element.count, element.properties, position);
  if (vertex_size_ == 0 || corners_ == none)
    fail("has no vertices with x, y and z, or no faces with a list vertex_indices");
}

// `position` moves on to the next element, as far as it is known.
void Ply_file::read_element(const std::string& name, std::uint64_t count, const std::vector<Ply_property>& properties,
                            std::uint64_t& position)
{
  if (corners_ != none) {
    if (name == "vertex")
      fail("has its vertices after its faces");
    add_last_element(name, count, properties);
    return;
  }
  if (name == "face") {
    faces_ = count;
    face_position_ = position;
    face_properties_ = properties;
    for (std::size_t i = 0; i < properties.size(); ++i)
      if (properties[i].is_list && (properties[i].name == "vertex_indices" || properties[i].name == "vertex_index"))
        corners_ = i;
    if (corners_ != none && !is_whole(properties[corners_].type))
      fail("has numbers of vertices that are not whole");
    return;
  }
  std::uint64_t size = 0;
  for (const Ply_property& p : properties) {
    if (p.is_list && count > 0)
      fail("has lists in the element '" + name + "', before its faces");
    size += size_of(p.type);
  }
  if (name == "vertex")
    place_vertices(count, properties, position);
  if (size > 0 && count > (window_.size() - position) / size)
    fail("is cut off: it ends after " + std::to_string(window_.size()) + " bytes, before its last element '" + name + "'");
  position += count * size;
}

void Ply_file::add_last_element(const std::string& name, std::uint64_t count, const std::vector<Ply_property>& properties)
{
  faces_are_last_ = faces_are_last_ && count == 0;
  for (const Ply_property& p : properties) {
    has_last_lists_ = has_last_lists_ || (p.is_list && count > 0);
    if (count > window_.size())
      fail("is cut off: it ends after " + std::to_string(window_.size()) + " bytes, before its last element '" + name + "'");
    bytes_after_faces_ += p.is_list ? 0 : count * size_of(p.type);
  }
}

void Ply_file::check_end(std::uint64_t end_of_faces) const
{
  const std::uint64_t left = window_.size() - end_of_faces;
  if (left < bytes_after_faces_)
    fail("is cut off: it ends after " + std::to_string(window_.size()) + " bytes, in the elements after its faces");
  if (left > bytes_after_faces_ && !has_last_lists_)
    fail("has " + std::to_string(left - bytes_after_faces_) + " bytes after its last element");
}

void Ply_file::place_vertices(std::uint64_t count, const std::vector<Ply_property>& properties, std::uint64_t position)
{
  std::size_t offset = 0;
  for (const Ply_property& p : properties) {
    for (std::size_t i = 0; i < 3; ++i)
      if (p.name == std::string(1, char('x' + i))) {
        coordinate_[i] = offset;
        coordinate_type_[i] = p.type;
      }
    if (p.name == "vertex_number") {
      if (!is_whole(p.type))
        fail("has a property vertex_number whose type is not whole");
      number_ = offset;
      number_type_ = p.type;
    }
    offset += size_of(p.type);
  }
  if (std::count(std::begin(coordinate_), std::end(coordinate_), none) > 0)
    return;
  vertices_ = count;
  vertex_position_ = position;
  vertex_size_ = offset;
}

double Ply_file::number(const char* bytes, Ply_type type) const
{
  switch (type) {
  case Ply_type::FLOAT32: return double(value_of<float>(bytes, swaps_bytes_));
  case Ply_type::FLOAT64: return value_of<double>(bytes, swaps_bytes_);
  default: return double(std::int64_t(whole_number(bytes, type)));
  }
}

// Negative numbers become large ones.
std::uint64_t Ply_file::whole_number(const char* bytes, Ply_type type) const
{
  switch (type) {
  case Ply_type::INT8: return std::uint64_t(value_of<std::int8_t>(bytes, swaps_bytes_));
  case Ply_type::UINT8: return value_of<std::uint8_t>(bytes, swaps_bytes_);
  case Ply_type::INT16: return std::uint64_t(value_of<std::int16_t>(bytes, swaps_bytes_));
  case Ply_type::UINT16: return value_of<std::uint16_t>(bytes, swaps_bytes_);
  case Ply_type::INT32: return std::uint64_t(value_of<std::int32_t>(bytes, swaps_bytes_));
  case Ply_type::UINT32: return value_of<std::uint32_t>(bytes, swaps_bytes_);
  default: return value_of<std::uint64_t>(bytes, swaps_bytes_);
  }
}

const char* Ply_file::face_bytes(std::uint64_t at, std::size_t n, std::uint64_t face)
{
  const char* const bytes = window_.bytes(at, n);
  if (bytes == nullptr)
    fail("is cut off: it ends after " + std::to_string(window_.size()) + " bytes, in or before face " + std::to_string(face) +
         " of " + std::to_string(faces_));
  return bytes;
}

std::uint64_t Ply_file::size_if_uniform()
{
  if (faces_ == 0 || !faces_are_last_)
    return 0;
  std::vector<std::uint64_t> vertices;
  const std::uint64_t size = read_face(face_position_, 0, vertices) - face_position_;
  const std::uint64_t bytes = window_.size() - face_position_;
  return bytes / size == faces_ && bytes % size == 0 ? size : 0;
}

std::uint64_t Ply_file::read_face(std::uint64_t position, std::uint64_t face, std::vector<std::uint64_t>& vertices)
{
  vertices.clear();
  for (std::size_t i = 0; i < face_properties_.size(); ++i) {
    const Ply_property& p = face_properties_[i];
    if (!p.is_list) {
      face_bytes(position, size_of(p.type), face);
      position += size_of(p.type);
      continue;
    }
    const std::uint64_t count = whole_number(face_bytes(position, size_of(p.count_type), face), p.count_type);
    position += size_of(p.count_type);
    if (count > window_.size())
      face_bytes(window_.size(), 1, face);
    const char* const bytes = face_bytes(position, std::size_t(count) * size_of(p.type), face);
    position += count * size_of(p.type);
    if (i != corners_)
      continue;
    for (std::size_t k = 0; k < count; ++k) {
      vertices.push_back(whole_number(bytes + k * size_of(p.type), p.type));
      if (vertices.back() >= vertices_)
        fail("face " + std::to_string(face) + " has the vertex " + std::to_string(std::int64_t(vertices.back())) +
             ", but there are " + std::to_string(vertices_));
    }
  }
  return position;
}

Ply_file::Vertex Ply_file::read_vertex(std::uint64_t vertex)
{
  constexpr std::size_t bytes_at_a_time = 1 << 16;
  const char* const bytes = vertex_window_.bytes(vertex_position_ + vertex * vertex_size_, vertex_size_, bytes_at_a_time);
  if (bytes == nullptr)
    fail("is cut off: it ends before vertex " + std::to_string(vertex));
  const auto coordinate = [&](std::size_t i) { return number(bytes + coordinate_[i], coordinate_type_[i]); };
  return {coordinate(0), coordinate(1), coordinate(2), number_ == none ? vertex : whole_number(bytes + number_, number_type_)};
}

} // namespace coarsen_mesh_mpi
