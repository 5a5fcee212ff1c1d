// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_SURFACE_FIT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_SURFACE_FIT_H

#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/Coarse_surface.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Fits a triangle mesh, one vertex per cluster, to the faces of the clusters: alternately looks for the closest points of
// samples, and solves for the positions that bring them closest. The samples are the vertices of the faces and their
// centroids, with the weights of the quadrature that is exact for quadratic functions on triangles (3/4 and 1/12).
class Surface_fit
{
public:
  Surface_fit(const Clustered_surface& surface, Coarse_surface& coarse, std::vector<Vector>& positions)
    : surface_(surface), coarse_(coarse), positions_(positions), of_triangle_(coarse.triangles().size())
  {
    collect_samples();
    mean_sample_weight_ = 0;
    for (const Sample& s : samples_)
      mean_sample_weight_ += s.weight / double(positions.size());
  }

  // Finds the closest point of each sample on the triangles around the vertex of its cluster.
  void find_feet()
  {
    for (std::vector<Index>& list : of_triangle_)
      list.clear();
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      Sample& s = samples_[i];
      s.foot.squared_distance = -1;
      Index triangle = NONE;
      for (const Index t : coarse_.around(s.cluster)) {
        const Foot_point foot = foot_on(s.position, coarse_.triangles()[t]);
        if (s.foot.squared_distance < 0 || foot.squared_distance < s.foot.squared_distance) {
          s.foot = foot;
          triangle = t;
        }
      }
      of_triangle_[triangle].push_back(Index(i));
    }
  }

  // Moves the vertices to where the sum of the squared distances between samples and their feet is smallest, the feet
  // keeping their barycentric coordinates. A vertex without samples nearby stays.
  void solve(double inertia)
  {
    typedef Eigen::SparseMatrix<double> Matrix;
    const std::size_t n = positions_.size();
    std::vector<Eigen::Triplet<double> > entries;
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(Eigen::Index(n), 3), guess(Eigen::Index(n), 3);
    entries.reserve(9 * coarse_.triangles().size() + n);
    for (std::size_t t = 0; t < coarse_.triangles().size(); ++t)
      add_equations(Index(t), entries, right);
    const double stay = inertia * mean_sample_weight_;
    for (std::size_t v = 0; v < n; ++v) {
      entries.emplace_back(int(v), int(v), stay);
      for (int k = 0; k < 3; ++k) {
        guess(v, k) = positions_[v][k];
        right(v, k) += stay * positions_[v][k];
      }
    }
    Matrix matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    // The matrix is much like a mass matrix, whose condition does not grow with the mesh.
    Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> solver(matrix);
    solver.setTolerance(1e-8);
    solver.setMaxIterations(200);
    const Eigen::MatrixXd x = solver.solveWithGuess(right, guess);
    if (!x.allFinite())
      return;
    for (std::size_t v = 0; v < n; ++v)
      positions_[v] = {{x(v, 0), x(v, 1), x(v, 2)}};
  }

  // Flips edges of the coarse mesh where that brings the samples of the two triangles clearly closer and leaves no angle
  // below `least_angle`, in radians, that was not there. Returns the number of flips.
  std::size_t flip_edges(double least_angle)
  {
    std::size_t flips = 0;
    for (std::size_t t = 0; t < coarse_.triangles().size(); ++t)
      for (int i = 0; i < 3; ++i)
        flips += flip_if_better(Index(t), i, std::cos(least_angle));
    return flips;
  }

  double sum_of_squared_distances() const
  {
    double sum = 0;
    for (const Sample& s : samples_)
      sum += s.weight * s.foot.squared_distance;
    return sum;
  }

private:
  struct Sample
  {
    Vector position;
    double weight;
    Index cluster;
    Foot_point foot;
  };

  void collect_samples()
  {
    const Clustering_input& input = surface_.input();
    const Flat_mesh& m = input.mesh;
    samples_.reserve(m.number_of_faces() + m.number_of_vertices());
    std::vector<double> weight(m.number_of_vertices(), 0);
    for (std::size_t f = 0; f < m.number_of_faces(); ++f) {
      samples_.push_back({input.centroid[f], 0.75 * input.area[f], surface_.labels()[Index(f)], {}});
      for (const Index v : surface_.vertices(f))
        weight[v] += 0.25 * input.area[f] / m.degree(Index(f));
    }
    for (std::size_t v = 0; v < weight.size(); ++v)
      if (weight[v] > 0)
        samples_.push_back({m.points[v], weight[v], surface_.labels()[m.star[m.first_in_star[v]]], {}});
  }

  Foot_point foot_on(const Vector& p, const Triangle& t) const
  {
    return closest_on_triangle(p, positions_[t[0]], positions_[t[1]], positions_[t[2]]);
  }

  void add_equations(Index t, std::vector<Eigen::Triplet<double> >& entries, Eigen::MatrixXd& right) const
  {
    const Triangle& corner = coarse_.triangles()[t];
    double product[3][3] = {};
    for (const Index i : of_triangle_[t]) {
      const Sample& s = samples_[i];
      for (int a = 0; a < 3; ++a) {
        const double w = s.weight * s.foot.barycentric[a];
        for (int b = 0; b < 3; ++b)
          product[a][b] += w * s.foot.barycentric[b];
        for (int k = 0; k < 3; ++k)
          right(corner[a], k) += w * s.position[k];
      }
    }
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        if (product[a][b] != 0)
          entries.emplace_back(int(corner[a]), int(corner[b]), product[a][b]);
  }

  Vector normal(Index a, Index b, Index c) const
  {
    return cross(positions_[b] - positions_[a], positions_[c] - positions_[a]);
  }

  // The cosine of the smallest angle of a triangle.
  double sharpest(Index a, Index b, Index c) const
  {
    const Index v[3] = {a, b, c};
    double largest = -1;
    for (int i = 0; i < 3; ++i) {
      const Vector e = positions_[v[(i + 1) % 3]] - positions_[v[i]], f = positions_[v[(i + 2) % 3]] - positions_[v[i]];
      const double product = std::sqrt(dot(e, e) * dot(f, f));
      largest = (std::max)(largest, product > 0 ? dot(e, f) / product : 1);
    }
    return largest;
  }

  bool flip_if_better(Index t, int i, double sharpest_allowed)
  {
    const Index u = coarse_.across(t, i);
    if (u == NONE || u < t)
      return false;
    const Triangle first = coarse_.triangles()[t];
    const Index a = first[i], b = first[(i + 1) % 3], c = coarse_.opposite(t, i);
    const Index d = coarse_.opposite(u, coarse_.corner(u, b));
    if (c == d || coarse_.is_edge(c, d))
      return false;
    const double before = (std::max)(sharpest(a, b, c), sharpest(b, a, d));
    const double after = (std::max)(sharpest(c, a, d), sharpest(c, d, b));
    if (after > (std::max)(sharpest_allowed, before))
      return false;
    // The new triangles may not fold over against each other or against the old.
    const Vector normals = normal(a, b, c) + normal(b, a, d), left = normal(c, a, d), right = normal(c, d, b);
    if (dot(left, normals) <= 0 || dot(right, normals) <= 0 || dot(left, right) <= 0)
      return false;
    double now = 0, then = 0;
    for (const Index s : of_triangle_[t])
      compare(samples_[s], a, b, c, d, now, then);
    for (const Index s : of_triangle_[u])
      compare(samples_[s], a, b, c, d, now, then);
    if (!(then < 0.9 * now))
      return false;
    coarse_.flip(t, i, u);
    reassign(t, u);
    return true;
  }

  void compare(const Sample& s, Index a, Index b, Index c, Index d, double& now, double& then) const
  {
    now += s.weight * s.foot.squared_distance;
    then += s.weight * (std::min)(foot_on(s.position, {c, a, d}).squared_distance,
                                  foot_on(s.position, {c, d, b}).squared_distance);
  }

  // Gives the samples of two triangles the closer of both after a flip.
  void reassign(Index t, Index u)
  {
    std::vector<Index> list;
    list.swap(of_triangle_[t]);
    list.insert(list.end(), of_triangle_[u].begin(), of_triangle_[u].end());
    of_triangle_[u].clear();
    for (const Index i : list) {
      Sample& s = samples_[i];
      const Foot_point on_t = foot_on(s.position, coarse_.triangles()[t]);
      const Foot_point on_u = foot_on(s.position, coarse_.triangles()[u]);
      const bool nearer = on_u.squared_distance < on_t.squared_distance;
      s.foot = nearer ? on_u : on_t;
      of_triangle_[nearer ? u : t].push_back(i);
    }
  }

  const Clustered_surface& surface_;
  Coarse_surface& coarse_;
  std::vector<Vector>& positions_;
  std::vector<Sample> samples_;
  std::vector<std::vector<Index> > of_triangle_; // samples whose foot lies on each triangle
  double mean_sample_weight_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_SURFACE_FIT_H
