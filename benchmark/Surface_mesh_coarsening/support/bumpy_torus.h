// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_BENCHMARK_BUMPY_TORUS_H
#define COARSENING_BENCHMARK_BUMPY_TORUS_H

#include "io/Mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace benchmark_support {

// A bumpy torus of about the given number of triangles, built face by face; 20 million faces take some 4 GB in all.
inline coarsening_support::Mesh bumpy_torus(std::size_t faces)
{
  using coarsening_support::Mesh;
  using coarsening_support::Vertex;
  const std::size_t n = (std::max)(std::size_t(4), std::size_t(std::sqrt(double(faces) / 2) + 0.5));
  const double step = 2 * 3.14159265358979323846 / double(n);
  Mesh mesh;
  mesh.reserve(Mesh::size_type(n * n), Mesh::size_type(3 * n * n), Mesh::size_type(2 * n * n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const double u = step * double(i), v = step * double(j), r = 0.4 + 0.04 * std::sin(9 * u) * std::sin(4 * v);
      const double x = 1 + r * std::cos(v);
      mesh.add_vertex(coarsening_support::Point(x * std::cos(u), x * std::sin(u), r * std::sin(v)));
    }
  const auto at = [n](std::size_t i, std::size_t j) { return Vertex(Mesh::size_type(i % n * n + j % n)); };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

} // namespace benchmark_support

#endif // COARSENING_BENCHMARK_BUMPY_TORUS_H
