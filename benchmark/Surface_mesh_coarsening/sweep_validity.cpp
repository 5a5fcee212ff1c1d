// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coarsens many meshes to many numbers of vertices with four weights and checks every result: the output has to be a
// 2-manifold triangle mesh with exactly the requested number of vertices and, component by component, the genus, the
// border loops and the orientation of the input. Where MPI is found, all meshes but the quick ones are also coarsened in small
// blocks. Prints a line per mesh and ends with 1 if a run failed.

#include "check/soup_fault.h"
#include "io/file_type.h"
#include "io/read_soup.h"
#include "io/to_mesh.h"
#include "support/Validity_checks.h"
#include "support/Watchdog.h"
#include "support/torture_set.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>

#ifdef SURFACE_MESH_COARSENING_WITH_MPI
#include <CGAL/Surface_mesh_coarsening/coarsen_distributed_mesh.h>

#include <boost/mpi/environment.hpp>
#include <boost/property_map/function_property_map.hpp>
#endif

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;
using namespace benchmark_support;
using coarsening_support::Soup;

struct Options
{
  std::vector<std::string> inputs;
  bool quick = false, torture = true;
  std::size_t maximum_faces = (std::numeric_limits<std::size_t>::max)();
  double time_limit = 600;
};

struct Line
{
  std::size_t smallest = 0, bound = 0, runs = 0, valid = 0, refused = 0, failed = 0, subdivided = 0;
  double worst_seconds = 0;

  void add(const Line& l)
  {
    runs += l.runs;
    valid += l.valid;
    refused += l.refused;
    failed += l.failed;
    subdivided += l.subdivided;
    worst_seconds = (std::max)(worst_seconds, l.worst_seconds);
  }
};

// The outcome of one call.
struct Outcome
{
  std::string fault;
  bool refused = false;
  std::size_t nearest = 0;
  bool subdivided = false;
};

typedef std::function<SMC::Coarsening_report(const Mesh&, std::size_t, Mesh&, Labels)> Coarsening;

template <class Weight>
Coarsening coarsening_with(double maximum_density)
{
  return [=](const Mesh& mesh, std::size_t number, Mesh& output, Labels labels) {
    return SMC::coarsen_mesh(mesh, number, output,
                             SMC::parameters::cluster_weight(Weight())
                               .vertex_placement(SMC::Centroid_placement()) // flips no edges: the triangles are the dual
                               .repair_output(false)
                               .maximum_density(maximum_density)
                               .face_cluster_map(labels));
  };
}

#ifdef SURFACE_MESH_COARSENING_WITH_MPI
// Coarsens a mesh as a distributed mesh with one piece, in blocks so small that most meshes have several.
SMC::Coarsening_report coarsen_in_blocks(const Mesh& mesh, std::size_t number, Mesh& output, Labels labels)
{
  const auto numbers = boost::make_function_property_map<Vertex>([](Vertex v) { return std::uint64_t(v); });
  return SMC::coarsen_distributed_mesh(boost::mpi::communicator(), mesh, numbers, number, output,
                                       SMC::parameters::faces_per_block(100).face_cluster_map(labels));
}
#endif

// Distributed meshes must not have two edges with the same ends.
bool has_parallel_edges(const Mesh& mesh)
{
  std::set<std::pair<Vertex, Vertex> > edges;
  for (const auto h : mesh.halfedges())
    if (!edges.insert({mesh.source(h), mesh.target(h)}).second)
      return true;
  return false;
}

class Sweep
{
public:
  explicit Sweep(const Options& options) : quick_(options.quick), watchdog_(options.time_limit)
  {
    if (!quick_) {
      weights_.push_back({"uniform", coarsening_with<SMC::Uniform_weight>(50)});
      weights_.push_back({"area", coarsening_with<SMC::Weighted_area_weight>(50)});
    }
    weights_.push_back({"maximum", coarsening_with<SMC::Maximum_density_weight>(50)});
    weights_.push_back({"variance", coarsening_with<SMC::Density_variance_weight>(3)});
#ifdef SURFACE_MESH_COARSENING_WITH_MPI
    if (!quick_) {
      blocks_ = weights_.size();
      weights_.push_back({"area, in blocks", coarsen_in_blocks});
    }
#endif
  }

  void print_head() const
  {
    std::cout << std::left << std::setw(38) << "mesh" << std::right;
    for (const char* title : {"vertices", "faces", "components", "loops", "genus", "smallest", "bound", "runs", "valid",
                              "refused", "failed", "subdivided", "worst s"})
      std::cout << ' ' << std::setw(10) << title;
    std::cout << std::endl;
  }

  // Tries each number with each weight.
  void run(const Examined_mesh& input)
  {
    line_ = Line();
    const Surface_counts total = input.certificate->total();
    for (const Surface_counts& c : input.certificate->components())
      line_.bound += c.fewest_vertices();
    input_ = &input;
    vertices_ = total.vertices;
    proven_.clear();
    // Refusals do not depend on the weight, but on the order of the faces, which is another one in blocks.
    if (find_smallest(0))
      for (std::size_t w = 0; w < weights_.size(); ++w)
        if (w != blocks_)
          run_all_numbers(w);
    const std::size_t smallest = line_.smallest;
    if (blocks_ < weights_.size() && !has_parallel_edges(input.mesh) && find_smallest(blocks_))
      run_all_numbers(blocks_);
    line_.smallest = smallest;
    print(total);
    sum_.add(line_);
    ++meshes_;
  }

  // An input that is no oriented surface: any face graph built from it has to be refused.
  void run_refused(const std::string& name, const Mesh& mesh)
  {
    line_ = Line();
    ++line_.runs;
    try {
      Mesh output;
      SMC::coarsen_mesh(mesh, 100, output);
      fail(name + ": was not refused");
    } catch (const SMC::Unreachable_number_of_vertices& e) {
      fail(name + ": was not refused as a surface: " + e.what());
    } catch (const SMC::Invalid_input& e) {
      ++line_.refused;
      std::cout << std::left << std::setw(38) << name << std::right << " refused: " << e.what() << std::endl;
    }
    sum_.add(line_);
    ++meshes_;
  }

  void note_refused(const std::string& name, const std::string& reason)
  {
    ++sum_.runs;
    ++sum_.refused;
    ++meshes_;
    std::cout << std::left << std::setw(38) << name << std::right << " refused: " << reason << std::endl;
  }

  bool finish() const
  {
    std::cout << "\n" << meshes_ << " meshes, " << sum_.runs << " runs: " << sum_.valid << " valid, " << sum_.refused
              << " rightly refused, " << sum_.failed << " failed; " << sum_.subdivided
              << " with subdivided components; the longest took " << sum_.worst_seconds << " s" << std::endl;
    return sum_.failed == 0;
  }

private:
  void fail(const std::string& message)
  {
    ++line_.failed;
    std::cout << "FAILED " << message << std::endl;
  }

  std::string name_of_run(std::size_t weight, std::size_t number) const
  {
    return input_->name + " to " + std::to_string(number) + " vertices, weight " + weights_[weight].first;
  }

  Outcome call(std::size_t weight, std::size_t number)
  {
    Outcome outcome;
    const auto begin = std::chrono::steady_clock::now();
    Mesh output;
    output.add_vertex(Point(1, 2, 3)); // has to remain after a refusal
    Mesh& mesh = const_cast<Mesh&>(input_->mesh);
    Labels labels = mesh.add_property_map<Face, std::size_t>("f:sweep", std::size_t(-1)).first;
    const auto seconds = [&] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    try {
      watchdog_.begin(name_of_run(weight, number));
      const SMC::Coarsening_report report = weights_[weight].second(input_->mesh, number, output, labels);
      watchdog_.end();
      line_.worst_seconds = (std::max)(line_.worst_seconds, seconds());
      outcome.subdivided = report.subdivided_components != 0;
      outcome.fault = fault_of_result(*input_, labels, number, output, report, weight != blocks_);
    } catch (const SMC::Unreachable_number_of_vertices& e) {
      line_.worst_seconds = (std::max)(line_.worst_seconds, seconds());
      outcome.refused = true;
      outcome.nearest = e.nearest();
      if (output.number_of_vertices() != 1 || output.number_of_faces() != 0)
        outcome.fault = "the output was touched before the refusal";
    } catch (const std::exception& e) {
      outcome.fault = std::string("threw: ") + e.what();
    }
    watchdog_.end();
    mesh.remove_property_map(labels);
    return outcome;
  }

  // The numbers that a refusal may name; none if the call has to succeed.
  struct Nearest
  {
    std::size_t low = 1, high = 0;
    bool allowed() const { return low <= high; }
  };

  // Counts one run. A refusal is right if it may be one and names a number, on its right side, that works.
  void judge(std::size_t weight, std::size_t number, const Nearest& nearest)
  {
    ++line_.runs;
    const Outcome outcome = call(weight, number);
    std::string fault = outcome.fault;
    if (fault.empty() && outcome.refused != nearest.allowed())
      fault = outcome.refused ? "was refused" : "was not refused";
    if (fault.empty() && outcome.refused)
      fault = fault_of_nearest(weight, outcome.nearest, nearest);
    if (!fault.empty()) {
      fail(name_of_run(weight, number) + ": " + fault);
    } else if (outcome.refused) {
      ++line_.refused;
    } else {
      ++line_.valid;
      line_.subdivided += outcome.subdivided;
      proven_.insert({weight, number});
    }
  }

  std::string fault_of_nearest(std::size_t weight, std::size_t number, const Nearest& nearest)
  {
    const std::string name = "nearest() = " + std::to_string(number);
    if (number < nearest.low || number > nearest.high)
      return name;
    if (proven_.count({weight, number}) != 0)
      return {};
    const Outcome outcome = call(weight, number);
    if (outcome.refused)
      return name + " is refused too";
    if (!outcome.fault.empty())
      return name + ": " + outcome.fault;
    proven_.insert({weight, number});
    return {};
  }

  bool find_smallest(std::size_t weight)
  {
    const Outcome outcome = call(weight, 1);
    if (outcome.refused && outcome.fault.empty() && outcome.nearest > 1 && outcome.nearest >= line_.bound) {
      line_.smallest = outcome.nearest;
      return true;
    }
    ++line_.runs;
    fail(name_of_run(weight, 1) + ": " +
         (!outcome.fault.empty() ? outcome.fault
                                 : outcome.refused ? "nearest() = " + std::to_string(outcome.nearest) : "not refused"));
    return false;
  }

  void run_all_numbers(std::size_t weight)
  {
    const std::size_t smallest = line_.smallest;
    std::vector<std::size_t> numbers{smallest};
    for (const double share : {0.01, 0.05, 0.2, 0.5, 1.})
      numbers.push_back(std::size_t(std::floor(share * double(vertices_) + 0.5)));
    for (const std::size_t n : numbers)
      judge(weight, n, n < smallest ? Nearest{smallest, smallest} : Nearest());
    if (weight != 0)
      return;
    judge(0, smallest - 1, {smallest, smallest});
    const std::size_t too_many = 2 * (std::max)(smallest, vertices_);
    judge(0, too_many, {smallest, too_many - 1});
  }

  void print(const Surface_counts& total) const
  {
    long genus = 0;
    for (const Surface_counts& c : input_->certificate->components())
      genus += c.genus();
    std::cout << std::left << std::setw(38) << input_->name << std::right;
    for (const std::size_t value :
         {total.vertices, total.faces, input_->certificate->components().size(), total.loops, std::size_t(genus),
          line_.smallest, line_.bound, line_.runs, line_.valid, line_.refused, line_.failed, line_.subdivided})
      std::cout << ' ' << std::setw(10) << value;
    std::cout << ' ' << std::setw(10) << std::fixed << std::setprecision(2) << line_.worst_seconds << std::endl;
  }

  const bool quick_;
  Watchdog watchdog_;
  std::vector<std::pair<std::string, Coarsening> > weights_;
  std::size_t blocks_ = std::size_t(-1); // the number of the coarsening in blocks among them
  const Examined_mesh* input_ = nullptr;
  std::size_t vertices_ = 0, meshes_ = 0;
  Line line_, sum_;
  std::set<std::pair<std::size_t, std::size_t> > proven_; // weights and numbers that have worked
};

std::vector<std::string> files_in(const std::vector<std::string>& inputs)
{
  std::vector<std::string> files;
  for (const std::string& input : inputs) {
    if (!std::filesystem::is_directory(input)) {
      files.push_back(input);
      continue;
    }
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(input))
      if (coarsening_support::is_own_file_type(coarsening_support::file_type(entry.path().string())))
        found.push_back(entry.path().string());
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

// Reverses polygons so that their orientations agree, if this alone yields a surface.
std::optional<std::string> fault_after_orientation(Soup& soup)
{
  const std::optional<std::string> fault = coarsening_support::soup_fault(soup);
  if (!fault)
    return fault;
  try {
    Soup turned;
    turned.points = soup.points;
    std::vector<std::vector<std::size_t> > polygons = soup.polygons.lists();
    CGAL::Polygon_mesh_processing::orient_polygon_soup(turned.points, polygons);
    turned.polygons = coarsening_support::Polygons(polygons);
    if (turned.points.size() != soup.points.size() || coarsening_support::soup_fault(turned))
      return fault;
    soup = turned;
    return std::nullopt;
  } catch (const std::exception&) {
    return fault;
  }
}

void run_file(const std::string& file, const Options& options, Sweep& sweep, std::vector<std::string>& left_out)
{
  const std::string name = std::filesystem::path(file).filename().string();
  try {
    Soup soup = coarsening_support::read_soup(file);
    if (const auto fault = fault_after_orientation(soup))
      left_out.push_back(name + ": " + *fault);
    else if (soup.polygons.size() > options.maximum_faces)
      left_out.push_back(name + ": has " + std::to_string(soup.polygons.size()) + " faces");
    else
      sweep.run(Examined_mesh(name, coarsening_support::to_mesh(soup)));
  } catch (const coarsening_support::Failure& e) {
    left_out.push_back(e.what());
  }
}

void run_torture(const Torture& torture, Sweep& sweep)
{
  const generated::Soup made = torture.make();
  Soup soup;
  for (const generated::Point& p : made.points)
    soup.points.push_back(Point(p[0], p[1], p[2]));
  soup.polygons = coarsening_support::Polygons(made.polygons);
  const auto fault = coarsening_support::soup_fault(soup);
  if (!torture.refused) {
    if (fault)
      throw std::logic_error(torture.name + ": " + *fault);
    sweep.run(Examined_mesh(torture.name, coarsening_support::to_mesh(soup)));
    return;
  }
  Mesh mesh;
  for (const Point& p : soup.points)
    mesh.add_vertex(p);
  for (const auto& polygon : soup.polygons) {
    std::vector<Vertex> corners;
    for (const std::size_t v : polygon)
      corners.push_back(Vertex(Mesh::size_type(v)));
    if (mesh.add_face(corners) == Mesh::null_face()) {
      // Halfedges cannot represent it: the library cannot be called at all.
      sweep.note_refused(torture.name, *fault);
      return;
    }
  }
  sweep.run_refused(torture.name, mesh);
}

Options read_options(int argc, char** argv)
{
  namespace po = boost::program_options;
  Options options;
  po::options_description visible("usage: sweep_validity [OPTIONS] [FILE | DIRECTORY]...\noptions");
  visible.add_options()("help", "print this and exit")(
    "quick", po::bool_switch(&options.quick), "small meshes and two weights")(
    "maximum-faces", po::value(&options.maximum_faces), "leave out files of more faces")(
    "time-limit", po::value(&options.time_limit)->default_value(options.time_limit), "seconds for one run")(
    "no-torture", "leave out the generated meshes");
  po::options_description all;
  all.add(visible).add_options()("input", po::value(&options.inputs));
  po::variables_map map;
  po::positional_options_description positional;
  positional.add("input", -1);
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional).run(), map);
  po::notify(map);
  if (map.count("help") != 0) {
    std::cout << visible;
    std::exit(0);
  }
  options.torture = map.count("no-torture") == 0;
  if (options.quick)
    options.maximum_faces = (std::min)(options.maximum_faces, std::size_t(2500));
  return options;
}

} // namespace

int main(int argc, char** argv)
try {
#ifdef SURFACE_MESH_COARSENING_WITH_MPI
  const boost::mpi::environment environment;
#endif
  const Options options = read_options(argc, argv);
  Sweep sweep(options);
  std::vector<std::string> left_out;
  sweep.print_head();
  if (options.torture)
    for (const Torture& torture : torture_set(options.quick))
      run_torture(torture, sweep);
  for (const std::string& file : files_in(options.inputs))
    run_file(file, options, sweep, left_out);
  if (!left_out.empty())
    std::cout << "\nleft out:\n";
  for (const std::string& message : left_out)
    std::cout << "  " << message << "\n";
  return sweep.finish() ? 0 : 1;
} catch (const std::exception& e) {
  std::cerr << "sweep_validity: " << e.what() << std::endl;
  return 2;
}
