// SPDX-License-Identifier: GPL-3.0-or-later
//
// A visitor can cancel quickly at any stage of the coarsening, and nothing has changed then. The test reads no clock but
// counts the calls of the visitor.

#include "support/face_graphs.h"

#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_cancelling)

namespace SMC = CGAL::Surface_mesh_coarsening;
using SMC::Coarsening_stage;
using test::Mesh;

namespace {

constexpr std::size_t never = (std::numeric_limits<std::size_t>::max)();

// Counts its calls stage by stage, and cancels from a given call on.
struct Asked_visitor : SMC::Coarsening_visitor_base
{
  std::size_t refused;
  std::size_t total = 0, rounds = 0;
  std::vector<std::size_t> in_stage = std::vector<std::size_t>(8, 0);
  Coarsening_stage stage = Coarsening_stage::PREPARATION;

  explicit Asked_visitor(std::size_t refused = never) : refused(refused) {}
  void stage_begins(Coarsening_stage s) { stage = s; }
  void round_done(std::size_t, std::size_t, double) { ++rounds; }
  bool go_further()
  {
    ++in_stage[std::size_t(stage)];
    return total++ < refused;
  }
};

constexpr std::size_t untouched = 12345678;

template <class Parameters>
bool is_cancelled(const Mesh& mesh, std::size_t number, Asked_visitor& visitor, const Parameters& parameters)
{
  const generated::Soup other = generated::grid(3, 2);
  Mesh output = test::to_mesh(other);
  std::vector<std::size_t> clusters(num_faces(mesh), untouched), counts(num_vertices(mesh), untouched);
  const auto np = parameters.visitor(std::ref(visitor))
                    .face_cluster_map(boost::make_iterator_property_map(clusters.begin(), get(CGAL::face_index, mesh)))
                    .vertex_boundary_count_map(
                      boost::make_iterator_property_map(counts.begin(), get(boost::vertex_index, mesh)));
  try {
    SMC::coarsen_mesh(mesh, number, output, np);
  } catch (const SMC::Coarsening_cancelled&) {
    BOOST_CHECK(test::to_soup(output).polygons == other.polygons);
    BOOST_CHECK(test::to_soup(output).points == other.points);
    BOOST_CHECK_EQUAL(std::count(clusters.begin(), clusters.end(), untouched), clusters.size());
    BOOST_CHECK_EQUAL(std::count(counts.begin(), counts.end(), untouched), counts.size());
    BOOST_CHECK_EQUAL(visitor.total, visitor.refused + 1); // not called again
    return true;
  }
  BOOST_CHECK_EQUAL(output.number_of_vertices(), number);
  BOOST_CHECK_EQUAL(std::count(clusters.begin(), clusters.end(), untouched), 0);
  return false;
}

// Cancels at each call, for at most `runs` evenly spread calls.
template <class Parameters>
void check_refusals(const Mesh& mesh, std::size_t number, std::size_t runs, const Parameters& parameters)
{
  Asked_visitor all;
  BOOST_REQUIRE(!is_cancelled(mesh, number, all, parameters));
  const std::size_t stride = 1 + all.total / runs;
  for (std::size_t k = 0; k < all.total; k += stride) {
    Asked_visitor visitor(k);
    BOOST_CHECK(is_cancelled(mesh, number, visitor, parameters));
  }
  Asked_visitor last(all.total - 1);
  BOOST_CHECK(is_cancelled(mesh, number, last, parameters));
}

// At least once per 100,000 faces and pass over all of them.
void check_questions(const Mesh& mesh, std::size_t number)
{
  const std::size_t faces = num_faces(mesh), often = faces / 100000;
  Asked_visitor visitor;
  BOOST_REQUIRE(!is_cancelled(mesh, number, visitor, SMC::parameters::number_of_iterations(5)));
  const auto asked = [&](Coarsening_stage stage) { return visitor.in_stage[std::size_t(stage)]; };
  BOOST_TEST_MESSAGE(faces << " faces: " << asked(Coarsening_stage::PREPARATION) << ", "
                           << asked(Coarsening_stage::SEEDING) << ", " << asked(Coarsening_stage::GROWTH) << ", "
                           << asked(Coarsening_stage::MINIMIZATION) << ", " << asked(Coarsening_stage::TRIANGULATION) << ", "
                           << asked(Coarsening_stage::PLACEMENT) << ", " << asked(Coarsening_stage::FEEDBACK) << ", "
                           << asked(Coarsening_stage::REPAIR) << " questions in the stages");
  BOOST_CHECK_GE(asked(Coarsening_stage::PREPARATION), 10 * often); // it has many passes
  BOOST_CHECK_GE(asked(Coarsening_stage::SEEDING), often);
  BOOST_CHECK_GE(asked(Coarsening_stage::GROWTH), 2 * often);
  BOOST_CHECK_GE(asked(Coarsening_stage::MINIMIZATION), visitor.rounds * (1 + often / 5));
  BOOST_CHECK_GE(asked(Coarsening_stage::TRIANGULATION), often);
  BOOST_CHECK_GE(asked(Coarsening_stage::PLACEMENT), 2 * often); // it has several rounds
  BOOST_CHECK_GE(asked(Coarsening_stage::FEEDBACK), 2 * often);
}

} // namespace

BOOST_AUTO_TEST_CASE(asked_often_enough)
{
  const Mesh mesh = test::to_mesh(generated::triangle_sphere(8));
  BOOST_REQUIRE_GE(num_faces(mesh), 500000u);
  check_questions(mesh, 5000);
}

// Many small pieces count together.
BOOST_AUTO_TEST_CASE(asked_often_enough_among_many_components)
{
  const Mesh mesh = test::to_mesh(generated::many_tetrahedra(10000));
  Asked_visitor visitor;
  BOOST_REQUIRE(!is_cancelled(mesh, 40000, visitor, SMC::parameters::number_of_iterations(2)));
  for (const Coarsening_stage stage : {Coarsening_stage::PREPARATION, Coarsening_stage::SEEDING, Coarsening_stage::GROWTH,
                                       Coarsening_stage::TRIANGULATION, Coarsening_stage::PLACEMENT})
    BOOST_CHECK_GE(visitor.in_stage[std::size_t(stage)], 4u);
}

BOOST_AUTO_TEST_CASE(refused_at_any_question)
{
  const Mesh mesh = test::to_mesh(generated::with_holes(generated::triangle_sphere(5), 3));
  check_refusals(mesh, 400, 60, SMC::parameters::maximum_density(50.));
  check_refusals(mesh, 400, 40, SMC::parameters::subdivide_input(true).vertex_placement(SMC::Quadric_placement()));
}

BOOST_AUTO_TEST_CASE(refused_while_pieces_are_cut)
{
  // Whole faces cannot form this many clusters.
  const Mesh mesh = test::to_mesh(generated::many_tetrahedra(3000));
  check_refusals(mesh, 12000, 40, SMC::parameters::number_of_iterations(3));
}

// Other face graphs are filled in another way.
BOOST_AUTO_TEST_CASE(other_output)
{
  typedef CGAL::Polyhedron_3<test::Kernel, CGAL::Polyhedron_items_with_id_3> Polyhedron;
  const Mesh mesh = test::to_mesh(generated::triangle_sphere(5));
  Asked_visitor all;
  Polyhedron output;
  SMC::coarsen_mesh(mesh, 20, output, SMC::parameters::visitor(std::ref(all)));
  SMC::coarsen_mesh(mesh, 300, output);
  BOOST_CHECK_EQUAL(output.size_of_vertices(), 300u);
  for (std::size_t k = 0; k < all.total; k += 1 + all.total / 10) {
    Asked_visitor visitor(k);
    BOOST_CHECK_THROW(SMC::coarsen_mesh(mesh, 20, output, SMC::parameters::visitor(std::ref(visitor))),
                      SMC::Coarsening_cancelled);
    BOOST_CHECK_EQUAL(output.size_of_vertices(), 300u);
  }
}

// After a cancellation the object can start again, with the result of an object that was never cancelled.
BOOST_AUTO_TEST_CASE(steps_restart)
{
  typedef SMC::Mwcvd_clustering<Mesh> Clustering;
  const Mesh mesh = test::to_mesh(generated::triangle_sphere(5));
  Asked_visitor all;
  Clustering expected(mesh, SMC::parameters::visitor(std::ref(all)));
  const std::size_t prepared = all.total;
  expected.seed(200);
  expected.grow();
  const std::size_t grown = all.total;
  const std::size_t most = SMC::Coarsening_defaults::number_of_iterations;
  expected.minimize(most, 0);
  for (std::size_t k = prepared; k < all.total; k += 1 + (all.total - prepared) / 15) {
    Asked_visitor visitor(k);
    Clustering clustering(mesh, SMC::parameters::visitor(std::ref(visitor)));
    const auto run = [&] {
      clustering.seed(200);
      clustering.grow();
      clustering.minimize(most, 0);
    };
    BOOST_CHECK_THROW(run(), SMC::Coarsening_cancelled);
    visitor.refused = never;
    if (k < grown) {
      BOOST_CHECK_THROW(clustering.minimize(), std::logic_error);
      run();
    } else
      clustering.minimize(most, 0); // from where it was
    BOOST_CHECK_EQUAL(clustering.number_of_clusters(), 200u);
    if (k < grown)
      BOOST_CHECK_EQUAL(clustering.energy(), expected.energy());
  }
}

BOOST_AUTO_TEST_SUITE_END()
