// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_LINE_FITS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_LINE_FITS_H

#include <CGAL/Surface_mesh_coarsening/internal/placement/Fit_equations.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Line_fit.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

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
      if (const double square = dot(d, d); square > 0)
        d = (1 / std::sqrt(square)) * d;
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
        const Vector way = positions_[y] - positions_[x];
        const double square = dot(way, way), weight = width * length;
        Symmetric_block metric = Symmetric_block::identity(), products;
        if (square > 0)
          metric.add(-(1 - damping) / square, Symmetric_block::square(way));
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

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_LINE_FITS_H
