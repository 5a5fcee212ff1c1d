// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_QUALITY_H
#define COARSEN_MESH_QUALITY_H

#include "io/Mesh.h"

#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>

#include <cstddef>
#include <optional>
#include <string>

namespace coarsen_mesh_tool {

using namespace coarsening_support;
using CGAL::Surface_mesh_coarsening::Coarsening_quality;

struct Measured_quality : Coarsening_quality
{
  std::size_t self_intersections_of_input = 0; // counted if the result has any
  // The pairs that the repair left, where the input has none; nothing without repair.
  std::optional<std::size_t> self_intersections_left;
};

// Measures how well a coarse mesh stands for a mesh.
Measured_quality measure(const Mesh& mesh, const Mesh& coarse);

// A length of the measurement in % of the diagonal of the input's bounding box.
double percent(const Coarsening_quality& quality, double length);

// Lines for the user.
std::string quality_text(const Mesh& result, const Measured_quality& quality);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_QUALITY_H
