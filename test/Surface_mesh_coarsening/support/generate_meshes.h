// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_TEST_GENERATE_MESHES_H
#define CGAL_SURFACE_MESH_COARSENING_TEST_GENERATE_MESHES_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

// Meshes made by pure functions: the same arguments give the same points and polygons everywhere. Polygons are oriented
// counterclockwise seen from outside, or from above.
namespace generated {

typedef std::array<double, 3> Point;
typedef std::vector<std::size_t> Polygon;

struct Soup
{
  std::vector<Point> points;
  std::vector<Polygon> polygons;
};

constexpr double pi = 3.14159265358979323846;

// ---- changes of a given mesh ----

template <class Function>
Soup with_points(Soup s, const Function& function)
{
  for (Point& p : s.points)
    p = function(p);
  return s;
}

inline Soup scaled(const Soup& s, double x, double y, double z)
{
  return with_points(s, [=](const Point& p) { return Point{p[0] * x, p[1] * y, p[2] * z}; });
}
inline Soup scaled(const Soup& s, double factor) { return scaled(s, factor, factor, factor); }

inline Soup translated(const Soup& s, double x, double y, double z)
{
  return with_points(s, [=](const Point& p) { return Point{p[0] + x, p[1] + y, p[2] + z}; });
}

// About the x axis and then about the z axis.
inline Soup rotated(const Soup& s, double about_x, double about_z)
{
  const double c = std::cos(about_x), d = std::sin(about_x), e = std::cos(about_z), g = std::sin(about_z);
  return with_points(s, [=](const Point& p) {
    const Point q{p[0], c * p[1] - d * p[2], d * p[1] + c * p[2]};
    return Point{e * q[0] - g * q[1], g * q[0] + e * q[1], q[2]};
  });
}

// A number in [-1, 1], from the engine's bits alone: distributions differ between standard libraries.
inline double symmetric_random(std::mt19937& engine) { return double(engine()) / 2147483647.5 - 1; }

inline Soup with_noise(const Soup& s, double amplitude, unsigned seed = 1)
{
  std::mt19937 engine(seed);
  return with_points(s, [&](Point p) {
    for (double& x : p)
      x += amplitude * symmetric_random(engine);
    return p;
  });
}

// Each polygon as a fan of triangles from its first vertex.
inline Soup triangulated(const Soup& s)
{
  Soup t{s.points, {}};
  for (const Polygon& p : s.polygons)
    for (std::size_t i = 2; i < p.size(); ++i)
      t.polygons.push_back({p[0], p[i - 1], p[i]});
  return t;
}

// Every third quadrilateral divided into two triangles.
inline Soup partly_triangulated(const Soup& s)
{
  Soup t{s.points, {}};
  for (std::size_t f = 0; f < s.polygons.size(); ++f) {
    const Polygon& p = s.polygons[f];
    if (f % 3 == 0 && p.size() == 4) {
      t.polygons.push_back({p[0], p[1], p[2]});
      t.polygons.push_back({p[0], p[2], p[3]});
    } else
      t.polygons.push_back(p);
  }
  return t;
}

inline Soup joined(const Soup& a, const Soup& b)
{
  Soup s = a;
  s.points.insert(s.points.end(), b.points.begin(), b.points.end());
  for (Polygon p : b.polygons) {
    for (std::size_t& v : p)
      v += a.points.size();
    s.polygons.push_back(p);
  }
  return s;
}

inline Soup reversed(Soup s)
{
  for (Polygon& p : s.polygons)
    std::reverse(p.begin(), p.end());
  return s;
}

inline Soup without_isolated_vertices(const Soup& s)
{
  std::vector<std::size_t> number(s.points.size(), 0);
  for (const Polygon& p : s.polygons)
    for (const std::size_t v : p)
      number[v] = 1;
  Soup t;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] != 0) {
      number[v] = t.points.size();
      t.points.push_back(s.points[v]);
    }
  t.polygons = s.polygons;
  for (Polygon& p : t.polygons)
    for (std::size_t& v : p)
      v = number[v];
  return t;
}

inline std::set<std::size_t> vertices_on_border(const Soup& s)
{
  std::set<std::pair<std::size_t, std::size_t> > sides;
  for (const Polygon& p : s.polygons)
    for (std::size_t i = 0; i < p.size(); ++i)
      sides.insert({p[i], p[(i + 1) % p.size()]});
  std::set<std::size_t> vertices;
  for (const auto& side : sides)
    if (sides.count({side.second, side.first}) == 0)
      vertices.insert(side.first);
  return vertices;
}

// Removes up to `holes` polygons, in their order, that share no vertex with each other or with the border.
inline Soup with_holes(const Soup& s, std::size_t holes)
{
  Soup t{s.points, {}};
  std::set<std::size_t> used = vertices_on_border(s);
  for (const Polygon& p : s.polygons) {
    const bool clear = std::none_of(p.begin(), p.end(), [&](std::size_t v) { return used.count(v) != 0; });
    if (holes > 0 && clear) {
      used.insert(p.begin(), p.end());
      --holes;
    } else
      t.polygons.push_back(p);
  }
  return t;
}

// The dual of a closed mesh: a vertex at the center of each polygon, a polygon around each vertex.
inline Soup dual(const Soup& s)
{
  Soup t;
  std::vector<std::map<std::size_t, std::pair<std::size_t, std::size_t> > > around(s.points.size());
  for (std::size_t f = 0; f < s.polygons.size(); ++f) {
    const Polygon& p = s.polygons[f];
    Point middle{0, 0, 0};
    for (std::size_t i = 0; i < p.size(); ++i) {
      for (int k = 0; k < 3; ++k)
        middle[k] += s.points[p[i]][k] / double(p.size());
      // From the edge that leaves the vertex to the one that arrives, counterclockwise.
      around[p[i]][p[(i + 1) % p.size()]] = {p[(i + p.size() - 1) % p.size()], f};
    }
    t.points.push_back(middle);
  }
  for (const auto& next : around) {
    if (next.empty())
      continue;
    Polygon polygon;
    const std::size_t first = next.begin()->first;
    std::size_t v = first;
    do {
      polygon.push_back(next.at(v).second);
      v = next.at(v).first;
    } while (v != first);
    t.polygons.push_back(polygon);
  }
  return t;
}

// ---- spheres ----

inline Soup tetrahedron()
{
  return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

inline Soup octahedron()
{
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

// A cube of side 2 with `n` x `n` squares on each side.
inline Soup cube_grid(std::size_t n)
{
  Soup s;
  std::map<std::array<std::size_t, 3>, std::size_t> number;
  const auto vertex = [&](const std::array<std::size_t, 3>& at) {
    const auto inserted = number.insert({at, s.points.size()});
    if (inserted.second) {
      Point p;
      for (int k = 0; k < 3; ++k)
        p[k] = 2. * double(at[k]) / double(n) - 1;
      s.points.push_back(p);
    }
    return inserted.first->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int far = 0; far < 2; ++far)
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
          const auto corner = [&](std::size_t di, std::size_t dj) {
            std::array<std::size_t, 3> at;
            at[axis] = far * n;
            at[(axis + 1) % 3] = i + di;
            at[(axis + 2) % 3] = j + dj;
            return vertex(at);
          };
          Polygon p{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
          if (far == 0)
            std::reverse(p.begin(), p.end());
          s.polygons.push_back(p);
        }
  return s;
}

// A closed shell between two bumpy surfaces very near each other.
inline Soup thin_plate(std::size_t n, double thickness)
{
  Soup s = cube_grid(n);
  for (auto& p : s.points) {
    const double z = 0.3 * std::sin(4 * p[0]) * std::cos(3 * p[1]);
    p[2] = z + 0.5 * thickness * p[2];
  }
  return s;
}

// An octahedron whose triangles are subdivided into four `level` times, on the unit sphere.
inline Soup triangle_sphere(unsigned level)
{
  Soup s = octahedron();
  for (unsigned i = 0; i < level; ++i) {
    Soup finer{s.points, {}};
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t a, std::size_t b) {
      const auto inserted = middles.insert({std::minmax(a, b), finer.points.size()});
      if (inserted.second) {
        Point p;
        for (int k = 0; k < 3; ++k)
          p[k] = s.points[a][k] + s.points[b][k];
        const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        finer.points.push_back({p[0] / length, p[1] / length, p[2] / length});
      }
      return inserted.first->second;
    };
    for (const Polygon& t : s.polygons) {
      const std::size_t a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
      for (const Polygon& part : {Polygon{t[0], a, c}, Polygon{a, t[1], b}, Polygon{c, b, t[2]}, Polygon{a, b, c}})
        finer.polygons.push_back(part);
    }
    s = finer;
  }
  return s;
}

// Two cones over a circle of `n` vertices: two vertices of valence `n`.
inline Soup bipyramid(std::size_t n)
{
  Soup s;
  for (std::size_t i = 0; i < n; ++i)
    s.points.push_back({std::cos(2 * pi * double(i) / double(n)), std::sin(2 * pi * double(i) / double(n)), 0});
  s.points.push_back({0, 0, 1});
  s.points.push_back({0, 0, -1});
  for (std::size_t i = 0; i < n; ++i) {
    s.polygons.push_back({i, (i + 1) % n, n});
    s.polygons.push_back({(i + 1) % n, i, n + 1});
  }
  return s;
}

// Two polygons of `n` sides, joined by squares or rectangles.
inline Soup prism(std::size_t n)
{
  Soup s{{}, {{}, {}}};
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * pi * double(i) / double(n);
    for (const double z : {0., 1.})
      s.points.push_back({std::cos(angle), std::sin(angle), z});
    s.polygons[0].insert(s.polygons[0].begin(), 2 * i);
    s.polygons[1].push_back(2 * i + 1);
    const std::size_t j = (i + 1) % n;
    s.polygons.push_back({2 * i, 2 * j, 2 * j + 1, 2 * i + 1});
  }
  return s;
}

inline Soup many_tetrahedra(std::size_t n)
{
  Soup s;
  const Soup one = tetrahedron();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t first = s.points.size();
    for (const Point& p : one.points)
      s.points.push_back({p[0] + 4. * double(i % 50), p[1] + 4. * double(i / 50), p[2]});
    for (const Polygon& p : one.polygons)
      s.polygons.push_back({p[0] + first, p[1] + first, p[2] + first});
  }
  return s;
}

// A pair of wide discs, joined along their rim, whose triangles are long needles: a bipyramid with rings of very
// uneven radii.
inline Soup needles(std::size_t around, std::size_t rings)
{
  Soup s;
  for (std::size_t r = 0; r < rings; ++r)
    for (std::size_t i = 0; i < around; ++i) {
      const double radius = std::pow(10., double(r) - double(rings) + 1), angle = 2 * pi * double(i) / double(around);
      s.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 1e-3 * double(rings - r)});
    }
  const std::size_t top = s.points.size();
  s.points.push_back({0, 0, 1e-3 * double(rings + 1)});
  s.points.push_back({0, 0, -1});
  const auto at = [&](std::size_t r, std::size_t i) { return r * around + i % around; };
  for (std::size_t i = 0; i < around; ++i) {
    s.polygons.push_back({top, at(0, i), at(0, i + 1)});
    for (std::size_t r = 0; r + 1 < rings; ++r) {
      s.polygons.push_back({at(r, i), at(r + 1, i), at(r + 1, i + 1)});
      s.polygons.push_back({at(r, i), at(r + 1, i + 1), at(r, i + 1)});
    }
    s.polygons.push_back({at(rings - 1, i), top + 1, at(rings - 1, i + 1)});
  }
  return s;
}

// ---- handles ----

// A torus of `m` x `n` quadrilaterals, with `m`, `n` >= 3.
inline Soup torus(std::size_t m, std::size_t n)
{
  Soup s;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const double a = 2 * pi * double(i) / double(m), b = 2 * pi * double(j) / double(n), r = 1 + 0.4 * std::cos(b);
      s.points.push_back({r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)});
    }
  const auto at = [&](std::size_t i, std::size_t j) { return (i % m) * n + j % n; };
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
      s.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return s;
}

// The torus of seven vertices, the smallest one; positions are arbitrary.
inline Soup seven_vertex_torus()
{
  Soup s;
  for (std::size_t i = 0; i < 7; ++i)
    s.points.push_back({std::cos(double(i)), std::sin(2. * double(i)), std::cos(3. * double(i) + 1)});
  for (std::size_t i = 0; i < 7; ++i) {
    s.polygons.push_back({i, (i + 1) % 7, (i + 3) % 7});
    s.polygons.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  return s;
}

// A plate with `genus` windows, made of cubes: a closed surface of that genus, of squares `1 / refinement` wide.
inline Soup plate_with_windows(std::size_t genus, std::size_t refinement = 1)
{
  const std::size_t k = refinement;
  const std::array<std::size_t, 3> size{(2 * genus + 1) * k, 3 * k, k};
  const auto filled = [&](long x, long y, long z) {
    if (x < 0 || y < 0 || z < 0 || x >= long(size[0]) || y >= long(size[1]) || z >= long(size[2]))
      return false;
    return !((std::size_t(x) / k) % 2 == 1 && (std::size_t(y) / k) == 1);
  };
  Soup s;
  std::map<std::array<long, 3>, std::size_t> number;
  for (long x = 0; x < long(size[0]); ++x)
    for (long y = 0; y < long(size[1]); ++y)
      for (long z = 0; z < long(size[2]); ++z) {
        if (!filled(x, y, z))
          continue;
        for (int axis = 0; axis < 3; ++axis)
          for (int far = 0; far < 2; ++far) {
            std::array<long, 3> next{x, y, z};
            next[axis] += far ? 1 : -1;
            if (filled(next[0], next[1], next[2]))
              continue;
            Polygon p;
            for (const std::array<long, 2>& d : {std::array<long, 2>{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
              std::array<long, 3> at{x, y, z};
              at[axis] += far;
              at[(axis + 1) % 3] += d[0];
              at[(axis + 2) % 3] += d[1];
              const auto inserted = number.insert({at, s.points.size()});
              if (inserted.second)
                s.points.push_back({double(at[0]) / double(k), double(at[1]) / double(k), double(at[2]) / double(k)});
              p.push_back(inserted.first->second);
            }
            if (far == 0)
              std::reverse(p.begin(), p.end());
            s.polygons.push_back(p);
          }
      }
  return s;
}

// ---- surfaces with border ----

inline Soup single_triangle() { return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}; }

// A flat rectangle of `m` x `n` unit squares.
inline Soup grid(std::size_t m, std::size_t n)
{
  Soup s;
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t j = 0; j <= n; ++j)
      s.points.push_back({double(i), double(j), 0});
  const auto at = [&](std::size_t i, std::size_t j) { return i * (n + 1) + j; };
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
      s.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return s;
}

// A tube of `m` x `n` quadrilaterals, closed in the first direction.
inline Soup tube(std::size_t m, std::size_t n)
{
  Soup s;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j <= n; ++j) {
      const double a = 2 * pi * double(i) / double(m);
      s.points.push_back({std::cos(a), std::sin(a), 2 * pi * double(j) / double(m)});
    }
  const auto at = [&](std::size_t i, std::size_t j) { return (i % m) * (n + 1) + j; };
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
      s.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return s;
}

// A disc of `n` triangles around one vertex.
inline Soup fan(std::size_t n)
{
  Soup s = bipyramid(n);
  Soup t{s.points, {}};
  t.points.pop_back();
  for (std::size_t i = 0; i < n; ++i)
    t.polygons.push_back({i, (i + 1) % n, n});
  return t;
}

// A strip of `2 n` triangles with one twist: it has no orientation.
inline Soup moebius_strip(std::size_t n)
{
  Soup s;
  for (std::size_t i = 0; i < n; ++i) {
    const double a = 2 * pi * double(i) / double(n);
    for (const double side : {-0.3, 0.3}) {
      const double r = 1 + side * std::cos(0.5 * a);
      s.points.push_back({r * std::cos(a), r * std::sin(a), side * std::sin(0.5 * a)});
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = 2 * i, b = 2 * i + 1;
    const bool last = i + 1 == n;
    const std::size_t c = last ? 1 : 2 * i + 2, d = last ? 0 : 2 * i + 3;
    s.polygons.push_back({a, c, d});
    s.polygons.push_back({a, d, b});
  }
  return s;
}

} // namespace generated

#endif // CGAL_SURFACE_MESH_COARSENING_TEST_GENERATE_MESHES_H
