// SPDX-License-Identifier: GPL-3.0-or-later
//
// Section 5.2 of the paper: densities from the deviation of normals; and densities near borders.

#include "support/face_graphs.h"
#include "support/reference_energy.h"

#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/compute_face_densities.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_densities)

namespace SMC = CGAL::Surface_mesh_coarsening;
using generated::Soup;
using test::Mesh;

namespace {

template <class... Parameters>
std::vector<double> densities(const Mesh& mesh, const Parameters&... np)
{
  const auto map = get(CGAL::dynamic_face_property_t<double>(), mesh);
  SMC::compute_face_densities(mesh, map, np...);
  std::vector<double> result;
  for (const auto f : faces(mesh))
    result.push_back(get(map, f));
  return result;
}

void check_against_definition(const Soup& soup)
{
  const Mesh mesh = test::to_mesh(soup);
  const reference::Reference_mesh m(test::to_soup(mesh));
  for (const double r_new : {1., 3., 50., 1e6}) {
    const std::vector<double> computed = densities(mesh, SMC::parameters::maximum_density(r_new).paper_rules(true)),
                              expected = reference::densities(m, r_new);
    BOOST_REQUIRE_EQUAL(computed.size(), expected.size());
    std::size_t wrong = 0;
    for (std::size_t f = 0; f < computed.size(); ++f)
      wrong += !(std::abs(computed[f] - expected[f]) <= 1e-12 * r_new);
    BOOST_CHECK_EQUAL(wrong, 0u);
    BOOST_CHECK_GE(*std::min_element(computed.begin(), computed.end()), 1);
    BOOST_CHECK_CLOSE(*std::max_element(computed.begin(), computed.end()), r_new, 1e-10);
  }
  BOOST_CHECK(densities(mesh) == densities(mesh, SMC::parameters::maximum_density(10.)));
}

} // namespace

BOOST_AUTO_TEST_CASE(by_hand)
{
  // All faces of a regular solid are alike.
  for (const Soup& soup : {generated::cube_grid(1), generated::tetrahedron(), generated::octahedron()}) {
    const Mesh mesh = test::to_mesh(soup);
    for (const double r : densities(mesh, SMC::parameters::maximum_density(7.)))
      BOOST_CHECK_CLOSE(r, 7, 1e-10);
    // With maximum 1, they are 1.
    for (const double r : densities(mesh, SMC::parameters::maximum_density(1.)))
      BOOST_CHECK_EQUAL(r, 1);
  }

  // A cube of 3 x 3 squares a side. Around a vertex: in the middle of a side 4 faces that do not deviate; on an edge
  // 4, of which 2 by sqrt(2); at a corner 3, of which 2 do.
  const double s = std::sqrt(2.);
  const double at_corner = (2 * s + 2 * 2 * s) / 15,
               at_edge = 2 * 2 * s / 16; // a corner, two vertices on edges, one inside
  const std::vector<double> r =
    densities(test::to_mesh(generated::cube_grid(3)), SMC::parameters::maximum_density(10.));
  for (std::size_t f = 0; f < 54; ++f) {
    const std::size_t i = f % 9 / 3, j = f % 3;
    const double deviation = i == 1 && j == 1 ? 0 : i != 1 && j != 1 ? at_corner : at_edge;
    BOOST_CHECK_CLOSE(r[f], 1 + 9 * deviation / at_corner, 1e-10);
  }

  // Two triangles at a right angle. At both ends of the common edge, normals differ by sqrt(2): 2 sqrt(2) of 2 + 2
  // + 1 pairs. A third triangle, in the plane of the second, deviates from the first at one vertex.
  const Soup fold{{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 1, 1}}, {{0, 1, 2}, {1, 0, 3}, {1, 3, 4}}};
  const std::vector<double> d = densities(test::to_mesh(fold), SMC::parameters::maximum_density(11.).paper_rules(true));
  const double first = 3 * s / 6, second = 2 * s / 7, third = s / 6; // pairs: 2 + 3 + 1, 2 + 3 + 2, 3 + 2 + 1
  BOOST_CHECK_CLOSE(d[0], 11, 1e-10);
  BOOST_CHECK_CLOSE(d[1], 1 + 10 * second / first, 1e-10);
  BOOST_CHECK_CLOSE(d[2], 1 + 10 * third / first, 1e-10);
}

BOOST_AUTO_TEST_CASE(agrees_with_the_definition)
{
  using namespace generated;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    check_against_definition(with_noise(triangle_sphere(3), 0.1, seed));
    check_against_definition(with_noise(triangulated(grid(12, 9)), 0.3, seed));
    check_against_definition(with_noise(triangulated(plate_with_windows(2, 2)), 0.1, seed));
  }
  check_against_definition(partly_triangulated(cube_grid(5)));
  check_against_definition(with_noise(bipyramid(200), 0.01));
  check_against_definition(joined(with_noise(triangle_sphere(2), 0.1), grid(5, 5)));
}

// The ends of a tube have radius 1 everywhere. At distance s the deviation is raised to 32 sqrt(A) / (1 + s), up to a tenth
// of the loop's length and at most to four times the largest deviation of normals.
BOOST_AUTO_TEST_CASE(near_borders)
{
  const std::size_t m = 100, n = 60;
  const double pi = generated::pi, side = 2 * std::sin(pi / m), area = side * 2 * pi / m, length = m * side;
  Soup soup = generated::tube(m, n);
  soup.points.push_back({0, 0, 100}); // a sharp edge elsewhere: the largest deviation
  for (const auto& p : std::vector<generated::Point>{{1, 0, 100}, {0, 1, 100}, {0, 0, 101}})
    soup.points.push_back(p);
  const std::size_t v = soup.points.size() - 4;
  for (const generated::Polygon& p :
       {generated::Polygon{v, v + 2, v + 1}, {v, v + 1, v + 3}, {v, v + 3, v + 2}, {v + 1, v + 2, v + 3}})
    soup.polygons.push_back(p);
  const Mesh mesh = test::to_mesh(soup);
  const double r_new = 50;
  const std::vector<double> paper = densities(mesh, SMC::parameters::paper_rules(true)), raised = densities(mesh);
  const double largest = (raised[0] - 1) / (r_new - 1); // checked against the definition below
  BOOST_REQUIRE_EQUAL(paper.size(), m * n + 4);
  BOOST_CHECK(std::equal(paper.begin() + m * n, paper.end(), raised.begin() + m * n)); // no border there, the same scale
  const double unit = (paper[m * n / 2] - 1) / std::sin(pi / m); // density for each unit of deviation
  BOOST_CHECK_CLOSE(largest * (r_new - 1), unit * 32 * std::sqrt(area), 1e-6);
  for (std::size_t f = 0; f < m * n; ++f) {
    const std::size_t row = f % n, from_end = (std::min)(row, n - 1 - row);
    const double s = double(from_end) * 2 * pi / m;
    const bool near = s <= 0.1 * length;
    const double expected = near ? 1 + unit * 32 * std::sqrt(area) / (1 + s) : paper[f];
    BOOST_CHECK_CLOSE(raised[f], (std::max)(expected, paper[f]), 1e-6);
  }
  // Closed meshes have no border. The sides of a tube alone deviate most, and its ends get four times that.
  const Mesh closed = test::to_mesh(generated::with_noise(generated::triangle_sphere(3), 0.05));
  BOOST_CHECK(densities(closed) == densities(closed, SMC::parameters::paper_rules(true)));
  const std::vector<double> alone = densities(test::to_mesh(generated::tube(30, 20)), SMC::parameters::maximum_density(50));
  for (std::size_t f = 0; f < alone.size(); ++f)
    BOOST_CHECK_CLOSE(alone[f], f % 20 == 0 || f % 20 == 19 ? 197 : std::clamp(alone[f], 50., 197.), 1e-6);
}

BOOST_AUTO_TEST_CASE(flat_meshes)
{
  using namespace generated;
  for (const Soup& soup : {grid(8, 5), triangulated(grid(8, 5)), single_triangle(), scaled(fan(30), 1, 1, 0)}) {
    const std::vector<double> r = densities(test::to_mesh(soup));
    BOOST_CHECK_EQUAL(std::count(r.begin(), r.end(), 1.), std::ptrdiff_t(r.size()));
  }
}

// Rounding errors of the normals of a plane are no deviation.
BOOST_AUTO_TEST_CASE(tilted_flat_meshes)
{
  using namespace generated;
  for (const Soup& soup : {grid(30, 20), triangulated(grid(30, 20)), scaled(fan(300), 1, 1, 0)}) {
    std::size_t wrong = 0;
    for (const double r : densities(test::to_mesh(rotated(soup, 0.7, 1.1))))
      wrong += !(std::abs(r - 1) < 1e-6);
    BOOST_CHECK_EQUAL(wrong, 0u);
  }
}

// Faces without area have no normal and cause no deviation.
BOOST_AUTO_TEST_CASE(degenerate_faces)
{
  using namespace generated;
  Soup soup = with_noise(triangle_sphere(3), 0.05);
  for (std::size_t f = 0; f < soup.polygons.size();
       f += 37) { // some triangles become degenerate needles, others points
    const Polygon& p = soup.polygons[f];
    soup.points[p[0]] = soup.points[p[1]];
    if (f % 2 == 0)
      soup.points[p[2]] = soup.points[p[1]];
  }
  check_against_definition(soup);
  for (const Soup& flat : {scaled(triangle_sphere(2), 0), scaled(triangle_sphere(2), 1, 0, 0)})
    for (const double r : densities(test::to_mesh(flat)))
      BOOST_CHECK_EQUAL(r, 1);
}

// Above valence 256 each face is compared with a part of the others.
BOOST_AUTO_TEST_CASE(large_valence)
{
  const Mesh mesh = test::to_mesh(generated::with_noise(generated::bipyramid(3000), 1e-4));
  const std::vector<double> computed = densities(mesh, SMC::parameters::maximum_density(50)),
                            all = reference::densities(reference::Reference_mesh(test::to_soup(mesh)), 50);
  double worst = 0;
  for (std::size_t f = 0; f < computed.size(); ++f)
    worst = (std::max)(worst, std::abs(computed[f] - all[f]));
  BOOST_TEST_MESSAGE("largest difference " << worst);
  BOOST_CHECK_LT(worst, 5);
}

BOOST_AUTO_TEST_CASE(maps)
{
  const Mesh mesh = test::to_mesh(generated::with_noise(generated::triangle_sphere(3), 0.05));
  const std::vector<double> expected = densities(mesh);
  std::map<Mesh::Face_index, float> map;
  SMC::compute_face_densities(mesh, boost::make_assoc_property_map(map));
  for (const auto f : faces(mesh))
    BOOST_CHECK_EQUAL(map[f], float(expected[f]));
  // The result does not depend on size and position.
  const std::vector<double> scaled =
    densities(test::to_mesh(generated::scaled(generated::with_noise(generated::triangle_sphere(3), 0.05), 1024)));
  BOOST_CHECK(scaled == expected);
}

// The caller's positive densities are accepted over a wide range and have the proper effect.
BOOST_AUTO_TEST_CASE(given_densities)
{
  const Mesh mesh = test::to_mesh(generated::triangulated(generated::grid(40, 40)));
  const auto right = [&](double ratio) {
    const auto map = get(CGAL::dynamic_face_property_t<double>(), mesh);
    for (const auto f : faces(mesh))
      put(map, f, mesh.point(target(halfedge(f, mesh), mesh)).x() > 20 ? ratio : 1.);
    Mesh output;
    SMC::coarsen_mesh(mesh, 100, output,
                      SMC::parameters::face_density_map(map).cluster_weight(SMC::Weighted_area_weight()));
    std::size_t n = 0;
    for (const auto v : vertices(output))
      n += output.point(v).x() > 20;
    return n;
  };
  const std::size_t lower = right(0.05), equal = right(1), higher = right(20);
  BOOST_TEST_MESSAGE("vertices in the right half: " << lower << ", " << equal << ", " << higher);
  BOOST_CHECK_LT(lower + 5, equal);
  BOOST_CHECK_LT(equal + 5, higher);
  BOOST_CHECK_NO_THROW(right(1e20));
  BOOST_CHECK_NO_THROW(right(1e-20));
}

BOOST_AUTO_TEST_SUITE_END()
