// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_VERTEX_NUMBERS_IMPL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_VERTEX_NUMBERS_IMPL_H

#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>
#include <CGAL/Surface_mesh_coarsening/internal/seeding/Initial_clustering.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

inline bool may_use_quadrics(const Clustering_state& state, const Seeding& seeding)
{
  return state.may_use_quadrics && seeding.may_use_quadrics && seeding.kind == Seeding::FOR_NUMBER && !state.subdivides_input;
}

// Returns how clusters of faces are merged. Long clusters need the exchange of vertices: without it, more triangles are narrow.
inline Merging merging(const Clustering_state& state, const Seeding& seeding)
{
  if (may_use_quadrics(state, seeding) && state.exchange_rounds > 0)
    return Merging::BY_QUADRICS;
  return state.follows_paper ? Merging::BY_AREA : Merging::BY_MASS;
}

// Returns whether the cells of vertices serve better than faces. A face is half a vertex, so clusters of few faces have vertices
// off the surface. Faces serve for the smallest numbers, because they determine the range of numbers.
inline bool needs_vertex_cells(const Clustering_state& state, const Seeding& seeding)
{
  std::size_t vertices = 0, enough = 0;
  for (const Component& c : state.base_input().mesh.components) {
    vertices += c.max_clusters();
    enough += Component_plan::sufficient_clusters(c);
  }
  const double share = double(seeding.value) / double(vertices);
  return may_use_quadrics(state, seeding) &&
         (share > min_share_of_dense || (share > min_share_of_cells && seeding.value >= enough));
}

// Calls `use` with a function that returns the clustering which finds the attainable numbers of clusters.
template <class Use>
auto with_attainable_numbers(const Clustering_state& state, const Use& use)
{
  Coarsening_report unused;
  const std::optional<Featured_input> faces =
    has_vertex_cells(state.input) ? std::make_optional(with_items(state.input, Feature_cells::AT_FEATURES, state.context))
                                  : std::nullopt;
  return use([&] { return Initial_clustering(faces ? *faces : state.input, merging(state, Seeding()), unused, state.context); });
}

CGAL_SURFACE_MESH_COARSENING_INLINE std::pair<std::size_t, std::size_t> vertex_number_range(const Clustering_state& state)
{
  return with_attainable_numbers(state, [&](const auto& unclustered) {
    auto range = unclustered().range();
    if (!state.subdivides_input)
      return range;
    range.second = Initial_clustering::max_clusters_of_subdivided(faces_per_cluster);
    // Pieces of faces may permit fewer clusters than the faces, but are only made for numbers that are too large for the faces.
    std::size_t sufficient = unclustered().input().items.mesh.number_of_faces() / faces_per_cluster; // for the faces as they are
    while (range.first > sufficient) {
      Initial_clustering finer = unclustered();
      finer.subdivide(sufficient + 1, faces_per_cluster);
      const std::size_t least = sufficient + 1;
      sufficient = finer.input().items.mesh.number_of_faces() / faces_per_cluster;
      range.first = (std::max)(least, finer.range().first);
    }
    return range;
  });
}

inline std::size_t part_of(std::size_t vertices, double ratio)
{
  const double number = std::round(ratio * double(vertices));
  if (!(ratio > 0 && number < double(NONE)))
    throw Invalid_input("the vertex ratio is " + number_text(ratio));
  return std::size_t(number);
}

CGAL_SURFACE_MESH_COARSENING_INLINE std::size_t number_of_vertices(const Clustering_state& state, double ratio)
{
  std::size_t vertices = 0;
  for (const Component& c : state.base_input().mesh.components)
    vertices += c.vertices;
  return (std::max)(part_of(vertices, ratio), std::size_t(1));
}

// Makes all edges and vertices of the components that cannot be reduced to the ratio features, which are kept.
CGAL_SURFACE_MESH_COARSENING_INLINE std::size_t keep_small_components(Clustering_state& state, double ratio)
{
  const std::vector<std::size_t> minima =
    with_attainable_numbers(state, [](const auto& unclustered) { return unclustered().minima(); });
  const Clustering_input& base = state.base_input();
  std::vector<char> is_small;
  std::size_t reduced = 0, kept = 0; // vertices
  for (std::size_t i = 0; i < minima.size(); ++i) {
    const std::size_t vertices = base.mesh.components[i].max_clusters();
    is_small.push_back(part_of(vertices, ratio) < minima[i]);
    (is_small.back() ? kept : reduced) += vertices;
  }
  if (kept == 0)
    return number_of_vertices(state, ratio);
  Feature_edges edges = state.input.cells ? state.input.cells->edges() : Feature_edges(base.mesh);
  for (std::size_t f = 0; f < base.mesh.number_of_faces(); ++f)
    if (is_small[base.mesh.component[f]])
      for (const Index c : base.mesh.corners(f)) {
        edges.is_feature[c] = base.mesh.face_across[c] != NONE;
        edges.is_corner[base.mesh.corner_vertex[c]] = true;
      }
  state.input = Feature_cells::run(Clustering_input(base), edges, state.context);
  return kept + part_of(reduced, ratio);
}

// Returns the number of vertices of a triangle mesh with the topology of the input, by Euler's formula.
inline double vertices_of_triangle_mesh(const Flat_mesh& mesh, double faces, double border_edges)
{
  double characteristic = 0;
  for (const Component& c : mesh.components)
    characteristic += double(c.euler_characteristic());
  return (faces + border_edges) / 2 + characteristic;
}

inline std::size_t number_of_border_edges(const Flat_mesh& mesh)
{
  std::size_t n = 0;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Index c : mesh.corners(f))
      n += mesh.face_across[c] == NONE;
  return n;
}

// The number of vertices of the border of the result is known only after the minimization, so several numbers are tried.
CGAL_SURFACE_MESH_COARSENING_INLINE std::size_t vertices_for_faces(Clustering_state& state, std::size_t faces,
                                                                   const Minimization_end& end)
{
  constexpr int max_trials = 8;
  const Flat_mesh& mesh = state.base_input().mesh;
  const double all = double(number_of_vertices(state, 1)), wanted = double(faces);
  const double border = double(number_of_border_edges(mesh));
  const auto to_number = [&](double n) { return std::size_t((std::min)((std::max)(std::round(n), 1.), all)); };
  // The border is a curve, so its vertices are about the square root of their part.
  std::size_t n = to_number(vertices_of_triangle_mesh(mesh, wanted, border * std::sqrt((std::min)(1., wanted / (2 * all)))));
  if (border == 0)
    return n;
  std::map<double, std::size_t> number_by_deviation;
  std::map<std::size_t, double> deviations;
  for (int i = 0; i < max_trials && deviations.count(n) == 0; ++i) {
    seed(state, {Seeding::FOR_NUMBER, n, true});
    grow(state);
    minimize(state, end);
    const double deviation = wanted - double(dual_triangles(labels(state), state.context).size());
    deviations[n] = deviation;
    number_by_deviation.emplace(std::abs(deviation), n);
    n = to_number(double(n) + (std::abs(deviation) == 1 ? deviation : std::trunc(deviation / 2)));
  }
  return number_by_deviation.begin()->second;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_VERTEX_NUMBERS_IMPL_H
