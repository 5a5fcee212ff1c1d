// SPDX-License-Identifier: GPL-3.0-or-later
//
// Times the tool, as a process, on difficult generated meshes: vertices of high valence, long triangles, polygons of very
// many sides, jagged borders, very many loops and components; or on small random meshes, as `attack` makes them: without
// options, with features, with repair of the input and within a distance. Each run has to end, with a result or a refusal,
// within a tenth of a second and a multiple of the processor time per face of a reference mesh: the horse if given, otherwise
// a rough sphere, coarsened with the same options. Prints a line per run, of random meshes only the longest, and ends with 1 if
// one took longer. The tool's path is in the environment variable COARSEN_MESH.

#include "attack/random_mesh.h"
#include "support/Tool_process.h"
#include "support/generate_meshes.h"
#include "support/mesh_files.h"
#include "support/torture_set.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <sys/resource.h>

namespace {

using generated::Soup;

struct Options
{
  std::string reference, only, tool_options;
  double limit = 20;
  std::uint64_t seed = 1;
  std::size_t random_meshes = 0;
  bool quick = false;
};

struct Hard_mesh
{
  std::string name;
  std::function<Soup()> make;
  std::string options;
};

// A disc of triangles around a polygon of many sides.
Soup disc_around_polygon(std::size_t sides)
{
  Soup s = generated::tube(sides, 1);
  generated::Polygon inside;
  for (std::size_t i = 0; i < sides; ++i) {
    generated::Point& p = s.points[2 * i];
    p = {0.5 * p[0], 0.5 * p[1], 0};
    s.points[2 * i + 1][2] = 0;
    inside.push_back(2 * (sides - 1 - i));
  }
  s.polygons.push_back(inside);
  return s;
}

// A tube with a zigzag border.
Soup jagged_tube(std::size_t edges, std::size_t rings)
{
  Soup s = generated::triangulated(generated::tube(edges / 2, rings));
  const auto on_top = [&](std::size_t v) { return v % (rings + 1) == rings; };
  const auto is_between_teeth = [&](const generated::Polygon& p) { return std::count_if(p.begin(), p.end(), on_top) == 2; };
  s.polygons.erase(std::remove_if(s.polygons.begin(), s.polygons.end(), is_between_teeth), s.polygons.end());
  std::mt19937 engine(1);
  for (std::size_t v = 0; v < s.points.size(); ++v)
    if (on_top(v))
      s.points[v][2] += 0.3 * (1 + generated::symmetric_random(engine));
  return generated::without_isolated_vertices(s);
}

std::vector<Hard_mesh> hard_meshes(bool quick)
{
  using namespace generated;
  const auto size = [quick](std::size_t large, std::size_t small) { return quick ? small : large; };
  const unsigned level = quick ? 4 : 6;
  return {
    {"bipyramid of valence 1,000", [] { return bipyramid(1000); }, ""},
    {"bipyramid of high valence", [=] { return bipyramid(size(100000, 5000)); }, ""},
    {"cone of valence 10,000", [=] { return fan(size(10000, 3000)); }, ""},
    {"cone of high valence", [=] { return fan(size(200000, 8000)); }, ""},
    {"dual of a bipyramid", [=] { return dual(bipyramid(size(20000, 1000))); }, ""},
    {"polygon of many sides", [=] { return disc_around_polygon(size(5000, 500)); }, ""},
    {"polygon of very many sides", [=] { return disc_around_polygon(size(50000, 2000)); }, ""},
    {"needles", [=] { return needles(size(1000, 100), size(100, 12)); }, ""},
    {"long thin tube", [=] { return triangulated(tube(3, size(30000, 1000))); }, ""},
    {"strip of triangles", [=] { return triangulated(grid(size(100000, 2000), 1)); }, ""},
    {"strip of long triangles", [=] { return scaled(triangulated(grid(size(50000, 1000), 2)), 1e-3, 10, 1); }, ""},
    {"uneven grid", [=] { return benchmark_support::uneven_grid(size(200, 60), size(500, 40)); }, ""},
    {"jagged border", [=] { return jagged_tube(1000, size(100, 4)); }, ""},
    {"jagged border, filled", [=] { return jagged_tube(size(1000, 200), size(100, 20)); }, "--fill-holes 1e9"},
    {"very many loops", [=] { return with_holes(triangle_sphere(level), size(2000, 100)); }, ""},
    {"very many components", [=] { return many_tetrahedra(size(10000, 300)); }, ""},
    {"very many triangles apart", [=] { return benchmark_support::triangles(size(3000, 100)); }, ""},
    {"plate of high genus", [=] { return triangulated(plate_with_windows(size(300, 20), size(5, 2))); }, ""},
    {"thin plate", [=] { return thin_plate(size(180, 40), 0.01); }, ""},
    {"noise", [=] { return with_noise(triangle_sphere(level), 0.2); }, ""},
    {"flat sphere", [=] { return scaled(triangle_sphere(level), 1, 1, 0); }, ""},
    {"all in one point", [=] { return scaled(triangle_sphere(level), 0); }, ""},
    {"features all over", [=] { return with_noise(triangle_sphere(level - 1), 0.1); }, "--features 20"}};
}

double processor_seconds_of_children()
{
  rusage usage;
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

class Sweep
{
public:
  // The reference mesh is the file, or a rough sphere if it is empty.
  Sweep(const std::string& reference, double limit, const std::string& options)
    : limit_(limit), options_(options), reference_(reference)
  {
    if (!reference_.empty())
      return;
    const Soup sphere = generated::with_noise(generated::triangle_sphere(6), 0.001);
    directory_.write("reference.off", mesh_files::off(sphere));
    reference_ = "reference.off";
    reference_faces_ = sphere.polygons.size();
    reference_vertices_ = 1200;
  }

  // A run of a random mesh is repeated if it takes long, because another process may have disturbed it, and printed only if it
  // takes long again.
  void run(const std::string& name, const Soup& soup, std::size_t number, const std::string& options, bool is_random)
  {
    directory_.write("in.off", mesh_files::off(soup));
    const double limit = 0.1 + limit_ * reference_seconds_a_face(options) * double(soup.polygons.size());
    auto outcome = time("in.off", options, number, limit);
    for (int repetitions = 0; is_random && outcome.second > 0.8 * limit && repetitions < 2; ++repetitions)
      outcome.second = (std::min)(outcome.second, time("in.off", options, number, limit).second);
    const double part = outcome.second / limit;
    const bool failed = part > 1;
    failures_ += failed;
    ++runs_;
    worst_ = (std::max)(worst_, part);
    if (is_random && part < 0.8)
      return;
    std::cout << std::left << std::setw(30) << name << std::right << std::setw(8) << soup.polygons.size() << " faces "
              << std::setw(7) << number << " " << std::setw(8)
              << (outcome.first == 0 ? "done" : outcome.first == 1 ? "refused" : "ended") << std::fixed << std::setprecision(2)
              << std::setw(9) << outcome.second << " s " << std::setw(8) << part << " of the limit  " << options
              << (failed ? "  TOO LONG" : "") << std::endl;
  }

  bool finish() const
  {
    std::cout << runs_ << " runs, " << failures_ << " longer than the limit; the longest took " << worst_ << " of it"
              << std::endl;
    return failures_ == 0;
  }

private:
  double reference_seconds_a_face(const std::string& options)
  {
    const auto known = seconds_a_face_.find(options);
    if (known != seconds_a_face_.end())
      return known->second;
    const auto outcome = time("'" + reference_ + "'", options, reference_vertices_, 300);
    if (outcome.first != 0)
      throw std::runtime_error("the tool does not coarsen the reference mesh " + reference_ + " " + options);
    const double seconds = outcome.second / double(reference_faces_);
    std::cout << "reference: " << 1e6 * seconds << " microseconds a face  " << options << std::endl;
    return seconds_a_face_[options] = seconds;
  }

  // The status and the processor time of a run. Ends runs far beyond the limit.
  std::pair<int, double> time(const std::string& input, const std::string& options, std::size_t number, double limit)
  {
    const double before = processor_seconds_of_children();
    const unsigned most = unsigned((std::min)(600., 2 * limit + 2));
    const std::string arguments =
      input + " out.off --quiet --force " + options_ + " " + options + " -n " + std::to_string(number);
    const test::Tool_outcome outcome =
      test::Tool_process(directory_.path(), arguments, "ulimit -c 0; ulimit -t " + std::to_string(most))
        .wait(std::chrono::seconds(3600));
    return {outcome.status, processor_seconds_of_children() - before};
  }

  const double limit_;
  const std::string options_; // of the tool, for all runs
  test::Tool_directory directory_;
  std::string reference_;
  std::size_t reference_faces_ = 96966, reference_vertices_ = 1579; // of the horse
  std::map<std::string, double> seconds_a_face_;                    // of the reference mesh, with these options
  double worst_ = 0;
  std::size_t runs_ = 0, failures_ = 0;
};

Options read_options(int argc, char** argv)
{
  namespace po = boost::program_options;
  Options options;
  po::options_description described("usage: sweep_times [OPTIONS]\noptions");
  described.add_options()("help", "print this and exit")(
    "reference", po::value(&options.reference), "the horse, of 96,966 faces")(
    "limit", po::value(&options.limit)->default_value(options.limit), "times the reference's time for each face")(
    "only", po::value(&options.only), "meshes with this in their names")(
    "options", po::value(&options.tool_options), "options of the tool, for all runs")(
    "random", po::value(&options.random_meshes), "so many random meshes instead of the difficult ones")(
    "seed", po::value(&options.seed)->default_value(options.seed), "of the random meshes")(
    "quick", po::bool_switch(&options.quick), "small meshes");
  po::variables_map map;
  po::store(po::parse_command_line(argc, argv, described), map);
  po::notify(map);
  if (map.count("help") != 0) {
    std::cout << described;
    std::exit(0);
  }
  return options;
}

void run_difficult_meshes(const Options& options, Sweep& sweep)
{
  for (const Hard_mesh& mesh : hard_meshes(options.quick)) {
    if (mesh.name.find(options.only) == std::string::npos)
      continue;
    const Soup soup = mesh.make();
    for (const double share : {0.01, 0.1, 0.35}) {
      const std::size_t number = std::size_t(share * double(soup.points.size()));
      if (number >= 4)
        sweep.run(mesh.name, soup, number, mesh.options, false);
    }
  }
}

void run_random_meshes(const Options& options, Sweep& sweep)
{
  for (std::size_t i = 0; i < options.random_meshes; ++i) {
    attack::Random random(options.seed, i);
    const Soup soup = attack::random_mesh(random);
    const std::size_t number = 1 + random.below(soup.points.size());
    for (const std::string also : {"", "--features 40", "--repair", "--maximum-distance 0.01"})
      sweep.run("random mesh " + std::to_string(i), soup, number, also, true);
  }
}

} // namespace

int main(int argc, char** argv)
try {
  const Options options = read_options(argc, argv);
  if (!std::getenv("COARSEN_MESH"))
    throw std::runtime_error("the environment variable COARSEN_MESH does not name the tool");
  Sweep sweep(options.reference.empty() ? "" : std::filesystem::absolute(options.reference).string(), options.limit,
              options.tool_options);
  options.random_meshes > 0 ? run_random_meshes(options, sweep) : run_difficult_meshes(options, sweep);
  return sweep.finish() ? 0 : 1;
} catch (const std::exception& e) {
  std::cerr << "sweep_times: " << e.what() << std::endl;
  return 2;
}
