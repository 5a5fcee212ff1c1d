// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares speeds in consecutive pairs of runs, so that other load affects both alike, and prints as CSV the ratios with
// their spread: the tool's default run and the clustering alone, with other packages, with themselves on two threads, and
// with themselves on a smaller mesh. Memory is the peak of a separate process beyond its memory with the mesh loaded.
//
//   compare_speed RUNS MODEL VERTICES [MODEL VERTICES]...
//   compare_speed --once default|clustering MODEL VERTICES      one run, for profilers; see count_serial_part.sh
//
// MODEL: a file, or a number, which stands for a bumpy torus of so many faces.

#include "support/all_methods.h"
#include "support/bumpy_torus.h"
#include "support/models.h"

#include <boost/config.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif
#if __has_include(<sys/resource.h>) && __has_include(<sys/wait.h>)
#  include <sys/resource.h>
#  include <sys/wait.h>
#  include <unistd.h>
#  define COARSENING_MEASURES_MEMORY
#endif
#ifdef __GLIBC__
#  include <malloc.h>
#endif

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace benchmark_support;

struct Model
{
  std::string name;
  Mesh mesh;
  std::size_t vertices;
};

bool is_number(const std::string& s) { return std::all_of(s.begin(), s.end(), [](unsigned char c) { return std::isdigit(c); }); }

Model model(const std::string& file, const std::string& vertices)
{
  if (is_number(file))
    return {"torus", bumpy_torus(std::stoul(file)), std::stoul(vertices)};
  return {std::filesystem::path(file).stem().string(), read_model(file), std::stoul(vertices)};
}

const char* const whole_run = "ours area fitted";
const char* const clustering = "ours maximum quadric without repair";

// None, if it is of a package that was not found.
const Method* method(const std::string& name)
{
  static const std::vector<Method> all = all_methods();
  const auto i = std::find_if(all.begin(), all.end(), [&](const Method& m) { return m.name == name; });
  return i == all.end() ? nullptr : &*i;
}

typedef std::function<double()> Timed_run;

double quantile(const std::vector<double>& sorted, double q)
{
  const double at = q * double(sorted.size() - 1);
  const std::size_t i = std::size_t(at);
  return i + 1 < sorted.size() ? sorted[i] + (at - double(i)) * (sorted[i + 1] - sorted[i]) : sorted.back();
}

void print(const std::string& what, const Model& m, std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  std::cout << '"' << what << "\"," << m.name << ',' << m.mesh.number_of_faces() << ',' << m.vertices << ',' << values.size();
  for (const double q : {0., 0.25, 0.5, 0.75, 1.})
    std::cout << ',' << quantile(values, q);
  std::cout << std::endl;
}

void compare(const std::string& what, const Model& m, std::size_t runs, const Timed_run& first, const Timed_run& second)
{
  std::vector<double> ratios;
  for (std::size_t i = 0; i < runs; ++i) {
    const double a = first(), b = second();
    ratios.push_back(a / b);
  }
  print(what, m, ratios);
}

Timed_run processor_seconds(const Method& method, const Model& m)
{
  return [&method, &m] {
    Result result;
    return method.run(m.mesh, m.vertices, result).processor;
  };
}

void compare_with_peer(const std::string& what, const char* ours, const char* other, const Model& m, std::size_t runs)
{
  if (method(other) != nullptr)
    compare(what, m, runs, processor_seconds(*method(ours), m), processor_seconds(*method(other), m));
}

#ifdef CGAL_LINKED_WITH_TBB
void compare_threads(const std::string& what, const Method& parallel, const Model& m, std::size_t runs)
{
  const auto on_threads = [&](std::size_t threads) -> Timed_run {
    return [&parallel, &m, threads] {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      Result result;
      return parallel.run(m.mesh, m.vertices, result).clock;
    };
  };
  compare(what, m, runs, on_threads(2), on_threads(1));
}
#endif

#ifdef COARSENING_MEASURES_MEMORY
double peak_memory()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024 * double(usage.ru_maxrss);
}

// Of a process that begins with the memory that this one holds.
double bytes_per_face(const Method& method, const Model& m)
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  int ends[2];
  if (pipe(ends) != 0)
    throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child < 0)
    throw std::runtime_error("no process");
  if (child == 0) {
    const double before = peak_memory();
    Result result;
    method.run(m.mesh, m.vertices, result);
    const double bytes = peak_memory() - before;
    _exit(write(ends[1], &bytes, sizeof bytes) == ssize_t(sizeof bytes) ? 0 : 1);
  }
  close(ends[1]);
  double bytes = 0;
  const bool is_read = read(ends[0], &bytes, sizeof bytes) == ssize_t(sizeof bytes);
  close(ends[0]);
  waitpid(child, nullptr, 0);
  if (!is_read)
    throw std::runtime_error("the process that measures memory failed");
  return bytes / double(m.mesh.number_of_faces());
}
#endif

void measure(const Model& m, std::size_t runs)
{
#ifdef COARSENING_MEASURES_MEMORY
  print("bytes a face, default run", m, {bytes_per_face(*method(whole_run), m)});
  print("bytes a face, clustering", m, {bytes_per_face(*method(clustering), m)});
#endif
  compare_with_peer("default run / edge collapse", whole_run, "CGAL edge collapse", m, runs);
  compare_with_peer("clustering with quadrics / meshoptimizer", clustering, "meshoptimizer", m, runs);
  compare_with_peer("clustering, uniform / ACVD", "ours uniform", "CGAL ACVD", m, runs);
#ifdef CGAL_LINKED_WITH_TBB
  compare_threads("default run, two threads / one",
                  our_method<SMC::Weighted_area_weight, SMC::Fitted_placement, CGAL::Parallel_tag>("", 10), m, runs);
  compare_threads("clustering, two threads / one",
                  our_method<SMC::Maximum_density_weight, SMC::Quadric_placement, CGAL::Parallel_tag>("", 50, false), m, runs);
#endif
}

// Time per face of a torus over that of a small one, both coarsened to the same part.
void measure_scale(const Model& m, std::size_t runs)
{
  constexpr std::size_t small_faces = 100000;
  const Model small{"torus", bumpy_torus(small_faces), m.vertices * small_faces / m.mesh.number_of_faces()};
  const auto seconds_per_face = [](const Model& x) -> Timed_run {
    return [&x, run = processor_seconds(*method(clustering), x)] { return run() / double(x.mesh.number_of_faces()); };
  };
  compare("time per face, clustering / of 100,000 faces", m, runs, seconds_per_face(m), seconds_per_face(small));
}

// Never inlined, so that profilers separate it from reading the model.
BOOST_NOINLINE void run_once(const Method& method, const Model& m)
{
  Result result;
  method.run(m.mesh, m.vertices, result);
}

} // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool once =
    arguments.size() == 4 && arguments[0] == "--once" && (arguments[1] == "default" || arguments[1] == "clustering");
  if (!once && (arguments.size() < 3 || arguments.size() % 2 == 0 || !is_number(arguments[0]))) {
    std::cerr << "usage: compare_speed RUNS MODEL VERTICES [MODEL VERTICES]...\n"
                 "       compare_speed --once default|clustering MODEL VERTICES\n"
                 "MODEL: a file, or the number of faces of a torus" << std::endl;
    return 2;
  }
  try {
    if (once) {
      run_once(*method(arguments[1] == "default" ? whole_run : clustering), model(arguments[2], arguments[3]));
      return 0;
    }
    std::cout << "what,model,faces,vertices,runs,minimum,quartile_1,median,quartile_3,maximum" << std::endl;
    const std::size_t runs = (std::max)(std::size_t(1), std::size_t(std::stoul(arguments[0])));
    for (std::size_t i = 1; i < arguments.size(); i += 2) {
      const Model m = model(arguments[i], arguments[i + 1]);
      measure(m, runs);
      if (is_number(arguments[i]))
        measure_scale(m, runs);
    }
  } catch (const std::exception& e) {
    std::cerr << "compare_speed: " << e.what() << std::endl;
    return 1;
  }
  return 0;
}
