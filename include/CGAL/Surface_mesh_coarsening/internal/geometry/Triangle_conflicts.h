// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_TRIANGLE_CONFLICTS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_TRIANGLE_CONFLICTS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Box_hierarchy.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intersections_3/Segment_3_Triangle_3.h>
#include <CGAL/Intersections_3/Triangle_3_Triangle_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

typedef Exact_predicates_inexact_constructions_kernel Exact_tests;
typedef Exact_tests::Point_3 Exact_point;

// A pair of triangles by number, the smaller first.
typedef std::pair<Index, Index> Triangle_pair;

// Tests exactly whether triangles have more points in common than their common vertices. A degenerate triangle conflicts with
// a neighbor only if its longest side does. The orientation of directions is tested first: where exponents differ much, the
// filters of CGAL fail, and its exact numbers have hundreds of digits. Counts the work of exact numbers, so each thread has its
// own copy.
class Triangle_conflict
{
public:
  explicit Triangle_conflict(const std::vector<Vector>& points) : points_(points) {}

  // Returns the work of all tests since the last call, in usual tests.
  std::size_t take_work() const { return std::exchange(work_, 0); }

  bool operator()(const Triangle& t, const Triangle& u) const
  {
    ++work_;
    std::array<int, 3> in_u{{-1, -1, -1}};
    int common = 0, shared = 0, other = 0; // the last common corner of t, and the last one that is not
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        if (t[i] == u[j])
          in_u[i] = j;
      common += in_u[i] >= 0;
      (in_u[i] >= 0 ? shared : other) = i;
    }
    if (common == 3)
      return true;
    if (common == 2) {
      const int i = (other + 1) % 3, j = (other + 2) % 3;
      const Index a = t[i], b = t[j], c = t[other], d = u[3 - in_u[i] - in_u[j]];
      return !are_across(a, b, c, d) && folds(a, b, c, d);
    }
    if (common == 1) {
      const int j = in_u[shared];
      const Index a = u[(j + 1) % 3], b = u[(j + 2) % 3], c = t[(shared + 1) % 3], d = t[(shared + 2) % 3];
      // Around a vertex of high valence, all boxes of triangles overlap, but few of them contain an opposite edge.
      if (!do_overlap(box(a, b), box(t)) && !do_overlap(box(c, d), box(u)))
        return false;
      if (const std::optional<bool> certain = cross_certainly(t[shared], a, b, c, d))
        return *certain;
      if (are_apart(t[shared], a, b, c, d))
        return false;
      // In most cases, all corners of one triangle except the common corner lie on one side of the plane of the other triangle.
      if (are_beside(t, {a, b}) || are_beside(u, {c, d}))
        return false;
      return crosses(t, a, b) || crosses(u, c, d);
    }
    if (const std::optional<bool> certain = cross_certainly(t, u))
      return *certain;
    if (are_beside(u, {t[0], t[1], t[2]}) || are_beside(t, {u[0], u[1], u[2]}) || is_flat(t) || is_flat(u))
      return false;
    count_exact_computation({t[0], t[1], t[2], u[0], u[1], u[2]});
    return do_intersect(triangle(t), triangle(u));
  }

  // Returns whether the corners are collinear.
  bool is_flat(const Triangle& t) const { return are_collinear(t[0], t[1], t[2]); }

  // Returns whether the corners coincide. Such a triangle conflicts with no other triangle.
  bool is_point(const Triangle& t) const { return points_[t[0]] == points_[t[1]] && points_[t[1]] == points_[t[2]]; }

  Bbox_3 box(const Triangle& t) const { return box(t[0], t[1]) + box_of_point(points_[t[2]]); }

  std::vector<Bbox_3> boxes(const std::vector<Triangle>& triangles) const
  {
    std::vector<Bbox_3> all;
    all.reserve(triangles.size());
    for (const Triangle& t : triangles)
      all.push_back(box(t));
    return all;
  }

private:
  Bbox_3 box(Index a, Index b) const { return box_of_point(points_[a]) + box_of_point(points_[b]); }

  // Exceeds the relative error of determinants and of dot products of three terms, unless these are smaller than the second
  // number.
  static constexpr double rounding = 1e-14, least_bound = 1e-290;

  // Returns whether edge ab certainly separates `c` and `d` if the four points are coplanar. In flat regions, most neighbors are
  // separated, and exact tests take long.
  bool are_across(Index a, Index b, Index c, Index d) const
  {
    const Vector edge = vector_between(a, b), to_c = vector_between(a, c), to_d = vector_between(a, d);
    const double bound = rounding * dot(edge, edge) * std::sqrt(dot(to_c, to_c) * dot(to_d, to_d));
    return bound > least_bound && dot(cross(edge, to_c), cross(edge, to_d)) < -bound;
  }

  // The corners of two triangles, relative to the first corner of one of them.
  struct Relative_corners
  {
    Vector second, third; // of this triangle
    std::array<Vector, 3> other;
    double size; // the largest distance

    // The dot products of the other corners with a vector.
    std::array<double, 3> heights(const Vector& v) const { return {{dot(v, other[0]), dot(v, other[1]), dot(v, other[2])}}; }

    // Returns whether the dot products with a vector certainly separate the triangles.
    bool are_separated_by(const Vector& v) const { return are_separated_by(v, heights(v)); }
    bool are_separated_by(const Vector& v, const std::array<double, 3>& heights) const
    {
      const auto [least, largest] = std::minmax({heights[0], heights[1], heights[2]});
      if (!(least > 0 || largest < 0))
        return false;
      const double bound = 2 * rounding * length(v) * size, x = dot(v, second), y = dot(v, third);
      return bound > least_bound &&
             (least > (std::max)((std::max)(x, y), 0.) + bound || largest < (std::min)((std::min)(x, y), 0.) - bound);
    }

    // Returns whether the other triangle lies about in the plane orthogonal to a vector through the first corner.
    bool is_flat_along(const Vector& v, const std::array<double, 3>& heights) const
    {
      return largest_coordinate(heights) <= 2 * rounding * length(v) * size;
    }
  };

  Relative_corners relative_corners(const Triangle& t, const Triangle& u) const
  {
    const auto to = [&](Index v) { return vector_between(t[0], v); };
    Relative_corners r{to(t[1]), to(t[2]), {{to(u[0]), to(u[1]), to(u[2])}}, 0};
    double square = (std::max)(dot(r.second, r.second), dot(r.third, r.third));
    for (const Vector& v : r.other)
      square = (std::max)(square, dot(v, v));
    r.size = std::sqrt(square);
    return r;
  }

  // A relative error of heights over a plane for which the points where sides cross this plane are nearly exact.
  static constexpr double part_of_certain_height = 1e-7;

  // Returns where a triangle meets the plane of another one, as the range of dot products with the direction of the line in both
  // planes; nothing unless all `heights` of its corners over the other plane exceed `least`, on both sides of it.
  static std::optional<std::pair<double, double> > section(const std::array<Vector, 3>& corners,
                                                           const std::array<double, 3>& heights, double least,
                                                           const Vector& line)
  {
    std::size_t above = 0;
    for (const double h : heights) {
      if (!(least > least_bound && std::abs(h) > least))
        return std::nullopt;
      above += h > 0;
    }
    if (above == 0 || above == 3)
      return std::nullopt;
    std::size_t alone = 0;
    while ((heights[alone] > 0) != (above == 1))
      ++alone;
    std::array<double, 2> ends;
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t other = (alone + 1 + i) % 3;
      const double x = heights[alone] / (heights[alone] - heights[other]);
      ends[i] = (1 - x) * dot(line, corners[alone]) + x * dot(line, corners[other]);
    }
    return std::minmax(ends[0], ends[1]);
  }

  // Returns whether two triangles without a common vertex intersect, if rounding errors certainly do not matter. They do not
  // matter for most pairs. Exact tests take longer, in particular for coplanar triangles. Compares the sections of the two
  // planes (T. Moeller, A fast triangle-triangle intersection test, Journal of Graphics Tools 2(2), 1997).
  std::optional<bool> cross_certainly(const Triangle& t, const Triangle& u) const
  {
    const Relative_corners r = relative_corners(t, u);
    const Vector n = cross(r.second, r.third);
    const std::array<double, 3> heights_of_u = r.heights(n);
    if (r.are_separated_by(n, heights_of_u))
      return false;
    const Relative_corners s = relative_corners(u, t);
    const Vector m = cross(s.second, s.third);
    const std::array<double, 3> heights_of_t = s.heights(m);
    if (s.are_separated_by(m, heights_of_t))
      return false;
    if (r.is_flat_along(n, heights_of_u) &&
        (r.are_separated_by(cross(n, r.second)) || r.are_separated_by(cross(n, r.third)) ||
         r.are_separated_by(cross(n, r.third - r.second)) || s.are_separated_by(cross(m, s.second)) ||
         s.are_separated_by(cross(m, s.third)) || s.are_separated_by(cross(m, s.third - s.second))))
      return false;
    constexpr double tolerance = 1e-5, parallel = 1e-6;
    const Vector line = cross(n, m);
    const double sides_of_t = length(r.second) * length(r.third), sides_of_u = length(s.second) * length(s.third),
                 size = (std::max)(r.size, s.size), length_of_line = length(line);
    if (!(sides_of_t > least_bound && sides_of_u > least_bound &&
          length_of_line > (std::max)(parallel * sides_of_t * sides_of_u, least_bound)))
      return std::nullopt;
    const double least = part_of_certain_height * size;
    const auto of_t = section(s.other, heights_of_t, least * sides_of_u, line),
               of_u = section({{{{0, 0, 0}}, s.second, s.third}}, heights_of_u, least * sides_of_t, line);
    if (!of_t || !of_u)
      return std::nullopt;
    const double common = (std::min)(of_t->second, of_u->second) - (std::max)(of_t->first, of_u->first);
    if (!(std::abs(common) > (std::max)(tolerance * size * length_of_line, least_bound)))
      return std::nullopt;
    return common > 0;
  }

  // The same for triangles (common, a, b) and (common, c, d). The planes meet in a line through the common vertex. Each triangle
  // contains a part of this line on one side of the vertex.
  std::optional<bool> cross_certainly(Index common, Index a, Index b, Index c, Index d) const
  {
    const std::array<Vector, 2> first{{vector_between(common, a), vector_between(common, b)}},
      second{{vector_between(common, c), vector_between(common, d)}};
    std::array<Vector, 2> on_line;
    for (const bool of_first : {true, false}) {
      const std::array<Vector, 2>&of = of_first ? first : second, &other = of_first ? second : first;
      const Vector n = cross(other[0], other[1]);
      const double unit = length(other[0]) * length(other[1]), x = dot(n, of[0]), y = dot(n, of[1]),
                   unit_of_x = unit * length(of[0]), unit_of_y = unit * length(of[1]);
      if (!(unit > least_bound && std::abs(x) - rounding * unit_of_x > least_bound &&
            std::abs(y) - rounding * unit_of_y > least_bound))
        return std::nullopt;
      if ((x > 0) == (y > 0))
        return false;
      if (!(std::abs(x) > part_of_certain_height * unit_of_x && std::abs(y) > part_of_certain_height * unit_of_y))
        return std::nullopt;
      Vector& p = on_line[of_first];
      p = (x / (x - y)) * of[1] - (y / (x - y)) * of[0];
      constexpr double tolerance = 1e-5;
      if (!(length(p) > tolerance * (std::max)(length(of[0]), length(of[1]))))
        return std::nullopt;
    }
    const double side = dot(on_line[0], on_line[1]);
    return std::abs(side) > least_bound ? std::optional<bool>(side > 0) : std::nullopt;
  }

  // Returns whether a plane through `common` certainly separates `a` and `b` from `c` and `d`. This test separates most triangles
  // around a vertex of high valence, for which exact tests take long if they are coplanar.
  bool are_apart(Index common, Index a, Index b, Index c, Index d) const
  {
    const std::array<Vector, 4> to{{vector_between(common, a), vector_between(common, b), vector_between(common, c),
                                    vector_between(common, d)}};
    Vector normal{{0, 0, 0}};
    std::array<double, 4> length;
    for (std::size_t i = 0; i < 4; ++i) {
      length[i] = internal::length(to[i]);
      normal = normal + ((i < 2 ? 1 : -1) / length[i]) * to[i];
    }
    const double bound = rounding * internal::length(normal);
    return dot(normal, to[0]) > bound * length[0] && dot(normal, to[1]) > bound * length[1] &&
           dot(normal, to[2]) < -bound * length[2] && dot(normal, to[3]) < -bound * length[3];
  }

  Vector vector_between(Index from, Index to) const { return points_[to] - points_[from]; }

  Exact_point exact(Index v) const { return {points_[v][0], points_[v][1], points_[v][2]}; }

  // Returns the vector between two points, divided by its largest component; 0 if its numbers leave the range of doubles.
  Vector direction(Index from, Index to) const
  {
    constexpr double least = 1e-280, largest = 1e300;
    const Vector w = vector_between(from, to);
    const double size = largest_coordinate(w);
    return size > least && size < largest ? (1 / size) * w : Vector{{0, 0, 0}};
  }

  // Moves the point nearest to the origin to the front. Returns the sign of the permutation.
  template <std::size_t n>
  double begin_with_nearest(std::array<Index, n>& v) const
  {
    double sign = 1;
    for (std::size_t i = 1; i < n; ++i)
      if (largest_coordinate(points_[v[i]]) < largest_coordinate(points_[v[0]])) {
        std::swap(v[0], v[i]);
        sign = -sign;
      }
    return sign;
  }

  // Exact numbers are longer where exponents differ.
  void count_exact_computation(std::initializer_list<Index> vertices) const
  {
    constexpr int work_of_word = 4, bits_of_word = 64;
    int least = (std::numeric_limits<int>::max)(), largest = (std::numeric_limits<int>::min)();
    for (const Index v : vertices)
      for (const double x : points_[v])
        if (x != 0) {
          least = (std::min)(least, std::ilogb(x));
          largest = (std::max)(largest, std::ilogb(x));
        }
    work_ += std::size_t(work_of_word * (1 + (std::max)(largest - least, 0) / bits_of_word));
  }

  Orientation side_of(Index a, Index b, Index c, Index d) const
  {
    std::array<Index, 4> v{{a, b, c, d}};
    const double sign = begin_with_nearest(v);
    const double det = sign * dot(direction(v[0], v[1]), cross(direction(v[0], v[2]), direction(v[0], v[3])));
    if (std::abs(det) > rounding)
      return det > 0 ? POSITIVE : NEGATIVE;
    count_exact_computation({a, b, c, d});
    return orientation(exact(a), exact(b), exact(c), exact(d));
  }

  bool are_collinear(Index a, Index b, Index c) const
  {
    std::array<Index, 3> v{{a, b, c}};
    begin_with_nearest(v);
    if (largest_coordinate(cross(direction(v[0], v[1]), direction(v[0], v[2]))) > rounding)
      return false;
    count_exact_computation({a, b, c});
    return collinear(exact(a), exact(b), exact(c));
  }

  // Returns whether points lie on one side of the plane of a triangle; a quick test.
  bool are_beside(const Triangle& t, std::initializer_list<Index> points) const
  {
    const Orientation side = side_of(t[0], t[1], t[2], *points.begin());
    return side != COPLANAR &&
           std::all_of(points.begin() + 1, points.end(), [&](Index v) { return side_of(t[0], t[1], t[2], v) == side; });
  }

  Exact_tests::Triangle_3 triangle(const Triangle& t) const { return {exact(t[0]), exact(t[1]), exact(t[2])}; }

  // Returns whether two triangles on edge ab overlap.
  bool folds(Index a, Index b, Index c, Index d) const
  {
    return side_of(a, b, c, d) == COPLANAR && !are_collinear(a, b, c) && !are_collinear(a, b, d) &&
           coplanar_orientation(exact(a), exact(b), exact(c), exact(d)) == POSITIVE;
  }

  // Returns whether an edge opposite to the vertex shared with a triangle intersects that triangle.
  bool crosses(const Triangle& t, Index a, Index b) const
  {
    count_exact_computation({t[0], t[1], t[2], a, b});
    return points_[a] != points_[b] && !is_flat(t) && do_intersect(triangle(t), Exact_tests::Segment_3(exact(a), exact(b)));
  }

  const std::vector<Vector>& points_;
  mutable std::size_t work_ = 0;
};

// Returns all pairs of conflicting triangles, in order. `boxes` are the boxes of the triangles. Adds the work of the tests to
// `work`.
inline std::vector<Triangle_pair> conflicting_pairs(const std::vector<Triangle>& triangles, const Triangle_conflict& exact_test,
                                                    const Box_hierarchy& boxes, const Run_context& context, std::size_t& work)
{
  struct Part
  {
    std::vector<Triangle_pair> pairs;
    std::size_t work = 0;
  };
  std::vector<Triangle_pair> pairs;
  Shared_cancellation_point cancellation(context);
  cancellation.begin();
  for_each_part<Part>(
    context.uninterrupted(), triangles.size(), 64,
    [&](Part& part, std::size_t begin, std::size_t end) {
      part = Part();
      const Triangle_conflict conflict = exact_test;
      for (std::size_t t = begin; t < end; ++t) {
        // Very many coincident points would be compared pairwise, so triangles that are points are left out.
        if (conflict.is_point(triangles[t]))
          continue;
        boxes.for_each_overlapping(conflict.box(triangles[t]), [&](Index u) {
          if (u <= t || conflict.is_point(triangles[u]))
            return;
          if (conflict(triangles[t], triangles[u]))
            part.pairs.emplace_back(Index(t), u);
        });
        // One part can have very many tests, where all triangles are long.
        const std::size_t work_of_triangle = conflict.take_work();
        part.work += work_of_triangle;
        if (!cancellation.poll(work_of_triangle))
          return;
      }
    },
    [&](const Part& part) {
      work += part.work;
      pairs.insert(pairs.end(), part.pairs.begin(), part.pairs.end());
    });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_TRIANGLE_CONFLICTS_H
