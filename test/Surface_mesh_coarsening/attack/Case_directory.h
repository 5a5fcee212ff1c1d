// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_ATTACK_CASE_DIRECTORY_H
#define CGAL_SURFACE_MESH_COARSENING_ATTACK_CASE_DIRECTORY_H

#include "support/Tool_process.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace attack {

// A violated promise of the project.
class Finding : public std::runtime_error
{
public:
  explicit Finding(const std::string& what) : std::runtime_error(what) {}
};

inline void require(bool condition, const std::string& what)
{
  if (!condition)
    throw Finding(what);
}

// The directory of a case, in which the tool runs. The destructor removes it unless the case led to a finding.
class Case_directory
{
public:
  explicit Case_directory(const std::filesystem::path& path) : path_(path)
  {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  Case_directory(const Case_directory&) = delete;
  Case_directory& operator=(const Case_directory&) = delete;
  ~Case_directory()
  {
    std::error_code ignored;
    if (!keeps_)
      std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  void keep() { keeps_ = true; }

  void write(const std::string& name, const std::string& content)
  {
    std::ofstream(path_ / name, std::ios::binary) << content;
    inputs_.push_back(name);
  }

  // Lists the files besides the inputs and the standard streams.
  std::vector<std::string> results() const
  {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
      const std::string name = entry.path().filename().string();
      if (name != "stdout" && name != "stderr" && name != "command" && std::count(inputs_.begin(), inputs_.end(), name) == 0)
        names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  void remove_results() const
  {
    for (const std::string& name : results())
      std::filesystem::remove(path_ / name);
  }

  // Its processor time, memory and files are limited.
  test::Tool_process start(const std::string& arguments) const
  {
    std::ofstream(path_ / "command", std::ios::app) << "coarsen_mesh " << arguments << "\n";
    return test::Tool_process(path_, arguments, "ulimit -c 0; ulimit -t 60; ulimit -v 4000000; ulimit -f 400000");
  }

  test::Tool_outcome run(const std::string& arguments) const
  {
    return start(arguments).wait(std::chrono::seconds(300));
  }

private:
  std::filesystem::path path_;
  std::vector<std::string> inputs_;
  bool keeps_ = false;
};

// A failure is one line on standard error, printable, and no file is left.
inline void check_failure(const Case_directory& directory, const test::Tool_outcome& outcome)
{
  require(outcome.status != 128 + SIGXCPU && outcome.status != 124, "more than 60 s of processor time, or 300 s");
  require(outcome.status == 1 || outcome.status == 2, "status " + std::to_string(outcome.status) + ": " + outcome.err);
  require(!outcome.names("is not written: "), "the tool refuses its own result: " + outcome.err);
  require(outcome.is_one_line_error(), "the message is not one line: " + outcome.out + outcome.err);
  require(outcome.err.compare(0, 14, "coarsen_mesh: ") == 0, "no message of the tool: " + outcome.err);
  require(std::all_of(outcome.err.begin(), outcome.err.end() - 1, [](char c) { return c >= 32 && c < 127; }),
          "the message has bytes that cannot be printed: " + outcome.err);
  require(directory.results().empty(), "a file was left after: " + outcome.err);
}

} // namespace attack

#endif // CGAL_SURFACE_MESH_COARSENING_ATTACK_CASE_DIRECTORY_H
