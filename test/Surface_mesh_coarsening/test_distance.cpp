// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results within a distance: the bound holds, and is at most the requested distance.

#include "support/face_graphs.h"
#include "support/generate_meshes.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Surface_location.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh_to_distance.h>
#include <CGAL/Surface_mesh_coarsening/is_valid_clustering.h>
#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>

#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_distance)

namespace SMC = CGAL::Surface_mesh_coarsening;
using test::Mesh;

BOOST_AUTO_TEST_CASE(bounds_hold)
{
  using namespace generated;
  const auto centroids = SMC::parameters::vertex_placement(SMC::Centroid_placement()); // the bound does not depend on it
  const Soup torus = with_noise(generated::torus(40, 30), 0.01);
  const std::vector<Soup> soups = {triangle_sphere(5), torus, triangulated(torus), with_holes(triangle_sphere(5), 3),
                                   with_noise(triangulated(grid(30, 20)), 0.05)};
  for (const Soup& soup : soups) {
    Mesh mesh = test::to_mesh(soup);
    const auto cluster = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:cluster").first;
    Mesh first;
    const double diagonal = SMC::measure_coarsening(mesh, mesh, 10).diagonal;
    std::size_t last = 0;
    for (const double part : {0.05, 0.02}) {
      Mesh output;
      const SMC::Distance_report report =
        SMC::coarsen_mesh_to_distance(mesh, part * diagonal, output, centroids.face_cluster_map(cluster));
      BOOST_CHECK_EQUAL(report.vertices, output.number_of_vertices());
      BOOST_CHECK(CGAL::is_valid_polygon_mesh(output));
      BOOST_CHECK(SMC::is_valid_clustering(mesh, cluster));
      BOOST_CHECK_LE(report.distance_bound, part * diagonal);
      BOOST_CHECK_LE(SMC::measure_coarsening(mesh, output, 20000).maximum_distance, report.distance_bound);
      BOOST_CHECK_GE(report.vertices, last);
      BOOST_CHECK_LT(report.vertices, mesh.number_of_vertices());
      last = report.vertices;
      for (const auto f : mesh.faces())
        BOOST_REQUIRE_LT(cluster[f], report.vertices);
      Mesh again;
      SMC::coarsen_mesh_to_distance(mesh, part * diagonal, again, centroids);
      BOOST_CHECK(test::to_soup(again).points == test::to_soup(output).points);
    }
  }
}

// Lengths are measured at any scale of double, and coordinates next to zero have triangles with normals next to zero.
BOOST_AUTO_TEST_CASE(distances_at_extreme_scales)
{
  using namespace generated;
  const Soup fine = triangle_sphere(4), coarse = triangle_sphere(2);
  const auto scaled = [](Soup soup, int exponent) {
    for (auto& p : soup.points)
      for (double& x : p)
        x = std::ldexp(x, exponent);
    return test::to_mesh(soup);
  };
  const SMC::Coarsening_quality at_one = SMC::measure_coarsening(scaled(fine, 0), scaled(coarse, 0), 1000);
  BOOST_TEST_REQUIRE(at_one.rms_distance > 0);
  for (const int exponent : {-900, -300, 300, 900}) {
    const SMC::Coarsening_quality q = SMC::measure_coarsening(scaled(fine, exponent), scaled(coarse, exponent), 1000);
    BOOST_TEST(q.rms_distance == std::ldexp(at_one.rms_distance, exponent));
    BOOST_TEST(q.from_coarse.maximum_distance == std::ldexp(at_one.from_coarse.maximum_distance, exponent));
    BOOST_TEST(q.diagonal == std::ldexp(at_one.diagonal, exponent));
    BOOST_TEST(q.maximum_normal_deviation == at_one.maximum_normal_deviation);
  }
  Mesh sliver, other;
  const double least = std::numeric_limits<double>::denorm_min(), small = 1e12 * least;
  CGAL::make_triangle(Mesh::Point(-small, -1, 0), Mesh::Point(0, 0, 0), Mesh::Point(0, -1, 0), sliver);
  CGAL::make_triangle(Mesh::Point(0, 0, 0), Mesh::Point(0, -1, 0), Mesh::Point(1, 0, 1e-5), sliver);
  CGAL::make_triangle(Mesh::Point(0, 0, 0), Mesh::Point(0, -1, 0), Mesh::Point(1, 0, 1e-5), other);
  BOOST_TEST(SMC::measure_coarsening(sliver, other, 1000).maximum_distance < 1e-15);
}

// With exchanges no distance takes more vertices, and some take fewer.
BOOST_AUTO_TEST_CASE(fewer_vertices_with_error_feedback)
{
  Mesh mesh;
  BOOST_REQUIRE(CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/elephant.off"), mesh));
  const auto cluster = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:cluster").first;
  const auto np = SMC::parameters::cluster_weight(SMC::Weighted_area_weight())
                    .vertex_placement(SMC::Fitted_placement())
                    .face_cluster_map(cluster);
  std::size_t all_with = 0, all_without = 0;
  for (const double part : {0.02, 0.03, 0.04}) { // with clusters of faces, not of cells
    const double distance = part * SMC::measure_coarsening(mesh, mesh, 10).diagonal;
    Mesh plain, output;
    const std::size_t without = SMC::coarsen_mesh_to_distance(mesh, distance, plain, np.error_feedback(0)).vertices;
    const SMC::Distance_report report = SMC::coarsen_mesh_to_distance(mesh, distance, output, np);
    BOOST_TEST(report.vertices <= without);
    all_with += report.vertices;
    all_without += without;
    BOOST_TEST(report.vertices == output.number_of_vertices());
    BOOST_TEST(report.vertices == report.clustering.clusters);
    BOOST_TEST(CGAL::is_valid_polygon_mesh(output));
    BOOST_TEST(SMC::is_valid_clustering(mesh, cluster));
    BOOST_TEST(report.distance_bound <= distance);
    BOOST_TEST(SMC::measure_coarsening(mesh, output, 20000).maximum_distance <= report.distance_bound);
  }
  BOOST_TEST(all_with < all_without);
}

// A bound of the distance by CGAL, in both directions and within a thousandth of `unit`.
double bound_by_cgal(const Mesh& a, const Mesh& b, double unit)
{
  const double error = unit / 1000;
  return CGAL::Polygon_mesh_processing::bounded_error_symmetric_Hausdorff_distance<CGAL::Sequential_tag>(a, b, error) + error;
}

// The bound exceeds CGAL's by at most the error that the search permits.
BOOST_AUTO_TEST_CASE(the_bound_agrees_with_the_bound_by_cgal)
{
  using namespace generated;
  for (const Soup& soup : {triangle_sphere(5), triangulated(torus(40, 30)), with_holes(triangle_sphere(5), 3),
                           with_noise(triangulated(grid(30, 20)), 0.05)}) {
    const Mesh mesh = test::to_mesh(soup);
    const double diagonal = SMC::measure_coarsening(mesh, mesh, 10).diagonal;
    for (const double distance : {0.05 * diagonal, 0.02 * diagonal})
      for (const std::size_t rounds : {0, 4}) {
        Mesh output;
        const double bound =
          SMC::coarsen_mesh_to_distance(mesh, distance, output, SMC::parameters::error_feedback(rounds)).distance_bound;
        const double other = bound_by_cgal(mesh, output, distance);
        BOOST_CHECK_GE(bound, other - distance / 500);
        BOOST_CHECK_LE(bound, other + distance / 32);
      }
  }
}

// A user who bisects the number of vertices does not find a much smaller one.
BOOST_AUTO_TEST_CASE(about_as_few_vertices_as_bisection_finds)
{
  Mesh mesh;
  BOOST_REQUIRE(CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/eight.off"), mesh));
  const double diagonal = SMC::measure_coarsening(mesh, mesh, 10).diagonal;
  for (const double distance : {0.02 * diagonal, 0.01 * diagonal}) {
    Mesh output;
    const std::size_t found = SMC::coarsen_mesh_to_distance(mesh, distance, output).vertices;
    std::size_t low = 10, high = mesh.number_of_vertices();
    while (high > low + 1) {
      const std::size_t middle = (low + high) / 2;
      SMC::coarsen_mesh(mesh, middle, output);
      (bound_by_cgal(mesh, output, distance) <= distance ? high : low) = middle;
    }
    BOOST_CHECK_LE(double(found), 1.1 * double(high));
  }
}

BOOST_AUTO_TEST_CASE(distances_out_of_reach_are_refused)
{
  const Mesh mesh = test::to_mesh(generated::triangle_sphere(3));
  Mesh output = test::to_mesh(generated::tetrahedron());
  for (const double wrong : {0., -1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    BOOST_CHECK_THROW(SMC::coarsen_mesh_to_distance(mesh, wrong, output), SMC::Invalid_input);
  try {
    SMC::coarsen_mesh_to_distance(mesh, 1e-30, output);
    BOOST_ERROR("no exception");
  } catch (const SMC::Unreachable_distance& e) {
    BOOST_CHECK_GT(e.nearest(), 1e-30);
    BOOST_CHECK_LT(e.nearest(), 0.1);
    Mesh nearest; // the nearest distance is a bound, and can be asked for
    BOOST_CHECK_LE(SMC::coarsen_mesh_to_distance(mesh, 1.04 * e.nearest(), nearest).distance_bound, 1.04 * e.nearest());
  }
  BOOST_CHECK_EQUAL(output.number_of_vertices(), 4u);
}

// The input meets every tolerance above rounding errors: with the number of all vertices, the result is its surface.
BOOST_AUTO_TEST_CASE(tolerances_that_the_input_meets_are_met)
{
  for (const generated::Soup& soup : {generated::tetrahedron(), generated::octahedron(), generated::cube_grid(2),
                                      generated::triangle_sphere(2), generated::with_holes(generated::triangle_sphere(2), 2)}) {
    const Mesh mesh = test::to_mesh(generated::triangulated(soup));
    Mesh all, within;
    SMC::coarsen_mesh(mesh, mesh.number_of_vertices(), all);
    BOOST_TEST(all.number_of_vertices() == mesh.number_of_vertices());
    BOOST_CHECK_SMALL(SMC::measure_coarsening(mesh, all, 2000).maximum_distance, 1e-9);
    BOOST_CHECK_LE(SMC::coarsen_mesh_to_distance(mesh, 1e-6, within).distance_bound, 1e-6);
    BOOST_CHECK_SMALL(SMC::measure_coarsening(mesh, within, 2000).maximum_distance, 1.1e-6);
  }
}

BOOST_AUTO_TEST_CASE(all_vertices_are_the_input)
{
  for (const char* name : {"meshes/cow.off", "meshes/u.off", "meshes/hand.off"}) {
    Mesh mesh, output;
    BOOST_REQUIRE(CGAL::IO::read_polygon_mesh(CGAL::data_file_path(name), mesh));
    SMC::coarsen_mesh(mesh, mesh.number_of_vertices(), output);
    BOOST_CHECK_SMALL(SMC::measure_coarsening(mesh, output).maximum_distance, 1e-9);
    BOOST_CHECK_SMALL(SMC::measure_coarsening(output, mesh).maximum_distance, 1e-9);
  }
}

// In the cells of vertices of a large polygon, and in its fan of triangles, one vertex has all triangles. A search for a nearest
// point that looks only at some of them is wrong by up to the size of the polygon.
BOOST_AUTO_TEST_CASE(large_polygons_stay_planar)
{
  for (const std::size_t sides : {40, 160, 750}) {
    const Mesh mesh = test::to_mesh(generated::prism(sides));
    Mesh output;
    SMC::coarsen_mesh(mesh, mesh.number_of_vertices(), output);
    BOOST_CHECK_SMALL(SMC::measure_coarsening(mesh, output, 2000).maximum_distance, 1e-9);
    SMC::coarsen_mesh(mesh, mesh.number_of_vertices() / 2, output); // cuts every second corner
    const double side = CGAL_PI / double(sides);
    BOOST_CHECK_LE(SMC::measure_coarsening(mesh, output, 2000).maximum_distance, 4 * side * side);
    const SMC::Distance_report report = SMC::coarsen_mesh_to_distance(mesh, 0.02, output);
    BOOST_CHECK_LE(report.distance_bound, 0.02);
    BOOST_CHECK_LE(report.vertices, std::max<std::size_t>(mesh.number_of_vertices() / 2, 50));
  }
}

// The numbers are tried in an order that does not depend on the distance.
BOOST_AUTO_TEST_CASE(a_larger_distance_never_takes_more_vertices)
{
  using namespace generated;
  for (const Soup& soup : {cube_grid(3), with_holes(triangle_sphere(2), 1), with_noise(torus(8, 8), 0.02),
                           joined(triangle_sphere(2), translated(tetrahedron(), 3, 0, 0))}) {
    const Mesh mesh = test::to_mesh(triangulated(soup));
    const double diagonal = SMC::measure_coarsening(mesh, mesh, 10).diagonal;
    std::size_t last = mesh.number_of_vertices();
    for (double distance = 1e-6 * diagonal; distance < diagonal; distance *= distance < 1e-3 * diagonal ? 100 : 1.5) {
      Mesh output;
      const SMC::Distance_report report = SMC::coarsen_mesh_to_distance(mesh, distance, output);
      BOOST_CHECK_LE(report.vertices, last);
      BOOST_CHECK(report.is_within_distance);
      BOOST_CHECK_LE(report.distance_bound, distance);
      last = report.vertices;
    }
  }
}

BOOST_AUTO_TEST_CASE(features_are_kept_within_a_distance)
{
  const Mesh mesh = test::to_mesh(generated::triangulated(generated::cube_grid(6)));
  Mesh output;
  const auto is_corner = output.add_property_map<Mesh::Vertex_index, bool>("v:is corner", false).first;
  const auto is_line = output.add_property_map<Mesh::Edge_index, bool>("e:is line", false).first;
  const SMC::Distance_report report =
    SMC::coarsen_mesh_to_distance(mesh, 1e-6, output, SMC::parameters::feature_angle(30.),
                                  SMC::parameters::vertex_is_constrained_map(is_corner).edge_is_constrained_map(is_line));
  BOOST_CHECK_LE(report.distance_bound, 1e-6);
  BOOST_CHECK_EQUAL(report.vertices, output.number_of_vertices());
  BOOST_CHECK_EQUAL(std::count_if(output.vertices().begin(), output.vertices().end(), [&](auto v) { return is_corner[v]; }), 8);
  BOOST_CHECK_GE(std::count_if(output.edges().begin(), output.edges().end(), [&](auto e) { return is_line[e]; }), 12);
}

BOOST_AUTO_TEST_CASE(a_number_limits_the_search)
{
  const Mesh mesh = test::to_mesh(generated::triangle_sphere(4));
  Mesh free, fewer, more;
  const std::size_t n = SMC::coarsen_mesh_to_distance(mesh, 0.02, free).vertices;
  const SMC::Distance_report by_number = SMC::coarsen_mesh_to_distance(mesh, 0.02, n / 2, fewer);
  BOOST_CHECK_EQUAL(fewer.number_of_vertices(), n / 2);
  BOOST_CHECK(!by_number.is_within_distance);
  BOOST_CHECK_GT(by_number.distance_bound, 0.02);
  BOOST_CHECK_LE(SMC::measure_coarsening(mesh, fewer, 20000).maximum_distance, by_number.distance_bound);
  const SMC::Distance_report by_distance = SMC::coarsen_mesh_to_distance(mesh, 0.02, 2 * n, more);
  BOOST_CHECK(by_distance.is_within_distance);
  BOOST_CHECK_LE(by_distance.distance_bound, 0.02);
  BOOST_CHECK_LE(double(more.number_of_vertices()), 1.1 * double(n));
  BOOST_CHECK_THROW(SMC::coarsen_mesh_to_distance(mesh, 0.02, 3, more), SMC::Unreachable_number_of_vertices);
}

BOOST_AUTO_TEST_CASE(a_surface_without_area_is_refused)
{
  const Mesh line = test::to_mesh(generated::scaled(generated::triangle_sphere(2), 1, 0, 0));
  Mesh output = test::to_mesh(generated::tetrahedron());
  BOOST_CHECK_THROW(SMC::coarsen_mesh_to_distance(line, 0.1, output), SMC::Invalid_input);
  BOOST_CHECK_EQUAL(output.number_of_vertices(), 4u);
}

// With the default limits, clusters are merged by quadrics instead, and no round is needed.
BOOST_AUTO_TEST_CASE(other_limits_request_a_minimization)
{
  const Mesh mesh = test::to_mesh(generated::triangle_sphere(5));
  const auto rounds = [&](const auto& np) {
    Mesh output;
    const SMC::Distance_report report = SMC::coarsen_mesh_to_distance(mesh, 0.04, output, np);
    BOOST_CHECK(report.is_within_distance);
    BOOST_CHECK_LE(report.distance_bound, 0.04);
    return report.clustering.rounds;
  };
  BOOST_CHECK_EQUAL(rounds(SMC::parameters::default_values()), 0u);
  BOOST_CHECK_EQUAL(rounds(SMC::parameters::number_of_iterations(2)), 2u);
  BOOST_CHECK_GT(rounds(SMC::parameters::convergence_tolerance(0)), 2u);
}

BOOST_AUTO_TEST_CASE(a_torus_needs_what_its_topology_needs)
{
  const Mesh mesh = test::to_mesh(generated::triangulated(generated::torus(9, 9)));
  Mesh output;
  const SMC::Distance_report report = SMC::coarsen_mesh_to_distance(mesh, 100., output);
  BOOST_CHECK_EQUAL(report.vertices, output.number_of_vertices());
  BOOST_CHECK_GE(report.vertices, 7u);
  BOOST_CHECK_LE(report.vertices, 10u);
  BOOST_CHECK_EQUAL(int(num_vertices(output)) - int(num_edges(output)) + int(num_faces(output)), 0);
}

BOOST_AUTO_TEST_CASE(a_plane_needs_what_its_topology_needs)
{
  const Mesh mesh = test::to_mesh(generated::triangulated(generated::grid(30, 30)));
  Mesh output;
  const auto source = output.add_property_map<Mesh::Vertex_index, SMC::Surface_location<Mesh> >("v:source").first;
  const SMC::Distance_report report = SMC::coarsen_mesh_to_distance(mesh, 40., output, SMC::parameters::default_values(),
                                                                    SMC::parameters::vertex_source_map(source));
  BOOST_CHECK_LE(report.vertices, 4u);
  for (const auto v : output.vertices())
    BOOST_CHECK(mesh.is_valid(source[v].face));
}

BOOST_AUTO_TEST_SUITE_END()
