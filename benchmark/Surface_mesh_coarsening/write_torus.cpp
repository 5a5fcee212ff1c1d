// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes a bumpy torus as binary PLY, face by face, so the mesh may be larger than memory:
//   write_torus FILE FACES

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <initializer_list>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

template <class T>
void write(std::ostream& stream, T value)
{
  stream.write(reinterpret_cast<const char*>(&value), sizeof value);
}

bool is_little_endian()
{
  const std::uint16_t one = 1;
  return *reinterpret_cast<const unsigned char*>(&one) == 1;
}

void write_vertex(std::ostream& stream, double u, double v)
{
  const double r = 0.4 + 0.04 * std::sin(9 * u) * std::sin(4 * v), x = 1 + r * std::cos(v);
  for (const double coordinate : {x * std::cos(u), x * std::sin(u), r * std::sin(v)})
    write(stream, float(coordinate));
}

void write_triangle(std::ostream& stream, std::initializer_list<std::uint64_t> vertices)
{
  write(stream, std::uint8_t(3));
  for (const std::uint64_t v : vertices)
    write(stream, std::int32_t(v));
}

// A grid of n by n vertices.
void write_torus(const std::string& file, std::uint64_t n)
{
  std::vector<char> buffer(1 << 20);
  std::ofstream stream;
  stream.rdbuf()->pubsetbuf(buffer.data(), std::streamsize(buffer.size()));
  stream.open(file, std::ios::binary);
  stream << "ply\nformat binary_" << (is_little_endian() ? "little" : "big") << "_endian 1.0\nelement vertex " << n * n
         << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << 2 * n * n
         << "\nproperty list uchar int vertex_indices\nend_header\n";
  const double step = 2 * std::acos(-1) / double(n);
  for (std::uint64_t i = 0; i < n; ++i)
    for (std::uint64_t j = 0; j < n; ++j)
      write_vertex(stream, step * double(i), step * double(j));
  const auto at = [n](std::uint64_t i, std::uint64_t j) { return i % n * n + j % n; };
  for (std::uint64_t i = 0; i < n; ++i)
    for (std::uint64_t j = 0; j < n; ++j) {
      write_triangle(stream, {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      write_triangle(stream, {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  if (!stream.flush())
    throw std::runtime_error("cannot write " + file);
}

} // namespace

int main(int argc, char* argv[])
{
  try {
    const double n = argc == 3 ? std::round(std::sqrt(std::stod(argv[2]) / 2)) : 0;
    if (!(n >= 3 && n <= 40000)) // vertex numbers have 32 bits
      throw std::invalid_argument("usage: write_torus FILE FACES, with 18 to 3200000000 faces");
    write_torus(argv[1], std::uint64_t(n));
    return EXIT_SUCCESS;
  } catch (const std::exception& e) {
    std::cerr << "write_torus: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
