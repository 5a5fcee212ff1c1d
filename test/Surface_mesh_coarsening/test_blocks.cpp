// SPDX-License-Identifier: GPL-3.0-or-later
//
// The minimization in blocks of clusters: whatever the order in which the blocks make their moves, and on however many threads,
// the result is the same; clusterings stay valid, and the energy falls.

#include "support/face_graphs.h"
#include "support/generate_meshes.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Normal_deviation_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Quadric_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Weighted_inertia_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Clustering_check.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_minimization.h>
#include <CGAL/Surface_mesh_coarsening/internal/seeding/Initial_clustering.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_blocks)

namespace SMC = CGAL::Surface_mesh_coarsening;
using namespace SMC::internal;

namespace {

constexpr std::size_t number_of_clusters = 1100, number_of_blocks = 7;

typedef boost::mpl::list<SMC::Weighted_inertia_energy<SMC::Uniform_weight>,
                         SMC::Weighted_inertia_energy<SMC::Maximum_density_weight>,
                         SMC::Weighted_inertia_energy<SMC::Density_variance_weight>, SMC::Quadric_energy,
                         SMC::Normal_deviation_energy>
  Energies;

// A mesh with clusters that have grown.
struct Grown
{
  explicit Grown(const generated::Soup& soup) : mesh(test::to_mesh(soup))
  {
    const auto np = CGAL::parameters::default_values();
    Local_frame frame;
    input.items = clustering_input(mesh, np, numbering(mesh, np), frame, Run_context());
    initial = std::make_unique<Initial_clustering>(input, Merging::BY_MASS, report, Run_context());
    initial->seed(number_of_clusters);
    labels = std::make_unique<Cluster_labels>(initial->grow());
  }

  const Featured_input& working_input() const { return initial->input(); }

  test::Mesh mesh;
  Featured_input input;
  SMC::Coarsening_report report;
  std::unique_ptr<Initial_clustering> initial;
  std::unique_ptr<Cluster_labels> labels;
};

// Closed and not, of triangles and not, in several pieces, and with vertices of so many faces that these are counted.
std::vector<std::pair<std::string, generated::Soup> > soups()
{
  using namespace generated;
  return {{"sphere", with_noise(triangle_sphere(5), 0.01)},
          {"torus of squares", with_noise(torus(160, 60), 0.01)},
          {"holes", with_holes(with_noise(triangle_sphere(5), 0.01), 12)},
          {"handles", triangulated(plate_with_windows(5, 8))},
          {"hubs", joined(needles(150, 30), translated(triangle_sphere(4), 5, 0, 0))}};
}

std::string fault(const Cluster_labels& labels)
{
  return Clustering_check(labels, number_of_clusters).fault([](std::size_t x) { return "cluster " + std::to_string(x); });
}

// The blocks of a division, ready to make their moves.
template <class Energy>
class Divided
{
public:
  typedef Block_minimization<Energy> Block;

  explicit Divided(const Grown& grown)
    : labels(*grown.labels), state{grown.working_input().items, labels,
                                   Energy_evaluation<Energy>(Energy(), grown.working_input().items, number_of_clusters),
                                   std::vector<Cluster_sums<Energy> >(number_of_clusters),
                                   std::vector<Move_time>(number_of_clusters, 1),
                                   Listed_edges(grown.working_input().items.mesh.corner_vertex.size()), nullptr, {}},
      cancellation_(Run_context())
  {
    state.last_change.push_back(0);
    state.energy.add_up(state.input, labels, state.clusters, Run_context());
    Boundary_edges edges;
    list_boundary_edges(labels, edges, state.listed, Run_context());
    std::vector<Moments> moments(number_of_clusters);
    add_up_centroids(state.input, labels, moments, Run_context());
    std::vector<Vector> points;
    for (const Moments& x : moments)
      points.push_back(x.centroid);
    division = Cluster_blocks(points, number_of_blocks, Run_context());
    distributed = distribute(edges, division, Run_context());
    state.is_shared.assign(state.input.mesh.number_of_vertices(), false);
    for (const Boundary_edge& e : distributed[number_of_blocks])
      mark_ends(state.input.mesh, e, state.is_shared);
    cancellation_.begin();
    for (std::size_t b = 0; b < number_of_blocks; ++b)
      blocks.emplace_back(state, distributed[b], 1, cancellation_);
  }

  double energy() const
  {
    double sum = 0;
    for (const auto& x : state.clusters)
      sum += x.energy;
    return sum;
  }

  Cluster_labels labels; // a copy
  Minimization_state<Energy> state;
  Cluster_blocks division;
  std::vector<Boundary_edges> distributed; // to blocks, and between blocks
  std::deque<Block> blocks;

private:
  Shared_cancellation_point cancellation_;
};

} // namespace

// Blocks are nearly of the same size; each edge is in the block of its two clusters, or between blocks.
BOOST_AUTO_TEST_CASE(edges_are_distributed)
{
  for (const auto& [name, soup] : soups()) {
    const Grown grown(soup);
    const Divided<SMC::Weighted_inertia_energy<> > divided(grown);
    std::vector<std::size_t> size(number_of_blocks, 0);
    for (Index x = 0; x < number_of_clusters; ++x)
      ++size[divided.division[x]];
    BOOST_CHECK_LE(*std::max_element(size.begin(), size.end()), *std::min_element(size.begin(), size.end()) + number_of_blocks);
    const Flat_mesh& m = grown.working_input().items.mesh;
    std::size_t expected = 0, between = 0;
    for (Index f = 0; f < m.number_of_faces(); ++f)
      for (Index c = m.first_corner[f]; c != m.first_corner[f + 1]; ++c) {
        const Index g = m.face_across[c];
        if (g == NONE || g < f || divided.labels[f] == divided.labels[g])
          continue;
        ++expected;
        between += divided.division[divided.labels[f]] != divided.division[divided.labels[g]];
      }
    std::size_t number = divided.distributed[number_of_blocks].size();
    BOOST_CHECK_EQUAL(number, between);
    for (std::size_t b = 0; b < number_of_blocks; ++b)
      for (const Boundary_edge& e : divided.distributed[b]) {
        BOOST_REQUIRE(divided.labels[e.face[0]] != divided.labels[e.face[1]]);
        for (const Index f : e.face)
          BOOST_REQUIRE_EQUAL(divided.division[divided.labels[f]], b);
        ++number;
      }
    BOOST_CHECK_EQUAL(number, expected);
    // A vertex is shared if and only if the faces around it belong to several blocks.
    for (Index v = 0; v < m.number_of_vertices(); ++v) {
      bool is_shared = false;
      for (Index i = m.first_in_star[v]; i != m.first_in_star[v + 1]; ++i)
        is_shared = is_shared ||
                    divided.division[divided.labels[m.star[i]]] != divided.division[divided.labels[m.star[m.first_in_star[v]]]];
      BOOST_REQUIRE_EQUAL(divided.state.is_shared[v], is_shared);
    }
  }
}

// Rounds of the blocks in several orders, interleaved and not.
BOOST_AUTO_TEST_CASE_TEMPLATE(blocks_commute, Energy, Energies)
{
  constexpr std::size_t rounds = 6;
  for (const auto& [name, soup] : soups()) {
    const Grown grown(soup);
    std::vector<std::size_t> order; // of the blocks, once for each round
    for (std::size_t b = 0; b < number_of_blocks; ++b)
      order.insert(order.end(), rounds, b);
    std::vector<Index> labels, counts;
    std::vector<double> energies;
    std::mt19937 engine;
    for (int replay = 0; replay < 5; ++replay) {
      Divided<Energy> divided(grown);
      double energy = divided.energy();
      for (const std::size_t b : order) {
        divided.blocks[b].round();
        BOOST_REQUIRE_LE(divided.energy(), energy * (1 + 1e-12));
        energy = divided.energy();
      }
      BOOST_CHECK_EQUAL(fault(divided.labels), "");
      BOOST_CHECK(divided.labels.recounted() == divided.labels.boundary_counts());
      std::vector<double> of_clusters;
      for (const auto& x : divided.state.clusters)
        of_clusters.push_back(x.energy);
      if (replay == 0) {
        std::size_t moves = 0;
        for (const auto& block : divided.blocks)
          moves += block.moves();
        BOOST_CHECK_GT(moves, number_of_clusters / 2);
        labels = divided.labels.labels();
        counts = divided.labels.boundary_counts();
        energies = of_clusters;
      }
      BOOST_CHECK_MESSAGE(divided.labels.labels() == labels, name << ": replay " << replay << " gives other labels");
      BOOST_CHECK(divided.labels.boundary_counts() == counts);
      BOOST_CHECK(of_clusters == energies);
      if (replay == 0)
        std::reverse(order.begin(), order.end());
      else
        std::shuffle(order.begin(), order.end(), engine);
    }
  }
}

// The whole minimization, run by run, on one thread and on many.
BOOST_AUTO_TEST_CASE_TEMPLATE(threads_agree, Energy, Energies)
{
  for (const auto& [name, soup] : soups()) {
    const Grown grown(soup);
    const auto minimized = [&grown](double tolerance, const Run_context& context) {
      Cluster_labels labels(*grown.labels);
      Energy_minimization<Energy> minimization(
        grown.working_input(), labels, {Energy(), grown.working_input().items, number_of_clusters}, false, context);
      BOOST_CHECK_GT(minimization.rounds_at_a_time(), 1u);
      std::vector<double> energies{minimization.energy()};
      for (;;) {
        const auto progress = minimization.run({minimization.rounds_at_a_time(), tolerance});
        energies.push_back(minimization.energy());
        const double gain = energies.end()[-2] - energies.back();
        BOOST_REQUIRE_GE(gain, -1e-12 * energies.back());
        BOOST_REQUIRE(minimization.agrees_with_recount());
        BOOST_REQUIRE(minimization.has_all_edges());
        BOOST_REQUIRE_LE(progress.rounds, minimization.rounds_at_a_time());
        if (progress.moves == 0 || gain < tolerance * energies.back())
          break;
      }
      BOOST_CHECK_EQUAL(fault(labels), "");
      return std::make_pair(labels.labels(), energies);
    };
    for (const double tolerance : {0., 1e-3}) {
      const auto expected = minimized(tolerance, Run_context());
      BOOST_CHECK_GT(expected.second.size(), 2u);
#ifdef CGAL_LINKED_WITH_TBB
      for (const std::size_t threads : {1, 2, 3, 8}) {
        tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        BOOST_CHECK_MESSAGE(minimized(tolerance, Run_context(CGAL::Parallel_tag())) == expected,
                            name << " on " << threads << " threads");
      }
#endif
    }
  }
}

// At the end no allowed move of a face lowers the energy, in whichever block.
BOOST_AUTO_TEST_CASE_TEMPLATE(ends_in_a_local_minimum, Energy, Energies)
{
  const Grown grown(soups().front().second);
  Cluster_labels labels(*grown.labels);
  const Clustering_input& input = grown.working_input().items;
  const Energy_evaluation<Energy> energy(Energy(), input, number_of_clusters);
  Energy_minimization<Energy> minimization(grown.working_input(), labels, energy, false, Run_context());
  while (minimization.run({3, 0}).moves > 0)
    ;
  std::vector<Cluster_sums<Energy> > sums(number_of_clusters);
  energy.add_up(input, labels, sums, Run_context());
  Valid_moves moves(labels, nullptr);
  const Flat_mesh& m = input.mesh;
  std::size_t gains = 0;
  for (Index f = 0; f < m.number_of_faces(); ++f)
    for (Index c = m.first_corner[f]; c != m.first_corner[f + 1]; ++c) {
      const Index from = labels[f], to = labels.label_across(c);
      if (m.face_across[c] == NONE || from == to || sums[from].faces == 1)
        continue;
      const auto face = energy.terms_of(input, f);
      const double lost = sums[from].energy - double(energy.outcome_without(sums[from], face)),
                   won = double(energy.outcome_with(sums[to], face)) - sums[to].energy;
      if (lost - won > 1e-6 * (lost + won) && moves.move(f, to)) {
        ++gains;
        labels.move(f, from);
      }
    }
  BOOST_CHECK_EQUAL(gains, 0u);
}

// A weight of 0 for all faces, and clusters at the same place: divisions are decided by numbers.
BOOST_AUTO_TEST_CASE(equal_points)
{
  const Cluster_blocks blocks(std::vector<Vector>(100, Vector{{1, 2, 3}}), 8, Run_context());
  std::vector<std::size_t> size(8, 0);
  for (Index x = 0; x < 100; ++x) {
    ++size[blocks[x]];
    BOOST_CHECK(x == 0 || blocks[x] >= blocks[x - 1]);
  }
  BOOST_CHECK_GE(*std::min_element(size.begin(), size.end()), 12u);
  BOOST_CHECK_LE(*std::max_element(size.begin(), size.end()), 13u);
}

// The visitor is asked on the thread that began, and its refusal leaves a clustering that can be minimized further.
BOOST_AUTO_TEST_CASE(cancelling)
{
  struct Refusing : SMC::Coarsening_visitor_base
  {
    std::size_t left = 0;
    bool go_further()
    {
      if (left == 0)
        return false;
      --left;
      return true;
    }
  };
  const Grown grown(soups()[1].second);
  std::size_t refusals = 0;
  for (std::size_t questions = 0; questions < 12; ++questions) {
    Refusing visitor;
    visitor.left = (std::numeric_limits<std::size_t>::max)();
    Cluster_labels labels(*grown.labels);
    const Run_context context(CGAL::Parallel_if_available_tag(), std::ref(visitor));
    typedef SMC::Weighted_inertia_energy<> Energy;
    Energy_minimization<Energy> minimization(
      grown.working_input(), labels, {Energy(), grown.working_input().items, number_of_clusters}, false, context);
    visitor.left = questions;
    try {
      for (int i = 0; i < 5; ++i)
        minimization.run({5, 0});
    } catch (const SMC::Coarsening_cancelled&) {
      ++refusals;
    }
    visitor.left = (std::numeric_limits<std::size_t>::max)();
    BOOST_CHECK_EQUAL(fault(labels), "");
    while (minimization.run({5, 0}).moves > 0)
      ;
    BOOST_CHECK(minimization.agrees_with_recount());
    BOOST_CHECK(minimization.has_all_edges());
    BOOST_CHECK_EQUAL(fault(labels), "");
  }
  BOOST_CHECK_GT(refusals, 2u);
}

BOOST_AUTO_TEST_SUITE_END()
