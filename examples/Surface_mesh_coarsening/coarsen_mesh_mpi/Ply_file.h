// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_MPI_PLY_FILE_H
#define COARSEN_MESH_MPI_PLY_FILE_H

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace coarsen_mesh_mpi {

// Reads any part of a file through a window of bytes.
class File_window
{
public:
  explicit File_window(const std::string& name);

  const std::string& name() const { return name_; }
  std::uint64_t size() const { return size_; }

  // Returns `n` bytes from position `at` on, or null if the file ends before. They are valid until the next call. Reads as many
  // as `at_least`, if the window does not have them.
  const char* bytes(std::uint64_t at, std::size_t n, std::size_t at_least = std::size_t(1) << 20);

private:
  std::string name_;
  std::ifstream file_;
  std::uint64_t size_ = 0, first_ = 0;
  std::vector<char> window_;
};

// The types of numbers in PLY files, with those of 64 bits that some programs write.
enum class Ply_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64, INT64, UINT64 };

struct Ply_property
{
  std::string name;
  Ply_type type = Ply_type::FLOAT32, count_type = Ply_type::UINT8;
  bool is_list = false;
};

// A binary PLY file, of which only the header has been read.
class Ply_file
{
public:
  // Throws Invalid_input if the file cannot be read, is not binary PLY, is too short for its vertices, or if their numbers are
  // not whole.
  explicit Ply_file(const std::string& name);

  const std::string& name() const { return window_.name(); }
  std::uint64_t number_of_vertices() const { return vertices_; }
  std::uint64_t number_of_faces() const { return faces_; }
  // Whether vertices have global numbers, in a property `vertex_number`.
  bool has_vertex_numbers() const { return number_ != none; }

  std::uint64_t first_face_position() const { return face_position_; }
  // Returns the size of all faces if they are as large as the first one, and nothing follows them; otherwise 0.
  std::uint64_t size_if_uniform();

  // Reads the vertices of the face at a position, and returns the position of the next face. `face` is its number, for messages.
  std::uint64_t read_face(std::uint64_t position, std::uint64_t face, std::vector<std::uint64_t>& vertices);

  // Throws Invalid_input if the file has fewer or more bytes than its header says, given the position after the last face. Does
  // not read lists that follow the faces.
  void check_end(std::uint64_t end_of_faces) const;

  struct Vertex
  {
    double x, y, z;
    std::uint64_t number;
  };
  // Reads a vertex; ascending numbers are fast.
  Vertex read_vertex(std::uint64_t vertex);

private:
  static constexpr std::size_t none = std::size_t(-1);

  [[noreturn]] void fail(const std::string& reason) const;
  void read_header();
  void read_element(const std::string& name, std::uint64_t count, const std::vector<Ply_property>& properties,
                    std::uint64_t& position);
  void add_last_element(const std::string& name, std::uint64_t count, const std::vector<Ply_property>& properties);
  void place_vertices(std::uint64_t count, const std::vector<Ply_property>& properties, std::uint64_t position);
  double number(const char* bytes, Ply_type type) const;
  std::uint64_t whole_number(const char* bytes, Ply_type type) const;
  const char* face_bytes(std::uint64_t at, std::size_t n, std::uint64_t face);

  File_window window_, vertex_window_;
  bool swaps_bytes_ = false;
  std::uint64_t vertices_ = 0, vertex_position_ = 0, faces_ = 0, face_position_ = 0, bytes_after_faces_ = 0;
  std::size_t vertex_size_ = 0, coordinate_[3] = {none, none, none}, number_ = none; // offsets in a vertex
  Ply_type coordinate_type_[3] = {}, number_type_ = Ply_type::UINT32;
  std::vector<Ply_property> face_properties_;
  std::size_t corners_ = none; // the property with the vertices of a face
  bool faces_are_last_ = true, has_last_lists_ = false;
};

} // namespace coarsen_mesh_mpi

#endif // COARSEN_MESH_MPI_PLY_FILE_H
