// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_INPUT_SURFACE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_INPUT_SURFACE_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// A point of the mesh.
struct Input_point
{
  Vector position;
  Index face;
};

// The surface of a polygon mesh. Polygons are triangulated by a fan around the vertex of smallest number, so the surface does
// not depend on their first corner.
class Input_surface
{
public:
  struct Closest
  {
    Input_point point;
    double squared_distance;
    bool is_partial; // the descent has left out faces around its last vertex, or has ended early
  };

  explicit Input_surface(const Flat_mesh& mesh) : mesh_(mesh)
  {
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      if (mesh.degree(Index(f)) > max_in_fan)
        large_faces_.push_back(large_face(Index(f)));
  }

  // Returns whether a vertex has so many faces that a descent does not visit all of them.
  bool has_hubs() const
  {
    for (std::size_t v = 0; v < mesh_.number_of_vertices(); ++v)
      if (mesh_.first_in_star[v + 1] - mesh_.first_in_star[v] > 2 * max_each_way + 1)
        return true;
    return false;
  }

  // Returns the area of all fans.
  double area(const Run_context& context) const
  {
    double sum = 0;
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f) {
      context.poll(mesh_.degree(Index(f)));
      for_each_triangle(Index(f), [&](const Vector& a, const Vector& b, const Vector& c) { sum += size(a, b, c); });
    }
    return sum;
  }

  // Calls `visit(point)` for points that are evenly distributed, independently of the sizes of the faces: at equal steps of the
  // cumulated area, in the triangles at the points of the additive recurrence of the plastic number. Each point
  // represents an equal part of `area`, the area of all fans.
  template <class Visit>
  void for_each_sample(std::size_t number, double area, const Run_context& context, const Visit& visit) const
  {
    if (!(area > 0))
      return;
    const double plastic = 1.32471795724474602596;
    double cumulated = 0;
    std::size_t visited = 0;
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f) {
      context.poll(mesh_.degree(Index(f)));
      for_each_triangle(Index(f), [&](const Vector& a, const Vector& b, const Vector& c) {
        cumulated += size(a, b, c);
        for (; visited < number && (double(visited) + 0.5) * area < cumulated * double(number); ++visited) {
          double u = double(visited + 1) / plastic, v = double(visited + 1) / (plastic * plastic);
          u -= std::floor(u);
          v -= std::floor(v);
          if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
          }
          visit(Input_point{a + u * (b - a) + v * (c - a), Index(f)});
        }
      });
    }
  }

  // Finds the closest point to `p` on face `f`. Returns whether it is no nearer to a side than to `p`; then a descent ends here.
  // Fans of several triangles are left to the descent.
  bool is_closest_inside(const Vector& p, Index f, Closest& closest) const
  {
    if (mesh_.degree(f) != 3)
      return false;
    Candidate candidate;
    improve(p, f, candidate);
    if (candidate.face == NONE)
      return false;
    const Fan corners = fan(f);
    const std::array<bool, 3> is_near = near_sides(candidate, corners);
    if (is_near[0] || is_near[1] || is_near[2])
      return false;
    closest = {{point_in(candidate, corners), f}, candidate.foot.squared_distance, false};
    return true;
  }

  // Returns the closest point to `p` found by a descent of at most `steps` steps, beginning at a face of the surface. A
  // step visits the faces that share an edge or a vertex with the triangle of the current closest point, where the edge or vertex
  // is no farther from this point than `p`.
  Closest closest_from(const Vector& p, Index f, int steps) const
  {
    Candidate candidate;
    Recent_faces recent;
    recent.add(f);
    improve(p, f, candidate);
    bool has_ended = false, has_visited_all = true;
    for (int i = 0; i < steps && !has_ended; ++i) {
      const Candidate before = candidate;
      has_visited_all = for_each_near(before, [&](Index g) {
        if (recent.add(g))
          improve(p, g, candidate);
      });
      has_ended = candidate.face == before.face;
    }
    return {{point_in(candidate, fan(candidate.face)), candidate.face},
            candidate.foot.squared_distance,
            !has_ended || !has_visited_all};
  }

private:
  // The maximum number of faces visited around a vertex in each direction.
  static constexpr Index max_each_way = 12;
  // Larger fans are not searched triangle by triangle.
  static constexpr Index max_in_fan = 16;

  // A face with a fan that is not searched triangle by triangle.
  struct Large_face
  {
    Index face, first;
    Bbox_3 box;
    std::vector<std::pair<Index, Index> > corner_of_vertex; // in order
  };

  // A closest point in the triangle of a fan that ends at corner `last`, counted from the apex.
  struct Candidate
  {
    Index face = NONE, last = 0;
    Foot_point foot{{{1, 0, 0}}, (std::numeric_limits<double>::infinity)()};
  };

  // Some of the faces that a search has visited. Visiting them again would not improve the closest point.
  class Recent_faces
  {
  public:
    Recent_faces() { face_.fill(NONE); }

    // Returns whether the face was not among them.
    bool add(Index f) { return std::exchange(face_[f % number], f) != f; }

  private:
    static constexpr Index number = 64;

    std::array<Index, number> face_;
  };

  // The corners of a face, beginning at its smallest vertex.
  struct Fan
  {
    const Flat_mesh& mesh;
    Index begin, degree, first;

    Index corner(Index i) const { return begin + (first + i < degree ? first + i : first + i - degree); }
    const Vector& point(Index i) const { return mesh.points[mesh.corner_vertex[corner(i)]]; }
  };

  Fan fan(Index f) const
  {
    const Index begin = mesh_.first_corner[f], degree = mesh_.degree(f);
    return {mesh_, begin, degree, degree > max_in_fan ? large_face_of(f).first : first_of_fan(f)};
  }

  // Returns the corner of smallest vertex, counted from the first corner.
  Index first_of_fan(Index f) const
  {
    const auto corners = mesh_.corner_vertex.begin() + mesh_.first_corner[f];
    return Index(std::min_element(corners, corners + mesh_.degree(f)) - corners);
  }

  Large_face large_face(Index f) const
  {
    Large_face large{f, first_of_fan(f), face_box(mesh_, f), {}};
    for (const Index c : mesh_.corners(f))
      large.corner_of_vertex.emplace_back(mesh_.corner_vertex[c], c);
    std::sort(large.corner_of_vertex.begin(), large.corner_of_vertex.end());
    return large;
  }

  const Large_face& large_face_of(Index f) const
  {
    return *std::lower_bound(large_faces_.begin(), large_faces_.end(), f,
                             [](const Large_face& large, Index g) { return large.face < g; });
  }

  Index corner_of(Index f, Index v) const
  {
    if (mesh_.degree(f) <= max_in_fan)
      return mesh_.corner_of(f, v);
    const auto& corners = large_face_of(f).corner_of_vertex;
    return std::lower_bound(corners.begin(), corners.end(), std::make_pair(v, Index(0)))->second;
  }

  // Due to rounding, a point of a face may be nearer than the box of the face.
  static double exceeding(double squared_distance) { return (1 + 1e-12) * squared_distance; }

  // Calls `visit(g)` for the faces around the vertex at corner `c` of face `f`, from `f` in both directions. Returns whether no
  // face is left out.
  template <class Visit>
  bool for_each_around(Index f, Index c, const Visit& visit) const
  {
    const Index v = mesh_.corner_vertex[c];
    Index g = mesh_.face_across[mesh_.previous_corner(f, c)];
    for (Index i = 0; i < max_each_way && g != NONE && g != f; ++i) {
      visit(g);
      g = mesh_.face_across[mesh_.previous_corner(g, corner_of(g, v))];
    }
    if (g == f)
      return true;
    const Index last = g;
    g = mesh_.face_across[c];
    for (Index i = 0; i < max_each_way && g != NONE && g != last; ++i) {
      visit(g);
      g = mesh_.face_across[corner_of(g, v)];
    }
    return g == last;
  }

  template <class Visit>
  void for_each_triangle(Index f, const Visit& visit) const
  {
    const Fan corners = fan(f);
    for (Index i = 2; i < corners.degree; ++i)
      visit(corners.point(0), corners.point(i - 1), corners.point(i));
  }

  static double size(const Vector& a, const Vector& b, const Vector& c) { return 0.5 * length(cross(b - a, c - a)); }

  void improve(const Vector& p, Index f, Candidate& candidate) const
  {
    const bool is_large = mesh_.degree(f) > max_in_fan;
    if (is_large && squared_distance_from_box(p, large_face_of(f).box) > exceeding(candidate.foot.squared_distance))
      return;
    const Fan corners = fan(f);
    const auto visit = [&](Index i) {
      const Foot_point foot =
        closest_on_triangle(p, corners.point(0), corners.point(i - 1), corners.point(i), candidate.foot.squared_distance);
      if (!(foot.squared_distance < candidate.foot.squared_distance))
        return false;
      candidate = {f, i, foot};
      return true;
    };
    if (!is_large) {
      for (Index i = 2; i < corners.degree; ++i)
        visit(i);
    } else {
      visit_downhill(corners.degree, visit);
    }
  }

  static Vector point_in(const Candidate& c, const Fan& corners)
  {
    const Vector& x = c.foot.barycentric;
    return x[0] * corners.point(0) + x[1] * corners.point(c.last - 1) + x[2] * corners.point(c.last);
  }

  // Returns for each corner of the triangle of a closest point whether the opposite side is no farther from it than the point
  // that was searched for.
  static std::array<bool, 3> near_sides(const Candidate& c, const Fan& corners)
  {
    std::array<bool, 3> is_near;
    const Vector* at[3] = {&corners.point(0), &corners.point(c.last - 1), &corners.point(c.last)};
    const Vector n = cross(*at[1] - *at[0], *at[2] - *at[0]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector side = *at[(k + 1) % 3] - *at[(k + 2) % 3];
      const double b = c.foot.barycentric[k];
      is_near[k] = b * b * dot(n, n) <= c.foot.squared_distance * dot(side, side);
    }
    return is_near;
  }

  // Calls `visit(g)` for the faces across a near side; if there are two such sides, for the faces around their common corner.
  // Returns whether no such face is left out.
  template <class Visit>
  bool for_each_near(const Candidate& c, const Visit& visit) const
  {
    const Fan corners = fan(c.face);
    const Index at[3] = {0, c.last - 1, c.last};
    const std::array<bool, 3> is_near = near_sides(c, corners);
    bool at_corner = false, are_all = true;
    for (std::size_t k = 0; k < 3; ++k)
      if (is_near[(k + 1) % 3] && is_near[(k + 2) % 3]) {
        at_corner = true;
        are_all = for_each_around(c.face, corners.corner(at[k]), visit) && are_all;
      }
    if (at_corner)
      return are_all;
    const bool is_edge[3] = {true, c.last + 1 == corners.degree, c.last == 2};
    for (std::size_t k = 0; k < 3; ++k)
      if (is_near[k] && is_edge[k]) {
        const Index g = mesh_.face_across[corners.corner(at[(k + 1) % 3])];
        if (g != NONE)
          visit(g);
      }
    return true;
  }

  // Visits some triangles of a large fan, then descends from the best of them to adjacent triangles.
  template <class Visit>
  static void visit_downhill(Index degree, const Visit& visit)
  {
    const Index step = Index(std::sqrt(double(degree)));
    Index best = NONE;
    for (Index i = 2; i < degree; i += step)
      if (visit(i))
        best = i;
    if (best == NONE)
      return;
    Index up = best, down = best;
    while (up + 1 < degree && visit(up + 1))
      ++up;
    while (down > 2 && visit(down - 1))
      --down;
  }

  const Flat_mesh& mesh_;
  std::vector<Large_face> large_faces_; // by face
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_INPUT_SURFACE_H
