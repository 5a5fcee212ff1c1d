// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vertex exchange between regions during the fit (parameter `error_feedback`): the distance decreases, the number of vertices
// and the topology do not change, and the clusters remain valid.

#include "support/face_graphs.h"
#include "support/generate_meshes.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/place_and_exchange.h>
#include <CGAL/Surface_mesh_coarsening/is_valid_clustering.h>
#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_error_feedback)

namespace SMC = CGAL::Surface_mesh_coarsening;
using test::Mesh;

namespace {

struct Outcome
{
  Mesh mesh;
  SMC::Coarsening_report report;
  std::vector<std::size_t> labels;
};

template <class ConcurrencyTag = CGAL::Sequential_tag, class NamedParameters>
Outcome coarsened(const Mesh& input, std::size_t vertices, const NamedParameters& np)
{
  Outcome outcome;
  outcome.labels.resize(input.number_of_faces());
  const auto map = boost::make_function_property_map<Mesh::Face_index>(
    [&](Mesh::Face_index f) -> std::size_t& { return outcome.labels[std::size_t(f)]; });
  outcome.report = SMC::coarsen_mesh<ConcurrencyTag>(input, vertices, outcome.mesh, np.face_cluster_map(map));
  return outcome;
}

auto parameters(std::size_t rounds)
{
  return SMC::parameters::cluster_weight(SMC::Weighted_area_weight())
    .maximum_density(10.)
    .error_feedback(rounds);
}

void check_kept(const Mesh& input, const Outcome& outcome, std::size_t vertices)
{
  const Mesh& mesh = outcome.mesh;
  BOOST_TEST(mesh.number_of_vertices() == vertices);
  BOOST_TEST(CGAL::is_valid_polygon_mesh(mesh));
  const auto euler = [](const Mesh& m) {
    return long(m.number_of_vertices()) - long(m.number_of_edges()) + long(m.number_of_faces());
  };
  BOOST_TEST(euler(mesh) == euler(input));
  BOOST_TEST(CGAL::is_closed(mesh) == CGAL::is_closed(input));
  const auto map = boost::make_function_property_map<Mesh::Face_index>(
    [&](Mesh::Face_index f) { return outcome.labels[std::size_t(f)]; });
  if (100 * vertices <= 9 * input.number_of_vertices()) // clusters of faces, not of cells
    BOOST_TEST(SMC::is_valid_clustering(input, map));
}

[[maybe_unused]] bool are_equal(const Mesh& a, const Mesh& b)
{
  if (a.number_of_vertices() != b.number_of_vertices() || a.number_of_faces() != b.number_of_faces())
    return false;
  for (const auto v : a.vertices())
    if (a.point(v) != b.point(v))
      return false;
  for (const auto h : a.halfedges())
    if (a.target(h) != b.target(h))
      return false;
  return true;
}

Mesh data_mesh(const std::string& name)
{
  Mesh mesh;
  BOOST_REQUIRE(CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + name), mesh));
  return mesh;
}

} // namespace

// Models with sharp edges, smooth ones, and one with borders.
BOOST_AUTO_TEST_CASE(distance_falls)
{
  const struct
  {
    std::string name;
    std::size_t vertices;
    double factor; // by which the distance falls
  } cases[] = {{"fandisk.off", 527, 0.8}, {"elephant.off", 277, 0.97}, {"mannequin-devil.off", 259, 0.9},
               {"blobby.off", 202, 0.97}, {"lion-head.off", 417, 0.9}};
  for (const auto& c : cases) {
    BOOST_TEST_CONTEXT(c.name)
    {
      const Mesh input = data_mesh(c.name);
      const Outcome without = coarsened(input, c.vertices, parameters(0)), with = coarsened(input, c.vertices, parameters(7));
      check_kept(input, with, c.vertices);
      BOOST_TEST(without.report.exchanged_vertices == 0);
      BOOST_TEST(with.report.exchanged_vertices > 0);
      const auto before = SMC::measure_coarsening(input, without.mesh, 20000),
                 after = SMC::measure_coarsening(input, with.mesh, 20000);
      BOOST_TEST(after.rms_distance <= c.factor * before.rms_distance);
      BOOST_TEST(after.mean_smallest_angle >= 40);
    }
  }
}

// With a small goal for the mean angle, movements are judged. The Fandisk has narrow triangles between which searches for closest
// points lose their way.
BOOST_AUTO_TEST_CASE(only_the_distance_counts)
{
  const struct
  {
    std::string name;
    std::size_t vertices;
    double factor; // by which the distance falls
  } cases[] = {{"fandisk.off", 648, 0.55}, {"elephant.off", 277, 0.93}, {"blobby.off", 202, 1}};
  const auto closest = SMC::parameters::vertex_placement(SMC::Fitted_placement(5, 0));
  for (const auto& c : cases) {
    BOOST_TEST_CONTEXT(c.name)
    {
      const Mesh input = data_mesh(c.name);
      Mesh output, by_default, again;
      const auto report = SMC::coarsen_mesh(input, c.vertices, output, closest);
      BOOST_TEST(output.number_of_vertices() == c.vertices);
      BOOST_TEST(CGAL::is_valid_polygon_mesh(output));
      BOOST_TEST(CGAL::is_closed(output));
      BOOST_TEST(report.exchanged_vertices > 0);
      SMC::coarsen_mesh(input, c.vertices, by_default);
      const auto q = SMC::measure_coarsening(input, output, 20000), other = SMC::measure_coarsening(input, by_default, 20000);
      BOOST_TEST(q.rms_distance < c.factor * other.rms_distance);
      BOOST_TEST(q.mean_smallest_angle < other.mean_smallest_angle);
#ifdef CGAL_LINKED_WITH_TBB
      SMC::coarsen_mesh<CGAL::Parallel_tag>(input, c.vertices, again, closest);
      BOOST_TEST(are_equal(output, again));
#endif
    }
  }
}

// A smaller goal for the mean angle lowers the distance.
BOOST_AUTO_TEST_CASE(distance_is_traded_for_angles)
{
  const std::pair<std::string, std::size_t> cases[] = {{"fandisk.off", 648}, {"elephant.off", 277}};
  for (const auto& [name, vertices] : cases) {
    const Mesh input = data_mesh(name);
    double distance = 0, angle = 0;
    for (const double goal : {0, 33, 38, 40})
      BOOST_TEST_CONTEXT(name << ", goal of " << goal << " degrees")
      {
        Mesh output;
        SMC::coarsen_mesh(input, vertices, output, SMC::parameters::vertex_placement(SMC::Fitted_placement(5, goal)));
        const SMC::Coarsening_quality q = SMC::measure_coarsening(input, output, 20000);
        BOOST_TEST(q.rms_distance > distance);
        BOOST_TEST(q.mean_smallest_angle > angle);
        BOOST_TEST(q.mean_smallest_angle >= goal);
        distance = q.rms_distance;
        angle = q.mean_smallest_angle;
      }
  }
}

BOOST_AUTO_TEST_CASE(default_depends_on_densities)
{
  const Mesh input = data_mesh("blobby.off");
  const auto np = SMC::parameters::vertex_placement(SMC::Fitted_placement());
  BOOST_TEST(coarsened(input, 202, np).report.exchanged_vertices > 0);
  const auto densities = boost::make_function_property_map<Mesh::Face_index>([](Mesh::Face_index) { return 1.; });
  BOOST_TEST(coarsened(input, 202, np.face_density_map(densities)).report.exchanged_vertices == 0);
  BOOST_TEST(coarsened(input, 202, np.face_density_map(densities).error_feedback(3)).report.exchanged_vertices > 0);
  // Other placements process one cluster at a time.
  const auto quadric = SMC::parameters::vertex_placement(SMC::Quadric_placement());
  BOOST_TEST(coarsened(input, 202, quadric.error_feedback(7)).report.exchanged_vertices == 0);
}

BOOST_AUTO_TEST_CASE(same_on_any_number_of_threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  const Mesh input = data_mesh("elephant.off");
  const Outcome one = coarsened(input, 277, parameters(7)), many = coarsened<CGAL::Parallel_tag>(input, 277, parameters(7));
  BOOST_TEST(are_equal(one.mesh, many.mesh));
  BOOST_TEST(one.labels == many.labels);
#endif
}

// Relocated clusters are valid, keep their vertices within their bounds, and can be restored.
BOOST_AUTO_TEST_CASE(relocations_are_valid_and_can_be_undone)
{
  using namespace SMC::internal;
  constexpr std::size_t n = 60;
  const Mesh mesh = test::to_mesh(generated::triangle_sphere(4));
  SMC::Mwcvd_clustering<Mesh, SMC::Weighted_area_weight> clustering(mesh);
  clustering.seed(n);
  clustering.grow();
  const Clustering_state& state = clustering.state();
  const std::vector<Index> labels = state.labels->labels();
  Cluster_relocation clusters(state.featured_input(), *state.labels, Index(n));
  const Clustering_input& items = state.featured_input().items;
  std::vector<Vector> positions(n);
  for (std::size_t f = 0; f < labels.size(); ++f)
    positions[labels[f]] = items.centroid(Index(f));
  for (std::size_t x = 0; x < n; ++x) {
    const Index f = Index(x * 7919 % mesh.number_of_faces());
    const Vector before = std::exchange(positions[x], items.centroid(f));
    if (clusters.relocate(Index(x), NONE, {f}, positions) != Relocation::DONE)
      positions[x] = before;
  }
  BOOST_TEST(clusters.number() > n / 4);
  for (std::size_t x = 0; x < n; ++x)
    if (clusters.has_changed(Index(x)))
      BOOST_TEST((closest_in_box(positions[x], clusters.vertex_bounds(Index(x))) == positions[x]));
  const auto map = boost::make_function_property_map<Mesh::Face_index>([&](Mesh::Face_index f) { return (*state.labels)[f]; });
  BOOST_TEST(SMC::is_valid_clustering(mesh, map));
  const std::vector<Index> after = state.labels->labels();
  BOOST_TEST(std::set<Index>(after.begin(), after.end()).size() == n);
  clusters.undo();
  BOOST_TEST(clusters.number() == 0);
  BOOST_TEST((state.labels->labels() == labels));
}

// A cluster on the border can be split, but it keeps its faces on the border.
BOOST_AUTO_TEST_CASE(clusters_on_the_border_keep_it)
{
  using namespace SMC::internal;
  constexpr std::size_t n = 12;
  const Mesh mesh = test::to_mesh(generated::grid(30, 30));
  SMC::Mwcvd_clustering<Mesh, SMC::Weighted_area_weight> clustering(mesh);
  clustering.seed(n);
  clustering.grow();
  const Clustering_state& state = clustering.state();
  const Clustering_input& items = state.featured_input().items;
  const std::vector<Index> labels = state.labels->labels();
  std::vector<bool> has_border(n);
  std::vector<Vector> positions(n);
  const auto is_on_border = [&](std::size_t f) {
    const auto corners = items.mesh.corners(f);
    return std::any_of(corners.begin(), corners.end(), [&](Index c) { return items.mesh.is_on_border(items.mesh.corner_vertex[c]); });
  };
  for (std::size_t f = 0; f < labels.size(); ++f) {
    positions[labels[f]] = items.centroid(Index(f));
    has_border[labels[f]] = has_border[labels[f]] || is_on_border(f);
  }
  Cluster_relocation clusters(state.featured_input(), *state.labels, Index(n));
  const auto inner = std::find(has_border.begin(), has_border.end(), false);
  BOOST_REQUIRE((inner != has_border.end()));
  const Index x = Index(inner - has_border.begin());
  for (std::size_t f = 0; f < labels.size() && clusters.number() == 0; ++f)
    if (has_border[labels[f]] && !is_on_border(f)) {
      const Vector before = std::exchange(positions[x], items.centroid(Index(f)));
      if (clusters.relocate(x, NONE, {Index(f)}, positions) != Relocation::DONE)
        positions[x] = before;
    }
  BOOST_TEST(clusters.number() == 1);
  for (std::size_t f = 0; f < labels.size(); ++f)
    if (is_on_border(f))
      BOOST_TEST((*state.labels)[Index(f)] == labels[f]);
  const auto map = boost::make_function_property_map<Mesh::Face_index>([&](Mesh::Face_index f) { return (*state.labels)[f]; });
  BOOST_TEST(SMC::is_valid_clustering(mesh, map));
}

BOOST_AUTO_TEST_CASE(features_stay)
{
  const Mesh input = data_mesh("elephant.off");
  const auto patches = boost::make_function_property_map<Mesh::Face_index>(
    [&](Mesh::Face_index f) { return int(input.point(input.target(input.halfedge(f))).z() > 0); });
  const auto np = parameters(7).face_patch_map(patches);
  const Outcome with = coarsened(input, 277, np), without = coarsened(input, 277, np.error_feedback(0));
  BOOST_TEST(with.mesh.number_of_vertices() == 277);
  BOOST_TEST(CGAL::is_valid_polygon_mesh(with.mesh));
  BOOST_TEST(with.report.exchanged_vertices > 0);
  BOOST_TEST(with.report.feature_lines == without.report.feature_lines);
  BOOST_TEST(with.report.feature_corners == without.report.feature_corners);
  const auto before = SMC::measure_coarsening(input, without.mesh, 20000),
             after = SMC::measure_coarsening(input, with.mesh, 20000);
  BOOST_TEST(after.rms_distance < before.rms_distance);
}

// Thin sheets near each other, which the repair has to keep apart: what exchanges do not improve in the end is undone.
BOOST_AUTO_TEST_CASE(thin_parts_do_not_get_worse)
{
  const struct
  {
    std::string name;
    std::size_t vertices;
  } cases[] = {{"couplingdown.off", 36}, {"rotor.off", 170}, {"spool.off", 12}};
  for (const auto& c : cases) {
    BOOST_TEST_CONTEXT(c.name)
    {
      const Mesh input = data_mesh(c.name);
      const Outcome without = coarsened(input, c.vertices, parameters(0)), with = coarsened(input, c.vertices, parameters(7));
      check_kept(input, with, c.vertices);
      BOOST_TEST(with.report.intersections_left <= without.report.intersections_left);
      const auto before = SMC::measure_coarsening(input, without.mesh, 20000),
                 after = SMC::measure_coarsening(input, with.mesh, 20000);
      if (with.report.intersections_left == without.report.intersections_left)
        BOOST_TEST(after.rms_distance <= before.rms_distance);
    }
  }
}

// Returns the smallest angle of each triangle in degrees.
std::vector<double> smallest_angles(const Mesh& mesh)
{
  std::vector<double> angles;
  for (const auto f : mesh.faces()) {
    double smallest = 180;
    for (const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
      smallest = (std::min)(smallest, CGAL::approximate_angle(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                                              mesh.point(mesh.target(mesh.next(h)))));
    angles.push_back(smallest);
  }
  return angles;
}

// Smooth models have no small angles, and few below 25 degrees with error feedback.
BOOST_AUTO_TEST_CASE(angles_stay_large)
{
  const std::pair<std::string, std::size_t> cases[] = {
    {"elephant.off", 139}, {"blobby.off", 202}, {"eight.off", 94}};
  for (const auto& [name, vertices] : cases)
    for (const std::size_t rounds : {std::size_t(0), SMC::Coarsening_defaults::error_feedback}) {
      const Outcome outcome = coarsened(data_mesh(name), vertices, parameters(rounds));
      const Mesh& mesh = outcome.mesh;
      const std::vector<double> angles = smallest_angles(mesh);
      const double least = *std::min_element(angles.begin(), angles.end());
      const auto narrow = std::count_if(angles.begin(), angles.end(), [](double angle) { return angle < 25; });
      BOOST_TEST_CONTEXT(name << ", " << rounds << " rounds")
      {
        // Without exchanges, flips create angles down to 7 degrees.
        BOOST_TEST(least >= (rounds > 0 ? 8 : 7));
        if (rounds > 0)
          BOOST_TEST(double(narrow) <= 0.07 * double(mesh.number_of_faces()));
        BOOST_TEST(outcome.report.narrow_faces.empty() == (least >= 10));
      }
    }
}

// Cells of vertices, too, have few triangles with angles below 25 degrees. Their share scatters by two points from one number of
// vertices to the next, so it is summed.
BOOST_AUTO_TEST_CASE(angles_stay_large_with_cells)
{
  std::size_t narrow = 0, triangles = 0;
  for (const std::size_t vertices : {240, 300}) {
    const Outcome outcome = coarsened(data_mesh("elephant.off"), vertices, parameters(SMC::Coarsening_defaults::error_feedback));
    const std::vector<double> angles = smallest_angles(outcome.mesh);
    BOOST_TEST(*std::min_element(angles.begin(), angles.end()) >= 8);
    narrow += std::size_t(std::count_if(angles.begin(), angles.end(), [](double angle) { return angle < 25; }));
    triangles += angles.size();
  }
  BOOST_TEST(double(narrow) <= 0.06 * double(triangles));
}

// If the mean angle falls slightly short of its goal, further rounds restore it, and the exchanges are kept.
BOOST_AUTO_TEST_CASE(small_angle_deficits_do_not_undo_exchanges)
{
  const std::pair<std::string, std::size_t> cases[] = {{"head.off", 74}, {"cylinder.off", 108}};
  for (const auto& [name, vertices] : cases)
    BOOST_TEST_CONTEXT(name)
    {
      const Outcome outcome = coarsened(data_mesh(name), vertices, parameters(7));
      BOOST_TEST(outcome.report.exchanged_vertices > 0);
      const std::vector<double> angles = smallest_angles(outcome.mesh);
      BOOST_TEST(std::accumulate(angles.begin(), angles.end(), 0.) >= 39.5 * double(angles.size()));
    }
}

// The repair leaves no narrow triangles where other changes remove the faults, too.
BOOST_AUTO_TEST_CASE(repair_makes_no_narrow_triangles)
{
  const std::pair<std::string, std::size_t> cases[] = {{"femur.off", 155}, {"mech-holes-shark.off", 209}, {"pipe.off", 32}};
  for (const auto& [name, vertices] : cases)
    BOOST_TEST_CONTEXT(name)
    {
      const SMC::Coarsening_report report = coarsened(data_mesh(name), vertices, parameters(0)).report;
      BOOST_TEST(report.intersections_found + report.reversals_found > 0);
      BOOST_TEST(report.intersections_left == 0);
      BOOST_TEST(report.narrow_faces.empty());
    }
}

// The report names the faces that intersect where the input does not: here it does nowhere.
BOOST_AUTO_TEST_CASE(intersecting_faces_are_named)
{
  typedef std::pair<std::size_t, std::size_t> Pair;
  const Outcome outcome = coarsened(data_mesh("couplingdown.off"), 36, parameters(7));
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index> > found;
  CGAL::Polygon_mesh_processing::self_intersections(outcome.mesh, std::back_inserter(found));
  std::set<Pair> pairs, named;
  for (const auto& p : found)
    pairs.insert(std::minmax({std::size_t(p.first), std::size_t(p.second)}));
  for (const Pair& p : outcome.report.intersecting_faces)
    named.insert(std::minmax({p.first, p.second}));
  BOOST_TEST(!pairs.empty());
  BOOST_TEST((named == pairs));
  BOOST_TEST(outcome.report.intersections_left == pairs.size());
}

// Counts rounds of feedback that follow a repair.
struct Repair_visitor : SMC::Coarsening_visitor_base
{
  std::size_t seedings = 0, relocations = 0;
  bool has_repaired = false;

  void stage_begins(SMC::Coarsening_stage stage)
  {
    seedings += stage == SMC::Coarsening_stage::SEEDING;
    relocations += stage == SMC::Coarsening_stage::FEEDBACK && has_repaired;
  }
  void stage_ends(SMC::Coarsening_stage stage)
  {
    has_repaired = stage == SMC::Coarsening_stage::REPAIR || (has_repaired && stage != SMC::Coarsening_stage::SEEDING);
  }
};

// Vertices are relocated to triangles that still intersect after the repair, at most four times. The clusters remain valid, and
// the report counts the pairs of the result. No triangle intersects any more in at least one case.
BOOST_AUTO_TEST_CASE(vertices_move_to_intersections)
{
  std::size_t solved = 0;
  const std::pair<std::string, std::size_t> cases[] = {
    {"anchor_dense.off", 37}, {"anchor.off", 20}, {"P.off", 7}, {"elephant.off", 277}};
  for (const auto& [name, vertices] : cases)
    BOOST_TEST_CONTEXT(name)
    {
      const Mesh input = data_mesh(name);
      Repair_visitor visitor;
      const Outcome outcome = coarsened(input, vertices, parameters(12).visitor(std::ref(visitor)));
      check_kept(input, outcome, vertices);
      std::vector<std::pair<Mesh::Face_index, Mesh::Face_index> > pairs;
      CGAL::Polygon_mesh_processing::self_intersections(outcome.mesh, std::back_inserter(pairs));
      BOOST_TEST(outcome.report.intersections_left == pairs.size());
      BOOST_TEST(outcome.report.intersections_left <= outcome.report.intersections_found);
      BOOST_TEST(visitor.relocations <= 4 * visitor.seedings);
      BOOST_TEST((visitor.relocations == 0 || outcome.report.intersections_found > 0));
      solved += visitor.seedings == 1 && visitor.relocations > 0 && pairs.empty();
    }
  BOOST_TEST(solved > 0);
}

// Given or frozen clusters do not change.
BOOST_AUTO_TEST_CASE(clusters_by_hand_stay)
{
  const Mesh input = data_mesh("eight.off");
  typedef SMC::Mwcvd_clustering<Mesh, SMC::Weighted_area_weight> Clustering;
  const auto labels_after = [&](bool freezes) {
    Clustering clustering(input, parameters(7));
    clustering.seed(94);
    clustering.grow();
    clustering.minimize();
    if (freezes)
      clustering.freeze_cluster(0);
    std::vector<std::size_t> before, after;
    for (const auto f : input.faces())
      before.push_back(clustering.cluster(f));
    Mesh output;
    clustering.extract_embedded_dual_mesh(output, SMC::Fitted_placement());
    for (const auto f : input.faces())
      after.push_back(clustering.cluster(f));
    return before == after;
  };
  BOOST_TEST(labels_after(true));
  BOOST_TEST(!labels_after(false));
}

// Later stages continue with the current clusters.
BOOST_AUTO_TEST_CASE(levels_and_editing_go_on)
{
  const Mesh input = data_mesh("elephant.off");
  SMC::Mwcvd_clustering<Mesh, SMC::Weighted_area_weight> clustering(input, parameters(7));
  clustering.seed(277);
  clustering.grow();
  clustering.minimize();
  Mesh output;
  clustering.extract_embedded_dual_mesh(output, SMC::Fitted_placement());
  BOOST_TEST(clustering.report().exchanged_vertices > 0);
  const double energy = clustering.energy();
  clustering.minimize();
  BOOST_TEST(clustering.energy() < energy);
  BOOST_TEST(clustering.split_cluster(0).has_value());
  clustering.extract_dual_mesh(output);
  BOOST_TEST(output.number_of_vertices() == 278);
  BOOST_TEST(CGAL::is_valid_polygon_mesh(output));
}

// The vertices of each triangle belong to clusters of one component of the input, and no component gets more vertices than it
// has, also where components overlap.
BOOST_AUTO_TEST_CASE(clusters_stay_on_their_component)
{
  const generated::Soup sphere = generated::triangle_sphere(2);
  for (const double shift : {0.05, 0.4, 1.3}) {
    const generated::Soup both = generated::joined(sphere, generated::translated(generated::scaled(sphere, 1, 0.9, 1.1), shift, 0.01, 0.02));
    Mesh input = test::to_mesh(generated::joined(both, generated::translated(sphere, 0, shift, 0)));
    const auto component = input.add_property_map<Mesh::Face_index, std::size_t>("f:component", 0).first;
    const std::size_t components = CGAL::Polygon_mesh_processing::connected_components(input, component);
    BOOST_TEST_REQUIRE(components == 3);
    for (std::size_t vertices = 14; 10 * vertices <= 3 * input.number_of_vertices(); vertices += 3) {
      const Outcome outcome = coarsened(input, vertices, parameters(8));
      std::vector<std::size_t> of_cluster(vertices, components), number(components, 0);
      for (const auto f : input.faces()) {
        std::size_t& c = of_cluster[outcome.labels[std::size_t(f)]];
        BOOST_TEST_REQUIRE((c == components || c == component[f]));
        c = component[f];
      }
      for (const std::size_t c : of_cluster)
        ++number[c];
      for (const std::size_t n : number)
        BOOST_TEST(n <= sphere.points.size());
      for (const auto f : outcome.mesh.faces()) {
        std::set<std::size_t> of_corners;
        for (const auto v : outcome.mesh.vertices_around_face(outcome.mesh.halfedge(f)))
          of_corners.insert(of_cluster[std::size_t(v)]);
        BOOST_TEST(of_corners.size() == 1u);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
