// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_OUTPUT_MAPS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_OUTPUT_MAPS_H

#include <CGAL/Surface_mesh_coarsening/Surface_location.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Coarse_features.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Numbering.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Returns the region between feature lines of each face; regions are numbered from 0 in the order of the faces.
inline std::vector<long long> regions(const Flat_mesh& m, const Feature_edges& edges)
{
  std::vector<long long> region(m.number_of_faces(), -1);
  std::vector<Index> reached;
  long long number = 0;
  for (std::size_t seed = 0; seed < region.size(); ++seed) {
    if (region[seed] >= 0)
      continue;
    region[seed] = number;
    flood_fill(m, Index(seed), reached, Run_context(), [&](Index c, Index g) {
      if (edges.is_feature[c] || region[g] >= 0)
        return false;
      region[g] = number;
      return true;
    });
    ++number;
  }
  return region;
}

// The patches of the triangles of a coarse mesh, whose edges may have been flipped and whose vertices may have been exchanged.
// Lines separate patches. A triangle at a line belongs to the patch on the same side of the line in the input. The other
// triangles belong to the patch of their neighbors.
class Triangle_patches
{
public:
  // `labels` are the labels of the clustered mesh, `patches` the patches of the faces of the caller's mesh. If `patches` is
  // empty, regions are numbered instead.
  Triangle_patches(const std::vector<Triangle>& triangles, const Coarse_features* features, const Featured_input& input,
                   const Cluster_labels& labels, const std::vector<long long>& patches)
    : triangles_(triangles), input_(input), labels_(labels), patches_(patches),
      pieces_(input.cells ? input.cells->pieces() : input.items)
  {
    if (patches.empty() && input.cells)
      regions_ = regions(input.cells->base().mesh, input.cells->edges());
    if (features)
      for (const Coarse_features::Line& line : features->lines())
        add_line(line);
  }

  std::vector<long long> run() const
  {
    std::vector<Index> face = faces_at_lines();
    std::vector<Index> reached;
    for (std::size_t t = 0; t < face.size(); ++t)
      if (face[t] != NONE)
        reached.push_back(Index(t));
    spread(face, reached);
    const std::vector<Index> some = some_faces();
    for (std::size_t t = 0; t < face.size(); ++t)
      if (face[t] == NONE)
        face[t] = some[triangles_[t][0]]; // this component has no lines
    std::vector<long long> result;
    for (const Index f : face)
      result.push_back(patch_of(f));
    return result;
  }

private:
  typedef std::pair<Index, Index> Side; // of a triangle, from one cluster to the next

  // Finds the faces on both sides of each edge of the line, at the point where the line enters the next cluster.
  void add_line(const Coarse_features::Line& line)
  {
    const std::size_t n = line.arcs.size();
    for (std::size_t i = line.is_loop ? 0 : 1; i < n; ++i) {
      const Coarse_features::Arc& arc = line.arcs[i];
      const Index previous = line.arcs[(i + n - 1) % n].cluster;
      face_at_side_[{previous, arc.cluster}] = face_left_of(arc.vertices[0], arc.vertices[1]);
      face_at_side_[{arc.cluster, previous}] = face_left_of(arc.vertices[1], arc.vertices[0]);
    }
  }

  // NONE on the border.
  Index face_left_of(Index source, Index target) const
  {
    const Flat_mesh& m = pieces_.mesh;
    for (const Index f : m.faces_around(source))
      if (m.corner_vertex[m.next_corner(f, m.corner_of(f, source))] == target)
        return f;
    return NONE;
  }

  std::vector<Index> faces_at_lines() const
  {
    std::vector<Index> face(triangles_.size(), NONE);
    for (std::size_t t = 0; t < face.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto found = face_at_side_.find({triangles_[t][i], triangles_[t][(i + 1) % 3]});
        if (found != face_at_side_.end())
          face[t] = found->second;
      }
    return face;
  }

  void spread(std::vector<Index>& face, std::vector<Index>& reached) const
  {
    const auto source = [this](Index side) { return triangles_[side / 3][side % 3]; };
    const std::vector<Index> opposite = opposite_sides(triangles_.size(), number_of_clusters(), source);
    for (std::size_t k = 0; k < reached.size(); ++k)
      for (Index side = 3 * reached[k]; side < 3 * reached[k] + 3; ++side) {
        const Index t = opposite[side] == NONE ? NONE : opposite[side] / 3;
        if (t == NONE || face[t] != NONE)
          continue;
        face[t] = face[reached[k]];
        reached.push_back(t);
      }
  }

  std::size_t number_of_clusters() const
  {
    Index last = 0;
    for (const Triangle& t : triangles_)
      last = (std::max)({last, t[0], t[1], t[2]});
    return std::size_t(last) + 1;
  }

  // Returns a face of each cluster.
  std::vector<Index> some_faces() const
  {
    std::vector<Index> some(number_of_clusters(), NONE);
    for (std::size_t f = 0; f < pieces_.mesh.number_of_faces(); ++f) {
      const Index label = labels_[input_.cells ? input_.cells->polygon(Index(f)) : Index(f)];
      if (label < some.size())
        some[label] = Index(f);
    }
    return some;
  }

  long long patch_of(Index face) const
  {
    if (!patches_.empty())
      return patches_[pieces_.parent_of(face)];
    return regions_.empty() ? pieces_.mesh.component[face] : regions_[input_.cells->base_face(face)];
  }

  const std::vector<Triangle>& triangles_;
  const Featured_input& input_;
  const Cluster_labels& labels_;
  const std::vector<long long>& patches_;
  const Clustering_input& pieces_;
  std::vector<long long> regions_;
  std::map<Side, Index> face_at_side_;
};

template <class Output>
auto vertices_of(const Output& output)
{
  return std::vector<typename boost::graph_traits<Output>::vertex_descriptor>(vertices(output).begin(), vertices(output).end());
}

template <class Output, class Vertices>
auto halfedge_between(const Output& output, const Vertices& vertices, Index x, Index y)
{
  return halfedge(vertices[x], vertices[y], output).first;
}

template <class Output, class Map>
void write_patches(const Output& output, const Map& map, const std::vector<Triangle>& triangles,
                   const Coarse_features* features, const Featured_input& input, const Cluster_labels& labels,
                   const std::vector<long long>& patches)
{
  typedef typename boost::property_traits<Map>::value_type Value;
  const auto v = vertices_of(output);
  const std::vector<long long> patch = Triangle_patches(triangles, features, input, labels, patches).run();
  for (std::size_t t = 0; t < triangles.size(); ++t)
    put(map, face(halfedge_between(output, v, triangles[t][0], triangles[t][1]), output), static_cast<Value>(patch[t]));
}
template <class Output>
void write_patches(const Output&, const CGAL::internal_np::Param_not_found&, const std::vector<Triangle>&,
                   const Coarse_features*, const Featured_input&, const Cluster_labels&, const std::vector<long long>&)
{}

template <class Output, class Map>
void write_lines(const Output& output, const Map& map, const Coarse_features* features)
{
  const auto v = vertices_of(output);
  for (const auto e : edges(output))
    put(map, e, false);
  if (!features)
    return;
  for (const Coarse_features::Line& line : features->lines()) {
    const std::size_t n = line.arcs.size();
    for (std::size_t i = line.is_loop ? 0 : 1; i < n; ++i)
      put(map, edge(halfedge_between(output, v, line.arcs[(i + n - 1) % n].cluster, line.arcs[i].cluster), output), true);
  }
}
template <class Output>
void write_lines(const Output&, const CGAL::internal_np::Param_not_found&, const Coarse_features*)
{}

template <class Output, class Map>
void write_corners(const Output& output, const Map& map, const Coarse_features* features)
{
  std::size_t i = 0;
  for (const auto v : vertices(output))
    put(map, v, features && features->corners()[i++] != NONE);
}
template <class Output>
void write_corners(const Output&, const CGAL::internal_np::Param_not_found&, const Coarse_features*)
{}

// Writes the maps that the parameters of the output request. `triangles` are the triangles of `output` in order.
template <class Output, class NamedParameters>
void write_features(const Output& output, const NamedParameters& np, const std::vector<Triangle>& triangles,
                    const Coarse_features* features, const Featured_input& input, const Cluster_labels& labels,
                    const std::vector<long long>& patches)
{
  write_patches(output, get_parameter(np, CGAL::internal_np::face_patch), triangles, features, input, labels, patches);
  write_lines(output, get_parameter(np, CGAL::internal_np::edge_is_constrained), features);
  write_corners(output, get_parameter(np, CGAL::internal_np::vertex_is_constrained), features);
}

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

// Writes the clusters of the faces of the input.
template <class FaceGraph, class Map>
void write_face_clusters(const Numbering<FaceGraph>& numbering, const std::vector<Index>& clusters, const Map& map)
{
  typedef typename boost::property_traits<Map>::value_type Value;
  for (std::size_t f = 0; f < clusters.size(); ++f)
    put(map, numbering.faces[f], Value(clusters[f]));
}
template <class FaceGraph>
void write_face_clusters(const Numbering<FaceGraph>&, const std::vector<Index>&, const CGAL::internal_np::Param_not_found&)
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
            const std::vector<Index>& clusters, const std::vector<Vector>& positions, const Run_context& context)
  {
    locations_ = surface_locations(mesh, numbering, input, clusters, positions, context);
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
            const std::vector<Vector>&, const Run_context&)
  {}
  template <class Output>
  void write(const Output&) {}
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_OUTPUT_MAPS_H
