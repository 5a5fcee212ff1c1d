// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_MPI_CLUSTER_FILE_H
#define COARSEN_MESH_MPI_CLUSTER_FILE_H

#include "Input_slice.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace coarsen_mesh_mpi {

// The file of VTK with the faces of one rank and their clusters. It has a temporary name until it is committed.
class Cluster_file
{
public:
  // The file is beside `file`, which names the files of all ranks.
  Cluster_file(const std::string& file, int rank);
  Cluster_file(const Cluster_file&) = delete;
  Cluster_file& operator=(const Cluster_file&) = delete;
  ~Cluster_file();

  void write(const Input_slice& slice, const std::vector<std::uint32_t>& clusters) const;
  void commit();
  // Removes the file if it was committed.
  void undo();

private:
  std::string name_, temporary_;
  int rank_;
  bool is_committed_ = false;
};

// Returns the content of the file that names the files of all ranks.
std::string list_of_cluster_files(const std::string& file, int ranks);

} // namespace coarsen_mesh_mpi

#endif // COARSEN_MESH_MPI_CLUSTER_FILE_H
