// SPDX-License-Identifier: GPL-3.0-or-later
//
// Attacks the library and the tool for a given time, with cases derived from a seed: mutated files of all formats, all
// numbers of vertices of small random meshes, random parameters and options, signals, threads. Each result is read and
// checked independently of the library. Prints a line, and one more for each finding, whose files it keeps. The tool's path
// is in the environment variable COARSEN_MESH.

#include "Case_directory.h"
#include "Random.h"
#include "library_cases.h"
#include "tool_cases.h"

#include <boost/program_options.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace {

struct Options
{
  double seconds = 60;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> only_case;
  std::string directory = "attack_cases";
};

// Returns one line, with question marks for unprintable bytes.
std::string printable(std::string text)
{
  while (!text.empty() && text.back() == '\n')
    text.pop_back();
  for (char& c : text)
    if (c < 32 || c > 126)
      c = c == '\n' ? ' ' : '?';
  return text;
}

struct Kind
{
  const char* name;
  void (*run)(attack::Case_directory&, attack::Random&);
  unsigned share; // of all cases
  std::size_t cases;
};

class Attack
{
public:
  explicit Attack(const Options& options) : options_(options) {}

  void run_case(std::uint64_t number)
  {
    attack::Random random(options_.seed, number);
    Kind& kind = pick_kind(random);
    ++kind.cases;
    attack::Case_directory directory(std::filesystem::absolute(options_.directory) /
                                     (std::to_string(options_.seed) + "_" + std::to_string(number)));
    try {
      kind.run(directory, random);
    } catch (const std::exception& e) {
      ++findings_;
      directory.keep();
      std::cout << "FINDING in " << kind.name << ", --seed " << options_.seed << " --case " << number << ", "
                << directory.path().string() << ": " << printable(e.what()) << std::endl;
    }
  }

  bool finish() const
  {
    std::size_t cases = 0;
    std::string parts;
    for (const Kind& kind : kinds_) {
      cases += kind.cases;
      parts += (parts.empty() ? "" : ", ") + std::to_string(kind.cases) + " " + kind.name;
    }
    std::cout << "attack with seed " << options_.seed << ": " << cases << " cases (" << parts << "), " << findings_ << " findings"
              << std::endl;
    return findings_ == 0;
  }

private:
  Kind& pick_kind(attack::Random& random)
  {
    unsigned sum = 0;
    for (const Kind& kind : kinds_)
      sum += kind.share;
    std::size_t chosen = random.below(sum);
    std::size_t i = 0;
    for (; chosen >= kinds_[i].share; ++i)
      chosen -= kinds_[i].share;
    return kinds_[i];
  }

  const Options options_;
  std::vector<Kind> kinds_ = {{"malformed files", attack::malformed_file, 40, 0},
                              {"combinations of parameters", attack::parameter_combination, 30, 0},
                              {"exhaustive counts", attack::exhaustive_counts, 5, 0},
                              {"combinations of options", attack::option_combination, 20, 0},
                              {"signals", attack::signal_at_any_time, 3, 0},
                              {"thread counts", attack::thread_counts, 2, 0}};
  std::size_t findings_ = 0;
};

Options read_options(int argc, char** argv)
{
  namespace po = boost::program_options;
  Options options;
  po::options_description described("usage: attack [OPTIONS]\noptions");
  described.add_options()("help", "print this and exit")(
    "seconds", po::value(&options.seconds)->default_value(options.seconds), "no case begins later")(
    "seed", po::value(&options.seed)->default_value(options.seed), "the cases follow from it")(
    "case", po::value<std::uint64_t>(), "run this case alone")(
    "directory", po::value(&options.directory)->default_value(options.directory), "where all files are");
  po::variables_map map;
  po::store(po::parse_command_line(argc, argv, described), map);
  po::notify(map);
  if (map.count("help") != 0) {
    std::cout << described;
    std::exit(0);
  }
  if (map.count("case") != 0)
    options.only_case = map["case"].as<std::uint64_t>();
  return options;
}

} // namespace

int main(int argc, char** argv)
try {
  const Options options = read_options(argc, argv);
  if (!std::getenv("COARSEN_MESH"))
    throw std::runtime_error("the environment variable COARSEN_MESH does not name the tool");
  Attack attack(options);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(options.seconds);
  if (options.only_case)
    attack.run_case(*options.only_case);
  else
    for (std::uint64_t number = 0; std::chrono::steady_clock::now() < end; ++number)
      attack.run_case(number);
  return attack.finish() ? 0 : 1;
} catch (const std::exception& e) {
  std::cerr << "attack: " << e.what() << std::endl;
  return 2;
}
