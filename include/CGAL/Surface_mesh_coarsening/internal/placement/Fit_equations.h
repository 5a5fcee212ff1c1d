// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_EQUATIONS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_EQUATIONS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// A symmetric matrix of six numbers; a fixed matrix of Eigen stores nine.
struct Symmetric_block
{
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  static Symmetric_block identity() { return {1, 0, 0, 1, 0, 1}; }
  static Symmetric_block square(const Vector& v)
  {
    return {v[0] * v[0], v[0] * v[1], v[0] * v[2], v[1] * v[1], v[1] * v[2], v[2] * v[2]};
  }
  // The metric with weight 1 for movements along a unit normal, and weight `across` for movements perpendicular to it.
  static Symmetric_block metric(const Vector& normal, double across)
  {
    Symmetric_block m;
    m.add(across, identity());
    m.add(1 - across, square(normal));
    return m;
  }

  void add(double factor, const Symmetric_block& b)
  {
    xx += factor * b.xx;
    xy += factor * b.xy;
    xz += factor * b.xz;
    yy += factor * b.yy;
    yz += factor * b.yz;
    zz += factor * b.zz;
  }

  Vector operator*(const Vector& v) const
  {
    return {{xx * v[0] + xy * v[1] + xz * v[2], xy * v[0] + yy * v[1] + yz * v[2], xz * v[0] + yz * v[1] + zz * v[2]}};
  }

  Eigen::Matrix3d matrix() const
  {
    Eigen::Matrix3d m;
    m << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return m;
  }
};

// The normal equations of a linear least squares problem for the movements of the vertices of a triangle mesh, stored per
// triangle and per vertex. They are solved by conjugate gradients, preconditioned with the blocks of the vertices. The
// matrix resembles a mass matrix, whose condition number does not grow with the mesh.
//
// Eigen::ConjugateGradient is not used, because the symmetric blocks of the triangles take a third of the memory of the
// sparse matrix and need no assembly. The sums over the triangles around a vertex are made in their order, so the result does not
// depend on the number of threads.
class Fit_equations
{
public:
  Fit_equations(const std::vector<Triangle>& triangles, std::size_t vertices, const Run_context& context)
    : triangles_(triangles), of_triangle_(triangles.size()), of_vertex_(vertices), right_(vertices, Vector{{0, 0, 0}}),
      is_fixed_(vertices, false), context_(context) {}

  // Adds terms for the movement of points of triangle `t`; `metric` weights the directions. `products` are sums over the points:
  // the weight of a point times the products of its barycentric coordinates.
  void add_stiffness(Index t, const Symmetric_block& products, const Symmetric_block& metric)
  {
    Element& e = of_triangle_[t];
    const std::array<double, 6> factor{{products.xx, products.yy, products.zz, products.yz, products.xz, products.xy}};
    for (std::size_t i = 0; i < 6; ++i)
      if (factor[i] != 0)
        e[i].add(factor[i], metric);
  }

  // Adds a term for the movement of vertex `v` by `d` with weight `weight`.
  void add_vertex(Index v, const Vector& d, double weight)
  {
    of_vertex_[v].add(weight, Symmetric_block::identity());
    add_force(v, d, weight);
  }

  void add_force(Index v, const Vector& d, double weight) { right_[v] = right_[v] + weight * d; }

  // Fixes vertex `v`.
  void fix(Index v) { is_fixed_[v] = true; }

  // Returns the movements; all are zero if a number overflows.
  std::vector<Vector> solve(std::size_t max_steps, double tolerance) const
  {
    const std::size_t n = right_.size();
    const Corners corners(numbers_below(Index(3 * triangles_.size())), n, [this](Index c) { return triangles_[c / 3][c % 3]; });
    const std::vector<Symmetric_block> inverse = inverse_blocks(corners);
    std::vector<Vector> x(n, Vector{{0, 0, 0}}), r = right_, z(n), p(n), q(n);
    clear_fixed(r);
    const double goal = product(r, r) * tolerance * tolerance;
    double rz = 0;
    for (std::size_t step = 0; step < max_steps && product(r, r) > goal; ++step) {
      context_.poll(n);
      for (std::size_t v = 0; v < n; ++v)
        z[v] = inverse[v] * r[v];
      const double now = product(r, z), beta = step == 0 ? 0 : now / rz;
      rz = now;
      for (std::size_t v = 0; v < n; ++v)
        p[v] = step == 0 ? z[v] : z[v] + beta * p[v];
      multiply(corners, p, q);
      const double alpha = rz / product(p, q);
      for (std::size_t v = 0; v < n; ++v) {
        x[v] = x[v] + alpha * p[v];
        r[v] = r[v] - alpha * q[v];
      }
    }
    const auto is_finite = [](const Vector& d) { return std::isfinite(d[0]) && std::isfinite(d[1]) && std::isfinite(d[2]); };
    return std::all_of(x.begin(), x.end(), is_finite) ? x : std::vector<Vector>(n, Vector{{0, 0, 0}});
  }

private:
  // The blocks of the pairs of corners 00, 11, 22, 12, 20 and 01.
  typedef std::array<Symmetric_block, 6> Element;

  // The corners of triangles at each vertex. Corner `3 t + i` is corner `i` of triangle `t`.
  typedef Bucketed_items<Index> Corners;

  static constexpr std::size_t vertices_of_chunk = 256;

  std::vector<Symmetric_block> inverse_blocks(const Corners& corners) const
  {
    std::vector<Symmetric_block> blocks = of_vertex_;
    const Run_context context = context_.uninterrupted();
    for_each_chunk(context, blocks.size(), vertices_of_chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) {
        for (const Index c : corners[v])
          blocks[v].add(1, of_triangle_[c / 3][c % 3]);
        const Eigen::Matrix3d inverse = blocks[v].matrix().inverse();
        blocks[v] = {inverse(0, 0), inverse(0, 1), inverse(0, 2), inverse(1, 1), inverse(1, 2), inverse(2, 2)};
      }
    });
    return blocks;
  }

  void multiply(const Corners& corners, const std::vector<Vector>& p, std::vector<Vector>& q) const
  {
    for_each_chunk(context_.uninterrupted(), p.size(), vertices_of_chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v)
        q[v] = row_product(Index(v), corners[v], p);
    });
  }

  template <class Corner_range>
  Vector row_product(Index v, const Corner_range& corners, const std::vector<Vector>& p) const
  {
    constexpr std::size_t block[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
    if (is_fixed_[v])
      return {{0, 0, 0}};
    Vector sum = of_vertex_[v] * p[v];
    for (const Index c : corners) {
      const Triangle& corner = triangles_[c / 3];
      const Element& e = of_triangle_[c / 3];
      const auto& row = block[c % 3];
      sum = sum + e[row[0]] * p[corner[0]] + e[row[1]] * p[corner[1]] + e[row[2]] * p[corner[2]];
    }
    return sum;
  }

  void clear_fixed(std::vector<Vector>& p) const
  {
    for (std::size_t v = 0; v < p.size(); ++v)
      if (is_fixed_[v])
        p[v] = {{0, 0, 0}};
  }

  static double product(const std::vector<Vector>& p, const std::vector<Vector>& q)
  {
    double sum = 0;
    for (std::size_t v = 0; v < p.size(); ++v)
      sum += dot(p[v], q[v]);
    return sum;
  }

  const std::vector<Triangle>& triangles_;
  std::vector<Element> of_triangle_;
  std::vector<Symmetric_block> of_vertex_;
  std::vector<Vector> right_;
  std::vector<char> is_fixed_; // bytes, which several threads may write
  const Run_context context_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_EQUATIONS_H
