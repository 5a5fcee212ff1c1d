// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the initial inputs of the fuzzers: make_seeds DIRECTORY writes to DIRECTORY/fuzz_tool and /fuzz_library.

#include "support/mesh_files.h"

#include <filesystem>
#include <fstream>
#include <random>
#include <string>

namespace {

void write(const std::filesystem::path& file, const std::string& bytes)
{
  std::ofstream(file, std::ios::binary) << bytes;
}

// Four bytes of options, and a file of each form.
void make_tool_seeds(const std::filesystem::path& directory)
{
  const generated::Soup surfaces[] = {generated::tetrahedron(), generated::triangulated(generated::grid(3, 3)),
                                      generated::triangulated(generated::torus(5, 4)), generated::moebius_strip(5)};
  const std::string types[] = {"off", "obj", "ply", "stl"};
  int number = 0;
  for (const generated::Soup& soup : surfaces)
    for (const auto& form : mesh_files::all_forms(soup)) {
      const std::size_t type = std::find(types, types + 4, form.first) - types;
      std::string options = {char(type + 4 * (number % 2)), char(number % 20), char(number % 3 == 0 ? 0 : 4 + number % 9), 0};
      write(directory / ("seed" + std::to_string(number++)), options + form.second);
    }
}

void make_library_seeds(const std::filesystem::path& directory)
{
  std::mt19937 engine(5);
  for (int number = 0; number < 64; ++number) {
    std::string bytes;
    for (std::size_t size = 8 + engine() % 200; bytes.size() < size;)
      bytes += char(engine());
    bytes[2] = char(4 + engine() % 20); // few vertices
    write(directory / ("seed" + std::to_string(number)), bytes);
  }
}

} // namespace

int main(int, char* argv[])
{
  const std::filesystem::path directory = argv[1];
  std::filesystem::create_directories(directory / "fuzz_tool");
  std::filesystem::create_directories(directory / "fuzz_library");
  make_tool_seeds(directory / "fuzz_tool");
  make_library_seeds(directory / "fuzz_library");
}
