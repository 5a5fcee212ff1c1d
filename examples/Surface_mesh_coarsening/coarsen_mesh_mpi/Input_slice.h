// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_MPI_INPUT_SLICE_H
#define COARSEN_MESH_MPI_INPUT_SLICE_H

#include "Ply_file.h"

#include <boost/mpi/communicator.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace coarsen_mesh_mpi {

// The faces that a rank reads: an equal part of the sequence of all faces of all files. Of vertices, it reads those of its faces.
class Input_slice
{
public:
  typedef std::function<void(const std::vector<std::uint64_t>&, const std::vector<std::array<double, 3> >&)> Receiver;

  // All ranks construct their slices together. Throws Invalid_input on all ranks if a file cannot be read.
  Input_slice(const boost::mpi::communicator& ranks, const std::vector<std::string>& files);

  std::uint64_t number_of_faces() const { return end_ - begin_; }
  std::uint64_t number_of_all_faces() const { return first_face_.back(); }

  // Passes the numbers and the points of the vertices of each face.
  void operator()(const Receiver& receive) const;

  // Returns the name of a face, given by its number in the sequence.
  std::string name(std::uint64_t face) const;

private:
  // The part of a file that this rank reads.
  struct Part
  {
    std::uint64_t begin = 0, end = 0, position = 0; // of its faces, and of the first one in the file
  };

  void open(const std::vector<std::string>& files);
  void find_position(const boost::mpi::communicator& ranks, std::size_t file);
  bool has_uniform_faces(const boost::mpi::communicator& ranks, std::size_t file);
  void read_part(Ply_file& file, const Part& part, const Receiver& receive) const;

  std::vector<std::unique_ptr<Ply_file> > files_;
  std::vector<std::uint64_t> first_face_ = {0}; // of each file, and the total
  std::uint64_t begin_ = 0, end_ = 0;           // of the faces of this rank
  std::vector<Part> parts_;                     // of each file
};

} // namespace coarsen_mesh_mpi

#endif // COARSEN_MESH_MPI_INPUT_SLICE_H
