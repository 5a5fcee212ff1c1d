// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PIECE_BLOCKS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PIECE_BLOCKS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Face_record.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Record_bins.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

#include <boost/mpi/collectives.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Receives a face: the global numbers and the points of its vertices, and its density.
typedef std::function<void(const std::vector<std::uint64_t>&, const std::vector<Vector>&, double)> Face_receiver;

// Passes all faces of a piece to the receiver, in the same order in each call.
typedef std::function<void(const Face_receiver&)> Face_source;

// A piece of which `source(receive)` passes the vertices and points of each face, and whose faces have consecutive keys in maps.
template <class Source, class Key, class NamedParameters>
struct Piece
{
  const Source& source;
  const Key first_key; // an iterator
  const NamedParameters& np;

  void operator()(const Face_receiver& receive) const
  {
    Key key = first_key;
    source([&, map = get_parameter(np, internal_np::face_density)](const auto& vertices, const std::vector<Vector>& points) {
      if constexpr (has_parameter<internal_np::face_density_t, NamedParameters>)
        receive(vertices, points, CGAL::to_double(get(map, *key++)));
      else
        receive(vertices, points, 1);
    });
  }

  void put_clusters(const std::vector<Index>& clusters) const
  {
    if constexpr (has_parameter<internal_np::face_cluster_t, NamedParameters>) {
      Key key = first_key;
      for (const Index cluster : clusters)
        put(get_parameter(np, internal_np::face_cluster), *key++, cluster);
    }
  }
};

// Returns a source of the faces of a face graph, which refers to the arguments.
template <class FaceGraph, class VertexNumberMap, class NamedParameters>
auto source_of_graph(const FaceGraph& graph, const VertexNumberMap& numbers, const NamedParameters& np)
{
  return [&](const auto& receive) {
    const auto coordinates = vertex_coordinates(graph, np);
    std::vector<std::uint64_t> vertices;
    std::vector<Vector> points;
    for (const auto f : faces(graph)) {
      vertices.clear();
      points.clear();
      for (const auto h : halfedges_around_face(halfedge(f, graph), graph)) {
        const auto v = target(h, graph);
        vertices.push_back(std::uint64_t(get(numbers, v)));
        points.push_back(coordinates(v));
      }
      receive(vertices, points);
    }
  };
}

// Reads the pieces of all ranks three times: for the bounding box, for the limits of the blocks, and into the blocks.
class Piece_blocks
{
public:
  Piece_blocks(Rank_context& context, Face_source source)
    : context_(context), source_(std::move(source))
  {}

  // Checks each face, finds the frame of the mesh, and gives faces without names a name.
  void measure()
  {
    on_all_ranks(context_.communicator, [&] { source_([this](const auto&... face) { measure_face(face...); }); });
    std::vector<std::uint64_t> faces;
    boost::mpi::all_gather(context_.communicator, faces_, faces);
    std::partial_sum(faces.begin(), faces.end(), std::back_inserter(first_face_));
    if (!context_.face_names)
      context_.face_names = [this](std::uint64_t face) {
        const auto [piece, number] = origin(face);
        return "face " + std::to_string(number) + " of piece " + std::to_string(piece);
      };
    on_all_ranks(context_.communicator, [&] { throw_fault(); });
    if (number_of_faces() == 0)
      throw Invalid_input("the input has no faces");
    // Minima do not depend on the order of their computation.
    const double own[6] = {box_.xmin(), box_.ymin(), box_.zmin(), -box_.xmax(), -box_.ymax(), -box_.zmax()};
    double all[6];
    boost::mpi::all_reduce(context_.communicator, own, 6, all, boost::mpi::minimum<double>());
    std::vector<Vector> ends = {{{all[0], all[1], all[2]}}, {{-all[3], -all[4], -all[5]}}};
    context_.frame = to_local_frame(ends, {0, 1, 2}, Run_context());
    curve_ = Morton_curve(ends[0], ends[1]);
  }

  const Morton_curve& curve() const { return curve_; }
  std::uint64_t number_of_faces() const { return first_face_.back(); }
  std::uint64_t faces_of_piece() const { return faces_; }

  // Returns the rank whose piece contains a face, and the number of the face in this piece.
  std::pair<std::size_t, std::uint64_t> origin(std::uint64_t face) const
  {
    const auto piece = std::upper_bound(first_face_.begin(), first_face_.end(), face) - first_face_.begin() - 1;
    return {std::size_t(piece), face - first_face_[std::size_t(piece)]};
  }

  // Reads each face into its block.
  std::unique_ptr<Record_bins> read(std::size_t faces_per_block) const
  {
    std::vector<std::uint64_t> places;
    on_all_ranks(context_.communicator, [&] {
      places.reserve(faces_);
      for_each_record([&](const Face_record& face) { places.push_back(face.place); });
    });
    const auto sum = [this](const std::vector<std::uint64_t>& own) {
      std::vector<std::uint64_t> all(own.size());
      boost::mpi::all_reduce(context_.communicator, own.data(), int(own.size()), all.data(), std::plus<std::uint64_t>());
      return all;
    };
    const std::vector<std::uint64_t> starts = block_starts(std::move(places), faces_per_block, sum);
    auto blocks = std::make_unique<Record_bins>(context_, starts.size());
    blocks->fill([&] {
      for_each_record([&](const Face_record& face) { blocks->send(block_of(starts, face.place), face); });
    });
    return blocks;
  }

private:
  // What is wrong with a face: a sentence around its name.
  struct Fault
  {
    std::uint64_t face;
    std::string before, after;
  };

  void measure_face(const std::vector<std::uint64_t>& vertices, const std::vector<Vector>& points, double density)
  {
    context_.poll();
    if (!fault_)
      find_fault(vertices, points, density);
    ++faces_;
    for (const Vector& p : points)
      box_ += box_of_point(p);
  }

  void find_fault(const std::vector<std::uint64_t>& vertices, const std::vector<Vector>& points, double density)
  {
    const auto set_fault = [&](const std::string& before, const std::string& after) { fault_ = Fault{faces_, before, after}; };
    if (vertices.size() < 3 || vertices.size() > Face_data::max_corners)
      return set_fault("", " has " + std::to_string(vertices.size()) + " sides");
    if (!(density >= 1 / largest_density && density <= largest_density))
      return set_fault("the density of ", " is " + number_text(density) + ", not in [1e-20, 1e20]");
    for (std::size_t i = 0; i < vertices.size(); ++i)
      for (const double x : points[i])
        if (!std::isfinite(x))
          return set_fault("vertex " + std::to_string(vertices[i]) + ", in ", ", has a coordinate that is " + number_text(x));
    if (vertices.size() == 3 && vertices[0] != vertices[1] && vertices[1] != vertices[2] && vertices[2] != vertices[0])
      return;
    std::vector<std::uint64_t> sorted = vertices;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end())
      set_fault("", " visits vertex " + std::to_string(*twice) + " twice");
  }

  // Throws an exception that names the first invalid face.
  void throw_fault() const
  {
    if (faces_ >= NONE)
      throw Invalid_input("piece " + std::to_string(context_.communicator.rank()) + " has more faces than the " +
                          std::to_string(NONE - 1) + " that can be numbered");
    if (fault_)
      throw Invalid_input(fault_->before + context_.face_names(first_face_[context_.rank()] + fault_->face) + fault_->after);
  }

  template <class Receive>
  void for_each_record(const Receive& receive) const
  {
    Face_record face;
    std::uint64_t number = first_face_[context_.rank()];
    source_([&](const std::vector<std::uint64_t>& vertices, const std::vector<Vector>& points, double density) {
      context_.poll();
      face.corner.clear();
      for (std::size_t i = 0; i < vertices.size(); ++i)
        face.corner.push_back({vertices[i], context_.frame.to_local(points[i])});
      begin_with_smallest_number(face);
      face.density = density;
      face.place = curve_(mean_of_corners(face));
      face.origin = number++;
      receive(face);
    });
  }

  Rank_context& context_;
  const Face_source source_;
  Bbox_3 box_;                                   // of the vertices of this piece
  Morton_curve curve_{{{0, 0, 0}}, {{0, 0, 0}}}; // of the mesh in its frame
  std::uint64_t faces_ = 0;                      // of this piece
  std::vector<std::uint64_t> first_face_ = {0};  // of each piece, and the total
  std::optional<Fault> fault_;                   // of the first invalid face
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PIECE_BLOCKS_H
