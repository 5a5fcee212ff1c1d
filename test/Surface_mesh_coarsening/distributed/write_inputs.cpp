// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the inputs of the test of coarsen_mesh_mpi to the working directory.

#include "distributed/mixed_surfaces.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace {

using generated::Soup;

template <class T>
void write(std::ostream& stream, T value)
{
  stream.write(reinterpret_cast<const char*>(&value), sizeof value);
}

// Has a property of vertices before the properties that are read, and one of faces after them, so that their places count.
// `numbers` are the numbers of the vertices, if there are several pieces.
void write_ply(const std::string& file, const Soup& soup, const std::vector<std::uint32_t>& numbers = {})
{
  std::ofstream stream(file, std::ios::binary);
  stream << "ply\nformat binary_little_endian 1.0\nelement vertex " << soup.points.size() << "\nproperty uchar quality\n"
         << "property double x\nproperty double y\nproperty double z\n"
         << (numbers.empty() ? "" : "property uint vertex_number\n") << "element face " << soup.polygons.size()
         << "\nproperty list uchar int vertex_indices\nproperty uchar flags\nend_header\n";
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    write(stream, std::uint8_t(7));
    for (const double x : soup.points[v])
      write(stream, x);
    if (!numbers.empty())
      write(stream, numbers[v]);
  }
  for (const auto& polygon : soup.polygons) {
    write(stream, std::uint8_t(polygon.size()));
    for (const std::size_t v : polygon)
      write(stream, std::int32_t(v));
    write(stream, std::uint8_t(1));
  }
}

// Writes the faces from `begin` to `end` with the vertices that they have, in the order in which they come.
void write_piece(const std::string& file, const Soup& soup, std::size_t begin, std::size_t end)
{
  Soup piece;
  std::map<std::size_t, std::size_t> local;
  std::vector<std::uint32_t> numbers;
  for (std::size_t f = begin; f < end; ++f) {
    piece.polygons.emplace_back();
    for (const std::size_t v : soup.polygons[f]) {
      if (local.emplace(v, numbers.size()).second) {
        numbers.push_back(std::uint32_t(v));
        piece.points.push_back(soup.points[v]);
      }
      piece.polygons.back().push_back(local[v]);
    }
  }
  write_ply(file, piece, numbers);
}

void cut_off(const std::string& file, const std::string& source, double part)
{
  std::ifstream stream(source, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  std::ofstream(file, std::ios::binary) << bytes.substr(0, std::size_t(part * double(bytes.size())));
}

// Writes a piece whose vertices have numbers of the type double.
void write_fractions(const std::string& file)
{
  std::ofstream stream(file, std::ios::binary);
  stream << "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
         << "property double vertex_number\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& p : generated::single_triangle().points) {
    for (const double x : p)
      write(stream, x);
    write(stream, 0.5);
  }
  write(stream, std::uint8_t(3));
  for (const std::int32_t v : {0, 1, 2})
    write(stream, v);
}

void add_bytes(const std::string& file, const std::string& source, const std::string& bytes)
{
  std::ofstream(file, std::ios::binary) << std::ifstream(source, std::ios::binary).rdbuf() << bytes;
}

} // namespace

int main()
{
  const Soup soup = generated::mixed_surfaces();
  write_ply("polygons.ply", soup);
  write_ply("triangles.ply", generated::triangulated(soup));
  const std::size_t faces = soup.polygons.size();
  write_piece("piece_0.ply", soup, 0, faces / 5);
  write_piece("piece_1.ply", soup, faces / 5, faces / 2);
  write_piece("piece_2.ply", soup, faces / 2, faces);
  write_piece("again.ply", soup, faces / 2 - 3, faces);
  write_piece("moved.ply", generated::translated(soup, 1, 0, 0), faces / 2, faces);
  Soup reversed = soup;
  for (auto& polygon : reversed.polygons)
    std::reverse(polygon.begin(), polygon.end());
  write_piece("reversed.ply", reversed, faces / 2, faces);
  cut_off("cut_in_faces.ply", "polygons.ply", 0.9);
  cut_off("cut_in_triangles.ply", "triangles.ply", 0.9);
  cut_off("cut_in_vertices.ply", "polygons.ply", 0.3);
  add_bytes("longer_polygons.ply", "polygons.ply", std::string(4, '\0'));
  add_bytes("longer_triangles.ply", "triangles.ply", std::string(1, '\0'));
  write_fractions("fractions.ply");
  write_ply("large.ply", generated::triangle_sphere(7));
  write_ply("plate.ply", generated::triangulated(generated::thin_plate(40, 0.05)));
}
