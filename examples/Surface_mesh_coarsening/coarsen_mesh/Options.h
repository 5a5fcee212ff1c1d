// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_OPTIONS_H
#define COARSEN_MESH_OPTIONS_H

#include "io/Mesh.h"

#include <CGAL/Surface_mesh_coarsening/defaults.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace coarsen_mesh_tool {

using namespace coarsening_support;
using Defaults = CGAL::Surface_mesh_coarsening::Coarsening_defaults;

// A command line that cannot be understood or obeyed.
class Wrong_usage : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// The options of the command line. An empty file name requests no file.
struct Options
{
  std::string input, output;
  std::string format; // of standard input and output
  std::optional<std::size_t> vertices;
  std::optional<double> vertex_ratio; // of the input's
  bool keep_small = false;            // components that cannot be reduced to the ratio
  std::optional<std::size_t> faces;
  bool asks_range = false;            // of the numbers of vertices that are possible, and for no output
  std::optional<unsigned> neighborhood_level;
  std::optional<double> maximum_distance; // with a number of vertices: the maximum number
  bool distance_is_relative = true;       // to the diagonal of the bounding box
  std::size_t levels = 0;                 // coarser ones to be written beside the result
  std::optional<std::size_t> rounds; // as many as it takes when not given
  double convergence_tolerance = Defaults::convergence_tolerance; // the relative gain of the last round
  std::string energy, weight, placement; // names out of the lists in Choices.h
  double maximum_density = Defaults::maximum_density;
  double mean_angle = Defaults::mean_angle; // of the triangles' smallest angles, in degrees
  bool paper = false; // in what no other option names
  std::size_t error_feedback = Defaults::error_feedback; // rounds of it
  std::optional<double> features; // the angle in degrees from which edges are kept
  std::string patches; // the field of faces whose patches are kept
  std::string keep; // the field of vertices or faces that are kept
  bool keep_borders = false;
  std::string clusters, picture, report;
  Vector view, up = Vector(0, 1, 0);
  double minimum_component_area = 0; // of the mesh's units squared; 0 keeps every component
  double fill_holes = 0;             // length of the border up to which holes are filled; 0 fills none, infinity all
  bool hole_length_is_relative = false; // to the diagonal
  double weld = 0; // distance within which the repair merges points; 0 merges coincident ones
  bool repair = false, subdivide = false, measure = false, quiet = false;
  bool force = false;     // OUTPUT may replace INPUT
  bool distances = false; // numbers of the result's vertices
  std::optional<unsigned> threads; // all if not given
};

// The type of a mesh file that the options name, also of a standard stream.
std::string type_of(const Options& options, const std::string& file);

// Reads the command line. Returns one set of options for each input, none when a question (--help, --version) has been answered
// on standard output.
std::vector<Options> read_options(int argc, char* argv[]);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_OPTIONS_H
