// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clusters frozen, split and removed by hand: the clustering remains valid after any sequence of edits.

#include "support/face_graphs.h"
#include "support/generate_meshes.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/is_valid_clustering.h>

#include <CGAL/boost/graph/helpers.h>

#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_steering)

namespace SMC = CGAL::Surface_mesh_coarsening;
using test::Mesh;

namespace {

typedef SMC::Mwcvd_clustering<Mesh, SMC::Maximum_density_weight> Clustering;

std::string fault(const Clustering& clustering, const Mesh& mesh)
{
  Mesh copy = mesh;
  const auto map = copy.add_property_map<Mesh::Face_index, std::size_t>("f:cluster").first;
  clustering.write_clusters(map);
  std::vector<bool> is_there(clustering.number_of_clusters(), false);
  for (const auto f : copy.faces())
    is_there.at(map[f]) = true;
  if (std::find(is_there.begin(), is_there.end(), false) != is_there.end())
    return "a number is missing";
  return SMC::clustering_fault(copy, map);
}

std::vector<generated::Soup> surfaces()
{
  using namespace generated;
  const Soup torus = with_noise(generated::torus(30, 20), 0.05);
  return {triangulated(torus), torus, triangle_sphere(3), with_noise(triangulated(grid(24, 18)), 0.1),
          with_holes(triangle_sphere(3), 5), plate_with_windows(3, 3), dual(triangulated(torus)), bipyramid(200)};
}

} // namespace

BOOST_AUTO_TEST_CASE(any_sequence_of_steps_keeps_the_guarantee)
{
  std::mt19937 random(7);
  for (const generated::Soup& soup : surfaces()) {
    const Mesh mesh = test::to_mesh(soup);
    Clustering clustering(mesh);
    clustering.seed(40);
    clustering.grow();
    std::size_t splits = 0, removals = 0;
    for (int step = 0; step < 150; ++step) {
      const std::size_t before = clustering.number_of_clusters(), x = random() % before;
      switch (random() % 5) {
      case 0: clustering.freeze_cluster(x, random() % 2 == 0); break;
      case 1: clustering.minimize_round(); break;
      case 2:
        if (clustering.remove_cluster(x)) {
          ++removals;
          BOOST_REQUIRE_EQUAL(clustering.number_of_clusters(), before - 1);
        }
        break;
      default:
        if (const auto y = clustering.split_cluster(x)) {
          ++splits;
          BOOST_REQUIRE_EQUAL(*y, before);
          BOOST_REQUIRE_EQUAL(clustering.number_of_clusters(), before + 1);
        }
      }
      if (step % 5 == 0)
        BOOST_REQUIRE_EQUAL(fault(clustering, mesh), "");
    }
    for (std::size_t x = 0; x < clustering.number_of_clusters(); ++x)
      clustering.thaw_cluster(x);
    clustering.minimize();
    BOOST_CHECK(clustering.report().converged);
    BOOST_REQUIRE_EQUAL(fault(clustering, mesh), "");
    BOOST_CHECK_GT(splits, 20u);
    BOOST_CHECK_GT(removals, 5u);
    Mesh output;
    clustering.extract_dual_mesh(output, SMC::Centroid_placement());
    BOOST_CHECK(CGAL::is_valid_polygon_mesh(output));
    BOOST_CHECK_EQUAL(output.number_of_vertices(), clustering.number_of_clusters());
    const auto euler = [](const Mesh& m) {
      return long(m.number_of_vertices()) - long(m.number_of_edges()) + long(m.number_of_faces());
    };
    BOOST_CHECK_EQUAL(euler(output), euler(mesh));
  }
}

BOOST_AUTO_TEST_CASE(frozen_clusters_keep_their_faces)
{
  const Mesh mesh = test::to_mesh(generated::triangulated(generated::with_noise(generated::torus(40, 30), 0.05)));
  Clustering clustering(mesh);
  clustering.seed(60);
  clustering.grow();
  std::vector<std::size_t> before, after;
  for (const auto f : mesh.faces())
    before.push_back(clustering.cluster(f));
  for (std::size_t x = 0; x < 20; ++x)
    clustering.freeze_cluster(x);
  BOOST_CHECK(clustering.is_frozen(19));
  BOOST_CHECK(!clustering.is_frozen(20));
  BOOST_CHECK(!clustering.split_cluster(3));
  BOOST_CHECK(!clustering.remove_cluster(3));
  clustering.minimize();
  BOOST_CHECK_GT(clustering.report().moves, 100u);
  // Statistics continue after an edit.
  const SMC::Coarsening_report report = clustering.report();
  BOOST_REQUIRE(clustering.split_cluster(30));
  clustering.minimize_round();
  BOOST_CHECK_EQUAL(clustering.report().rounds, report.rounds + 1);
  BOOST_CHECK_GT(clustering.report().tests, report.tests);
  BOOST_CHECK_GE(clustering.report().moves, report.moves);
  for (const auto f : mesh.faces())
    after.push_back(clustering.cluster(f));
  for (std::size_t f = 0; f < before.size(); ++f)
    BOOST_CHECK(before[f] < 20 ? after[f] == before[f] : after[f] >= 20);
}

BOOST_AUTO_TEST_CASE(what_topology_needs_stays)
{
  const Mesh mesh = test::to_mesh(generated::triangle_sphere(3));
  Clustering clustering(mesh);
  BOOST_CHECK_THROW(clustering.split_cluster(0), std::logic_error);
  clustering.seed(4);
  clustering.grow();
  for (std::size_t x = 0; x < 4; ++x)
    BOOST_CHECK(!clustering.remove_cluster(x));
  BOOST_CHECK_THROW(clustering.freeze_cluster(4), SMC::Invalid_input);
  BOOST_CHECK_THROW(clustering.remove_cluster(4), SMC::Invalid_input);
  // Down to single faces, and back.
  bool has_changed = true;
  while (has_changed) {
    has_changed = false;
    for (std::size_t x = 0, n = clustering.number_of_clusters(); x < n; ++x)
      has_changed = clustering.split_cluster(x) || has_changed;
  }
  BOOST_CHECK_GT(clustering.number_of_clusters(), 200u);
  BOOST_CHECK_EQUAL(fault(clustering, mesh), "");
  has_changed = true;
  while (has_changed) {
    has_changed = false;
    for (std::size_t x = 0; x < clustering.number_of_clusters(); ++x)
      has_changed = clustering.remove_cluster(x) || has_changed;
  }
  BOOST_CHECK_LT(clustering.number_of_clusters(), 20u);
  BOOST_CHECK_EQUAL(fault(clustering, mesh), "");
}

BOOST_AUTO_TEST_SUITE_END()
