// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decides whether a polygon soup is an oriented 2-manifold, and names the first element that is not as it should be.
// The elements are named by their numbers in the file, so that a user can find them there.

#ifndef COARSENING_SUPPORT_SOUP_FAULT_H
#define COARSENING_SUPPORT_SOUP_FAULT_H

#include "io/Mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace coarsening_support {

class Soup_checker
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // One side of one polygon; `from` and `to` are its ends in the polygon's own direction.
  struct Side
  {
    std::size_t face, from, to;
    std::size_t low() const { return (std::min)(from, to); }
    std::size_t high() const { return (std::max)(from, to); }
  };

  const Soup& soup;
  std::vector<std::size_t> first_side; // per face, with one more at the end
  std::vector<Side> sides;
  std::vector<std::size_t> twins; // per side, `none` on the border

public:
  explicit Soup_checker(const Soup& soup) : soup(soup) {}

  // Returns nothing when the soup is an oriented 2-manifold.
  std::optional<std::string> operator()()
  {
    if (soup.polygons.empty())
      return "it has no faces";
    if (auto fault = face_fault())
      return fault;
    collect_sides();
    if (auto fault = edge_fault())
      return fault;
    return vertex_fault();
  }

private:
  std::string vertex_name(std::size_t v) const
  {
    const Point& p = soup.points[v];
    std::ostringstream os;
    os << "vertex " << v << " at (" << p.x() << ", " << p.y() << ", " << p.z() << ")";
    return os.str();
  }

  static std::string edge_name(const Side& s)
  {
    return "the edge between the vertices " + std::to_string(s.low()) + " and " + std::to_string(s.high());
  }

  static std::string face_name(std::size_t f) { return "face " + std::to_string(f); }

  std::optional<std::string> face_fault() const
  {
    std::vector<std::size_t> seen_in(soup.points.size(), none);
    for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
      const auto& polygon = soup.polygons[f];
      if (polygon.size() < 3)
        return face_name(f) + " has only " + std::to_string(polygon.size()) +
               (polygon.size() == 1 ? " vertex" : " vertices");
      for (std::size_t v : polygon) {
        if (v >= soup.points.size())
          return face_name(f) + " names a vertex that is not there (the file has " +
                 std::to_string(soup.points.size()) + " vertices)";
        if (seen_in[v] == f)
          return face_name(f) + " uses " + vertex_name(v) + " twice";
        seen_in[v] = f;
        const Point& p = soup.points[v];
        if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
          return face_name(f) + " uses vertex " + std::to_string(v) + ", which has a coordinate that is not finite";
      }
    }
    return std::nullopt;
  }

  void collect_sides()
  {
    first_side.reserve(soup.polygons.size() + 1);
    for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
      const auto& polygon = soup.polygons[f];
      first_side.push_back(sides.size());
      for (std::size_t i = 0; i < polygon.size(); ++i)
        sides.push_back({f, polygon[i], polygon[i + 1 == polygon.size() ? 0 : i + 1]});
    }
    first_side.push_back(sides.size());
    twins.assign(sides.size(), none);
  }

  // The sides ordered so that those of one edge stand together, in the order of their faces.
  std::vector<std::size_t> sides_by_edge() const
  {
    std::vector<std::size_t> order(sides.size());
    std::vector<std::size_t> begin(soup.points.size() + 1, 0);
    for (const Side& s : sides)
      ++begin[s.low() + 1];
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      begin[v + 1] += begin[v];
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t s = 0; s < sides.size(); ++s)
      order[next[sides[s].low()]++] = s;
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      std::sort(order.begin() + static_cast<std::ptrdiff_t>(begin[v]),
                order.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]), [this](std::size_t a, std::size_t b) {
                  return std::make_pair(sides[a].high(), a) < std::make_pair(sides[b].high(), b);
                });
    return order;
  }

  std::string crowded_edge(const std::vector<std::size_t>& order, std::size_t begin, std::size_t end) const
  {
    std::string faces;
    const std::size_t shown = (std::min)(end, begin + 6);
    for (std::size_t i = begin; i < shown; ++i)
      faces += (i == begin ? "" : i + 1 == end ? " and " : ", ") + std::to_string(sides[order[i]].face);
    return edge_name(sides[order[begin]]) + " is shared by " + std::to_string(end - begin) + " faces (" + faces +
           (shown < end ? ", ...)" : ")");
  }

  std::string turned_edge(std::size_t a, std::size_t b) const
  {
    return "the faces " + std::to_string(sides[a].face) + " and " + std::to_string(sides[b].face) +
           " are oriented against each other along " + edge_name(sides[a]);
  }

  // Pairs the sides, and reports the bad edge whose second face comes first in the file.
  std::optional<std::string> edge_fault()
  {
    const std::vector<std::size_t> order = sides_by_edge();
    std::size_t first_bad_side = none;
    std::optional<std::string> fault;
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
      const Side& s = sides[order[begin]];
      while (end < order.size() && sides[order[end]].low() == s.low() && sides[order[end]].high() == s.high())
        ++end;
      if (end - begin == 1)
        continue;
      const std::size_t a = order[begin], b = order[begin + 1];
      const bool crowded = end - begin > 2;
      if (!crowded && sides[a].from != sides[b].from) {
        twins[a] = b;
        twins[b] = a;
      } else if (b < first_bad_side) {
        first_bad_side = b;
        fault = crowded ? crowded_edge(order, begin, end) : turned_edge(a, b);
      }
    }
    return fault;
  }

  std::size_t next_side(std::size_t s) const
  {
    const std::size_t f = sides[s].face;
    return s + 1 == first_side[f + 1] ? first_side[f] : s + 1;
  }

  std::size_t previous_side(std::size_t s) const
  {
    const std::size_t f = sides[s].face;
    return s == first_side[f] ? first_side[f + 1] - 1 : s - 1;
  }

  // Marks all sides that leave the same vertex as `start` and are reached from it across edges.
  void mark_fan(std::size_t start, std::vector<bool>& marked) const
  {
    for (std::size_t s = start; s != none && !marked[s]; s = twins[previous_side(s)])
      marked[s] = true;
    for (std::size_t t = twins[start]; t != none; t = twins[next_side(t)]) {
      if (marked[next_side(t)])
        break;
      marked[next_side(t)] = true;
    }
  }

  // The faces around a vertex of a 2-manifold form a single fan.
  std::optional<std::string> vertex_fault() const
  {
    std::vector<bool> marked(sides.size(), false);
    std::vector<std::size_t> fans(soup.points.size(), 0), bad;
    for (std::size_t s = 0; s < sides.size(); ++s)
      if (!marked[s]) {
        mark_fan(s, marked);
        if (++fans[sides[s].from] == 2)
          bad.push_back(sides[s].from);
      }
    if (bad.empty())
      return std::nullopt;
    const std::size_t v = *std::min_element(bad.begin(), bad.end());
    return "the faces around " + vertex_name(v) + " form " + std::to_string(fans[v]) +
           " groups that meet only at this vertex";
  }
};

// Describes the first fault of the soup as an oriented 2-manifold; numbers count from 0.
inline std::optional<std::string> soup_fault(const Soup& soup) { return Soup_checker(soup)(); }

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_SOUP_FAULT_H
