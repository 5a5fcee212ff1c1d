// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_BENCHMARK_MODELS_H
#define COARSENING_BENCHMARK_MODELS_H

#include "io/Mesh.h"
#include "io/read_soup.h"
#include "io/to_mesh.h"
#include "support/generate_meshes.h"

#include <cstddef>
#include <string>
#include <vector>

namespace benchmark_support {

// Reads a mesh without unused vertices from a file of a 2-manifold.
inline coarsening_support::Mesh read_model(const std::string& file)
{
  coarsening_support::Soup soup = coarsening_support::read_soup(file);
  coarsening_support::drop_unused_points(soup);
  return coarsening_support::to_mesh(soup);
}

inline coarsening_support::Mesh generated_mesh(const generated::Soup& made)
{
  coarsening_support::Soup soup;
  soup.points.reserve(made.points.size());
  for (const generated::Point& p : made.points)
    soup.points.push_back(coarsening_support::Point(p[0], p[1], p[2]));
  soup.polygons = coarsening_support::Polygons(made.polygons);
  return coarsening_support::to_mesh(soup);
}

} // namespace benchmark_support

#endif // COARSENING_BENCHMARK_MODELS_H
