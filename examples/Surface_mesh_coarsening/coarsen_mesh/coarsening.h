// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_COARSENING_H
#define COARSEN_MESH_COARSENING_H

#include "Options.h"
#include "Tool_visitor.h"

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/vertex_number_range.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace coarsen_mesh_tool {

// A level coarser than the result.
struct Coarser_level
{
  Mesh mesh;
  std::vector<std::size_t> parents; // the vertex here of each vertex of the previous level
};

struct Coarsening_result
{
  Mesh mesh;                       // its vertex i represents label i
  std::vector<std::size_t> labels; // per face of the input
  CGAL::Surface_mesh_coarsening::Coarsening_report report;
  std::size_t vertices_on_features = 0;
  std::optional<double> distance_bound; // if a distance was asked for
  bool is_within_distance = true;       // not if the number of vertices ended the search
  std::vector<Coarser_level> levels;
};

// Returns the name of the file of a coarser level; the first is 1.
std::string level_file(const std::string& output, std::size_t level);

// The names for the command line.
const std::vector<std::string>& energy_names();
const std::vector<std::string>& weight_names();
const std::vector<std::string>& placement_names();
std::string default_energy();
std::string default_weight();
std::string default_placement();

// The maximal number of threads, for any options; 1 without oneTBB.
unsigned max_threads();

// Of the bounding box.
double diagonal(const Mesh& mesh);

// The numbers of vertices that the input can be coarsened to.
CGAL::Surface_mesh_coarsening::Vertex_number_range range_of(const Mesh& input, const Options& options, Tool_visitor& visitor);

// The densities of the faces for these options, before any of them is raised to recluster the mesh.
std::vector<double> face_densities(const Mesh& input, const Options& options);

// Coarsens with the energy, the weight, the placement and the numbers in the options. Meanwhile, the input may have no halfedges.
Coarsening_result coarsen(Mesh& input, const Options& options, Tool_visitor& visitor);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_COARSENING_H
