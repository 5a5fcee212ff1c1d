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
#include <utility>
#include <vector>

namespace coarsening_python {

using namespace coarsening_support;

struct Options
{
  // One of these, or the clusters of `Fields`; a number or ratio beside a distance is the maximum. The numbers of vertices are
  // the numbers of the levels, from fine to coarse.
  std::vector<std::size_t> vertices;
  std::optional<double> vertex_ratio, maximum_distance;
  std::optional<std::size_t> level, faces;
  std::string energy, weight, placement;
  bool paper = false; // in what no other option names
  double maximum_density = 10;
  double feature_angle = 180;
  double mean_angle = 40; // of the smallest angles, in degrees
  std::size_t error_feedback = 0;
  double minimum_component_area = 0;
  bool subdivide = false, repair_output = true, keep_borders = false, keep_small = false;
  std::optional<std::size_t> iterations;
  double convergence_tolerance = 0;
  int threads = 0; // all if 0
};

// Values of elements of the input; null, or empty, if not given.
struct Fields
{
  const double* density = nullptr; // of each face, like the next two
  const std::int64_t* patches = nullptr;
  const std::int64_t* clusters = nullptr; // to start from
  std::vector<bool> kept_edges, kept_vertices;
};

struct Coarsening
{
  Mesh mesh;
  std::vector<std::int64_t> labels;          // of each face of the input; the number of vertices in dropped components
  std::vector<std::int64_t> boundary_counts; // of each vertex of the input; not with a distance, nor of coarser levels
  std::vector<std::int64_t> patches;         // of each face of the mesh, if the input has patches; not of coarser levels
  CGAL::Surface_mesh_coarsening::Coarsening_report report;
  std::size_t dropped_components = 0;
  std::optional<double> distance_bound; // if a distance was requested
  bool is_within_distance = true;
};

// Coarsens to each number of vertices, all from the clustering with the first number, or to the distance.
std::vector<Coarsening> coarsen(Mesh input, const Options& options, Fields fields, Python_visitor& visitor);

// Returns the least and the largest number of vertices that can be requested.
std::pair<std::size_t, std::size_t> range_of(Mesh input, const Options& options, Fields fields, Python_visitor& visitor);

} // namespace coarsening_python

#endif // SURFACE_MESH_COARSENING_PYTHON_COARSENING_H
