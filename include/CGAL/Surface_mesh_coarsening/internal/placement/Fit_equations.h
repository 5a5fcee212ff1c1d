// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_EQUATIONS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_EQUATIONS_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The normal equations of a linear least squares problem for the movements of the vertices of a triangle mesh, kept triangle
// by triangle and vertex by vertex. They are solved by conjugate gradients, preconditioned with the blocks of the vertices;
// the matrix is much like a mass matrix, whose condition does not grow with the mesh.
class Fit_equations
{
public:
  typedef Eigen::Matrix3d Block;

  Fit_equations(const std::vector<Triangle>& triangles, std::size_t vertices)
    : triangles_(triangles), of_triangle_(triangles.size(), Element::Zero()), of_vertex_(vertices, Block::Zero()),
      right_(vertices, Eigen::Vector3d::Zero()), is_fixed_(vertices, false) {}

  // Wants points of triangle `t` to move along `normal` with full weight, and sideways with a part `damping` of that.
  // `products` are the sums over the points of their weights times the products of their barycentric coordinates.
  void add_stiffness(Index t, const Eigen::Matrix3d& products, const Vector& normal, double damping)
  {
    const Eigen::Vector3d n(normal[0], normal[1], normal[2]);
    add_stiffness(t, products, damping * Block::Identity() + (1 - damping) * n * n.transpose());
  }

  // The same with other weights of directions.
  void add_stiffness(Index t, const Eigen::Matrix3d& products, const Block& metric)
  {
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        if (products(a, b) != 0)
          of_triangle_[t].block<3, 3>(3 * a, 3 * b) += products(a, b) * metric;
  }

  // Wants vertex `v` to move by `d` with weight `weight`.
  void add_vertex(Index v, const Vector& d, double weight)
  {
    of_vertex_[v].diagonal().array() += weight;
    add_force(v, d, weight);
  }

  void add_force(Index v, const Vector& d, double weight) { right_[v] += weight * Eigen::Vector3d(d[0], d[1], d[2]); }

  // Keeps vertex `v` where it is.
  void fix(Index v) { is_fixed_[v] = true; }

  // The movements; none if numbers get out of hand.
  std::vector<Vector> solve(std::size_t max_steps, double tolerance, const Cancellation_point& cancellation) const
  {
    const std::size_t n = right_.size();
    const std::vector<Block> inverse = inverse_blocks();
    Vectors x(n, Eigen::Vector3d::Zero()), r = right_, z(n), p(n), q(n);
    hold(r);
    const double goal = product(r, r) * tolerance * tolerance;
    double rz = 0;
    for (std::size_t step = 0; step < max_steps && product(r, r) > goal; ++step) {
      cancellation.poll(n);
      for (std::size_t v = 0; v < n; ++v)
        z[v] = inverse[v] * r[v];
      const double now = product(r, z), beta = step == 0 ? 0 : now / rz;
      rz = now;
      for (std::size_t v = 0; v < n; ++v)
        p[v] = step == 0 ? z[v] : Eigen::Vector3d(z[v] + beta * p[v]);
      multiply(p, q);
      const double alpha = rz / product(p, q);
      for (std::size_t v = 0; v < n; ++v) {
        x[v] += alpha * p[v];
        r[v] -= alpha * q[v];
      }
    }
    std::vector<Vector> moves(n, Vector{{0, 0, 0}});
    for (std::size_t v = 0; v < n; ++v) {
      if (!x[v].allFinite())
        return std::vector<Vector>(n, Vector{{0, 0, 0}});
      moves[v] = {{x[v][0], x[v][1], x[v][2]}};
    }
    return moves;
  }

private:
  typedef Eigen::Matrix<double, 9, 9> Element;
  typedef std::vector<Eigen::Vector3d> Vectors;

  std::vector<Block> inverse_blocks() const
  {
    std::vector<Block> blocks = of_vertex_;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (int a = 0; a < 3; ++a)
        blocks[triangles_[t][a]] += of_triangle_[t].block<3, 3>(3 * a, 3 * a);
    for (Block& b : blocks)
      b = b.inverse().eval();
    return blocks;
  }

  void multiply(const Vectors& p, Vectors& q) const
  {
    for (std::size_t v = 0; v < p.size(); ++v)
      q[v] = of_vertex_[v] * p[v];
    Eigen::Matrix<double, 9, 1> in, out;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (int a = 0; a < 3; ++a)
        in.segment<3>(3 * a) = p[triangles_[t][a]];
      out.noalias() = of_triangle_[t] * in;
      for (int a = 0; a < 3; ++a)
        q[triangles_[t][a]] += out.segment<3>(3 * a);
    }
    hold(q);
  }

  void hold(Vectors& p) const
  {
    for (std::size_t v = 0; v < p.size(); ++v)
      if (is_fixed_[v])
        p[v].setZero();
  }

  static double product(const Vectors& p, const Vectors& q)
  {
    double sum = 0;
    for (std::size_t v = 0; v < p.size(); ++v)
      sum += p[v].dot(q[v]);
    return sum;
  }

  const std::vector<Triangle>& triangles_;
  std::vector<Element> of_triangle_;
  std::vector<Block> of_vertex_;
  Vectors right_;
  std::vector<bool> is_fixed_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_EQUATIONS_H
