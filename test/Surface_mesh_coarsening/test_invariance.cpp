// SPDX-License-Identifier: GPL-3.0-or-later
//
// The effects of scaling, translation and rotation on a clustering.

#include "support/face_graphs.h"
#include "support/reference_energy.h"

#include "models.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/mpl/list.hpp>

#include <cmath>
#include <string>

BOOST_AUTO_TEST_SUITE(test_invariance)

namespace SMC = CGAL::Surface_mesh_coarsening;
namespace utf = boost::unit_test;
using generated::Soup;
using reference::Labels;
using test::Mesh;

namespace {

typedef boost::mpl::list<SMC::Uniform_weight, SMC::Weighted_area_weight, SMC::Maximum_density_weight,
                         SMC::Density_variance_weight>
  Weights;

template <class Weight>
struct Clusters
{
  Clusters(const Soup& soup, std::size_t n) : mesh(test::to_mesh(soup)), clustering(mesh)
  {
    clustering.seed(n);
    clustering.grow();
    clustering.minimize();
    labels = test::labels_in(clustering, mesh);
  }

  Mesh mesh;
  SMC::Mwcvd_clustering<Mesh, Weight> clustering;
  Labels labels;
};

double diameter(const Soup& s)
{
  generated::Point low = s.points.front(), high = low;
  for (const generated::Point& p : s.points)
    for (int k = 0; k < 3; ++k) {
      low[k] = (std::min)(low[k], p[k]);
      high[k] = (std::max)(high[k], p[k]);
    }
  return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

// `power`: the power of the unit of length in the energy.
template <class Weight>
constexpr int power()
{
  return std::is_same<Weight, SMC::Weighted_area_weight>::value ? 6 : 4;
}

template <class Weight>
void check_scaling(const Soup& soup, std::size_t n, Clusters<Weight>& expected)
{
  Mesh output;
  expected.clustering.extract_dual_mesh(output, SMC::Centroid_placement());
  const Soup positions = test::to_soup(output);
  for (const int exponent : {-300, -40, -1, 20, 300}) {
    const double factor = std::ldexp(1., exponent);
    Clusters<Weight> c(generated::scaled(soup, factor), n);
    BOOST_CHECK_MESSAGE(c.labels == expected.labels, "scaling by 2^" << exponent << " has changed the labels");
    BOOST_CHECK_EQUAL(c.clustering.report().moves, expected.clustering.report().moves);
    if (std::abs(exponent) < 100)
      BOOST_CHECK_EQUAL(c.clustering.energy(), std::ldexp(expected.clustering.energy(), power<Weight>() * exponent));
    c.clustering.extract_dual_mesh(output, SMC::Centroid_placement());
    const Soup scaled = generated::scaled(positions, factor);
    BOOST_CHECK_MESSAGE(test::to_soup(output).points == scaled.points,
                        "scaling by 2^" << exponent << " has not scaled the positions");
  }
}

template <class Weight>
void check_relative(const Clusters<Weight>& c, Clusters<Weight>& expected, const std::string& what)
{
  const reference::Reference_mesh m(test::to_soup(c.mesh));
  BOOST_CHECK_EQUAL(reference::fault_of_clustering(m, c.labels), "");
  BOOST_CHECK_EQUAL(reference::number_of_clusters(c.labels), expected.clustering.number_of_clusters());
  const double energy = c.clustering.energy(), change = energy / expected.clustering.energy() - 1;
  std::size_t other = 0;
  for (std::size_t f = 0; f < c.labels.size(); ++f)
    other += c.labels[f] != expected.labels[f];
  BOOST_TEST_MESSAGE(what << ", " << typeid(Weight).name() << ": energy changes by " << change << ", " << other
                          << " labels of " << c.labels.size() << " differ");
  BOOST_CHECK_MESSAGE(std::abs(change) <= 1e-6, what << " changes the energy by " << change);
}

template <class Weight>
void check_scaling_and_translation(const Soup& soup, std::size_t n, Clusters<Weight>& expected)
{
  check_scaling(soup, n, expected);
  const double far = 1e6 * diameter(soup);
  check_relative(Clusters<Weight>(generated::translated(soup, far, -far, 0.5 * far), n), expected, "translation");
}

// Many clusters are divided into blocks, by planes that are not rotated with the mesh.
template <class Weight>
bool is_divided(const Clusters<Weight>& c)
{
  return c.clustering.state().minimization->rounds_at_a_time() > 1;
}

template <class Weight>
void check_invariance(const Soup& soup, std::size_t n)
{
  Clusters<Weight> expected(soup, n);
  BOOST_REQUIRE(!is_divided(expected));
  check_scaling_and_translation(soup, n, expected);
  check_relative(Clusters<Weight>(generated::rotated(soup, 0.7, 1.1), n), expected, "rotation");
}

// Without rotation.
template <class Weight>
void check_invariance_of_blocks(const Soup& soup, std::size_t n)
{
  Clusters<Weight> expected(soup, n);
  BOOST_REQUIRE(is_divided(expected));
  check_scaling_and_translation(soup, n, expected);
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(generated_meshes, Weight, Weights)
{
  check_invariance<Weight>(generated::with_noise(generated::triangle_sphere(4), 0.02), 60);
  check_invariance<Weight>(generated::with_noise(generated::triangulated(generated::grid(30, 30)), 0.1), 60);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(cube, Weight, Weights)
{
  check_invariance<Weight>(generated::triangulated(generated::cube_grid(50)), 274);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(blocks, Weight, Weights)
{
  check_invariance_of_blocks<Weight>(generated::with_noise(generated::triangle_sphere(5), 0.01), 1000);
}

// Sizes at the ends of the range of double.
BOOST_AUTO_TEST_CASE_TEMPLATE(extreme_sizes, Weight, Weights)
{
  const Soup soup = generated::with_noise(generated::triangle_sphere(4), 0.02);
  for (const double factor : {1e300, 1e307, 1e-300, 1e-307}) {
    Clusters<Weight> c(generated::scaled(soup, factor), 60);
    const reference::Reference_mesh m(soup);
    BOOST_CHECK_EQUAL(reference::fault_of_clustering(m, c.labels), "");
    BOOST_CHECK(std::isfinite(c.clustering.energy()));
    BOOST_CHECK_GT(c.clustering.energy(), 0);
    BOOST_CHECK(c.clustering.report().converged);
    BOOST_CHECK_GT(c.clustering.report().moves, 0u);
    Mesh output;
    c.clustering.extract_dual_mesh(output, SMC::Centroid_placement());
    for (const auto v : vertices(output)) {
      const test::Point p = output.point(v);
      const double length = std::hypot(p.x() / factor, p.y() / factor, p.z() / factor);
      BOOST_CHECK(length > 0.5 && length < 1.5);
    }
  }
}

BOOST_AUTO_TEST_SUITE(fandisk, *utf::precondition(test::If_found{models::fandisk}))
BOOST_AUTO_TEST_CASE_TEMPLATE(weights, Weight, Weights)
{
  check_invariance<Weight>(test::read_soup(models::fandisk), 527);
}
BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(horse, *utf::precondition(test::If_found{models::horse}))
BOOST_AUTO_TEST_CASE_TEMPLATE(weights, Weight, Weights)
{
  const Soup soup = test::read_soup(models::horse);
  check_invariance<Weight>(soup, 700);
  check_invariance_of_blocks<Weight>(soup, 1579);
}
BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
