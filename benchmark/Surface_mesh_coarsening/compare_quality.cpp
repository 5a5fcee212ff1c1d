// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs this package and the other compiled-in coarsening methods on meshes, at several sizes. The first argument names a file,
// which gets a row for each run as soon as the run is measured. Runs that the file already has are not repeated, so an
// interrupted comparison can be continued. At the end, prints two tables as CSV, with an empty line between them: means over the
// meshes, and the mean ratio of distances for each mesh. Distances and deviations of normals are divided by the values of the
// edge collapse of CGAL with its default cost, by Lindstrom and Turk, at the same size: below 1, a method is closer. Their means
// are geometric. Runs that fail, do not end, or return no 2-manifold, are counted and omitted from the means.

#include "support/Surface_certificate.h"
#include "support/models.h"
#include "support/peers.h"

#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace benchmark_support;

// The others are compared with the first one.
std::vector<Method> all_methods()
{
  std::vector<Method> methods{{"CGAL edge collapse", run_lindstrom_turk},
                              {"CGAL edge collapse by planes", run_garland_heckbert<Plane_quadrics>}};
#ifdef COARSENING_HAS_LINE_QUADRICS
  methods.push_back({"CGAL edge collapse by planes and lines", run_garland_heckbert<Plane_and_line_quadrics>});
#endif
#ifdef COARSENING_HAS_ACVD
  const auto seed = CGAL::parameters::random_seed(0);
  methods.push_back(acvd("CGAL ACVD", seed));
  methods.push_back(acvd("CGAL ACVD by quadrics", seed.use_qem_based_energy(true)));
  methods.push_back(acvd("CGAL ACVD with gradation", seed.gradation_factor(1.)));
#endif
  add_other_libraries(methods);
  methods.push_back(our_method_with_energy<SMC::Weighted_inertia_energy<> >("ours"));
  methods.push_back(our_method_with_energy<SMC::Quadric_energy>("ours by quadrics"));
  methods.push_back(our_method_with_energy<SMC::Normal_deviation_energy>("ours by normals"));
  return methods;
}

// Searches for closest points take longer than most methods. With five times as many samples, a distance changes by three percent
// at most, and the mean over runs by a tenth of a percent.
constexpr std::size_t number_of_samples = 20000;

struct Run
{
  std::size_t vertices = 0; // none if the method has failed
  double seconds = 0, rms_percent = 0, rms_of_normals = 0, angle = 0, below_30_percent = 0;
  std::size_t self_intersections = 0;
};

Run run(const Method& method, const Mesh& mesh, std::size_t number)
{
  try {
    Result result;
    const double seconds = method.run(mesh, number, result).processor;
    if (!Surface_certificate(result.polygons, result.points.size(), true).fault().empty())
      return Run();
    Mesh coarse;
    CGAL::Polygon_mesh_processing::orient_polygon_soup(result.points, result.polygons);
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(result.points, result.polygons, coarse);
    const SMC::Coarsening_quality q = SMC::measure_coarsening(mesh, coarse, number_of_samples);
    return {result.points.size(),
            seconds,
            100 * q.rms_distance / q.diagonal,
            q.rms_normal_deviation,
            q.mean_smallest_angle,
            100 * q.part_below_30_degrees,
            q.self_intersections};
  } catch (const std::exception& e) {
    std::cerr << method.name << ", " << number << " vertices: " << e.what() << std::endl;
    return Run();
  }
}

// Runs the method in a process of its own, which ends after a number of seconds of processor time: there are meshes on which some
// methods do not end, or crash.
Run run_for_limited_time(const Method& method, const Mesh& mesh, std::size_t number)
{
  constexpr rlim_t seconds = 30;
  int ends[2];
  const pid_t process = pipe(ends) == 0 ? fork() : -1;
  if (process < 0)
    throw std::runtime_error("cannot begin a process");
  if (process == 0) {
    const rlimit limit{seconds, seconds};
    setrlimit(RLIMIT_CPU, &limit);
    const Run r = run(method, mesh, number);
    std::_Exit(write(ends[1], &r, sizeof r) == ssize_t(sizeof r) ? EXIT_SUCCESS : EXIT_FAILURE);
  }
  close(ends[1]);
  Run r;
  const bool is_done = read(ends[0], &r, sizeof r) == ssize_t(sizeof r);
  close(ends[0]);
  waitpid(process, nullptr, 0);
  if (is_done)
    return r;
  std::cerr << method.name << ", " << number << " vertices: did not end within " << seconds << " s, or crashed" << std::endl;
  return Run();
}

// The file of the runs: a row of CSV each. The key is what its row begins with: model, size and method.
class Runs_file
{
public:
  explicit Runs_file(const std::string& name)
  {
    std::ifstream is(name);
    std::string line;
    const bool is_new = !std::getline(is, line);
    while (std::getline(is, line))
      read_row(line);
    os_.open(name, std::ios::app);
    os_.precision(9);
    if (is_new)
      os_ << "model,size_%,method,vertices,seconds,rms_%,rms_of_normals,mean_smallest_angle,below_30_%,self_intersections"
          << std::endl;
    if (!os_)
      throw std::runtime_error(name + ": cannot be written");
  }

  // Returns the run of this key, which `measure` measures if the file does not have it.
  template <class Measure>
  const Run& get(const std::string& key, const Measure& measure)
  {
    const auto found = runs_.find(key);
    if (found != runs_.end())
      return found->second;
    const Run r = measure();
    os_ << key << ',' << r.vertices << ',' << r.seconds << ',' << r.rms_percent << ',' << r.rms_of_normals << ',' << r.angle
        << ',' << r.below_30_percent << ',' << r.self_intersections << std::endl;
    return runs_.emplace(key, r).first->second;
  }

private:
  void read_row(const std::string& line)
  {
    std::istringstream fields(line);
    std::string model, size, method;
    std::getline(std::getline(std::getline(fields, model, ','), size, ','), method, ',');
    Run r;
    char comma;
    if (fields >> r.vertices >> comma >> r.seconds >> comma >> r.rms_percent >> comma >> r.rms_of_normals >> comma >> r.angle >>
        comma >> r.below_30_percent >> comma >> r.self_intersections)
      runs_.emplace(model + ',' + size + ',' + method, r);
  }

  std::map<std::string, Run> runs_;
  std::ofstream os_;
};

class Geometric_mean
{
public:
  void add(double ratio)
  {
    if (!(ratio > 0 && std::isfinite(ratio)))
      return;
    logarithms_ += std::log(ratio);
    ++number_;
  }
  double value() const { return number_ == 0 ? 0 : std::exp(logarithms_ / double(number_)); }

private:
  double logarithms_ = 0;
  std::size_t number_ = 0;
};

// What a method has reached, with regard to the edge collapse.
struct Record
{
  explicit Record(std::size_t sizes) : distance_at(sizes) {}

  void add(const Run& run, const Run& anchor, std::size_t size)
  {
    if (run.vertices == 0) {
      ++failed;
      return;
    }
    const double ratio = run.rms_percent / anchor.rms_percent;
    distance.add(ratio);
    distance_at[size].add(ratio);
    worst = (std::max)(worst, ratio);
    closer += ratio < 1;
    normals.add(run.rms_of_normals / anchor.rms_of_normals);
    seconds.add(run.seconds / anchor.seconds);
    angles += run.angle;
    below_30_percent += run.below_30_percent;
    self_intersections += run.self_intersections;
    ++runs;
  }

  Geometric_mean distance, normals, seconds;
  std::vector<Geometric_mean> distance_at; // of each size
  double worst = 0, angles = 0, below_30_percent = 0;
  std::size_t runs = 0, failed = 0, closer = 0, self_intersections = 0;
};

std::string formatted(double size)
{
  std::ostringstream os;
  os << size;
  return os.str();
}

// Adds the runs on a mesh to the records of the methods, and returns the mean ratio of distances of each method on it.
std::vector<Geometric_mean> compare(const std::string& file, const std::vector<double>& sizes, const std::vector<Method>& methods,
                                    Runs_file& runs, std::vector<Record>& records)
{
  std::vector<Geometric_mean> distances(methods.size());
  const Mesh mesh = read_model(file);
  for (std::size_t s = 0; s < sizes.size(); ++s) {
    const std::size_t number = (std::max)(std::size_t(sizes[s] / 100 * double(mesh.number_of_vertices())), std::size_t(4));
    const std::string key = std::filesystem::path(file).stem().string() + ',' + formatted(sizes[s]) + ',';
    const auto run_of = [&](const Method& method) {
      return runs.get(key + method.name, [&] { return run_for_limited_time(method, mesh, number); });
    };
    const Run anchor = run_of(methods.front());
    if (anchor.vertices == 0)
      throw std::runtime_error("the edge collapse, which the others are compared with, has failed");
    for (std::size_t i = 0; i < methods.size(); ++i) {
      const Run run = run_of(methods[i]);
      records[i].add(run, anchor, s);
      if (run.vertices != 0)
        distances[i].add(run.rms_percent / anchor.rms_percent);
    }
  }
  return distances;
}

void print(const std::vector<double>& sizes, const std::vector<Method>& methods, const std::vector<Record>& records)
{
  std::cout << "method,runs,failed,rms";
  for (const double size : sizes)
    std::cout << ",at_" << size << "%";
  std::cout << ",largest_rms,closer_in,rms_of_normals,mean_smallest_angle,below_30_%,self_intersections,seconds" << std::endl;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const Record& r = records[i];
    const double runs = double((std::max)(r.runs, std::size_t(1)));
    std::cout << methods[i].name << ',' << r.runs << ',' << r.failed << ',' << r.distance.value();
    for (const Geometric_mean& mean : r.distance_at)
      std::cout << ',' << mean.value();
    std::cout << ',' << r.worst << ',' << r.closer << ',' << r.normals.value() << ',' << r.angles / runs << ','
              << r.below_30_percent / runs << ',' << r.self_intersections << ',' << r.seconds.value() << std::endl;
  }
}

typedef std::vector<std::pair<std::string, std::vector<Geometric_mean> > > Models;

// A method without runs on a mesh has no mean.
void print(const std::vector<Method>& methods, const Models& models)
{
  std::cout << "\nmodel";
  for (const Method& method : methods)
    std::cout << ',' << method.name;
  std::cout << std::endl;
  for (const auto& model : models) {
    std::cout << model.first;
    for (const Geometric_mean& mean : model.second) {
      std::cout << ',';
      if (mean.value() > 0)
        std::cout << mean.value();
    }
    std::cout << std::endl;
  }
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 4) {
    std::cerr << "usage: compare_quality RUNS SIZES FILE...\n"
                 "RUNS: a file of CSV that gets a row for each run; runs that it has are not repeated\n"
                 "SIZES: parts of the vertices of each file in percent, as in 1,2,5,10,20"
              << std::endl;
    return 2;
  }
  try {
    std::vector<double> sizes;
    std::istringstream stream(argv[2]);
    for (std::string item; std::getline(stream, item, ',');)
      sizes.push_back(std::stod(item));
    const std::vector<Method> methods = all_methods();
    std::vector<Record> records(methods.size(), Record(sizes.size()));
    Runs_file runs(argv[1]);
    Models models;
    for (int i = 3; i < argc; ++i)
      models.emplace_back(std::filesystem::path(argv[i]).stem().string(), compare(argv[i], sizes, methods, runs, records));
    std::cout.precision(3);
    print(sizes, methods, records);
    print(methods, models);
  } catch (const std::exception& e) {
    std::cerr << "compare_quality: " << e.what() << std::endl;
    return 1;
  }
  return 0;
}
