// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs table 1 of the paper on the models that are found, with the method of the paper, and draws the figures 1 to 7. Each cell has
// the number of the paper before the number measured here.

#include "check/certificate.h"
#include "io/Failure.h"
#include "Paper_model.h"
#include "figures.h"
#include "run_clustering.h"
#include "sketches.h"

#include <boost/program_options.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
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
                          "draw the figures 1 to 7 of the paper into this directory")("help", "print this text");
  all.add(described).add_options()("places", po::value(&options.places));
  po::variables_map values;
  po::positional_options_description positional;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional.add("places", -1)).run(), values);
  po::notify(values);
  if (values.count("help")) {
    std::cout << "Usage: reproduce_paper [options] [FILE | DIRECTORY]...\n\n"
                 "Runs table 1 of the paper. Its models are looked for among the files and in the directories:\n"
                 "fandisk, bunny, horse, dragon_vrip or dragon, as .off, .obj, .ply or .stl; the Cube is generated.\n\n"
              << described;
    return std::nullopt;
  }
  return options;
}

// A model with the run of each of the paper's weights.
struct Column
{
  const Paper_model* model;
  std::size_t vertices;
  std::size_t seeds_in_breadth_first_order;
  std::pair<std::size_t, std::size_t> seeds_in_random_orders;
  std::size_t components_with_clusters_beyond_seeds;
  double deviation_after_growth, deviation_after_merging; // of the areas of clusters
  std::vector<Clustering_run> runs;
};

// A row of the table: a title, and a cell for each model.
template <class Cell>
void print_row(const std::string& title, const std::vector<Column>& columns, const Cell& cell)
{
  std::printf("%-29s", title.c_str());
  for (const Column& column : columns)
    std::printf(" | %17s", cell(column).c_str());
  std::printf("\n");
}

template <class... Arguments>
std::string formatted(const char* format, Arguments... arguments)
{
  char text[64];
  std::snprintf(text, sizeof text, format, arguments...);
  return text;
}

// Table 1 as it is printed, each cell with the paper's number and ours. The times are defined as in the paper: seeding, and
// then growth and minimization. Neither seems to include densities there.
void print_table(const std::vector<Column>& columns)
{
  print_row("paper / here", columns, [](const Column& c) { return c.model->name; });
  print_row("vertices", columns, [](const Column& c) { return formatted("%zu / %zu", c.model->vertices, c.vertices); });
  print_row("k (level)", columns, [](const Column& c) { return formatted("%u", c.model->level); });
  print_row("seeds (obtained)", columns,
            [](const Column& c) { return formatted("%zu / %zu", c.model->seeds, c.runs[AREA].report.seeds); });
  print_row("initialization, s", columns, [](const Column& c) {
    return formatted("%s / %.3f", c.model->seeding_seconds.c_str(), c.runs[AREA].times.sum({"seeding"}));
  });
  for (const Paper_weight w : paper_weights) {
    const std::string weight = weight_names[w];
    print_row("clustering, " + weight + ": r_new", columns,
              [&](const Column& c) { return formatted("%g", c.model->maximum_density[w]); });
    print_row("  s", columns, [&](const Column& c) {
      return formatted("%g / %.3f", c.model->seconds[w], c.runs[w].times.sum({"growth", "minimization"}));
    });
  }
  std::printf("\nnot in the paper:\n");
  print_row("seeds, breadth-first", columns, [](const Column& c) { return formatted("%zu", c.seeds_in_breadth_first_order); });
  print_row("seeds in random orders", columns, [](const Column& c) {
    return formatted("%zu - %zu", c.seeds_in_random_orders.first, c.seeds_in_random_orders.second);
  });
  print_row("clusters beyond the seeds", columns, [](const Column& c) {
    return formatted("%ld", long(c.runs[AREA].report.clusters) - long(c.runs[AREA].report.seeds));
  });
  print_row("  number of components", columns,
            [](const Column& c) { return formatted("%zu", c.components_with_clusters_beyond_seeds); });
  print_row("splits + merges after growth", columns,
            [](const Column& c) { return formatted("%zu + %zu", c.runs[AREA].report.splits, c.runs[AREA].report.merges); });
  print_row("deviation of areas, grown", columns, [](const Column& c) { return formatted("%.3f", c.deviation_after_growth); });
  print_row("  merged to half the seeds", columns, [](const Column& c) { return formatted("%.3f", c.deviation_after_merging); });
  for (const Paper_weight w : paper_weights) {
    print_row(std::string(weight_names[w]) + ": rounds", columns,
              [&](const Column& c) { return formatted("%zu", c.runs[w].report.rounds); });
    print_row("  moves", columns, [&](const Column& c) { return formatted("%zu", c.runs[w].report.moves); });
    print_row("  refused by the paper", columns,
              [&](const Column& c) { return formatted("%zu", c.runs[w].report.refused_by_boundary_counts); });
    print_row("  refused by us alone", columns,
              [&](const Column& c) { return formatted("%zu", c.runs[w].report.refused_by_guarantee); });
  }
}

bool is_good(const Paper_model& model, const Mesh& mesh, Paper_weight weight, const Clustering_run& run)
{
  auto fault = triangle_mesh_fault(run.dual);
  if (!fault)
    fault = certify(mesh, run.labels, run.dual, run.report.subdivided_components == 0).change();
  if (fault)
    std::printf("%s, %s: %s\n", model.name.c_str(), weight_names[weight], fault->c_str());
  return !fault;
}

// Returns whether everything that was found could be done and is valid.
bool reproduce(const Paper_model& model, const Options& options, std::vector<Column>& columns)
{
  std::string file;
  if (!model.files.empty()) {
    const auto found = find_model(model, options.places);
    if (!found) {
      std::printf("%s not found, skipped\n", model.name.c_str());
      return true;
    }
    file = *found;
  }
  const Mesh mesh = load_model(model, file);
  bool good = true;
  Column column{&model,
                mesh.number_of_vertices(),
                seeds_in_breadth_first_order(mesh, model.level),
                seeds_in_random_orders(mesh, model.level),
                0,
                0,
                0,
                {}};
  for (const Paper_weight weight : paper_weights) {
    column.runs.push_back(run_clustering(mesh, model.level, weight, model.maximum_density[weight]));
    good = is_good(model, mesh, weight, column.runs.back()) && good;
  }
  column.components_with_clusters_beyond_seeds = components_with_clusters_beyond_seeds(mesh, column.runs[AREA]);
  column.deviation_after_growth = deviation_of_areas(mesh, column.runs[AREA].labels_after_growth);
  column.deviation_after_merging = deviation_of_areas_after_merging(mesh, model.level);
  if (!options.figures.empty())
    for (const std::string& written : write_figures(model, mesh, column.runs, options.figures))
      std::printf("%s drawn: %s\n", model.name.c_str(), written.c_str());
  columns.push_back(std::move(column));
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
  if (!options->figures.empty()) {
    std::filesystem::create_directories(options->figures);
    for (const std::string& written : write_sketches(options->figures))
      std::printf("sketch drawn: %s\n", written.c_str());
  }
  bool good = true;
  std::vector<Column> columns;
  for (const Paper_model& model : paper_models())
    try {
      good = reproduce(model, *options, columns) && good;
    } catch (const std::exception& e) {
      std::printf("%s failed: %s\n", model.name.c_str(), one_line(e.what()).c_str());
      good = false;
    }
  print_table(columns);
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
