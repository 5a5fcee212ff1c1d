// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_ATTACK_RANDOM_MESH_H
#define CGAL_SURFACE_MESH_COARSENING_ATTACK_RANDOM_MESH_H

#include "Random.h"

#include "support/generate_meshes.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

namespace attack {

// Returns a sheet of random folds, whose triangles intersect almost everywhere.
inline generated::Soup folded_sheet(Random& random)
{
  const double folds = random.between(0.1, 3), height = random.between(0, 1);
  const auto fold = [&](double x) { return std::abs(std::remainder(x, 2 * folds)); };
  const generated::Soup sheet = generated::triangulated(generated::grid(4 + random.below(12), 4 + random.below(12)));
  return generated::with_points(generated::rotated(sheet, 0, random.between(0, 3)), [&](const generated::Point& p) {
    return generated::Point{fold(p[0]), fold(p[1]), height * fold(p[0] + p[1])};
  });
}

// Rounds coordinates to multiples of `unit`: many points coincide, and many faces are coplanar.
inline generated::Soup quantized(const generated::Soup& soup, double unit)
{
  const auto nearest = [&](double x) { return unit * std::round(x / unit); };
  return generated::with_points(
    soup, [&](const generated::Point& p) { return generated::Point{nearest(p[0]), nearest(p[1]), nearest(p[2])}; });
}

inline generated::Soup random_surface(Random& random)
{
  using namespace generated;
  const std::size_t a = 1 + random.below(12), b = 1 + random.below(12);
  switch (random.below(23)) {
  case 0: return tetrahedron();
  case 1: return single_triangle();
  case 2: return grid(a, b);
  case 3: return triangulated(grid(3 * a, 2 * b));
  case 4: return torus(a + 2, b + 2);
  case 5: return triangulated(torus(2 * a + 2, b + 2));
  case 6: return tube(a + 2, b);
  case 7: return seven_vertex_torus();
  case 8: return fan(10 * a + b + 2);
  case 9: return bipyramid(5 * a + b + 2);
  case 10: return cube_grid(a);
  case 11: return plate_with_windows(a % 5 + 1, b % 3 + 1);
  case 12: return triangle_sphere(unsigned(a % 5));
  case 13: return dual(triangle_sphere(unsigned(a % 4)));
  case 14: return with_holes(triangle_sphere(unsigned(2 + a % 3)), b);
  case 15: return thin_plate(a + 2, 0.01 * double(b));
  case 16: return joined(triangle_sphere(2), translated(random_surface(random), 5, 0, 0));
  case 17: return folded_sheet(random);
  case 18: return prism(10 * a + b + 2);
  case 19: { // several components near each other
    const Soup one = random_surface(random);
    return joined(one, joined(scaled(one, random.between(0.5, 1.5)), translated(one, random.between(0, 0.1), 0, 0)));
  }
  case 20: return needles(a + 2, b);
  case 21: return quantized(with_noise(dual(triangle_sphere(unsigned(a % 4))), 0.5), 1); // coordinates 0 and 1, polygons
  default: return many_tetrahedra(a);
  }
}

inline double with_flipped_bit(double x, std::size_t bit)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits ^= std::uint64_t(1) << bit;
  std::memcpy(&x, &bits, sizeof bits);
  return x;
}

// Multiplies coordinates by powers of ten: those of all points, or of one in `every`.
inline generated::Soup with_exponents(const generated::Soup& soup, double largest, std::size_t every, Random& random)
{
  return generated::with_points(soup, [&](const generated::Point& p) {
    const double factor = random.one_in(every) ? std::pow(10., random.between(-largest, largest)) : 1;
    return generated::Point{factor * p[0], factor * p[1], factor * p[2]};
  });
}

// Changes coordinates only: faces may self-intersect, shrink to points, or reach the ends of the range of doubles.
inline void move_points(generated::Soup& soup, Random& random)
{
  using namespace generated;
  const auto any = [&]() -> Point& { return soup.points[random.below(soup.points.size())]; };
  switch (random.below(13)) {
  case 0: soup = with_noise(soup, std::pow(10., random.between(-12, 1)), unsigned(random.below(1000))); break;
  case 1: soup = scaled(soup, std::pow(10., random.between(-300, 300))); break;
  case 2: soup = translated(soup, std::pow(10., random.between(0, 18)), 0, -1e3); break;
  case 3: soup = scaled(soup, 1, random.between(-1, 1), random.pick({0., 1e-9, 1e9})); break;
  case 4: std::swap(any(), any()); break;
  case 5: any() = any(); break;
  case 6: {
    double& x = any()[random.below(3)];
    const double y = with_flipped_bit(x, random.below(64));
    x = std::isfinite(y) ? y : x;
    break;
  }
  case 7: soup = rotated(soup, random.between(0, 6), random.between(0, 6)); break;
  case 8: soup = with_exponents(soup, random.pick({3., 30., 150., 300.}), 1 + random.below(40), random); break;
  case 9:
    soup = with_noise(soup, random.between(0, 1), unsigned(random.below(1000)));
    soup = quantized(soup, 1. / double(1 + random.below(4)));
    break;
  default: break;
  }
}

inline generated::Soup random_mesh(Random& random)
{
  generated::Soup soup = random_surface(random);
  for (std::size_t changes = random.below(4); changes > 0; --changes)
    move_points(soup, random);
  return soup;
}

} // namespace attack

#endif // CGAL_SURFACE_MESH_COARSENING_ATTACK_RANDOM_MESH_H
