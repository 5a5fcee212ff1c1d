// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_SURFACE_FIT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_SURFACE_FIT_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Fit_equations.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Fit_samples.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Line_fits.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Fits a triangle mesh, one vertex per cluster, to the faces of the clusters, by the squared distances of samples of both
// surfaces from the other: alternately looks for the closest points of the samples, and solves for the movements that
// bring them closest.
class Surface_fit
{
public:
  Surface_fit(const Clustered_surface& surface, const Border_arcs& border, const Flippable_triangulation& coarse,
              std::vector<Vector>& positions)
    : surface_(surface), border_(border), coarse_(coarse), positions_(positions), samples_(surface, coarse, positions),
      lines_(surface, positions)
  {}

  // Finds the closest points of the samples.
  void find_feet()
  {
    samples_.find_feet();
    lines_.find_feet();
  }

  Fit_samples& samples() { return samples_; }

  // Moves the vertices, but for those on the border and at corners, to where the sum of the squared distances is smallest as far
  // as it can be told from the closest points. Where that leaves a vertex free to slide, it does so towards the middle of its
  // neighbors.
  void move_vertices()
  {
    const std::vector<Triangle>& triangles = coarse_.triangles();
    const double area = samples_.area();
    Fit_equations equations(triangles, positions_.size());
    std::vector<Hold> holds(positions_.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      surface_.cancellation().poll(steps_of_triangle);
      add_triangle(Index(t), equations, holds);
    }
    lines_.add_to(equations, coarse_, line_width * std::sqrt(area / double(positions_.size())), damping);
    const double mean_size = 2 * area / double(triangles.size());
    const double shape = area > 0 ? shape_part * samples_.sum_of_squared_distances() / area / mean_size : 0;
    const double inertia = min_inertia * area / double(positions_.size());
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      equations.add_vertex(Index(v), {{0, 0, 0}}, inertia);
      if (border_.is_on_border(v)) {
        if (!lines_.is_on_line(Index(v)))
          equations.fix(Index(v));
        continue;
      }
      const Vector d = way_to_middle(Index(v));
      equations.add_vertex(Index(v), d, shape * holds[v].weight);
      equations.add_force(Index(v), free_part(holds[v].normals, d), damping * holds[v].squared_weight);
    }
    move_by(equations.solve(100, 1e-3, surface_.cancellation()));
  }

private:
  static constexpr int max_halvings = 5;
  static constexpr std::size_t steps_of_triangle = 16;
  // The weight of sideways movements of samples. They do not change the distance as long as they are small.
  static constexpr double damping = 0.02;
  // The weight of the way to the middle of the neighbors, where the coarse mesh is as far off as it is wide.
  static constexpr double shape_part = 3;
  // Eigenvalues of the normals around a vertex that are smaller than this part of the largest leave it free to slide.
  static constexpr double free_part_below = 0.01;
  static constexpr double min_inertia = 0.001;
  // Lines count as strips of this width, where 1 is about the length of an edge.
  static constexpr double line_width = 1;

  // What holds a vertex: the weights of the samples around, and the sum of the squares of their normals.
  struct Hold
  {
    double weight = 0, squared_weight = 0;
    Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
  };

  // Triangles may not turn by more than a right angle: the vertices of those that would go half as far.
  void move_by(std::vector<Vector> moves)
  {
    const std::vector<Vector> before = positions_;
    std::vector<bool> goes_too_far(positions_.size());
    for (int i = 0; i < max_halvings; ++i) {
      for (std::size_t v = 0; v < positions_.size(); ++v)
        positions_[v] = before[v] + moves[v];
      goes_too_far.assign(positions_.size(), false);
      for (const Triangle& t : coarse_.triangles())
        if (dot(normal_of(before, t), normal_of(positions_, t)) < 0)
          for (const Index v : t)
            goes_too_far[v] = true;
      for (std::size_t v = 0; v < positions_.size(); ++v)
        if (goes_too_far[v])
          moves[v] = 0.5 * moves[v];
    }
    for (std::size_t v = 0; v < positions_.size(); ++v)
      positions_[v] = before[v] + moves[v];
  }

  // Samples whose foot is inside the triangle are held across it, others across the way to their foot. How much a vertex is
  // held is told by those of the input: ways back from chords of sharp edges have directions of their own.
  void add_triangle(Index t, Fit_equations& equations, std::vector<Hold>& holds) const
  {
    const Triangle& corner = coarse_.triangles()[t];
    const Vector doubled = normal_of(positions_, corner);
    const double length = std::sqrt(dot(doubled, doubled)), tiny = 1e-9 * std::sqrt(length);
    const Vector normal = length > 0 ? (1 / length) * doubled : doubled;
    Eigen::Matrix3d inside = Eigen::Matrix3d::Zero();
    const auto add = [&](const Vector& b, const Vector& d, bool is_inside, double weight, bool holds_vertices) {
      const double distance = std::sqrt(dot(d, d));
      const Vector n = is_inside || !(distance > tiny) ? normal : (1 / distance) * d;
      const Eigen::Vector3d w(b[0], b[1], b[2]), e(n[0], n[1], n[2]);
      if (is_inside)
        inside += weight * w * w.transpose();
      else
        equations.add_stiffness(t, weight * w * w.transpose(), n, damping);
      for (std::size_t k = 0; k < 3; ++k) {
        equations.add_force(corner[k], d, weight * b[k]);
        Hold& hold = holds[corner[k]];
        hold.weight += weight * b[k];
        if (holds_vertices) {
          hold.squared_weight += weight * b[k] * b[k];
          hold.normals += weight * b[k] * b[k] * e * e.transpose();
        }
      }
    };
    const double sample_weight = samples_.weight();
    samples_.for_each_on(t, [&](const Fit_samples::Sample& s) {
      const Vector& b = s.foot.barycentric;
      add(b, s.position - point_in(positions_, corner, b), b[0] > 0 && b[1] > 0 && b[2] > 0, sample_weight, true);
    });
    for (const Fit_samples::Back_sample& s : samples_.of_triangle(t))
      if (s.weight > 0)
        add(s.barycentric, s.foot.position - point_in(positions_, corner, s.barycentric), false, s.weight, false);
    equations.add_stiffness(t, inside, normal, damping);
  }

  // From a vertex to the mean of its neighbors, along the surface.
  Vector way_to_middle(Index v) const
  {
    Vector normal{{0, 0, 0}};
    for (const Index t : coarse_.around(v))
      normal = normal + normal_of(positions_, coarse_.triangles()[t]);
    const Vector d = coarse_.mean_of_neighbors(v, positions_) - positions_[v];
    const double square = dot(normal, normal);
    return square > 0 ? d - (dot(d, normal) / square) * normal : d;
  }

  // The part of `d` in the directions in which no sample holds a vertex.
  static Vector free_part(const Eigen::Matrix3d& normals, const Vector& d)
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normals);
    const double largest = solver.eigenvalues()[2];
    Vector part{{0, 0, 0}};
    if (!(largest > 0))
      return part;
    for (int i = 0; i < 3; ++i) {
      const double freedom = 1 - solver.eigenvalues()[i] / (free_part_below * largest);
      const Vector e{{solver.eigenvectors()(0, i), solver.eigenvectors()(1, i), solver.eigenvectors()(2, i)}};
      if (freedom > 0)
        part = part + (freedom * dot(d, e)) * e;
    }
    return part;
  }

  const Clustered_surface& surface_;
  const Border_arcs& border_;
  const Flippable_triangulation& coarse_;
  std::vector<Vector>& positions_;
  Fit_samples samples_;
  Line_fits lines_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_SURFACE_FIT_H
