// SPDX-License-Identifier: GPL-3.0-or-later
//
// Difficult surfaces at numbers of vertices from the smallest possible to all: for every weight, the output is a
// 2-manifold of the topology of the input with exactly that number of vertices, or the number is refused with the
// nearest attainable one.

#include "support/face_graphs.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/vertex_number_range.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_topology)

namespace SMC = CGAL::Surface_mesh_coarsening;
using generated::Soup;
using reference::Reference_mesh;
using reference::Topology;
using test::Mesh;

namespace {

// Characteristic and loops of each component, sorted.
std::vector<std::pair<long, std::size_t> > kinds(const std::vector<Topology>& topologies)
{
  std::vector<std::pair<long, std::size_t> > list;
  for (const Topology& t : topologies)
    list.emplace_back(t.characteristic(), t.loops);
  std::sort(list.begin(), list.end());
  return list;
}

void check_output(const Reference_mesh& input, const Mesh& output, std::size_t n, const std::string& what)
{
  const Soup soup = test::to_soup(output);
  const reference::Triangle_surface surface(test::triangles_of(soup), soup.points.size());
  BOOST_CHECK_MESSAGE(soup.points.size() == n, what << ": " << soup.points.size() << " vertices");
  BOOST_CHECK_MESSAGE(surface.fault().empty(), what << ": " << surface.fault());
  BOOST_CHECK_MESSAGE(kinds(surface.topologies()) == kinds(input.topologies()), what << ": another topology");
  bool finite = true;
  for (const generated::Point& p : soup.points)
    finite = finite && std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  BOOST_CHECK_MESSAGE(finite, what << ": a coordinate is not finite");
}

// The fit exchanges vertices, and clusters follow; that takes time, and one weight with it is enough.
template <class Weight>
auto parameters()
{
  typedef std::conditional_t<std::is_same<Weight, SMC::Weighted_area_weight>::value, SMC::Fitted_placement,
                             SMC::Centroid_placement>
    Placement;
  return SMC::parameters::cluster_weight(Weight()).vertex_placement(Placement());
}

template <class Weight>
void check_number(const Mesh& mesh, const Reference_mesh& m, std::size_t n, const std::string& what)
{
  const std::string name = what + ", " + std::to_string(n) + " vertices, " + typeid(Weight).name();
  Mesh output;
  try {
    const auto report = SMC::coarsen_mesh(mesh, n, output, parameters<Weight>());
    check_output(m, output, n, name);
    BOOST_CHECK_MESSAGE(report.clusters == n, name << ": the report says " << report.clusters);
    BOOST_CHECK_MESSAGE(report.final_energy <= report.initial_energy * (1 + 1e-12), name << ": the energy has risen");
    BOOST_CHECK_MESSAGE(report.converged, name << ": not converged after " << report.rounds << " rounds");
  } catch (const std::exception& e) {
    BOOST_ERROR(name << ": " << e.what());
  }
}

std::size_t vertices_in_use(const Reference_mesh& m)
{
  std::size_t n = 0;
  for (const Topology& t : m.topologies())
    n += t.vertices;
  return n;
}

// Returns the smallest number that works, from the exception for 0. One less is refused with the same number.
std::size_t smallest_number(const Mesh& mesh, const std::string& what)
{
  Mesh output;
  std::size_t nearest = 0;
  try {
    SMC::coarsen_mesh(mesh, 0, output);
    BOOST_ERROR(what << ": 0 vertices are not refused");
  } catch (const SMC::Unreachable_number_of_vertices& e) {
    nearest = e.nearest();
  }
  BOOST_CHECK_EQUAL(SMC::vertex_number_range(mesh).least, nearest);
  BOOST_REQUIRE_GT(nearest, 0u);
  try {
    SMC::coarsen_mesh(mesh, nearest - 1, output);
    BOOST_ERROR(what << ": " << nearest - 1 << " vertices are not refused");
  } catch (const SMC::Unreachable_number_of_vertices& e) {
    BOOST_CHECK_EQUAL(e.nearest(), nearest);
  }
  BOOST_CHECK(output.is_empty());
  return nearest;
}

// All numbers from the smallest one on work, and no smaller one.
void check_range_of_subdivided(const Soup& soup)
{
  const Mesh mesh = test::to_mesh(soup);
  const auto np = SMC::parameters::subdivide_input(true);
  const std::size_t least = SMC::vertex_number_range(mesh, np).least;
  for (std::size_t n = 1; n < least + 4; ++n) {
    Mesh output;
    bool works = true;
    try {
      SMC::coarsen_mesh(mesh, n, output, np);
    } catch (const SMC::Unreachable_number_of_vertices&) {
      works = false;
    }
    BOOST_CHECK_MESSAGE(works == (n >= least), n << " vertices, where " << least << " is the smallest number");
  }
}

// `expected_minimum`: the smallest number that the topology allows, if the method is known to reach it.
void check_surface(const std::string& what, const Soup& soup, std::size_t expected_minimum = 0)
{
  BOOST_TEST_CONTEXT(what)
  {
    const Mesh mesh = test::to_mesh(soup);
    const Reference_mesh m(test::to_soup(mesh));
    const std::size_t vertices = vertices_in_use(m), least = smallest_number(mesh, what);
    if (expected_minimum != 0)
      BOOST_CHECK_EQUAL(least, expected_minimum);
    const std::size_t most = (std::max)(least, vertices);
    BOOST_CHECK_EQUAL(SMC::vertex_number_range(mesh).most, most);
    std::set<std::size_t> numbers{least, most};
    for (const double part : {0.01, 0.05, 0.2, 0.5})
      numbers.insert((std::max)(least, std::size_t(std::ceil(part * double(vertices)))));
    for (const std::size_t n : numbers) {
      check_number<SMC::Uniform_weight>(mesh, m, n, what);
      check_number<SMC::Weighted_area_weight>(mesh, m, n, what);
      check_number<SMC::Maximum_density_weight>(mesh, m, n, what);
      check_number<SMC::Density_variance_weight>(mesh, m, n, what);
    }
    Mesh output;
    try {
      SMC::coarsen_mesh(mesh, most + 1, output);
      BOOST_ERROR(most + 1 << " vertices are not refused");
    } catch (const SMC::Unreachable_number_of_vertices& e) {
      BOOST_CHECK_EQUAL(e.nearest(), most);
    }
    BOOST_CHECK(output.is_empty());
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(spheres)
{
  using namespace generated;
  check_surface("tetrahedron", tetrahedron(), 4);
  check_surface("octahedron", octahedron(), 4);
  check_surface("cube", cube_grid(1), 4);
  check_surface("cube of quadrilaterals", cube_grid(8), 4);
  check_surface("sphere", with_noise(triangle_sphere(4), 0.02), 4);
  check_surface("polygons", dual(triangle_sphere(3)), 4);
  check_surface("valence 1000", bipyramid(1000), 4);
  check_surface("needles", needles(30, 12), 4);
  check_surface("needles by scaling", scaled(with_noise(triangle_sphere(3), 0.02), 1e-9, 1, 1e6), 4);
}

BOOST_AUTO_TEST_CASE(no_area)
{
  using namespace generated;
  check_surface("a line", scaled(triangle_sphere(3), 1, 0, 0), 4);
  check_surface("a point", scaled(triangle_sphere(3), 0), 4);
  check_surface("a flat sphere", scaled(triangle_sphere(3), 1, 1, 0), 4);
  Soup half = triangle_sphere(3); // one half is a point
  for (Point& p : half.points)
    if (p[2] < 0)
      p = {0, 0, -1};
  check_surface("half a point", half, 4);
}

BOOST_AUTO_TEST_CASE(components)
{
  using namespace generated;
  check_surface("two tetrahedra", many_tetrahedra(2), 8);
  check_surface("2000 tetrahedra", many_tetrahedra(2000), 8000);
  check_surface("a small component",
                joined(with_noise(triangle_sphere(4), 0.02), translated(scaled(triangle_sphere(3), 1e-6), 3, 0, 0)), 8);
  check_surface("components without area",
                joined(with_noise(triangle_sphere(3), 0.02), joined(scaled(triangle_sphere(2), 0), tetrahedron())), 12);
  check_surface("of all kinds", joined(joined(triangulated(torus(12, 8)), grid(8, 8)), joined(tube(12, 4), tetrahedron())));
}

BOOST_AUTO_TEST_CASE(handles)
{
  using namespace generated;
  check_surface("seven vertex torus", seven_vertex_torus(), 7);
  check_surface("thin torus", torus(3, 3));
  check_surface("torus", triangulated(torus(30, 20)));
  check_surface("torus of quadrilaterals", torus(25, 16));
  check_surface("genus 2", plate_with_windows(2, 3));
  check_surface("genus 50", plate_with_windows(50));
  check_surface("genus 50 of triangles", triangulated(plate_with_windows(50, 2)));
}

BOOST_AUTO_TEST_CASE(borders)
{
  using namespace generated;
  check_surface("one triangle", single_triangle(), 3);
  check_surface("one square", grid(1, 1), 3);
  check_surface("square", grid(15, 15), 3);
  check_surface("strip", triangulated(grid(200, 1)), 3);
  check_surface("strip of squares", grid(100, 1), 3);
  check_surface("fan of valence 1000", fan(1000), 3);
  check_surface("short ring", triangulated(tube(3, 1)), 6);
  check_surface("ring one face wide", triangulated(tube(200, 1)), 6);
  check_surface("ring of quadrilaterals", tube(100, 1), 6);
  check_surface("tube", with_noise(triangulated(tube(20, 20)), 0.02), 6);
  check_surface("torus with holes", with_holes(triangulated(torus(30, 20)), 10));
  check_surface("genus 5 with holes", with_holes(triangulated(plate_with_windows(5, 3)), 7));
}

BOOST_AUTO_TEST_CASE(ranges_of_subdivided_meshes)
{
  const Soup torus = generated::torus(3, 3);
  for (const std::vector<std::size_t>& faces :
       std::vector<std::vector<std::size_t> >{{0, 1, 2, 3, 6}, {1, 2, 5, 6, 7, 8}, {0, 1, 2, 3, 5, 6, 8}, {4}}) {
    Soup part = torus;
    part.polygons.clear();
    for (const std::size_t f : faces)
      part.polygons.push_back(torus.polygons[f]);
    check_range_of_subdivided(generated::without_isolated_vertices(part));
  }
}

BOOST_AUTO_TEST_CASE(a_thousand_holes)
{
  const Soup s = generated::with_holes(generated::triangle_sphere(6), 1000);
  const Reference_mesh m(s);
  BOOST_REQUIRE_EQUAL(m.topologies().front().loops, 1000u);
  check_surface("sphere with 1000 holes", s);
}

// A strip with one twist has no orientation: its soup cannot become a mesh without a cut.
BOOST_AUTO_TEST_CASE(moebius_strip)
{
  const Soup s = generated::moebius_strip(20);
  BOOST_CHECK(!CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(s.polygons));
  std::vector<test::Point> points;
  for (const generated::Point& p : s.points)
    points.push_back(test::Point(p[0], p[1], p[2]));
  std::vector<generated::Polygon> polygons = s.polygons;
  BOOST_CHECK(!CGAL::Polygon_mesh_processing::orient_polygon_soup(points, polygons)); // vertices were doubled
  Mesh mesh, output;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  const Reference_mesh m(test::to_soup(mesh)); // a strip like any other
  BOOST_CHECK_EQUAL(m.topologies().front().characteristic(), 1);
  SMC::coarsen_mesh(mesh, 10, output);
  check_output(m, output, 10, "a strip cut open");
}

BOOST_AUTO_TEST_SUITE_END()
