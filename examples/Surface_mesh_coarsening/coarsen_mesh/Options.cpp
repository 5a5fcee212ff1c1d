// SPDX-License-Identifier: GPL-3.0-or-later

#include "Options.h"

#include "io/Descriptor.h"
#include "io/assimp_formats.h"
#include "io/file_type.h"
#include "io/same_file.h"
#include "coarsening.h"
#include "described_options.h"

#include <CGAL/Surface_mesh_coarsening/version.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>
#include <sstream>
#include <system_error>
#include <vector>

namespace coarsen_mesh_tool {
namespace {

namespace po = boost::program_options;

// Parses numbers itself: the stream operators behind Boost.Program_options accept "-1" as an unsigned number.
std::size_t to_count(const std::string& option, const std::string& text, std::size_t least, std::size_t most)
{
  std::size_t value = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end || value < least || value > most)
    throw Wrong_usage("--" + option + " takes a whole number from " + std::to_string(least) +
                      (most < (std::numeric_limits<unsigned>::max)() ? " to " + std::to_string(most) : " on") + ", not '" + text +
                      "'");
  return value;
}

std::optional<double> to_number(const std::string& text)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value))
    return std::nullopt;
  return value;
}

double to_size(const std::string& option, const std::string& text)
{
  const double value = to_number(text).value_or(-1);
  if (!(value >= 0))
    throw Wrong_usage("--" + option + " takes a number from 0 on, not '" + text + "'");
  return value;
}

double to_positive(const std::string& option, const std::string& text)
{
  const double value = to_size(option, text);
  if (!(value > 0))
    throw Wrong_usage("--" + option + " takes a number greater than 0, not '" + text + "'");
  return value;
}

double to_density(const std::string& option, const std::string& text)
{
  const double value = to_number(text).value_or(0);
  if (!(value >= 1 && value <= 1e20))
    throw Wrong_usage("--" + option + " takes a number from 1 to 1e20, not '" + text + "'");
  return value;
}

Vector to_direction(const std::string& option, const std::string& text)
{
  std::vector<double> coordinates;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');)
    if (const auto value = to_number(part))
      coordinates.push_back(*value);
    else
      coordinates.resize(4); // is refused below
  if (coordinates.size() == 3 && text.back() != ',') {
    const double largest = (std::max)({std::abs(coordinates[0]), std::abs(coordinates[1]), std::abs(coordinates[2])});
    if (largest > 0)
      return Vector(coordinates[0] / largest, coordinates[1] / largest, coordinates[2] / largest);
  }
  throw Wrong_usage("--" + option + " takes a direction X,Y,Z that is not zero, not '" + text + "'");
}

void check_choice(const std::string& option, const std::string& value, const std::vector<std::string>& names)
{
  if (std::find(names.begin(), names.end(), value) == names.end())
    throw Wrong_usage("--" + option + " is one of " + joined(names) + ", not '" + value + "'");
}

// A length, a part of the diagonal in percent, or "all".
void read_hole_length(const std::string& text, Options& options)
{
  options.hole_length_is_relative = !text.empty() && text.back() == '%';
  options.fill_holes = text == "all" ? std::numeric_limits<double>::infinity() : -1;
  if (const auto number = to_number(options.hole_length_is_relative ? text.substr(0, text.size() - 1) : text))
    options.fill_holes = options.hole_length_is_relative ? *number / 100 : *number;
  if (!(options.fill_holes >= 0))
    throw Wrong_usage("--fill-holes takes a length from 0 on, one in percent of the diagonal, or all, not '" + text + "'");
}

// A number, or a part of the input's in percent.
void read_vertices(const std::string& text, Options& options)
{
  if (text.empty() || text.back() != '%') {
    options.vertices = to_count("vertices", text, 1, (std::numeric_limits<std::size_t>::max)());
    return;
  }
  const double percent = to_number(text.substr(0, text.size() - 1)).value_or(0);
  if (!(percent > 0))
    throw Wrong_usage("--vertices takes a whole number from 1 on, or more than 0%, not '" + text + "'");
  options.vertex_ratio = percent / 100;
}

// Of --vertices, --neighborhood-level and the distances one has to be given.
void check_number(const Options& options)
{
  const bool has_number = options.vertices || options.vertex_ratio;
  if (options.vertex_ratio && options.neighborhood_level)
    throw Wrong_usage("--neighborhood-level goes with a whole number of --vertices, not with a part");
  if (options.faces && (has_number || options.neighborhood_level || options.maximum_distance))
    throw Wrong_usage("--faces excludes --vertices, --neighborhood-level and --maximum-distance");
  if (options.keep_small && (!options.vertex_ratio || options.maximum_distance))
    throw Wrong_usage("--keep-small goes with --vertices P%");
  if (!has_number && !options.faces && !options.neighborhood_level && !options.maximum_distance && !options.asks_range)
    throw Wrong_usage("how many vertices? Give --vertices N, --vertices P%, --faces N, --maximum-distance D or "
                      "--neighborhood-level K; --range prints the possible numbers for INPUT");
}

// Returns the view (1, 0.5, 0.8) of a model with vertical y axis, rotated with the model by the shortest rotation from the
// y axis to `up`.
Vector default_view(const Vector& up)
{
  const Vector view(1, 0.5, 0.8), y(0, 1, 0), u = up / std::sqrt(up.squared_length());
  const double cosine = u * y;
  if (cosine < -1 + 1e-12) // half a turn around the x axis
    return Vector(view.x(), -view.y(), -view.z());
  const Vector axis = CGAL::cross_product(y, u);
  return cosine * view + CGAL::cross_product(axis, view) + (axis * view) / (1 + cosine) * axis;
}

void check_types(const Options& options)
{
  for (const std::string& file : {options.input, options.output}) {
    const std::string place = file == options.input ? "INPUT" : "OUTPUT";
    if (options.asks_range && place == "OUTPUT")
      continue;
    if (file == standard_stream && options.format.empty())
      throw Wrong_usage(place + " is -, which needs --format");
    const std::string type = type_of(options, file);
    if (!is_own_file_type(type) && !(place == "INPUT" ? assimp_reads(type) : assimp_writes(type)))
      throw Wrong_usage((file == standard_stream ? "--format is one of off, obj, ply, stl, not '" + options.format + "'"
                                                 : place + " must be an .off, .obj, .ply or .stl file, not '" + file + "'") +
                        assimp_hint(type));
  }
  if (!options.clusters.empty() && file_type(options.clusters) != "ply")
    throw Wrong_usage("--clusters takes a .ply file, not '" + options.clusters + "'");
  if (!options.picture.empty() && file_type(options.picture) != "png")
    throw Wrong_usage("--picture takes a .png file, not '" + options.picture + "'");
  if (options.output == standard_stream && options.levels > 0)
    throw Wrong_usage("--levels needs files, and OUTPUT is -");
}

// The files that are written beside the output.
std::vector<std::string> files_beside_output(const Options& options)
{
  std::vector<std::string> files = {options.clusters, options.picture, options.report};
  for (std::size_t i = 1; i <= options.levels; ++i)
    files.push_back(level_file(options.output, i));
  files.erase(std::remove(files.begin(), files.end(), ""), files.end());
  return files;
}

void check_that_files_differ(const std::string& one, const std::string& other)
{
  if (is_same_file(one, other))
    throw Wrong_usage("'" + one + "'" + (one == other ? " is named twice" : " and '" + other + "' are one file"));
}

// OUTPUT replaces its own input only on request.
void check_that_input_stays(const Options& options)
{
  if (!options.force && !options.asks_range && options.input != standard_stream && options.output != standard_stream &&
      is_same_file(options.input, options.output))
    throw Wrong_usage("OUTPUT '" + options.output + "' is INPUT, which is replaced only with --force");
}

void check_files(const std::vector<Options>& all)
{
  std::vector<std::string> inputs, written;
  for (const Options& options : all) {
    check_types(options);
    check_that_input_stays(options);
    for (const std::string& file : files_beside_output(options)) {
      for (const std::string& other : written)
        check_that_files_differ(file, other);
      for (const std::string& other : {options.input, options.output})
        if (other != standard_stream || file == standard_stream)
          check_that_files_differ(file, other);
      written.push_back(file);
    }
    for (const std::string& other : written)
      check_that_files_differ(options.output, other);
    for (const std::string& other : inputs)
      check_that_files_differ(options.output, other);
    for (const std::string& other : written)
      if (options.input != standard_stream)
        check_that_files_differ(options.input, other);
    inputs.push_back(options.input);
    written.push_back(options.output);
  }
}

// The defaults that the article has.
void choose_as_in_paper(const po::variables_map& values, Options& options)
{
  if (values["placement"].defaulted())
    options.placement = "centroid";
  if (values["maximum-density"].defaulted())
    options.maximum_density = options.weight == "variance" ? 3 : 50;
  if (values["convergence-tolerance"].defaulted())
    options.convergence_tolerance = 0;
  if (values["error-feedback"].defaulted())
    options.error_feedback = 0;
}

// Returns whether the option was given, also for options with a default.
std::optional<std::string> given(const po::variables_map& values, const std::string& option)
{
  const auto found = values.find(option);
  return found == values.end() ? std::nullopt : std::optional<std::string>(found->second.as<std::string>());
}

void read_size(const po::variables_map& values, Options& options)
{
  const std::size_t any = (std::numeric_limits<std::size_t>::max)();
  options.asks_range = values.count("range") > 0;
  if (const auto text = given(values, "vertices"))
    read_vertices(*text, options);
  if (const auto text = given(values, "faces"))
    options.faces = to_count("faces", *text, 1, any);
  options.keep_small = values.count("keep-small") > 0;
  if (const auto text = given(values, "neighborhood-level"))
    options.neighborhood_level = static_cast<unsigned>(to_count("neighborhood-level", *text, 0, 1000000));
  for (const char* option : {"maximum-distance", "maximum-distance-absolute"})
    if (const auto text = given(values, option)) {
      if (options.neighborhood_level || options.maximum_distance)
        throw Wrong_usage(std::string("--") + option + " excludes --neighborhood-level and the other distance");
      options.maximum_distance = to_positive(option, *text);
      options.distance_is_relative = option == std::string("maximum-distance");
    }
  options.levels = to_count("levels", *given(values, "levels"), 0, 30);
  if (options.levels > 0 && options.maximum_distance)
    throw Wrong_usage("--levels needs a number of vertices, and no maximum distance");
  options.subdivide = values.count("subdivide") > 0;
}

void read_method(const po::variables_map& values, Options& options)
{
  const std::size_t any = (std::numeric_limits<std::size_t>::max)();
  if (const auto text = given(values, "rounds"))
    options.rounds = to_count("rounds", *text, 0, any);
  options.convergence_tolerance = to_size("convergence-tolerance", *given(values, "convergence-tolerance"));
  options.paper = values.count("paper") > 0;
  options.energy = *given(values, "energy");
  check_choice("energy", options.energy, energy_names());
  if (options.energy != default_energy() && !values["weight"].defaulted())
    throw Wrong_usage("--weight goes with --energy " + default_energy() + ", not with --energy " + options.energy);
  options.weight = *given(values, "weight");
  check_choice("weight", options.weight, weight_names());
  options.placement = *given(values, "placement");
  check_choice("placement", options.placement, placement_names());
  options.maximum_density = to_density("maximum-density", *given(values, "maximum-density"));
  const std::string angle = *given(values, "angle");
  options.mean_angle = to_size("angle", angle);
  if (options.mean_angle > 60)
    throw Wrong_usage("--angle takes an angle from 0 to 60 degrees, not '" + angle + "'");
  options.error_feedback = to_count("error-feedback", *given(values, "error-feedback"), 0, any);
  if (options.paper)
    choose_as_in_paper(values, options);
  if (!values["angle"].defaulted() && options.placement != default_placement())
    throw Wrong_usage("--angle goes with --placement " + default_placement() + ", not with " + options.placement);
  if (const auto text = given(values, "threads"))
    options.threads = static_cast<unsigned>(to_count("threads", *text, 1, 1000000));
}

void read_kept(const po::variables_map& values, Options& options)
{
  if (const auto text = given(values, "features")) {
    options.features = to_number(*text);
    if (!options.features || !(*options.features >= 0 && *options.features <= 180))
      throw Wrong_usage("--features takes an angle from 0 to 180 degrees, not '" + *text + "'");
  }
  options.patches = given(values, "patches").value_or("");
  options.keep = given(values, "keep").value_or("");
  options.keep_borders = values.count("keep-borders") > 0;
  for (const char* option : {"features", "patches", "keep", "keep-borders"})
    if (values.count(option) && options.levels > 0)
      throw Wrong_usage("--" + std::string(option) + " cannot be combined with --levels");
}

void read_preparation(const po::variables_map& values, Options& options)
{
  if (const auto text = given(values, "weld"))
    options.weld = to_positive("weld", *text);
  options.repair = values.count("repair") > 0 || options.weld > 0;
  if (const auto text = given(values, "fill-holes"))
    read_hole_length(*text, options);
  if (const auto text = given(values, "minimum-component-area"))
    options.minimum_component_area = to_size("minimum-component-area", *text);
}

void read_output(const po::variables_map& values, Options& options)
{
  options.format = lower_case(given(values, "format").value_or(""));
  options.clusters = given(values, "clusters").value_or("");
  options.picture = given(values, "picture").value_or("");
  options.report = given(values, "report").value_or("");
  if (const auto text = given(values, "up"))
    options.up = to_direction("up", *text);
  const auto view = given(values, "view");
  options.view = view ? to_direction("view", *view) : default_view(options.up);
  options.measure = values.count("measure") > 0;
  options.distances = values.count("distances") > 0;
  options.force = values.count("force") > 0;
  options.quiet = values.count("quiet") > 0;
}

Options checked_options(const po::variables_map& values)
{
  Options options;
  read_size(values, options);
  read_method(values, options);
  read_kept(values, options);
  read_preparation(values, options);
  read_output(values, options);
  check_number(options); // last, as other faults are easier to understand
  return options;
}

// The pattern with the input's name without folder and ending for each %, and % for each %%.
std::string matched(const std::string& pattern, const std::string& input)
{
  const std::string name = input == standard_stream ? "stdin" : std::filesystem::path(input).stem().string();
  std::string result;
  for (std::size_t i = 0; i < pattern.size(); ++i)
    if (pattern[i] != '%')
      result += pattern[i];
    else if (i + 1 < pattern.size() && pattern[i + 1] == '%')
      result += pattern[++i];
    else
      result += name;
  return result;
}

// The options for each input: files in a directory are called as the input is.
std::vector<Options> options_of_inputs(Options options, const std::vector<std::string>& files)
{
  if (options.asks_range && files.size() != 1)
    throw Wrong_usage("--range takes INPUT alone");
  if (options.asks_range) {
    options.input = files[0];
    check_files({options});
    return {options};
  }
  if (files.size() < 2)
    throw Wrong_usage("INPUT and OUTPUT are needed");
  const std::string& output = files.back();
  std::error_code error;
  const bool is_directory =
    std::filesystem::is_directory(output, error) && !is_own_file_type(file_type(output)) && !assimp_writes(file_type(output));
  const auto has_room = [&](const std::string& pattern) { return matched(pattern, "a") != matched(pattern, "b"); };
  if (files.size() > 2 && !is_directory && !has_room(output))
    throw Wrong_usage("several inputs need a directory or a pattern such as coarse/%.ply for OUTPUT, not '" + output + "'");
  for (const std::string& file : {options.clusters, options.picture, options.report})
    if (files.size() > 2 && !file.empty() && !has_room(file))
      throw Wrong_usage("several inputs need a pattern such as %." + file_type(file) + ", not '" + file + "'");
  std::vector<Options> result;
  for (std::size_t i = 0; i + 1 < files.size(); ++i) {
    result.push_back(options);
    Options& one = result.back();
    one.input = files[i];
    one.output = is_directory ? (std::filesystem::path(output) / std::filesystem::path(one.input).filename()).string()
                              : matched(output, one.input);
    one.clusters = matched(options.clusters, one.input);
    one.picture = matched(options.picture, one.input);
    one.report = matched(options.report, one.input);
  }
  check_files(result);
  return result;
}

// The arguments, with the angle of --features, which need not be given, tied to the option: what follows is taken for it only if
// it is a number.
std::vector<std::string> arguments(int argc, char* argv[])
{
  std::vector<std::string> result;
  for (int i = 1; i < argc; ++i) {
    result.push_back(argv[i]);
    if (result.back() == "--features")
      result.back() += std::string("=") + (i + 1 < argc && to_number(argv[i + 1]) ? argv[++i] : default_feature_angle);
  }
  return result;
}

} // namespace

std::string type_of(const Options& options, const std::string& file)
{
  return file == standard_stream ? options.format : file_type(file);
}

std::vector<Options> read_options(int argc, char* argv[])
{
  const po::options_description described = described_options();
  po::options_description all;
  all.add(described).add_options()("files", po::value<std::vector<std::string> >());
  po::positional_options_description positional;
  positional.add("files", -1);
  po::variables_map values;
  try {
    const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(arguments(argc, argv)).options(all).positional(positional).style(style).run(), values);
  } catch (const po::error& e) {
    throw Wrong_usage(e.what());
  }
  if (values.count("-h")) {
    print_short_help();
    return {};
  }
  if (values.count("help")) {
    print_help(described);
    return {};
  }
  if (values.count("version")) {
    std::cout << "coarsen_mesh " CGAL_SURFACE_MESH_COARSENING_VERSION "\n";
    return {};
  }
  typedef std::vector<std::string> Names;
  return options_of_inputs(checked_options(values), values.count("files") ? values["files"].as<Names>() : Names());
}

} // namespace coarsen_mesh_tool
