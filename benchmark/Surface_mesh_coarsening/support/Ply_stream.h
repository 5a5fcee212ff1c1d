// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_BENCHMARK_PLY_STREAM_H
#define COARSENING_BENCHMARK_PLY_STREAM_H

#include <array>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>

namespace benchmark_support {

// Writes a triangle mesh as binary PLY, element by element, so the mesh may be larger than memory.
class Ply_stream
{
public:
  Ply_stream(const std::string& file, std::uint64_t vertices, std::uint64_t faces) : file_(file), stream_(file, std::ios::binary)
  {
    if (vertices > 2147483647) // the largest number of 32 bits with a sign
      throw std::runtime_error(file + " would have " + std::to_string(vertices) + " vertices");
    const std::uint16_t one = 1;
    const bool is_little_endian = *reinterpret_cast<const unsigned char*>(&one) == 1;
    stream_ << "ply\nformat binary_" << (is_little_endian ? "little" : "big") << "_endian 1.0\nelement vertex " << vertices
            << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << faces
            << "\nproperty list uchar int vertex_indices\nend_header\n";
  }

  void write_vertex(double x, double y, double z)
  {
    for (const double coordinate : {x, y, z})
      write(float(coordinate));
  }

  void write_triangle(const std::array<std::uint64_t, 3>& vertices)
  {
    write(std::uint8_t(3));
    for (const std::uint64_t v : vertices)
      write(std::int32_t(v));
  }

  void close()
  {
    if (!stream_.flush())
      throw std::runtime_error("cannot write " + file_);
  }

private:
  template <class T>
  void write(T value)
  {
    stream_.write(reinterpret_cast<const char*>(&value), sizeof value);
  }

  std::string file_;
  std::ofstream stream_;
};

} // namespace benchmark_support

#endif // COARSENING_BENCHMARK_PLY_STREAM_H
