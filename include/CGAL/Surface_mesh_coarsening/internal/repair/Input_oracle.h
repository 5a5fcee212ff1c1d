// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_INPUT_ORACLE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_INPUT_ORACLE_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Box_hierarchy.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Input_surface.h>
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

// The bounding boxes of blocks of consecutive faces of each cluster, and of groups of consecutive blocks.
class Cluster_boxes
{
public:
  static constexpr std::size_t faces_of_block = 8, blocks_of_group = 8;

  explicit Cluster_boxes(const Clustered_faces& surface)
    : surface_(surface), first_block_(surface.number_of_clusters() + 1, 0), first_group_(first_block_), first_face_(first_block_)
  {
    for (std::size_t x = 0; x < surface.number_of_clusters(); ++x) {
      first_face_[x + 1] = first_face_[x] + surface.faces(x).size();
      first_block_[x + 1] = first_block_[x] + number_of_parts(surface.faces(x).size(), faces_of_block);
      first_group_[x + 1] = first_group_[x] + number_of_parts(first_block_[x + 1] - first_block_[x], blocks_of_group);
      order_.insert(order_.end(), surface.faces(x).begin(), surface.faces(x).end());
    }
    compute_boxes();
  }

  // Puts near faces into the same blocks, for many searches.
  void sort()
  {
    for_each_cluster([this](std::size_t x) {
      std::vector<Bbox_3> boxes;
      std::vector<Index> numbers;
      for (const Index f : surface_.faces(x)) {
        numbers.push_back(Index(boxes.size()));
        boxes.push_back(face_box(surface_.input().mesh, f));
      }
      sort(boxes, numbers, 0, numbers.size());
      for (std::size_t i = 0; i < numbers.size(); ++i)
        order_[first_face_[x] + i] = surface_.faces(x).begin()[numbers[i]];
    });
    compute_boxes();
  }

  // Returns the bounding box of a cluster.
  Bbox_3 box(std::size_t cluster) const
  {
    Bbox_3 all;
    for (std::size_t i = first_group_[cluster]; i < first_group_[cluster + 1]; ++i)
      all += group_[i];
    return all;
  }

  // Calls `visit(squared distance from the box, faces)` for the blocks of a cluster whose boxes are not farther from a point than
  // `is_far(squared distance)` tells; its answer may change between calls. Returns the number of boxes compared.
  template <class Is_far, class Visit>
  std::size_t for_each_near(const Vector& p, std::size_t cluster, const Is_far& is_far, const Visit& visit) const
  {
    std::size_t compared = first_group_[cluster + 1] - first_group_[cluster];
    for (std::size_t g = first_group_[cluster]; g < first_group_[cluster + 1]; ++g) {
      if (is_far(squared_distance_from_box(p, group_[g])))
        continue;
      const std::size_t begin = first_block_[cluster] + (g - first_group_[cluster]) * blocks_of_group,
                        end = (std::min)(begin + blocks_of_group, first_block_[cluster + 1]);
      compared += end - begin;
      for (std::size_t i = begin; i < end; ++i) {
        const double squared_distance = squared_distance_from_box(p, block_[i]);
        if (!is_far(squared_distance))
          visit(squared_distance, faces(cluster, i));
      }
    }
    return compared;
  }

private:
  template <class Visit>
  void for_each_cluster(const Visit& visit) const
  {
    const Run_context context = surface_.context().uninterrupted();
    for_each_chunk(context, surface_.number_of_clusters(), 16, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t x = begin; x < end; ++x)
        visit(x);
    });
  }

  void compute_boxes()
  {
    block_.assign(first_block_.back(), Bbox_3());
    group_.assign(first_group_.back(), Bbox_3());
    for_each_cluster([this](std::size_t x) {
      for (std::size_t i = first_block_[x]; i < first_block_[x + 1]; ++i) {
        for (const Index f : faces(x, i))
          block_[i] += face_box(surface_.input().mesh, f);
        group_[group_of(x, i)] += block_[i];
      }
    });
  }

  static void sort(const std::vector<Bbox_3>& boxes, std::vector<Index>& numbers, std::size_t begin, std::size_t end)
  {
    if (end - begin <= faces_of_block)
      return;
    Bbox_3 extent;
    for (std::size_t i = begin; i < end; ++i)
      extent += boxes[numbers[i]];
    const std::size_t middle = divide_boxes(boxes, extent, numbers, begin, end);
    sort(boxes, numbers, begin, middle);
    sort(boxes, numbers, middle, end);
  }

  static std::size_t number_of_parts(std::size_t size, std::size_t size_of_part)
  {
    return (size + size_of_part - 1) / size_of_part;
  }

  std::size_t group_of(std::size_t cluster, std::size_t block) const
  {
    return first_group_[cluster] + (block - first_block_[cluster]) / blocks_of_group;
  }

  Clustered_faces::Range faces(std::size_t cluster, std::size_t block) const
  {
    const std::size_t begin = first_face_[cluster] + (block - first_block_[cluster]) * faces_of_block,
                      end = (std::min)(begin + faces_of_block, first_face_[cluster + 1]);
    return Clustered_faces::Range(order_.data() + begin, order_.data() + end);
  }

  const Clustered_faces& surface_;
  std::vector<std::size_t> first_block_, first_group_, first_face_; // of each cluster
  std::vector<Index> order_;                                        // of the faces in the blocks
  std::vector<Bbox_3> block_, group_;
};

// The properties of the input near coarse triangles: the orientation of the surface that they approximate, and whether this
// surface intersects itself there.
class Input_oracle
{
public:
  Input_oracle(const Clustered_faces& surface, Repair_budget& budget)
    : surface_(surface), input_(surface.input().mesh), boxes_(surface), normals_(surface.number_of_clusters()),
      budget_(budget)
  {
    const Run_context context = surface.context().uninterrupted();
    for_each_chunk(context, normals_.size(), 16, [this](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t x = begin; x < end; ++x)
        normals_[x] = mean_normal(x);
    });
  }

  // Prepares many tests of orientation.
  void sort_faces() { boxes_.sort(); }

  // The mean normal of the faces of a cluster. It is shorter for curved clusters, and zero if the faces have no area.
  const Vector& normal(Index cluster) const { return normals_[cluster]; }

  // Returns whether any cluster of a coarse triangle has an area.
  bool has_area(const Triangle& t) const
  {
    constexpr Vector none{{0, 0, 0}};
    return std::any_of(t.begin(), t.end(), [&](Index x) { return normals_[x] != none; });
  }

  // Returns whether a coarse triangle faces away from the surface at the closest point of its clusters. The point is computed
  // only if the mean normals are not decisive. If the point lies on an edge, or if several points are equally close, all faces
  // there count, so the result does not depend on rounding errors. Adds the number of triangles in the fans of the faces whose
  // distances it computes to `visited`, and a fraction of the number of boxes.
  bool is_against(const Triangle& t, const std::vector<Vector>& positions, std::size_t& visited) const
  {
    const Vector n = normal_of(positions, t), mean = normals_[t[0]] + normals_[t[1]] + normals_[t[2]];
    const double size = length(n);
    if (dot(n, mean) > 0.5 * size * length(mean))
      return false;
    const Vector middle = (1. / 3) * (positions[t[0]] + positions[t[1]] + positions[t[2]]);
    double nearest = squared_distance_from_nearest_block(middle, t, visited);
    std::size_t boxes = 0;
    std::vector<std::pair<double, Index> > faces;
    for (const Index x : t) {
      const auto begin = std::ptrdiff_t(faces.size());
      boxes += boxes_.for_each_near(
        middle, x, [&](double squared_distance) { return squared_distance > same_as(nearest, size); },
        [&](double, const Face_range& block) {
          for (const Index f : block) {
            visited += number_of_triangles(f);
            const double squared_distance = input_.squared_distance_from_face(middle, f, 1.000001 * same_as(nearest, size));
            if (squared_distance <= same_as(nearest, size))
              faces.emplace_back(squared_distance, f);
            nearest = (std::min)(nearest, squared_distance);
          }
        });
      // Sums that cancel must not depend on the order of the boxes.
      std::sort(faces.begin() + begin, faces.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    }
    visited += boxes / boxes_of_face;
    Vector there{{0, 0, 0}};
    for (const auto& [squared_distance, f] : faces)
      if (squared_distance <= same_as(nearest, size))
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
  // Returns the bound below which squared distances are equal up to rounding errors, for a triangle of about this squared size.
  static double same_as(double squared_distance, double squared_size)
  {
    return 1.000000001 * squared_distance + 1e-18 * squared_size;
  }

  typedef Clustered_faces::Range Face_range;

  // The distances from this many boxes take as long as the distance from a face.
  static constexpr std::size_t boxes_of_face = 8;

  Vector mean_normal(std::size_t cluster) const
  {
    constexpr double rounding = 1e-13; // exceeds the area of collinear points due to rounding of coordinates
    Vector sum{{0, 0, 0}};
    double area = 0;
    for (const Index f : surface_.faces(cluster)) {
      sum = sum + vector_area(surface_.input().mesh, f);
      area += surface_.area(f);
    }
    return area > rounding * squared_diagonal(boxes_.box(cluster)) ? (1 / area) * sum : Vector{{0, 0, 0}};
  }

  std::size_t number_of_triangles(Index f) const { return surface_.input().mesh.degree(f) - 2; }

  // Returns the squared distance from the faces of the block whose box is nearest. Adds the number of triangles in the fans of
  // the faces and a fraction of the number of boxes that it compares to `visited`.
  double squared_distance_from_nearest_block(const Vector& p, const Triangle& t, std::size_t& visited) const
  {
    double from_box = std::numeric_limits<double>::infinity(), nearest = from_box;
    std::size_t boxes = 0;
    Face_range block(nullptr, nullptr);
    for (const Index x : t)
      boxes += boxes_.for_each_near(
        p, x, [&](double squared_distance) { return squared_distance >= from_box; },
        [&](double squared_distance, const Face_range& faces) {
          from_box = squared_distance;
          block = faces;
        });
    visited += boxes / boxes_of_face;
    for (const Index f : block) {
      visited += number_of_triangles(f);
      nearest = (std::min)(nearest, input_.squared_distance_from_face(p, f, nearest));
    }
    return nearest;
  }

  bool clusters_intersect(Index x, Index y)
  {
    const std::uint64_t both = (std::uint64_t(x) << 32) | y;
    const auto known = intersecting_.find(both);
    if (known != intersecting_.end())
      return known->second;
    if (budget_.is_spent_for_input())
      return false;
    const std::vector<Triangle> of_x = pieces_at(x, boxes_.box(y)), of_y = pieces_at(y, boxes_.box(x));
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
  Input_surface input_;
  Cluster_boxes boxes_;
  std::vector<Vector> normals_;
  Repair_budget& budget_;
  std::unordered_map<std::uint64_t, bool> intersecting_; // tested pairs of clusters
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_INPUT_ORACLE_H
