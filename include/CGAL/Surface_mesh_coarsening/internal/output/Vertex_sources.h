// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_VERTEX_SOURCES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_VERTEX_SOURCES_H

#include <CGAL/Surface_mesh_coarsening/Surface_location.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Numbering.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/properties.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Returns the cluster of each vertex of a mesh: among the clusters of the incident faces, the cluster of largest area there, and
// of equal areas the smallest number. Vertices without faces get `clusters`.
inline std::vector<Index> clusters_of_vertices(const Flat_mesh& m, const std::vector<double>& area,
                                               const std::vector<Index>& cluster_of_face, Index clusters)
{
  std::vector<Index> result(m.number_of_vertices(), clusters);
  std::vector<std::pair<Index, double> > around;
  for (std::size_t v = 0; v < result.size(); ++v) {
    around.clear();
    for (const Index f : m.faces_around(v))
      around.emplace_back(cluster_of_face[f], area[f]);
    std::sort(around.begin(), around.end());
    double largest = -1;
    for (std::size_t i = 0; i < around.size();) {
      const Index x = around[i].first;
      double sum = 0;
      for (; i < around.size() && around[i].first == x; ++i)
        sum += around[i].second;
      if (sum > largest) {
        largest = sum;
        result[v] = x;
      }
    }
  }
  return result;
}

// Writes the clusters of the faces of the input; faces of removed components get `number`.
template <class FaceGraph, class Map>
void write_face_clusters(const Numbering<FaceGraph>& numbering, const Clustering_input& input,
                         const std::vector<Index>& clusters, std::size_t number, const Map& map)
{
  typedef typename boost::property_traits<Map>::value_type Value;
  const auto& faces = numbering.faces;
  std::vector<Index> of_face(faces.size(), Index(number));
  for (std::size_t i = 0; i < clusters.size(); ++i)
    of_face[input.parent_of(Index(i))] = clusters[i];
  for (std::size_t f = 0; f < faces.size(); ++f)
    put(map, faces[f], Value(of_face[f]));
}
template <class FaceGraph>
void write_face_clusters(const Numbering<FaceGraph>&, const Clustering_input&, const std::vector<Index>&, std::size_t,
                         const CGAL::internal_np::Param_not_found&)
{}

template <class FaceGraph, class Map>
void write_vertex_clusters(const Numbering<FaceGraph>& numbering, const Clustering_input& input,
                           const std::vector<Index>& clusters, std::size_t number, const Map& map)
{
  typedef typename boost::property_traits<Map>::value_type Value;
  const std::vector<Index> of_vertex = clusters_of_vertices(input.mesh, input.area, clusters, Index(number));
  const auto& vertices = numbering.vertices;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    put(map, vertices[v], Value(of_vertex[v]));
}
template <class FaceGraph>
void write_vertex_clusters(const Numbering<FaceGraph>&, const Clustering_input&, const std::vector<Index>&, std::size_t,
                           const CGAL::internal_np::Param_not_found&)
{}

// Throws Invalid_input if sources are requested and the output replaces the input.
template <class Map, class FaceGraph, class Output>
void check_input_stays(const FaceGraph& input, const Output& output)
{
  const bool has_map = !std::is_same<Map, CGAL::internal_np::Param_not_found>::value;
  if (has_map && static_cast<const void*>(&input) == static_cast<const void*>(&output))
    throw Invalid_input("a vertex_source_map was given, but the output is the input, which the sources would lie on");
}

// Finds the sources of the vertices on the input before the output changes, and writes them after the output has its
// vertices.
template <class FaceGraph, class Map>
class Vertex_sources
{
public:
  explicit Vertex_sources(const Map& map) : map_(map) {}

  void find(const FaceGraph& mesh, const Numbering<FaceGraph>& numbering, const Clustering_input& input,
            const std::vector<Index>& clusters, const std::vector<Vector>& positions, const Cancellation_point& cancellation)
  {
    locations_ = surface_locations(mesh, numbering, input, clusters, positions, cancellation);
  }

  template <class Output>
  void write(const Output& output)
  {
    std::size_t i = 0;
    for (const auto v : vertices(output))
      put(map_, v, std::move(locations_[i++]));
  }

private:
  Map map_;
  std::vector<Surface_location<FaceGraph> > locations_;
};

template <class FaceGraph>
class Vertex_sources<FaceGraph, CGAL::internal_np::Param_not_found>
{
public:
  explicit Vertex_sources(const CGAL::internal_np::Param_not_found&) {}
  void find(const FaceGraph&, const Numbering<FaceGraph>&, const Clustering_input&, const std::vector<Index>&,
            const std::vector<Vector>&, const Cancellation_point&)
  {}
  template <class Output>
  void write(const Output&) {}
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_VERTEX_SOURCES_H
