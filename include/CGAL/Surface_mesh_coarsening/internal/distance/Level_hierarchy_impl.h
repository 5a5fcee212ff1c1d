// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_LEVEL_HIERARCHY_IMPL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_LEVEL_HIERARCHY_IMPL_H

#include <CGAL/Surface_mesh_coarsening/internal/distance/Distance_bound.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/Level_hierarchy.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/place_vertices.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Estimates the distance between a mesh and its coarse mesh: the largest distance in both directions, at the vertices of the
// mesh, at the vertices of the coarse mesh and at points of its triangles, with more points where distances are large. The
// estimate is fast, but no bound.
class Distance_estimate
{
public:
  Distance_estimate(const Cluster_labels& labels, const std::vector<Vector>& positions,
                    const std::vector<Triangle>& triangles, const Run_context& context)
    : labels_(labels), mesh_(labels.mesh()), positions_(positions), coarse_(triangles, positions.size()), context_(context)
  {}

  double distance() const { return std::sqrt(from_coarse(to_coarse())); }

private:
  struct Part
  {
    Corner_points corners;
    Triangle clusters; // the clusters in which the search begins
  };

  double to_coarse() const
  {
    double largest = 0;
    std::vector<Index> around;
    for (std::size_t v = 0; v < mesh_.number_of_vertices(); ++v) {
      context_.poll(16);
      around.clear();
      for (const Index f : mesh_.faces_around(v))
        if (around.empty() || around.back() != labels_[f])
          around.push_back(labels_[f]);
      if (around.empty())
        continue;
      double least = std::numeric_limits<double>::infinity();
      for (const Index x : around)
        improve_around(mesh_.points[v], x, largest, least);
      // Edge flips may have moved the triangle that was at this place away from these vertices.
      for (double before = -1; least > largest && least != before;) {
        before = least;
        const std::vector<Index> inner(around);
        for (const Index x : inner)
          for (const Index t : coarse_.around(x))
            around.insert(around.end(), coarse_.triangles()[t].begin(), coarse_.triangles()[t].end());
        sort_unique(around);
        for (const Index x : around)
          improve_around(mesh_.points[v], x, largest, least);
      }
      largest = (std::max)(largest, least);
    }
    return largest;
  }

  // Stops when the result can no longer change.
  void improve_around(const Vector& p, Index x, double largest, double& least) const
  {
    for (const Index t : coarse_.around(x)) {
      const Triangle& c = coarse_.triangles()[t];
      if (least > largest)
        least = (std::min)(least, closest_on_triangle(p, positions_[c[0]], positions_[c[1]], positions_[c[2]]).squared_distance);
    }
  }

  // Subdivides the parts of triangles whose distance may exceed the largest distance so far.
  double from_coarse(double largest) const
  {
    const Nearest_point_search search(mesh_, labels_.labels(), positions_.size());
    const auto look_at = [&](const Vector& p, Index x, double near_enough) {
      context_.poll(64);
      const double d = search(p, x, near_enough).squared_distance;
      largest = (std::max)(largest, d);
      return d;
    };
    for (std::size_t x = 0; x < positions_.size(); ++x)
      look_at(positions_[x], Index(x), largest);
    std::vector<Part> parts;
    for (const Triangle& t : coarse_.triangles())
      parts.push_back({{{positions_[t[0]], positions_[t[1]], positions_[t[2]]}}, t});
    for (int i = 0; !parts.empty(); ++i) {
      std::vector<Part> far;
      for (const Part& part : parts) {
        const Vector center = center_of(part.corners);
        const double rise = i < divisions ? steepness * radius_about(center, part.corners) : 0;
        const double low = (std::max)(std::sqrt(largest) - rise, 0.);
        if (!(look_at(center, part.clusters[0], low * low) > low * low && i < divisions))
          continue;
        const auto& [c, x] = part;
        const Corner_points middles{{0.5 * (c[1] + c[2]), 0.5 * (c[2] + c[0]), 0.5 * (c[0] + c[1])}};
        far.push_back({middles, x});
        for (int k = 0; k < 3; ++k)
          far.push_back({{{c[k], middles[(k + 2) % 3], middles[(k + 1) % 3]}}, {{x[k], x[k], x[k]}}});
      }
      parts = std::move(far);
    }
    return largest;
  }

  static constexpr int divisions = 5;
  // Assumed Lipschitz constant of the distance to the surface along the triangles; only the value 1 would be certain.
  static constexpr double steepness = 0.5;
  const Cluster_labels& labels_;
  const Flat_mesh& mesh_;
  const std::vector<Vector>& positions_;
  Flippable_triangulation coarse_;
  const Run_context context_;
};

inline const Clustering_input& input_without_features(const Clustering_state& state)
{
  if (state.featured_input().cells && state.featured_input().cells->has_features())
    throw Invalid_input("clusters cannot be edited, nor merged to levels, where features are kept");
  return state.working_input();
}

CGAL_SURFACE_MESH_COARSENING_INLINE Level_hierarchy::Level_hierarchy(const Clustering_state& state)
  : state_(state), history_(input_without_features(state), labels(state), Index(state.number_of_clusters()), state.context)
{}

CGAL_SURFACE_MESH_COARSENING_INLINE std::vector<Index> Level_hierarchy::clusters_of_faces(std::size_t level,
                                                                                          std::size_t number) const
{
  const std::vector<Index> of_cluster = history_.ancestors(history_.finest(), level);
  std::vector<Index> clusters(number);
  for (std::size_t f = 0; f < number; ++f)
    clusters[f] = of_cluster[history_.number(Index(cluster_of_face(state_, Index(f))))];
  return clusters;
}

CGAL_SURFACE_MESH_COARSENING_INLINE Placed_level Level_hierarchy::place(std::size_t level, const Placement_model& placement,
                                                                        const Output_coordinates& output_coordinates) const
{
  const Featured_input& input = state_.featured_input();
  // The faces with geometry; the items may be cells without geometry.
  const Clustering_input& pieces = input.cells ? input.cells->pieces() : input.items;
  const std::vector<Index> of_cluster = history_.ancestors(history_.finest(), level);
  Placed_level placed{Cluster_labels(pieces.mesh), history_.triangles(level), {}};
  for (std::size_t f = 0; f < pieces.mesh.number_of_faces(); ++f) {
    const Index item = input.cells ? input.cells->polygon(Index(f)) : Index(f);
    placed.labels.set(Index(f), of_cluster[history_.number(labels(state_)[item])]);
  }
  placed.labels.recount();
  const Clustered_faces surface(pieces, placed.labels, level, state_.context);
  Repair_counts counts;
  placed.positions = place_vertices({surface, Border_arcs(surface, !state_.follows_paper), placement}, state_.repairs_output,
                                    output_coordinates, placed.triangles, counts);
  return placed;
}

CGAL_SURFACE_MESH_COARSENING_INLINE double Level_hierarchy::estimate(const Placed_level& placed) const
{
  return Distance_estimate(placed.labels, placed.positions, placed.triangles, state_.context).distance();
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_LEVEL_HIERARCHY_IMPL_H
