// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests the common parts of the programs: the check of a soup, the counts of the certificate, the colors of clusters,
// the renderer.

#include "Stowed_halfedges.h"
#include "check/certificate.h"
#include "check/soup_fault.h"
#include "io/read_soup.h"
#include "io/to_mesh.h"
#include "render/Camera.h"
#include "render/Scene.h"
#include "render/cluster_colors.h"
#include "render/render.h"
#include "repair/fill_holes.h"
#include "support/generate_meshes.h"
#include "support/mesh_files.h"

#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_tool_support)

namespace {

using namespace coarsening_support;
namespace PMP = CGAL::Polygon_mesh_processing;

Soup soup_of(const generated::Soup& source)
{
  Soup soup;
  for (const auto& p : source.points)
    soup.points.emplace_back(p[0], p[1], p[2]);
  soup.polygons = Polygons(source.polygons);
  return soup;
}

Mesh mesh_of(const generated::Soup& source) { return to_mesh(soup_of(source)); }

// The same check with CGAL only.
bool is_manifold_for_cgal(const Soup& soup)
{
  const auto polygons = soup.polygons.lists();
  if (!PMP::is_polygon_soup_a_polygon_mesh(polygons))
    return false;
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, polygons, mesh);
  std::vector<Halfedge> cones;
  PMP::non_manifold_vertices(mesh, std::back_inserter(cones));
  return cones.empty();
}

Component_counts only_component(const generated::Soup& source)
{
  const Mesh_components components = mesh_components(mesh_of(source));
  BOOST_REQUIRE(components.counts.size() == 1u);
  return components.counts[0];
}

} // namespace

BOOST_AUTO_TEST_CASE(soup_check_agrees_with_cgal)
{
  std::mt19937 engine(7);
  std::size_t good = 0, bad = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const std::size_t points = 4 + engine() % 4, faces = 1 + engine() % 5;
    Soup soup;
    for (std::size_t i = 0; i < points; ++i)
      soup.points.emplace_back(double(i), double(i * i), 0);
    for (std::size_t f = 0; f < faces; ++f) {
      std::vector<std::size_t> corners(points);
      for (std::size_t i = 0; i < points; ++i)
        corners[i] = i;
      std::shuffle(corners.begin(), corners.end(), engine);
      corners.resize(3 + engine() % 2);
      soup.polygons.push_back(corners);
    }
    const bool expected = is_manifold_for_cgal(soup);
    ++(expected ? good : bad);
    BOOST_TEST_REQUIRE(!soup_fault(soup).has_value() == expected);
  }
  BOOST_TEST(good > 1000u);
  BOOST_TEST(bad > 1000u);
}

BOOST_AUTO_TEST_CASE(soup_check_accepts_manifolds)
{
  for (const generated::Soup& source :
       {generated::tetrahedron(), generated::cube_grid(4), generated::torus(7, 5), generated::seven_vertex_torus(),
        generated::plate_with_windows(3), generated::single_triangle(), generated::grid(3, 5), generated::tube(6, 4),
        generated::fan(9), generated::many_tetrahedra(5), generated::bipyramid(50)})
    BOOST_TEST(!soup_fault(soup_of(source)).has_value());
}

namespace {

void check_same_as_cgal(const generated::Soup& source)
{
  const Soup soup = soup_of(source);
  BOOST_REQUIRE(!soup_fault(soup));
  Mesh expected;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons.lists(), expected);
  const Mesh mesh = to_mesh(soup);
  BOOST_CHECK(mesh.is_valid(false));
  BOOST_CHECK_EQUAL(mesh.number_of_halfedges(), expected.number_of_halfedges());
  std::set<std::vector<std::size_t> > loops, expected_loops; // of faces and borders, each from its smallest vertex on
  const auto loop = [](const Mesh& m, Halfedge h) {
    std::vector<std::size_t> around;
    for (const Halfedge g : m.halfedges_around_face(h))
      around.push_back(m.target(g));
    std::rotate(around.begin(), std::min_element(around.begin(), around.end()), around.end());
    around.push_back(m.is_border(h) ? std::size_t(-1) : std::size_t(m.face(h)));
    return around;
  };
  for (const Halfedge h : mesh.halfedges())
    loops.insert(loop(mesh, h));
  for (const Halfedge h : expected.halfedges())
    expected_loops.insert(loop(expected, h));
  BOOST_CHECK(loops == expected_loops);
  for (const Vertex v : mesh.vertices()) {
    BOOST_CHECK(mesh.point(v) == soup.points[v]);
    BOOST_CHECK_EQUAL(mesh.is_border(v), expected.is_border(v));
    BOOST_CHECK_EQUAL(mesh.is_border(v), mesh.is_border(mesh.halfedge(v)));
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(mesh_of_a_soup)
{
  check_same_as_cgal(generated::single_triangle());
  check_same_as_cgal(generated::joined(generated::torus(7, 5), generated::fan(9)));
  check_same_as_cgal(generated::plate_with_windows(2));
  check_same_as_cgal(generated::with_holes(generated::triangle_sphere(4), 5));
  check_same_as_cgal(generated::partly_triangulated(generated::tube(12, 4)));
}

// With border, several components and an isolated vertex.
BOOST_AUTO_TEST_CASE(stowed_halfedges)
{
  Mesh mesh = mesh_of(generated::cube_grid(3));
  mesh.join(mesh_of(generated::grid(4, 4)));
  mesh.add_vertex(Point(7, 7, 7));
  const Mesh before = mesh;
  {
    coarsen_mesh_tool::Stowed_halfedges stowed(mesh);
    stowed.stow();
    BOOST_TEST(mesh.number_of_halfedges() == 0u);
    BOOST_TEST(mesh.number_of_faces() == before.number_of_faces());
  }
  BOOST_TEST(mesh.is_valid());
  BOOST_TEST(mesh.number_of_halfedges() == before.number_of_halfedges());
  for (const Halfedge h : before.halfedges())
    BOOST_TEST((mesh.next(h) == before.next(h) && mesh.face(h) == before.face(h) && mesh.target(h) == before.target(h)));
}

// In linear time, or nearly: this would take minutes face by face.
BOOST_AUTO_TEST_CASE(mesh_with_hubs)
{
  const Soup soup = soup_of(generated::bipyramid(300000));
  BOOST_REQUIRE(!soup_fault(soup));
  const Mesh mesh = to_mesh(soup);
  BOOST_CHECK(mesh.is_valid(false));
  BOOST_CHECK(CGAL::is_closed(mesh));
}

// In linear time, or nearly, for any fault.
BOOST_AUTO_TEST_CASE(faults_of_large_polygons)
{
  const std::size_t n = 300000;
  Soup soup;
  std::vector<std::size_t> polygon(n);
  std::iota(polygon.begin(), polygon.end(), std::size_t(0));
  for (std::size_t i = 0; i < n; ++i)
    soup.points.emplace_back(std::cos(double(i)), std::sin(double(i)), 0);
  soup.polygons.push_back(polygon);
  BOOST_CHECK(!soup_fault(soup));
  polygon.insert(polygon.end(), polygon.begin(), polygon.end());
  soup.polygons = Polygons();
  soup.polygons.push_back(polygon);
  BOOST_CHECK(soup_fault(soup)->find("face 0 uses vertex 0 at (1, 0, 0) twice") == 0);

  // An unused point need not be finite.
  soup = soup_of(generated::bipyramid(n));
  soup.points.emplace_back(std::numeric_limits<double>::infinity(), 0, 0);
  BOOST_CHECK(!soup_fault(soup));
  BOOST_CHECK_EQUAL(drop_unused_points(soup), 1u);
  BOOST_CHECK(std::isfinite(soup.points.back().x()));
}

BOOST_AUTO_TEST_CASE(reading_can_be_stopped)
{
  struct Stopped
  {};
  const Soup soup = soup_of(generated::triangle_sphere(6));
  std::size_t asked = 0;
  const Stop count = [&asked] { ++asked; };
  std::optional<Edge_pairing> pairing;
  BOOST_CHECK(!soup_fault(soup, pairing, count));
  BOOST_CHECK_GE(asked, 2u);
  asked = 0;
  to_mesh(soup, *pairing, count);
  BOOST_CHECK_GE(asked, 2u);
  for (const auto& form : mesh_files::all_forms(generated::triangle_sphere(6))) {
    asked = 0;
    parse_soup(form.second, form.first, count);
    BOOST_CHECK_GE(asked, 2u);
    BOOST_CHECK_THROW(parse_soup(form.second, form.first, [] { throw Stopped(); }), Stopped);
  }
}

namespace {

// A tube with a wavy upper border: few of its triangulations are among Delaunay tetrahedra.
Mesh jagged_tube(std::size_t edges)
{
  generated::Soup soup = generated::tube(edges, 2);
  std::mt19937 engine(5);
  double top = 0;
  for (const auto& p : soup.points)
    top = (std::max)(top, p[2]);
  for (auto& p : soup.points)
    if (p[2] == top)
      for (double& x : p)
        x += 0.5 * double(engine() % 1000) / 1000;
  return mesh_of(soup);
}

} // namespace

BOOST_AUTO_TEST_CASE(jagged_holes)
{
  for (const std::size_t edges : {40u, 1000u, 3000u}) {
    Mesh mesh = jagged_tube(edges);
    std::size_t asked = 0;
    const auto begin = std::clock();
    const auto filling = coarsen_mesh_tool::fill_holes(mesh, 1e9, [&asked] { ++asked; });
    BOOST_CHECK_LT(double(std::clock() - begin) / CLOCKS_PER_SEC, 6);
    BOOST_CHECK_EQUAL(filling.number(coarsen_mesh_tool::Hole_state::FILLED), 2u);
    BOOST_CHECK_EQUAL(filling.triangles_added, 2 * (edges - 2));
    BOOST_CHECK(CGAL::is_closed(mesh));
    BOOST_CHECK(mesh.is_valid(false));
    BOOST_CHECK(!soup_fault(to_soup(mesh)));
    BOOST_CHECK_GE(asked, 2u);
  }
  struct Stopped
  {};
  Mesh mesh = jagged_tube(1000);
  std::size_t asked = 0;
  BOOST_CHECK_THROW(coarsen_mesh_tool::fill_holes(mesh, 1e9, [&asked] {
    if (++asked == 5)
      throw Stopped();
  }), Stopped);
}

BOOST_AUTO_TEST_CASE(counts)
{
  BOOST_TEST(only_component(generated::cube_grid(3)).genus() == 0);
  BOOST_TEST(only_component(generated::cube_grid(3)).border_loops == 0u);
  BOOST_TEST(only_component(generated::torus(6, 5)).genus() == 1);
  BOOST_TEST(only_component(generated::plate_with_windows(5)).genus() == 5);
  BOOST_TEST(only_component(generated::tube(6, 5)).genus() == 0);
  BOOST_TEST(only_component(generated::tube(6, 5)).border_loops == 2u);
  BOOST_TEST(only_component(generated::grid(4, 5)).border_loops == 1u);
  const Component_counts grid = only_component(generated::grid(4, 5));
  BOOST_TEST(grid.vertices == 30u);
  BOOST_TEST(grid.edges == 49u);
  BOOST_TEST(grid.faces == 20u);
  BOOST_TEST(mesh_components(mesh_of(generated::many_tetrahedra(6))).counts.size() == 6u);
}

// The dual of a mesh, the faces of which are the clusters.
Soup dual_of(const Mesh& mesh)
{
  Soup dual;
  for (Face f : mesh.faces()) {
    const Point& a = mesh.point(mesh.target(mesh.halfedge(f)));
    const Point& b = mesh.point(mesh.target(mesh.next(mesh.next(mesh.halfedge(f)))));
    dual.points.push_back(CGAL::midpoint(a, b));
  }
  for (Vertex v : mesh.vertices()) {
    std::vector<std::size_t> polygon;
    for (Face f : mesh.faces_around_target(mesh.halfedge(v)))
      polygon.insert(polygon.begin(), f);
    dual.polygons.push_back(polygon);
  }
  return dual;
}

// The octahedron is the dual of the cube.
BOOST_AUTO_TEST_CASE(certificate_of_a_dual)
{
  const Mesh cube = mesh_of(generated::cube_grid(1));
  const std::vector<std::size_t> labels{0, 1, 2, 3, 4, 5};
  Soup dual = dual_of(cube);
  const Mesh octahedron = to_mesh(dual);
  BOOST_TEST(!triangle_mesh_fault(octahedron).has_value());
  const Certificate good = certify(cube, labels, octahedron);
  BOOST_TEST(good.kept());

  auto triangles = dual.polygons.lists();
  for (auto& triangle : triangles)
    std::reverse(triangle.begin(), triangle.end());
  dual.polygons = Polygons(triangles);
  const Certificate turned = certify(cube, labels, to_mesh(dual));
  BOOST_TEST(!turned.orientation_kept());
  BOOST_TEST(!turned.kept());

  triangles.pop_back();
  dual.polygons = Polygons(triangles);
  const Certificate open = certify(cube, labels, to_mesh(dual));
  BOOST_TEST(!open.components[0].kept());
  BOOST_TEST(!open.kept());
}

// One of two octahedra is reversed.
BOOST_AUTO_TEST_CASE(certificate_of_a_turned_component)
{
  Mesh cubes = mesh_of(generated::cube_grid(1));
  cubes += mesh_of(generated::cube_grid(1));
  std::vector<std::size_t> labels(12);
  std::iota(labels.begin(), labels.end(), std::size_t(0));
  Soup dual = dual_of(cubes);
  BOOST_TEST(certify(cubes, labels, to_mesh(dual)).kept());

  auto triangles = dual.polygons.lists();
  for (std::size_t i = 8; i < 16; ++i)
    std::reverse(triangles[i].begin(), triangles[i].end());
  dual.polygons = Polygons(triangles);
  BOOST_TEST(!certify(cubes, labels, to_mesh(dual)).orientation_kept());
}

// The result of the library for a mesh with flat faces of many sides, a border and components within each other, as it is, and
// with one component reversed. Flips and exchanges leave few of the triangles between the clusters. Clusters of cells, which divide
// faces, are avoided by the weight.
BOOST_AUTO_TEST_CASE(certificate_of_results_with_flips)
{
  Mesh input = mesh_of(generated::prism(200));
  for (const generated::Soup& s : {generated::grid(12, 12), generated::with_noise(generated::triangle_sphere(3), 0.3),
                                   generated::triangle_sphere(3), generated::torus(12, 8)})
    input += mesh_of(s);
  std::vector<std::size_t> labels(input.number_of_faces());
  const auto cluster =
    boost::make_function_property_map<Face>([&](Face f) -> std::size_t& { return labels[static_cast<std::size_t>(f)]; });
  for (const std::size_t n : {60u, 150u, 300u}) {
    Mesh output;
    namespace SMC = CGAL::Surface_mesh_coarsening;
    SMC::coarsen_mesh(input, n, output, SMC::parameters::face_cluster_map(cluster).cluster_weight(SMC::Uniform_weight()));
    const Certificate good = certify(input, labels, output);
    BOOST_TEST(good.change().value_or("") == "");
    const Mesh_components components = mesh_components(output);
    for (std::size_t c = 0; c < components.counts.size(); ++c) {
      std::vector<Face> faces;
      for (Face f : output.faces())
        if (components.of_face[f] == c)
          faces.push_back(f);
      PMP::reverse_face_orientations(faces, output);
      const Certificate turned = certify(input, labels, output);
      BOOST_TEST(turned.change().value_or("").find("is reversed") != std::string::npos);
      PMP::reverse_face_orientations(faces, output);
    }
  }
}

BOOST_AUTO_TEST_CASE(certificate_of_joined_and_lost_components)
{
  const Mesh two = mesh_of(generated::many_tetrahedra(2)), one = mesh_of(generated::many_tetrahedra(1));
  const std::vector<std::size_t> labels = {0, 1, 2, 3, 4, 5, 6, 7};
  BOOST_TEST(certify(two, labels, two).one_to_one);
  BOOST_TEST(!certify(two, {0, 1, 2, 3, 4, 5, 6, 3}, two).one_to_one); // a label in both components
  const Certificate lost = certify(two, labels, one);
  BOOST_TEST(!lost.components[1].after.has_value());
  BOOST_TEST(!lost.kept());
  BOOST_TEST(!certify(one, {0, 1, 2, 3}, two).one_to_one); // an additional component
}

BOOST_AUTO_TEST_CASE(faults_of_triangle_meshes)
{
  BOOST_TEST(triangle_mesh_fault(mesh_of(generated::cube_grid(2))).has_value());
  Mesh isolated = mesh_of(generated::tetrahedron());
  isolated.add_vertex(Point(5, 5, 5));
  BOOST_TEST(triangle_mesh_fault(isolated).has_value());
  Soup pillow = soup_of(generated::single_triangle());
  pillow.polygons.push_back({2, 1, 0});
  BOOST_TEST(!soup_fault(pillow).has_value()); // a manifold, but not a simplicial one
  BOOST_TEST(triangle_mesh_fault(to_mesh(pillow)).has_value());
}

BOOST_AUTO_TEST_CASE(neighbors_differ_in_color)
{
  const Mesh mesh = mesh_of(generated::triangle_sphere(3));
  std::mt19937 engine(3);
  for (std::size_t clusters : {1u, 2u, 30u, 1000u}) {
    std::vector<std::size_t> labels(mesh.number_of_faces());
    for (std::size_t& label : labels)
      label = engine() % clusters;
    const std::vector<std::size_t> colors = color_clusters(mesh, labels);
    for (const auto& pair : cluster_adjacencies(mesh, labels))
      BOOST_TEST(colors[pair.first] != colors[pair.second]);
  }
  std::set<Rgb> palette;
  for (std::size_t i = 0; i < 40; ++i)
    palette.insert(palette_color(i));
  BOOST_TEST(palette.size() == 40u);
}

BOOST_AUTO_TEST_CASE(rendering)
{
  const Mesh mesh = mesh_of(generated::triangulated(generated::cube_grid(1)));
  const std::vector<Point> points(mesh.points().begin(), mesh.points().end());
  const Camera camera(points, Vector(0, 0, 1), Vector(0, 1, 0), 100);
  const Image image = render(mesh_scene(mesh), camera);
  const Rgb white = {{255, 255, 255}};
  BOOST_TEST(image.width == 100u);
  BOOST_TEST(image.height == 100u);
  BOOST_TEST((image.at(0, 0) == white));
  BOOST_TEST((image.at(50, 40) != white)); // the front, of one color but for the diagonal
  BOOST_TEST((image.at(50, 40) == image.at(40, 30)));
  const auto shown = static_cast<std::size_t>(
    std::count_if(image.pixels.begin(), image.pixels.end(), [&white](const Rgb& c) { return c != white; }));
  BOOST_TEST(shown > 90u * 90u); // a square with margins of 4 pixels, and its outline
  BOOST_TEST(shown < 96u * 96u);

  // The light does not depend on whether the mesh is inside out.
  const Mesh turned = mesh_of(generated::reversed(generated::triangulated(generated::cube_grid(1))));
  BOOST_TEST((render(mesh_scene(turned), camera).at(50, 40) == image.at(50, 40)));
}

BOOST_AUTO_TEST_SUITE_END()
