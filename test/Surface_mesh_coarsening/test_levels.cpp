// SPDX-License-Identifier: GPL-3.0-or-later
//
// Levels of detail: each is valid, its clusters are unions of clusters of finer levels, and the stored history gives
// its triangles.

#include "support/face_graphs.h"
#include "support/generate_meshes.h"

#include "models.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_levels.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/extract_dual_mesh.h>
#include <CGAL/Surface_mesh_coarsening/is_valid_clustering.h>
#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_levels)

namespace utf = boost::unit_test;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMC = CGAL::Surface_mesh_coarsening;
using test::Mesh;

namespace {

typedef SMC::Mwcvd_clustering<Mesh, SMC::Maximum_density_weight> Clustering;
typedef SMC::Cluster_levels<Clustering> Levels;
typedef std::array<std::size_t, 3> Triangle;

std::set<Triangle> normalized(std::vector<Triangle> triangles)
{
  for (Triangle& t : triangles)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return std::set<Triangle>(triangles.begin(), triangles.end());
}

std::set<Triangle> triangles_of(const Mesh& mesh)
{
  std::vector<Triangle> triangles;
  for (const auto f : mesh.faces()) {
    Triangle t;
    std::size_t i = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      t[i++] = std::size_t(v);
    triangles.push_back(t);
  }
  return normalized(triangles);
}

std::vector<generated::Soup> surfaces()
{
  using namespace generated;
  const Soup torus = with_noise(generated::torus(30, 20), 0.05);
  return {triangulated(torus),
          torus,
          triangle_sphere(4),
          with_noise(triangulated(grid(24, 18)), 0.1),
          with_holes(triangle_sphere(4), 5),
          plate_with_windows(3, 3),
          joined(triangulated(torus), translated(tube(24, 12), 5, 0, 0)),
          dual(triangulated(torus))};
}

void make_clusters(Clustering& clustering, std::size_t number)
{
  clustering.seed(number);
  clustering.grow();
  clustering.minimize();
}

} // namespace

// Vertices with two faces: polygons are cut into fans where all vertices have cells, but the map is filled for the faces of the
// input.
BOOST_AUTO_TEST_CASE(levels_where_polygons_are_cut)
{
  Mesh mesh = test::to_mesh(generated::triangle_sphere(3));
  const std::vector<Mesh::Edge_index> edges(mesh.edges().begin(), mesh.edges().end());
  for (std::size_t i = 0; i < edges.size(); i += 7) {
    const auto h = mesh.halfedge(edges[i]);
    const auto middle = CGAL::midpoint(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
    mesh.point(mesh.target(CGAL::Euler::split_edge(h, mesh))) = middle;
  }
  SMC::Mwcvd_clustering<Mesh> clustering(mesh);
  clustering.seed_faces_or_cells(mesh.number_of_vertices() / 4);
  clustering.grow();
  const SMC::Cluster_levels<SMC::Mwcvd_clustering<Mesh> > levels(clustering);
  auto cluster = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:cluster").first;
  for (const std::size_t level : {levels.finest(), levels.finest() / 2, std::size_t(10)}) {
    levels.write_clusters(level, cluster);
    std::set<std::size_t> clusters;
    for (const auto f : mesh.faces())
      clusters.insert(cluster[f]);
    BOOST_TEST(*clusters.rbegin() < level);
    BOOST_TEST(2 * clusters.size() > level); // cells that are small parts of their faces have none
  }
}

BOOST_AUTO_TEST_CASE(each_level_is_valid_and_a_union_of_finer_clusters)
{
  for (const generated::Soup& soup : surfaces()) {
    const Mesh mesh = test::to_mesh(soup);
    Mesh finest;
    Clustering clustering(mesh, SMC::parameters::repair_output(false));
    clustering.seed(mesh.number_of_vertices() / 3);
    clustering.grow();
    clustering.minimize();
    clustering.extract_dual_mesh(finest, SMC::Centroid_placement());
    const Levels levels(clustering);
    BOOST_REQUIRE_EQUAL(levels.finest(), clustering.number_of_clusters());
    BOOST_REQUIRE_LT(levels.coarsest(), 40u);
    Mesh copy = mesh;
    auto label = copy.add_property_map<Mesh::Face_index, std::size_t>("f:label").first;
    auto fine = copy.add_property_map<Mesh::Face_index, std::size_t>("f:fine").first;
    levels.write_clusters(levels.finest(), fine);
    std::size_t last = levels.finest();
    for (std::size_t n = levels.finest(); n >= levels.coarsest(); n = n > levels.coarsest() + 40 ? n * 4 / 5 : n - 1) {
      levels.write_clusters(n, label);
      BOOST_REQUIRE_EQUAL(SMC::clustering_fault(mesh, label), "");
      std::set<std::size_t> names;
      for (const auto f : mesh.faces())
        names.insert(label[f]);
      BOOST_REQUIRE_EQUAL(names.size(), n);
      BOOST_REQUIRE_EQUAL(*names.rbegin(), n - 1);
      std::vector<std::size_t> parents;
      levels.parents(last, n, std::back_inserter(parents));
      BOOST_REQUIRE_EQUAL(parents.size(), last);
      for (const auto f : mesh.faces())
        BOOST_REQUIRE_EQUAL(label[f], parents[fine[f]]);
      for (const auto f : mesh.faces())
        fine[f] = label[f];
      last = n;

      std::vector<Triangle> triangles;
      Mesh output, from_labels;
      levels.triangles(n, std::back_inserter(triangles));
      levels.extract_dual_mesh(n, output, SMC::Centroid_placement());
      SMC::extract_dual_mesh(mesh, label, from_labels,
                             SMC::parameters::repair_output(false).vertex_placement(SMC::Centroid_placement()));
      BOOST_REQUIRE(CGAL::is_valid_polygon_mesh(output));
      BOOST_REQUIRE_EQUAL(output.number_of_vertices(), n);
      BOOST_REQUIRE(normalized(triangles) == triangles_of(output));
      BOOST_REQUIRE(normalized(triangles) == triangles_of(from_labels));
      const auto euler = [](const Mesh& m) {
        return long(m.number_of_vertices()) - long(m.number_of_edges()) + long(m.number_of_faces());
      };
      BOOST_REQUIRE_EQUAL(euler(output), euler(finest));
    }
  }
}

// The Hausdorff distance is at least the distance at any points, and close to the estimate.
BOOST_AUTO_TEST_CASE(approximate_distances_are_near_the_hausdorff_distance)
{
  using namespace generated;
  const Soup torus = triangulated(with_noise(generated::torus(60, 40), 0.01));
  for (const Soup& soup : {torus, triangle_sphere(5), with_holes(triangle_sphere(4), 5), scaled(torus, 1e-6)}) {
    const Mesh mesh = test::to_mesh(soup);
    Clustering clustering(mesh);
    make_clusters(clustering, 200);
    const Levels levels(clustering);
    const auto check = [&](std::size_t level, const auto& placement) {
      Mesh output;
      levels.extract_dual_mesh(level, output, placement);
      const double diagonal = SMC::measure_coarsening(mesh, output, 100).diagonal;
      const double error = 1e-4 * diagonal;
      const double exact = PMP::bounded_error_symmetric_Hausdorff_distance<CGAL::Sequential_tag>(mesh, output, error);
      const double distance = levels.approximate_distance(level, placement);
      BOOST_CHECK_LE(distance, exact + error);
      BOOST_CHECK_GE(distance, 0.9 * exact);
    };
    for (const std::size_t level : {200, 100, 50, 25}) {
      check(level, SMC::Centroid_placement());
      check(level, SMC::Quadric_placement());
    }
    BOOST_CHECK_THROW(levels.approximate_distance(201), SMC::Unreachable_number_of_vertices);
  }
}

// Merged clusters are not much farther from the surface than clusters computed for their number.
BOOST_AUTO_TEST_CASE(levels_are_about_as_near_as_direct_results, *utf::precondition(test::If_found{models::fandisk}))
{
  const Mesh mesh = test::to_mesh(test::read_soup(models::fandisk));
  const auto rms = [&mesh](const Mesh& output) { return SMC::measure_coarsening(mesh, output, 50000).rms_distance; };
  const auto np = SMC::parameters::maximum_density(50);
  Clustering clustering(mesh, np), other(mesh, np);
  make_clusters(clustering, 1600);
  const Levels levels(clustering);
  double finer = 0;
  for (const std::size_t level : {800, 400, 200, 100}) {
    Mesh output, direct;
    levels.extract_dual_mesh(level, output, SMC::Centroid_placement());
    make_clusters(other, level);
    other.extract_dual_mesh(direct, SMC::Centroid_placement());
    BOOST_CHECK_LE(rms(output), 1.2 * rms(direct));
    BOOST_CHECK_GT(rms(output), finer);
    finer = rms(output);
  }
}

BOOST_AUTO_TEST_CASE(parents_have_smaller_numbers_and_levels_out_of_range_are_refused)
{
  const Mesh mesh = test::to_mesh(generated::triangle_sphere(4));
  Clustering clustering(mesh);
  BOOST_CHECK_THROW(Levels{clustering}, std::logic_error);
  clustering.seed(100);
  clustering.grow();
  const Levels levels(clustering);
  BOOST_CHECK_EQUAL(levels.coarsest(), 4u);
  for (std::size_t k = levels.coarsest(); k < levels.finest(); ++k)
    BOOST_CHECK_LT(levels.parent(k), k);
  BOOST_CHECK_THROW(levels.parent(3), SMC::Invalid_input);
  BOOST_CHECK_THROW(levels.parent(100), SMC::Invalid_input);
  Mesh output = test::to_mesh(generated::tetrahedron());
  for (const std::size_t wrong : {3, 101}) {
    try {
      levels.extract_dual_mesh(wrong, output);
      BOOST_ERROR("no exception");
    } catch (const SMC::Unreachable_number_of_vertices& e) {
      BOOST_CHECK_EQUAL(e.nearest(), wrong == 3 ? 4 : 100);
    }
  }
  std::vector<std::size_t> parents;
  BOOST_CHECK_THROW(levels.parents(50, 60, std::back_inserter(parents)), SMC::Invalid_input);
  BOOST_CHECK_EQUAL(output.number_of_vertices(), 4u);
}

BOOST_AUTO_TEST_CASE(other_face_graphs)
{
  typedef CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel> Polyhedron;
  Polyhedron mesh, output;
  test::to_face_graph(generated::triangle_sphere(3), mesh);
  SMC::Mwcvd_clustering<Polyhedron> clustering(mesh);
  clustering.seed(60);
  clustering.grow();
  clustering.minimize();
  const SMC::Cluster_levels<SMC::Mwcvd_clustering<Polyhedron> > levels(clustering);
  levels.extract_dual_mesh(20, output);
  BOOST_CHECK_EQUAL(output.size_of_vertices(), 20u);
  std::map<boost::graph_traits<Polyhedron>::face_descriptor, std::size_t> clusters;
  levels.write_clusters(20, boost::make_assoc_property_map(clusters));
  BOOST_CHECK_EQUAL(clusters.size(), mesh.size_of_facets());
  BOOST_CHECK(std::all_of(clusters.begin(), clusters.end(), [](const auto& c) { return c.second < 20; }));
}

BOOST_AUTO_TEST_SUITE_END()
