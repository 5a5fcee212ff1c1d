// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares the weights with formulas (9) to (13) of the paper while random faces join and leave.

#include "support/face_graphs.h"
#include "support/generate_meshes.h"
#include "support/reference_energy.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Minimization_state.h>

#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>

#include <boost/mpl/list.hpp>
#include <boost/mpl/push_front.hpp>
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_cluster_weights)

namespace SMC = CGAL::Surface_mesh_coarsening;

namespace {

// A user's weight, twice the mass, which judges moves by their moments.
struct Judging_weight : SMC::Additive_cluster_weight<Judging_weight>
{
  struct Face_data {};
  struct Cluster_data {};
  Face_data face_data(double, double) const { return {}; }
  void add(Cluster_data&, const Face_data&) const {}
  void remove(Cluster_data&, const Face_data&) const {}
  double weight(const Cluster_data&, double mass, std::size_t) const { return 2 * mass; }
  bool cannot_gain(const SMC::Trial_move& t) const
  {
    ++number_of_judgements;
    return t.source_inertia + t.source_mass * t.source_squared_distance <=
           t.target_inertia + t.target_mass * t.target_squared_distance;
  }
  static std::size_t number_of_judgements;
};
std::size_t Judging_weight::number_of_judgements = 0;

// The same weight without a judgement, and with bounds.
struct Silent_weight : SMC::Additive_cluster_weight<Silent_weight>
{
  struct Face_data
  {
    double mass;
  };
  struct Cluster_data {};
  Face_data face_data(double density, double area) const { return {density * area}; }
  void add(Cluster_data&, const Face_data&) const {}
  void remove(Cluster_data&, const Face_data&) const {}
  double weight(const Cluster_data&, double mass, std::size_t) const { return 2 * mass; }
};
struct Bounding_weight : Silent_weight
{
  double min_weight_with(const Cluster_data&, const Face_data& face, double weight) const
  {
    ++number_of_bounds;
    return (weight + 2 * face.mass) * (1 - 1e-12);
  }
  double min_weight_without(const Cluster_data&, const Face_data& face, double weight) const
  {
    return (weight - 2 * face.mass) * (1 - 1e-12);
  }
  double weight_with(const Cluster_data& data, const Face_data&, double mass, std::size_t faces) const
  {
    return weight(data, mass, faces);
  }
  double weight_without(const Cluster_data& data, const Face_data&, double mass, std::size_t faces) const
  {
    return weight(data, mass, faces);
  }
  static std::size_t number_of_bounds;
};
std::size_t Bounding_weight::number_of_bounds = 0;

typedef boost::mpl::list<SMC::Uniform_weight, SMC::Weighted_area_weight, SMC::Maximum_density_weight,
                         SMC::Exact_maximum_density_weight, SMC::Density_variance_weight>
  Weights;

typedef boost::mpl::push_front<boost::mpl::push_front<boost::mpl::push_front<Weights, Judging_weight>::type, Silent_weight>::type,
                               Bounding_weight>::type Weights_and_own;

struct Cluster_face
{
  double density, area;
};

// A cluster with the data of a weight, and the list of its faces.
template <class Weight>
struct Cluster
{
  Weight weight;
  typename Weight::Cluster_data data{};
  std::vector<Cluster_face> faces;
  double mass = 0;

  void add(const Cluster_face& f)
  {
    weight.add(data, weight.face_data(f.density, f.area));
    mass += f.density * f.area;
    faces.push_back(f);
  }
  void remove(std::size_t i)
  {
    weight.remove(data, weight.face_data(faces[i].density, faces[i].area));
    mass -= faces[i].density * faces[i].area;
    faces.erase(faces.begin() + std::ptrdiff_t(i));
  }
  double value() const { return weight.weight(data, mass, faces.size()); }
};

template <class Weight>
double expected(const Weight& w, const std::vector<Cluster_face>& faces)
{
  std::vector<reference::Real> densities;
  reference::Real mass = 0;
  for (const Cluster_face& f : faces) {
    densities.push_back(f.density);
    mass += reference::Real(f.density) * f.area;
  }
  return double(reference::weight(w, densities, mass));
}

void check_near(double a, double b, double tolerance)
{
  BOOST_CHECK_MESSAGE(std::abs(a - b) <= tolerance * std::abs(b), a << " is not " << b);
}

double uniform(std::mt19937& engine) { return (double(engine()) + 0.5) / 4294967296.; }

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(random_adds_and_removes, Weight, Weights)
{
  std::mt19937 engine(1);
  for (const double highest : {1., 3., 20., 50.}) {
    Cluster<Weight> c;
    for (int step = 0; step < 3000; ++step) {
      const Cluster_face f{1 + (highest - 1) * std::pow(uniform(engine), 3), 0.1 + uniform(engine)};
      if (c.faces.size() < 2 || (c.faces.size() < 200 && engine() % 2 == 0)) {
        const double with = c.weight.weight_with(c.data, c.weight.face_data(f.density, f.area),
                                                 c.mass + f.density * f.area, c.faces.size() + 1);
        c.add(f);
        BOOST_CHECK_EQUAL(with, c.value());
      } else {
        const std::size_t i = engine() % c.faces.size();
        const Cluster_face g = c.faces[i];
        const double without = c.weight.weight_without(c.data, c.weight.face_data(g.density, g.area),
                                                       c.mass - g.density * g.area, c.faces.size() - 1);
        c.remove(i);
        BOOST_CHECK_EQUAL(without, c.value());
      }
      // The sum of squared deviations is a difference: its error is relative to the sum of squares.
      const double scale = double(c.faces.size()) * highest * highest;
      const double value = expected(c.weight, c.faces);
      check_near(c.value(), value,
                 1e-11 + (std::is_same<Weight, SMC::Density_variance_weight>::value ? 1e-13 * scale : 0.));
    }
  }
}

// The tenth power of 50 is 10^17.
BOOST_AUTO_TEST_CASE(norm_survives_the_largest_face)
{
  for (const double low : {1., 1.5, 3.})
    for (const double high : {10., 50.})
      for (const int repetitions : {1, 2, 100}) {
        Cluster<SMC::Maximum_density_weight> c;
        for (int i = 0; i < 30; ++i)
          c.add({low + 0.01 * i, 1});
        const double before = c.value();
        for (int i = 0; i < repetitions; ++i) {
          c.add({high, 1});
          check_near(c.value(), expected(c.weight, c.faces), 1e-13);
          c.remove(c.faces.size() - 1);
          check_near(c.value(), before, 1e-12);
        }
        check_near(c.value(), expected(c.weight, c.faces), 1e-12);
      }
}

BOOST_AUTO_TEST_CASE(norm_of_any_exponent)
{
  for (const double p : {1., 2., 3.5, 10., 30.}) {
    const SMC::Maximum_density_weight w(p);
    SMC::Maximum_density_weight::Cluster_data data;
    for (const double r : {2., 3., 5.})
      w.add(data, w.face_data(r, 1));
    check_near(w.weight(data, 0, 3), std::pow(std::pow(2, p) + std::pow(3, p) + std::pow(5, p), 1 / p), 1e-13);
    BOOST_CHECK_GE(w.weight(data, 0, 3), 5 * (1 - 1e-15));
  }
  // Formula (10) is the limit of formula (13).
  const SMC::Maximum_density_weight w(300);
  SMC::Maximum_density_weight::Cluster_data data;
  for (const double r : {2., 3., 5.})
    w.add(data, w.face_data(r, 1));
  check_near(w.weight(data, 0, 3), 5, 1e-12);
}

BOOST_AUTO_TEST_CASE(exact_maximum)
{
  Cluster<SMC::Exact_maximum_density_weight> c;
  c.add({3, 1});
  BOOST_CHECK_EQUAL(c.value(), 3);
  c.add({7, 1});
  c.add({7, 1});
  c.add({5, 1});
  BOOST_CHECK_EQUAL(c.value(), 7);
  BOOST_CHECK_EQUAL(c.weight.weight_without(c.data, 7, 0, 3), 7); // there are two
  c.remove(1);
  BOOST_CHECK_EQUAL(c.value(), 7);
  BOOST_CHECK_EQUAL(c.weight.weight_without(c.data, 7, 0, 2), 5);
  BOOST_CHECK_EQUAL(c.weight.weight_without(c.data, 3, 0, 2), 7);
  c.remove(1);
  BOOST_CHECK_EQUAL(c.value(), 5);
  BOOST_CHECK_EQUAL(c.weight.weight_with(c.data, 6, 0, 3), 6);
  BOOST_CHECK_EQUAL(c.weight.weight_with(c.data, 4, 0, 3), 5);
}

BOOST_AUTO_TEST_CASE(values_by_hand)
{
  Cluster<SMC::Uniform_weight> uniform;
  Cluster<SMC::Weighted_area_weight> area;
  Cluster<SMC::Density_variance_weight> variance;
  for (const Cluster_face& f : {Cluster_face{1, 2}, Cluster_face{2, 3}, Cluster_face{3, 0.5}}) {
    uniform.add(f);
    area.add(f);
    variance.add(f);
  }
  BOOST_CHECK_EQUAL(uniform.value(), 1);
  BOOST_CHECK_EQUAL(area.value(), 9.5);
  BOOST_CHECK_CLOSE(variance.value(), 3, 1e-12); // 1 + 1 + 0 + 1
  variance.remove(0);
  BOOST_CHECK_CLOSE(variance.value(), 1.5, 1e-12);
  variance.remove(0);
  BOOST_CHECK_CLOSE(variance.value(), 1, 1e-12);
  // Equal densities deviate by rounding only, which never lowers the weight below 1.
  Cluster<SMC::Density_variance_weight> equal;
  for (int i = 0; i < 1000; ++i) {
    equal.add({2.7182818284590452, 1});
    BOOST_CHECK_GE(equal.value(), 1);
    BOOST_CHECK_LE(equal.value(), 1 + 1e-9);
  }
}

// A face moves between two adjacent clusters in the plane. A quick rejection is correct, and weights with an exact quick
// rejection reject all such moves.
BOOST_AUTO_TEST_CASE_TEMPLATE(moves_that_cannot_gain, Weight, Weights_and_own)
{
  namespace internal = SMC::internal;
  typedef internal::Energy_evaluation<SMC::Weighted_inertia_energy<Weight> > Energy;
  constexpr bool is_exact = internal::judges_moves<Weight>;
  const Weight weight{};
  const Energy energy(SMC::Weighted_inertia_energy<Weight>(weight), {}, 1);
  std::mt19937 engine(2);
  std::size_t losses = 0, gains = 0, rejected = 0;
  for (const double highest : {1., 3., 20., 50.})
    for (int step = 0; step < 2000; ++step) {
      const auto face = [&](double x) {
        const double density = 1 + (highest - 1) * std::pow(uniform(engine), 3), area = 0.1 + uniform(engine);
        const internal::Vector centroid{{x + uniform(engine), uniform(engine), 0}};
        return typename Energy::Face{density * area, centroid, weight.face_data(density, area)};
      };
      const auto cluster = [&](double x) {
        typename Energy::Sums sums;
        for (std::size_t n = 2 + engine() % 40; n > 0; --n) {
          const auto f = face(x);
          energy.add(sums, f, energy.outcome_with(sums, f));
        }
        return sums;
      };
      typename Energy::Sums source = cluster(0);
      const typename Energy::Sums target = cluster(0.7);
      const auto f = face(0.5 * uniform(engine) + 0.1);
      energy.add(source, f, energy.outcome_with(source, f));
      const double before = source.energy + target.energy;
      const double change = energy.outcome_without(source, f).energy + energy.outcome_with(target, f).energy - before;
      const bool is_rejected = energy.cannot_gain(source, target, f);
      gains += change < -1e-12 * before;
      losses += change > 1e-12 * before;
      rejected += is_rejected;
      BOOST_CHECK(!is_rejected || change > -1e-12 * before);
      BOOST_CHECK(!is_exact || is_rejected || change < 1e-12 * before);
    }
  BOOST_TEST(gains > 1000u);
  BOOST_TEST(losses > 1000u);
  if (is_exact || internal::has_bounds<Weight>)
    BOOST_TEST(double(rejected) > 0.9 * double(losses));
  else
    BOOST_TEST(rejected == 0u);
}

BOOST_AUTO_TEST_CASE(exponents_that_are_refused)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double p : {0.999, 0., -10., infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
    BOOST_CHECK_THROW(SMC::Maximum_density_weight weight(p), SMC::Invalid_input);
  BOOST_CHECK_NO_THROW(SMC::Maximum_density_weight(1.));
}

// The optional members save work and change nothing else: three weights of equal values give the same clusters.
BOOST_AUTO_TEST_CASE(own_weights_with_optional_members)
{
  const test::Mesh mesh = test::to_mesh(generated::with_noise(generated::triangulated(generated::torus(30, 20)), 0.1, 1));
  const auto labels_with = [&](const auto& weight) {
    SMC::Mwcvd_clustering<test::Mesh, std::decay_t<decltype(weight)> > clustering(
      mesh, SMC::parameters::cluster_weight(weight));
    clustering.seed(60);
    clustering.grow();
    clustering.minimize(SMC::Coarsening_defaults::number_of_iterations, 0);
    std::vector<std::size_t> labels;
    for (const auto f : mesh.faces())
      labels.push_back(clustering.cluster(f));
    return labels;
  };
  const std::vector<std::size_t> labels = labels_with(Silent_weight());
  BOOST_TEST(labels_with(Judging_weight()) == labels, boost::test_tools::per_element());
  BOOST_TEST(labels_with(Bounding_weight()) == labels, boost::test_tools::per_element());
  BOOST_TEST(Judging_weight::number_of_judgements > 1000u);
  BOOST_TEST(Bounding_weight::number_of_bounds > 1000u);
}

BOOST_AUTO_TEST_SUITE_END()
