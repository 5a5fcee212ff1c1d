// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_INPUT_ORACLE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_INPUT_ORACLE_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Box_hierarchy.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Nearest_point_search.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Triangle_conflicts.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Repair_budget.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The properties of the input near coarse triangles: the orientation of the surface that they approximate, and whether this
// surface intersects itself there.
class Input_oracle
{
public:
  Input_oracle(const Clustered_faces& surface, Repair_budget& budget)
    : surface_(surface), normals_(surface.number_of_clusters()), boxes_(normals_.size()), budget_(budget)
  {
    const Run_context context = surface.context().uninterrupted();
    for_each_chunk(context, normals_.size(), 16, [this](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t x = begin; x < end; ++x)
        measure_cluster(x);
    });
  }

  const Clustered_faces& surface() const { return surface_; }

  // The mean normal of the faces of a cluster. It is shorter for curved clusters, and zero if the faces have no area.
  const Vector& normal(Index cluster) const { return normals_[cluster]; }

  // Returns whether any cluster of a coarse triangle has an area.
  bool has_area(const Triangle& t) const
  {
    constexpr Vector none{{0, 0, 0}};
    return std::any_of(t.begin(), t.end(), [&](Index x) { return normals_[x] != none; });
  }

  // Prepares concurrent calls of `is_against()` for some triangles.
  void prepare(const std::vector<Triangle>& triangles, const std::vector<Vector>& positions)
  {
    for (const Triangle& t : triangles)
      if (!is_along_mean_normals(t, positions))
        for (const Index x : t)
          search_in(x);
  }

  // Returns whether a coarse triangle faces away from the surface at the closest point of its clusters. The point is computed
  // only if the mean normals are not decisive. If the point lies on an edge, or if several points are equally close, all faces
  // there count, so the result does not depend on rounding errors. Adds the work to `visited`, in triangles whose distances are
  // computed.
  bool is_against(const Triangle& t, const std::vector<Vector>& positions, std::size_t& visited)
  {
    if (is_along_mean_normals(t, positions))
      return false;
    const Vector n = normal_of(positions, t);
    const double size = length(n);
    const Vector middle = (1. / 3) * (positions[t[0]] + positions[t[1]] + positions[t[2]]);
    Nearest_point nearest;
    for (const Index x : t)
      visited += search_in(x).improve_in(middle, 0, nearest) / comparisons_of_face;
    // The bound below which squared distances are equal up to rounding errors, for a triangle of about this squared size.
    const double limit = 1.000000001 * nearest.squared_distance + 1e-18 * size;
    std::vector<Index> faces;
    for (const Index x : t)
      visited += search_in(x).for_each_within(middle, 0, limit, [&](Index f) { faces.push_back(f); }) / comparisons_of_face;
    std::sort(faces.begin(), faces.end()); // sums that cancel must not depend on the order
    Vector there{{0, 0, 0}};
    for (const Index f : faces)
      there = there + vector_area(surface_.input().mesh, f);
    return dot(n, there) < -1e-9 * size * length(there);
  }

  // Returns whether faces of the clusters of two coarse triangles intersect. Faces with a common vertex are not tested, because
  // they are many and rarely have more points in common. If very many coarse triangles intersect beside huge faces, only the first
  // pairs of clusters are tested, and the others count as not intersecting. Intersections of an approximation of the input say
  // nothing about the input, which is then assumed to have none.
  bool intersects_itself(const Triangle& t, const Triangle& u)
  {
    if (surface_.is_approximate())
      return false;
    for (const Index x : t)
      for (const Index y : u)
        if (clusters_intersect((std::min)(x, y), (std::max)(x, y)))
          return true;
    return false;
  }

private:
  // The comparisons of a point with this many boxes or faces take as long as the distance from a face.
  static constexpr std::size_t comparisons_of_face = 4;

  void measure_cluster(std::size_t cluster)
  {
    constexpr double rounding = 1e-13; // exceeds the area of collinear points due to rounding of coordinates
    Vector sum{{0, 0, 0}};
    double area = 0;
    for (const Index f : surface_.faces(cluster)) {
      sum = sum + vector_area(surface_.input().mesh, f);
      area += surface_.area(f);
      boxes_[cluster] += face_box(surface_.input().mesh, f);
    }
    normals_[cluster] = area > rounding * squared_diagonal(boxes_[cluster]) ? (1 / area) * sum : Vector{{0, 0, 0}};
  }

  bool is_along_mean_normals(const Triangle& t, const std::vector<Vector>& positions) const
  {
    const Vector n = normal_of(positions, t), mean = normals_[t[0]] + normals_[t[1]] + normals_[t[2]];
    return dot(n, mean) > 0.5 * length(n) * length(mean);
  }

  // The search for nearest points in a cluster. Few clusters need one.
  const Nearest_point_search& search_in(Index cluster)
  {
    const auto found = search_.find(cluster);
    if (found != search_.end())
      return found->second;
    const Bucketed_items<Index> faces(surface_.faces(cluster), 1, [](Index) { return 0; });
    return search_.try_emplace(cluster, surface_.input().mesh, faces).first->second;
  }

  bool clusters_intersect(Index x, Index y)
  {
    const std::uint64_t both = (std::uint64_t(x) << 32) | y;
    const auto known = intersecting_.find(both);
    if (known != intersecting_.end())
      return known->second;
    if (budget_.is_spent_for_input())
      return false;
    const std::vector<Triangle> of_x = pieces_at(x, boxes_[y]), of_y = pieces_at(y, boxes_[x]);
    std::size_t work = of_x.size() + of_y.size();
    const bool result = pieces_intersect(of_x, of_y, work);
    budget_.spend_on_input(work);
    return intersecting_[both] = result;
  }

  // Tests so many pairs at most; then assumes that there is no intersection. Where all boxes overlap, as in a fan of very many
  // long triangles, testing all pairs would take quadratic time.
  static std::size_t max_pairs(std::size_t pieces) { return 1000 + 16 * pieces; }

  // Adds the work of the tests to `work`.
  bool pieces_intersect(const std::vector<Triangle>& of_x, const std::vector<Triangle>& of_y, std::size_t& work) const
  {
    if (of_x.empty() || of_y.empty())
      return false;
    const Triangle_conflict conflict(surface_.input().mesh.points);
    Box_hierarchy hierarchy;
    hierarchy.build(conflict.boxes(of_y));
    const std::size_t most = max_pairs(of_x.size() + of_y.size());
    std::size_t left = most;
    bool found = false;
    for (std::size_t i = 0; i < of_x.size() && !found && left > 0; ++i)
      hierarchy.for_each_overlapping(conflict.box(of_x[i]), [&](Index j) {
        if (found || left == 0)
          return;
        --left;
        found = !have_common_corner(of_x[i], of_y[j]) && conflict(of_x[i], of_y[j]);
      });
    work += (most - left) / 8 + conflict.take_work(); // a comparison of corners takes a fraction of the time of a test
    return found;
  }

  static bool have_common_corner(const Triangle& t, const Triangle& u)
  {
    return std::find_first_of(t.begin(), t.end(), u.begin(), u.end()) != t.end();
  }

  // Returns the faces of a cluster, triangulated as fans, that may intersect a box.
  std::vector<Triangle> pieces_at(Index x, const Bbox_3& box) const
  {
    std::vector<Triangle> triangles;
    for (const Index f : surface_.faces(x)) {
      if (!do_overlap(face_box(surface_.input().mesh, f), box))
        continue;
      const Clustered_faces::Range v = surface_.vertices(f);
      for (std::size_t i = 2; i < v.size(); ++i)
        triangles.push_back({v.begin()[0], v.begin()[i - 1], v.begin()[i]});
    }
    return triangles;
  }

  const Clustered_faces& surface_;
  std::vector<Vector> normals_; // of each cluster, as the next ones
  std::vector<Bbox_3> boxes_;
  std::unordered_map<Index, Nearest_point_search> search_;
  Repair_budget& budget_;
  std::unordered_map<std::uint64_t, bool> intersecting_; // tested pairs of clusters
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_INPUT_ORACLE_H
