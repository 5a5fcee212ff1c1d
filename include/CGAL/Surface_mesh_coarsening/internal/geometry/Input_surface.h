// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_INPUT_SURFACE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_INPUT_SURFACE_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// A point of the mesh.
struct Input_point
{
  Vector position;
  Index face;
};

// The surface of a polygon mesh, polygons being triangulated by a fan around the vertex of the smallest number, wherever
// their corners begin.
class Input_surface
{
public:
  struct Closest
  {
    Input_point point;
    double squared_distance;
  };

  explicit Input_surface(const Flat_mesh& mesh) : mesh_(mesh) {}

  // Points spread evenly, whatever the sizes of the faces: at equal steps of the cumulated area, in the triangles at the
  // points of the additive recurrence of the plastic number. Each stands for an equal part of `area`, which is that of all
  // the fans.
  std::vector<Input_point> samples(std::size_t number, double& area) const
  {
    std::vector<Input_point> points;
    area = 0;
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f)
      for_each_triangle(Index(f), [&](const Vector& a, const Vector& b, const Vector& c) { area += size(a, b, c); });
    if (!(area > 0))
      return points;
    points.reserve(number);
    const double plastic = 1.32471795724474602596;
    double cumulated = 0;
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f)
      for_each_triangle(Index(f), [&](const Vector& a, const Vector& b, const Vector& c) {
        cumulated += size(a, b, c);
        while (points.size() < number && (double(points.size()) + 0.5) * area < cumulated * double(number)) {
          double u = double(points.size() + 1) / plastic, v = double(points.size() + 1) / (plastic * plastic);
          u -= std::floor(u);
          v -= std::floor(v);
          if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
          }
          points.push_back({a + u * (b - a) + v * (c - a), Index(f)});
        }
      });
    return points;
  }

  // The closest point of one face to `p`.
  Closest closest_on_face(const Vector& p, Index f) const
  {
    Closest closest{{p, f}, -1};
    improve(p, f, closest);
    return closest;
  }

  // The closest point to `p` that is found from a face of the surface by going to the closest of the faces around, time
  // and again, but for so many steps at most.
  Closest closest_from(const Vector& p, Index f, int steps) const
  {
    Closest closest = closest_on_face(p, f);
    for (int i = 0; i < steps; ++i) {
      const Index from = closest.point.face;
      for (Index c = mesh_.first_corner[from]; c != mesh_.first_corner[from + 1]; ++c) {
        const Index v = mesh_.corner_vertex[c];
        for (Index k = mesh_.first_in_star[v]; k != mesh_.first_in_star[v + 1]; ++k)
          if (mesh_.star[k] != from)
            improve(p, mesh_.star[k], closest);
      }
      if (closest.point.face == from)
        break;
    }
    return closest;
  }

private:
  template <class Visit>
  void for_each_triangle(Index f, const Visit& visit) const
  {
    const auto begin = mesh_.corner_vertex.begin() + mesh_.first_corner[f];
    const Index degree = mesh_.degree(f), first = Index(std::min_element(begin, begin + degree) - begin);
    const auto corner = [&](Index i) -> const Vector& { return mesh_.points[begin[(first + i) % degree]]; };
    for (Index i = 2; i < degree; ++i)
      visit(corner(0), corner(i - 1), corner(i));
  }

  static double size(const Vector& a, const Vector& b, const Vector& c)
  {
    const Vector n = cross(b - a, c - a);
    return 0.5 * std::sqrt(dot(n, n));
  }

  void improve(const Vector& p, Index f, Closest& closest) const
  {
    for_each_triangle(f, [&](const Vector& a, const Vector& b, const Vector& c) {
      const Foot_point foot = closest_on_triangle(p, a, b, c);
      if (closest.squared_distance < 0 || foot.squared_distance < closest.squared_distance) {
        const Vector& x = foot.barycentric;
        closest = {{x[0] * a + x[1] * b + x[2] * c, f}, foot.squared_distance};
      }
    });
  }

  const Flat_mesh& mesh_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_INPUT_SURFACE_H
