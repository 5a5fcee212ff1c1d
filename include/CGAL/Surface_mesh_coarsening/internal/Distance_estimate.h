// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_ESTIMATE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_ESTIMATE_H

#include <CGAL/Surface_mesh_coarsening/internal/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/Coarse_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/Nearest_point_search.h>
#include <CGAL/Surface_mesh_coarsening/internal/sort_out.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// About how far a mesh and its coarse mesh are from each other: the largest distance, both ways, at the vertices of the mesh
// and at vertices of the coarse mesh and points of its triangles, many where these are far. Fast, and no bound.
class Distance_estimate
{
public:
  Distance_estimate(const Cluster_labels& labels, const std::vector<Vector>& positions,
                    const std::vector<Triangle>& triangles, const Checkpoint& checkpoint)
    : labels_(labels), mesh_(labels.mesh()), positions_(positions), coarse_(triangles, positions.size()),
      checkpoint_(checkpoint)
  {}

  double distance() const { return std::sqrt(from_coarse(to_coarse())); }

private:
  double to_coarse() const
  {
    double largest = 0;
    std::vector<Index> around;
    for (std::size_t v = 0; v < mesh_.number_of_vertices(); ++v) {
      checkpoint_.pass(16);
      around.clear();
      for (Index i = mesh_.first_in_star[v]; i != mesh_.first_in_star[v + 1]; ++i)
        if (around.empty() || around.back() != labels_[mesh_.star[i]])
          around.push_back(labels_[mesh_.star[i]]);
      if (around.empty())
        continue;
      double least = -1;
      for (const Index x : around)
        improve_around(mesh_.points[v], x, largest, least);
      // Flips of edges may have taken the triangle that lies here away from these vertices.
      if (least > largest) {
        const std::vector<Index> first(around);
        for (const Index x : first)
          for (const Index t : coarse_.around(x))
            around.insert(around.end(), coarse_.triangles()[t].begin(), coarse_.triangles()[t].end());
        sort_out(around);
        for (const Index x : around)
          improve_around(mesh_.points[v], x, largest, least);
      }
      largest = (std::max)(largest, least);
    }
    return largest;
  }

  // Up to what would not change the result.
  void improve_around(const Vector& p, Index x, double largest, double& least) const
  {
    for (const Index t : coarse_.around(x))
      if (least < 0 || least > largest)
        least = least < 0 ? squared_distance(p, t) : (std::min)(least, squared_distance(p, t));
  }

  double squared_distance(const Vector& p, Index t) const
  {
    const Triangle& c = coarse_.triangles()[t];
    return closest_on_triangle(p, positions_[c[0]], positions_[c[1]], positions_[c[2]]).squared_distance;
  }

  // Looks closer at the parts of triangles that are far away.
  double from_coarse(double largest) const
  {
    const Nearest_point_search search(mesh_, labels_.labels(), positions_.size());
    const auto distance_at = [&](const Vector& p, Index x) {
      checkpoint_.pass(64);
      const double d = search(p, x).squared_distance;
      largest = (std::max)(largest, d);
      return d;
    };
    for (std::size_t x = 0; x < positions_.size(); ++x)
      distance_at(positions_[x], Index(x));
    std::vector<Part> parts;
    for (const Triangle& t : coarse_.triangles())
      parts.push_back({{{positions_[t[0]], positions_[t[1]], positions_[t[2]]}}, t[0]});
    for (int i = 0; !parts.empty(); ++i) {
      std::vector<double> distances;
      for (const Part& part : parts)
        distances.push_back(distance_at(center(part), part.cluster));
      std::vector<Part> far;
      for (std::size_t j = 0; j < parts.size() && i < divisions; ++j)
        if (distances[j] > far_away * largest)
          divide(parts[j], far);
      parts = std::move(far);
    }
    return largest;
  }

  struct Part
  {
    std::array<Vector, 3> corners;
    Index cluster; // near which to begin to look
  };

  static Vector center(const Part& part)
  {
    return (1. / 3) * (part.corners[0] + part.corners[1] + part.corners[2]);
  }

  static void divide(const Part& part, std::vector<Part>& parts)
  {
    const auto& c = part.corners;
    const std::array<Vector, 3> middles{{0.5 * (c[1] + c[2]), 0.5 * (c[2] + c[0]), 0.5 * (c[0] + c[1])}};
    parts.push_back({middles, part.cluster});
    for (int i = 0; i < 3; ++i)
      parts.push_back({{{c[i], middles[(i + 2) % 3], middles[(i + 1) % 3]}}, part.cluster});
  }

  static constexpr int divisions = 4;
  static constexpr double far_away = 0.25; // of the largest squared distance
  const Cluster_labels& labels_;
  const Flat_mesh& mesh_;
  const std::vector<Vector>& positions_;
  Coarse_surface coarse_;
  Checkpoint checkpoint_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_ESTIMATE_H
