// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares seeds with disjoint neighborhoods with a literal implementation of section 6 of the paper.

#include "support/face_graphs.h"

#include "models.h"

#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/neighborhood_seeds.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstdlib>
#include <iterator>
#include <numeric>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_seeds)

namespace SMC = CGAL::Surface_mesh_coarsening;
namespace utf = boost::unit_test;
using generated::Soup;
using reference::Reference_mesh;
using test::Mesh;

namespace {

std::vector<std::size_t> neighborhood(const Reference_mesh& m, std::size_t face, std::size_t level)
{
  std::vector<std::size_t> found(1, face);
  std::vector<bool> reached(m.number_of_faces(), false);
  reached[face] = true;
  for (std::size_t step = 0, begin = 0; step < level; ++step) {
    const std::size_t end = found.size();
    for (std::size_t i = begin; i < end; ++i)
      for (const std::size_t g : m.faces_across(found[i]))
        if (g != reference::none && !reached[g]) {
          reached[g] = true;
          found.push_back(g);
        }
    begin = end;
  }
  return found;
}

// Traverses the faces in order; takes a face if every face of its neighborhood is free, and then marks them all.
std::vector<std::size_t> expected_seeds(const Reference_mesh& m, std::size_t level,
                                        const std::vector<std::size_t>& order)
{
  std::vector<bool> taken(m.number_of_faces(), false);
  std::vector<std::size_t> seeds;
  for (const std::size_t f : order) {
    const std::vector<std::size_t> faces = neighborhood(m, f, level);
    if (std::any_of(faces.begin(), faces.end(), [&](std::size_t g) { return taken[g]; }))
      continue;
    seeds.push_back(f);
    for (const std::size_t g : faces)
      taken[g] = true;
  }
  return seeds;
}

template <class... Parameters>
std::vector<std::size_t> seeds(const Mesh& mesh, std::size_t level, const Parameters&... np)
{
  std::vector<Mesh::Face_index> found;
  SMC::neighborhood_seeds(mesh, level, std::back_inserter(found), np...);
  return {found.begin(), found.end()};
}

std::vector<std::size_t> array_order(std::size_t n)
{
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  return order;
}

void check_seeds(const Soup& soup)
{
  const Mesh mesh = test::to_mesh(soup);
  const Reference_mesh m(test::to_soup(mesh));
  std::vector<std::size_t> order = array_order(m.number_of_faces()), index(order);
  std::mt19937 engine(3);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[engine() % i]);
  for (std::size_t i = 0; i < order.size(); ++i)
    index[order[i]] = i;
  const auto index_map =
    boost::make_function_property_map<Mesh::Face_index, std::size_t>([&](Mesh::Face_index f) { return index[f]; });
  for (std::size_t level = 0; level <= 10; ++level) {
    BOOST_CHECK(seeds(mesh, level) == expected_seeds(m, level, array_order(m.number_of_faces())));
    BOOST_CHECK(seeds(mesh, level, CGAL::parameters::face_index_map(index_map)) == expected_seeds(m, level, order));
  }
  // Far beyond the size of the mesh: one seed per component.
  for (const std::size_t level : {std::size_t(1000000), std::size_t(1) << 31, std::size_t(1) << 32, std::size_t(-1)})
    BOOST_CHECK_EQUAL(seeds(mesh, level).size(), m.topologies().size());
}

std::size_t count(const std::string& file, std::size_t level)
{
  Mesh mesh;
  test::to_face_graph(test::read_soup(file), mesh);
  return seeds(mesh, level).size();
}

// Within 20 % of the paper's numbers.
void check_near(std::size_t ours, std::size_t paper)
{
  BOOST_TEST_MESSAGE(ours << " seeds, the paper has " << paper);
  BOOST_CHECK_GE(5 * ours, 4 * paper);
  BOOST_CHECK_LE(5 * ours, 6 * paper);
}

} // namespace

BOOST_AUTO_TEST_CASE(agrees_with_the_definition)
{
  using namespace generated;
  check_seeds(tetrahedron());
  check_seeds(single_triangle());
  check_seeds(cube_grid(1));
  check_seeds(triangle_sphere(3));
  check_seeds(triangulated(cube_grid(10)));
  check_seeds(cube_grid(15));
  check_seeds(partly_triangulated(cube_grid(12)));
  check_seeds(dual(triangle_sphere(4)));
  check_seeds(triangulated(torus(20, 12)));
  check_seeds(plate_with_windows(3, 3));
  check_seeds(grid(25, 13));
  check_seeds(triangulated(tube(30, 10)));
  check_seeds(triangulated(grid(150, 1)));
  check_seeds(with_holes(triangle_sphere(4), 15));
  check_seeds(fan(100));
  check_seeds(bipyramid(60));
  check_seeds(joined(joined(triangle_sphere(3), triangulated(grid(9, 9))), many_tetrahedra(7)));
}

BOOST_AUTO_TEST_CASE(counts_known_by_hand)
{
  using namespace generated;
  // Every face.
  BOOST_CHECK_EQUAL(seeds(test::to_mesh(cube_grid(3)), 0).size(), 54u);
  // All faces of a tetrahedron are neighbors.
  BOOST_CHECK_EQUAL(seeds(test::to_mesh(tetrahedron()), 1).size(), 1u);
  // Opposite faces of an octahedron are three steps apart.
  BOOST_CHECK(seeds(test::to_mesh(octahedron()), 1) == (std::vector<std::size_t>{0, 6}));
  BOOST_CHECK_EQUAL(seeds(test::to_mesh(octahedron()), 2).size(), 1u);
  // Along a strip each neighborhood of level k has 2 k + 1 faces.
  const Mesh strip = test::to_mesh(grid(100, 1));
  BOOST_CHECK_EQUAL(seeds(strip, 1).size(), 34u); // faces 0, 3, 6, ..., 99
  BOOST_CHECK_EQUAL(seeds(strip, 3).size(), 15u); // faces 0, 7, ..., 98
  const std::vector<std::size_t> fives = seeds(strip, 2);
  for (std::size_t i = 0; i < fives.size(); ++i)
    BOOST_CHECK_EQUAL(fives[i], 5 * i);
  // Around a ring of 12 squares, two of level 2; three of level 1 leave no room for a fifth.
  const Mesh ring = test::to_mesh(tube(12, 1));
  BOOST_CHECK_EQUAL(seeds(ring, 1).size(), 4u);
  BOOST_CHECK_EQUAL(seeds(ring, 2).size(), 2u);
  // One seed per tetrahedron.
  BOOST_CHECK_EQUAL(seeds(test::to_mesh(many_tetrahedra(30)), 5).size(), 30u);
  BOOST_CHECK(seeds(Mesh(), 3).empty());
}

BOOST_AUTO_TEST_CASE(size_of_a_neighborhood)
{
  // In the middle of a large regular triangulation: 1 + 3 (1 + 2 + ... + k).
  const Reference_mesh m(test::to_soup(test::to_mesh(generated::triangle_sphere(6))));
  const std::size_t middle = 4 * 4 * 4 * 4 * 4 * 4 - 1; // the last of the first eighth: between the middles of edges
  BOOST_CHECK_EQUAL(neighborhood(m, middle, 7).size(), 85u);
}

// Section 6 specifies no order. The order of the array depends on the file: the counts are close to the paper's.
BOOST_AUTO_TEST_CASE(table_1_cube)
{
  check_near(seeds(test::to_mesh(generated::triangulated(generated::cube_grid(50))), 7).size(), 274);
}
BOOST_AUTO_TEST_CASE(table_1_fandisk, *utf::precondition(test::If_found{models::fandisk}))
{
  check_near(count(models::fandisk, 3), 527);
}
BOOST_AUTO_TEST_CASE(table_1_bunny, *utf::precondition(test::If_found{models::bunny}))
{
  check_near(count(models::bunny, 7), 594);
}
BOOST_AUTO_TEST_CASE(table_1_horse, *utf::precondition(test::If_found{models::horse}))
{
  check_near(count(models::horse, 5), 1579);
}

BOOST_AUTO_TEST_SUITE_END()
