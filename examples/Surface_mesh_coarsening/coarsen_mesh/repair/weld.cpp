// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair/weld.h"

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace coarsen_mesh_tool {
namespace {

// The points that stay, in cells of twice the tolerance: a point within the tolerance lies in one of eight cells.
class Staying_points
{
  typedef std::array<double, 3> Cell;

  const double tolerance_;
  std::unordered_map<Cell, std::vector<std::size_t>, boost::hash<Cell> > cells_;

  double cell(double x) const
  {
    constexpr double most = 9007199254740992.; // 2^53: larger coordinates within the tolerance of each other are equal
    const double quotient = x / tolerance_ / 2;
    return (std::abs(quotient) < most ? std::floor(quotient) : x) + 0.; // zero has one sign
  }

public:
  explicit Staying_points(double tolerance) : tolerance_(tolerance) {}

  // The first of the points within the tolerance; their number if there is none, and then `i` stays.
  std::size_t first_near(const std::vector<Point>& points, std::size_t i)
  {
    const Point& p = points[i];
    std::size_t first = points.size();
    for (int corner = 0; corner < 8; ++corner) {
      const auto at = [&](int axis) { return cell(p[axis] + (corner >> axis & 1 ? tolerance_ : -tolerance_)); };
      const auto found = cells_.find(Cell{at(0), at(1), at(2)});
      if (found == cells_.end())
        continue;
      for (const std::size_t j : found->second) {
        const Vector gap = points[j] - p;
        if (j < first && std::hypot(gap.x(), gap.y(), gap.z()) <= tolerance_)
          first = j;
      }
    }
    if (first == points.size())
      cells_[Cell{cell(p.x()), cell(p.y()), cell(p.z())}].push_back(i);
    return first;
  }
};

} // namespace

std::size_t weld(std::vector<Point>& points, double tolerance)
{
  Staying_points staying(tolerance);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].x()) || !std::isfinite(points[i].y()) || !std::isfinite(points[i].z()))
      continue;
    const std::size_t first = staying.first_near(points, i);
    if (first == points.size() || points[first] == points[i])
      continue;
    points[i] = points[first];
    ++moved;
  }
  return moved;
}

} // namespace coarsen_mesh_tool
