// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts bytes to a mesh file and a command line, and runs the whole tool with them. The first four bytes are the
// options, the others the content of the file.

#include "Fuzz_bytes.h"

#include "check/certificate.h"
#include "check/soup_fault.h"
#include "io/read_soup.h"
#include "io/to_mesh.h"
#include "run_and_report.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using fuzz::require;

struct Outcome
{
  int status;
  std::string out, err;
};

Outcome run(std::vector<std::string> words)
{
  std::ostringstream out, err;
  std::streambuf* const before_out = std::cout.rdbuf(out.rdbuf());
  std::streambuf* const before_err = std::cerr.rdbuf(err.rdbuf());
  words.insert(words.begin(), "coarsen_mesh");
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(&word[0]);
  arguments.push_back(nullptr);
  const int status = coarsen_mesh_tool::run_and_report(int(words.size()), arguments.data());
  std::cout.rdbuf(before_out);
  std::cerr.rdbuf(before_err);
  return {status, out.str(), err.str()};
}

const fs::path& directory()
{
  static const struct Directory
  {
    fs::path path = fs::temp_directory_path() / ("fuzz_tool_" + std::to_string(getpid()));
    Directory() { fs::create_directories(path); }
    ~Directory()
    {
      std::error_code ignored;
      fs::remove_all(path, ignored);
    }
  } result;
  return result.path;
}

std::size_t number_of_files()
{
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory()), fs::directory_iterator()));
}

void check_failure(const Outcome& outcome, const std::string& input)
{
  require(outcome.status == 1, "status " + std::to_string(outcome.status) + ": " + outcome.err);
  require(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1, "not one line: " + outcome.err);
  require(outcome.err.compare(0, 14 + input.size(), "coarsen_mesh: " + input) == 0, "no file named: " + outcome.err);
  require(number_of_files() == 1, "a file was left after: " + outcome.err);
}

// Returns whether the result exists.
bool check_success(const Outcome& outcome, const std::string& output, std::size_t vertices)
{
  if (outcome.status != 0)
    return false;
  const auto soup = coarsening_support::read_soup(output);
  const auto fault = coarsening_support::soup_fault(soup);
  require(!fault, "the result is no surface: " + fault.value_or(""));
  require(vertices == 0 || soup.points.size() == vertices, "the result has " + std::to_string(soup.points.size()) +
                                                               " vertices, not " + std::to_string(vertices));
  require(outcome.out.find("topology kept") != std::string::npos, outcome.out);
  return true;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const char* const types[] = {"off", "obj", "ply", "stl"};
  static const char* const weights[] = {"uniform", "area", "maximum", "exact-maximum", "variance"};
  static const char* const placements[] = {"centroid", "closest-vertex", "quadric", "fitted"};
  fuzz::Bytes bytes(data, size);
  const std::size_t form = bytes.next(), choice = bytes.next(), vertices = bytes.next2() % 2048;
  const std::string input = (directory() / ("in." + std::string(types[form % 4]))).string();
  const std::string output = (directory() / "out.off").string(), report = (directory() / "report.json").string();
  std::ofstream(input, std::ios::binary) << bytes.rest();

  std::vector<std::string> words = {input, output, "--report", report, "--rounds", "30"};
  words.insert(words.end(), {"--weight", weights[choice % 5], "--placement", placements[choice / 5 % 4]});
  if (form & 4)
    words.push_back("--repair");
  const std::vector<std::string> number = {"--vertices", std::to_string(vertices)}, level = {"--neighborhood-level", "7"};
  words.insert(words.end(), (vertices > 0 ? number : level).begin(), (vertices > 0 ? number : level).end());
  const Outcome outcome = run(words);
  if (!check_success(outcome, output, vertices)) {
    check_failure(outcome, input);
    const std::string lead = "nearest number that works: ";
    const std::size_t found = outcome.err.find(lead);
    if (found != std::string::npos) {
      words.back() = std::to_string(std::stoul(outcome.err.substr(found + lead.size())));
      const Outcome second = run(words);
      require(check_success(second, output, std::stoul(words.back())),
              "the nearest number does not work: " + outcome.err + second.err);
    }
  }
  for (const auto& file : fs::directory_iterator(directory()))
    fs::remove(file.path());
  return 0;
}
