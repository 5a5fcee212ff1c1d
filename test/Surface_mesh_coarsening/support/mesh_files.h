// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_TEST_MESH_FILES_H
#define CGAL_SURFACE_MESH_COARSENING_TEST_MESH_FILES_H

#include "generate_meshes.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// The content of mesh files, written according to the descriptions of the formats.
namespace mesh_files {

using generated::Soup;

template <class Number>
void put_bytes(std::string& to, Number number, bool big_endian)
{
  char bytes[sizeof number];
  std::memcpy(bytes, &number, sizeof number);
  if (big_endian)
    std::reverse(bytes, bytes + sizeof number);
  to.append(bytes, sizeof number);
}

inline std::string off(const Soup& soup)
{
  std::ostringstream os;
  os.precision(17);
  os << "OFF\n" << soup.points.size() << ' ' << soup.polygons.size() << " 0\n";
  for (const auto& p : soup.points)
    os << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const auto& polygon : soup.polygons) {
    os << polygon.size();
    for (std::size_t v : polygon)
      os << ' ' << v;
    os << '\n';
  }
  return os.str();
}

inline std::string binary_off(const Soup& soup)
{
  std::string s = "OFF BINARY\n";
  const auto put = [&s](std::size_t n) { put_bytes(s, std::int32_t(n), true); };
  put(soup.points.size());
  put(soup.polygons.size());
  put(0);
  for (const auto& p : soup.points)
    for (double x : p)
      put_bytes(s, float(x), true);
  for (const auto& polygon : soup.polygons) {
    put(polygon.size());
    for (std::size_t v : polygon)
      put(v);
    put(0); // colors
  }
  return s;
}

inline std::string obj(const Soup& soup)
{
  std::ostringstream os;
  os.precision(17);
  for (const auto& p : soup.points)
    os << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const auto& polygon : soup.polygons) {
    os << 'f';
    for (std::size_t v : polygon)
      os << ' ' << v + 1;
    os << '\n';
  }
  return os.str();
}

inline std::string ply_header(const Soup& soup, const std::string& format)
{
  return "ply\nformat " + format + " 1.0\ncomment a mesh\nelement vertex " + std::to_string(soup.points.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\nelement face " +
         std::to_string(soup.polygons.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string text_ply(const Soup& soup)
{
  std::ostringstream os;
  os.precision(17);
  os << ply_header(soup, "ascii");
  for (const auto& p : soup.points)
    os << p[0] << ' ' << p[1] << ' ' << p[2] << " 255\n";
  for (const auto& polygon : soup.polygons) {
    os << polygon.size();
    for (std::size_t v : polygon)
      os << ' ' << v;
    os << '\n';
  }
  return os.str();
}

inline std::string binary_ply(const Soup& soup, bool big_endian)
{
  std::string s = ply_header(soup, big_endian ? "binary_big_endian" : "binary_little_endian");
  for (const auto& p : soup.points) {
    for (double x : p)
      put_bytes(s, x, big_endian);
    put_bytes(s, std::uint8_t(255), big_endian);
  }
  for (const auto& polygon : soup.polygons) {
    put_bytes(s, std::uint8_t(polygon.size()), big_endian);
    for (std::size_t v : polygon)
      put_bytes(s, std::int32_t(v), big_endian);
  }
  return s;
}

inline std::string text_stl(const Soup& soup)
{
  std::ostringstream os;
  os.precision(17);
  os << "solid\n";
  for (const auto& polygon : soup.polygons) {
    os << "facet normal 0 0 0\nouter loop\n";
    for (std::size_t v : polygon)
      os << "vertex " << soup.points[v][0] << ' ' << soup.points[v][1] << ' ' << soup.points[v][2] << '\n';
    os << "endloop\nendfacet\n";
  }
  os << "endsolid\n";
  return os.str();
}

inline std::string binary_stl(const Soup& soup)
{
  std::string s(80, ' ');
  put_bytes(s, std::uint32_t(soup.polygons.size()), false);
  for (const auto& polygon : soup.polygons) {
    s.append(12, '\0');
    for (std::size_t v : polygon)
      for (double x : soup.points[v])
        put_bytes(s, float(x), false);
    s.append(2, '\0');
  }
  return s;
}

// Each form of each type: the type and the content.
inline std::vector<std::pair<std::string, std::string> > all_forms(const Soup& soup)
{
  return {{"off", off(soup)},         {"off", binary_off(soup)},        {"obj", obj(soup)},
          {"ply", text_ply(soup)},    {"ply", binary_ply(soup, false)}, {"ply", binary_ply(soup, true)},
          {"stl", text_stl(soup)},    {"stl", binary_stl(soup)}};
}

} // namespace mesh_files

#endif // CGAL_SURFACE_MESH_COARSENING_TEST_MESH_FILES_H
