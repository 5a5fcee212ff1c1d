// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coarsens a bumpy torus of many triangles with the default settings, and prints as CSV the processor seconds of the stages.
//
//   measure_scale FACES...              each number of faces, to a fiftieth of the vertices
//   measure_scale --clusters FACES      one mesh, to numbers of vertices from 7 to all
//   measure_scale --cancel FACES        the longest time in which the visitor is not asked whether to go on, in each stage, and
//                                       how long it takes from its answer until the call has returned

#include "support/bumpy_torus.h"

#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;
using benchmark_support::bumpy_torus;
using coarsening_support::Mesh;

constexpr std::size_t vertices_per_cluster = 50;
const std::array<const char*, 8> stages{
  {"preparation", "seeds", "growth", "minimization", "triangulation", "placement", "feedback", "repair"}};

double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

// Processor seconds of each stage.
struct Timing_visitor : SMC::Coarsening_visitor_base
{
  std::array<double, 8> seconds{};
  double begin = 0;
  void stage_begins(SMC::Coarsening_stage) { begin = processor_seconds(); }
  void stage_ends(SMC::Coarsening_stage stage) { seconds[std::size_t(stage)] += processor_seconds() - begin; }
};

void print_header()
{
  std::cout << "faces,vertices_of_output";
  for (const char* stage : stages)
    std::cout << ',' << stage << "_s";
  std::cout << ",whole_s,microseconds_per_face,rounds,tests_per_face" << std::endl;
}

// Centroids: how the clustering grows with the mesh is measured, not the fit.
auto clustering_alone() { return SMC::parameters::vertex_placement(SMC::Centroid_placement()); }

void measure(const Mesh& mesh, std::size_t number)
{
  Mesh output;
  Timing_visitor visitor;
  const double begin = processor_seconds();
  const SMC::Coarsening_report report =
    SMC::coarsen_mesh(mesh, number, output, clustering_alone().visitor(std::ref(visitor)));
  const double whole = processor_seconds() - begin, faces = double(mesh.number_of_faces());
  std::cout << mesh.number_of_faces() << ',' << number;
  for (const double s : visitor.seconds)
    std::cout << ',' << s;
  std::cout << ',' << whole << ',' << 1e6 * whole / faces << ',' << report.rounds << ',' << double(report.tests) / faces
            << std::endl;
}

// Cancels after this number of calls, unless it is 0.
struct Asking_visitor : SMC::Coarsening_visitor_base
{
  std::size_t max_questions = 0, questions = 0, stage = 0;
  double last = 0;
  std::array<double, 8> longest{};

  void stage_begins(SMC::Coarsening_stage s)
  {
    note();
    stage = std::size_t(s);
  }
  void stage_ends(SMC::Coarsening_stage) { note(); }
  bool go_further()
  {
    note();
    return ++questions != max_questions;
  }
  void note()
  {
    const double now = processor_seconds();
    if (last > 0)
      longest[stage] = (std::max)(longest[stage], now - last);
    last = now;
  }
};

void measure_cancelling(std::size_t faces)
{
  const Mesh mesh = bumpy_torus(faces);
  const std::size_t number = mesh.number_of_vertices() / vertices_per_cluster;
  constexpr std::size_t rounds = 5; // one is like another
  Asking_visitor visitor;
  {
    Mesh output;
    SMC::coarsen_mesh(mesh, number, output, clustering_alone().visitor(std::ref(visitor)).number_of_iterations(rounds));
  }
  std::cout << "faces,stage,longest_without_question_s" << std::endl;
  for (std::size_t i = 0; i < stages.size(); ++i)
    std::cout << mesh.number_of_faces() << ',' << stages[i] << ',' << visitor.longest[i] << std::endl;
  std::cout << "faces,cancelled_at_question,of,stage,until_returned_s" << std::endl;
  for (const double part : {0.01, 0.1, 0.3, 0.6, 0.95}) {
    Asking_visitor cancelling;
    cancelling.max_questions = (std::max)(std::size_t(1), std::size_t(part * double(visitor.questions)));
    Mesh output;
    try {
      SMC::coarsen_mesh(mesh, number, output, clustering_alone().visitor(std::ref(cancelling)).number_of_iterations(rounds));
    } catch (const SMC::Coarsening_cancelled&) {
      const double seconds = processor_seconds() - cancelling.last;
      std::cout << mesh.number_of_faces() << ',' << cancelling.max_questions << ',' << visitor.questions << ','
                << stages[cancelling.stage] << ',' << seconds << std::endl;
    }
    if (output.number_of_vertices() != 0)
      throw std::runtime_error("the output has changed");
  }
}

void measure_clusters(std::size_t faces)
{
  const Mesh mesh = bumpy_torus(faces);
  print_header();
  // A torus needs seven vertices.
  for (std::size_t number = 7; number < mesh.number_of_vertices(); number *= 8)
    measure(mesh, number);
  measure(mesh, mesh.number_of_vertices());
}

} // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.empty()) {
    std::cerr << "usage: measure_scale FACES... | --clusters FACES | --cancel FACES" << std::endl;
    return EXIT_FAILURE;
  }
  try {
    std::cout.precision(4);
    const auto number = [](const std::string& s) { return std::size_t(std::stoull(s)); };
    if (arguments[0] == "--clusters")
      measure_clusters(number(arguments.at(1)));
    else if (arguments[0] == "--cancel")
      measure_cancelling(number(arguments.at(1)));
    else {
      print_header();
      for (const std::string& faces : arguments) {
        const Mesh mesh = bumpy_torus(number(faces));
        measure(mesh, mesh.number_of_vertices() / vertices_per_cluster);
      }
    }
  } catch (const std::exception& e) {
    std::cerr << "measure_scale: " << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
