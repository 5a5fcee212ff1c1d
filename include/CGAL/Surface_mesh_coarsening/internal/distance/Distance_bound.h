// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_DISTANCE_BOUND_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_DISTANCE_BOUND_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Nearest_point_search.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <queue>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

typedef std::array<Vector, 3> Corner_points; // of a triangle

inline Vector center_of(const Corner_points& p) { return (1. / 3) * (p[0] + p[1] + p[2]); }

inline double radius_about(const Vector& center, const Corner_points& corners)
{
  double squared = 0;
  for (const Vector& p : corners)
    squared = (std::max)(squared, dot(p - center, p - center));
  return std::sqrt(squared);
}

// A point of a triangle of the coarse mesh that is far from a point of the mesh, which lies at the offset from it. One of the two
// is the point of its surface nearest to the other.
struct Far_point
{
  Index triangle;
  Vector barycentric, offset;
};

// A bound of the distance of two surfaces, the distance of some points, and the points that are far in comparison.
struct Measured_distance
{
  double bound = 0, reached = 0;
  std::vector<Far_point> far;
};

// Points are far if their distance is at least this part of the largest one.
constexpr double far_part = 0.75;

// Bounds the two-sided Hausdorff distance between a mesh and its coarse meshes, over both surfaces and not only at points.
// Polygons are fans of triangles. Degenerate triangles do not count.
//
// Parts of triangles are divided until each part is proven: the distance from one triangle is a convex function, so its maximum
// over a part is at a corner. CGAL's bounded_error_symmetric_Hausdorff_distance() finds the nearest triangles without the
// clusters, takes two to eight times as long, and does not tell where the distance is large.
//
// Where surfaces are crumpled or extremely long, a proof would take very many parts, so the work is limited; when it is spent, a
// bound exceeds the distance by more.
class Distance_bound
{
public:
  // `cluster_of_face` gives the vertex of the coarse mesh near each face of the mesh, and is below `vertices`. `work_left` counts
  // down the comparisons of points with triangles and boxes.
  Distance_bound(const Flat_mesh& mesh, const std::vector<Index>& cluster_of_face, std::size_t vertices, std::size_t& work_left,
                 const Run_context& context)
    : surface_(mesh.points, vertices), context_(context), work_left_(work_left)
  {
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      for (Index c = mesh.first_corner[f] + 2; c != mesh.first_corner[f + 1]; ++c)
        surface_.add({{mesh.corner_vertex[mesh.first_corner[f]], mesh.corner_vertex[c - 1], mesh.corner_vertex[c]}},
                     Index(f), cluster_of_face[f]);
    surface_.prepare();
  }

  // Bounds the distance, up to a 32nd part of it if it is larger than `limit`. Otherwise the bound is at most `limit` and, if it
  // is `precise`, exceeds the distance by at most a 32nd part of `limit`. When the work is spent, or the distance exceeds
  // `hopeless`, bounds are larger.
  Measured_distance operator()(const std::vector<Vector>& positions, const std::vector<Triangle>& triangles, double limit,
                               bool precise, double hopeless)
  {
    const Surface coarse(positions, triangles);
    Measured_distance measured;
    std::vector<Far_point> points;
    // The part with the largest bound comes first, because it is likely to raise `reached`.
    const auto is_below = [](const Part& a, const Part& b) { return a.bound < b.bound; };
    std::priority_queue<Part, std::vector<Part>, decltype(is_below)> undecided(is_below);
    double reached = 0;
    const auto measure = [&](Part part) {
      context_.poll(16);
      const Surface& to = part.is_coarse ? surface_ : coarse;
      if (part.nearest != NONE && distance_of_corners(part, to) <= far_part * reached)
        return;
      const Nearest_point near = nearest_to_center(part, to, reached);
      const double distance = std::sqrt(near.squared_distance);
      reached = (std::max)(reached, distance);
      if (distance > far_part * reached)
        points.push_back(far_point(part, near, coarse));
      if (part.bound > reached)
        undecided.push(part);
    };
    // A few of the triangles, first, yield a distance below which the others need not be divided.
    constexpr std::size_t step = 8, max_cuts = 8;
    for (const Surface* from : {static_cast<const Surface*>(&surface_), &coarse})
      for (std::size_t first = 0; first < step; ++first)
        for (std::size_t t = first; t < from->number.size(); t += step)
          measure({from->corners(t), Index(t), from->group[t], from == &coarse, 0});
    const auto select_far_points = [&] {
      measured.reached = reached;
      std::copy_if(points.begin(), points.end(), std::back_inserter(measured.far),
                   [&](const Far_point& p) { return length(p.offset) >= far_part * reached; });
    };
    const double least_error = (std::max)(limit / 8192, 1e-12 * surface_.largest_coordinate);
    while (!undecided.empty() && work_left_ > 0 && reached <= hopeless) {
      const double largest = undecided.top().bound;
      if (measured.far.empty() && largest <= reached + reached / 32)
        select_far_points(); // does not depend on the limit
      // A bound beyond the limit must not be due to the error.
      if (largest <= limit ? !precise || largest <= reached + limit / 32
                           : largest <= reached + (reached > limit ? reached / 32 : least_error))
        break;
      const Part part = undecided.top();
      undecided.pop();
      // Where possible, a part is divided into what lies over its nearest triangle and what does not: over one triangle, the
      // bound is exact. Repeated cuts of thin slices are followed by a halving.
      if (part.cuts == max_cuts || !cut_at_edge(part, part.is_coarse ? surface_ : coarse, measure))
        halve(part, measure);
    }
    measured.bound = undecided.empty() ? reached : (std::max)(reached, undecided.top().bound);
    if (measured.far.empty())
      select_far_points();
    return measured;
  }

private:
  // Triangles that are not degenerate, and their groups.
  struct Surface
  {
    Surface(const std::vector<Vector>& points, std::size_t groups) : number_of_groups(groups) { mesh.points = points; }

    Surface(const std::vector<Vector>& positions, const std::vector<Triangle>& triangles) : Surface(positions, positions.size())
    {
      for (std::size_t t = 0; t < triangles.size(); ++t)
        add(triangles[t], Index(t), triangles[t][0]);
      prepare();
    }

    void add(const Triangle& t, Index triangle_number, Index triangle_group)
    {
      const Vector normal = normal_of(mesh.points, t);
      if (!(dot(normal, normal) > 0))
        return;
      mesh.corner_vertex.insert(mesh.corner_vertex.end(), t.begin(), t.end());
      for (const Index v : t)
        largest_coordinate = (std::max)(largest_coordinate, internal::largest_coordinate(mesh.points[v]));
      number.push_back(triangle_number);
      group.push_back(triangle_group);
    }

    void prepare()
    {
      if (number.empty())
        throw Invalid_input("the distance of a surface without area cannot be bounded");
      for (std::size_t c = 0; c <= mesh.corner_vertex.size(); c += 3)
        mesh.first_corner.push_back(Index(c));
      search.emplace(mesh, group, number_of_groups);
    }

    Corner_points corners(std::size_t t) const
    {
      return {{mesh.points[mesh.corner_vertex[3 * t]], mesh.points[mesh.corner_vertex[3 * t + 1]],
               mesh.points[mesh.corner_vertex[3 * t + 2]]}};
    }

    Vector point(std::size_t t, const Vector& barycentric) const
    {
      const auto p = corners(t);
      return barycentric[0] * p[0] + barycentric[1] * p[1] + barycentric[2] * p[2];
    }

    Flat_mesh mesh;
    std::vector<Index> number, group;
    std::size_t number_of_groups;
    double largest_coordinate = 0;
    std::optional<Nearest_point_search> search;
  };

  // A part of a triangle, the group in which the search begins, and a bound of the distance of its points.
  struct Part
  {
    Corner_points corners;
    Index triangle, group;
    bool is_coarse; // whether it is a part of the coarse mesh
    double bound;
    Index nearest = NONE; // the triangle nearest to the center; at first, of the divided part
    std::size_t cuts = 0; // since it was halved
  };

  Far_point far_point(const Part& part, const Nearest_point& near, const Surface& coarse) const
  {
    const Vector middle = center_of(part.corners);
    if (!part.is_coarse)
      return {coarse.number[near.face], near.barycentric, middle - coarse.point(near.face, near.barycentric)};
    const auto t = coarse.corners(part.triangle);
    return {coarse.number[part.triangle], closest_on_triangle(middle, t[0], t[1], t[2]).barycentric,
            surface_.point(near.face, near.barycentric) - middle};
  }

  // Bounds the distance of a part. Returns the point nearest to its center, or one so near that the part is nearer than
  // `near_enough`.
  Nearest_point nearest_to_center(Part& part, const Surface& to, double near_enough)
  {
    const Vector middle = center_of(part.corners);
    const double radius = radius_about(middle, part.corners), inner = (std::max)(near_enough - radius, 0.);
    std::size_t compared = 0;
    const Nearest_point nearest = (*to.search)(middle, part.group, inner * inner, compared);
    work_left_ -= (std::min)(compared, work_left_);
    const double distance = std::sqrt(nearest.squared_distance);
    part.bound = distance + radius;
    if (part.bound > near_enough) {
      part.group = to.group[nearest.face];
      part.nearest = nearest.face;
      part.bound = (std::min)(part.bound, distance_of_corners(part, to));
    }
    return nearest;
  }

  // Returns the largest distance of the corners from the nearest triangle, which bounds the distance of all points of the part.
  double distance_of_corners(const Part& part, const Surface& to)
  {
    const Corner_points triangle = to.corners(part.nearest);
    double squared = 0;
    for (const Vector& p : part.corners)
      squared = (std::max)(squared, closest_on_triangle(p, triangle[0], triangle[1], triangle[2]).squared_distance);
    work_left_ -= (std::min)(part.corners.size(), work_left_);
    return std::sqrt(squared);
  }

  // Cuts a part by the plane through an edge of its nearest triangle, upright on the triangle: the plane beyond which the part
  // reaches farthest. Returns whether such a plane crosses the part.
  template <class Visit>
  static bool cut_at_edge(const Part& part, const Surface& to, const Visit& visit)
  {
    constexpr double least_part = 1e-3; // of the extent of the part, on each side
    const Corner_points t = to.corners(part.nearest);
    const Vector normal = cross(t[1] - t[0], t[2] - t[0]);
    Vector heights{};
    double farthest = 0;
    for (int i = 0; i < 3; ++i) {
      const Vector outward = cross(t[(i + 1) % 3] - t[i], normal);
      const double size = length(outward);
      Vector h;
      for (int k = 0; k < 3; ++k)
        h[k] = dot(outward, part.corners[k] - t[i]) / size;
      const double highest = *std::max_element(h.begin(), h.end()), lowest = *std::min_element(h.begin(), h.end());
      if (highest > farthest && (std::min)(highest, -lowest) > least_part * (highest - lowest)) {
        farthest = highest;
        heights = h;
      }
    }
    if (!(farthest > 0))
      return false;
    int alone = 0;
    while ((heights[alone] > 0) == (heights[(alone + 1) % 3] > 0) || (heights[alone] > 0) == (heights[(alone + 2) % 3] > 0))
      ++alone;
    const Vector &p = part.corners[alone], &q = part.corners[(alone + 1) % 3], &r = part.corners[(alone + 2) % 3];
    const auto crossing = [&](const Vector& end, double height) {
      return p + heights[alone] / (heights[alone] - height) * (end - p);
    };
    const Vector on_pq = crossing(q, heights[(alone + 1) % 3]), on_pr = crossing(r, heights[(alone + 2) % 3]);
    for (const Corner_points& corners : {Corner_points{{p, on_pq, on_pr}}, {{on_pq, q, on_pr}}, {{q, r, on_pr}}})
      visit({corners, part.triangle, part.group, part.is_coarse, part.bound, part.nearest, part.cuts + 1});
    return true;
  }

  // Halves a part at its longest side.
  template <class Visit>
  static void halve(const Part& part, const Visit& visit)
  {
    const auto& c = part.corners;
    const auto squared_length = [&](int i) { return dot(c[(i + 1) % 3] - c[i], c[(i + 1) % 3] - c[i]); };
    const int longest = (std::max)({0, 1, 2}, [&](int i, int j) { return squared_length(i) < squared_length(j); });
    const Vector middle = 0.5 * (c[longest] + c[(longest + 1) % 3]), opposite = c[(longest + 2) % 3];
    visit({{{c[longest], middle, opposite}}, part.triangle, part.group, part.is_coarse, part.bound, part.nearest});
    visit({{{middle, c[(longest + 1) % 3], opposite}}, part.triangle, part.group, part.is_coarse, part.bound, part.nearest});
  }

  Surface surface_;
  const Run_context context_;
  std::size_t& work_left_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_DISTANCE_BOUND_H
