// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_NEAREST_POINT_SEARCH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_NEAREST_POINT_SEARCH_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Box_hierarchy.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The nearest point of a mesh, in a triangle of the fan around the first corner of its face. Of faces at equal distance, the face
// of smallest number is returned.
struct Nearest_point
{
  Index face = NONE;
  Index corner = NONE; // the second corner of the triangle
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

// Finds nearest points in a mesh whose faces form small patches, such as clusters, by a tree over the bounding boxes of these
// groups and of parts of them. A search begins with a nearby group.
//
// CGAL::AABB_tree is not used for three reasons. Degenerate faces must have nearest points, too. A search here begins with the
// group of the point, which in most cases contains the result or a close point, whereas the tree needs a nearby point as a hint.
// Of faces at the same distance, the tree returns the first face visited, whereas results must be reproducible.
class Nearest_point_search
{
public:
  // Omits faces of group NONE.
  Nearest_point_search(const Flat_mesh& mesh, const std::vector<Index>& group_of_face, std::size_t groups)
    : Nearest_point_search(mesh, Bucketed_items<Index>(numbers_below(Index(group_of_face.size())), groups,
                                                       [&](Index f) { return group_of_face[f]; }))
  {}

  // `faces` are the faces of each group.
  Nearest_point_search(const Flat_mesh& mesh, const Bucketed_items<Index>& faces) : mesh_(mesh), root_of_(faces.size(), NONE)
  {
    const std::size_t groups = faces.size();
    std::vector<Index> all;
    std::vector<Bbox_3> boxes(groups);
    std::size_t nodes = groups;
    for (std::size_t x = 0; x < groups; ++x) {
      nodes += max_nodes(faces[x].size());
      for (const Index f : faces[x])
        boxes[x] += face_box(mesh_, f);
      if (!faces[x].empty())
        all.push_back(Index(x));
    }
    order_.reserve(faces.items().size());
    node_.reserve(nodes);
    if (!all.empty())
      build(all, boxes, 0, all.size(), 1,
            [&](std::size_t begin, std::size_t) { return root_of_[all[begin]] = build_group(faces[all[begin]]); });
  }

  // If `near_enough` is given, may return any point whose squared distance is at most `near_enough`.
  Nearest_point operator()(const Vector& p, Index first_group, double near_enough = -1) const
  {
    std::size_t compared = 0;
    return (*this)(p, first_group, near_enough, compared);
  }

  // Adds the number of triangles and boxes with which the point is compared to `compared`.
  Nearest_point operator()(const Vector& p, Index first_group, double near_enough, std::size_t& compared) const
  {
    Nearest_point nearest;
    if (root_of_[first_group] != NONE)
      compared += improve_below(root_of_[first_group], NONE, p, nearest, near_enough);
    if (!node_.empty())
      compared += improve_below(0, root_of_[first_group], p, nearest, near_enough);
    return nearest;
  }

  // Replaces a point by the nearest point of a group if it is nearer. Returns the number of triangles and boxes compared.
  std::size_t improve_in(const Vector& p, Index group, Nearest_point& nearest) const
  {
    return root_of_[group] == NONE ? 0 : improve_below(root_of_[group], NONE, p, nearest, -1);
  }

  // Calls `visit` with the faces of a group whose squared distance from a point is at most `limit`. Returns the number of
  // triangles and boxes compared.
  template <class Visit>
  std::size_t for_each_within(const Vector& p, Index group, double limit, const Visit& visit) const
  {
    std::size_t compared = 0;
    if (root_of_[group] != NONE)
      visit_within(root_of_[group], p, limit, visit, compared);
    return compared;
  }

private:
  static constexpr std::size_t max_faces = 16; // of a leaf

  struct Node
  {
    Bbox_3 box;
    bool is_leaf;
    Index first, second; // the children; in a leaf, the range of its faces
    Index turned;        // the turned box; NONE if it is not narrow
  };

  typedef std::pair<Index, double> Waiting_node; // with the squared distance from its box

  // Returns a bound on the number of nodes for so many faces.
  static std::size_t max_nodes(std::size_t faces)
  {
    std::size_t leaves = 1;
    while (leaves * max_faces < faces)
      leaves *= 2;
    return 2 * leaves - 1;
  }

  // A box with axes that follow the faces of a node. The bounding boxes of long triangles around a vertex overlap each other, but
  // their turned boxes do not.
  struct Turned_box
  {
    std::array<Vector, 3> axes; // orthonormal
    std::array<double, 3> low, high;

    void add(const Vector& p)
    {
      for (std::size_t i = 0; i < 3; ++i) {
        const double at = dot(axes[i], p);
        low[i] = (std::min)(low[i], at - margin(p));
        high[i] = (std::max)(high[i], at + margin(p));
      }
    }

    double squared_distance(const Vector& p) const
    {
      double sum = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double at = dot(axes[i], p), d = (std::max)((std::max)(low[i] - at, at - high[i]) - margin(p), 0.);
        sum += d * d;
      }
      return sum;
    }

    double width(std::size_t i) const { return high[i] - low[i]; }

    // Exceeds the rounding errors of dot products with axes.
    static double margin(const Vector& p) { return 1e-14 * (std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2])); }
  };

  template <class Visit>
  void visit_within(Index node, const Vector& p, double limit, const Visit& visit, std::size_t& compared) const
  {
    const Node& n = node_[node];
    ++compared;
    if (squared_distance_from_box(p, n.box) > limit)
      return;
    if (!n.is_leaf) {
      visit_within(n.first, p, limit, visit, compared);
      visit_within(n.second, p, limit, visit, compared);
      return;
    }
    for (Index i = n.first; i < n.second; ++i) {
      Nearest_point point;
      point.squared_distance = limit; // farther triangles are rejected early
      improve(mesh_, p, order_[i], point);
      compared += mesh_.degree(order_[i]) - 2;
      if (point.face != NONE)
        visit(order_[i]);
    }
  }

  // Omits the subtree of another node. Returns the number of triangles and boxes with which the point is compared.
  std::size_t improve_below(Index root, Index omitted, const Vector& p, Nearest_point& nearest, double near_enough) const
  {
    boost::container::small_vector<Waiting_node, 64> stack(1, {root, squared_distance_from_box(p, node_[root].box)});
    std::size_t compared = 0;
    while (!stack.empty() && nearest.squared_distance > near_enough) {
      ++compared;
      const auto [number, squared_distance] = stack.back();
      const Node& n = node_[number];
      stack.pop_back();
      // Due to rounding, a foot point may be nearer than the box.
      const double limit = (1 + 1e-12) * nearest.squared_distance;
      if (number == omitted || squared_distance > limit || is_beyond_turned_box(p, n, limit))
        continue;
      if (n.is_leaf) {
        for (Index i = n.first; i < n.second && nearest.squared_distance > near_enough; ++i) {
          improve(mesh_, p, order_[i], nearest);
          compared += mesh_.degree(order_[i]) - 2;
        }
        continue;
      }
      const Waiting_node first{n.first, squared_distance_from_box(p, node_[n.first].box)},
        second{n.second, squared_distance_from_box(p, node_[n.second].box)};
      const bool is_first_nearer = is_nearer(p, first, second);
      stack.push_back(is_first_nearer ? second : first);
      stack.push_back(is_first_nearer ? first : second);
    }
    return compared;
  }

  bool is_nearer(const Vector& p, const Waiting_node& n, const Waiting_node& than) const
  {
    const Index turned = node_[n.first].turned, other = node_[than.first].turned;
    return n.second != than.second || turned == NONE || other == NONE
             ? n.second < than.second
             : turned_[turned].squared_distance(p) < turned_[other].squared_distance(p);
  }

  bool is_beyond_turned_box(const Vector& p, const Node& n, double limit) const
  {
    return n.turned != NONE && turned_[n.turned].squared_distance(p) > limit;
  }

  // Returns the number of a turned box around the faces in the leaves from `begin`, or NONE if the box is not narrow.
  Index turned_box(const std::array<Vector, 3>& axes, Index begin)
  {
    constexpr double narrow = 0.25, far = std::numeric_limits<double>::infinity();
    Turned_box box{axes, {{far, far, far}}, {{-far, -far, -far}}};
    for (std::size_t i = begin; i < order_.size(); ++i)
      for (const Index c : mesh_.corners(order_[i]))
        box.add(mesh_.points[mesh_.corner_vertex[c]]);
    if (!(box.width(1) < narrow * box.width(0)))
      return NONE;
    turned_.push_back(box);
    return Index(turned_.size() - 1);
  }

  // The same for a leaf. The first axis is the longest side of the first triangles of the faces, and the second axis is
  // orthogonal to it in the plane of this triangle.
  Index turned_box_of_leaf(const Node& leaf)
  {
    constexpr double narrow = 0.1;
    double longest = 0;
    Vector side{{0, 0, 0}}, next = side;
    for (Index i = leaf.first; i < leaf.second; ++i) {
      const auto corner = mesh_.corner_vertex.begin() + mesh_.first_corner[order_[i]];
      for (int k = 0; k < 3; ++k) {
        const Vector &from = mesh_.points[corner[k]], edge = mesh_.points[corner[(k + 1) % 3]] - from;
        if (dot(edge, edge) > longest) {
          longest = dot(edge, edge);
          side = edge;
          next = mesh_.points[corner[(k + 2) % 3]] - from;
        }
      }
    }
    const double length = std::sqrt(longest);
    const Vector first = (1 / length) * side, height = next - dot(first, next) * first;
    const double size = std::sqrt(dot(height, height));
    if (!(size > 1e-6 * length && size < narrow * length))
      return NONE;
    Vector third = cross(first, height);
    third = (1 / std::sqrt(dot(third, third))) * third;
    return turned_box({{first, cross(third, first), third}}, leaf.first);
  }

  // Divides items along the axis along which the centers of their boxes are spread most, until at most `max_items` remain for
  // `make_leaf(begin, end)`. Both functions return the number of a node.
  template <class Make_leaf>
  Index build(std::vector<Index>& items, const std::vector<Bbox_3>& boxes, std::size_t begin, std::size_t end,
              std::size_t max_items, const Make_leaf& make_leaf)
  {
    if (end - begin <= max_items)
      return make_leaf(begin, end);
    Bbox_3 box, centers;
    for (std::size_t i = begin; i < end; ++i) {
      const Bbox_3& b = boxes[items[i]];
      box += b;
      centers += box_of_point({{doubled_center(b, 0), doubled_center(b, 1), doubled_center(b, 2)}});
    }
    const std::size_t middle = divide_boxes(boxes, centers, items, begin, end);
    const Index number = Index(node_.size()), first_of_order = Index(order_.size());
    node_.push_back({box, false, NONE, NONE, NONE});
    const Index first = build(items, boxes, begin, middle, max_items, make_leaf),
                second = build(items, boxes, middle, end, max_items, make_leaf);
    node_[number].first = first;
    node_[number].second = second;
    if (node_[first].turned != NONE && node_[second].turned != NONE)
      node_[number].turned = turned_box(turned_[node_[first].turned].axes, first_of_order);
    return number;
  }

  Index build_group(const Bucketed_items<Index>::Range& faces)
  {
    std::vector<Bbox_3> boxes;
    for (const Index f : faces)
      boxes.push_back(face_box(mesh_, f));
    std::vector<Index> items(boxes.size());
    std::iota(items.begin(), items.end(), Index(0));
    const Index first = Index(order_.size());
    return build(items, boxes, 0, items.size(), max_faces, [&](std::size_t begin, std::size_t end) {
      Node leaf{Bbox_3(), true, Index(first + begin), Index(first + end), NONE};
      for (std::size_t i = begin; i < end; ++i) {
        leaf.box += boxes[items[i]];
        order_.push_back(faces.begin()[items[i]]);
      }
      leaf.turned = turned_box_of_leaf(leaf);
      node_.push_back(leaf);
      return Index(node_.size() - 1);
    });
  }

  const Flat_mesh& mesh_;
  std::vector<Index> order_;   // of the faces, in the leaves
  std::vector<Index> root_of_; // per group
  std::vector<Node> node_;
  std::vector<Turned_box> turned_;
};

// Finds nearest points on the triangles of a coarse mesh.
class Coarse_mesh_search
{
public:
  Coarse_mesh_search(const std::vector<Triangle>& triangles, const std::vector<Vector>& positions)
    : mesh_(mesh_of(triangles, positions)),
      search_(mesh_, Bucketed_items<Index>(numbers_below(Index(triangles.size())), positions.size(),
                                           [&](Index t) { return triangles[t][0]; }))
  {}

  Coarse_mesh_search(const Coarse_mesh_search&) = delete;
  Coarse_mesh_search& operator=(const Coarse_mesh_search&) = delete;

  const Flat_mesh& mesh() const { return mesh_; }

  // The search begins at the triangles whose first corner is `vertex`.
  Nearest_point operator()(const Vector& p, Index vertex) const { return search_(p, vertex); }

private:
  static Flat_mesh mesh_of(const std::vector<Triangle>& triangles, const std::vector<Vector>& positions)
  {
    Flat_mesh mesh;
    mesh.points = positions;
    mesh.first_corner.push_back(0);
    for (const Triangle& t : triangles) {
      mesh.corner_vertex.insert(mesh.corner_vertex.end(), t.begin(), t.end());
      mesh.first_corner.push_back(Index(mesh.corner_vertex.size()));
    }
    return mesh;
  }

  const Flat_mesh mesh_;
  const Nearest_point_search search_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_NEAREST_POINT_SEARCH_H
