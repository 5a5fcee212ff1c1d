// SPDX-License-Identifier: GPL-3.0-or-later

#include "Input_slice.h"

#include "all_ranks.h"

#include <CGAL/Surface_mesh_coarsening/exceptions.h>

#include <boost/mpi/collectives.hpp>

#include <algorithm>

namespace coarsen_mesh_mpi {

using CGAL::Surface_mesh_coarsening::Invalid_input;

namespace {

// The vertices of some faces.
class Vertex_cache
{
public:
  // Reads the range of the numbers if it has few others, or else only these.
  void read(Ply_file& file, std::vector<std::uint64_t> numbers)
  {
    numbers_.clear();
    vertices_.clear();
    const auto [least, largest] = std::minmax_element(numbers.begin(), numbers.end());
    first_ = *least;
    const std::uint64_t range = *largest - *least + 1;
    if (range <= numbers.size()) {
      for (std::uint64_t v = first_; v < first_ + range; ++v)
        vertices_.push_back(file.read_vertex(v));
      return;
    }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    numbers_.swap(numbers);
    for (const std::uint64_t v : numbers_)
      vertices_.push_back(file.read_vertex(v));
  }

  const Ply_file::Vertex& operator[](std::uint64_t v) const
  {
    return vertices_[std::size_t(
      numbers_.empty() ? v - first_ : std::uint64_t(std::lower_bound(numbers_.begin(), numbers_.end(), v) - numbers_.begin()))];
  }

private:
  std::uint64_t first_ = 0;
  std::vector<std::uint64_t> numbers_; // empty if they are consecutive
  std::vector<Ply_file::Vertex> vertices_;
};

} // namespace

Input_slice::Input_slice(const boost::mpi::communicator& ranks, const std::vector<std::string>& files)
{
  on_all_ranks(ranks, [&] { open(files); });
  const auto rank = std::uint64_t(ranks.rank()), number = std::uint64_t(ranks.size()), faces = number_of_all_faces();
  const auto first_of = [&](std::uint64_t r) { return faces / number * r + faces % number * r / number; };
  begin_ = first_of(rank);
  end_ = first_of(rank + 1);
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const auto within = [&](std::uint64_t face) {
      return (std::min)((std::max)(face, first_face_[i]), first_face_[i + 1]) - first_face_[i];
    };
    parts_.push_back({within(begin_), within(end_), 0});
    find_position(ranks, i);
  }
}

void Input_slice::open(const std::vector<std::string>& files)
{
  for (const std::string& name : files) {
    files_.push_back(std::make_unique<Ply_file>(name));
    if (files.size() > 1 && !files_.back()->has_vertex_numbers())
      throw Invalid_input(name + ": is one of several pieces, but its vertices have no property vertex_number");
    first_face_.push_back(first_face_.back() + files_.back()->number_of_faces());
  }
}

// Where faces have different sizes, each rank passes over its own ones and tells the next rank where it has ended.
void Input_slice::find_position(const boost::mpi::communicator& ranks, std::size_t i)
{
  if (has_uniform_faces(ranks, i))
    return;
  Ply_file& file = *files_[i];
  Part& part = parts_[i];
  constexpr std::uint64_t unknown = ~std::uint64_t(0);
  on_all_ranks(ranks, [&] {
    std::uint64_t position = file.first_face_position();
    if (ranks.rank() > 0)
      ranks.recv(ranks.rank() - 1, 0, position);
    part.position = position;
    std::string fault;
    std::vector<std::uint64_t> vertices;
    try {
      for (std::uint64_t f = part.begin; f < part.end && position != unknown; ++f)
        position = file.read_face(position, f, vertices);
      if (ranks.rank() + 1 == ranks.size() && position != unknown)
        file.check_end(position);
    } catch (const Invalid_input& e) {
      fault = e.what();
      position = unknown;
    }
    if (ranks.rank() + 1 < ranks.size())
      ranks.send(ranks.rank() + 1, 0, position);
    if (!fault.empty())
      throw Invalid_input(fault);
  });
}

bool Input_slice::has_uniform_faces(const boost::mpi::communicator& ranks, std::size_t i)
{
  Ply_file& file = *files_[i];
  Part& part = parts_[i];
  std::uint64_t size = 0;
  on_all_ranks(ranks, [&] { size = file.size_if_uniform(); });
  if (size == 0)
    return false;
  part.position = file.first_face_position() + part.begin * size;
  bool is_uniform = true;
  std::vector<std::uint64_t> vertices;
  std::uint64_t position = part.position;
  try {
    for (std::uint64_t f = part.begin; f < part.end && is_uniform; ++f, position += size)
      is_uniform = file.read_face(position, f, vertices) == position + size;
  } catch (const Invalid_input&) {
    is_uniform = false; // the faces are somewhere else, or the fault is found again
  }
  return boost::mpi::all_reduce(ranks, is_uniform, std::logical_and<bool>());
}

void Input_slice::operator()(const Receiver& receive) const
{
  for (std::size_t i = 0; i < files_.size(); ++i)
    read_part(*files_[i], parts_[i], receive);
}

void Input_slice::read_part(Ply_file& file, const Part& part, const Receiver& receive) const
{
  constexpr std::uint64_t faces_at_a_time = 1 << 16;
  std::uint64_t position = part.position;
  std::vector<std::uint64_t> vertices, corners, first_corner;
  std::vector<std::array<double, 3> > points;
  Vertex_cache cache;
  for (std::uint64_t begin = part.begin, end; begin < part.end; begin = end) {
    end = (std::min)(begin + faces_at_a_time, part.end);
    corners.clear();
    first_corner.assign(1, 0);
    for (std::uint64_t f = begin; f < end; ++f) {
      position = file.read_face(position, f, vertices);
      corners.insert(corners.end(), vertices.begin(), vertices.end());
      first_corner.push_back(corners.size());
    }
    if (!corners.empty())
      cache.read(file, corners);
    for (std::uint64_t f = 0; f < end - begin; ++f) {
      vertices.clear();
      points.clear();
      for (std::uint64_t c = first_corner[f]; c != first_corner[f + 1]; ++c) {
        const Ply_file::Vertex& v = cache[corners[c]];
        vertices.push_back(v.number);
        points.push_back({{v.x, v.y, v.z}});
      }
      receive(vertices, points);
    }
  }
}

std::string Input_slice::name(std::uint64_t face) const
{
  const std::size_t i =
    std::size_t(std::upper_bound(first_face_.begin(), first_face_.end(), face) - first_face_.begin() - 1);
  return "face " + std::to_string(face - first_face_[i]) + " of " + files_[i]->name();
}

} // namespace coarsen_mesh_mpi
