// SPDX-License-Identifier: GPL-3.0-or-later

#include "Options.h"

#include "io/file_type.h"
#include "io/same_file.h"

#include <boost/program_options.hpp>

#include <charconv>
#include <filesystem>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace coarsen_mesh_mpi {
namespace {

namespace po = boost::program_options;

// Reads a whole number from 1 on, which may end with K, M, G or T if it counts bytes.
std::uint64_t to_count(const std::string& option, const std::string& text, std::uint64_t most, bool counts_bytes = false)
{
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  unsigned shift = 0;
  const char* rest = read.ptr;
  if (counts_bytes && rest != end) {
    const std::size_t unit = std::string("KMGT").find(*rest);
    shift = unit == std::string::npos ? 0 : 10 * unsigned(unit + 1);
    rest += unit == std::string::npos ? 0 : 1;
  }
  if (read.ec != std::errc() || rest != end || value == 0 || value > most >> shift)
    throw std::invalid_argument("--" + option + " takes a whole number from 1 on" +
                                (counts_bytes ? ", of bytes or with K, M, G or T," : "") + ", not '" + text + "'");
  return value << shift;
}

po::options_description description()
{
  po::options_description options("Options");
  const auto text = [] { return po::value<std::string>(); };
  options.add_options()
    ("help,h", "show this help")
    ("vertices,n", text()->value_name("N"), "number of vertices of the output")
    ("threads", text()->value_name("T")->default_value("1"), "upper bound for the number of threads of each rank")
    ("placement", text()->value_name("P")->default_value("fitted"),
     "fitted, or quadric: fitted vertices are about twice as close to the input; rank 0 alone fits them")
    ("memory", text()->value_name("M"),
     "memory of each rank, in bytes or with K, M or G: a quarter of it holds faces, and more faces go to a scratch file")
    ("scratch", text()->value_name("DIRECTORY"), "directory of the scratch files; by default that for temporary files")
    ("faces-per-block", text()->value_name("B"),
     "number of faces that are worked on together; the result depends on it. By default 262144, and more for large clusters")
    ("clusters", text()->value_name("FILE.pvtp"), "write the input with the cluster and the rank of each face, one file a rank")
    ("report", text()->value_name("FILE"), "write times, memory and bytes sent of each rank, in JSON")
    ("quiet,q", "print nothing but errors");
  return options;
}

std::string help_text()
{
  std::ostringstream text;
  text << "Usage: mpirun -n R coarsen_mesh_mpi INPUT... OUTPUT -n N [OPTION]...\n\n"
          "Coarsens a mesh in binary PLY, of which each rank reads a part. Of several inputs, the vertices\n"
          "have global numbers in a property vertex_number; vertices of the same number are one. The output\n"
          "is OFF, OBJ, PLY or STL. It does not depend on ranks, threads and memory.\n\n"
       << description();
  return text.str();
}

void check_outputs(const Options& options)
{
  const std::string type = coarsening_support::file_type(options.output);
  if (!coarsening_support::is_own_file_type(type))
    throw std::invalid_argument(options.output + ": the output is OFF, OBJ, PLY or STL");
  if (!options.clusters.empty() && coarsening_support::file_type(options.clusters) != "pvtp")
    throw std::invalid_argument(options.clusters + ": clusters are written to a file .pvtp");
  std::vector<std::string> outputs = {options.output};
  for (const std::string& file : {options.clusters, options.report})
    if (!file.empty())
      outputs.push_back(file);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      if (coarsening_support::is_same_file(outputs[i], outputs[j]))
        throw std::invalid_argument(outputs[i] + ": would be written twice");
    for (const std::string& input : options.inputs)
      if (coarsening_support::is_same_file(outputs[i], input))
        throw std::invalid_argument(outputs[i] + ": would replace the input");
  }
}

void take_values(const po::variables_map& values, Options& options)
{
  const auto text = [&](const char* name) { return values.count(name) ? values[name].as<std::string>() : std::string(); };
  constexpr std::uint64_t most = (std::numeric_limits<std::uint64_t>::max)();
  if (values.count("vertices") == 0)
    throw std::invalid_argument("how many vertices? Give -n N");
  options.number_of_vertices = std::size_t(to_count("vertices", text("vertices"), most));
  options.threads = unsigned(to_count("threads", text("threads"), 1000000));
  const std::string placement = text("placement");
  if (placement != "fitted" && placement != "quadric")
    throw std::invalid_argument("--placement takes fitted or quadric, not '" + placement + "'");
  options.is_fitted = placement == "fitted";
  if (values.count("memory"))
    options.memory = to_count("memory", text("memory"), most, true);
  if (values.count("faces-per-block"))
    options.faces_per_block = std::size_t(to_count("faces-per-block", text("faces-per-block"), most));
  if (values.count("scratch") && !options.memory)
    throw std::invalid_argument("--scratch needs --memory");
  if (options.memory)
    options.scratch = values.count("scratch") ? text("scratch") : std::filesystem::temp_directory_path().string();
  options.clusters = text("clusters");
  options.report = text("report");
  options.is_quiet = values.count("quiet") > 0;
}

} // namespace

Options read_options(int argc, const char* const argv[])
{
  po::options_description all = description();
  all.add_options()("file", po::value<std::vector<std::string> >());
  po::positional_options_description positional;
  positional.add("file", -1);
  po::variables_map values;
  Options options;
  try {
    po::store(po::command_line_parser(argc, argv).options(all).positional(positional).run(), values);
  } catch (const po::error& e) {
    throw std::invalid_argument(e.what());
  }
  if (values.count("help")) {
    options.help = help_text();
    return options;
  }
  if (values.count("file"))
    options.inputs = values["file"].as<std::vector<std::string> >();
  if (options.inputs.size() < 2)
    throw std::invalid_argument("which files? Give INPUT and OUTPUT");
  options.output = options.inputs.back();
  options.inputs.pop_back();
  take_values(values, options);
  check_outputs(options);
  return options;
}

} // namespace coarsen_mesh_mpi
