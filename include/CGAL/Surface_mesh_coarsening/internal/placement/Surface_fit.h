// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_SURFACE_FIT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_SURFACE_FIT_H

#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Coarse_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Fit_equations.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Fit_samples.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Line_fits.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Fits a triangle mesh with one vertex per cluster to the faces of the clusters, by the squared distances of samples of both
// surfaces from the other surface. Two steps alternate: find the closest points of the samples, and solve for the movements of
// the vertices that minimize these distances.
class Surface_fit
{
public:
  // Fits the lines, each alone, as far as no triangle turns by more than a right angle.
  explicit Surface_fit(Coarse_mesh& mesh)
    : mesh_(mesh), damping_(has_merged_cells(mesh.surface()) ? damping_of_cells : damping),
      lines_(mesh.surface(), mesh, mesh.positions())
  {
    if (lines_.empty())
      return;
    const std::vector<Vector> before = mesh_.positions();
    lines_.run();
    std::vector<Vector> moves = std::exchange(mesh_.positions(), before);
    for (std::size_t v = 0; v < moves.size(); ++v)
      moves[v] = moves[v] - before[v];
    move_by(std::move(moves));
  }

  // Finds the closest points of the samples; uses every `step`-th sample of the input.
  void find_feet(std::size_t step)
  {
    mesh_.samples().find_feet(step);
    lines_.find_feet();
  }

  // Vertices on the border and at corners of feature lines remain at their places.
  bool may_move(Index v) const { return !mesh_.is_on_border(v) || lines_.is_on_line(v); }

  // Moves the vertices, except on the border and at corners, to the minimum of the sum of squared distances as estimated from
  // the closest points. A vertex that is free to slide moves towards the mean of its neighbors; on a line, along the line.
  // `tolerance` is the part of the residual at which the solution is accepted.
  void move_vertices(double tolerance)
  {
    const std::vector<Triangle>& triangles = mesh_.triangles();
    const double area = mesh_.samples().area();
    Fit_equations equations(triangles, mesh_.positions().size(), mesh_.context());
    std::vector<Normal_constraint> constraints(mesh_.positions().size());
    add_triangles(equations, constraints);
    lines_.add_to(equations, mesh_, line_width * std::sqrt(area / double(mesh_.positions().size())), damping_);
    const double mean_size = 2 * area / double(triangles.size());
    const double shape = area > 0 ? shape_part * mesh_.samples().sum_of_squared_distances() / area / mean_size : 0;
    const double inertia = min_inertia * area / double(mesh_.positions().size());
    const std::vector<Vector> along = lines_.directions();
    for_each_number(mesh_.context(), mesh_.positions().size(), [&](Index v) {
      equations.add_vertex(v, {{0, 0, 0}}, inertia);
      if (!may_move(v)) {
        equations.fix(v);
        return;
      }
      const bool is_on_line = lines_.is_on_line(v);
      const Vector to_middle = vector_to_middle(v), d = is_on_line ? dot(to_middle, along[v]) * along[v] : to_middle;
      equations.add_vertex(v, d, shape * constraints[v].weight);
      const double below = is_on_line ? free_part_on_lines : free_part_below;
      equations.add_force(v, free_part(constraints[v].normals.matrix(), below, d), damping_ * constraints[v].squared_weight);
    });
    std::vector<Vector> moves = equations.solve(100, tolerance);
    for (Vector& move : moves)
      move = over_relaxation * move;
    move_by(std::move(moves));
  }

private:
  static constexpr int max_halvings = 5;
  static constexpr double min_part_of_side = 0.3;
  // Closest points move with the triangles, so movements are too short: 5 rounds with this factor reach the result of 7 without.
  static constexpr double over_relaxation = 1.5;
  static constexpr std::size_t steps_of_triangle = 16, triangles_of_part = 64;
  // The weights of tangential movements of samples. Small tangential movements do not change the distance. With clusters of cells,
  // few faces lie under a triangle: the models of compare_quality are 3 % closer with the smaller weight, at 10 and 20 % of the
  // vertices. With clusters of faces they are 3 % farther with half the weight, at 5 %.
  static constexpr double damping = 0.02, damping_of_cells = 0.008;
  // The weight of the movement to the mean of the neighbors, if the error of the coarse mesh equals its edge length.
  static constexpr double shape_part = 3;
  // A vertex is free to slide in directions in which the eigenvalue of the normals around it is below this fraction of the
  // largest. On lines the fraction is smaller, so that vertices stay where a line turns by a few degrees.
  static constexpr double free_part_below = 0.01, free_part_on_lines = 0.003;
  static constexpr double min_inertia = 0.001;
  // Lines count as strips of this width, in units of about the length of an edge.
  static constexpr double line_width = 1;

  // The constraint of the movements of a vertex: the weights of the samples around it, and the sum of the squares of their normals.
  struct Normal_constraint
  {
    double weight = 0, squared_weight = 0;
    Symmetric_block normals;
  };

  // A term of a constraint.
  struct Constraint_term
  {
    Index vertex;
    double square;
    Vector normal;
  };

  // The contributions of some triangles to their corners.
  struct Terms
  {
    std::vector<std::array<Vector, 3> > forces;
    std::vector<Vector> weights;
    std::vector<Constraint_term> constraints;
  };

  void add_triangles(Fit_equations& equations, std::vector<Normal_constraint>& constraints) const
  {
    const std::vector<Triangle>& triangles = mesh_.triangles();
    std::size_t next = 0;
    for_each_part<Terms>(
      mesh_.context(), triangles.size(), triangles_of_part,
      [&](Terms& terms, std::size_t begin, std::size_t end) {
        terms.forces.clear();
        terms.weights.clear();
        terms.constraints.clear();
        for (std::size_t t = begin; t != end; ++t)
          add_triangle(Index(t), equations, terms);
      },
      [&](const Terms& terms) {
        mesh_.context().poll(steps_of_triangle * terms.forces.size());
        for (std::size_t i = 0; i < terms.forces.size(); ++i, ++next)
          for (std::size_t k = 0; k < 3; ++k) {
            equations.add_force(triangles[next][k], terms.forces[i][k], 1);
            constraints[triangles[next][k]].weight += terms.weights[i][k];
          }
        for (const Constraint_term& c : terms.constraints) {
          constraints[c.vertex].squared_weight += c.square;
          constraints[c.vertex].normals.add(c.square, Symmetric_block::square(c.normal));
        }
      });
  }

  // Keeps the vertices on lines apart. Triangles must not turn by more than a right angle, and sides of feature lines must not
  // become much shorter in one round, because their vertices could change places. Where one would, the movements of its vertices
  // are halved.
  void move_by(std::vector<Vector> moves)
  {
    std::vector<Vector>& positions = mesh_.positions();
    const std::vector<Vector> before = positions;
    for (std::size_t v = 0; v < positions.size(); ++v)
      positions[v] = before[v] + moves[v];
    lines_.keep_apart();
    for (std::size_t v = 0; v < positions.size(); ++v)
      if (lines_.is_on_line(Index(v)))
        moves[v] = positions[v] - before[v];
    std::vector<bool> goes_too_far(positions.size());
    for (int i = 0; i < max_halvings; ++i) {
      for (std::size_t v = 0; v < positions.size(); ++v)
        positions[v] = before[v] + moves[v];
      goes_too_far.assign(positions.size(), false);
      for (const Triangle& t : mesh_.triangles())
        if (dot(normal_of(before, t), normal_of(positions, t)) < 0)
          for (const Index v : t)
            goes_too_far[v] = true;
      lines_.for_each_side([&](Index x, Index y) {
        const Vector d = before[y] - before[x];
        if (dot(positions[y] - positions[x], d) < min_part_of_side * dot(d, d))
          goes_too_far[x] = goes_too_far[y] = true;
      });
      for (std::size_t v = 0; v < positions.size(); ++v)
        if (goes_too_far[v])
          moves[v] = 0.5 * moves[v];
    }
    for (std::size_t v = 0; v < positions.size(); ++v)
      positions[v] = before[v] + moves[v];
  }

  // Samples whose foot is inside the triangle constrain movements along its normal; other samples constrain movements along the
  // vector to their foot. Only samples of the input determine the constraint of a vertex, because vectors from chords of sharp
  // edges to the input have other directions.
  void add_triangle(Index t, Fit_equations& equations, Terms& terms) const
  {
    const Triangle& corner = mesh_.triangle(t);
    const Vector doubled = mesh_.normal(t);
    const double length = std::sqrt(dot(doubled, doubled)), tiny = 1e-9 * std::sqrt(length);
    const Vector normal = length > 0 ? (1 / length) * doubled : doubled;
    std::array<Vector, 3> forces{};
    Vector weights{{0, 0, 0}};
    const auto add = [&](const Vector& b, const Vector& d, double weight) {
      for (std::size_t k = 0; k < 3; ++k)
        forces[k] = forces[k] + weight * b[k] * d;
      weights = weights + weight * b;
    };
    const auto constrain_along = [&](const Vector& b, const Vector& d, double weight) {
      const double distance = std::sqrt(dot(d, d));
      const Vector n = distance > tiny ? (1 / distance) * d : normal;
      Symmetric_block products;
      products.add(weight, Symmetric_block::square(b));
      equations.add_stiffness(t, products, Symmetric_block::metric(n, damping_));
      return n;
    };
    Symmetric_block inside;
    const double sample_weight = mesh_.samples().weight();
    mesh_.samples().for_each_on(t, [&](const Input_sample& s) {
      const Vector &b = s.foot.barycentric, d = s.position - point_in(mesh_.positions(), corner, b);
      add(b, d, sample_weight);
      if (b[0] > 0 && b[1] > 0 && b[2] > 0) {
        inside.add(sample_weight, Symmetric_block::square(b));
        return;
      }
      const Vector n = constrain_along(b, d, sample_weight);
      for (std::size_t k = 0; k < 3; ++k)
        if (b[k] > 0)
          terms.constraints.push_back({corner[k], sample_weight * b[k] * b[k], n});
    });
    for (const Back_sample& s : mesh_.samples().of_triangle(t))
      if (s.weight > 0) {
        const Vector d = s.foot.position - point_in(mesh_.positions(), corner, s.barycentric);
        add(s.barycentric, d, s.weight);
        constrain_along(s.barycentric, d, s.weight);
      }
    equations.add_stiffness(t, inside, Symmetric_block::metric(normal, damping_));
    const Vector squares{{inside.xx, inside.yy, inside.zz}};
    terms.forces.push_back(forces);
    terms.weights.push_back(weights);
    for (std::size_t k = 0; k < 3; ++k)
      terms.constraints.push_back({corner[k], squares[k], normal});
  }

  // Returns the tangential component of the vector from a vertex to the mean of its neighbors.
  Vector vector_to_middle(Index v) const
  {
    Vector normal{{0, 0, 0}};
    for (const Index t : mesh_.around(v))
      normal = normal + mesh_.normal(t);
    const Vector d = mesh_.mean_of_neighbors(v, mesh_.positions()) - mesh_.point(v);
    const double square = dot(normal, normal);
    return square > 0 ? d - (dot(d, normal) / square) * normal : d;
  }

  // Returns the component of `d` in the directions in which no sample constrains the vertex.
  static Vector free_part(const Eigen::Matrix3d& normals, double below, const Vector& d)
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normals);
    const double largest = solver.eigenvalues()[2];
    Vector part{{0, 0, 0}};
    if (!(largest > 0))
      return part;
    for (int i = 0; i < 3; ++i) {
      const double freedom = 1 - solver.eigenvalues()[i] / (below * largest);
      const Vector e{{solver.eigenvectors()(0, i), solver.eigenvectors()(1, i), solver.eigenvectors()(2, i)}};
      if (freedom > 0)
        part = part + (freedom * dot(d, e)) * e;
    }
    return part;
  }

  Coarse_mesh& mesh_;
  const double damping_;
  Line_fits lines_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_SURFACE_FIT_H
