// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes a bumpy torus, the mesh of measure_scale, which may be larger than memory:
//   write_torus FILE FACES

#include "support/Ply_stream.h"

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

// A grid of n by n vertices.
void write_torus(const std::string& file, std::uint64_t n)
{
  benchmark_support::Ply_stream stream(file, n * n, 2 * n * n);
  const double step = 2 * CGAL_PI / double(n);
  for (std::uint64_t i = 0; i < n; ++i)
    for (std::uint64_t j = 0; j < n; ++j) {
      const double u = step * double(i), v = step * double(j);
      const double r = 0.4 + 0.04 * std::sin(9 * u) * std::sin(4 * v), x = 1 + r * std::cos(v);
      stream.write_vertex(x * std::cos(u), x * std::sin(u), r * std::sin(v));
    }
  const auto at = [n](std::uint64_t i, std::uint64_t j) { return i % n * n + j % n; };
  for (std::uint64_t i = 0; i < n; ++i)
    for (std::uint64_t j = 0; j < n; ++j) {
      stream.write_triangle({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}});
      stream.write_triangle({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    }
  stream.close();
}

} // namespace

int main(int argc, char* argv[])
{
  try {
    const double n = argc == 3 ? std::round(std::sqrt(std::stod(argv[2]) / 2)) : 0;
    if (!(n >= 3 && n < 1e6))
      throw std::invalid_argument("usage: write_torus FILE FACES");
    write_torus(argv[1], std::uint64_t(n));
    return EXIT_SUCCESS;
  } catch (const std::exception& e) {
    std::cerr << "write_torus: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
