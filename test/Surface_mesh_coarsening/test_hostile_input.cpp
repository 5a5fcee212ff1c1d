// SPDX-License-Identifier: GPL-3.0-or-later
//
// The manual's promises for degenerate, extreme or invalid input, and for failures during the call: a result, or an error
// with input and output unchanged.

#include "support/face_graphs.h"

#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <new>
#include <string>

namespace SMC = CGAL::Surface_mesh_coarsening;
using generated::Soup;
using test::Mesh;

// ---- memory that runs out ----

namespace memory {

std::size_t blocks = 0;      // that are in use
std::size_t left = 0;        // number of the failing allocation; 0: none fails
std::size_t allocations = 0; // since the last call of `let_fail()`

void let_fail(std::size_t nth)
{
  left = nth;
  allocations = 0;
}

void* take(std::size_t size)
{
  ++allocations;
  if (left != 0 && --left == 0)
    throw std::bad_alloc();
  void* const p = std::malloc(size ? size : 1);
  if (!p)
    throw std::bad_alloc();
  ++blocks;
  return p;
}

void give(void* p)
{
  if (!p)
    return;
  --blocks;
  std::free(p);
}

} // namespace memory

void* operator new(std::size_t size) { return memory::take(size); }
void* operator new[](std::size_t size) { return memory::take(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  try {
    return memory::take(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* p, const std::nothrow_t&) noexcept { memory::give(p); }
void operator delete(void* p) noexcept { memory::give(p); }
void operator delete[](void* p) noexcept { memory::give(p); }
void operator delete(void* p, std::size_t) noexcept { memory::give(p); }
void operator delete[](void* p, std::size_t) noexcept { memory::give(p); }

BOOST_AUTO_TEST_SUITE(test_hostile_input)

namespace {

bool equal(const Soup& a, const Soup& b)
{
  // Compares bits: coordinates may be NaN.
  const auto same = [](const generated::Point& p, const generated::Point& q) {
    return std::memcmp(&p, &q, sizeof p) == 0;
  };
  return a.polygons == b.polygons && std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(), same);
}

Soup other_surface() { return generated::joined(generated::tetrahedron(), generated::grid(3, 2)); }

// Returns whether the two are equal and valid.
void check_unchanged(const Mesh& mesh, const Soup& soup)
{
  BOOST_CHECK(equal(test::to_soup(mesh), soup));
  BOOST_CHECK(mesh.is_valid(false));
}

void check_surface(const Mesh& input, const Mesh& output, std::size_t number)
{
  BOOST_CHECK_EQUAL(output.number_of_vertices(), number);
  BOOST_CHECK(output.is_valid(false));
  BOOST_CHECK(CGAL::is_triangle_mesh(output));
  const reference::Reference_mesh a(test::to_soup(input)), b(test::to_soup(output));
  BOOST_REQUIRE_EQUAL(a.topologies().size(), b.topologies().size());
  if (a.topologies().size() == 1)
    BOOST_CHECK(a.topologies()[0].same_surface_as(b.topologies()[0]));
}

// All results have to be as for a mesh without faults.
SMC::Coarsening_report check_coarsened(const Mesh& mesh, std::size_t number, bool finite = true, std::size_t rounds = 1000)
{
  const Soup soup = test::to_soup(mesh);
  Mesh output = test::to_mesh(other_surface());
  const SMC::Coarsening_report report = SMC::coarsen_mesh(mesh, number, output, SMC::parameters::number_of_iterations(rounds));
  check_surface(mesh, output, number);
  BOOST_CHECK(std::isfinite(report.final_energy) || !finite);
  for (const auto v : output.vertices())
    for (int i = 0; i < 3; ++i)
      BOOST_CHECK(std::isfinite(output.point(v)[i]));
  check_unchanged(mesh, soup);
  return report;
}

void check_coarsened(const Soup& soup, std::size_t number, bool finite = true)
{
  BOOST_CHECK(check_coarsened(test::to_mesh(soup), number, finite).converged);
}

Soup squashed(const Soup& s, double x, double y, double z) { return generated::scaled(s, x, y, z); }

Soup sphere() { return generated::triangle_sphere(3); }

} // namespace

// ---- meshes ----

BOOST_AUTO_TEST_CASE(one_face)
{
  check_coarsened(generated::single_triangle(), 3);
  const Mesh mesh = test::to_mesh(generated::grid(1, 1));
  Mesh output;
  SMC::coarsen_mesh(mesh, 4, output);
  check_surface(mesh, output, 4);
  SMC::coarsen_mesh(mesh, 3, output);
  check_surface(mesh, output, 3);
}

BOOST_AUTO_TEST_CASE(isolated_vertices)
{
  Soup soup = sphere();
  soup.points.insert(soup.points.begin(), {5, 5, 5});
  soup.points.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0}); // belongs to no surface
  for (auto& polygon : soup.polygons)
    for (std::size_t& v : polygon)
      ++v;
  Mesh mesh;
  for (const auto& p : soup.points)
    mesh.add_vertex(test::Point(p[0], p[1], p[2]));
  for (const auto& f : soup.polygons)
    mesh.add_face(Mesh::Vertex_index(f[0]), Mesh::Vertex_index(f[1]), Mesh::Vertex_index(f[2]));
  Mesh output;
  SMC::coarsen_mesh(mesh, 40, output);
  BOOST_CHECK_EQUAL(output.number_of_vertices(), 40u);
  Mesh expected;
  SMC::coarsen_mesh(test::to_mesh(sphere()), 40, expected);
  BOOST_CHECK(equal(test::to_soup(output), test::to_soup(expected)));
}

// A hole between two edges with the same ends, which a face graph can have and a list of polygons cannot, is a border loop.
BOOST_AUTO_TEST_CASE(border_of_two_edges)
{
  Mesh mesh = test::to_mesh(sphere());
  const Mesh::Halfedge_index o(20), added = mesh.add_edge(mesh.source(o), mesh.target(o)), beside = mesh.opposite(added);
  mesh.set_next(mesh.prev(o), added); // replaces `o`
  mesh.set_next(added, mesh.next(o));
  mesh.set_face(added, mesh.face(o));
  mesh.set_halfedge(mesh.face(o), added);
  mesh.set_next(o, beside);
  mesh.set_next(beside, o);
  for (const auto h : {o, beside}) {
    mesh.set_face(h, Mesh::null_face());
    mesh.set_halfedge(mesh.target(h), h);
  }
  BOOST_REQUIRE(mesh.is_valid(false));
  for (const std::size_t number : {3, 20}) {
    Mesh output;
    SMC::coarsen_mesh(mesh, number, output);
    BOOST_CHECK_EQUAL(output.number_of_vertices(), number);
    const reference::Reference_mesh m(test::to_soup(output));
    BOOST_REQUIRE_EQUAL(m.topologies().size(), 1u);
    BOOST_CHECK_EQUAL(m.topologies()[0].loops, 1u);
    BOOST_CHECK_EQUAL(m.topologies()[0].characteristic(), 1);
  }
}

// With removed elements among the others, in the input and in the output.
BOOST_AUTO_TEST_CASE(garbage)
{
  Mesh mesh = test::to_mesh(sphere());
  for (std::size_t i = 0; i < 5; ++i)
    CGAL::Euler::remove_center_vertex(halfedge(Mesh::Vertex_index(7 + 40 * i), mesh), mesh);
  BOOST_REQUIRE(mesh.has_garbage());
  Mesh clean = mesh;
  const Soup soup = test::to_soup(mesh);
  Mesh output = mesh, expected;
  const auto kept = output.add_property_map<Mesh::Vertex_index, int>("v:kept", 7).first;
  SMC::coarsen_mesh(mesh, 60, output);
  check_surface(mesh, output, 60);
  BOOST_CHECK(!output.has_garbage());
  BOOST_CHECK_EQUAL(kept[Mesh::Vertex_index(59)], 7);
  BOOST_CHECK(mesh.has_garbage());
  check_unchanged(mesh, soup);
  SMC::coarsen_mesh(test::to_mesh(soup), 60, expected);
  BOOST_CHECK(equal(test::to_soup(output), test::to_soup(expected)));
}

BOOST_AUTO_TEST_CASE(degenerate_geometry)
{
  const double tiny = std::numeric_limits<double>::denorm_min();
  check_coarsened(squashed(sphere(), 1, 1, 0), 40); // a sphere pressed flat
  // All points on a line: no face has an area except by rounding. There is nothing to repair.
  for (const Soup& line : {squashed(sphere(), 1, 0, 0), generated::with_points(sphere(), [](const generated::Point& p) {
         return generated::Point{p[0], 0.3 * p[0], 0.7 * p[0]};
       })})
    BOOST_CHECK_EQUAL(check_coarsened(test::to_mesh(line), 40).reversals_found, 0u);
  check_coarsened(squashed(sphere(), 0, 0, 0), 40); // all points are one
  check_coarsened(squashed(generated::triangulated(generated::torus(20, 12)), 0, 0, 0), 30);
  check_coarsened(squashed(generated::grid(9, 9), 0, 0, 0), 20);
  check_coarsened(squashed(sphere(), tiny, tiny, tiny), 40);
  check_coarsened(generated::with_points(sphere(), [](const generated::Point& p) {
    return p[2] > 0 ? generated::Point{0, 0, 1} : p; // half of the faces are points
  }), 40);
  check_coarsened(generated::with_points(sphere(), [](const generated::Point& p) {
    return generated::Point{std::round(2 * p[0]), std::round(2 * p[1]), std::round(2 * p[2])}; // points coincide
  }), 40);
  check_coarsened(generated::needles(40, 12), 40);
}

BOOST_AUTO_TEST_CASE(extreme_coordinates)
{
  const double largest = (std::numeric_limits<double>::max)();
  for (const double factor : {1e-320, 1e-310, 1e-300, 1e-160, 1e-40, 1e40, 1e160, 1e300, largest / 2})
    check_coarsened(generated::scaled(sphere(), factor), 40, false);
  // One far away from all others.
  Soup soup = sphere();
  soup.points[17] = {1e300, -1e300, 1e300};
  check_coarsened(soup, 40, false);
  // Relative to it, squares of areas are tiny, denormalized or zero.
  for (int exponent = 66; exponent < 110; ++exponent) {
    Soup grid = generated::with_noise(generated::grid(4, 2), 0.3, 5);
    grid.points[7][1] = std::pow(10., exponent);
    check_coarsened(grid, 10, false);
  }
  soup.points[18] = {-largest, largest, -largest};
  check_coarsened(soup, 40, false);
  check_coarsened(generated::translated(sphere(), 1e15, 0, 0), 40);
  check_coarsened(generated::translated(sphere(), 1e300, 0, 0), 40);
}

// Vertices that a placement cannot place.
BOOST_AUTO_TEST_CASE(positions_that_are_not_finite)
{
  Soup soup = generated::triangle_sphere(2);
  const auto check = [&](const auto& placement) {
    const Mesh mesh = test::to_mesh(soup);
    Mesh output;
    SMC::coarsen_mesh(mesh, 20, output, SMC::parameters::vertex_placement(placement));
    check_surface(mesh, output, 20);
    for (const auto v : output.vertices())
      for (int i = 0; i < 3; ++i)
        BOOST_CHECK(std::isfinite(output.point(v)[i]));
  };
  check([](const SMC::Clustered_surface&, std::size_t x) {
    const double nowhere = x % 2 ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity();
    return SMC::Clustered_surface::Point_3(0, nowhere, 0);
  });
  for (const double size : {1e300, 1.7e308}) {
    soup = generated::scaled(generated::triangle_sphere(2), size);
    soup.points[3] = {0, 0, 0};
    check(SMC::Quadric_placement());
    check(SMC::Fitted_placement());
  }
}

namespace {

Soup disc(std::size_t n)
{
  Soup soup;
  soup.polygons.resize(1);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * double(i) / double(n);
    soup.points.push_back({std::cos(angle), std::sin(angle), 0});
    soup.polygons[0].push_back(i);
  }
  return soup;
}

// Cuts a face into triangles around a new vertex. Triangle by triangle, that would take quadratic time.
void add_center(Mesh& mesh, Mesh::Halfedge_index h, double z)
{
  mesh.point(mesh.target(CGAL::Euler::add_center_vertex(h, mesh))) = test::Point(0, 0, z);
}

// A face of `n` sides. CGAL's functions for soups of polygons take quadratic time for it.
Mesh disc_mesh(std::size_t n)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> corners;
  for (const generated::Point& p : disc(n).points)
    corners.push_back(mesh.add_vertex(test::Point(p[0], p[1], p[2])));
  CGAL::Euler::add_face(corners, mesh);
  return mesh;
}

Mesh fan(std::size_t n)
{
  Mesh mesh = disc_mesh(n);
  add_center(mesh, mesh.halfedge(Mesh::Face_index(0)), 0.5);
  return mesh;
}

// A fan with a face, or another fan, on its other side.
Mesh cone(std::size_t n, bool is_double)
{
  Mesh mesh = disc_mesh(n);
  const Mesh::Halfedge_index h = mesh.halfedge(Mesh::Face_index(0)), o = mesh.opposite(h);
  CGAL::Euler::fill_hole(o, mesh);
  add_center(mesh, h, 1);
  if (is_double)
    add_center(mesh, o, -1);
  return mesh;
}

// A face of `n` sides with others around it.
Soup lid(std::size_t n)
{
  Soup soup = generated::tube(n, 3);
  const std::size_t rows = soup.points.size() / n;
  soup.polygons.emplace_back();
  for (std::size_t i = n; i-- > 0;)
    soup.polygons.back().push_back(i * rows);
  return soup;
}

} // namespace

BOOST_AUTO_TEST_CASE(face_of_ten_thousand_sides)
{
  check_coarsened(disc(10000), 3);
  check_coarsened(disc(10000), 100);
  check_coarsened(cone(10000, false), 100, true, 100);
  check_coarsened(test::to_mesh(lid(10000)), 300, true, 100);
}

// Moving face by face, clusters of this many thin triangles need a thousand rounds and more to converge; some rounds
// suffice here.
BOOST_AUTO_TEST_CASE(vertex_of_a_hundred_thousand_faces)
{
  check_coarsened(fan(100000), 1000, true, 50);
  check_coarsened(cone(100000, true), 1000, true, 50);
}

// ---- parameters ----

BOOST_AUTO_TEST_CASE(densities_of_every_size)
{
  const Mesh mesh = test::to_mesh(generated::triangle_sphere(4));
  for (const double range : {1e12, 1e20}) {
    const auto densities = boost::make_function_property_map<Mesh::Face_index, double>([range](Mesh::Face_index f) {
      return std::pow(range, double((std::size_t(f) * 7919) % 1000) / 999 - 0.5); // from face to face at random
    });
    Mesh output;
    const auto report = SMC::coarsen_mesh(mesh, 60, output, SMC::parameters::face_density_map(densities));
    check_surface(mesh, output, 60);
    BOOST_CHECK(report.converged);
    BOOST_CHECK(report.final_energy <= report.initial_energy);
  }
}

BOOST_AUTO_TEST_CASE(bounded_work)
{
  const Mesh mesh = test::to_mesh(generated::with_noise(generated::triangle_sphere(4), 0.01));
  Mesh output;
  const auto two = SMC::coarsen_mesh(mesh, 60, output, SMC::parameters::number_of_iterations(2));
  BOOST_CHECK_EQUAL(two.rounds, 2u);
  const auto report = SMC::coarsen_mesh(mesh, 60, output);
  BOOST_CHECK(report.rounds <= SMC::Coarsening_defaults::number_of_iterations);
}

// ---- failures during the call ----

namespace {

struct Thrown
{};

// Runs `f` on an output; it has to throw a `Thrown`.
template <class Function>
void check_thrown(const Function& f)
{
  Mesh output = test::to_mesh(other_surface());
  BOOST_CHECK_THROW(f(output), Thrown);
  check_unchanged(output, other_surface());
}

// Throws at its `n`-th call.
struct Countdown
{
  std::size_t n;
  void operator()()
  {
    if (n-- == 0)
      throw Thrown();
  }
};

struct Throwing_visitor : SMC::Coarsening_visitor_base
{
  Countdown countdown;
  explicit Throwing_visitor(std::size_t n) : countdown{n} {}
  void stage_begins(SMC::Coarsening_stage) { countdown(); }
  void stage_ends(SMC::Coarsening_stage) { countdown(); }
  void round_done(std::size_t, std::size_t, double) { countdown(); }
  bool go_further()
  {
    countdown();
    return true;
  }
};

// A map from faces or vertices that throws for one of them.
template <class Key, class Value>
struct Throwing_map
{
  typedef Key key_type;
  typedef Value value_type;
  typedef Value reference;
  typedef boost::read_write_property_map_tag category;

  std::size_t at;
  Value value;

  friend Value get(const Throwing_map& map, const Key& key)
  {
    if (std::size_t(key) == map.at)
      throw Thrown();
    return map.value;
  }
  friend void put(const Throwing_map& map, const Key& key, const Value&) { get(map, key); }
};

} // namespace

BOOST_AUTO_TEST_CASE(visitors_that_throw)
{
  const Soup soup = generated::triangle_sphere(2);
  const Mesh mesh = test::to_mesh(soup);
  std::size_t calls = 0;
  for (bool is_done = false; !is_done; ++calls) {
    Mesh output = test::to_mesh(other_surface());
    Throwing_visitor visitor(calls);
    try {
      SMC::coarsen_mesh(mesh, 20, output, SMC::parameters::visitor(std::ref(visitor)));
      is_done = true;
      BOOST_CHECK_EQUAL(output.number_of_vertices(), 20u);
    } catch (const Thrown&) {
      check_unchanged(output, other_surface());
    }
    check_unchanged(mesh, soup);
  }
  BOOST_CHECK(calls > 15); // at least two per stage, and the requests to continue
}

BOOST_AUTO_TEST_CASE(property_maps_that_throw)
{
  const Soup soup = generated::triangle_sphere(2);
  const Mesh mesh = test::to_mesh(soup);
  for (const std::size_t at : {0, 5, 65}) {
    check_thrown([&](Mesh& output) {
      SMC::coarsen_mesh(mesh, 20, output,
                        SMC::parameters::face_density_map(Throwing_map<Mesh::Face_index, double>{at, 1.}));
    });
    check_thrown([&](Mesh& output) {
      SMC::coarsen_mesh(mesh, 20, output,
                        SMC::parameters::face_cluster_map(Throwing_map<Mesh::Face_index, std::size_t>{at, 0}));
    });
    check_thrown([&](Mesh& output) {
      const Throwing_map<Mesh::Vertex_index, std::size_t> map{at, 0};
      SMC::coarsen_mesh(mesh, 20, output, SMC::parameters::vertex_boundary_count_map(map));
    });
    check_thrown([&](Mesh& output) {
      const Throwing_map<Mesh::Vertex_index, test::Point> map{at, test::Point(0, 0, 0)};
      SMC::coarsen_mesh(mesh, 20, output, CGAL::parameters::vertex_point_map(map));
    });
    // The map of the output has only 20 points.
    check_thrown([&](Mesh& output) {
      const Throwing_map<Mesh::Vertex_index, test::Point> map{(std::min)(at, std::size_t(19)), test::Point(0, 0, 0)};
      SMC::coarsen_mesh(mesh, 20, output, CGAL::parameters::default_values(), CGAL::parameters::vertex_point_map(map));
    });
    check_unchanged(mesh, soup);
  }
}

// Each allocation of a call fails once.
BOOST_AUTO_TEST_CASE(allocations_that_fail)
{
  const Soup soup = generated::joined(generated::triangle_sphere(1), generated::translated(generated::grid(3, 3), 9, 0, 0));
  const Soup other = other_surface();
  const Mesh mesh = test::to_mesh(soup);
  Mesh expected;
  SMC::coarsen_mesh(mesh, 15, expected);
  std::size_t failures = 0;
  bool is_done = false;
  for (std::size_t nth = 1; !is_done; nth += 1 + nth / 200) {
    Mesh output = test::to_mesh(other);
    const std::size_t before = memory::blocks;
    bool has_thrown = false;
    memory::let_fail(nth);
    try {
      SMC::coarsen_mesh(mesh, 15, output);
      is_done = memory::left != 0;
    } catch (const std::bad_alloc&) {
      has_thrown = true;
    }
    memory::left = 0;
    failures += has_thrown;
    if (has_thrown) {
      BOOST_CHECK_EQUAL(memory::blocks, before);
      check_unchanged(output, other);
    } else // the standard library can sort without this memory
      BOOST_CHECK(equal(test::to_soup(output), test::to_soup(expected)));
    if (nth % 50 == 0 || is_done)
      check_unchanged(mesh, soup);
  }
  BOOST_CHECK(failures > 100);
}

// A change that fails before it begins keeps the clusters; if it fails later, there are no clusters.
BOOST_AUTO_TEST_CASE(allocations_that_fail_in_steering)
{
  const Mesh mesh = test::to_mesh(generated::triangle_sphere(3));
  const auto labels_of = [&mesh](SMC::Mwcvd_clustering<Mesh>& c) {
    std::vector<std::size_t> labels;
    for (const auto f : mesh.faces())
      labels.push_back(c.cluster(f));
    return labels;
  };
  for (const bool splits : {true, false}) {
    SMC::Mwcvd_clustering<Mesh> clustering(mesh);
    const auto begin = [&clustering] {
      clustering.seed(12);
      clustering.grow();
    };
    const auto edit = [&] { return splits ? clustering.split_cluster(5).has_value() : clustering.remove_cluster(5); };
    begin();
    BOOST_REQUIRE(edit());
    const std::vector<std::size_t> expected = labels_of(clustering);
    begin();
    const std::vector<std::size_t> before = labels_of(clustering);
    std::size_t left_alone = 0, left_none = 0;
    for (std::size_t nth = 1;; ++nth) {
      begin();
      bool has_thrown = false;
      memory::let_fail(nth);
      try {
        edit();
      } catch (const std::bad_alloc&) {
        has_thrown = true;
      }
      memory::left = 0;
      if (!has_thrown) {
        BOOST_CHECK(labels_of(clustering) == expected);
        if (memory::allocations < nth)
          break;
        continue;
      }
      try {
        BOOST_CHECK(labels_of(clustering) == before);
        ++left_alone;
      } catch (const std::logic_error&) {
        ++left_none;
      }
    }
    BOOST_CHECK(left_alone > 0);
    BOOST_CHECK(left_none > 3);
  }
}

BOOST_AUTO_TEST_SUITE_END()
