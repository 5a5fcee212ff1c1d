// SPDX-License-Identifier: GPL-3.0-or-later
//
// Energies of clusters: sums that follow faces which join and leave are compared with the formulas, and the guarantee with any
// energy.

#include "support/face_graphs.h"
#include "support/generate_meshes.h"

#include <CGAL/Surface_mesh_coarsening/Any_cluster_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Normal_deviation_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Quadric_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Weighted_inertia_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/is_valid_clustering.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/mpl/list.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_cluster_energies)

namespace SMC = CGAL::Surface_mesh_coarsening;
namespace internal = SMC::internal;
using generated::Soup;
using reference::Labels;
using test::Mesh;

namespace {

typedef long double Real;
typedef boost::mpl::list<SMC::Quadric_energy, SMC::Normal_deviation_energy> Energies;

double uniform(std::mt19937& engine) { return (double(engine()) + 0.5) / 4294967296.; }

struct Plain_face
{
  double mass;
  internal::Vector centroid, normal;
};

// A bent patch of faces around `place`.
Plain_face random_face(std::mt19937& engine, const internal::Vector& place, double bend)
{
  const double u = uniform(engine) - 0.5, v = uniform(engine) - 0.5;
  const internal::Vector n{{bend * u, bend * v, 1}};
  const double length = std::sqrt(internal::dot(n, n));
  return {0.1 + uniform(engine),
          {{place[0] + u, place[1] + v, place[2] - bend * (u * u + v * v) / 2}},
          {{n[0] / length, n[1] / length, n[2] / length}}};
}

constexpr double mean_area = 0.7;

Real inertia(const std::vector<Plain_face>& faces)
{
  Real mass = 0, sum = 0;
  std::array<Real, 3> center{};
  for (const Plain_face& f : faces) {
    mass += f.mass;
    for (int k = 0; k < 3; ++k)
      center[k] += Real(f.mass) * f.centroid[k];
  }
  for (const Plain_face& f : faces)
    for (int k = 0; k < 3; ++k)
      sum += f.mass * (f.centroid[k] - center[k] / mass) * (f.centroid[k] - center[k] / mass);
  return sum;
}

// The value of the quadric, with its regularization, at the solution of the linear system for its minimum.
Real expected(const SMC::Quadric_energy&, const std::vector<Plain_face>& faces)
{
  const Real pull = SMC::Quadric_energy::default_regularization;
  Real a[3][4] = {};
  for (const Plain_face& f : faces) {
    Real d = 0;
    for (int k = 0; k < 3; ++k)
      d += Real(f.normal[k]) * f.centroid[k];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        a[i][j] += Real(f.mass) * (Real(f.normal[i]) * f.normal[j] + (i == j ? pull : 0));
      a[i][3] += Real(f.mass) * (d * f.normal[i] + pull * f.centroid[i]);
    }
  }
  for (int i = 0; i < 3; ++i) // Gauss and Jordan; the matrix is positive definite
    for (int r = 0; r < 3; ++r)
      if (r != i) {
        const Real factor = a[r][i] / a[i][i];
        for (int k = i; k < 4; ++k)
          a[r][k] -= factor * a[i][k];
      }
  Real sum = 0;
  for (const Plain_face& f : faces) {
    Real distance = 0, square = 0;
    for (int k = 0; k < 3; ++k) {
      const Real d = a[k][3] / a[k][k] - f.centroid[k];
      distance += f.normal[k] * d;
      square += d * d;
    }
    sum += f.mass * (distance * distance + pull * square);
  }
  return sum;
}

Real expected(const SMC::Normal_deviation_energy&, const std::vector<Plain_face>& faces)
{
  Real mass = 0, square = 0;
  for (const Plain_face& f : faces)
    mass += f.mass;
  for (int k = 0; k < 3; ++k) {
    Real s = 0;
    for (const Plain_face& f : faces)
      s += Real(f.mass) * f.normal[k];
    square += s * s;
  }
  return mass - std::sqrt(square) + SMC::Normal_deviation_energy::default_regularization / mean_area * inertia(faces);
}

template <class Energy>
Energy prepared()
{
  Energy energy;
  if constexpr (internal::needs_mean_area<Energy>)
    energy.set_mean_area(mean_area);
  return energy;
}

void check_near(Real a, Real b, Real tolerance, const std::string& what)
{
  BOOST_CHECK_MESSAGE(std::abs(a - b) <= tolerance, what << ": " << a << " is not " << b);
}

// Closed and not, of triangles and not, of several components.
std::vector<std::pair<std::string, Soup> > soups()
{
  using namespace generated;
  return {{"sphere", with_noise(triangle_sphere(3), 0.01)},
          {"cube", cube_grid(12)},
          {"torus of squares", with_noise(torus(40, 20), 0.01)},
          {"holes", with_holes(with_noise(triangle_sphere(3), 0.01), 5)},
          {"handles", triangulated(plate_with_windows(2, 4))},
          {"grid", grid(20, 30)},
          {"two", joined(with_noise(triangle_sphere(3), 0.01), translated(cube_grid(6), 5, 0, 0))}};
}

// The clusters after each round; the energy never rises, is the sum from scratch, and clusters stay valid.
template <class Energy, class Graph>
Labels minimized(const Graph& mesh, std::size_t n, const Energy& energy, bool checks = true)
{
  SMC::Mwcvd_clustering<Graph, Energy> clustering(mesh, SMC::parameters::cluster_energy(energy));
  clustering.seed(n);
  clustering.grow();
  double before = clustering.energy();
  std::size_t rounds = 0;
  for (bool moves = true; moves && rounds < 100; ++rounds) {
    moves = clustering.minimize_round();
    if (!checks)
      continue;
    const double now = clustering.energy();
    BOOST_CHECK(std::isfinite(now));
    BOOST_CHECK_LE(now, before * (1 + 1e-12));
    before = now;
  }
  BOOST_CHECK_EQUAL(clustering.number_of_clusters(), n);
  if (checks) {
    double sum = 0;
    const SMC::internal::Clustering_state& state = clustering.state();
    for (const auto& x : internal::cluster_sums(energy, state.working_input(), *state.labels, n))
      sum += x.energy;
    check_near(sum, before, 1e-9 * before, "the energy from scratch");
    BOOST_CHECK_LT(before, clustering.report().initial_energy);
  }
  return test::labels_in(clustering, mesh);
}

std::string fault(const Mesh& mesh, const Labels& labels)
{
  return SMC::clustering_fault(mesh, boost::make_function_property_map<Mesh::Face_index>([&](Mesh::Face_index f) {
                                 return labels[std::size_t(f)];
                               }));
}

// A user's energy, with what the concept asks for: the squared extent of the cluster along an axis, times its area.
class Axis_energy
{
public:
  struct Face_data
  {
    double area, x;
  };
  struct Cluster_data
  {
    double area = 0, moment = 0, square = 0;
  };

  Face_data face_data(const SMC::Clustered_face& f) const { return {f.area(), f.centroid().x()}; }
  void add(Cluster_data& c, const Face_data& f) const { accumulate(c, f, f.area); }
  void remove(Cluster_data& c, const Face_data& f) const { accumulate(c, f, -f.area); }
  double energy(const Cluster_data& c, std::size_t faces) const { return value(c) + 1e-9 * double(faces * faces); }

protected:
  static void accumulate(Cluster_data& c, const Face_data& f, double area)
  {
    c.area += area;
    c.moment += area * f.x;
    c.square += area * f.x * f.x;
  }
  static double value(const Cluster_data& c) { return c.area > 0 ? (std::max)(0., c.square - c.moment * c.moment / c.area) : 0; }
};

// The same with all optional members, which change nothing but the work.
class Full_axis_energy : public Axis_energy
{
public:
  static constexpr bool depends_on_densities = false;
  struct Cluster_data : Axis_energy::Cluster_data
  {
    double center = 0, kept = 0;
  };
  struct Outcome
  {
    double energy = 0, root = 0;
    operator double() const { return energy; }
  };

  void set_mean_area(double area)
  {
    BOOST_REQUIRE_GT(area, 0);
    mean_area = area;
  }
  void add_to_center(Cluster_data& c, const SMC::Clustered_face& f) const
  {
    BOOST_REQUIRE_GT(mean_area, 0);
    c.center += f.area();
  }
  void set_center(Cluster_data& c) const { c.center = -c.center; }
  void add_about_center(Cluster_data& c, const Face_data& f) const
  {
    BOOST_REQUIRE_LE(c.center, 0);
    add(c, f);
    ++calls.second_passes;
  }
  Outcome energy(const Cluster_data& c, std::size_t faces) const { return outcome(Axis_energy::energy(c, faces)); }
  Outcome energy_with(Cluster_data c, const Face_data& f, std::size_t faces) const
  {
    ++calls.trials;
    add(c, f);
    return energy(c, faces);
  }
  Outcome energy_without(Cluster_data c, const Face_data& f, std::size_t faces) const
  {
    remove(c, f);
    return energy(c, faces);
  }
  void keep(Cluster_data& c, const Outcome& o) const
  {
    ++calls.kept;
    c.kept = o.root;
  }
  bool cannot_gain(const Cluster_data& source, const Cluster_data&, const Face_data&) const
  {
    ++calls.judgements;
    BOOST_REQUIRE_EQUAL(source.kept, std::sqrt(source.kept * source.kept));
    return false;
  }

  struct Calls
  {
    std::size_t second_passes = 0, trials = 0, kept = 0, judgements = 0;
  };
  static Calls calls;

private:
  static Outcome outcome(double energy) { return {energy, std::sqrt(energy)}; }
  double mean_area = 0;
};
Full_axis_energy::Calls Full_axis_energy::calls;

// Energies that no minimization can work with.
class Broken_energy
{
public:
  explicit Broken_energy(double value) : value_(value) {}
  struct Face_data {};
  struct Cluster_data {};
  Face_data face_data(const SMC::Clustered_face&) const { return {}; }
  void add(Cluster_data&, const Face_data&) const {}
  void remove(Cluster_data&, const Face_data&) const {}
  double energy(const Cluster_data&, std::size_t faces) const { return faces % 3 == 0 ? value_ : 1; }

private:
  double value_;
};

} // namespace

// Sums that follow faces, against the formulas. A cluster a thousand of its diameters away loses what the roundings of its
// centroid add up to, as masses and widths are about 1, but no square of that distance.
BOOST_AUTO_TEST_CASE_TEMPLATE(faces_join_and_leave, Energy, Energies)
{
  std::mt19937 engine(3);
  const Energy energy = prepared<Energy>();
  for (const double bend : {0., 1e-3, 0.3, 3.})
    for (const double far : {0., 1000.}) {
      typename Energy::Cluster_data data{};
      std::vector<Plain_face> faces;
      constexpr int steps = 600;
      const double rounding = steps * std::ldexp(far, -53);
      for (int step = 0; step < steps; ++step) {
        const bool joins = faces.size() < 2 || (faces.size() < 60 && engine() % 2 == 0);
        const std::size_t i = joins ? faces.size() : engine() % faces.size();
        if (joins)
          faces.push_back(random_face(engine, {{far, -far, far / 3}}, bend));
        const typename Energy::Face_data face{faces[i].mass, faces[i].centroid, faces[i].normal};
        joins ? energy.add(data, face) : energy.remove(data, face);
        if (!joins)
          faces.erase(faces.begin() + std::ptrdiff_t(i));
        const Real value = expected(energy, faces);
        check_near(energy.energy(data, faces.size()), value, 1e-11 * (value + 0.01L * Real(faces.size())) + rounding,
                   "bend " + std::to_string(bend));
      }
    }
}

// The gain of a move is the difference of the energies of the two clusterings.
BOOST_AUTO_TEST_CASE_TEMPLATE(gains_of_moves, Energy, Energies)
{
  for (const auto& [name, soup] : soups()) {
    const Mesh mesh = test::to_mesh(soup);
    constexpr std::size_t n = 30;
    SMC::Mwcvd_clustering<Mesh, Energy> clustering(mesh);
    clustering.seed(n);
    clustering.grow();
    const internal::Clustering_input& input = clustering.state().working_input();
    internal::Cluster_labels labels(*clustering.state().labels);
    const internal::Energy_evaluation<Energy> evaluation(Energy(), input, n);
    std::vector<internal::Cluster_sums<Energy> > sums(n);
    evaluation.add_up(input, labels, sums, internal::Run_context());
    const auto total = [&] {
      double sum = 0;
      for (const auto& x : internal::cluster_sums(Energy(), input, labels, n))
        sum += x.energy;
      return sum;
    };
    const double before = total();
    std::size_t moves = 0;
    for (internal::Index f = 0; f < input.mesh.number_of_faces(); f += 3)
      for (const internal::Index c : input.mesh.corners(f)) {
        const internal::Index g = input.mesh.face_across[c];
        if (g == internal::NONE || labels[f] == labels[g] || sums[labels[f]].faces < 2)
          continue;
        const internal::Index from = labels[f], to = labels[g];
        const auto face = evaluation.terms_of(input, f);
        const double gain = sums[from].energy - double(evaluation.outcome_without(sums[from], face)) + sums[to].energy -
                            double(evaluation.outcome_with(sums[to], face));
        labels.set(f, to);
        check_near(gain, before - total(), 1e-11 * before, name);
        labels.set(f, from);
        ++moves;
        break;
      }
    BOOST_CHECK_GT(moves, 20u);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(energy_falls_and_clusters_stay_valid, Energy, Energies)
{
  for (const auto& [name, soup] : soups()) {
    const Mesh mesh = test::to_mesh(soup);
    BOOST_TEST_CONTEXT(name)
    BOOST_CHECK_EQUAL(fault(mesh, minimized(mesh, 40, Energy())), "");
  }
}

// The same clusters for each type of mesh.
BOOST_AUTO_TEST_CASE_TEMPLATE(mesh_types_agree, Energy, Energies)
{
  const Soup soup = generated::with_noise(generated::torus(40, 20), 0.01);
  CGAL::Polyhedron_3<test::Kernel> polyhedron;
  test::to_face_graph(soup, polyhedron);
  BOOST_TEST(minimized(test::to_mesh(soup), 50, Energy()) == minimized(polyhedron, 50, Energy()),
             boost::test_tools::per_element());
}

// On a plane, quadrics and normals leave the inertia.
BOOST_AUTO_TEST_CASE_TEMPLATE(inertia_decides_on_a_plane, Energy, Energies)
{
  const Mesh mesh = test::to_mesh(generated::rotated(generated::grid(40, 30), 0.3, 0.4));
  BOOST_TEST(minimized(mesh, 50, Energy()) == minimized(mesh, 50, SMC::Weighted_inertia_energy<SMC::Uniform_weight>()),
             boost::test_tools::per_element());
}

// A power of two changes no label, however large it is, and a translation that rounds coordinates no promise.
BOOST_AUTO_TEST_CASE_TEMPLATE(scaled_and_translated, Energy, Energies)
{
  const Soup soup = generated::with_noise(generated::triangle_sphere(3), 0.05);
  const Labels labels = minimized(test::to_mesh(soup), 50, Energy());
  for (const int exponent : {-300, -100, -20, 7, 100, 300})
    BOOST_TEST(minimized(test::to_mesh(generated::scaled(soup, std::ldexp(1., exponent))), 50, Energy()) == labels,
               boost::test_tools::per_element());
  const Mesh far = test::to_mesh(generated::translated(soup, 1e6, -2e6, 3e6));
  BOOST_CHECK_EQUAL(fault(far, minimized(far, 50, Energy())), "");
}

// Faces without area, in part or all.
BOOST_AUTO_TEST_CASE_TEMPLATE(degenerate_input, Energy, Energies)
{
  using namespace generated;
  const Soup sphere = triangle_sphere(3);
  const std::vector<Soup> degenerate{
    with_points(sphere, [](const Point& p) { return Point{{p[0], p[1], 0}}; }),
    with_points(sphere, [](const Point& p) { return Point{{p[0], 0, 0}}; }),
    with_points(sphere, [](const Point&) { return Point{{1, 2, 3}}; }),
    with_points(sphere, [](const Point& p) { return Point{{p[0], p[1], (std::max)(p[2], 0.)}}; }),
    scaled(sphere, 1, 1, 1e-12),
    needles(50, 10)};
  for (const Soup& soup : degenerate) {
    const Mesh mesh = test::to_mesh(soup);
    Mesh output;
    const SMC::Coarsening_report report =
      SMC::coarsen_mesh(mesh, 40, output, SMC::parameters::cluster_energy(Energy()).vertex_placement(SMC::Centroid_placement()));
    BOOST_CHECK_EQUAL(num_vertices(output), 40u);
    BOOST_CHECK(CGAL::is_valid_polygon_mesh(output));
    BOOST_CHECK(CGAL::is_triangle_mesh(output));
    BOOST_CHECK(std::isfinite(report.final_energy));
    BOOST_CHECK_GE(report.initial_energy, report.final_energy);
    for (const auto v : output.vertices())
      BOOST_REQUIRE(std::isfinite(output.point(v).x() + output.point(v).y() + output.point(v).z()));
  }
}

// Parts of faces, and polygons of several, where features are kept or the input is subdivided.
BOOST_AUTO_TEST_CASE_TEMPLATE(features_and_parts_of_faces, Energy, Energies)
{
  const Mesh cube = test::to_mesh(generated::triangulated(generated::cube_grid(10)));
  Mesh output;
  SMC::Coarsening_report report =
    SMC::coarsen_mesh(cube, 60, output, SMC::parameters::cluster_energy(Energy()).feature_angle(30));
  BOOST_CHECK_EQUAL(num_vertices(output), 60u);
  BOOST_CHECK_EQUAL(report.feature_lines, 12u);
  BOOST_CHECK_LT(report.final_energy, report.initial_energy);
  report = SMC::coarsen_mesh(test::to_mesh(generated::octahedron()), 30, output,
                             SMC::parameters::cluster_energy(Energy()).subdivide_input(true));
  BOOST_CHECK_EQUAL(num_vertices(output), 30u);
  BOOST_CHECK_LT(report.final_energy, report.initial_energy);
}

// A weight is short for its energy.
BOOST_AUTO_TEST_CASE(weights_are_energies)
{
  const Mesh mesh = test::to_mesh(generated::with_noise(generated::triangle_sphere(4), 0.02));
  const SMC::Maximum_density_weight weight(7);
  Mesh by_weight, by_energy;
  const auto a = SMC::coarsen_mesh(mesh, 100, by_weight, SMC::parameters::cluster_weight(weight));
  const auto b = SMC::coarsen_mesh(
    mesh, 100, by_energy,
    SMC::parameters::cluster_energy(SMC::Weighted_inertia_energy<SMC::Maximum_density_weight>(weight)));
  BOOST_CHECK_EQUAL(a.final_energy, b.final_energy);
  BOOST_CHECK(std::equal(by_weight.points().begin(), by_weight.points().end(), by_energy.points().begin(),
                         by_energy.points().end()));
}

// The type of the energy may be hidden. The default energy still clusters cells where the output is fine.
typedef boost::mpl::list<SMC::Weighted_inertia_energy<SMC::Weighted_area_weight>, SMC::Quadric_energy, Axis_energy> Hidden_energies;

BOOST_AUTO_TEST_CASE_TEMPLATE(energy_chosen_at_run_time, Energy, Hidden_energies)
{
  const Mesh mesh = test::to_mesh(generated::with_noise(generated::triangle_sphere(4), 0.02));
  for (const std::size_t n : {std::size_t(100), std::size_t(mesh.number_of_vertices() / 2)}) {
    Mesh typed, any;
    const auto a = SMC::coarsen_mesh(mesh, n, typed, SMC::parameters::cluster_energy(Energy()));
    const auto b = SMC::coarsen_mesh(mesh, n, any, SMC::parameters::cluster_energy(SMC::Any_cluster_energy(Energy())));
    BOOST_CHECK_EQUAL(a.final_energy, b.final_energy);
    BOOST_CHECK(std::equal(typed.points().begin(), typed.points().end(), any.points().begin(), any.points().end()));
  }
}

BOOST_AUTO_TEST_CASE(any_energy_is_the_default_energy)
{
  const Mesh mesh = test::to_mesh(generated::with_noise(generated::triangle_sphere(4), 0.02));
  Mesh by_default, any;
  SMC::coarsen_mesh(mesh, 100, by_default);
  SMC::coarsen_mesh(mesh, 100, any, SMC::parameters::cluster_energy(SMC::Any_cluster_energy()));
  BOOST_CHECK(std::equal(by_default.points().begin(), by_default.points().end(), any.points().begin(), any.points().end()));
}

BOOST_AUTO_TEST_CASE(own_energy_with_and_without_optional_members)
{
  typedef Full_axis_energy Full;
  for (const auto& [name, soup] : soups()) {
    const Mesh mesh = test::to_mesh(soup);
    const Labels labels = minimized(mesh, 40, Axis_energy());
    BOOST_CHECK_EQUAL(fault(mesh, labels), "");
    Full::calls = Full::Calls();
    BOOST_TEST(minimized(mesh, 40, Full()) == labels, boost::test_tools::per_element());
    BOOST_CHECK_GE(Full::calls.second_passes, 2 * mesh.number_of_faces());
    BOOST_CHECK_GT(Full::calls.trials, 100u);
    BOOST_CHECK_GE(Full::calls.judgements, Full::calls.trials);
    BOOST_CHECK_GT(Full::calls.kept, 80u);
  }
}

// Whatever an energy returns, the promises of the output hold.
BOOST_AUTO_TEST_CASE(guarantee_with_any_energy)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, -1., 0., 1e300})
    for (const auto& [name, soup] : soups()) {
      const Mesh mesh = test::to_mesh(soup);
      BOOST_CHECK_EQUAL(fault(mesh, minimized(mesh, 40, Broken_energy(value), false)), "");
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(regularization, Energy, Energies)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double x : {0., -1., infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
    BOOST_CHECK_THROW(Energy energy(x), SMC::Invalid_input);
  // More of it makes rounder clusters: the inertia is smaller.
  const Mesh mesh = test::to_mesh(generated::scaled(generated::triangle_sphere(4), 1, 1, 0.2));
  const auto inertia_with = [&](double x) {
    SMC::Mwcvd_clustering<Mesh, Energy> clustering(mesh, SMC::parameters::cluster_energy(Energy(x)));
    clustering.seed(60);
    clustering.grow();
    clustering.minimize();
    double sum = 0;
    for (const auto& y : internal::cluster_sums(SMC::Weighted_inertia_energy<SMC::Uniform_weight>(),
                                                clustering.state().working_input(), *clustering.state().labels, 60))
      sum += y.energy;
    return sum;
  };
  BOOST_CHECK_LT(inertia_with(10), inertia_with(1e-3));
}

BOOST_AUTO_TEST_SUITE_END()
