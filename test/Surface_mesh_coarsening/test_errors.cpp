// SPDX-License-Identifier: GPL-3.0-or-later
//
// Refused input, with its exception and message; the output does not change.

#include "support/face_graphs.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/compute_face_densities.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/extract_dual_mesh.h>
#include <CGAL/Surface_mesh_coarsening/is_valid_clustering.h>
#include <CGAL/Surface_mesh_coarsening/neighborhood_seeds.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>

BOOST_AUTO_TEST_SUITE(test_errors)

namespace SMC = CGAL::Surface_mesh_coarsening;
using generated::Soup;
using reference::Labels;
using test::Mesh;

namespace {

const double infinity = std::numeric_limits<double>::infinity();
const double not_a_number = std::numeric_limits<double>::quiet_NaN();

bool equal(const Soup& a, const Soup& b) { return a.points == b.points && a.polygons == b.polygons; }

// Runs `f` on an output that must not change and expects an `Exception` whose message has all of `parts`.
template <class Exception, class Function>
void expect(const Function& f, const std::vector<std::string>& parts)
{
  const Soup before = generated::joined(generated::tetrahedron(), generated::octahedron());
  Mesh output = test::to_mesh(before);
  const Soup start = test::to_soup(output);
  try {
    f(output);
    BOOST_ERROR("nothing was thrown where '" << (parts.empty() ? "" : parts.front()) << "' was expected");
  } catch (const Exception& e) {
    const std::string message = e.what();
    for (const std::string& part : parts)
      BOOST_CHECK_MESSAGE(message.find(part) != std::string::npos,
                          "'" << message << "' does not have '" << part << "'");
  }
  BOOST_CHECK(equal(test::to_soup(output), start));
}

void expect_invalid_mesh(const Mesh& mesh, const std::vector<std::string>& parts)
{
  expect<SMC::Invalid_input>([&](Mesh& output) { SMC::coarsen_mesh(mesh, 4, output); }, parts);
  expect<SMC::Invalid_input>([&](Mesh& output) { SMC::coarsen_mesh(mesh, output, SMC::parameters::neighborhood_level(7)); },
                             parts);
}

// Also the functions that use the connectivity only.
void expect_not_manifold(const Mesh& mesh, const std::vector<std::string>& parts)
{
  expect_invalid_mesh(mesh, parts);
  std::vector<Mesh::Face_index> seeds;
  const auto labels =
    boost::make_function_property_map<Mesh::Face_index, std::size_t>([](Mesh::Face_index f) { return std::size_t(f); });
  expect<SMC::Invalid_input>([&](Mesh&) { SMC::neighborhood_seeds(mesh, 2, std::back_inserter(seeds)); }, parts);
  BOOST_CHECK(seeds.empty());
  expect<SMC::Invalid_input>([&](Mesh&) { SMC::is_valid_clustering(mesh, labels); }, parts);
  expect<SMC::Invalid_input>([&](Mesh& output) { SMC::extract_dual_mesh(mesh, labels, output); }, parts);
}

Mesh some_mesh() { return test::to_mesh(generated::with_noise(generated::triangle_sphere(3), 0.02)); }

// N works, and numbers beyond it do not.
void check_nearest(const Soup& soup, std::size_t asked, bool too_small)
{
  const Mesh mesh = test::to_mesh(soup);
  std::size_t nearest = 0;
  expect<SMC::Unreachable_number_of_vertices>(
    [&](Mesh& output) {
      try {
        SMC::coarsen_mesh(mesh, asked, output);
      } catch (const SMC::Unreachable_number_of_vertices& e) {
        nearest = e.nearest();
        throw;
      }
    },
    {std::to_string(asked) + (asked == 1 ? " vertex" : " vertices")});
  BOOST_CHECK(too_small ? nearest > asked : nearest < asked);
  Mesh output;
  SMC::coarsen_mesh(mesh, nearest, output);
  BOOST_CHECK_EQUAL(output.number_of_vertices(), nearest);
  const std::size_t beyond = too_small ? nearest - 1 : nearest + 1;
  try {
    SMC::coarsen_mesh(mesh, beyond, output);
    BOOST_ERROR(beyond << " is not refused, though the nearest number was said to be " << nearest);
  } catch (const SMC::Unreachable_number_of_vertices& e) {
    BOOST_CHECK_EQUAL(e.nearest(), nearest);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(kinds_of_exceptions)
{
  BOOST_CHECK((std::is_base_of<std::invalid_argument, SMC::Invalid_input>::value));
  BOOST_CHECK((std::is_base_of<std::invalid_argument, SMC::Unreachable_number_of_vertices>::value));
  BOOST_CHECK((std::is_base_of<std::runtime_error, SMC::Coarsening_cancelled>::value));
}

BOOST_AUTO_TEST_CASE(empty_mesh)
{
  expect_invalid_mesh(Mesh(), {"no faces"});
  Mesh vertices_only;
  vertices_only.add_vertex(test::Point(0, 0, 0));
  expect_invalid_mesh(vertices_only, {"no faces"});
}

// Two tetrahedra at one vertex, and two flat triangles likewise.
BOOST_AUTO_TEST_CASE(vertex_with_two_fans)
{
  Mesh two = test::to_mesh(generated::many_tetrahedra(2));
  const Mesh::Vertex_index kept(0), gone(4);
  const auto begin = halfedge(gone, two);
  for (const auto h : CGAL::halfedges_around_target(begin, two))
    set_target(h, kept, two);
  expect_not_manifold(two, {"vertex 0", "not a manifold vertex"});

  Mesh bow_tie;
  std::vector<Mesh::Vertex_index> v;
  for (int i = 0; i < 5; ++i)
    v.push_back(bow_tie.add_vertex(test::Point(i, i * i, 0)));
  bow_tie.add_face(v[0], v[1], v[2]);
  bow_tie.add_face(v[2], v[3], v[4]);
  expect_not_manifold(bow_tie, {"vertex 2", "border twice"});
}

// A face joined from two with three common vertices.
BOOST_AUTO_TEST_CASE(face_that_visits_a_vertex_twice)
{
  // A square with a spike inside: two triangles joined across an edge that ends at an inner vertex of valence one.
  Mesh m = test::to_mesh(generated::triangle_sphere(1));
  const auto h = *halfedges(m).begin();
  const auto spike = CGAL::Euler::add_center_vertex(h, m);
  // Removes two of the three edges at the new vertex.
  CGAL::Euler::join_face(CGAL::prev(opposite(spike, m), m), m);
  const auto rest = halfedge(target(spike, m), m);
  for (const auto g : {rest})
    if (CGAL::degree(target(g, m), m) > 1) {
      const auto next = opposite(CGAL::next(g, m), m);
      CGAL::Euler::join_face(next, m);
    }
  bool twice = false;
  for (const auto f : faces(m)) {
    std::vector<Mesh::Vertex_index> around;
    for (const auto v : CGAL::vertices_around_face(halfedge(f, m), m))
      around.push_back(v);
    std::sort(around.begin(), around.end());
    twice = twice || std::adjacent_find(around.begin(), around.end()) != around.end();
  }
  BOOST_REQUIRE(twice);
  expect_not_manifold(m, {"face "});
}

BOOST_AUTO_TEST_CASE(coordinates_that_are_not_finite)
{
  for (const double x : {infinity, -infinity, not_a_number})
    for (int k = 0; k < 3; ++k) {
      Soup soup = generated::triangle_sphere(2);
      soup.points[7][k] = x;
      const Mesh mesh = test::to_mesh(soup);
      expect_invalid_mesh(mesh, {"coordinate " + std::to_string(k), "vertex 7", std::isnan(x) ? "nan" : "inf"});
      const auto densities = get(CGAL::dynamic_face_property_t<double>(), mesh);
      expect<SMC::Invalid_input>([&](Mesh&) { SMC::compute_face_densities(mesh, densities); }, {"vertex 7"});
    }
}

BOOST_AUTO_TEST_CASE(numbers_of_vertices_that_cannot_be_had)
{
  using namespace generated;
  for (const std::size_t n : {0, 1, 3})
    check_nearest(triangle_sphere(3), n, true);
  check_nearest(triangle_sphere(2), 67, false);
  check_nearest(triangle_sphere(2), std::size_t(-1), false);
  check_nearest(tetrahedron(), 5, false);
  check_nearest(grid(5, 5), 2, true);
  check_nearest(grid(5, 5), 37, false);
  check_nearest(tube(12, 4), 5, true);
  check_nearest(triangulated(torus(20, 10)), 6, true);
  check_nearest(seven_vertex_torus(), 3, true);
  check_nearest(seven_vertex_torus(), 8, false);
  check_nearest(plate_with_windows(3, 2), 5, true);
  check_nearest(many_tetrahedra(5), 19, true);
  check_nearest(many_tetrahedra(5), 21, false);
  check_nearest(with_holes(triangle_sphere(4), 20), 20, true);
  check_nearest(joined(torus(8, 8), grid(6, 6)), 4, true);
}

BOOST_AUTO_TEST_CASE(densities_out_of_range)
{
  const Mesh mesh = some_mesh();
  const auto with = [&](double x, const std::vector<std::string>& parts) {
    const auto densities = boost::make_function_property_map<Mesh::Face_index, double>(
      [x](Mesh::Face_index f) { return std::size_t(f) == 17 ? x : 1.; });
    expect<SMC::Invalid_input>(
      [&](Mesh& output) { SMC::coarsen_mesh(mesh, 20, output, SMC::parameters::face_density_map(densities)); }, parts);
  };
  with(0, {"face 17", " is 0,"});
  with(-1, {"face 17", " is -1,"});
  with(not_a_number, {"face 17", "nan"});
  with(infinity, {"face 17", "inf"});
  with(1e300, {"face 17"});
  with(1e-300, {"face 17"});
}

BOOST_AUTO_TEST_CASE(parameters_out_of_range)
{
  const Mesh mesh = some_mesh();
  const auto densities = get(CGAL::dynamic_face_property_t<double>(), mesh);
  for (const double r : {0., 0.5, -3., infinity, not_a_number, 1e21}) {
    expect<SMC::Invalid_input>(
      [&](Mesh& output) { SMC::coarsen_mesh(mesh, 20, output, SMC::parameters::maximum_density(r)); },
      {"maximum density"});
    expect<SMC::Invalid_input>(
      [&](Mesh&) { SMC::compute_face_densities(mesh, densities, SMC::parameters::maximum_density(r)); },
      {"maximum density"});
  }
  for (const double p : {0., 0.9, -1., infinity, not_a_number})
    expect<SMC::Invalid_input>([&](Mesh&) { SMC::Maximum_density_weight weight(p); }, {"exponent"});
  // The ranges are closed.
  Mesh output;
  SMC::coarsen_mesh(mesh, 20, output, SMC::parameters::maximum_density(1.));
  SMC::coarsen_mesh(mesh, 20, output, SMC::parameters::maximum_density(1e20));
  SMC::coarsen_mesh(mesh, 20, output, SMC::parameters::cluster_weight(SMC::Maximum_density_weight(1)));
  SMC::coarsen_mesh(mesh, output, SMC::parameters::neighborhood_level(std::size_t(-1)));
  BOOST_CHECK_EQUAL(output.number_of_vertices(), 4u);
}

BOOST_AUTO_TEST_CASE(labels_to_start_from)
{
  const Mesh mesh = some_mesh();
  const auto good = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  Mesh unused;
  SMC::coarsen_mesh(mesh, 20, unused, SMC::parameters::face_cluster_map(good).number_of_iterations(0));
  const Labels labels = test::labels_of(mesh, good);
  const auto with = [&](const Labels& start, const std::vector<std::string>& parts) {
    const auto map = boost::make_function_property_map<Mesh::Face_index>([&](Mesh::Face_index f) { return start[f]; });
    expect<SMC::Invalid_input>([&](Mesh&) { SMC::Mwcvd_clustering<Mesh>(mesh).set_clusters(map); }, parts);
  };
  Labels bad = labels;
  bad[5] = std::size_t(-1);
  with(bad, {"face 5", std::to_string(std::size_t(-1))});
  bad = labels;
  for (std::size_t& x : bad)
    x += x == 7 ? 100 : 0; // a gap
  with(bad, {"cluster 7"});
  bad = labels;
  for (std::size_t& x : bad)
    x = x == 7 ? 8 : x;
  with(bad, {"cluster "});
  bad = labels; // a face far from its cluster
  const auto far = std::find_if(labels.rbegin(), labels.rend(), [&](std::size_t x) { return x != labels[0]; });
  bad[0] = *far;
  with(bad, {"cluster "});
  with(Labels(labels.size(), 0), {"cluster 0"});
}

// Steps in the wrong order.
BOOST_AUTO_TEST_CASE(order_of_steps)
{
  const Mesh mesh = some_mesh();
  SMC::Mwcvd_clustering<Mesh> c(mesh);
  Mesh output;
  BOOST_CHECK_THROW(c.grow(), std::logic_error);
  BOOST_CHECK_THROW(c.minimize(), std::logic_error);
  BOOST_CHECK_THROW(c.minimize_round(), std::logic_error);
  BOOST_CHECK_THROW(c.energy(), std::logic_error);
  BOOST_CHECK_THROW(c.cluster(*faces(mesh).begin()), std::logic_error);
  BOOST_CHECK_THROW(c.extract_dual_mesh(output), std::logic_error);
  c.seed(20);
  BOOST_CHECK_THROW(c.minimize(), std::logic_error);
  // The object remains usable after a refused number and refused labels.
  BOOST_CHECK_THROW(c.seed(1), SMC::Unreachable_number_of_vertices);
  BOOST_CHECK_THROW(c.seed(100000), SMC::Unreachable_number_of_vertices);
  const auto zero = boost::make_function_property_map<Mesh::Face_index, int>([](Mesh::Face_index) { return 0; });
  BOOST_CHECK_THROW(c.set_clusters(zero), SMC::Invalid_input);
  c.seed(30);
  c.grow();
  c.minimize();
  c.extract_dual_mesh(output);
  BOOST_CHECK_EQUAL(output.number_of_vertices(), 30u);
  // The same object again, with the result of a new one.
  const Labels first = test::labels_in(c, mesh);
  c.seed(12);
  c.grow();
  c.minimize();
  BOOST_CHECK_EQUAL(c.number_of_clusters(), 12u);
  c.seed(30);
  c.grow();
  c.minimize();
  BOOST_CHECK(test::labels_in(c, mesh) == first);
}

BOOST_AUTO_TEST_SUITE_END()
