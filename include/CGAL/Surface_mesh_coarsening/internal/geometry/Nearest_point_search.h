// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_NEAREST_POINT_SEARCH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_NEAREST_POINT_SEARCH_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/Bucketed_items.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/boxes.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The nearest point of a mesh, in a triangle of the fan around the first corner of its face. Ties go to the face of
// smallest number.
struct Nearest_point
{
  Index face = NONE;
  Index corner = NONE; // the second of the triangle
  Vector barycentric{{1, 0, 0}};
  double squared_distance = (std::numeric_limits<double>::infinity)();
};

inline void improve(const Flat_mesh& m, const Vector& p, Index f, Nearest_point& nearest)
{
  const Vector& a = m.points[m.corner_vertex[m.first_corner[f]]];
  for (Index c = m.first_corner[f] + 2; c != m.first_corner[f + 1]; ++c) {
    const Foot_point foot =
      closest_on_triangle(p, a, m.points[m.corner_vertex[c - 1]], m.points[m.corner_vertex[c]], nearest.squared_distance);
    if (foot.squared_distance < nearest.squared_distance ||
        (foot.squared_distance == nearest.squared_distance && f < nearest.face))
      nearest = {f, c - 1, foot.barycentric, foot.squared_distance};
  }
}

// Searches nearest points in a mesh whose faces form small patches, such as clusters, with a tree over the bounding
// boxes of these groups. The search begins with a nearby group.
//
// CGAL::AABB_tree does not serve here: degenerate faces have nearest points, too; a search begins with the group of the
// point, which in most cases contains the answer or nearly so, whereas the tree needs a nearby point as a hint; and of
// faces at the same distance the tree returns the first it visits, whereas results have to be reproducible.
class Nearest_point_search
{
public:
  // Omits faces of group NONE.
  Nearest_point_search(const Flat_mesh& mesh, const std::vector<Index>& group_of_face, std::size_t groups)
    : mesh_(mesh), faces_(numbers_below(Index(group_of_face.size())), groups, [&](Index f) { return group_of_face[f]; }),
      box_(groups)
  {
    for (std::size_t x = 0; x < groups; ++x)
      for (const Index f : faces_[x])
        for (const Index c : mesh.corners(f))
          box_[x] += box_of_point(mesh.points[mesh.corner_vertex[c]]);
    std::vector<Index> all;
    for (std::size_t x = 0; x < groups; ++x)
      if (!faces_[x].empty())
        all.push_back(Index(x));
    if (!all.empty())
      build(all, 0, all.size());
  }

  Bucketed_items<Index>::Range faces(Index group) const { return faces_[group]; }

  // May return any point whose squared distance is at most `near_enough`.
  Nearest_point operator()(const Vector& p, Index first_group, double near_enough = -1) const
  {
    Nearest_point nearest;
    improve_in(p, first_group, nearest, near_enough);
    std::vector<Index> stack(node_.empty() ? 0 : 1, 0);
    while (!stack.empty() && nearest.squared_distance > near_enough) {
      const Node& n = node_[stack.back()];
      stack.pop_back();
      // By rounding, a foot point may be nearer than the box.
      if (squared_distance_from_box(p, n.box) > (1 + 1e-12) * nearest.squared_distance)
        continue;
      if (n.group != NONE) {
        if (n.group != first_group)
          improve_in(p, n.group, nearest, near_enough);
        continue;
      }
      const bool left_first =
        squared_distance_from_box(p, node_[n.left].box) < squared_distance_from_box(p, node_[n.right].box);
      stack.push_back(left_first ? n.right : n.left);
      stack.push_back(left_first ? n.left : n.right);
    }
    return nearest;
  }

  void improve_in(const Vector& p, Index group, Nearest_point& nearest, double near_enough = -1) const
  {
    for (const Index f : faces_[group]) {
      improve(mesh_, p, f, nearest);
      if (nearest.squared_distance <= near_enough)
        return;
    }
  }

private:
  struct Node
  {
    Bbox_3 box;
    Index left = NONE, right = NONE, group = NONE;
  };

  Index build(std::vector<Index>& groups, std::size_t begin, std::size_t end)
  {
    const Index number = Index(node_.size());
    node_.emplace_back();
    Bbox_3 box, centers;
    for (std::size_t i = begin; i < end; ++i) {
      box += box_[groups[i]];
      centers += box_of_point(center(groups[i]));
    }
    node_[number].box = box;
    if (end - begin == 1) {
      node_[number].group = groups[begin];
      return number;
    }
    const Vector extent = high_corner(centers) - low_corner(centers);
    const std::size_t axis = std::max_element(extent.begin(), extent.end()) - extent.begin();
    const std::size_t middle = begin + (end - begin) / 2;
    std::nth_element(groups.begin() + begin, groups.begin() + middle, groups.begin() + end, [&](Index x, Index y) {
      const double a = center(x)[axis], b = center(y)[axis];
      return a < b || (a == b && x < y);
    });
    const Index left = build(groups, begin, middle), right = build(groups, middle, end);
    node_[number].left = left;
    node_[number].right = right;
    return number;
  }

  Vector center(Index group) const { return 0.5 * (low_corner(box_[group]) + high_corner(box_[group])); }

  const Flat_mesh& mesh_;
  Bucketed_items<Index> faces_; // per group
  std::vector<Bbox_3> box_; // per group
  std::vector<Node> node_;
};

// Returns coordinates of a point of a face, one per corner in the order of the corners. In a triangle they are
// barycentric. In a polygon they are mean value coordinates in its plane if these are not negative, as in every convex
// polygon. If they are negative, or if the polygon is not planar so that they would yield another point, they are
// barycentric in the triangle of the fan.
inline std::vector<double> coordinates_in_face(const Flat_mesh& m, const Nearest_point& nearest, const Vector& normal)
{
  const Index begin = m.first_corner[nearest.face], degree = m.degree(nearest.face);
  std::vector<double> fan(degree, 0);
  const Index corners[3] = {0, nearest.corner - begin, nearest.corner + 1 - begin};
  Vector p{{0, 0, 0}};
  for (int i = 0; i < 3; ++i) {
    fan[corners[i]] += nearest.barycentric[i];
    p = p + nearest.barycentric[i] * m.points[m.corner_vertex[begin + corners[i]]];
  }
  const double normal_length = std::sqrt(dot(normal, normal));
  if (degree == 3 || !(normal_length > 0))
    return fan;
  // With r_i the distance of corner i and t_i the tangent of half the angle under which side i is seen, the weight of
  // corner i is (t_{i-1} + t_i) / r_i.
  std::vector<Vector> to_corner(degree);
  std::vector<double> r(degree), tangent(degree), weight(degree);
  double extent = 0;
  for (Index i = 0; i < degree; ++i) {
    to_corner[i] = m.points[m.corner_vertex[begin + i]] - p;
    r[i] = std::sqrt(dot(to_corner[i], to_corner[i]));
    extent = (std::max)(extent, r[i]);
  }
  for (Index i = 0; i < degree; ++i) {
    const Index j = (i + 1) % degree;
    const double sine = dot(cross(to_corner[i], to_corner[j]), normal) / normal_length;
    const double cosine = dot(to_corner[i], to_corner[j]);
    // On a side or a corner the fan's coordinates are the same.
    if (r[i] * r[j] + cosine <= 1e-12 * extent * extent)
      return fan;
    tangent[i] = sine / (r[i] * r[j] + cosine);
  }
  double sum = 0;
  for (Index i = 0; i < degree; ++i) {
    if (!(r[i] > 1e-12 * extent))
      return fan;
    weight[i] = (tangent[(i + degree - 1) % degree] + tangent[i]) / r[i];
    if (!(weight[i] >= 0))
      return fan;
    sum += weight[i];
  }
  Vector offset{{0, 0, 0}};
  for (Index i = 0; i < degree; ++i) {
    weight[i] /= sum;
    offset = offset + weight[i] * to_corner[i];
  }
  return dot(offset, offset) <= 1e-24 * extent * extent ? weight : fan;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_NEAREST_POINT_SEARCH_H
