// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_TEST_LINE_DISTANCE_H
#define CGAL_SURFACE_MESH_COARSENING_TEST_LINE_DISTANCE_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace test {

// Returns the root mean square distance between the marked edges of two meshes.
template <class Mesh, class IsLine, class IsOther>
double line_distance(const Mesh& m, const IsLine& is_line, const Mesh& other, const IsOther& is_other)
{
  typedef typename Mesh::Point Point;
  typedef typename CGAL::Kernel_traits<Point>::Kernel::Segment_3 Segment;
  const auto segment = [](const Mesh& of, auto e) { return Segment(of.point(of.vertex(e, 0)), of.point(of.vertex(e, 1))); };
  std::vector<Segment> segments;
  for (const auto e : other.edges())
    if (is_other(e))
      segments.push_back(segment(other, e));
  double sum = 0, total = 0;
  for (const auto e : m.edges()) {
    if (!is_line(e))
      continue;
    const Segment line = segment(m, e);
    const double length = std::sqrt(line.squared_length());
    for (int i = 0; i < 10; ++i) {
      const Point p = line.source() + (i + 0.5) / 10 * line.to_vector();
      double nearest = std::numeric_limits<double>::infinity();
      for (const Segment& s : segments)
        nearest = (std::min)(nearest, CGAL::squared_distance(p, s));
      sum += length * nearest;
      total += length;
    }
  }
  return std::sqrt(sum / total);
}

} // namespace test

#endif // CGAL_SURFACE_MESH_COARSENING_TEST_LINE_DISTANCE_H
