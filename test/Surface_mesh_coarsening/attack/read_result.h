// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_ATTACK_READ_RESULT_H
#define CGAL_SURFACE_MESH_COARSENING_ATTACK_READ_RESULT_H

#include "Case_directory.h"

#include "support/Reference_mesh.h"
#include "support/generate_meshes.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace attack {

typedef std::vector<std::pair<long, std::size_t> > Topologies; // characteristic and loops of each component, sorted

inline Topologies topologies(const std::vector<reference::Topology>& components)
{
  Topologies result;
  for (const reference::Topology& t : components)
    result.push_back({t.characteristic(), t.loops});
  std::sort(result.begin(), result.end());
  return result;
}

// Reads a mesh file by CGAL's readers. Identifies points of equal coordinates in STL files, which have no indices.
inline generated::Soup read_soup(const std::filesystem::path& file)
{
  typedef CGAL::Simple_cartesian<double>::Point_3 Point;
  std::vector<Point> points;
  std::vector<std::vector<std::size_t> > polygons;
  require(CGAL::IO::read_polygon_soup(file.string(), points, polygons), "cannot read " + file.filename().string());
  generated::Soup soup;
  std::map<generated::Point, std::size_t> number;
  const bool is_stl = file.extension() == ".stl";
  std::vector<std::size_t> new_number;
  for (const Point& p : points) {
    const generated::Point q{p.x(), p.y(), p.z()};
    const auto inserted = is_stl ? number.insert({q, soup.points.size()}) : std::make_pair(number.end(), true);
    new_number.push_back(inserted.second ? soup.points.size() : inserted.first->second);
    if (inserted.second)
      soup.points.push_back(q);
  }
  for (auto& polygon : polygons) {
    for (std::size_t& v : polygon)
      v = new_number.at(v);
    soup.polygons.push_back(polygon);
  }
  return soup;
}

struct Result
{
  std::size_t vertices = 0;
  Topologies topologies;
};

// Requires that an output file of the tool holds a 2-manifold of triangles with finite coordinates.
inline Result read_result(const std::filesystem::path& file)
{
  const std::string name = file.filename().string() + ": ";
  const generated::Soup soup = read_soup(file);
  std::vector<reference::Triangle> triangles;
  for (const generated::Polygon& p : soup.polygons) {
    require(p.size() == 3, name + "a face has " + std::to_string(p.size()) + " corners");
    triangles.push_back({p[0], p[1], p[2]});
  }
  for (const generated::Point& p : soup.points)
    for (const double x : p)
      require(std::isfinite(x), name + "a coordinate is not finite");
  const reference::Triangle_surface surface(triangles, soup.points.size());
  require(surface.fault().empty(), name + surface.fault());
  return {soup.points.size(), topologies(surface.topologies())};
}

} // namespace attack

#endif // CGAL_SURFACE_MESH_COARSENING_ATTACK_READ_RESULT_H
