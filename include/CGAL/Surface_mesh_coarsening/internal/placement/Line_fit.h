// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_LINE_FIT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_LINE_FIT_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Fits the polyline of a feature line to the line, with fixed ends, by the squared distances of samples of the line. Two steps
// alternate: find the closest points of the samples, and move each vertex to the position where its two sides are closest
// to their samples. Along a circle, the fit more than halves the distance of a polyline with vertices on the line.
class Line_fit
{
public:
  Line_fit(const Flat_mesh& mesh, const Coarse_features::Line& line, std::vector<Vector>& positions)
    : line_(line), positions_(positions), sides_(line.is_loop ? line.arcs.size() : line.arcs.size() - 1)
  {
    for (std::size_t k = 0; k < line.arcs.size(); ++k) {
      const std::vector<Index>& v = line.arcs[k].vertices;
      for (std::size_t i = 1; i < v.size(); ++i)
        add_samples(mesh.points[v[i - 1]], mesh.points[v[i]], k);
    }
  }

  void run()
  {
    if (sides_ < 2)
      return;
    for (int round = 0; round < rounds; ++round) {
      find_feet();
      of_side_.assign(sides_, {});
      for (std::size_t i = 0; i < samples_.size(); ++i)
        of_side_[samples_[i].side].push_back(i);
      for (std::size_t k = line_.is_loop ? 0 : 1; k < sides_; ++k)
        move(k);
    }
  }

  void find_feet()
  {
    for (Sample& s : samples_)
      find_foot(s);
  }

  // Calls `visit(x, y, at, off, weight)` for each sample. `x` and `y` are the vertices at the ends of its side, `at` is the
  // position of its foot on the side, from 0 to 1, `off` is the vector from the foot to the sample, and `weight` is its share of
  // the length of the line.
  template <class Visit>
  void for_each_foot(const Visit& visit) const
  {
    for (const Sample& s : samples_) {
      const Index x = line_.arcs[s.side].cluster, y = line_.arcs[(s.side + 1) % line_.arcs.size()].cluster;
      visit(x, y, s.at, s.position - ((1 - s.at) * positions_[x] + s.at * positions_[y]), s.weight);
    }
  }

private:
  static constexpr int rounds = 10;
  static constexpr int samples_per_edge = 4;
  static constexpr double damping = 0.02; // the weight of movements along the line

  struct Sample
  {
    Vector position;
    double weight;
    std::size_t arc;
    std::size_t side; // the side of its foot; sides connect the vertices of consecutive arcs
    double at;        // the position of the foot on its side, from 0 to 1
  };

  Vector& vertex(std::size_t k) { return positions_[line_.arcs[k % line_.arcs.size()].cluster]; }

  void add_samples(const Vector& a, const Vector& b, std::size_t arc)
  {
    const Vector d = b - a;
    const double length = std::sqrt(dot(d, d));
    for (int i = 0; i < samples_per_edge; ++i)
      samples_.push_back({a + ((i + 0.5) / samples_per_edge) * d, length / samples_per_edge, arc, 0, 0});
  }

  // Searches the sides around the vertex of the arc.
  void find_foot(Sample& s)
  {
    double nearest = -1;
    for (std::size_t i = 0; i < 4; ++i) { // two sides before the vertex and two after it
      if (!line_.is_loop && (s.arc + i < 2 || s.arc + i >= sides_ + 2))
        continue;
      const std::size_t side = (s.arc + 2 * sides_ + i - 2) % sides_;
      const Vector &a = vertex(side), &b = vertex(side + 1);
      const double at = closest_on_segment(s.position, a, b);
      const Vector d = s.position - ((1 - at) * a + at * b);
      if (nearest >= 0 && !(dot(d, d) < nearest))
        continue;
      nearest = dot(d, d);
      s.side = side;
      s.at = at;
    }
  }

  // Moves the vertex between side `k` and the previous side.
  void move(std::size_t k)
  {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double total = 0;
    for (const std::size_t side : {(k + sides_ - 1) % sides_, k}) {
      const Vector a = vertex(side), b = vertex(side + 1), d = b - a;
      Eigen::Vector3d along(d[0], d[1], d[2]);
      if (along.squaredNorm() > 0)
        along.normalize();
      const Eigen::Matrix3d metric = Eigen::Matrix3d::Identity() - (1 - damping) * along * along.transpose();
      for (const std::size_t i : of_side_[side]) {
        const Sample& s = samples_[i];
        const double part = side == k ? 1 - s.at : s.at;
        const Vector off = s.position - ((1 - s.at) * a + s.at * b);
        matrix += s.weight * part * part * metric;
        right += s.weight * part * (metric * Eigen::Vector3d(off[0], off[1], off[2]));
        total += s.weight * part * part;
      }
    }
    if (!(total > 0))
      return;
    const Eigen::Vector3d x = matrix.ldlt().solve(right);
    if (x.allFinite())
      vertex(k) = vertex(k) + Vector{{x[0], x[1], x[2]}};
  }

  const Coarse_features::Line& line_;
  std::vector<Vector>& positions_;
  std::size_t sides_;
  std::vector<Sample> samples_;
  std::vector<std::vector<std::size_t> > of_side_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_LINE_FIT_H
