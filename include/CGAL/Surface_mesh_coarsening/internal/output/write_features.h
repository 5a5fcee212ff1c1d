// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_WRITE_FEATURES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_WRITE_FEATURES_H

#include <CGAL/Surface_mesh_coarsening/internal/features/Coarse_features.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/Triangle_patches.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

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

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_WRITE_FEATURES_H
