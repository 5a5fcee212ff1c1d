// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs Table 1 of the paper on the models that are found, and draws its figures 5, 6 and 7.

#include "check/certificate.h"
#include "io/Failure.h"
#include "Paper_model.h"
#include "figures.h"
#include "run_clustering.h"

#include <boost/program_options.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace reproduce_paper {
namespace {

struct Options
{
  std::vector<std::string> places;
  std::string figures;
};

std::optional<Options> read_options(int argc, char* argv[])
{
  namespace po = boost::program_options;
  Options options;
  po::options_description described("Options"), all;
  described.add_options()("figures", po::value(&options.figures)->value_name("DIRECTORY"),
                          "draw figures 5, 6 and 7 of the paper into this directory")("help", "print this text");
  all.add(described).add_options()("places", po::value(&options.places));
  po::variables_map values;
  po::positional_options_description positional;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional.add("places", -1)).run(), values);
  po::notify(values);
  if (values.count("help")) {
    std::cout << "Usage: reproduce_paper [options] [FILE | DIRECTORY]...\n\n"
                 "Runs Table 1 of the paper. Its models are looked for among the files and in the directories:\n"
                 "fandisk, bunny, horse, dragon_vrip or dragon, as .off, .obj, .ply or .stl; the Cube is generated.\n\n"
              << described;
    return std::nullopt;
  }
  return options;
}

void print_heading()
{
  std::printf("%-8s %8s %2s | %6s %6s | %6s %8s | %-8s %5s | %6s %8s | %8s %6s %s\n", "", "", "", "seeds", "seeds",
              "seeding", "seeding", "", "", "time", "time", "", "", "");
  std::printf("%-8s %8s %2s | %6s %6s | %6s %8s | %-8s %5s | %6s %8s | %8s %6s %s\n", "model", "vertices", "k", "paper",
              "ours", "paper", "ours", "weight", "r_new", "paper", "ours", "clusters", "rounds", "dual");
}

// The times are defined as in the paper: seeding, and then growth and minimization. Neither seems to include densities
// there.
bool print_row(const Paper_model& model, const Mesh& mesh, Paper_weight weight, const Clustering_run& run)
{
  const auto fault = triangle_mesh_fault(run.dual);
  const bool kept = !fault && certify(mesh, run.labels, run.dual).kept();
  std::printf("%-8s %8zu %2u | %6zu %6zu | %4s s %6.3f s | %-8s %5g | %4g s %6.3f s | %8zu %6zu %s\n",
              model.name.c_str(), static_cast<std::size_t>(mesh.number_of_vertices()), model.level, model.seeds,
              run.report.seeds, model.seeding_seconds.c_str(), run.times.sum({"seeding"}), weight_names[weight],
              model.maximum_density[weight], model.seconds[weight], run.times.sum({"growth", "minimization"}),
              run.report.clusters, run.report.rounds,
              fault  ? fault->c_str()
              : kept ? "valid, topology kept"
                     : "valid, topology changed");
  std::fflush(stdout);
  return kept;
}

// Returns whether all models found were processed with valid results.
bool reproduce(const Paper_model& model, const Options& options)
{
  std::string file;
  if (!model.files.empty()) {
    const auto found = find_model(model, options.places);
    if (!found) {
      std::printf("%-8s not found, skipped\n", model.name.c_str());
      return true;
    }
    file = *found;
  }
  const Mesh mesh = load_model(model, file);
  if (mesh.number_of_vertices() != model.vertices)
    std::printf("%-8s has %zu vertices here, %zu in the paper\n", model.name.c_str(),
                static_cast<std::size_t>(mesh.number_of_vertices()), model.vertices);
  bool good = true;
  std::vector<Clustering_run> runs;
  for (Paper_weight weight : paper_weights) {
    runs.push_back(run_clustering(mesh, model.level, weight, model.maximum_density[weight]));
    good = print_row(model, mesh, weight, runs.back()) && good;
  }
  if (!options.figures.empty())
    for (const std::string& written : write_figures(model, mesh, runs, options.figures))
      std::printf("%-8s drawn: %s\n", model.name.c_str(), written.c_str());
  return good;
}

int run(int argc, char* argv[])
{
  std::optional<Options> options;
  try {
    options = read_options(argc, argv);
  } catch (const boost::program_options::error& e) {
    std::cerr << "reproduce_paper: " << e.what() << " (see reproduce_paper --help)" << std::endl;
    return 2;
  }
  if (!options)
    return 0;
  if (!options->figures.empty())
    std::filesystem::create_directories(options->figures);
  print_heading();
  bool good = true;
  for (const Paper_model& model : paper_models())
    try {
      good = reproduce(model, *options) && good;
    } catch (const std::exception& e) {
      std::printf("%-8s failed: %s\n", model.name.c_str(), one_line(e.what()).c_str());
      good = false;
    }
  return good ? 0 : 1;
}

} // namespace
} // namespace reproduce_paper

int main(int argc, char* argv[])
{
  try {
    return reproduce_paper::run(argc, argv);
  } catch (const std::exception& e) {
    std::cerr << "reproduce_paper: " << coarsening_support::one_line(e.what()) << std::endl;
    return 1;
  }
}
