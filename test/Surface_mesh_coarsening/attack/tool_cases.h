// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_ATTACK_TOOL_CASES_H
#define CGAL_SURFACE_MESH_COARSENING_ATTACK_TOOL_CASES_H

#include "Case_directory.h"
#include "Random.h"
#include "mutate_file.h"
#include "random_mesh.h"
#include "read_result.h"

#include "support/Reference_mesh.h"
#include "support/generate_meshes.h"
#include "support/mesh_files.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <exception>
#include <string>
#include <thread>

// Cases in which the tool runs as a process.
namespace attack {

inline std::string random_type(Random& random) { return random.pick({"off", "obj", "ply", "stl"}); }

// Returns the nearest number of vertices that a refusal names; 0 if it names none.
inline std::size_t nearest_number(const test::Tool_outcome& outcome)
{
  const std::string lead = "nearest number that works: ";
  const std::size_t found = outcome.err.find(lead);
  return found == std::string::npos ? 0 : std::stoul(outcome.err.substr(found + lead.size()));
}

// Runs the tool for a number of vertices, and once more for the nearest one if it is refused. Returns whether `output` holds
// a result, which then has that number.
inline bool run_for_number(const Case_directory& directory, const std::string& files, const std::string& output,
                           const std::string& options, std::size_t number, Result& result)
{
  test::Tool_outcome outcome = directory.run(files + options + " -n " + std::to_string(number));
  if (outcome.status != 0) {
    check_failure(directory, outcome);
    number = nearest_number(outcome);
    if (number == 0)
      return false;
    outcome = directory.run(files + options + " -n " + std::to_string(number));
    if (outcome.status != 0) {
      check_failure(directory, outcome);
      require(outcome.names("cannot be written"), "the nearest number does not work: " + outcome.err); // in that format
      return false;
    }
  }
  result = read_result(directory / output);
  require(result.vertices == number,
          output + " has " + std::to_string(result.vertices) + " vertices, not " + std::to_string(number));
  return true;
}

// A file of any format with a few changes of its bytes.
inline void malformed_file(Case_directory& directory, Random& random)
{
  generated::Soup soup = random_mesh(random);
  if (random.one_in(2))
    soup = generated::triangulated(soup);
  auto forms = mesh_files::all_forms(generated::triangulated(soup));
  const std::size_t chosen = random.below(forms.size());
  if (forms[chosen].first != "stl")
    forms = mesh_files::all_forms(soup); // STL files have triangles alone
  std::string file = forms[chosen].second;
  for (std::size_t changes = random.below(5); changes > 0; --changes)
    mutate(file, random);
  directory.write("in." + forms[chosen].first, file);
  const std::string output = "out." + random_type(random);
  std::string options = " --rounds 20 --placement " + random.pick<std::string>({"centroid", "quadric", "fitted"});
  if (random.one_in(4))
    options += " --repair";
  Result result;
  run_for_number(directory, "in." + forms[chosen].first + " " + output, output, options, 1 + random.below(soup.points.size() + 2),
                 result);
}

// Options other than the number of vertices.
inline std::string random_options(Random& random)
{
  std::string options;
  const auto maybe = [&](std::size_t n, const std::string& option) {
    if (random.one_in(n))
      options += " " + option;
  };
  const auto number = [&](double low, double high) { return std::to_string(random.between(low, high)); };
  maybe(2, "--weight " + random.pick<std::string>({"uniform", "area", "maximum", "exact-maximum", "variance"}));
  maybe(2, "--placement " + random.pick<std::string>({"centroid", "closest-vertex", "quadric", "fitted"}));
  maybe(3, "--maximum-density " + number(1, 100));
  maybe(3, "--rounds " + std::to_string(random.below(40)));
  maybe(4, "--features " + std::to_string(random.below(181)));
  maybe(6, "--subdivide");
  maybe(6, "--measure");
  maybe(8, "--repair");
  maybe(10, "--fill-holes " + number(0, 20));
  maybe(10, "--minimum-component-area " + number(0, 20));
  maybe(4, "--threads " + std::to_string(1 + random.below(4)));
  maybe(4, "--quiet");
  maybe(3, "--report report.json");
  maybe(4, "--clusters clusters.ply");
  maybe(20, "--picture picture.png");
  return options;
}

inline bool has(const std::string& options, const std::string& option) { return options.find(option) != std::string::npos; }

// All requested files exist, and no others.
inline void check_results(const Case_directory& directory, const std::string& options, const generated::Soup& soup)
{
  std::size_t expected = 1;
  const bool is_as_given = !has(options, "--repair") && !has(options, "--fill-holes");
  if (has(options, "--report")) {
    ++expected;
    const auto report = nlohmann::json::parse(test::content_of(directory / "report.json"), nullptr, false);
    require(!report.is_discarded() && report.is_object(), "the report is no JSON");
  }
  if (has(options, "--clusters")) {
    ++expected;
    const std::size_t faces = read_soup(directory / "clusters.ply").polygons.size();
    require(!is_as_given || faces == soup.polygons.size(), "the file of clusters has " + std::to_string(faces) + " faces");
  }
  expected += has(options, "--picture");
  require(directory.results().size() == expected, "there are " + std::to_string(directory.results().size()) + " files");
}

// Returns a number of vertices up to somewhat more than the points, near all of them in one of four cases.
inline std::size_t random_number(const generated::Soup& soup, Random& random)
{
  const std::size_t points = soup.points.size();
  return random.one_in(4) ? points + 2 - random.below((std::min)(points + 2, std::size_t(8))) : 1 + random.below(points + 2);
}

// Any options with a mesh that is a surface.
inline void option_combination(Case_directory& directory, Random& random)
{
  const generated::Soup soup = random_mesh(random);
  const std::string input = random.pick<std::string>({"off", "obj", "ply"}), output = "out." + random_type(random);
  for (const auto& form : mesh_files::all_forms(soup))
    if (form.first == input) {
      directory.write("in." + input, form.second);
      break;
    }
  const std::string files = "in." + input + " " + output, options = random_options(random);
  Result result;
  if (random.one_in(5)) {
    const std::string target = random.one_in(2) ? " -k " + std::to_string(random.below(10))
                                                : " --maximum-distance " + std::to_string(random.between(1e-3, 0.5));
    const test::Tool_outcome outcome = directory.run(files + options + target);
    if (outcome.status != 0)
      return check_failure(directory, outcome);
    result = read_result(directory / output);
  } else if (!run_for_number(directory, files, output, options, random_number(soup, random), result)) {
    return;
  }
  check_results(directory, options, soup);
  if (!has(options, "--fill-holes") && !has(options, "--minimum-component-area") && !has(options, "--repair"))
    require(result.topologies == topologies(reference::Reference_mesh(soup).topologies()), "the topology has changed");
}

// A signal at any time ends the tool quickly, and leaves no file unless all work was done.
inline void signal_at_any_time(Case_directory& directory, Random& random)
{
  directory.write("in.off", mesh_files::off(generated::triangle_sphere(5)));
  const int signal = random.pick({SIGINT, SIGTERM, SIGHUP});
  const std::string options = random.one_in(2) ? " --clusters clusters.ply --report report.json" : "";
  test::Tool_process tool =
    directory.start("in.off out.off -n " + std::to_string(50 + random.below(4000)) + " --threads 2" + options);
  std::this_thread::sleep_for(std::chrono::milliseconds(random.below(random.pick({20, 200, 1500}))));
  tool.send(signal);
  const test::Tool_outcome outcome = tool.wait(std::chrono::seconds(20));
  require(outcome.status == 0 || outcome.status == 128 + signal,
          "status " + std::to_string(outcome.status) + " after signal " + std::to_string(signal) + ": " + outcome.err);
  if (outcome.status == 0)
    read_result(directory / "out.off");
  else
    require(directory.results().empty(), "a file was left after signal " + std::to_string(signal));
}

// The bytes of the results on one thread and on several.
inline void thread_counts(Case_directory& directory, Random& random)
{
  generated::Soup soup =
    generated::with_noise(generated::triangle_sphere(4 + unsigned(random.below(2))), random.between(0, 0.03));
  if (random.one_in(3))
    soup = generated::with_holes(soup, random.below(20));
  directory.write("in.ply", mesh_files::binary_ply(soup, false));
  const std::string arguments = "in.ply out.ply --clusters clusters.ply -n " + std::to_string(20 + random.below(1500)) +
                                " --weight " +
                                random.pick<std::string>({"uniform", "area", "maximum", "exact-maximum", "variance"});
  const auto results_of = [&](std::size_t threads) {
    directory.remove_results();
    const test::Tool_outcome outcome = directory.run(arguments + " --threads " + std::to_string(threads));
    require(outcome.status == 0 || outcome.status == 1, "status " + std::to_string(outcome.status) + ": " + outcome.err);
    return outcome.status == 0 ? test::content_of(directory / "out.ply") + test::content_of(directory / "clusters.ply")
                               : outcome.err;
  };
  require(results_of(1) == results_of(2 + random.below(7)), "several threads give other bytes");
}

} // namespace attack

#endif // CGAL_SURFACE_MESH_COARSENING_ATTACK_TOOL_CASES_H
