// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_PLANE_FIT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_PLANE_FIT_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Coarse_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Fit_equations.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Surface_fit.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Moves vertices exactly onto the planes of the input around them, where these planes have a common point. The fit ends near such
// points only, because it also regards the shape of triangles. Where the fit has failed, for example at a vertex that cuts a sharp
// edge, the vertex moves to the point nearest to the planes.
class Plane_fit
{
public:
  // Moves the vertices that `fit` may move.
  Plane_fit(Coarse_mesh& mesh, const Surface_fit& fit) : mesh_(mesh), fit_(fit) {}

  // Movements bring samples to other triangles, hence the repetitions, around the vertices that have moved.
  void run(const Angle_worth& worth)
  {
    constexpr int max_repetitions = 8;
    worth_ = worth;
    high_cost_ = part_of_high_cost * triangles_of_vertex * mesh_.mean_cost();
    planes_.resize(mesh_.triangles().size());
    std::vector<Index> triangles(planes_.size());
    std::iota(triangles.begin(), triangles.end(), Index(0));
    std::vector<Index> vertices = movable_corners(triangles);
    for (int i = 0; i < max_repetitions && !vertices.empty(); ++i) {
      for_each_number(mesh_.context(), triangles.size(), [&](Index k) { planes_[triangles[k]] = planes_on(triangles[k]); });
      std::vector<Move> moves(vertices.size());
      for_each_number(mesh_.context(), vertices.size(), [&](Index k) { moves[k] = move_onto_planes(vertices[k]); });
      triangles.clear();
      for (std::size_t k = 0; k < vertices.size(); ++k)
        if (dot(moves[k].by, moves[k].by) > 0 && make(vertices[k], moves[k]))
          triangles.insert(triangles.end(), mesh_.around(vertices[k]).begin(), mesh_.around(vertices[k]).end());
      sort_unique(triangles);
      vertices = movable_corners(triangles);
    }
  }

private:
  // Planes have a common point if it is this close to each of them on average, in units of the longest edge around the vertex.
  static constexpr double tolerance = 1e-6;
  // Normals span only the directions in which the sum of their squares exceeds this part of the largest.
  static constexpr double min_eigenvalue = 1e-4;
  // Shorter movements are rounding errors, longer ones lead to other places, in units of the longest edge.
  static constexpr double shortest = 1e-12, farthest = 0.5;
  // The mean squared distance in units of the area around a vertex below which it is nearly zero, and the changes permitted there.
  static constexpr double nearly_zero = 1e-7, max_growth = 1.25, min_part_of_angle = 0.999;
  // The fit has failed at a vertex if the cost of its triangles is this number of times the mean cost around a vertex.
  static constexpr double part_of_high_cost = 30, triangles_of_vertex = 6;
  // Vertices on lines keep apart, as in the fit: the length of their shortest edge in units of the mean length around them, and the
  // part of it that is kept below.
  static constexpr double min_part_of_edges = 0.4, min_kept_part = 0.99;

  struct Move
  {
    Vector by{{0, 0, 0}};
    bool is_exact = false; // the planes have a common point
  };

  // The planes of some samples: the sums over their normals `n` and their heights `h` above a point.
  struct Planes
  {
    double number = 0, squared_heights = 0;
    Vector right{{0, 0, 0}}; // the sum of h n
    Symmetric_block squares;

    void add(const Vector& n, double h)
    {
      ++number;
      squared_heights += h * h;
      right = right + h * n;
      squares.add(1, Symmetric_block::square(n));
    }

    // Adds planes with heights above another point; `d` is the vector from this point to their point.
    void add(const Planes& planes, const Vector& d)
    {
      const Vector by = planes.squares * d;
      number += planes.number;
      squared_heights += planes.squared_heights + 2 * dot(planes.right, d) + dot(by, d);
      right = right + planes.right + by;
      squares.add(1, planes.squares);
    }
  };

  // Returns the planes of the samples on a triangle, with heights above its first corner. A small triangle that cuts a corner of the
  // input may have no samples of the input on all planes at the corner, so planes below its own samples are added.
  Planes planes_on(Index t) const
  {
    Planes planes;
    const Vector& p = mesh_.point(mesh_.triangle(t)[0]);
    const auto add = [&](const Vector& area, const Vector& point) {
      const double size = length(area);
      if (size > 0)
        planes.add((1 / size) * area, dot(area, point - p) / size);
    };
    const Flat_mesh& faces = mesh_.surface().whole_mesh();
    mesh_.samples().for_each_on(t, [&](const Input_sample& s) {
      add(vector_area(faces, mesh_.surface().whole_face(s.face)), s.position);
    });
    const double exact = tolerance * tolerance * length(mesh_.normal(t));
    for (const Back_sample& s : mesh_.samples().of_triangle(t))
      if (s.foot.face != NONE && s.squared_distance > exact)
        add(vector_area(faces, s.foot.face), s.foot.position);
    return planes;
  }

  // Returns the corners of some triangles that the fit may move, in order.
  std::vector<Index> movable_corners(const std::vector<Index>& triangles) const
  {
    std::vector<Index> vertices;
    for (const Index t : triangles)
      for (const Index v : mesh_.triangle(t))
        if (fit_.may_move(v))
          vertices.push_back(v);
    sort_unique(vertices);
    return vertices;
  }

  // Returns the shortest movement to the planes of the samples around a vertex; zero if they have no common point, unless the cost
  // is high.
  Move move_onto_planes(Index v) const
  {
    const Vector& p = mesh_.point(v);
    Planes planes;
    double longest = 0; // a square
    for (const Index t : mesh_.around(v)) {
      for (const Index w : mesh_.triangle(t))
        longest = (std::max)(longest, dot(mesh_.point(w) - p, mesh_.point(w) - p));
      planes.add(planes_[t], mesh_.point(mesh_.triangle(t)[0]) - p);
    }
    if (planes.number == 0)
      return Move();
    const Symmetric_block& squares = planes.squares;
    const Vector& right = planes.right;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares.matrix());
    Vector move{{0, 0, 0}};
    for (int i = 0; i < 3; ++i) {
      const double value = solver.eigenvalues()[i];
      if (!(value > min_eigenvalue * solver.eigenvalues()[2]))
        continue;
      const Vector e{{solver.eigenvectors()(0, i), solver.eigenvectors()(1, i), solver.eigenvectors()(2, i)}};
      move = move + (dot(right, e) / value) * e;
    }
    const double left = planes.squared_heights - 2 * dot(right, move) + dot(move, squares * move);
    const double square = dot(move, move);
    const bool is_useful = square > shortest * shortest * longest && square <= farthest * farthest * longest;
    const bool is_exact = left <= planes.number * tolerance * tolerance * longest;
    return is_useful && (is_exact || mesh_.cost_of(mesh_.around(v)) > high_cost_) ? Move{move, is_exact} : Move();
  }

  // Undoes the movement if the distance increases, a triangle turns over or becomes narrow. Where the distance is nearly zero, a
  // small increase is permitted, because neighbors may still be off their planes. The worth of angles counts only if the planes have
  // no common point.
  bool make(Index v, const Move& move)
  {
    const std::vector<Index>& around = mesh_.around(v);
    const double before = mesh_.cost_of(around), angle = mesh_.angle_of(around);
    const double with_angles = mesh_.cost_of(around, worth_);
    const bool is_exact = is_nearly_zero(before, around);
    std::vector<Vector> normals;
    for (const Index t : around)
      normals.push_back(mesh_.normal(t));
    const double part = part_of_shortest_edge(v);
    Vector& p = mesh_.positions()[v];
    const Vector from = p, to = mesh_.within_bounds(v, p + move.by);
    p = to;
    bool is_sound = mesh_.angle_of(around) >= (std::min)(is_exact ? min_part_of_angle * angle : angle, min_angle);
    if (mesh_.is_on_border(v))
      is_sound = is_sound && part_of_shortest_edge(v) >= (std::min)(min_kept_part * part, min_part_of_edges);
    for (std::size_t i = 0; i < around.size(); ++i)
      is_sound = is_sound && dot(normals[i], mesh_.normal(around[i])) > 0;
    p = from;
    return is_sound && mesh_.move_if(v, to, [&]() {
      if (!move.is_exact)
        return mesh_.cost_of(around, worth_) < with_angles;
      const double after = mesh_.cost_of(around);
      return is_exact ? after <= max_growth * before : after < before;
    });
  }

  // Returns the length of the shortest edge at a vertex, in units of the mean length of the edges there.
  double part_of_shortest_edge(Index v) const
  {
    double sum = 0, least = std::numeric_limits<double>::infinity();
    std::size_t number = 0;
    for (const Index t : mesh_.around(v))
      for (const Index w : mesh_.triangle(t))
        if (w != v) {
          const double size = length(mesh_.point(w) - mesh_.point(v));
          sum += size;
          ++number;
          least = (std::min)(least, size);
        }
    return sum > 0 ? least * double(number) / sum : 0;
  }

  // Compares a sum of area times squared distance with the square of the area.
  bool is_nearly_zero(double cost, const std::vector<Index>& triangles) const
  {
    double area = 0;
    for (const Index t : triangles)
      area += 0.5 * length(mesh_.normal(t));
    return cost <= nearly_zero * area * area;
  }

  Coarse_mesh& mesh_;
  const Surface_fit& fit_;
  std::vector<Planes> planes_; // of each triangle
  Angle_worth worth_;
  double high_cost_ = 0;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_PLANE_FIT_H
