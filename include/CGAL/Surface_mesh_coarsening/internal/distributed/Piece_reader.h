// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PIECE_READER_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PIECE_READER_H

#include <CGAL/Surface_mesh_coarsening/internal/distributed/Face_set.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

template <class DensityMap, class Face>
double density_of(const DensityMap& map, Face f, const Face_origin& origin)
{
  const double r = CGAL::to_double(get(map, f));
  if (!(r >= 1 / largest_density && r <= largest_density))
    throw Invalid_input("the density of " + name_of(origin) + " is " + number_text(r) + ", not in [1e-20, 1e20]");
  return r;
}
template <class Face>
double density_of(const CGAL::internal_np::Param_not_found&, Face, const Face_origin&)
{
  return 1;
}

// Copies the faces of a piece, in the order in which it gives them. A face begins with its vertex of the smallest number.
template <class FaceGraph, class VertexNumberMap, class NamedParameters>
class Piece_reader
{
public:
  Piece_reader(const FaceGraph& piece, const VertexNumberMap& numbers, const NamedParameters& np, int rank)
    : piece_(piece), numbers_(numbers), coordinates_(piece, np), densities_(get_parameter(np, internal_np::face_density)),
      rank_(Index(rank))
  {}

  void run(Face_set& set, const Cancellation_point& cancellation) const
  {
    std::size_t n = 0;
    for (const auto f : faces(piece_)) {
      cancellation.poll();
      if (n >= NONE)
        throw Invalid_input("piece " + std::to_string(rank_) + " has more faces than the " + std::to_string(NONE - 1) +
                            " that can be numbered");
      add_face(f, {rank_, Index(n++)}, set);
    }
  }

private:
  typedef typename boost::graph_traits<FaceGraph>::face_descriptor face_descriptor;

  void add_face(face_descriptor f, const Face_origin& origin, Face_set& set) const
  {
    const std::size_t first = set.vertex.size();
    for (const auto h : halfedges_around_face(halfedge(f, piece_), piece_)) {
      const auto v = target(h, piece_);
      set.vertex.push_back(std::uint64_t(get(numbers_, v)));
      set.point.push_back(coordinates_(v));
      for (const double x : set.point.back())
        if (!std::isfinite(x))
          throw Invalid_input("vertex " + std::to_string(set.vertex.back()) + ", in " + name_of(origin) +
                              ", has a coordinate that is " + number_text(x));
    }
    const auto begin = set.vertex.begin() + std::ptrdiff_t(first);
    const auto shift = std::min_element(begin, set.vertex.end()) - begin;
    std::rotate(begin, begin + shift, set.vertex.end());
    const auto point = set.point.begin() + std::ptrdiff_t(first);
    std::rotate(point, point + shift, set.point.end());
    check(std::vector<std::uint64_t>(begin, set.vertex.end()), origin);
    set.first_corner.push_back(set.vertex.size());
    set.place.push_back(0);
    set.cluster.push_back(NONE);
    set.origin.push_back(origin);
    set.density.push_back(density_of(densities_, f, origin));
  }

  static void check(std::vector<std::uint64_t> vertices, const Face_origin& origin)
  {
    if (vertices.size() < 3)
      throw Invalid_input(name_of(origin) + " has " + std::to_string(vertices.size()) + " sides");
    std::sort(vertices.begin(), vertices.end());
    const auto twice = std::adjacent_find(vertices.begin(), vertices.end());
    if (twice != vertices.end())
      throw Invalid_input(name_of(origin) + " visits vertex " + std::to_string(*twice) + " twice");
  }

  const FaceGraph& piece_;
  const VertexNumberMap& numbers_;
  Vertex_coordinates<FaceGraph, NamedParameters> coordinates_;
  const std::decay_t<decltype(get_parameter(std::declval<NamedParameters>(), internal_np::face_density))> densities_;
  Index rank_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PIECE_READER_H
