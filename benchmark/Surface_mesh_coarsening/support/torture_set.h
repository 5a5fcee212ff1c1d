// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_BENCHMARK_TORTURE_SET_H
#define COARSENING_BENCHMARK_TORTURE_SET_H

#include "support/generate_meshes.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

// Meshes designed to break a coarsening: each has many instances of a rare feature of real meshes.
namespace benchmark_support {

struct Torture
{
  std::string name;
  std::function<generated::Soup()> make;
  bool refused = false; // not an oriented surface
};

// Two squares of triangles that touch in one vertex.
inline generated::Soup pinched_squares(std::size_t n)
{
  using namespace generated;
  const Soup square = triangulated(grid(n, n));
  Soup s = joined(square, translated(square, double(n), double(n), 0));
  const std::size_t first = square.points.size();
  for (Polygon& p : s.polygons)
    for (std::size_t& v : p)
      if (v == first)
        v = first - 1;
  return without_isolated_vertices(s);
}

// A grid whose columns are of very uneven widths.
inline generated::Soup uneven_grid(std::size_t m, std::size_t n)
{
  using namespace generated;
  return with_points(triangulated(grid(m, n)), [](const generated::Point& p) {
    return generated::Point{std::pow(1.3, p[0]), p[1], std::sin(p[0])};
  });
}

inline generated::Soup triangles(std::size_t n)
{
  using namespace generated;
  Soup s;
  for (std::size_t i = 0; i < n; ++i)
    s = joined(s, translated(single_triangle(), 2. * double(i), 0, 0));
  return s;
}

// In two sizes: `small` for a quick run.
inline std::vector<Torture> torture_set(bool small)
{
  using namespace generated;
  const auto size = [small](std::size_t large_size, std::size_t small_size) { return small ? small_size : large_size; };
  const std::size_t valence = size(1000, 200), strip = size(2000, 100), handles = size(60, 8);
  const unsigned level = small ? 3 : 6;
  std::vector<Torture> set;
  const auto add = [&set](const std::string& name, const std::function<Soup()>& make) { set.push_back({name, make}); };

  add("one triangle", [] { return single_triangle(); });
  add("one quadrilateral", [] { return grid(1, 1); });
  add("one polygon of many sides", [=] {
    Soup s = fan(valence);
    s.points.pop_back();
    s.polygons.assign(1, Polygon());
    for (std::size_t i = 0; i < s.points.size(); ++i)
      s.polygons[0].push_back(i);
    return s;
  });
  add("tetrahedron", [] { return tetrahedron(); });
  add("torus of 7 vertices", [] { return seven_vertex_torus(); });
  add("torus of 3 x 3 squares", [] { return torus(3, 3); });
  add("needles", [=] { return needles(size(100, 20), 12); });
  add("uneven grid", [=] { return uneven_grid(size(100, 30), size(50, 10)); });
  add("sphere with one-triangle holes", [=] { return with_holes(triangle_sphere(level), size(1000, 20)); });
  add("sphere all holes", [=] { return with_holes(triangle_sphere(level - 1), 100000); });
  add("plate of high genus", [=] { return plate_with_windows(handles); });
  add("plate of high genus, refined", [=] { return triangulated(plate_with_windows(handles, size(5, 2))); });
  add("plate of high genus with holes", [=] { return with_holes(plate_with_windows(handles, 2), size(300, 10)); });
  add("many tetrahedra", [=] { return many_tetrahedra(size(3000, 50)); });
  add("many triangles", [=] { return triangles(size(300, 20)); });
  add("strip of quadrilaterals", [=] { return grid(strip, 1); });
  add("strip of triangles", [=] { return triangulated(grid(strip, 1)); });
  add("annulus one quadrilateral wide", [=] { return tube(strip, 1); });
  add("annulus one triangle wide", [=] { return triangulated(tube(strip, 1)); });
  add("annulus of 3 quadrilaterals", [] { return tube(3, 1); });
  add("annulus of 6 triangles", [] { return triangulated(tube(3, 1)); });
  add("long thin tube", [=] { return triangulated(tube(3, strip)); });
  add("bipyramid of high valence", [=] { return bipyramid(valence); });
  add("fan of high valence", [=] { return fan(valence); });
  add("dual of a bipyramid", [=] { return dual(bipyramid(valence)); });
  add("bipyramid with holes", [=] { return with_holes(bipyramid(valence), 1); });
  add("components of very different sizes", [=] {
    return joined(joined(triangle_sphere(level - 1), translated(scaled(triangle_sphere(level - 1), 1e-5), 3, 0, 0)),
                  translated(scaled(triangulated(torus(20, 10)), 1e-3), 0, 3, 0));
  });
  add("tetrahedra beside a fine sphere", [=] {
    return joined(triangle_sphere(level - 1), scaled(many_tetrahedra(100), 1e3));
  });
  add("cube of squares", [=] { return cube_grid(size(30, 8)); });
  add("mixed triangles and squares", [=] { return partly_triangulated(cube_grid(size(30, 8))); });
  add("mixed torus", [=] { return partly_triangulated(torus(size(60, 12), size(20, 6))); });
  add("hexagons", [=] { return dual(triangle_sphere(level - 1)); });
  add("noise", [=] { return with_noise(triangle_sphere(level - 1), 0.5); });
  add("flat sphere", [=] { return scaled(triangle_sphere(level - 1), 1, 1, 0); });
  add("far from the origin", [=] { return translated(triangle_sphere(level - 1), 1e9, -1e9, 1e9); });
  add("tiny", [=] { return scaled(triangle_sphere(level - 1), 1e-150); });
  add("huge", [=] { return scaled(triangle_sphere(level - 1), 1e150); });
  add("all in one point", [=] { return scaled(triangle_sphere(level - 2), 0); });
  set.push_back({"Moebius strip", [=] { return moebius_strip(strip); }, true});
  set.push_back({"pinched squares", [] { return pinched_squares(10); }, true});
  return set;
}

} // namespace benchmark_support

#endif // COARSENING_BENCHMARK_TORTURE_SET_H
