// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SURFACE_MESH_COARSENING_PYTHON_COARSENING_H
#define SURFACE_MESH_COARSENING_PYTHON_COARSENING_H

#include "Python_visitor.h"

#include "io/Mesh.h"

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coarsening_python {

using namespace coarsening_support;

struct Options
{
  std::vector<std::size_t> vertices; // of the levels, from fine to coarse; none if a distance is given
  std::optional<double> maximum_distance;
  std::string weight, placement;
  double maximum_density = 10;
  const double* density = nullptr;       // of each face, if given
  const std::int64_t* patches = nullptr; // likewise
  double feature_angle = 180;
  std::size_t error_feedback = 0;
  double minimum_component_area = 0;
  bool subdivide = false, repair = true;
  std::optional<std::size_t> iterations;
  double convergence_tolerance = 0;
  int threads = 0; // all if 0
};

struct Coarsening
{
  Mesh mesh;
  std::vector<std::int64_t> labels; // of each face of the input
  CGAL::Surface_mesh_coarsening::Coarsening_report report;
  std::optional<double> distance_bound; // if a distance was requested
};

// Coarsens to each number of vertices, all from the clustering with the first number, or to the distance.
std::vector<Coarsening> coarsen(const Mesh& input, const Options& options, Python_visitor& visitor);

} // namespace coarsening_python

#endif // SURFACE_MESH_COARSENING_PYTHON_COARSENING_H
