// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mesh types, kernels, property maps, named parameters and visitors: the clusters do not depend on the representation
// of the mesh.

#include "support/face_graphs.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Closest_vertex_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/compute_face_densities.h>
#include <CGAL/Surface_mesh_coarsening/extract_dual_mesh.h>
#include <CGAL/Surface_mesh_coarsening/is_valid_clustering.h>
#include <CGAL/Surface_mesh_coarsening/neighborhood_seeds.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <random>

BOOST_AUTO_TEST_SUITE(test_genericity)

namespace SMC = CGAL::Surface_mesh_coarsening;
namespace PMP = CGAL::Polygon_mesh_processing;
using generated::Soup;
using reference::Labels;
using test::Mesh;

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
typedef CGAL::Simple_cartesian<double> Double_kernel;
typedef CGAL::Simple_cartesian<float> Float_kernel;
typedef CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
  2, 3, CGAL::Linear_cell_complex_traits<3, Epick> >::type Linear_cell_complex;

// Coordinates that are exact in float.
Soup rounded_to_float(const Soup& s)
{
  return generated::with_points(s, [](generated::Point p) {
    for (double& x : p) {
      const volatile float f = float(x); // g++ 12 optimizes a conversion in both directions away when vectorizing
      x = f;
    }
    return p;
  });
}

Soup closed_soup() { return rounded_to_float(generated::with_noise(generated::triangle_sphere(4), 0.02)); }
Soup open_soup()
{
  return rounded_to_float(
    generated::with_noise(generated::with_holes(generated::triangulated(generated::grid(20, 20)), 3), 0.2));
}

struct Result
{
  Labels labels;
  std::size_t vertices = 0, faces = 0;
  double energy = 0;
};

template <class Graph>
Result coarsen(const Soup& soup, std::size_t n)
{
  Graph input, output;
  test::to_face_graph(soup, input);
  const auto clusters = get(CGAL::dynamic_face_property_t<std::size_t>(), input);
  Result result;
  result.energy = SMC::coarsen_mesh(input, n, output, SMC::parameters::face_cluster_map(clusters)).final_energy;
  result.labels = test::labels_of(input, clusters);
  result.vertices = num_vertices(output);
  result.faces = num_faces(output);
  BOOST_CHECK(CGAL::is_valid_polygon_mesh(output));
  BOOST_CHECK(CGAL::is_triangle_mesh(output));

  // The pieces, on the same graph.
  std::vector<typename boost::graph_traits<Graph>::face_descriptor> seeds;
  SMC::neighborhood_seeds(input, 3, std::back_inserter(seeds));
  BOOST_CHECK_GT(seeds.size(), 10u);
  BOOST_CHECK(SMC::is_valid_clustering(input, clusters));
  Graph again;
  SMC::extract_dual_mesh(input, clusters, again);
  BOOST_CHECK_EQUAL(num_vertices(again), num_vertices(output));
  BOOST_CHECK_EQUAL(num_faces(again), num_faces(output));
  return result;
}

void check_all_graphs(const Soup& soup, std::size_t n)
{
  const Result expected = coarsen<CGAL::Surface_mesh<Double_kernel::Point_3> >(soup, n);
  BOOST_CHECK_EQUAL(expected.vertices, n);
  const auto check = [&](const Result& r, const char* name) {
    BOOST_CHECK_MESSAGE(r.labels == expected.labels, name << " gives other labels");
    BOOST_CHECK_EQUAL(r.vertices, expected.vertices);
    BOOST_CHECK_EQUAL(r.faces, expected.faces);
    BOOST_CHECK_MESSAGE(r.energy == expected.energy,
                        name << " gives energy " << r.energy << ", not " << expected.energy);
  };
  check(coarsen<CGAL::Surface_mesh<Epick::Point_3> >(soup, n), "Surface_mesh with EPICK");
  check(coarsen<CGAL::Surface_mesh<Float_kernel::Point_3> >(soup, n), "Surface_mesh in float");
  check(coarsen<CGAL::Polyhedron_3<Epick> >(soup, n), "Polyhedron_3");
  check(coarsen<CGAL::Polyhedron_3<Double_kernel> >(soup, n), "Polyhedron_3 with Simple_cartesian");
  check(coarsen<Linear_cell_complex>(soup, n), "Linear_cell_complex");
}

template <class... Parameters>
Labels labels_with(const Mesh& mesh, std::size_t n, const Parameters&... np)
{
  SMC::Mwcvd_clustering<Mesh> c(mesh, np...);
  c.seed_faces_or_cells(n); // as coarsen_mesh() does
  c.grow();
  c.minimize();
  Mesh output;
  c.extract_embedded_dual_mesh(output); // exchanges vertices, and clusters follow
  return test::labels_in(c, mesh);
}

bool same_points_and_triangles(const Mesh& a, const Mesh& b)
{
  const Soup s = test::to_soup(a), t = test::to_soup(b);
  return s.points == t.points && s.polygons == t.polygons;
}

Mesh marked_mesh() { return test::to_mesh(generated::joined(generated::tetrahedron(), generated::octahedron())); }

// A kernel that counts calls.
struct Counting_traits : Double_kernel
{
  explicit Counting_traits(std::size_t& reads, std::size_t& points) : reads_(&reads), points_(&points) {}
  Counting_traits() = default;

  template <class Functor>
  struct Counting
  {
    Functor functor;
    std::size_t* count;
    template <class... T>
    decltype(auto) operator()(const T&... t) const
    {
      ++*count;
      return functor(t...);
    }
  };
  typedef Counting<Double_kernel::Compute_x_3> Compute_x_3;
  typedef Counting<Double_kernel::Compute_y_3> Compute_y_3;
  typedef Counting<Double_kernel::Compute_z_3> Compute_z_3;
  typedef Counting<Double_kernel::Construct_point_3> Construct_point_3;
  Compute_x_3 compute_x_3_object() const { return {Double_kernel().compute_x_3_object(), reads_}; }
  Compute_y_3 compute_y_3_object() const { return {Double_kernel().compute_y_3_object(), reads_}; }
  Compute_z_3 compute_z_3_object() const { return {Double_kernel().compute_z_3_object(), reads_}; }
  Construct_point_3 construct_point_3_object() const { return {Double_kernel().construct_point_3_object(), points_}; }

private:
  std::size_t *reads_ = nullptr, *points_ = nullptr;
};

// Records all notifications, and cancels at the `patience`-th request.
struct Recorder
{
  std::vector<std::string> events;
  std::vector<double> energies;
  std::size_t patience = std::size_t(-1), asked = 0;

  void stage_begins(SMC::Coarsening_stage s) { events.push_back("begin " + std::to_string(int(s))); }
  void stage_ends(SMC::Coarsening_stage s) { events.push_back("end " + std::to_string(int(s))); }
  void round_done(std::size_t round, std::size_t moves, double energy)
  {
    events.push_back("round " + std::to_string(round) + (moves == 0 ? " without moves" : ""));
    energies.push_back(energy);
  }
  void step_done(SMC::Coarsening_stage s, std::size_t done, std::size_t total)
  {
    events.push_back("step " + std::to_string(done) + "/" + std::to_string(total) + " of " + std::to_string(int(s)));
  }
  bool go_further() { return ++asked < patience; }
};

} // namespace

BOOST_AUTO_TEST_CASE(graphs_and_kernels)
{
  check_all_graphs(closed_soup(), 80);
  check_all_graphs(open_soup(), 39);
  check_all_graphs(rounded_to_float(generated::partly_triangulated(generated::torus(30, 20))), 54);
}

BOOST_AUTO_TEST_CASE(output_of_another_type)
{
  const Mesh mesh = test::to_mesh(closed_soup());
  CGAL::Polyhedron_3<Epick> polyhedron;
  Linear_cell_complex complex;
  CGAL::Surface_mesh<Float_kernel::Point_3> floats;
  Mesh expected;
  SMC::coarsen_mesh(mesh, 50, expected);
  SMC::coarsen_mesh(mesh, 50, polyhedron);
  SMC::coarsen_mesh(mesh, 50, complex);
  SMC::coarsen_mesh(mesh, 50, floats);
  const Soup soup = test::to_soup(expected);
  BOOST_CHECK(test::to_soup(polyhedron).points == soup.points);
  BOOST_CHECK(test::to_soup(floats).points == rounded_to_float(soup).points);
  BOOST_CHECK_EQUAL(num_vertices(complex), 50u);
  BOOST_CHECK_EQUAL(num_faces(complex), 96u);
  BOOST_CHECK(test::normalized(test::triangles_of(test::to_soup(polyhedron))) ==
              test::normalized(test::triangles_of(soup)));
}

BOOST_AUTO_TEST_CASE(point_maps)
{
  const Soup soup = closed_soup();
  const Mesh mesh = test::to_mesh(soup);
  // The mesh itself is flat; only the map has the positions of its vertices.
  Mesh flat = test::to_mesh(generated::scaled(soup, 0));
  std::map<Mesh::Vertex_index, test::Point> positions;
  for (const auto v : vertices(mesh))
    positions[v] = mesh.point(v);
  const auto map = boost::make_assoc_property_map(positions);
  const auto clusters = get(CGAL::dynamic_face_property_t<std::size_t>(), flat);
  Mesh output, expected;
  const auto report =
    SMC::coarsen_mesh(flat, 60, output, SMC::parameters::vertex_point_map(map).face_cluster_map(clusters));
  BOOST_CHECK(test::labels_of(flat, clusters) == labels_with(mesh, 60));
  const auto other = SMC::coarsen_mesh(mesh, 60, expected);
  BOOST_CHECK(same_points_and_triangles(output, expected));
  BOOST_CHECK_EQUAL(report.final_energy, other.final_energy);

  // Points of the output are written to the given map.
  Mesh unplaced;
  auto placed =
    unplaced.add_property_map<Mesh::Vertex_index, Epick::Point_3>("v:placed", Epick::Point_3(7, 7, 7)).first;
  SMC::coarsen_mesh(mesh, 60, unplaced, CGAL::parameters::default_values(), CGAL::parameters::vertex_point_map(placed));
  BOOST_REQUIRE_EQUAL(unplaced.number_of_vertices(), 60u);
  for (const auto v : vertices(unplaced)) {
    BOOST_CHECK_EQUAL(placed[v].x(), expected.point(v).x());
    BOOST_CHECK_EQUAL(placed[v].z(), expected.point(v).z());
  }
}

BOOST_AUTO_TEST_CASE(face_index_map)
{
  const Soup soup = closed_soup();
  const Mesh mesh = test::to_mesh(soup);
  // The faces in another order, with a map to the old order.
  std::vector<std::size_t> order(soup.polygons.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::mt19937 engine(5);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[engine() % i]);
  Soup shuffled{soup.points, {}};
  for (const std::size_t i : order)
    shuffled.polygons.push_back(soup.polygons[i]);
  const Mesh other = test::to_mesh(shuffled);
  const auto index =
    boost::make_function_property_map<Mesh::Face_index, std::size_t>([&](Mesh::Face_index f) { return order[f]; });
  const Labels expected = labels_with(mesh, 60),
               labels = labels_with(other, 60, CGAL::parameters::face_index_map(index));
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
    wrong += labels[i] != expected[order[i]];
  BOOST_CHECK_EQUAL(wrong, 0u);
  BOOST_CHECK(labels_with(other, 60) != labels); // the map made a difference
  // Results are assigned to the right faces.
  std::map<Mesh::Face_index, int> clusters;
  Mesh output;
  SMC::coarsen_mesh(other, 60, output,
                    CGAL::parameters::face_index_map(index)); // plain CGAL pack
  SMC::coarsen_mesh(other, 60, output,
                    SMC::parameters::face_cluster_map(boost::make_assoc_property_map(clusters)).face_index_map(index));
  for (const auto f : faces(other))
    BOOST_CHECK_EQUAL(std::size_t(clusters[f]), labels[f]);
  // Without error feedback, which exchanges vertices, the triangles follow from the clusters.
  Mesh without_feedback, by_clusters;
  SMC::coarsen_mesh(other, 60, without_feedback,
                    SMC::parameters::face_cluster_map(boost::make_assoc_property_map(clusters))
                      .face_index_map(index)
                      .error_feedback(0));
  SMC::extract_dual_mesh(other, boost::make_assoc_property_map(clusters), by_clusters,
                         CGAL::parameters::face_index_map(index));
  BOOST_CHECK(test::normalized(test::triangles_of(test::to_soup(without_feedback))) ==
              test::normalized(test::triangles_of(test::to_soup(by_clusters))));
  // A map that is no bijection is refused.
  const auto constant =
    boost::make_function_property_map<Mesh::Face_index, std::size_t>([](Mesh::Face_index) { return 3; });
  const auto large = boost::make_function_property_map<Mesh::Face_index, std::size_t>(
    [](Mesh::Face_index f) { return std::size_t(f) + 1; });
  BOOST_CHECK_THROW(SMC::coarsen_mesh(other, 60, output, CGAL::parameters::face_index_map(constant)),
                    SMC::Invalid_input);
  BOOST_CHECK_THROW(SMC::coarsen_mesh(other, 60, output, CGAL::parameters::face_index_map(large)), SMC::Invalid_input);
}

BOOST_AUTO_TEST_CASE(geometry_traits)
{
  const Mesh mesh = test::to_mesh(closed_soup());
  std::size_t reads = 0, points = 0;
  const Counting_traits traits(reads, points);
  Mesh output, expected;
  SMC::coarsen_mesh(mesh, 50, expected);
  SMC::coarsen_mesh(mesh, 50, output, SMC::parameters::geom_traits(traits), CGAL::parameters::geom_traits(traits));
  BOOST_CHECK_EQUAL(reads, 3 * mesh.number_of_vertices());
  BOOST_CHECK_EQUAL(points, 50u);
  BOOST_CHECK(same_points_and_triangles(output, expected));
  const auto densities = get(CGAL::dynamic_face_property_t<double>(), mesh);
  reads = 0;
  SMC::compute_face_densities(mesh, densities, CGAL::parameters::geom_traits(traits));
  BOOST_CHECK_EQUAL(reads, 3 * mesh.number_of_vertices());
}

BOOST_AUTO_TEST_CASE(density_and_cluster_maps)
{
  const Mesh mesh = test::to_mesh(closed_soup());
  std::map<Mesh::Face_index, float> densities;
  std::map<Mesh::Face_index, int> clusters;
  std::map<Mesh::Vertex_index, short> counts;
  for (const auto f : faces(mesh))
    densities[f] = mesh.point(target(halfedge(f, mesh), mesh)).z() > 0 ? 20.f : 1.f;
  Mesh output;
  SMC::coarsen_mesh(mesh, 60, output,
                    SMC::parameters::face_density_map(boost::make_assoc_property_map(densities))
                      .face_cluster_map(boost::make_assoc_property_map(clusters))
                      .vertex_boundary_count_map(boost::make_assoc_property_map(counts))
                      .cluster_weight(SMC::Weighted_area_weight()));
  BOOST_CHECK_EQUAL(clusters.size(), mesh.number_of_faces());
  BOOST_CHECK_EQUAL(counts.size(), mesh.number_of_vertices());
  // More vertices where the density is higher.
  std::size_t upper = 0;
  for (const auto v : vertices(output))
    upper += output.point(v).z() > 0;
  BOOST_CHECK_GT(upper, 38u);
  const reference::Reference_mesh m(test::to_soup(mesh));
  const Labels labels = test::labels_of(mesh, boost::make_assoc_property_map(clusters));
  BOOST_CHECK_EQUAL(reference::fault_of_clustering(m, labels), "");
  const std::vector<std::size_t> expected = reference::boundary_counts(m, labels);
  for (const auto v : vertices(mesh))
    BOOST_CHECK_EQUAL(std::size_t(counts[v]), expected[v]);
  // The computed densities, passed as a map, give the same result.
  const auto computed = get(CGAL::dynamic_face_property_t<double>(), mesh);
  SMC::compute_face_densities(mesh, computed, SMC::parameters::maximum_density(20.));
  BOOST_CHECK(labels_with(mesh, 60, SMC::parameters::face_density_map(computed)) ==
              labels_with(mesh, 60, SMC::parameters::maximum_density(20.)));
}

BOOST_AUTO_TEST_CASE(removed_elements_and_isolated_vertices)
{
  const Soup soup = closed_soup();
  const Mesh mesh = test::to_mesh(soup);
  Mesh mutilated;
  // Isolated vertices in between, at meaningless positions.
  std::vector<Mesh::Vertex_index> number;
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    if (v % 5 == 0)
      mutilated.add_vertex(test::Point(std::nan(""), 1e300, -1e300));
    number.push_back(mutilated.add_vertex(test::Point(soup.points[v][0], soup.points[v][1], soup.points[v][2])));
  }
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    const generated::Polygon& p = soup.polygons[f];
    mutilated.add_face(number[p[0]], number[p[1]], number[p[2]]);
  }
  // Garbage: a component that is removed again, and removed vertices.
  const auto a = mutilated.add_vertex(test::Point(9, 9, 9)), b = mutilated.add_vertex(test::Point(9, 8, 9)),
             c = mutilated.add_vertex(test::Point(9, 9, 8));
  const auto f = mutilated.add_face(a, b, c);
  CGAL::Euler::remove_face(halfedge(f, mutilated), mutilated);
  mutilated.remove_vertex(mutilated.add_vertex(test::Point(0, 0, 50)));
  BOOST_REQUIRE(mutilated.has_garbage());

  const auto clusters = get(CGAL::dynamic_face_property_t<std::size_t>(), mutilated);
  const auto counts = get(CGAL::dynamic_vertex_property_t<int>(), mutilated);
  Mesh output, expected;
  SMC::coarsen_mesh(mutilated, 60, output,
                    SMC::parameters::face_cluster_map(clusters).vertex_boundary_count_map(counts));
  SMC::coarsen_mesh(mesh, 60, expected);
  BOOST_CHECK(test::labels_of(mutilated, clusters) == labels_with(mesh, 60));
  BOOST_CHECK(same_points_and_triangles(output, expected));
  for (const auto v : vertices(mutilated))
    if (mutilated.is_isolated(v))
      BOOST_CHECK_EQUAL(get(counts, v), 0);
  // They do not count as vertices.
  try {
    SMC::coarsen_mesh(mutilated, mesh.number_of_vertices() + 1, output);
    BOOST_ERROR("not refused");
  } catch (const SMC::Unreachable_number_of_vertices& e) {
    BOOST_CHECK_EQUAL(e.nearest(), mesh.number_of_vertices());
  }
}

BOOST_AUTO_TEST_CASE(output_is_replaced)
{
  const Mesh mesh = test::to_mesh(closed_soup());
  Mesh expected, output = marked_mesh();
  auto kept = output.add_property_map<Mesh::Vertex_index, int>("v:kept", 7).first;
  SMC::coarsen_mesh(mesh, 50, expected);
  SMC::coarsen_mesh(mesh, 50, output);
  BOOST_CHECK(same_points_and_triangles(output, expected));
  BOOST_CHECK_EQUAL(kept[*vertices(output).begin()], 7); // the caller's map still exists
  // Twice into the same mesh.
  SMC::coarsen_mesh(mesh, 30, output);
  BOOST_CHECK_EQUAL(output.number_of_vertices(), 30u);
  BOOST_CHECK_EQUAL(output.number_of_faces(), 56u);
  BOOST_CHECK(!output.has_garbage());
}

BOOST_AUTO_TEST_CASE(named_parameters_in_any_order)
{
  const Mesh mesh = test::to_mesh(closed_soup());
  namespace p = SMC::parameters;
  typedef SMC::Mwcvd_clustering<Mesh, SMC::Weighted_area_weight> Clustering;
  Clustering c(mesh, p::maximum_density(5.));
  c.seed(40);
  c.grow();
  c.minimize(2);
  Mesh first, output;
  c.extract_dual_mesh(first, SMC::Centroid_placement());
  const Labels expected = test::labels_in(c, mesh);
  const auto clusters = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  const auto counts = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  const auto points = get(CGAL::vertex_point, mesh);
  const SMC::Weighted_area_weight weight;
  const auto check = [&](const auto& np) {
    for (const auto f : faces(mesh))
      put(clusters, f, std::size_t(-1));
    const auto report = SMC::coarsen_mesh(mesh, 40, output, np);
    BOOST_CHECK_LE(report.rounds, 2u);
    BOOST_CHECK(test::labels_of(mesh, clusters) == expected);
    BOOST_CHECK(same_points_and_triangles(first, output));
  };
  check(p::cluster_weight(weight)
          .maximum_density(5.)
          .vertex_placement(SMC::Centroid_placement())
          .number_of_iterations(2)
          .face_cluster_map(clusters)
          .vertex_point_map(points));
  check(p::vertex_point_map(points)
          .face_cluster_map(clusters)
          .number_of_iterations(2)
          .maximum_density(5.)
          .vertex_placement(SMC::Centroid_placement())
          .cluster_weight(weight)
          .vertex_boundary_count_map(counts));
  check(p::number_of_iterations(2)
          .geom_traits(Double_kernel())
          .face_cluster_map(clusters)
          .cluster_weight(weight)
          .maximum_density(5.)
          .vertex_placement(SMC::Centroid_placement()));
  check(p::geom_traits(Double_kernel())
          .vertex_point_map(points)
          .cluster_weight(weight)
          .face_cluster_map(clusters)
          .maximum_density(5.)
          .vertex_placement(SMC::Centroid_placement())
          .number_of_iterations(2));
  // A pack of CGAL's, adopted in the middle of the work.
  check(p::adopt(CGAL::parameters::vertex_point_map(points).number_of_iterations(2))
          .maximum_density(5.)
          .vertex_placement(SMC::Centroid_placement())
          .face_cluster_map(clusters)
          .geom_traits(Double_kernel())
          .cluster_weight(weight));
  // A pack may hold parameters of other functions of CGAL.
  check(p::verbose(false)
          .random_seed(5)
          .cluster_weight(weight)
          .number_of_iterations(2)
          .face_cluster_map(clusters)
          .vertex_index_map(get(CGAL::vertex_index, mesh))
          .maximum_density(5.)
          .vertex_placement(SMC::Centroid_placement()));
  // The whole pack goes on to CGAL's own functions.
  const auto pack = p::cluster_weight(weight).vertex_point_map(points).maximum_density(5.);
  BOOST_CHECK_CLOSE(PMP::area(mesh, pack), PMP::area(mesh), 1e-12);
}

BOOST_AUTO_TEST_CASE(parameters_of_the_parts)
{
  const Mesh mesh = test::to_mesh(closed_soup());
  const auto clusters = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  Mesh centroids, closest, by_labels;
  SMC::coarsen_mesh(mesh, 50, centroids, SMC::parameters::vertex_placement(SMC::Centroid_placement()));
  SMC::coarsen_mesh(mesh, 50, closest,
                    SMC::parameters::vertex_placement(SMC::Closest_vertex_placement()).face_cluster_map(clusters));
  BOOST_CHECK(test::to_soup(centroids).polygons == test::to_soup(closest).polygons);
  std::vector<test::Point> points(mesh.points().begin(), mesh.points().end());
  std::sort(points.begin(), points.end());
  for (const auto v : vertices(closest)) {
    // Equal to the mesh's coordinates except for the rounding of the local frame.
    const auto near = std::min_element(points.begin(), points.end(), [&](const test::Point& a, const test::Point& b) {
      return CGAL::squared_distance(a, closest.point(v)) < CGAL::squared_distance(b, closest.point(v));
    });
    BOOST_CHECK_LT(CGAL::squared_distance(*near, closest.point(v)), 1e-28);
    BOOST_CHECK(closest.point(v) != centroids.point(v));
  }
  SMC::extract_dual_mesh(mesh, clusters, by_labels, SMC::parameters::vertex_placement(SMC::Closest_vertex_placement()));
  BOOST_CHECK(test::normalized(test::triangles_of(test::to_soup(by_labels))) ==
              test::normalized(test::triangles_of(test::to_soup(closest))));
  // Components subdivided on request are counted like the others.
  Mesh divided;
  const auto subdivide = SMC::parameters::subdivide_input(true);
  BOOST_CHECK_EQUAL(SMC::coarsen_mesh(mesh, 50, divided).subdivided_components, 0u);
  BOOST_CHECK_EQUAL(SMC::coarsen_mesh(marked_mesh(), 30, divided, subdivide).subdivided_components, 2u);
}

BOOST_AUTO_TEST_CASE(visitor_is_notified_in_order)
{
  const Mesh mesh = test::to_mesh(closed_soup());
  Mesh output;
  Recorder recorder;
  const auto report = SMC::coarsen_mesh(mesh, 50, output, SMC::parameters::visitor(std::ref(recorder))
                                                            .convergence_tolerance(0)
                                                            .error_feedback(0)
                                                            .vertex_placement(SMC::Fitted_placement(3)));
  std::vector<std::string> expected{"begin 0", "end 0", "begin 1", "end 1", "begin 2", "end 2", "begin 3"};
  for (std::size_t i = 1; i < report.rounds; ++i)
    expected.push_back("round " + std::to_string(i));
  expected.push_back("round " + std::to_string(report.rounds) + " without moves");
  expected.insert(expected.end(), {"end 3", "begin 4", "end 4", "begin 5", "step 1/3 of 5", "step 2/3 of 5", "step 3/3 of 5",
                                   "end 5", "begin 7", "end 7"});
  BOOST_CHECK_EQUAL_COLLECTIONS(recorder.events.begin(), recorder.events.end(), expected.begin(), expected.end());
  BOOST_CHECK(std::is_sorted(recorder.energies.rbegin(), recorder.energies.rend(),
                             [](double a, double b) { return a < b * (1 - 1e-12); }));
  BOOST_CHECK_GT(recorder.asked, 5u);

  // By value: a copy is notified. CGAL's own pack suffices.
  Recorder untouched;
  SMC::coarsen_mesh(mesh, 50, output, CGAL::parameters::visitor(untouched));
  BOOST_CHECK(untouched.events.empty());
}

// The feedback may end early; then its last two rounds follow.
BOOST_AUTO_TEST_CASE(visitor_is_notified_of_feedback)
{
  const Mesh mesh = test::to_mesh(closed_soup());
  Mesh output;
  Recorder recorder;
  SMC::coarsen_mesh(mesh, 50, output, SMC::parameters::visitor(std::ref(recorder)).error_feedback(4));
  const auto at = [&](const std::string& event) {
    return std::find(recorder.events.begin(), recorder.events.end(), event) - recorder.events.begin();
  };
  BOOST_CHECK_LT(at("end 4"), at("begin 5"));
  BOOST_CHECK_LT(at("step 5/5 of 5"), at("end 5"));
  BOOST_CHECK_LT(at("end 5"), at("begin 6"));
  BOOST_CHECK_LT(at("begin 6"), at("step 1/6 of 6"));
  BOOST_CHECK_LT(at("step 1/6 of 6"), at("step 5/6 of 6"));
  BOOST_CHECK_LT(at("step 5/6 of 6"), at("step 6/6 of 6"));
  BOOST_CHECK_LT(at("step 6/6 of 6"), at("end 6"));
  BOOST_CHECK_LT(at("end 6"), at("begin 7"));
  BOOST_CHECK_EQUAL(recorder.events.back(), "end 7");
}

BOOST_AUTO_TEST_CASE(cancelling)
{
  const Mesh mesh = test::to_mesh(closed_soup());
  const Mesh before = marked_mesh();
  std::map<Mesh::Face_index, std::size_t> clusters;
  std::size_t cancelled = 0;
  for (std::size_t patience = 1;; ++patience) {
    Recorder recorder;
    recorder.patience = patience;
    Mesh output = marked_mesh();
    try {
      SMC::coarsen_mesh(
        mesh, 50, output,
        SMC::parameters::visitor(std::ref(recorder)).face_cluster_map(boost::make_assoc_property_map(clusters)));
      BOOST_CHECK_EQUAL(output.number_of_vertices(), 50u);
      break;
    } catch (const SMC::Coarsening_cancelled&) {
      ++cancelled;
      BOOST_CHECK_EQUAL(recorder.asked, patience); // not called after cancelling
      BOOST_CHECK_MESSAGE(same_points_and_triangles(output, before),
                          "the output has changed when cancelled at question " << patience << ", after "
                                                                               << recorder.events.size() << " events");
      BOOST_CHECK(clusters.empty());
    }
    BOOST_REQUIRE_LT(patience, 10000u);
  }
  BOOST_CHECK_GT(cancelled, 10u);
}

BOOST_AUTO_TEST_CASE(polygon_soup)
{
  const Mesh mesh = test::to_mesh(open_soup());
  const auto clusters = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  // The dual uses no densities unless given; the clusters are computed with densities of 1, so that both have the same
  // centroids and the same repair.
  const CGAL::Constant_property_map<Mesh::Face_index, double> uniform(1);
  Mesh output;
  SMC::coarsen_mesh(mesh, 50, output, SMC::parameters::face_density_map(uniform).face_cluster_map(clusters));
  std::vector<test::Point> points;
  std::vector<std::vector<std::size_t> > triangles;
  SMC::extract_dual_soup(mesh, clusters, points, triangles);
  BOOST_CHECK_EQUAL(points.size(), output.number_of_vertices());
  std::vector<reference::Triangle> soup_triangles;
  for (const auto& t : triangles)
    soup_triangles.push_back({t[0], t[1], t[2]});
  BOOST_CHECK(test::normalized(soup_triangles) == test::normalized(test::triangles_of(test::to_soup(output))));
  // Existing elements of the ranges remain, and indices count them.
  std::vector<std::array<std::size_t, 3> > more{{{0, 1, 2}}};
  SMC::extract_dual_soup(mesh, clusters, points, more);
  BOOST_CHECK_EQUAL(points.size(), 2 * output.number_of_vertices());
  BOOST_CHECK_EQUAL(more.size(), 1 + triangles.size());
  BOOST_CHECK_EQUAL(more[1][0], 50 + triangles[0][0]);
  // Indices of a type that is not std::size_t.
  std::vector<std::vector<int> > of_ints;
  std::vector<std::array<int, 3> > of_three_ints;
  points.clear();
  SMC::extract_dual_soup(mesh, clusters, points, of_ints);
  points.clear();
  SMC::extract_dual_soup(mesh, clusters, points, of_three_ints);
  BOOST_REQUIRE_EQUAL(of_ints.size(), triangles.size());
  BOOST_REQUIRE_EQUAL(of_three_ints.size(), triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      BOOST_CHECK_EQUAL(of_ints[t][i], int(triangles[t][i]));
      BOOST_CHECK_EQUAL(of_three_ints[t][i], int(triangles[t][i]));
    }
}

// Labels of any origin and type, their dual in the order of the labels.
BOOST_AUTO_TEST_CASE(labels_of_anyone)
{
  // A cube with one label per side: the dual is an octahedron.
  const Mesh cube = test::to_mesh(generated::cube_grid(4));
  const int names[] = {-50, 7, 3, 1000000, 0, -2};
  const auto labels = boost::make_function_property_map<Mesh::Face_index, int>(
    [&](Mesh::Face_index f) { return names[std::size_t(f) / 16]; });
  Mesh octahedron;
  SMC::extract_dual_mesh(cube, labels, octahedron, SMC::parameters::vertex_placement(SMC::Centroid_placement()));
  BOOST_CHECK_EQUAL(octahedron.number_of_vertices(), 6u);
  BOOST_CHECK_EQUAL(octahedron.number_of_faces(), 8u);
  BOOST_CHECK(CGAL::is_closed(octahedron));
  // In ascending order of labels: sides -x, +z, -z, -y, +x, +y.
  const double expected[6][3] = {{-1, 0, 0}, {0, 0, 1}, {0, 0, -1}, {0, -1, 0}, {1, 0, 0}, {0, 1, 0}};
  for (std::size_t i = 0; i < 6; ++i)
    BOOST_CHECK_LT(CGAL::squared_distance(octahedron.point(Mesh::Vertex_index(unsigned(i))),
                                          test::Point(expected[i][0], expected[i][1], expected[i][2])),
                   1e-24);
  // Oriented outwards.
  for (const auto f : faces(octahedron)) {
    std::vector<test::Point> p;
    for (const auto v : CGAL::vertices_around_face(halfedge(f, octahedron), octahedron))
      p.push_back(octahedron.point(v));
    BOOST_CHECK_GT(CGAL::scalar_product(CGAL::normal(p[0], p[1], p[2]), p[0] - CGAL::ORIGIN), 0);
  }

  // Invalid labels do not change the output.
  Mesh output = marked_mesh();
  const auto two = boost::make_function_property_map<Mesh::Face_index, int>(
    [&](Mesh::Face_index f) { return int(std::size_t(f) % 2); });
  BOOST_CHECK_THROW(SMC::extract_dual_mesh(cube, two, output), SMC::Invalid_input);
  BOOST_CHECK(same_points_and_triangles(output, marked_mesh()));

  // Where four faces of an octahedron meet, the fans of its dual must not repeat an edge.
  const Mesh small = test::to_mesh(generated::octahedron());
  const auto each =
    boost::make_function_property_map<Mesh::Face_index, std::size_t>([](Mesh::Face_index f) { return std::size_t(f); });
  Mesh dual;
  SMC::extract_dual_mesh(small, each, dual);
  BOOST_CHECK_EQUAL(dual.number_of_vertices(), 8u);
  BOOST_CHECK_EQUAL(dual.number_of_faces(), 12u);
  BOOST_CHECK(CGAL::is_closed(dual));
}

BOOST_AUTO_TEST_SUITE_END()
