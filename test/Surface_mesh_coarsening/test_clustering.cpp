// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares seeds, growth, minimization and dual with brute force, on generated meshes and on models, for each weight.

#include "support/face_graphs.h"
#include "support/reference_energy.h"

#include "models.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Quadric_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/compute_face_densities.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Minimization_state.h>
#include <CGAL/Surface_mesh_coarsening/is_valid_clustering.h>
#include <CGAL/Surface_mesh_coarsening/neighborhood_seeds.h>
#include <CGAL/Surface_mesh_coarsening/paper.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/mpl/list.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_clustering)

namespace SMC = CGAL::Surface_mesh_coarsening;
namespace utf = boost::unit_test;
using generated::Soup;
using reference::Labels;
using reference::Reference_mesh;
using test::Mesh;

namespace {

typedef boost::mpl::list<SMC::Uniform_weight, SMC::Weighted_area_weight, SMC::Maximum_density_weight,
                         SMC::Exact_maximum_density_weight, SMC::Density_variance_weight>
  Weights;

template <class Weight>
double r_new()
{
  return std::is_same<Weight, SMC::Density_variance_weight>::value ? 3. : 50.;
}

void check_close(double a, double b, double relative, const std::string& what)
{
  BOOST_CHECK_MESSAGE(std::abs(a - b) <= relative * (std::max)(std::abs(a), std::abs(b)),
                      what << ": " << a << " and " << b << " differ");
}

// Elements and points have not changed.
bool same_mesh(const Mesh& a, const Mesh& b)
{
  if (a.number_of_vertices() != b.number_of_vertices() || a.number_of_halfedges() != b.number_of_halfedges() ||
      a.number_of_faces() != b.number_of_faces() ||
      a.properties<Mesh::Face_index>() != b.properties<Mesh::Face_index>() ||
      a.properties<Mesh::Vertex_index>() != b.properties<Mesh::Vertex_index>())
    return false;
  for (const auto v : a.vertices())
    if (a.point(v) != b.point(v) || a.halfedge(v) != b.halfedge(v))
      return false;
  for (const auto h : a.halfedges())
    if (a.next(h) != b.next(h) || a.target(h) != b.target(h) || a.face(h) != b.face(h))
      return false;
  return true;
}

// Counts dual triangles oriented like the surface around the vertex where their clusters meet.
template <class Positions>
double fraction_of_upright_triangles(const Reference_mesh& m, const Labels& labels, const Positions& position)
{
  const std::vector<reference::Face> faces = reference::faces_of(m.soup());
  std::vector<reference::Vector> normal(reference::number_of_clusters(labels), reference::Vector{{0, 0, 0}});
  for (std::size_t f = 0; f < labels.size(); ++f)
    for (int k = 0; k < 3; ++k)
      normal[labels[f]][k] += faces[f].area * faces[f].normal[k];
  std::size_t upright = 0;
  const auto triangles = reference::dual_triangles(m, labels);
  for (const reference::Triangle& t : triangles) {
    reference::Vector around = normal[t[0]];
    const auto n = reference::cross(reference::difference(position[t[1]], position[t[0]]),
                                    reference::difference(position[t[2]], position[t[0]]));
    for (int k = 1; k < 3; ++k)
      for (int i = 0; i < 3; ++i)
        around[i] += normal[t[k]][i];
    upright += reference::dot(n, around) > 0;
  }
  return triangles.empty() ? 1. : double(upright) / double(triangles.size());
}

template <class Clustering>
void check_dual(Clustering& clustering, const Reference_mesh& m, const Labels& labels, double min_upright)
{
  Mesh output;
  clustering.extract_dual_mesh(output, SMC::Centroid_placement());
  const Soup soup = test::to_soup(output);
  BOOST_CHECK(CGAL::is_valid_polygon_mesh(output));
  BOOST_CHECK(CGAL::is_triangle_mesh(output));
  BOOST_CHECK_EQUAL(soup.points.size(), clustering.number_of_clusters());
  for (const auto v : vertices(output))
    BOOST_CHECK(!output.is_isolated(v));
  // The triangles equal the triangles that brute force computes from the labels, in the orientation of the mesh: by
  // fault_of_clustering(), a 2-manifold of the right topology and orientation.
  BOOST_CHECK(test::normalized(test::triangles_of(soup)) == test::normalized(reference::dual_triangles(m, labels)));
  const double upright = fraction_of_upright_triangles(m, labels, soup.points);
  BOOST_CHECK_MESSAGE(upright >= min_upright, "only " << upright << " of the dual triangles look outwards");
}

template <class Clustering>
void check_boundary_counts(const Clustering& clustering, const Mesh& mesh, const Reference_mesh& m,
                           const Labels& labels)
{
  const auto counts = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  clustering.write_boundary_counts(counts);
  const std::vector<std::size_t> expected = reference::boundary_counts(m, labels);
  std::size_t wrong = 0;
  for (const auto v : vertices(mesh))
    wrong += get(counts, v) != expected[v];
  BOOST_CHECK_EQUAL(wrong, 0u);
}

// No allowed move of a single face lowers the energy of a converged clustering by more than the tolerance.
template <class Weight>
void check_local_minimum(const Reference_mesh& m, const Labels& labels, const std::vector<reference::Face>& faces,
                         const std::vector<double>& densities, const Weight& weight)
{
  const std::vector<reference::Real> before = reference::energies(faces, densities, labels, weight);
  std::size_t valid = 0, gains = 0;
  Labels moved = labels;
  for (std::size_t f = 0; f < labels.size(); ++f) {
    const std::size_t from = labels[f];
    std::vector<std::size_t> tried(1, from);
    for (const std::size_t g : m.faces_across(f)) {
      if (g == reference::none || std::find(tried.begin(), tried.end(), labels[g]) != tried.end())
        continue;
      const std::size_t to = labels[g];
      tried.push_back(to);
      moved[f] = to;
      if (reference::number_of_clusters(moved) == before.size() && reference::fault_of_clustering(m, moved).empty()) {
        ++valid;
        const std::vector<reference::Real> after = reference::energies(faces, densities, moved, weight);
        const reference::Real lost = before[from] - after[from], won = after[to] - before[to];
        gains += lost - won > 1.1e-7L * (std::abs(lost) + std::abs(won)) + 1e-14L * (before[from] + before[to]);
      }
      moved[f] = from;
    }
  }
  BOOST_CHECK_GT(valid, 0u);
  BOOST_CHECK_MESSAGE(gains == 0,
                      gains << " of " << valid << " allowed moves lower the energy of a converged clustering");
}

struct How
{
  double min_upright = 0.95;
  bool local_minimum = false;
  bool in_blocks = false; // of clusters, because there are many
};

// A mesh, and what the checks need of it.
template <class W>
struct Problem
{
  typedef W Weight;

  Problem(const Soup& input, std::size_t n, const How& how)
    : mesh(test::to_mesh(input)), m(test::to_soup(mesh)), faces(reference::faces_of(m.soup())),
      densities(reference::densities(m, r_new<Weight>())), n(n), how(how)
  {}

  auto density_map() const
  {
    return boost::make_function_property_map<Mesh::Face_index>([this](Mesh::Face_index f) { return densities[f]; });
  }
  double energy(const Labels& labels) const { return double(reference::energy(faces, densities, labels, weight)); }

  const Mesh mesh;
  const Reference_mesh m;
  const std::vector<reference::Face> faces;
  const std::vector<double> densities;
  const Weight weight = Weight();
  const std::size_t n;
  const How how;
};

template <class Clustering, class Problem>
void seed_and_grow(Clustering& c, const Problem& p)
{
  BOOST_CHECK_GE(c.seed(p.n), p.n);
  c.grow();
  BOOST_REQUIRE_EQUAL(c.report().subdivided_components, 0u);
  const Labels labels = test::labels_in(c, p.mesh);
  BOOST_CHECK_EQUAL(reference::fault_of_clustering(p.m, labels), "");
  BOOST_CHECK_EQUAL(reference::number_of_clusters(labels), p.n);
  BOOST_CHECK_EQUAL(c.number_of_clusters(), p.n);
  check_close(c.energy(), p.energy(labels), 1e-9, "initial energy");
  BOOST_CHECK_EQUAL(c.report().initial_energy, c.energy());
  check_boundary_counts(c, p.mesh, p.m, labels);
}

template <class Clustering, class Problem>
void minimize_round_by_round(Clustering& c, const Problem& p)
{
  double energy = c.energy();
  std::size_t rounds = 0, moves = 0;
  bool changed = true;
  while (changed && rounds < 1000) {
    changed = c.minimize_round();
    ++rounds;
    BOOST_CHECK_MESSAGE(c.energy() <= energy * (1 + 1e-12),
                        "round " << rounds << " has raised the energy from " << energy << " to " << c.energy());
    BOOST_CHECK_EQUAL(changed, c.report().moves != moves);
    energy = c.energy();
    moves = c.report().moves;
    if (rounds == 1 || rounds % 16 == 0) {
      const Labels labels = test::labels_in(c, p.mesh);
      check_close(energy, p.energy(labels), 1e-9, "energy in between");
      BOOST_CHECK_EQUAL(reference::fault_of_clustering(p.m, labels), "");
    }
  }
  BOOST_CHECK_EQUAL(c.report().rounds, rounds);
}

template <class Clustering, class Problem>
void check_minimized(Clustering& c, const Problem& p)
{
  BOOST_CHECK(c.report().converged);
  BOOST_CHECK(!c.minimize_round()); // and remains so
  const Labels labels = test::labels_in(c, p.mesh);
  BOOST_CHECK_EQUAL(reference::number_of_clusters(labels), p.n);
  BOOST_CHECK_EQUAL(reference::fault_of_clustering(p.m, labels), "");
  BOOST_CHECK(SMC::is_valid_clustering(
    p.mesh, boost::make_function_property_map<Mesh::Face_index>([&](Mesh::Face_index f) { return labels[f]; })));
  check_close(c.energy(), p.energy(labels), 1e-9, "final energy");
  check_boundary_counts(c, p.mesh, p.m, labels);
  check_dual(c, p.m, labels, p.how.min_upright);
}

// The single call gives what the steps give, repeatedly.
template <class Clustering, class Problem>
void check_single_call(Clustering& c, const Problem& p)
{
  for (int i = 0; i < 2; ++i) {
    const auto clusters = get(CGAL::dynamic_face_property_t<std::size_t>(), p.mesh);
    Mesh output, same;
    const auto report = SMC::coarsen_mesh(
      p.mesh, p.n, output,
      SMC::parameters::face_cluster_map(clusters)
        .cluster_weight(p.weight)
        .face_density_map(p.density_map())
        .repair_output(false)
        .vertex_placement(SMC::Centroid_placement())
        .convergence_tolerance(0));
    BOOST_CHECK(test::labels_of(p.mesh, clusters) == test::labels_in(c, p.mesh));
    BOOST_CHECK_EQUAL(report.moves, c.report().moves);
    check_close(report.final_energy, c.energy(), 1e-12, "energies of two ways"); // sums were recomputed in between
    c.extract_dual_mesh(same, SMC::Centroid_placement());
    BOOST_CHECK(same_mesh(output, same));
  }
}

template <class Weight>
void check_clustering(const Soup& input, std::size_t n, const How how = How())
{
  const Problem<Weight> p(input, n, how);
  const Mesh copy = p.mesh;
  const auto parameters =
    SMC::parameters::face_density_map(p.density_map()).repair_output(false);
  SMC::Mwcvd_clustering<Mesh, Weight> by_rounds(p.mesh, parameters), at_once(p.mesh, parameters);
  seed_and_grow(by_rounds, p);
  minimize_round_by_round(by_rounds, p);
  check_minimized(by_rounds, p);
  seed_and_grow(at_once, p);
  at_once.minimize(1000, 0);
  check_minimized(at_once, p);
  if (how.local_minimum)
    check_local_minimum(p.m, test::labels_in(at_once, p.mesh), p.faces, p.densities, p.weight);

  check_single_call(at_once, p);
  // Blocks run several rounds at a time, so single rounds give other clusters.
  const bool is_in_blocks = at_once.state().minimization->rounds_at_a_time() > 1;
  BOOST_CHECK_EQUAL(is_in_blocks, how.in_blocks);
  if (!is_in_blocks)
    check_single_call(by_rounds, p);
  BOOST_CHECK(same_mesh(p.mesh, copy));
}

Soup bumpy(const Soup& s, double amplitude) { return generated::with_noise(s, amplitude); }

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(closed_meshes, Weight, Weights)
{
  using namespace generated;
  How minimum;
  minimum.local_minimum = true;
  check_clustering<Weight>(bumpy(triangle_sphere(4), 0.01), 60, minimum);
  check_clustering<Weight>(triangle_sphere(3), 20, minimum); // many equal energies
  check_clustering<Weight>(triangle_sphere(5), 300);
  check_clustering<Weight>(cube_grid(12), 50, minimum);
  check_clustering<Weight>(partly_triangulated(cube_grid(20)), 100);
  check_clustering<Weight>(dual(bumpy(triangle_sphere(4), 0)), 80);
  check_clustering<Weight>(triangulated(torus(40, 20)), 100, minimum);
  check_clustering<Weight>(plate_with_windows(2, 6), 150);
  check_clustering<Weight>(triangulated(plate_with_windows(5, 4)), 200);
  check_clustering<Weight>(joined(triangle_sphere(3), translated(triangulated(torus(20, 20)), 5, 0, 0)), 60, minimum);
}

// Many clusters.
BOOST_AUTO_TEST_CASE_TEMPLATE(blocks, Weight, Weights)
{
  How in_blocks;
  in_blocks.in_blocks = true;
  check_clustering<Weight>(bumpy(generated::triangle_sphere(5), 0.01), 1000, in_blocks);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(meshes_with_border, Weight, Weights)
{
  using namespace generated;
  How minimum;
  minimum.local_minimum = true;
  check_clustering<Weight>(bumpy(triangulated(grid(20, 15)), 0.05), 40, minimum);
  check_clustering<Weight>(grid(30, 30), 50, minimum);
  check_clustering<Weight>(partly_triangulated(tube(40, 20)), 60, minimum);
  check_clustering<Weight>(bumpy(with_holes(triangle_sphere(4), 12), 0.01), 100, minimum);
  check_clustering<Weight>(with_holes(triangulated(torus(40, 30)), 5), 100);
  check_clustering<Weight>(joined(tube(30, 10), translated(fan(200), 5, 0, 0)), 50);
}

// Energies of a flat mesh by hand.
BOOST_AUTO_TEST_CASE(energy_by_hand)
{
  const Mesh mesh = test::to_mesh(generated::grid(4, 2));
  // Columns 0 and 1 upper and lower half, and the rest: 3 clusters of 2, 2 and 4 unit squares around a vertex.
  const Labels labels{0, 1, 0, 1, 2, 2, 2, 2};
  const auto map = boost::make_function_property_map<Mesh::Face_index>([&](Mesh::Face_index f) { return labels[f]; });
  SMC::Mwcvd_clustering<Mesh, SMC::Uniform_weight> uniform(mesh);
  uniform.set_clusters(map);
  // Two squares: 2 * 1/4. Four: 4 * 1/2.
  BOOST_CHECK_CLOSE(uniform.energy(), 0.5 + 0.5 + 2, 1e-10);
  SMC::Mwcvd_clustering<Mesh, SMC::Weighted_area_weight> area(mesh);
  area.set_clusters(map);
  BOOST_CHECK_CLOSE(area.energy(), 2 * 0.5 + 2 * 0.5 + 4 * 2, 1e-10);
  SMC::Mwcvd_clustering<Mesh, SMC::Exact_maximum_density_weight> exact(mesh);
  exact.set_clusters(map);
  BOOST_CHECK_CLOSE(exact.energy(), 3, 1e-10);
  SMC::Mwcvd_clustering<Mesh, SMC::Maximum_density_weight> norm(mesh);
  norm.set_clusters(map);
  BOOST_CHECK_CLOSE(norm.energy(), std::pow(2, 0.1) + std::pow(4, 0.1) * 2, 1e-10);
  SMC::Mwcvd_clustering<Mesh, SMC::Density_variance_weight> variance(mesh);
  variance.set_clusters(map);
  BOOST_CHECK_CLOSE(variance.energy(), 3, 1e-10);
  BOOST_CHECK_EQUAL(variance.number_of_clusters(), 3u);
}

BOOST_AUTO_TEST_CASE(no_iterations_are_seeds_and_growth)
{
  const Mesh mesh = test::to_mesh(generated::with_noise(generated::triangle_sphere(4), 0.02));
  const auto clusters = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  Mesh output;
  const auto report =
    SMC::coarsen_mesh(mesh, 70, output, SMC::parameters::number_of_iterations(0).face_cluster_map(clusters));
  BOOST_CHECK_EQUAL(report.rounds, 0u);
  BOOST_CHECK_EQUAL(report.moves, 0u);
  BOOST_CHECK(!report.converged);
  BOOST_CHECK_EQUAL(report.initial_energy, report.final_energy);
  SMC::Mwcvd_clustering<Mesh> c(mesh);
  c.seed(70);
  c.grow();
  BOOST_CHECK(test::labels_of(mesh, clusters) == test::labels_in(c, mesh));
  // Each seed lies in its own cluster.
  std::vector<Mesh::Face_index> seeds;
  c.seeds(std::back_inserter(seeds));
  BOOST_REQUIRE_EQUAL(seeds.size(), 70u);
  for (std::size_t i = 0; i < seeds.size(); ++i)
    BOOST_CHECK_EQUAL(c.cluster(seeds[i]), i);

  const auto limited = SMC::coarsen_mesh(mesh, 70, output, SMC::parameters::number_of_iterations(3));
  BOOST_CHECK_EQUAL(limited.rounds, 3u);
  BOOST_CHECK_LT(limited.final_energy, limited.initial_energy);
}

// The minimization ends with the first round that lowers the energy by at most the tolerance.
BOOST_AUTO_TEST_CASE(convergence_tolerance)
{
  typedef SMC::Mwcvd_clustering<Mesh> Clustering;
  const Mesh mesh = test::to_mesh(generated::with_noise(generated::triangle_sphere(4), 0.02));
  const auto begin = [](Clustering& c) {
    c.seed(70);
    c.grow();
  };
  for (const double tolerance : {1., 0.1, 0.01, 1e-3, 1e-4, 0.}) {
    Clustering by_hand(mesh), c(mesh);
    begin(by_hand);
    double before;
    do {
      before = by_hand.energy();
      by_hand.minimize_round();
    } while (before - by_hand.energy() > tolerance * before);
    begin(c);
    c.minimize(1000, tolerance);
    BOOST_CHECK(c.report().converged);
    BOOST_CHECK_EQUAL(c.report().rounds, by_hand.report().rounds);
    BOOST_CHECK_EQUAL(c.energy(), by_hand.energy());
    BOOST_CHECK_EQUAL(c.report().rounds == 1, tolerance == 1);
    const Labels labels = test::labels_in(c, mesh);
    BOOST_CHECK(labels == test::labels_in(by_hand, mesh));

    const auto clusters = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
    Mesh output;
    const auto report = SMC::coarsen_mesh(
      mesh, 70, output, SMC::parameters::convergence_tolerance(tolerance).face_cluster_map(clusters).error_feedback(0));
    BOOST_CHECK_EQUAL(report.rounds, c.report().rounds);
    BOOST_CHECK(test::labels_of(mesh, clusters) == labels);
    if (tolerance == SMC::Coarsening_defaults::convergence_tolerance) {
      SMC::coarsen_mesh(mesh, 70, output, SMC::parameters::face_cluster_map(clusters).error_feedback(0));
      BOOST_CHECK(test::labels_of(mesh, clusters) == labels);
    }
    // With no more rounds than before, no round gains little.
    begin(c);
    c.minimize(by_hand.report().rounds - 1, tolerance);
    BOOST_CHECK(!c.report().converged);
  }
  Clustering c(mesh);
  begin(c);
  for (const double tolerance : {-1e-3, std::numeric_limits<double>::quiet_NaN()}) {
    BOOST_CHECK_THROW(c.minimize(10, tolerance), SMC::Invalid_input);
    BOOST_CHECK_THROW(c.seed_from_number_of_faces(20, 10, tolerance), SMC::Invalid_input);
  }
  BOOST_CHECK_EQUAL(c.report().rounds, 0u);
}

BOOST_AUTO_TEST_CASE(levels)
{
  const Mesh mesh = test::to_mesh(generated::with_noise(generated::triangulated(generated::cube_grid(20)), 0.005));
  const Reference_mesh m(test::to_soup(mesh));
  for (const std::size_t level : {2, 4, 7}) {
    std::vector<Mesh::Face_index> seeds, found;
    SMC::neighborhood_seeds(mesh, level, std::back_inserter(seeds));
    SMC::Mwcvd_clustering<Mesh> c(mesh);
    BOOST_CHECK_EQUAL(c.seed_from_level(level), seeds.size());
    c.seeds(std::back_inserter(found));
    BOOST_CHECK(found == seeds);
    const auto clusters = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
    Mesh output;
    const auto report = SMC::coarsen_mesh(
      mesh, output, SMC::parameters::neighborhood_level(level).face_cluster_map(clusters).number_of_iterations(5));
    BOOST_CHECK_EQUAL(report.level, level);
    BOOST_CHECK_EQUAL(report.seeds, seeds.size());
    BOOST_CHECK_EQUAL(report.clusters, seeds.size());
    BOOST_CHECK_EQUAL(output.number_of_vertices(), seeds.size());
    BOOST_CHECK_EQUAL(reference::fault_of_clustering(m, test::labels_of(mesh, clusters)), "");
  }
}

// A part of the vertices that belong to faces.
BOOST_AUTO_TEST_CASE(ratios)
{
  Mesh mesh = test::to_mesh(generated::triangle_sphere(4));
  const std::size_t vertices = mesh.number_of_vertices();
  mesh.add_vertex(test::Point(7, 7, 7));
  const auto number = [&mesh](double ratio) {
    Mesh output;
    SMC::coarsen_mesh(mesh, output, SMC::parameters::vertex_ratio(ratio).number_of_iterations(0));
    return output.number_of_vertices();
  };
  BOOST_CHECK_EQUAL(number(0.1), std::size_t(std::round(0.1 * double(vertices))));
  BOOST_CHECK_EQUAL(number(1), vertices);
  BOOST_CHECK_EQUAL(number(4. / double(vertices)), 4u);
  for (const double wrong : {0., -0.1, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    BOOST_CHECK_THROW(number(wrong), SMC::Invalid_input);
  BOOST_CHECK_THROW(number(1.1), SMC::Unreachable_number_of_vertices);
  BOOST_CHECK_THROW(number(1e-9), SMC::Unreachable_number_of_vertices);

  Mesh half, same;
  SMC::coarsen_mesh(mesh, vertices / 2, half);
  SMC::coarsen_mesh(mesh, same, SMC::parameters::vertex_ratio(double(vertices / 2) / double(vertices)));
  BOOST_CHECK(same_mesh(half, same));
}

// Library, tool and viewer have the same defaults.
BOOST_AUTO_TEST_CASE(defaults)
{
  const Mesh mesh = test::to_mesh(generated::with_noise(generated::triangulated(generated::torus(40, 30)), 0.01));
  for (const std::size_t n : {100, 120}) { // clusters of faces, and of cells
    Mesh by_default, explicitly, by_hand;
    SMC::coarsen_mesh(mesh, n, by_default);
    SMC::coarsen_mesh(mesh, n, explicitly,
                      SMC::parameters::cluster_weight(SMC::Weighted_area_weight())
                        .maximum_density(10.)
                        .vertex_placement(SMC::Fitted_placement())
                        .error_feedback(8)
                        .repair_output(true)
                        .number_of_iterations(1000)
                        .convergence_tolerance(1e-3)
                        .feature_angle(180.));
    BOOST_CHECK(same_mesh(by_default, explicitly));
    SMC::Mwcvd_clustering<Mesh> clustering(mesh);
    clustering.seed_faces_or_cells(n);
    clustering.grow();
    clustering.minimize();
    clustering.extract_embedded_dual_mesh(by_hand);
    BOOST_CHECK(same_mesh(by_default, by_hand));
  }
}

namespace {

// The check of section 7 as printed, at the edge `c` of its face, across which the cluster `curr` lies.
bool paper_allows(const Mesh& mesh, const Labels& labels, Mesh::Halfedge_index c)
{
  const std::size_t curr = labels[mesh.face(mesh.opposite(c))], own = labels[mesh.face(c)];
  const auto n = mesh.next(c), p = mesh.prev(c);
  const auto label_across = [&](Mesh::Halfedge_index h) {
    return mesh.is_border(mesh.opposite(h)) ? std::size_t(-1) : labels[mesh.face(mesh.opposite(h))];
  };
  std::size_t count = 0;
  bool has_boundary_edge_of_curr = false;
  for (const auto h : mesh.halfedges_around_target(mesh.halfedge(mesh.target(n)))) {
    count += mesh.is_border(mesh.edge(h)) || labels[mesh.face(h)] != labels[mesh.face(mesh.opposite(h))];
    has_boundary_edge_of_curr = has_boundary_edge_of_curr || (!mesh.is_border(h) && labels[mesh.face(h)] == curr);
  }
  return count == 0 || (label_across(n) == curr) != (label_across(p) == curr) ||
         ((label_across(n) != own) != (label_across(p) != own) && !has_boundary_edge_of_curr);
}

} // namespace

// The method of the paper: the check of boundary-edge counts, merging by area, centroids on borders as elsewhere.
BOOST_AUTO_TEST_CASE(paper)
{
  const Soup soup = generated::with_noise(generated::triangulated(generated::grid(30, 30)), 0.2);
  const Mesh mesh = test::to_mesh(soup);
  const Reference_mesh m(test::to_soup(mesh));
  const SMC::Maximum_density_weight weight;
  const auto clusters = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  Mesh output;
  const auto report = SMC::coarsen_mesh(mesh, 60, output, SMC::parameters::paper(weight).face_cluster_map(clusters));
  const Labels labels = test::labels_of(mesh, clusters);
  BOOST_CHECK(report.converged);
  BOOST_CHECK_GT(report.refused_by_boundary_counts, 0u);
  BOOST_CHECK_EQUAL(report.exchanged_vertices, 0u);
  BOOST_CHECK_EQUAL(reference::fault_of_clustering(m, labels), "");
  const std::vector<reference::Face> faces = reference::faces_of(test::to_soup(mesh));
  const std::vector<double> densities = reference::densities(m, 50);
  check_close(report.final_energy, reference::energy(faces, densities, labels, weight), 1e-9, "energy");
  std::vector<double> mass(60, 0), x(60, 0), y(60, 0);
  for (const auto f : mesh.faces()) {
    std::vector<test::Point> q;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      q.push_back(mesh.point(v));
    const double a = densities[f] * std::sqrt(CGAL::squared_area(q[0], q[1], q[2]));
    mass[labels[f]] += a;
    x[labels[f]] += a * CGAL::centroid(q[0], q[1], q[2]).x();
    y[labels[f]] += a * CGAL::centroid(q[0], q[1], q[2]).y();
  }
  for (const auto v : output.vertices()) { // also those on the border
    BOOST_CHECK_SMALL(output.point(v).x() - x[v] / mass[v], 1e-9);
    BOOST_CHECK_SMALL(output.point(v).y() - y[v] / mass[v], 1e-9);
  }
  BOOST_CHECK_EQUAL(SMC::coarsen_mesh(mesh, 60, output).refused_by_boundary_counts, 0u);

  // Not a single edge, of the triangles that the minimization goes over, is answered in another way.
  SMC::Mwcvd_clustering<Mesh, SMC::Maximum_density_weight> c(mesh, SMC::parameters::paper_clustering(weight));
  c.seed(60);
  c.grow();
  const Labels grown = test::labels_in(c, mesh);
  SMC::internal::Cluster_labels internal_labels = *c.state().labels;
  const SMC::internal::Valid_moves moves(internal_labels, nullptr);
  std::size_t allowed = 0, refused = 0;
  for (const auto h : mesh.halfedges())
    if (!mesh.is_border(mesh.edge(h)) && grown[mesh.face(h)] != grown[mesh.face(mesh.opposite(h))]) {
      const bool is_allowed = paper_allows(mesh, grown, h);
      (is_allowed ? allowed : refused)++;
      BOOST_CHECK_EQUAL(moves.boundary_counts_allow(SMC::internal::Index(mesh.face(h)),
                                                    SMC::internal::Index(grown[mesh.face(mesh.opposite(h))])),
                        is_allowed);
    }
  BOOST_CHECK_GT(allowed, 100u);
  BOOST_CHECK_GT(refused, 10u);
}

// By area, densities do not matter to the reduction of seeds; by mass they do.
BOOST_AUTO_TEST_CASE(merging_by_area)
{
  const Mesh mesh = test::to_mesh(generated::with_noise(generated::triangle_sphere(4), 0.02));
  const auto labels_with = [&mesh](double range, bool by_area) {
    const auto density = boost::make_function_property_map<Mesh::Face_index, double>(
      [&](Mesh::Face_index f) { return mesh.point(mesh.target(mesh.halfedge(f))).z() > 0 ? range : 1; });
    SMC::Mwcvd_clustering<Mesh> c(mesh, SMC::parameters::face_density_map(density).paper_rules(by_area));
    c.seed(70);
    c.grow();
    return test::labels_in(c, mesh);
  };
  BOOST_CHECK(labels_with(1, true) == labels_with(30, true));
  BOOST_CHECK(labels_with(1, false) != labels_with(30, false));
}

// Section 6 of the paper: seeds of a given level, merged to a number; the new seeds lie in their clusters.
BOOST_AUTO_TEST_CASE(level_and_number)
{
  const Mesh mesh = test::to_mesh(generated::with_noise(generated::triangle_sphere(4), 0.02));
  SMC::Mwcvd_clustering<Mesh> c(mesh, SMC::parameters::paper_rules(true));
  const std::size_t seeds = c.seed_from_level(2);
  BOOST_CHECK_EQUAL(c.seed_from_level(2, 40), seeds);
  std::vector<Mesh::Face_index> before, after;
  c.seeds(std::back_inserter(before));
  c.grow();
  BOOST_CHECK_EQUAL(c.report().level, 2u);
  BOOST_CHECK_EQUAL(c.number_of_clusters(), 40u);
  BOOST_CHECK_EQUAL(c.report().merges, seeds + c.report().splits - 40);
  c.seeds(std::back_inserter(after));
  BOOST_REQUIRE_EQUAL(after.size(), 40u);
  std::size_t moved = 0;
  for (std::size_t x = 0; x < after.size(); ++x) {
    BOOST_CHECK_EQUAL(c.cluster(after[x]), x);
    moved += std::find(before.begin(), before.end(), after[x]) == before.end();
  }
  BOOST_CHECK_GT(moved, 20u); // most clusters are merged from three
  Mesh output;
  const auto report = SMC::coarsen_mesh(mesh, 40, output, SMC::parameters::neighborhood_level(2));
  BOOST_CHECK_EQUAL(report.level, 2u);
  BOOST_CHECK_EQUAL(report.seeds, seeds);
  BOOST_CHECK_EQUAL(output.number_of_vertices(), 40u);
  BOOST_CHECK_THROW(c.seed_from_level(2, seeds + 1), SMC::Unreachable_number_of_vertices);
  BOOST_CHECK_THROW(c.seed_from_level(2, 0), SMC::Invalid_input);
  BOOST_CHECK_THROW(c.seed_from_level(2, 3), SMC::Unreachable_number_of_vertices);
}

// With the paper's check, rounds run over the whole mesh, however many clusters there are: minimize() equals single rounds.
BOOST_AUTO_TEST_CASE(rounds_of_the_paper)
{
  const Mesh mesh = test::to_mesh(generated::with_noise(generated::triangulated(generated::grid(90, 90)), 0.2));
  const SMC::Uniform_weight weight;
  SMC::Mwcvd_clustering<Mesh, SMC::Uniform_weight> at_once(mesh, SMC::parameters::paper_clustering(weight, 50)),
    single(mesh, SMC::parameters::paper_clustering(weight, 50));
  for (auto* c : {&at_once, &single}) {
    c->seed(900);
    c->grow();
  }
  at_once.minimize(SMC::Coarsening_defaults::number_of_iterations, 0);
  while (single.minimize_round())
    ;
  BOOST_CHECK_EQUAL(at_once.report().rounds, single.report().rounds);
  BOOST_CHECK(test::labels_in(at_once, mesh) == test::labels_in(single, mesh));
}

// The reports of the clusters agree with sums from their definitions.
BOOST_AUTO_TEST_CASE_TEMPLATE(reports_of_clusters, Weight, Weights)
{
  const Problem<Weight> p(generated::with_noise(generated::triangulated(generated::grid(20, 20)), 0.2), 30, How());
  SMC::Mwcvd_clustering<Mesh, Weight> c(p.mesh, SMC::parameters::face_density_map(p.density_map()));
  BOOST_CHECK_THROW(c.cluster_reports(), std::logic_error);
  c.seed(p.n);
  c.grow();
  c.minimize_round();
  const Labels labels = test::labels_in(c, p.mesh);
  const std::vector<reference::Real> energies = reference::energies(p.faces, p.densities, labels, p.weight);
  const std::vector<SMC::Cluster_report> reports = c.cluster_reports();
  BOOST_REQUIRE_EQUAL(reports.size(), p.n);
  double sum = 0;
  for (std::size_t x = 0; x < p.n; ++x) {
    std::vector<reference::Real> densities;
    reference::Real mass = 0;
    reference::Vector moment{{0, 0, 0}};
    for (std::size_t f = 0; f < labels.size(); ++f)
      if (labels[f] == x) {
        densities.push_back(p.densities[f]);
        mass += p.densities[f] * p.faces[f].area;
        for (int k = 0; k < 3; ++k)
          moment[k] += p.densities[f] * p.faces[f].area * p.faces[f].centroid[k];
      }
    BOOST_CHECK_EQUAL(reports[x].faces, densities.size());
    check_close(reports[x].weight, double(reference::weight(p.weight, densities, mass)), 1e-9, "weight");
    check_close(reports[x].energy, double(energies[x]), 1e-9, "energy of a cluster");
    for (int k = 0; k < 3; ++k)
      BOOST_CHECK_SMALL(reports[x].centroid[k] - double(moment[k] / mass), 1e-9);
    sum += reports[x].energy;
  }
  check_close(sum, c.energy(), 1e-9, "sum of the energies");
}

// An energy without a weight.
BOOST_AUTO_TEST_CASE(reports_of_other_clusters)
{
  const Mesh mesh = test::to_mesh(generated::triangle_sphere(2));
  SMC::Mwcvd_clustering<Mesh, SMC::Quadric_energy> c(mesh);
  c.seed(10);
  c.grow();
  std::size_t number = 0;
  for (const SMC::Cluster_report& x : c.cluster_reports()) {
    BOOST_CHECK_EQUAL(x.weight, 1);
    number += x.faces;
  }
  BOOST_CHECK_EQUAL(number, mesh.number_of_faces());
}

// The answers of the two checks agree with brute force, at each face and for each cluster, and change nothing.
BOOST_AUTO_TEST_CASE(answers_of_the_checks)
{
  const Mesh mesh = test::to_mesh(generated::with_noise(generated::triangulated(generated::grid(12, 12)), 0.2));
  const Reference_mesh m(test::to_soup(mesh));
  SMC::Mwcvd_clustering<Mesh> exact(mesh), both(mesh, SMC::parameters::paper_rules(true));
  const Mesh::Face_index first(0);
  BOOST_CHECK_THROW(exact.may_move(first, 0), std::logic_error);
  exact.seed(14);
  exact.grow();
  const Labels labels = test::labels_in(exact, mesh);
  both.set_clusters(boost::make_function_property_map<Mesh::Face_index>([&](Mesh::Face_index f) { return labels[f]; }));
  std::size_t valid = 0, refused_by_paper = 0;
  for (const auto h : mesh.halfedges()) {
    if (mesh.is_border(h) || mesh.is_border(mesh.opposite(h)))
      continue;
    const auto f = mesh.face(h);
    const std::size_t to = labels[mesh.face(mesh.opposite(h))];
    if (to == labels[f])
      continue;
    Labels moved = labels;
    moved[f] = to;
    const bool is_valid = reference::number_of_clusters(moved) == 14 && reference::fault_of_clustering(m, moved).empty();
    const bool is_allowed = paper_allows(mesh, labels, h);
    BOOST_CHECK_EQUAL(exact.may_move(f, to), is_valid);
    BOOST_CHECK_EQUAL(exact.boundary_counts_allow(f, to), is_allowed);
    BOOST_CHECK_EQUAL(both.may_move(f, to), is_valid && is_allowed);
    valid += is_valid;
    refused_by_paper += !is_allowed;
  }
  BOOST_CHECK_GT(valid, 50u);
  BOOST_CHECK_GT(refused_by_paper, 0u);
  for (std::size_t x = 0; x < 14; ++x)
    BOOST_CHECK(x != labels[first] || !exact.may_move(first, x));
  BOOST_CHECK(test::labels_in(exact, mesh) == labels);
  check_boundary_counts(exact, mesh, m, labels);
  BOOST_CHECK_THROW(exact.may_move(first, 14), SMC::Invalid_input);
  SMC::Mwcvd_clustering<Mesh> with_features(mesh, SMC::parameters::feature_angle(20.));
  with_features.seed(100);
  with_features.grow();
  BOOST_CHECK_THROW(with_features.may_move(first, 0), SMC::Invalid_input);
}

BOOST_AUTO_TEST_CASE(start_from_clusters)
{
  const Mesh mesh = test::to_mesh(generated::with_noise(generated::triangle_sphere(4), 0.02));
  const auto grown = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  const auto direct = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  Mesh output, again;
  SMC::coarsen_mesh(mesh, 50, output, SMC::parameters::number_of_iterations(0).face_cluster_map(grown));
  const auto first =
    SMC::coarsen_mesh(mesh, 50, output, SMC::parameters::face_cluster_map(direct).convergence_tolerance(0).error_feedback(0));
  SMC::Mwcvd_clustering<Mesh> second(mesh);
  second.set_clusters(grown);
  second.minimize(SMC::Coarsening_defaults::number_of_iterations, 0);
  second.extract_embedded_dual_mesh(again);
  BOOST_CHECK(test::labels_in(second, mesh) == test::labels_of(mesh, direct));
  BOOST_CHECK(test::labels_in(second, mesh) != test::labels_of(mesh, grown));
  BOOST_CHECK_EQUAL(first.final_energy, second.report().final_energy);
  BOOST_CHECK(same_mesh(output, again));
  // Converged clusters do not change.
  SMC::Mwcvd_clustering<Mesh> third(mesh);
  third.set_clusters(direct);
  third.minimize();
  third.extract_embedded_dual_mesh(again);
  BOOST_CHECK_EQUAL(third.report().moves, 0u);
  BOOST_CHECK_EQUAL(third.report().rounds, 1u);
  BOOST_CHECK_EQUAL(third.report().clusters, 50u);
  BOOST_CHECK(same_mesh(output, again));
}

BOOST_AUTO_TEST_SUITE(fandisk, *utf::precondition(test::If_found{models::fandisk}))
BOOST_AUTO_TEST_CASE_TEMPLATE(weights, Weight, Weights)
{
  check_clustering<Weight>(test::read_soup(models::fandisk), 527);
}
BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(bunny, *utf::precondition(test::If_found{models::bunny}))
BOOST_AUTO_TEST_CASE_TEMPLATE(weights, Weight, Weights)
{
  check_clustering<Weight>(test::read_soup(models::bunny), 594);
}
BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(horse, *utf::precondition(test::If_found{models::horse}))
BOOST_AUTO_TEST_CASE_TEMPLATE(weights, Weight, Weights)
{
  How in_blocks;
  in_blocks.in_blocks = true;
  check_clustering<Weight>(test::read_soup(models::horse), 1579, in_blocks);
}
BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
