// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_SOURCE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_SOURCE_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

#include <cstddef>
#include <cstdint>
#include <functional>
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

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_SOURCE_H
