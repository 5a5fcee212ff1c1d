// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_PLANE_FIT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_PLANE_FIT_H

#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Coarse_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Fit_equations.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Surface_fit.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Moves vertices exactly onto the planes of the input around them. The fit ends near such places only, because it also regards the
// shape of triangles.
class Plane_fit
{
public:
  // Moves the vertices that `fit` may move.
  Plane_fit(Coarse_mesh& mesh, const Surface_fit& fit) : mesh_(mesh), fit_(fit) {}

  // Movements bring samples to other triangles, hence the repetitions.
  void run()
  {
    constexpr int max_repetitions = 8;
    planes_.resize(mesh_.triangles().size());
    bool has_moved = true;
    for (int i = 0; i < max_repetitions && has_moved; ++i) {
      for_each_number(mesh_.context(), planes_.size(), [this](Index t) { planes_[t] = planes_on(t); });
      has_moved = false;
      for (std::size_t v = 0; v < mesh_.positions().size(); ++v)
        if (fit_.may_move(Index(v)) && move_onto_planes(Index(v)))
          has_moved = true;
    }
  }

private:
  // Planes have a common point if it is this close to each of them on average, in units of the longest edge around the vertex.
  static constexpr double tolerance = 1e-6;
  // The normals of faces on one plane differ by less.
  static constexpr double max_deviation = 1e-4;
  // Normals span only the directions in which the sum of their squares exceeds this part of the largest.
  static constexpr double min_eigenvalue = 1e-4;
  // Shorter movements are rounding errors, longer ones lead to other places, in units of the longest edge.
  static constexpr double shortest = 1e-12, farthest = 0.5;
  // The mean squared distance in units of the area around a vertex below which it is nearly zero, and the changes permitted there.
  static constexpr double nearly_zero = 1e-7, max_growth = 1.25, min_part_of_angle = 0.999;
  // No movement makes the sides of feature lines shorter than this part, because the distance does not keep their vertices apart.
  static constexpr double min_part_of_side = 0.9;
  // Surfaces with more planes around a vertex are curved.
  static constexpr std::size_t max_planes = 6;

  // A plane through the point with height `h` along a unit normal `n` above an origin.
  struct Plane
  {
    Vector normal;
    double height;
  };

  // The planes of some samples: the sums over their normals `n` and their heights `h` above an origin, and the planes that differ.
  struct Planes
  {
    double number = 0, squared_heights = 0;
    Vector right{{0, 0, 0}}; // the sum of h n
    Symmetric_block squares;
    std::vector<Plane> distinct; // at most max_planes + 1

    // Planes are equal if their heights differ by less than `max_difference`.
    void add(const Plane& p, double max_difference)
    {
      ++number;
      squared_heights += p.height * p.height;
      right = right + p.height * p.normal;
      squares.add(1, Symmetric_block::square(p.normal));
      add_distinct(p, max_difference);
    }

    // Adds planes with heights above another origin; `d` is the vector from this origin to their origin.
    void add(const Planes& planes, const Vector& d, double max_difference)
    {
      const Vector by = planes.squares * d;
      number += planes.number;
      squared_heights += planes.squared_heights + 2 * dot(planes.right, d) + dot(by, d);
      right = right + planes.right + by;
      squares.add(1, planes.squares);
      for (const Plane& p : planes.distinct)
        add_distinct({p.normal, p.height + dot(p.normal, d)}, max_difference);
    }

    void add_distinct(const Plane& p, double max_difference)
    {
      const auto is_equal = [&](const Plane& q) {
        const Vector d = p.normal - q.normal;
        return dot(d, d) < max_deviation * max_deviation && std::abs(p.height - q.height) < max_difference;
      };
      if (distinct.size() <= max_planes && std::none_of(distinct.begin(), distinct.end(), is_equal))
        distinct.push_back(p);
    }
  };

  // Returns the planes of the samples on a triangle, with its first corner as origin. A small triangle that cuts a corner of the
  // input may have no samples of the input on all planes at the corner, so planes below its own samples are added.
  Planes planes_on(Index t) const
  {
    Planes planes;
    const Triangle& corners = mesh_.triangle(t);
    const Vector& p = mesh_.point(corners[0]);
    const double close = tolerance * std::sqrt(length(mesh_.normal(t)));
    const auto add = [&](const Vector& area, const Vector& point) {
      const double size = length(area);
      if (size > 0)
        planes.add({(1 / size) * area, dot(area, point - p) / size}, close);
    };
    const Flat_mesh& faces = mesh_.surface().whole_mesh();
    mesh_.samples().for_each_on(
      t, [&](const Fit_samples::Sample& s) { add(vector_area(faces, mesh_.surface().whole_face(s.face)), s.position); });
    for (const Back_sample& s : mesh_.samples().of_triangle(t))
      if (s.foot.face != NONE && s.squared_distance > close * close)
        add(vector_area(faces, s.foot.face), s.foot.position);
    return planes;
  }

  // Moves a vertex to the planes around it, or to some of them if all have no common point. Returns whether it has moved.
  bool move_onto_planes(Index v)
  {
    const Vector& p = mesh_.point(v);
    double square = 0; // of the longest edge
    for (const Index t : mesh_.around(v))
      for (const Index w : mesh_.triangle(t))
        square = (std::max)(square, dot(mesh_.point(w) - p, mesh_.point(w) - p));
    const double longest = std::sqrt(square);
    Planes planes;
    for (const Index t : mesh_.around(v))
      planes.add(planes_[t], mesh_.point(mesh_.triangle(t)[0]) - p, tolerance * longest);
    if (planes.number == 0)
      return false;
    const Vector move = vector_to(planes);
    const double left = planes.squared_heights - 2 * dot(planes.right, move) + dot(move, planes.squares * move);
    if (left <= planes.number * tolerance * tolerance * square)
      return is_useful(move, longest) && make(v, p + move, mesh_.cost_of(mesh_.around(v)));
    return planes.distinct.size() <= max_planes && !is_exact(v, longest) && move_to_best(v, planes.distinct, longest);
  }

  // Returns the shortest movement to the points with the smallest sum of squared heights.
  static Vector vector_to(const Planes& planes)
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(planes.squares.matrix());
    Vector move{{0, 0, 0}};
    for (int i = 0; i < 3; ++i) {
      const double value = solver.eigenvalues()[i];
      if (!(value > min_eigenvalue * solver.eigenvalues()[2]))
        continue;
      const Vector e{{solver.eigenvectors()(0, i), solver.eigenvectors()(1, i), solver.eigenvectors()(2, i)}};
      move = move + (dot(planes.right, e) / value) * e;
    }
    return move;
  }

  static bool is_useful(const Vector& move, double longest)
  {
    const double square = dot(move, move);
    return square > shortest * shortest * longest * longest && square <= farthest * farthest * longest * longest;
  }

  // Moves a vertex to the point on one, two or three planes where the distance is smallest.
  bool move_to_best(Index v, const std::vector<Plane>& planes, double longest)
  {
    const Vector from = mesh_.point(v);
    double least = mesh_.cost_of(mesh_.around(v));
    bool has_moved = false;
    const std::size_t n = planes.size();
    for (std::size_t chosen = 1; chosen < (std::size_t(1) << n); ++chosen) {
      Planes some;
      for (std::size_t i = 0; i < n; ++i)
        if (chosen >> i & 1)
          some.add(planes[i], 0);
      if (some.number > 3)
        continue;
      const Vector move = vector_to(some);
      if (is_useful(move, longest) && make(v, from + move, least)) {
        least = mesh_.cost_of(mesh_.around(v));
        has_moved = true;
      }
    }
    return has_moved;
  }

  // Moves a vertex unless the distance is not less than `before` then, or a triangle turns over or becomes narrow. Where the
  // distance is nearly zero, a small increase is permitted, because neighbors may still be off their planes.
  bool make(Index v, const Vector& p, double before)
  {
    const std::vector<Index>& around = mesh_.around(v);
    const double angle = smallest_angle_of(around), area = area_of(around);
    const bool is_near = before <= nearly_zero * area * area;
    std::vector<Vector> normals;
    for (const Index t : around)
      normals.push_back(mesh_.normal(t));
    const Vector to = mesh_.within_bounds(v, p), from = std::exchange(mesh_.positions()[v], to);
    bool is_sound = smallest_angle_of(around) >= (std::min)(is_near ? min_part_of_angle * angle : angle, min_angle);
    for (std::size_t i = 0; i < around.size(); ++i)
      is_sound = is_sound && dot(normals[i], mesh_.normal(around[i])) > 0;
    mesh_.positions()[v] = from;
    return is_sound && keeps_sides(v, to) && mesh_.move_if(v, to, [&]() {
      const double after = mesh_.cost_of(around);
      return is_near ? after <= max_growth * before : after < before;
    });
  }

  // Returns whether the sides of lines at a vertex do not become much shorter if it moves.
  bool keeps_sides(Index v, const Vector& to) const
  {
    for (const Index t : mesh_.around(v))
      for (int i = 0; i < 3; ++i) {
        const Index a = mesh_.triangle(t)[std::size_t(i)], b = mesh_.triangle(t)[std::size_t((i + 1) % 3)];
        if (mesh_.across(t, i) != NONE || (a != v && b != v))
          continue;
        const Vector& end = mesh_.point(a == v ? b : a);
        if (length(to - end) < min_part_of_side * length(mesh_.point(v) - end))
          return false;
      }
    return true;
  }

  double smallest_angle_of(const std::vector<Index>& triangles) const
  {
    double least = min_angle;
    for (const Index t : triangles)
      least = (std::min)(least, mesh_.angle(t));
    return least;
  }

  double area_of(const std::vector<Index>& triangles) const
  {
    double area = 0;
    for (const Index t : triangles)
      area += 0.5 * length(mesh_.normal(t));
    return area;
  }

  // Returns whether the surface around a vertex is as close as points on planes are.
  bool is_exact(Index v, double longest) const
  {
    const double close = tolerance * longest;
    return mesh_.cost_of(mesh_.around(v)) <= close * close * area_of(mesh_.around(v));
  }

  Coarse_mesh& mesh_;
  const Surface_fit& fit_;
  std::vector<Planes> planes_; // of each triangle
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_PLANE_FIT_H
