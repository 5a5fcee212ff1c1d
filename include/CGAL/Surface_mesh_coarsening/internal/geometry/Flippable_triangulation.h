// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_FLIPPABLE_TRIANGULATION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_FLIPPABLE_TRIANGULATION_H

#include <CGAL/Surface_mesh_coarsening/internal/features/Coarse_features.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The point of a triangle closest to another point: barycentric coordinates and squared distance.
struct Foot_point
{
  Vector barycentric;
  double squared_distance;
};

// Returns the closest point of a segment as the coordinate of its second end.
inline double closest_on_segment(const Vector& p, const Vector& a, const Vector& b)
{
  const Vector ab = b - a;
  const double length = dot(ab, ab);
  return length > 0 ? (std::max)(0., (std::min)(1., dot(p - a, ab) / length)) : 0;
}

// Replaces the best of the closest points on the sides of a triangle by the one on the side from corner `i` to corner `j` if it
// is nearer. `ap` begins at corner `i`, `ab` is the side.
inline void improve_on_side(const Vector& ap, const Vector& ab, std::size_t i, std::size_t j, Foot_point& best)
{
  const double length = dot(ab, ab);
  const double x = length > 0 ? (std::max)(0., (std::min)(1., dot(ap, ab) / length)) : 0;
  const Vector d = ap - x * ab;
  const double square = dot(d, d);
  if (best.squared_distance >= 0 && !(square < best.squared_distance))
    return;
  best.squared_distance = square;
  best.barycentric = {{0, 0, 0}};
  best.barycentric[i] = 1 - x;
  best.barycentric[j] = x;
}

// Returns the closest point of a triangle. The distance may be reported as infinite if its square exceeds `limit`. For a point
// beside the triangle, the lines through its sides bound the distance from below.
inline Foot_point closest_on_triangle(const Vector& p, const Vector& a, const Vector& b, const Vector& c,
                                      double limit = std::numeric_limits<double>::infinity())
{
  const Vector ab = b - a, ac = c - a, ap = p - a;
  const double uu = dot(ab, ab), uv = dot(ab, ac), vv = dot(ac, ac), pu = dot(ap, ab), pv = dot(ap, ac);
  const double determinant = uu * vv - uv * uv;
  const double s = vv * pu - uv * pv, t = uu * pv - uv * pu, r = determinant - s - t;
  // The margin covers rounding errors, which are bounded unless the triangle is a needle.
  constexpr double needle = 1e-4, margin = 1e-6, least = 1e-18;
  const bool is_needle = !(determinant > needle * uu * vv);
  Foot_point best{{{1, 0, 0}}, -1};
  if (determinant > 0 && s >= 0 && t >= 0 && r >= 0) {
    const double u = s / determinant, v = t / determinant;
    const Vector d = ap - u * ab - v * ac;
    best = {{{1 - u - v, u, v}}, dot(d, d)};
    if (!is_needle)
      return best;
  } else if (!is_needle) {
    const double far = determinant * ((1 + margin) * limit + least * (dot(a, a) + uu + vv));
    if ((s < 0 && s * s > far * vv) || (t < 0 && t * t > far * uu) || (r < 0 && r * r > far * (uu - 2 * uv + vv)))
      return {{{1, 0, 0}}, std::numeric_limits<double>::infinity()};
  }
  // The closest point lies on a side that separates the point from the triangle. In a needle of almost no area, the point inside
  // may be anywhere, and a side is closer.
  if (is_needle || t < 0)
    improve_on_side(ap, ab, 0, 1, best);
  if (is_needle || r < 0)
    improve_on_side(p - b, c - b, 1, 2, best);
  if (is_needle || s < 0)
    improve_on_side(ap, ac, 0, 2, best);
  return best;
}

// Returns the cross product of two sides of a triangle.
inline Vector normal_of(const std::vector<Vector>& positions, const Triangle& t)
{
  return cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
}

inline Vector point_in(const std::vector<Vector>& positions, const Triangle& t, const Vector& barycentric)
{
  return barycentric[0] * positions[t[0]] + barycentric[1] * positions[t[1]] + barycentric[2] * positions[t[2]];
}

// Returns the cosine of the smallest angle of a triangle; 1 if two corners coincide.
inline double sharpest_of(const std::array<Vector, 3>& corner)
{
  double largest = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector e = corner[(i + 1) % 3] - corner[i], f = corner[(i + 2) % 3] - corner[i];
    const double product = std::sqrt(dot(e, e) * dot(f, f));
    largest = (std::max)(largest, product > 0 ? dot(e, f) / product : 1);
  }
  return largest;
}

inline double sharpest_of(const std::vector<Vector>& positions, const Triangle& t)
{
  return sharpest_of({{positions[t[0]], positions[t[1]], positions[t[2]]}});
}

inline double smallest_angle(const std::vector<Vector>& positions, const Triangle& t)
{
  return std::acos((std::min)(1., sharpest_of(positions, t)));
}

inline Triangle with_corner(Triangle t, Index old_corner, Index new_corner)
{
  std::replace(t.begin(), t.end(), old_corner, new_corner);
  return t;
}

// The triangles of the dual, with the triangles around each vertex and across each edge. Edges may be flipped, except feature
// edges, which have no neighbors across them, like border edges.
//
// The arrays replace a halfedge structure, because the fit and the repair read the corners of triangles much more often than they
// flip edges, and the corners are adjacent in memory.
class Flippable_triangulation
{
public:
  Flippable_triangulation(const std::vector<Triangle>& triangles, std::size_t vertices, const Coarse_features* features = nullptr)
    : triangles_(triangles), neighbors_(triangles.size()), around_(vertices), features_(features)
  {
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (const Index v : triangles_[t])
        around_[v].push_back(Index(t));
    const std::vector<Index> opposite =
      opposite_sides(triangles_.size(), vertices, [this](Index s) { return triangles_[s / 3][s % 3]; });
    for (std::size_t s = 0; s < opposite.size(); ++s)
      neighbors_[s / 3][s % 3] = opposite[s] == NONE ? NONE : opposite[s] / 3;
  }

  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<Index>& around(Index vertex) const { return around_[vertex]; }

  // Returns the triangle on the other side of the edge from corner `i` of triangle `t` to the next corner; NONE on the border.
  Index neighbor(Index t, int i) const { return neighbors_[t][i]; }

  // The same; NONE also on features.
  Index across(Index t, int i) const
  {
    return features_ && features_->is_edge(triangles_[t][i], triangles_[t][(i + 1) % 3]) ? NONE : neighbors_[t][i];
  }

  int corner(Index t, Index vertex) const
  {
    for (int i = 0; i < 3; ++i)
      if (triangles_[t][i] == vertex)
        return i;
    return -1;
  }

  bool is_edge(Index a, Index b) const
  {
    if (around_[a].size() > around_[b].size())
      std::swap(a, b);
    for (const Index t : around_[a])
      if (corner(t, b) >= 0)
        return true;
    return false;
  }

  // Returns the vertex opposite to the edge of triangle `t` that begins at corner `i`.
  Index opposite(Index t, int i) const { return triangles_[t][(i + 2) % 3]; }

  // Returns whether this edge, with triangle `u` on its other side, may be flipped: the new edge must not exist yet.
  bool may_flip(Index t, int i, Index u) const
  {
    const Index c = opposite(t, i), d = opposite(u, corner(u, triangles_[t][(i + 1) % 3]));
    return c != d && !is_edge(c, d);
  }

  // Replaces this edge by the edge between the two opposite vertices.
  void flip(Index t, int i, Index u)
  {
    const Index a = triangles_[t][i], b = triangles_[t][(i + 1) % 3], c = opposite(t, i);
    const Index d = opposite(u, corner(u, b));
    take_away(a, u);
    take_away(b, t);
    around_[c].push_back(u);
    around_[d].push_back(t);
    triangles_[t] = {c, a, d};
    triangles_[u] = {c, d, b};
    connect(t);
    connect(u);
  }

  // Restores the corners that two triangles had before a flip.
  void undo_flip(Index t, const Triangle& old_t, Index u, const Triangle& old_u) { replace({t, u}, {old_t, old_u}); }

  // Replaces some triangles by the same number of other triangles that cover the same region.
  void replace(const std::vector<Index>& old_triangles, const std::vector<Triangle>& new_triangles)
  {
    for (const Index t : old_triangles)
      for (const Index v : triangles_[t])
        take_away(v, t);
    for (std::size_t i = 0; i < old_triangles.size(); ++i) {
      triangles_[old_triangles[i]] = new_triangles[i];
      for (const Index v : new_triangles[i])
        around_[v].push_back(old_triangles[i]);
    }
    for (const Index t : old_triangles)
      connect(t);
  }

  // Returns the mean of the neighbors of an inner vertex.
  Vector mean_of_neighbors(Index v, const std::vector<Vector>& positions) const
  {
    Vector sum{{0, 0, 0}};
    for (const Index t : around_[v])
      sum = sum + positions[triangles_[t][(corner(t, v) + 1) % 3]];
    return (1. / double(around_[v].size())) * sum;
  }

private:
  // Finds the neighbors of a triangle whose corners have changed.
  void connect(Index t)
  {
    for (int i = 0; i < 3; ++i) {
      const Index u = find_across(t, i);
      neighbors_[t][i] = u;
      if (u != NONE)
        neighbors_[u][corner(u, triangles_[t][(i + 1) % 3])] = t;
    }
  }

  Index find_across(Index t, int i) const
  {
    const Index a = triangles_[t][i], b = triangles_[t][(i + 1) % 3];
    const bool from_a = around_[a].size() <= around_[b].size();
    for (const Index u : around_[from_a ? a : b])
      if (u != t && corner(u, from_a ? b : a) >= 0)
        return u;
    return NONE;
  }

  void take_away(Index vertex, Index gone)
  {
    std::vector<Index>& list = around_[vertex];
    list.erase(std::find(list.begin(), list.end(), gone));
  }

  std::vector<Triangle> triangles_;
  std::vector<std::array<Index, 3> > neighbors_; // across the edge that begins at each corner
  std::vector<std::vector<Index> > around_;
  const Coarse_features* features_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_FLIPPABLE_TRIANGULATION_H
