// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_ATTACK_LIBRARY_CASES_H
#define CGAL_SURFACE_MESH_COARSENING_ATTACK_LIBRARY_CASES_H

#include "Case_directory.h"
#include "Random.h"

#include "fuzz/Library_input.h"

#include <CGAL/assertions_behaviour.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

// Cases in which the library is called.
namespace attack {

// Calls a function in a separate process, with limited time and memory: it may crash, or never end.
template <class Function>
void run_in_child(const Case_directory& directory, const Function& function)
{
  std::fflush(nullptr);
  const pid_t pid = fork();
  if (pid == 0) {
    const rlimit seconds{120, 120}, bytes{4000000000u, 4000000000u}, none{0, 0};
    setrlimit(RLIMIT_CPU, &seconds);
    setrlimit(RLIMIT_AS, &bytes);
    setrlimit(RLIMIT_CORE, &none);
    if (!std::freopen((directory / "stderr").c_str(), "w", stderr))
      _exit(3);
    CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
    try {
      function();
    } catch (const std::exception& e) {
      std::fprintf(stderr, "FINDING: threw %s\n", e.what());
      std::fflush(stderr);
      _exit(1);
    }
    _exit(0);
  }
  int status = -1;
  waitpid(pid, &status, 0);
  require(WIFEXITED(status) && WEXITSTATUS(status) == 0,
          (WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status)) + ": " : std::string()) +
            test::content_of(directory / "stderr"));
}

inline std::string random_library_bytes(Random& random)
{
  std::string bytes = random.bytes(8 + random.below(200));
  bytes[2] = char(random.below(40)); // few vertices
  return bytes;
}

inline fuzz::Library_input library_input(const std::string& bytes)
{
  return fuzz::Library_input(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

// A small mesh, any parameters.
inline void parameter_combination(Case_directory& directory, Random& random)
{
  const std::string bytes = random_library_bytes(random);
  directory.write("bytes", bytes);
  run_in_child(directory, [&] {
    fuzz::Library_input input = library_input(bytes);
    if (input.soup.points.size() <= 400)
      input.check(input.parameters.number);
  });
}

// All numbers of vertices of a small mesh, and some more: there is a result from the smallest attainable number up to the
// number of vertices of the mesh.
inline void exhaustive_counts(Case_directory& directory, Random& random)
{
  std::string bytes = random_library_bytes(random);
  bytes[0] = char(random.below(20)); // a number of vertices, and no level
  bytes[1] = char(4 * random.below(8));
  directory.write("bytes", bytes);
  run_in_child(directory, [&] {
    fuzz::Library_input input = library_input(bytes);
    input.parameters.level = 0;
    if (input.soup.points.size() > 60)
      return;
    bool had_result = false, had_end = false;
    for (std::size_t n = 1; n <= input.soup.points.size() + 2; ++n) {
      const bool is_result = input.check(n);
      fuzz::require(!(is_result && had_end), "a number is refused between others that are not: " + std::to_string(n - 1));
      had_end = had_end || (had_result && !is_result);
      had_result = had_result || is_result;
    }
  });
}

} // namespace attack

#endif // CGAL_SURFACE_MESH_COARSENING_ATTACK_LIBRARY_CASES_H
