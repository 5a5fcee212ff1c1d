// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_MPI_OPTIONS_H
#define COARSEN_MESH_MPI_OPTIONS_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coarsen_mesh_mpi {

struct Options
{
  std::vector<std::string> inputs;
  std::string output, scratch, clusters, report;
  std::size_t number_of_vertices = 0;
  std::optional<std::size_t> faces_per_block;
  std::optional<std::uint64_t> memory; // bytes
  unsigned threads = 1;
  bool is_fitted = true; // or placed by quadrics
  bool is_quiet = false;
  std::string help; // if it is wanted
};

// Throws std::invalid_argument if the arguments are not valid.
Options read_options(int argc, const char* const argv[]);

} // namespace coarsen_mesh_mpi

#endif // COARSEN_MESH_MPI_OPTIONS_H
