// SPDX-License-Identifier: GPL-3.0-or-later

#include "Cluster_file.h"

#include <CGAL/Surface_mesh_coarsening/exceptions.h>

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

namespace coarsen_mesh_mpi {
namespace {

namespace fs = std::filesystem;

std::string name_of_rank(const std::string& file, int rank)
{
  fs::path path(file);
  path.replace_extension();
  return path.string() + "_" + std::to_string(rank) + ".vtp";
}

std::string opening(const char* type)
{
  return std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"") + type + "\" version=\"1.0\" byte_order=\"" +
         (boost::endian::order::native == boost::endian::order::little ? "Little" : "Big") + "Endian\" header_type=\"UInt64\">\n";
}

// The vertices of a slice, in ascending order of their numbers.
struct Slice_vertices
{
  std::vector<std::uint64_t> numbers;
  std::vector<std::array<double, 3> > points;
  std::uint64_t corners = 0;

  explicit Slice_vertices(const Input_slice& slice)
  {
    constexpr std::size_t many = 1 << 22;
    std::size_t limit = many;
    const auto make_unique = [this] {
      std::sort(numbers.begin(), numbers.end());
      numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    };
    slice([&](const std::vector<std::uint64_t>& vertices, const std::vector<std::array<double, 3> >&) {
      corners += vertices.size();
      numbers.insert(numbers.end(), vertices.begin(), vertices.end());
      if (numbers.size() > limit) {
        make_unique();
        limit = 2 * numbers.size() + many;
      }
    });
    make_unique();
    points.resize(numbers.size());
    slice([this](const std::vector<std::uint64_t>& vertices, const std::vector<std::array<double, 3> >& points_of_face) {
      for (std::size_t i = 0; i < vertices.size(); ++i)
        points[index(vertices[i])] = points_of_face[i];
    });
  }

  std::size_t index(std::uint64_t number) const
  {
    return std::size_t(std::lower_bound(numbers.begin(), numbers.end(), number) - numbers.begin());
  }
};

void write_header(std::ostream& stream, std::uint64_t points, std::uint64_t corners, std::uint64_t faces)
{
  std::uint64_t offset = 0;
  // Announces an array, with its place behind the header.
  const auto add = [&](const char* type, const char* name, int components, std::uint64_t bytes) {
    stream << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << components
           << "\" format=\"appended\" offset=\"" << offset << "\"/>\n";
    offset += bytes + sizeof(std::uint64_t);
  };
  stream << opening("PolyData") << "<PolyData><Piece NumberOfPoints=\"" << points << "\" NumberOfPolys=\"" << faces
         << "\">\n<Points>\n";
  add("Float64", "Points", 3, 24 * points);
  stream << "</Points>\n<Polys>\n";
  add("Int64", "connectivity", 1, 8 * corners);
  add("Int64", "offsets", 1, 8 * faces);
  stream << "</Polys>\n<CellData>\n";
  add("UInt32", "cluster", 1, 4 * faces);
  add("UInt32", "rank", 1, 4 * faces);
  stream << "</CellData>\n</Piece></PolyData>\n<AppendedData encoding=\"raw\">\n_";
}

} // namespace

Cluster_file::Cluster_file(const std::string& file, int rank)
  : name_(name_of_rank(file, rank)), temporary_(name_ + ".part"), rank_(rank)
{}

Cluster_file::~Cluster_file()
{
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void Cluster_file::write(const Input_slice& slice, const std::vector<std::uint32_t>& clusters) const
{
  const Slice_vertices vertices(slice);
  errno = 0;
  std::ofstream stream(temporary_, std::ios::binary);
  write_header(stream, vertices.points.size(), vertices.corners, clusters.size());
  const auto write_binary = [&](const auto& value) { stream.write(reinterpret_cast<const char*>(&value), sizeof value); };
  write_binary(std::uint64_t(24 * vertices.points.size()));
  for (const auto& p : vertices.points)
    write_binary(p);
  write_binary(std::uint64_t(8 * vertices.corners));
  slice([&](const std::vector<std::uint64_t>& numbers, const auto&) {
    for (const std::uint64_t v : numbers)
      write_binary(std::int64_t(vertices.index(v)));
  });
  write_binary(std::uint64_t(8 * clusters.size()));
  std::int64_t end = 0;
  slice([&](const std::vector<std::uint64_t>& numbers, const auto&) { write_binary(end += std::int64_t(numbers.size())); });
  write_binary(std::uint64_t(4 * clusters.size()));
  for (const std::uint32_t x : clusters)
    write_binary(x);
  write_binary(std::uint64_t(4 * clusters.size()));
  for (std::size_t f = 0; f < clusters.size(); ++f)
    write_binary(std::uint32_t(rank_));
  stream << "\n</AppendedData>\n</VTKFile>\n";
  stream.close();
  if (!stream)
    throw CGAL::Surface_mesh_coarsening::Invalid_input(
      name_ + ": cannot be written" + (errno == 0 ? "" : ": " + std::generic_category().message(errno)));
}

void Cluster_file::commit()
{
  fs::rename(temporary_, name_);
  is_committed_ = true;
}

void Cluster_file::undo()
{
  std::error_code ignored;
  if (is_committed_)
    fs::remove(name_, ignored);
}

std::string list_of_cluster_files(const std::string& file, int ranks)
{
  std::ostringstream text;
  text << opening("PPolyData") << "<PPolyData GhostLevel=\"0\">\n"
       << "<PPoints><PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/></PPoints>\n"
       << "<PCellData><PDataArray type=\"UInt32\" Name=\"cluster\"/><PDataArray type=\"UInt32\" Name=\"rank\"/></PCellData>\n";
  for (int rank = 0; rank < ranks; ++rank)
    text << "<Piece Source=\"" << fs::path(name_of_rank(file, rank)).filename().string() << "\"/>\n";
  text << "</PPolyData>\n</VTKFile>\n";
  return text.str();
}

} // namespace coarsen_mesh_mpi
