// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mesh on several ranks: its ranks, its blocks, and the clusters that coarsen_mesh_mpi has written.

#include "Picture_kit.h"

#include <CGAL/Surface_mesh_coarsening/internal/distributed/Face_record.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace coarsening_pictures {
namespace {

const std::size_t faces_per_block = 8000, ranks = 4; // the first is also in CMakeLists.txt

// Reads the array `cluster` of a file that coarsen_mesh_mpi has written.
Labels read_clusters(const std::filesystem::path& file, std::size_t faces)
{
  std::ifstream is(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(is)), std::istreambuf_iterator<char>());
  const std::string begin = "<AppendedData encoding=\"raw\">\n_", name = "Name=\"cluster\"", offset = "offset=\"";
  const std::size_t data = bytes.find(begin), array = bytes.find(name), number = bytes.find(offset, array);
  if (data == std::string::npos || number == std::string::npos)
    throw std::runtime_error("cannot read the clusters in " + file.string());
  const std::size_t at = data + begin.size() + std::stoul(bytes.substr(number + offset.size(), 20)) + sizeof(std::uint64_t);
  std::vector<std::uint32_t> clusters(faces);
  if (bytes.size() < at + faces * sizeof clusters[0])
    throw std::runtime_error(file.string() + " has too few clusters");
  std::copy_n(bytes.data() + at, faces * sizeof clusters[0], reinterpret_cast<char*>(clusters.data()));
  return Labels(clusters.begin(), clusters.end());
}

// Returns the blocks of the faces, as in a distributed coarsening.
Labels blocks_of(const Mesh& mesh, std::size_t& number)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  std::vector<SMC::internal::Vector> ends = {SMC::internal::low_corner(box), SMC::internal::high_corner(box)};
  const SMC::internal::Local_frame frame = SMC::internal::to_local_frame(ends, {0, 1, 2}, SMC::internal::Run_context());
  const SMC::internal::Morton_curve place_of(ends[0], ends[1]);
  std::vector<std::uint64_t> places;
  for (Face f : mesh.faces()) {
    SMC::internal::Face_record face;
    for (Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) {
      const Point& p = mesh.point(v);
      face.corner.push_back({v, frame.to_local({{p.x(), p.y(), p.z()}})});
    }
    places.push_back(place_of(mean_of_corners(face)));
  }
  const auto starts =
    SMC::internal::block_starts(places, faces_per_block, [](const std::vector<std::uint64_t>& own) { return own; });
  number = starts.size();
  Labels blocks;
  for (const std::uint64_t place : places)
    blocks.push_back(SMC::internal::block_of(starts, place));
  return blocks;
}

void picture_ranks(const Setting& setting)
{
  const Mesh mesh = read(setting, "refined_elephant.off");
  const Camera camera = camera_for(mesh, Vector(0.9, 0.25, 0.9), Vector(0, 1, 0));
  std::size_t number = 0;
  const Labels blocks = blocks_of(mesh, number),
               clusters = read_clusters(setting.directory / "clusters_of_ranks_0.vtp", mesh.number_of_faces());
  Labels ranks_of_faces;
  for (const std::size_t block : blocks)
    ranks_of_faces.push_back(SMC::internal::rank_of_bin(block, number, ranks));
  Mesh coarse;
  std::ifstream is(setting.directory / "coarse_of_ranks.off");
  if (!CGAL::IO::read_OFF(is, coarse))
    throw std::runtime_error("cannot read the output of coarsen_mesh_mpi");
  compose(setting.directory, "ranks",
          {{{drawn(cluster_scene(mesh, ranks_of_faces), camera), std::to_string(ranks) + " ranks", "", ""},
            {drawn(cluster_scene(mesh, blocks), camera), std::to_string(number) + " blocks", "", ""}},
           {{drawn(cluster_scene(mesh, clusters), camera), counted(coarse.number_of_vertices()) + " clusters", "", ""},
            {drawn(mesh_scene(coarse), camera), vertices_of(coarse), "", ""}}});
}

} // namespace

Pictures pictures_of_ranks() { return {{"ranks", picture_ranks}}; }

} // namespace coarsening_pictures
