// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair/carry_over_repair.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace coarsen_mesh_tool {
namespace {

// The polygons of the soup by their places, which are the points with equal coordinates taken for one.
class Polygon_sources
{
  const Soup& soup_;
  const Soup& repaired_;
  std::map<Point, Vertex_number> places_;         // the first point of the soup there
  std::vector<Vertex_number> place_of_point_;     // of the soup; `no_vertex` if it is nowhere
  std::vector<std::vector<std::size_t> > around_; // the polygons of the soup at each place

public:
  Polygon_sources(const Soup& soup, const Soup& repaired) : soup_(soup), repaired_(repaired), around_(soup.points.size())
  {
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      place_of_point_.push_back(is_number(soup.points[v]) ? places_.emplace(soup.points[v], to_vertex_number(v)).first->second
                                                          : no_vertex);
    for (std::size_t f = 0; f < soup.polygons.size(); ++f)
      for (const Vertex_number v : soup.polygons[f])
        if (v < place_of_point_.size() && place_of_point_[v] != no_vertex)
          around_[place_of_point_[v]].push_back(f);
  }

  // The first point of the soup where a point of the repaired soup is.
  Vertex_number place(Vertex_number v) const
  {
    const auto found = places_.find(repaired_.points[v]);
    return found == places_.end() ? 0 : found->second; // repair moves no points
  }

  // Looks among the polygons at the corner that has the fewest: all corners of a polygon of the soup have it.
  std::size_t source(std::size_t f) const
  {
    const std::vector<std::size_t>* fewest = nullptr;
    for (const Vertex_number v : repaired_.polygons[f]) {
      const std::vector<std::size_t>& here = around_[place(v)];
      if (!here.empty() && (fewest == nullptr || here.size() < fewest->size()))
        fewest = &here;
    }
    std::size_t best = 0, most = 0;
    for (std::size_t i = 0; fewest != nullptr && i < fewest->size(); ++i) {
      const std::size_t g = (*fewest)[i];
      std::size_t shared = 0;
      for (const Vertex_number v : repaired_.polygons[f])
        shared += std::binary_search(around_[place(v)].begin(), around_[place(v)].end(), g);
      const bool is_smaller = shared == most && soup_.polygons[g].size() < soup_.polygons[best].size();
      if (shared > most || is_smaller) {
        best = g;
        most = shared;
      }
    }
    return best;
  }

  // The corner of polygon `g` of the soup that is where a point of the repaired soup is; that of another polygon if it has none.
  std::size_t corner(std::size_t g, Vertex_number v, const Polygons& corners) const
  {
    const Vertex_number p = place(v);
    constexpr std::size_t most_others = 16;
    std::vector<std::size_t> candidates{g};
    candidates.insert(candidates.end(), around_[p].begin(),
                      around_[p].begin() + std::ptrdiff_t((std::min)(around_[p].size(), most_others)));
    for (const std::size_t h : candidates)
      for (std::size_t i = 0; i < corners[h].size(); ++i)
        if (place_of_point_[soup_.polygons[h][std::ptrdiff_t(i)]] == p)
          return corners.first_corner(h) + i;
    return corners.corners().size(); // there is none
  }

private:
  static bool is_number(const Point& p) { return p.x() == p.x() && p.y() == p.y() && p.z() == p.z(); }
};

// The values of corners of the repaired polygons, which have none if a corner has none.
Polygons carried_corners(const Polygon_sources& sources, const std::vector<std::size_t>& source, const Polygons& corners,
                         const Soup& repaired)
{
  Polygons result;
  for (std::size_t f = 0; f < source.size() && !corners.corners().empty(); ++f) {
    std::vector<Vertex_number> values;
    for (const Vertex_number v : repaired.polygons[f]) {
      const std::size_t c = sources.corner(source[f], v, corners);
      values.push_back(c < corners.corners().size() ? corners.corners()[c] : no_vertex);
    }
    if (std::find(values.begin(), values.end(), no_vertex) != values.end())
      values.clear();
    result.push_back(values);
  }
  return result;
}

std::vector<std::string> carried_names(const std::vector<std::size_t>& source, const std::vector<std::string>& names)
{
  std::vector<std::string> result;
  for (std::size_t f = 0; f < source.size() && !names.empty(); ++f)
    result.push_back(names[source[f]]);
  return result;
}

} // namespace

void carry_over_repair(const Soup& soup, Soup& repaired)
{
  const Polygon_sources sources(soup, repaired);
  for (const Soup_property& p : soup.of_points) {
    repaired.of_points.push_back({p.name, p.type, {}});
    for (std::size_t v = 0; v < repaired.points.size(); ++v)
      repaired.of_points.back().values.push_back(p.values[sources.place(to_vertex_number(v))]);
  }
  const bool has_fields = !soup.of_polygons.empty() || !soup.texture_corners.empty() || !soup.normal_corners.empty() ||
                          !soup.materials.empty() || !soup.groups.empty() || !soup.objects.empty();
  std::vector<std::size_t> source;
  for (std::size_t f = 0; f < repaired.polygons.size() && has_fields; ++f)
    source.push_back(sources.source(f));
  for (const Soup_property& p : soup.of_polygons) {
    repaired.of_polygons.push_back({p.name, p.type, {}});
    for (const std::size_t g : source)
      repaired.of_polygons.back().values.push_back(p.values[g]);
  }
  repaired.texture_points = soup.texture_points;
  repaired.texture_corners = carried_corners(sources, source, soup.texture_corners, repaired);
  repaired.normals = soup.normals;
  repaired.normal_corners = carried_corners(sources, source, soup.normal_corners, repaired);
  repaired.materials = carried_names(source, soup.materials);
  repaired.groups = carried_names(source, soup.groups);
  repaired.objects = carried_names(source, soup.objects);
  repaired.notes = soup.notes;
  repaired.left_out = soup.left_out;
}

} // namespace coarsen_mesh_tool
