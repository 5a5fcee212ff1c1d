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

inline generated::Soup random_surface(Random& random)
{
  using namespace generated;
  const std::size_t a = 1 + random.below(12), b = 1 + random.below(12);
  switch (random.below(18)) {
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

// Changes coordinates only: faces may self-intersect, shrink to points, or reach the ends of the range of doubles.
inline void move_points(generated::Soup& soup, Random& random)
{
  using namespace generated;
  const auto any = [&]() -> Point& { return soup.points[random.below(soup.points.size())]; };
  switch (random.below(10)) {
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
