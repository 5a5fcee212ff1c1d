// SPDX-License-Identifier: GPL-3.0-or-later

#include "check/soup_fault.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <vector>

namespace coarsening_support {
namespace {

typedef Edge_pairing::Side Side;

class Soup_checker
{
  static constexpr Side none = Edge_pairing::none;

  const Soup& soup_;
  const std::vector<Vertex_number>& sources_; // of the sides
  const Stop& stop_;

public:
  Soup_checker(const Soup& soup, const Stop& stop) : soup_(soup), sources_(soup.polygons.corners()), stop_(stop) {}

  std::optional<std::string> operator()(std::optional<Edge_pairing>& pairing) const
  {
    if (soup_.polygons.empty())
      return "it has no faces";
    if (auto fault = face_fault())
      return fault;
    pairing.emplace(soup_.polygons, soup_.points.size(), stop_);
    if (!pairing->unpaired().empty())
      return edge_fault(pairing->unpaired());
    return vertex_fault(*pairing);
  }

private:
  std::string vertex_name(std::size_t v) const
  {
    const Point& p = soup_.points[v];
    std::ostringstream os;
    os << "vertex " << v << " at (" << p.x() << ", " << p.y() << ", " << p.z() << ")";
    return os.str();
  }

  static bool is_finite(const Point& p) { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); }

  // Describes the first faulty corner of a face.
  std::optional<std::string> corner_fault(std::size_t f) const
  {
    const Polygons::Polygon polygon = soup_.polygons[f];
    const std::string face = "face " + std::to_string(f);
    if (polygon.size() < 3)
      return face + " has only " + std::to_string(polygon.size()) + (polygon.size() == 1 ? " vertex" : " vertices");
    std::vector<bool> is_met(soup_.points.size(), false);
    for (const Vertex_number v : polygon) {
      if (v >= soup_.points.size())
        return face + " names a vertex that is not there (the file has " + std::to_string(soup_.points.size()) + " vertices)";
      if (is_met[v])
        return face + " uses " + vertex_name(v) + " twice";
      is_met[v] = true;
      if (!is_finite(soup_.points[v]))
        return face + " uses vertex " + std::to_string(v) + ", which has a coordinate that is not finite";
    }
    return std::nullopt;
  }

  std::optional<std::string> face_fault() const
  {
    const Polygons& polygons = soup_.polygons;
    const bool all_finite = std::all_of(soup_.points.begin(), soup_.points.end(), is_finite);
    std::vector<Vertex_number> sorted;
    for (std::size_t f = 0, begin = 0; f < polygons.size(); ++f) {
      stop_at(f, stop_);
      const std::size_t end = polygons.first_corner(f + 1);
      bool is_sound = false;
      if (end - begin == 3) {
        const Vertex_number a = sources_[begin], b = sources_[begin + 1], c = sources_[begin + 2];
        is_sound = (std::max)({a, b, c}) < soup_.points.size() && a != b && b != c && c != a;
      } else {
        sorted.assign(sources_.begin() + std::ptrdiff_t(begin), sources_.begin() + std::ptrdiff_t(end));
        std::sort(sorted.begin(), sorted.end());
        is_sound = sorted.size() > 3 && sorted.back() < soup_.points.size() &&
                   std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
      }
      for (std::size_t s = begin; s < end && is_sound && !all_finite; ++s)
        is_sound = is_finite(soup_.points[sources_[s]]);
      if (!is_sound)
        return corner_fault(f);
      begin = end;
    }
    return std::nullopt;
  }

  std::size_t face_of(Side s) const
  {
    std::size_t low = 0, high = soup_.polygons.size();
    while (high - low > 1) {
      const std::size_t middle = (low + high) / 2;
      (soup_.polygons.first_corner(middle) <= s ? low : high) = middle;
    }
    return low;
  }

  Side next_side(Side s) const
  {
    const std::size_t f = face_of(s);
    return s + 1 == soup_.polygons.first_corner(f + 1) ? Side(soup_.polygons.first_corner(f)) : s + 1;
  }

  std::string edge_fault(const std::vector<Side>& sides) const
  {
    const Vertex_number a = sources_[sides[0]], b = sources_[next_side(sides[0])];
    const std::string edge = "the edge between the vertices " + std::to_string((std::min)(a, b)) + " and " +
                             std::to_string((std::max)(a, b));
    if (sides.size() == 2)
      return "the faces " + std::to_string(face_of(sides[0])) + " and " + std::to_string(face_of(sides[1])) +
             " are oriented against each other along " + edge;
    std::string faces;
    const std::size_t shown = (std::min)(sides.size(), std::size_t(6));
    for (std::size_t i = 0; i < shown; ++i)
      faces += (i == 0 ? "" : i + 1 == sides.size() ? " and " : ", ") + std::to_string(face_of(sides[i]));
    return edge + " is shared by " + std::to_string(sides.size()) + " faces (" + faces +
           (shown < sides.size() ? ", ...)" : ")");
  }

  std::vector<Side> previous_sides() const
  {
    std::vector<Side> previous(sources_.size());
    for (std::size_t f = 0, begin = 0; f < soup_.polygons.size(); ++f) {
      const std::size_t end = soup_.polygons.first_corner(f + 1);
      previous[begin] = Side(end - 1);
      for (std::size_t s = begin + 1; s < end; ++s)
        previous[s] = Side(s - 1);
      begin = end;
    }
    return previous;
  }

  // The faces around a vertex of a 2-manifold form a single fan: a walk from face to face, from the border if the vertex lies
  // on it, visits all of them.
  std::optional<std::string> vertex_fault(const Edge_pairing& pairing) const
  {
    const std::vector<Side> previous = previous_sides();
    const auto walk = [&](Side start, const auto& visit) {
      Side s = start;
      do {
        visit(s);
        s = pairing.twin(previous[s]);
      } while (s != none && s != start);
    };
    std::vector<Side> starts(soup_.points.size(), none), faces(soup_.points.size(), 0);
    for (Side s = 0; s < sources_.size(); ++s) {
      const Vertex_number v = sources_[s];
      ++faces[v];
      if (starts[v] == none || pairing.twin(s) == none)
        starts[v] = s;
    }
    for (std::size_t v = 0; v < starts.size(); ++v) {
      stop_at(v, stop_);
      if (starts[v] == none)
        continue;
      Side met = 0;
      walk(starts[v], [&met](Side) { ++met; });
      if (met < faces[v])
        return "the faces around " + vertex_name(v) + " form " + std::to_string(fans(v, pairing, walk)) +
               " groups that meet only at this vertex";
    }
    return std::nullopt;
  }

  template <class Walk>
  std::size_t fans(std::size_t v, const Edge_pairing& pairing, const Walk& walk) const
  {
    std::vector<bool> met(sources_.size(), false);
    std::size_t number = 0;
    for (const bool at_border : {true, false})
      for (Side s = 0; s < sources_.size(); ++s)
        if (sources_[s] == v && !met[s] && (pairing.twin(s) == none || !at_border)) {
          walk(s, [&met](Side t) { met[t] = true; });
          ++number;
        }
    return number;
  }
};

} // namespace

std::optional<std::string> soup_fault(const Soup& soup, std::optional<Edge_pairing>& pairing, const Stop& stop)
{
  return Soup_checker(soup, stop)(pairing);
}

std::optional<std::string> soup_fault(const Soup& soup)
{
  std::optional<Edge_pairing> pairing;
  return soup_fault(soup, pairing);
}

} // namespace coarsening_support
