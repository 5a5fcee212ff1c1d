// SPDX-License-Identifier: GPL-3.0-or-later
//
// The result is the same to the last bit for any number of threads, the sequential version included.

#include "support/face_graphs.h"
#include "support/generate_meshes.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/place_and_exchange.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <CGAL/Polyhedron_3.h>

#include <boost/mpl/list.hpp>
#include <boost/property_map/property_map.hpp>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_threads)

namespace SMC = CGAL::Surface_mesh_coarsening;
using test::Mesh;

namespace {

struct Result
{
  std::vector<double> coordinates;
  std::vector<std::size_t> corners, clusters;
  std::size_t rounds, tests, moves;
  double energy;

  bool operator==(const Result& r) const
  {
    return coordinates == r.coordinates && corners == r.corners && clusters == r.clusters && rounds == r.rounds &&
           tests == r.tests && moves == r.moves && energy == r.energy;
  }
};

template <class ConcurrencyTag, class Weight, class FaceGraph>
Result coarsened(const FaceGraph& mesh, std::size_t n)
{
  Mesh output;
  Result r;
  std::vector<std::size_t> clusters(num_faces(mesh));
  std::map<typename boost::graph_traits<FaceGraph>::face_descriptor, std::size_t> number;
  for (const auto f : faces(mesh))
    number.emplace(f, number.size());
  const auto map = boost::make_iterator_property_map(clusters.begin(), boost::make_assoc_property_map(number));
  const SMC::Coarsening_report report = SMC::coarsen_mesh<ConcurrencyTag>(
    mesh, n, output,
    SMC::parameters::cluster_weight(Weight()).vertex_placement(SMC::Quadric_placement()).face_cluster_map(map));
  for (const auto v : vertices(output))
    for (int i = 0; i < 3; ++i)
      r.coordinates.push_back(output.point(v)[i]);
  for (const auto f : faces(output))
    for (const auto v : CGAL::vertices_around_face(halfedge(f, output), output))
      r.corners.push_back(std::size_t(v));
  r.clusters = clusters;
  r.rounds = report.rounds;
  r.tests = report.tests;
  r.moves = report.moves;
  r.energy = report.final_energy;
  return r;
}

typedef boost::mpl::list<SMC::Uniform_weight, SMC::Weighted_area_weight, SMC::Maximum_density_weight,
                         SMC::Density_variance_weight>
  Weights;

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(same_result, Weight, Weights)
{
  const Mesh mesh = test::to_mesh(generated::with_noise(generated::triangle_sphere(5), 0.01));
  const Result sequential = coarsened<CGAL::Sequential_tag, Weight>(mesh, 900);
  BOOST_CHECK(sequential.rounds > 3);
  BOOST_CHECK((coarsened<CGAL::Sequential_tag, Weight>(mesh, 900) == sequential));
  BOOST_CHECK((coarsened<CGAL::Parallel_if_available_tag, Weight>(mesh, 900) == sequential));
#ifdef CGAL_LINKED_WITH_TBB
  for (const std::size_t threads : {1, 2, 8})
    for (int repetition = 0; repetition < 5; ++repetition) {
      tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      BOOST_CHECK((coarsened<CGAL::Parallel_tag, Weight>(mesh, 900) == sequential));
    }
#endif
}

#ifdef CGAL_LINKED_WITH_TBB
// A user's placement that waits a while for a second thread, with and without the optional member.
struct Waiting_placement
{
  struct Visits
  {
    std::mutex mutex;
    std::condition_variable has_changed;
    std::set<std::thread::id> threads;
  };
  std::shared_ptr<Visits> visits = std::make_shared<Visits>();

  SMC::Clustered_surface::Point_3 operator()(const SMC::Clustered_surface& surface, std::size_t cluster) const
  {
    std::unique_lock<std::mutex> lock(visits->mutex);
    if (visits->threads.insert(std::this_thread::get_id()).second) {
      visits->has_changed.notify_all();
      visits->has_changed.wait_for(lock, std::chrono::seconds(2), [this] { return visits->threads.size() > 1; });
    }
    return surface.cluster_centroid(cluster);
  }
};
struct Waiting_parallel_placement : Waiting_placement
{
  static constexpr bool may_run_in_parallel = true;
};

BOOST_AUTO_TEST_CASE(own_placement_on_many_threads)
{
  const Mesh mesh = test::to_mesh(generated::triangle_sphere(4));
  const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
  Mesh output;
  const Waiting_placement sequential;
  SMC::coarsen_mesh<CGAL::Parallel_tag>(mesh, 200, output, SMC::parameters::vertex_placement(sequential));
  BOOST_TEST(sequential.visits->threads.size() == 1u);
  const Waiting_parallel_placement parallel;
  SMC::coarsen_mesh<CGAL::Parallel_tag>(mesh, 200, output, SMC::parameters::vertex_placement(parallel));
  BOOST_TEST(parallel.visits->threads.size() == 2u);
}
#endif

BOOST_AUTO_TEST_CASE(same_result_of_another_face_graph)
{
  const generated::Soup soup = generated::with_noise(generated::torus(60, 40), 0.01);
  CGAL::Polyhedron_3<test::Kernel> polyhedron;
  test::to_face_graph(soup, polyhedron);
  const Result sequential = coarsened<CGAL::Sequential_tag, SMC::Uniform_weight>(test::to_mesh(soup), 100);
  BOOST_CHECK((coarsened<CGAL::Parallel_if_available_tag, SMC::Uniform_weight>(polyhedron, 100) == sequential));
}

// Enough faces and clusters to compute sums in several chunks, and to list edges again.
BOOST_AUTO_TEST_CASE(same_result_of_a_large_mesh)
{
  const Mesh mesh = test::to_mesh(generated::with_noise(generated::triangle_sphere(8), 0.001));
  const Result sequential = coarsened<CGAL::Sequential_tag, SMC::Uniform_weight>(mesh, 20000);
  BOOST_CHECK((coarsened<CGAL::Parallel_if_available_tag, SMC::Uniform_weight>(mesh, 20000) == sequential));
}

// Vertices of very high valence, and clusters that are relocated while vertices are moved on many threads.
BOOST_AUTO_TEST_CASE(same_result_of_the_default_at_vertices_of_high_valence)
{
  const Mesh mesh = test::to_mesh(generated::bipyramid(3000));
  const auto points = [&](auto tag) {
    Mesh output;
    SMC::coarsen_mesh<decltype(tag)>(mesh, 1050, output);
    return std::vector<test::Kernel::Point_3>(output.points().begin(), output.points().end());
  };
  const auto sequential = points(CGAL::Sequential_tag());
  for (int repetition = 0; repetition < 2; ++repetition)
    BOOST_CHECK(points(CGAL::Parallel_if_available_tag()) == sequential);
}

// Many threads ask for the bounds of clusters that share vertices, each for other clusters. This changes no cluster.
BOOST_AUTO_TEST_CASE(bounds_of_relocated_clusters)
{
  using namespace SMC::internal;
  constexpr std::size_t n = 350;
  const Mesh mesh = test::to_mesh(generated::bipyramid(3000));
  SMC::Mwcvd_clustering<Mesh, SMC::Weighted_area_weight, CGAL::Parallel_if_available_tag> clustering(mesh);
  clustering.seed(n);
  clustering.grow();
  const Clustering_state& state = clustering.state();
  Cluster_relocation clusters(state.featured_input(), *state.labels, Index(n));
  Placed_dual dual;
  const std::unique_ptr<Bordered_surface> surface = bordered_surface(state, dual);
  const Clustering_input& items = state.featured_input().items;
  std::vector<Vector> positions(n);
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    positions[(*state.labels)[Index(f)]] = items.centroid(Index(f));
  for (std::size_t x = 0; x < n; ++x) {
    const Index f = Index(x * (mesh.number_of_faces() / n));
    const Vector before = std::exchange(positions[x], items.centroid(f));
    if (clusters.relocate(Index(x), NONE, {f}, positions) != Relocation::DONE)
      positions[x] = before;
  }
  BOOST_CHECK_GT(clusters.number(), n / 4);

  const auto position = [&](std::size_t x) {
    return clusters.has_changed(Index(x)) ? closest_in_box({{9, 9, 9}}, clusters.vertex_bounds(Index(x)))
                                          : surface->faces.within_bounds(x, {{9, 9, 9}});
  };
  std::vector<Vector> expected;
  for (std::size_t x = 0; x < n; ++x)
    expected.push_back(position(x));
  const std::vector<Index> labels = state.labels->labels();
  std::vector<char> is_equal(n, true);
  for_each_chunk(state.context, n, 1, [&](std::size_t x, std::size_t, std::size_t) {
    for (int repetition = 0; repetition < 1000; ++repetition)
      is_equal[x] = is_equal[x] && position(x) == expected[x];
  });
  BOOST_CHECK(is_equal == std::vector<char>(n, true));
  BOOST_CHECK(state.labels->labels() == labels);
  BOOST_CHECK(state.labels->recounted() == state.labels->boundary_counts());
}

BOOST_AUTO_TEST_SUITE_END()
