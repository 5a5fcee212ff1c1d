// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PIECE_BLOCKS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PIECE_BLOCKS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Face_set.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Patch.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Word_routing.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Receives a face: the global numbers and the points of its vertices, and its density.
typedef std::function<void(const std::vector<std::uint64_t>&, const std::vector<Vector>&, double)> Face_receiver;

// Passes all faces of a piece to the receiver, in the same order in each call.
typedef std::function<void(const Face_receiver&)> Face_source;

template <class DensityMap, class Face>
double density_of(const DensityMap& map, Face f)
{
  return CGAL::to_double(get(map, f));
}
template <class Face>
double density_of(const CGAL::internal_np::Param_not_found&, Face)
{
  return 1;
}

// Returns the source that reads a face graph. The graph, the numbers and the parameters must exist as long as the source.
template <class FaceGraph, class VertexNumberMap, class NamedParameters>
Face_source source_of_face_graph(const FaceGraph& piece, const VertexNumberMap& numbers, const NamedParameters& np)
{
  return [&](const Face_receiver& receive) {
    const Vertex_coordinates<FaceGraph, NamedParameters> coordinates(piece, np);
    const auto densities = get_parameter(np, internal_np::face_density);
    std::vector<std::uint64_t> vertices;
    std::vector<Vector> points;
    for (const auto f : faces(piece)) {
      vertices.clear();
      points.clear();
      for (const auto h : halfedges_around_face(halfedge(f, piece), piece)) {
        const auto v = target(h, piece);
        vertices.push_back(std::uint64_t(get(numbers, v)));
        points.push_back(coordinates(v));
      }
      receive(vertices, points, density_of(densities, f));
    }
  };
}

// Returns the source that reads a caller's source of faces. The keys of the densities are the numbers of the faces.
template <class Source, class NamedParameters>
Face_source source_of_faces(const Source& source, const NamedParameters& np)
{
  return [&](const Face_receiver& receive) {
    const auto densities = get_parameter(np, internal_np::face_density);
    std::size_t face = 0;
    source([&](const std::vector<std::uint64_t>& vertices, const std::vector<Vector>& points) {
      receive(vertices, points, density_of(densities, face++));
    });
  };
}

// Reads the pieces of all ranks three times: for the bounding box, for the limits of the blocks, and into the blocks.
class Piece_blocks
{
public:
  // Without `names`, the name of a face consists of its piece and its number in the piece.
  Piece_blocks(Rank_context& context, const Face_source& source, const Face_names& names)
    : context_(context), communicator_(context.communicator), source_(source), names_(names)
  {}

  // Checks each face and finds the frame of the mesh.
  void measure()
  {
    Remote_exception failure = caught([&] { source_([this](const auto&... face) { measure_face(face...); }); },
                                      communicator_.rank());
    count_faces();
    if (failure.kind == Remote_exception::NONE_THROWN)
      failure = caught([&] { throw_fault(); }, communicator_.rank());
    throw_on_all_ranks(communicator_, failure);
    if (number_of_faces() == 0)
      throw Invalid_input("the input has no faces");
    // Minima do not depend on the order of their computation.
    std::array<double, 6> box;
    boost::mpi::all_reduce(communicator_, low_and_negated_high_.data(), 6, box.data(), boost::mpi::minimum<double>());
    std::vector<Vector> ends = {{{box[0], box[1], box[2]}}, {{-box[3], -box[4], -box[5]}}};
    frame_ = to_local_frame(ends, {0, 1, 2}, Run_context());
    low_ = ends[0];
    high_ = ends[1];
  }

  const Local_frame& frame() const { return frame_; }
  Morton_curve curve() const { return Morton_curve(low_, high_); }
  std::uint64_t number_of_faces() const { return first_face_.back(); }
  std::uint64_t faces_of_piece() const { return faces_; }

  // Returns the rank whose piece contains a face, and the number of the face in this piece.
  std::pair<std::size_t, std::uint64_t> origin(std::uint64_t face) const
  {
    const auto piece = std::upper_bound(first_face_.begin(), first_face_.end(), face) - first_face_.begin() - 1;
    return {std::size_t(piece), face - first_face_[std::size_t(piece)]};
  }

  std::string name(std::uint64_t face) const
  {
    if (names_)
      return names_(face);
    const auto [piece, number] = origin(face);
    return "face " + std::to_string(number) + " of piece " + std::to_string(piece);
  }

  // Returns the first position of each block on the curve.
  std::vector<std::uint64_t> find_blocks(std::size_t faces_per_block) const
  {
    std::vector<std::uint64_t> places;
    on_all_ranks(communicator_, [&] {
      places.reserve(faces_);
      for_each_record([&](const Face_record& face) { places.push_back(face.place); });
    });
    return block_starts(std::move(places), faces_per_block, [this](const std::vector<std::uint64_t>& own) {
      std::vector<std::uint64_t> all(own.size());
      boost::mpi::all_reduce(communicator_, own.data(), int(own.size()), all.data(), std::plus<std::uint64_t>());
      return all;
    });
  }

  // Sends each face to its block.
  void read(const std::vector<std::uint64_t>& starts, const Bin_ranks& blocks, Word_store& store) const
  {
    Word_routing routing(context_, blocks, store);
    routing.run([&] {
      for_each_record([&](const Face_record& face) { routing.send(block_of(starts, face.place), face); });
    });
  }

private:
  void measure_face(const std::vector<std::uint64_t>& vertices, const std::vector<Vector>& points, double density)
  {
    context_.poll();
    if (!has_fault_ && !fault_of(vertices, points, density, std::string()).empty()) {
      has_fault_ = true;
      fault_.origin = faces_;
      fault_.density = density;
      fault_.vertex = vertices;
      fault_.point = points;
    }
    ++faces_;
    for (const Vector& p : points)
      for (std::size_t i = 0; i < 3; ++i) {
        low_and_negated_high_[i] = (std::min)(low_and_negated_high_[i], p[i]);
        low_and_negated_high_[i + 3] = (std::min)(low_and_negated_high_[i + 3], -p[i]);
      }
  }

  // Returns what is wrong with a face, or an empty string.
  static std::string fault_of(const std::vector<std::uint64_t>& vertices, const std::vector<Vector>& points, double density,
                              const std::string& name)
  {
    if (vertices.size() < 3 || vertices.size() > Face_data::max_corners)
      return name + " has " + std::to_string(vertices.size()) + " sides";
    if (!(density >= 1 / largest_density && density <= largest_density))
      return "the density of " + name + " is " + number_text(density) + ", not in [1e-20, 1e20]";
    for (std::size_t i = 0; i < vertices.size(); ++i)
      for (const double x : points[i])
        if (!std::isfinite(x))
          return "vertex " + std::to_string(vertices[i]) + ", in " + name + ", has a coordinate that is " + number_text(x);
    if (vertices.size() == 3 && vertices[0] != vertices[1] && vertices[1] != vertices[2] && vertices[2] != vertices[0])
      return std::string();
    std::vector<std::uint64_t> sorted = vertices;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    return twice == sorted.end() ? std::string() : name + " visits vertex " + std::to_string(*twice) + " twice";
  }

  void count_faces()
  {
    std::vector<std::uint64_t> faces;
    boost::mpi::all_gather(communicator_, faces_, faces);
    first_face_.assign(1, 0);
    for (const std::uint64_t n : faces)
      first_face_.push_back(first_face_.back() + n);
  }

  // Throws an exception that names the first invalid face.
  void throw_fault() const
  {
    if (faces_ >= NONE)
      throw Invalid_input("piece " + std::to_string(communicator_.rank()) + " has more faces than the " +
                          std::to_string(NONE - 1) + " that can be numbered");
    if (has_fault_)
      throw Invalid_input(
        fault_of(fault_.vertex, fault_.point, fault_.density, name(first_face_[context_.rank()] + fault_.origin)));
  }

  template <class Receive>
  void for_each_record(const Receive& receive) const
  {
    const Morton_curve place_of(low_, high_);
    Face_record face;
    std::uint64_t number = first_face_[context_.rank()];
    source_([&](const std::vector<std::uint64_t>& vertices, const std::vector<Vector>& points, double density) {
      context_.poll();
      face.vertex = vertices;
      face.point = points;
      for (Vector& p : face.point)
        p = frame_.to_local(p);
      face.begin_with_smallest_number();
      face.density = density;
      face.place = place_of(face.mean_of_corners());
      face.origin = number++;
      receive(face);
    });
  }

  Rank_context& context_;
  const boost::mpi::communicator& communicator_;
  const Face_source& source_;
  Face_names names_;
  static constexpr double inf = std::numeric_limits<double>::infinity();
  std::array<double, 6> low_and_negated_high_{{inf, inf, inf, inf, inf, inf}}; // of the vertices of this piece
  Local_frame frame_;
  Vector low_{{0, 0, 0}}, high_{{0, 0, 0}}; // of the mesh in its frame
  std::uint64_t faces_ = 0;                 // of this piece
  std::vector<std::uint64_t> first_face_;   // of each piece, and the total
  bool has_fault_ = false;
  Face_record fault_; // the first invalid face
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PIECE_BLOCKS_H
