// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_LINE_FITS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_LINE_FITS_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Fit_equations.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Fits the polyline of a feature line to the line, with fixed ends, by the squared distances of samples of both from the other.
// Two steps alternate: find the closest points of the samples, and move each vertex to the position where its two sides are
// closest to their samples. Samples of the line alone would not keep the corners of a polyline with few vertices near the line.
class Line_fit
{
public:
  Line_fit(const Flat_mesh& mesh, const Coarse_features::Line& line, const Flippable_triangulation& coarse,
           std::vector<Vector>& positions)
    : mesh_(mesh), line_(line), coarse_(coarse), positions_(positions),
      sides_(line.is_loop ? line.arcs.size() : line.arcs.size() - 1)
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
      for (const std::vector<Sample>* samples : {&samples_, &back_samples_})
        for (const Sample& s : *samples)
          of_side_[s.side].push_back(&s);
      for (std::size_t k = line_.is_loop ? 0 : 1; k < sides_; ++k)
        move(k);
      keep_apart();
    }
  }

  // Slides the ends of short sides along the sides beside them. The distance does not keep vertices apart: where the line turns,
  // several would move to the same place. The end where the polyline turns more slides less, because it approximates the line.
  void keep_apart()
  {
    if (sides_ < 2)
      return;
    const std::size_t n = line_.arcs.size();
    double mean_side = 0;
    for (std::size_t k = 0; k < sides_; ++k)
      mean_side += length(vertex(k + 1) - vertex(k)) / double(sides_);
    for (int pass = 0; pass < passes; ++pass)
      for (std::size_t k = 0; k < sides_; ++k) {
        const double least = (std::min)(min_part_of_sides * mean_side, min_part_of_edges * mean_length_around(k));
        const double missing = least - length(vertex(k + 1) - vertex(k));
        if (!(missing > 0))
          continue;
        const double a = turn(k), b = turn(k + 1);
        slide(k, k + n - 1, missing * b / (a + b));
        slide(k + 1, k + 2, missing * a / (a + b));
      }
  }

  void find_feet()
  {
    for (Sample& s : samples_)
      find_foot(s);
    back_samples_.clear();
    for (std::size_t side = 0; side < sides_; ++side)
      add_back_samples(side);
  }

  // Calls `visit(x, y, at, off, weight)` for each sample. `x` and `y` are the vertices at the ends of its side, `at` is its
  // position or the position of its foot on the side, from 0 to 1, `off` is the vector from there to the line, and `weight` is its
  // share of the length of the line or the polyline.
  template <class Visit>
  void for_each_foot(const Visit& visit) const
  {
    for (const std::vector<Sample>* samples : {&samples_, &back_samples_})
      for (const Sample& s : *samples) {
        const Index x = line_.arcs[s.side].cluster, y = line_.arcs[(s.side + 1) % line_.arcs.size()].cluster;
        visit(x, y, s.at, s.position - ((1 - s.at) * positions_[x] + s.at * positions_[y]), s.weight);
      }
  }

  // Calls `visit(x, y)` for the two vertices of each side.
  template <class Visit>
  void for_each_side(const Visit& visit) const
  {
    for (std::size_t k = 0; k < sides_; ++k)
      visit(line_.arcs[k].cluster, line_.arcs[(k + 1) % line_.arcs.size()].cluster);
  }

private:
  static constexpr int rounds = 10;
  static constexpr int samples_per_edge = 4, samples_per_side = 4;
  static constexpr double part_of_direction = 0.5; // of the weights of the samples
  static constexpr double damping = 0.02; // the weight of movements along the line
  // The least length of a side, in units of the mean length of all sides and of the edges around it. Where a line needs more
  // vertices than the surface, sides are shorter than other edges.
  static constexpr double min_part_of_sides = 0.8, min_part_of_edges = 0.4;
  static constexpr int passes = 10; // over the sides that are too short

  // A point of the line with its foot on a side, or a point of a side with its foot on the line.
  struct Sample
  {
    Vector position; // on the line
    double weight;
    std::size_t arc;
    std::size_t side; // sides connect the vertices of consecutive arcs
    double at;        // the position on the side, from 0 to 1
  };

  Vector& vertex(std::size_t k) { return positions_[line_.arcs[k % line_.arcs.size()].cluster]; }

  bool is_end(std::size_t k) const { return !line_.is_loop && (k == 0 || k == sides_); }

  // Returns the mean length of the edges at the ends of a side.
  double mean_length_around(std::size_t side)
  {
    double sum = 0, number = 0;
    for (const std::size_t k : {side, side + 1}) {
      const Index x = line_.arcs[k % line_.arcs.size()].cluster;
      for (const Index t : coarse_.around(x))
        for (const Index y : coarse_.triangles()[t])
          if (y != x) {
            sum += length(positions_[y] - positions_[x]);
            ++number;
          }
    }
    return sum / number;
  }

  // Returns a positive measure of the turn of the polyline at a vertex.
  double turn(std::size_t k)
  {
    constexpr double least = 1e-6, of_end = 1e6;
    if (is_end(k))
      return of_end;
    const Vector a = vertex(k) - vertex(k + line_.arcs.size() - 1), b = vertex(k + 1) - vertex(k);
    const double product = length(a) * length(b);
    return product > 0 ? (std::max)(1 - dot(a, b) / product, least) : least;
  }

  // Moves a vertex towards another one, at most half of the way.
  void slide(std::size_t k, std::size_t towards, double by)
  {
    if (is_end(k))
      return;
    const Vector d = vertex(towards) - vertex(k);
    if (const double whole = length(d); whole > 0)
      vertex(k) = vertex(k) + (std::min)(by / whole, 0.5) * d;
  }

  void add_samples(const Vector& a, const Vector& b, std::size_t arc)
  {
    const Vector d = b - a;
    const double length = std::sqrt(dot(d, d));
    for (int i = 0; i < samples_per_edge; ++i)
      samples_.push_back({a + ((i + 0.5) / samples_per_edge) * d, part_of_direction * length / samples_per_edge, arc, 0, 0});
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

  // Searches the arcs around the side.
  void add_back_samples(std::size_t side)
  {
    const std::size_t n = line_.arcs.size();
    const Vector &a = vertex(side), &b = vertex(side + 1), d = b - a;
    const double weight = part_of_direction * length(d) / samples_per_side;
    for (int i = 0; i < samples_per_side; ++i) {
      const double at = (i + 0.5) / samples_per_side;
      const Vector p = a + at * d;
      Vector foot = a;
      double nearest = -1;
      for (std::size_t k = 0; k < 4; ++k) // one arc before the ends of the side and one after them
        if (line_.is_loop || (side + k >= 1 && side + k <= n))
          improve_on_arc(p, (side + n + k - 1) % n, foot, nearest);
      back_samples_.push_back({foot, weight, NONE, side, at});
    }
  }

  void improve_on_arc(const Vector& p, std::size_t arc, Vector& foot, double& nearest) const
  {
    const std::vector<Index>& v = line_.arcs[arc].vertices;
    for (std::size_t i = 1; i < v.size(); ++i) {
      const Vector &a = mesh_.points[v[i - 1]], &b = mesh_.points[v[i]];
      const Vector q = a + closest_on_segment(p, a, b) * (b - a);
      const double square = dot(p - q, p - q);
      if (nearest >= 0 && !(square < nearest))
        continue;
      nearest = square;
      foot = q;
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
      for (const Sample* s : of_side_[side]) {
        const double part = side == k ? 1 - s->at : s->at;
        const Vector off = s->position - ((1 - s->at) * a + s->at * b);
        matrix += s->weight * part * part * metric;
        right += s->weight * part * (metric * Eigen::Vector3d(off[0], off[1], off[2]));
        total += s->weight * part * part;
      }
    }
    if (!(total > 0))
      return;
    const Eigen::Vector3d x = matrix.ldlt().solve(right);
    if (x.allFinite())
      vertex(k) = vertex(k) + Vector{{x[0], x[1], x[2]}};
  }

  const Flat_mesh& mesh_;
  const Coarse_features::Line& line_;
  const Flippable_triangulation& coarse_;
  std::vector<Vector>& positions_;
  std::size_t sides_;
  std::vector<Sample> samples_, back_samples_; // of the line and of the polyline
  std::vector<std::vector<const Sample*> > of_side_;
};

// The feature lines in the fit of a surface, if any. First each line is fitted alone; then all lines contribute to the equations
// of the surface.
class Line_fits
{
public:
  Line_fits(const Clustered_faces& surface, const Flippable_triangulation& coarse, std::vector<Vector>& positions)
    : positions_(positions)
  {
    if (!surface.features())
      return;
    const Coarse_features& features = *surface.features();
    is_on_line_.assign(positions.size(), false);
    lines_.reserve(features.lines().size());
    for (const Coarse_features::Line& line : features.lines()) {
      lines_.emplace_back(surface.input().mesh, line, coarse, positions);
      for (const Coarse_features::Arc& arc : line.arcs)
        is_on_line_[arc.cluster] = features.corners()[arc.cluster] == NONE;
    }
  }

  bool empty() const { return lines_.empty(); }

  // Returns whether a vertex lies on a line, but not at a corner.
  bool is_on_line(Index v) const { return !is_on_line_.empty() && is_on_line_[v]; }

  void find_feet()
  {
    for (Line_fit& line : lines_)
      line.find_feet();
  }

  // Returns the direction of the line at each vertex on a line.
  std::vector<Vector> directions() const
  {
    std::vector<Vector> result(is_on_line_.size(), Vector{{0, 0, 0}});
    for_each_side([&](Index x, Index y) {
      for (const Index v : {x, y})
        result[v] = result[v] + (positions_[y] - positions_[x]);
    });
    for (Vector& d : result)
      if (const double size = length(d); size > 0)
        d = (1 / size) * d;
    return result;
  }

  // Fits each line alone.
  void run()
  {
    for (Line_fit& line : lines_)
      line.run();
  }

  void keep_apart()
  {
    for (Line_fit& line : lines_)
      line.keep_apart();
  }

  // Calls `visit(x, y)` for the two vertices of each side of the polylines.
  template <class Visit>
  void for_each_side(const Visit& visit) const
  {
    for (const Line_fit& line : lines_)
      line.for_each_side(visit);
  }

  // Samples of lines constrain movements perpendicular to the edge of their foot. A line counts as a strip of width `width`.
  void add_to(Fit_equations& equations, const Flippable_triangulation& coarse, double width, double damping) const
  {
    for (const Line_fit& line : lines_)
      line.for_each_foot([&](Index x, Index y, double at, const Vector& off, double length) {
        const std::vector<Index>& around = coarse.around(x);
        const Index t = *std::find_if(around.begin(), around.end(), [&](Index u) { return coarse.corner(u, y) >= 0; });
        Vector b{{0, 0, 0}};
        b[std::size_t(coarse.corner(t, x))] = 1 - at;
        b[std::size_t(coarse.corner(t, y))] = at;
        const Vector edge = positions_[y] - positions_[x];
        const double square = dot(edge, edge), weight = width * length;
        Symmetric_block metric = Symmetric_block::identity(), products;
        if (square > 0)
          metric.add(-(1 - damping) / square, Symmetric_block::square(edge));
        products.add(weight, Symmetric_block::square(b));
        equations.add_stiffness(t, products, metric);
        equations.add_force(x, off, weight * (1 - at));
        equations.add_force(y, off, weight * at);
      });
  }

private:
  const std::vector<Vector>& positions_;
  std::vector<Line_fit> lines_;
  std::vector<char> is_on_line_; // of each vertex
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_LINE_FITS_H
