// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_TEST_TOOL_PROCESS_H
#define CGAL_SURFACE_MESH_COARSENING_TEST_TOOL_PROCESS_H

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

// Runs the tool, whose path is in the environment variable COARSEN_MESH, in a directory of its own.
namespace test {

inline std::string content_of(const std::filesystem::path& file)
{
  std::ifstream is(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>());
}

struct Tool_outcome
{
  int status; // 128 + the signal's number if one ended the tool
  std::string out, err;

  bool is_one_line_error() const
  {
    return out.empty() && std::count(err.begin(), err.end(), '\n') == 1 && err.back() == '\n';
  }
  bool names(const std::string& text) const { return err.find(text) != std::string::npos; }
};

// Runs a process of a shell with limited time: a hanging process yields status 124.
class Tool_process
{
  pid_t pid = -1;
  std::filesystem::path directory;

public:
  // `limits` are commands of the shell, such as those of ulimit.
  Tool_process(const std::filesystem::path& directory, const std::string& arguments, const std::string& limits = "")
    : directory(directory)
  {
    const std::string tool = "'" + std::string(std::getenv("COARSEN_MESH")) + "'";
    const std::string command = limits + "\nexec " + tool + " " + arguments + " >stdout 2>stderr </dev/null";
    pid = fork();
    if (pid == 0) {
      if (chdir(directory.c_str()) == 0)
        execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
      _exit(127);
    }
  }
  Tool_process(const Tool_process&) = delete;
  Tool_process& operator=(const Tool_process&) = delete;
  ~Tool_process()
  {
    if (pid > 0) {
      kill(pid, SIGKILL);
      waitpid(pid, nullptr, 0);
    }
  }

  void send(int signal) const { kill(pid, signal); }

  Tool_outcome wait(std::chrono::seconds limit = std::chrono::seconds(120))
  {
    const auto deadline = std::chrono::steady_clock::now() + limit;
    int status = 0;
    while (waitpid(pid, &status, WNOHANG) == 0) {
      if (std::chrono::steady_clock::now() > deadline)
        return {124, "", "it hangs"}; // the destructor ends it
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    pid = -1;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), content_of(directory / "stdout"),
            content_of(directory / "stderr")};
  }
};

class Tool_directory
{
  std::filesystem::path directory;

public:
  Tool_directory()
  {
    static int number = 0;
    directory = std::filesystem::temp_directory_path() /
                ("coarsen_mesh_test_" + std::to_string(getpid()) + "_" + std::to_string(number++));
    std::filesystem::remove_all(directory);
    std::filesystem::create_directories(directory);
  }
  Tool_directory(const Tool_directory&) = delete;
  Tool_directory& operator=(const Tool_directory&) = delete;
  ~Tool_directory()
  {
    std::error_code ignored;
    std::filesystem::remove_all(directory, ignored);
  }

  std::filesystem::path operator/(const std::string& name) const { return directory / name; }
  const std::filesystem::path& path() const { return directory; }

  void write(const std::string& name, const std::string& content) const
  {
    std::ofstream(directory / name, std::ios::binary) << content;
  }

  // Lists all files except the standard streams.
  std::vector<std::string> files() const
  {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(directory))
      if (entry.path().filename() != "stdout" && entry.path().filename() != "stderr")
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

  Tool_outcome run(const std::string& arguments, const std::string& limits = "") const
  {
    return Tool_process(directory, arguments, limits).wait();
  }
};

} // namespace test

#endif // CGAL_SURFACE_MESH_COARSENING_TEST_TOOL_PROCESS_H
