// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fast tests of moves and of clusterings agree with brute force on millions of cases: random small surfaces,
// random labels, every move.

#include "support/face_graphs.h"
#include "support/random_surfaces.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/is_valid_clustering.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/function_property_map.hpp>

#include <map>

BOOST_AUTO_TEST_SUITE(test_validity)

namespace SMC = CGAL::Surface_mesh_coarsening;
using generated::Soup;
using reference::Labels;
using reference::Reference_mesh;
using SMC::internal::Index;
using test::Mesh;

namespace {

std::string text(const Soup& s)
{
  std::string t;
  for (const generated::Polygon& p : s.polygons) {
    t += "(";
    for (const std::size_t v : p)
      t += std::to_string(v) + (v == p.back() ? ")" : " ");
  }
  return t;
}

std::string text(const Labels& labels)
{
  std::string t;
  for (const std::size_t x : labels)
    t += std::to_string(x) + " ";
  return t;
}

struct Surface
{
  explicit Surface(const Soup& soup) : reference(soup), mesh(test::to_mesh(soup))
  {
    const auto np = CGAL::parameters::default_values();
    const auto numbering = SMC::internal::numbering(mesh, np);
    SMC::internal::Local_frame frame;
    input = SMC::internal::clustering_input(mesh, np, numbering, frame, SMC::internal::Run_context());
  }

  Reference_mesh reference;
  Mesh mesh;
  SMC::internal::Clustering_input input;
};

// Labels from random seeds, grown at random: connected clusters, discs or not.
Labels random_connected_labels(const Reference_mesh& m, std::size_t clusters, std::mt19937& engine)
{
  Labels labels(m.number_of_faces(), reference::none);
  std::vector<std::size_t> front;
  for (std::size_t x = 0; x < clusters;) {
    const std::size_t f = engine() % labels.size();
    if (labels[f] == reference::none) {
      labels[f] = x++;
      front.push_back(f);
    }
  }
  while (!front.empty()) {
    const std::size_t i = engine() % front.size(), f = front[i];
    std::vector<std::size_t> free;
    for (const std::size_t g : m.faces_across(f))
      if (g != reference::none && labels[g] == reference::none)
        free.push_back(g);
    if (free.empty()) {
      front[i] = front.back();
      front.pop_back();
      continue;
    }
    const std::size_t g = free[engine() % free.size()];
    labels[g] = labels[f];
    front.push_back(g);
  }
  for (std::size_t f = 0; f < labels.size(); ++f) // components without a seed
    if (labels[f] == reference::none) {
      std::vector<std::size_t> stack(1, f);
      labels[f] = clusters;
      while (!stack.empty()) {
        const std::size_t g = stack.back();
        stack.pop_back();
        for (const std::size_t h : m.faces_across(g))
          if (h != reference::none && labels[h] == reference::none) {
            labels[h] = clusters;
            stack.push_back(h);
          }
      }
      ++clusters;
    }
  return labels;
}

struct Statistics
{
  std::size_t surfaces = 0, clusterings = 0, moves = 0, allowed = 0, wrong = 0;
};

// Compares all moves from valid labels, and continues with the result of an allowed move.
void walk(Surface& s, Labels labels, std::size_t steps, std::mt19937& engine, Statistics& statistics)
{
  const std::size_t clusters = reference::number_of_clusters(labels);
  SMC::internal::Cluster_labels fast(s.input.mesh);
  for (std::size_t f = 0; f < labels.size(); ++f)
    fast.set(Index(f), Index(labels[f]));
  fast.recount();
  SMC::internal::Valid_moves moves(fast, nullptr);
  std::vector<std::pair<std::size_t, std::size_t> > allowed;
  for (std::size_t step = 0; step < steps; ++step) {
    ++statistics.clusterings;
    allowed.clear();
    for (std::size_t f = 0; f < labels.size(); ++f) {
      const std::size_t from = labels[f];
      std::vector<std::size_t> tried(1, from);
      for (const std::size_t g : s.reference.faces_across(f)) {
        if (g == reference::none || std::find(tried.begin(), tried.end(), labels[g]) != tried.end())
          continue;
        const std::size_t to = labels[g];
        tried.push_back(to);
        const bool moved = moves.move(Index(f), Index(to));
        labels[f] = to;
        const std::string fault = reference::number_of_clusters(labels) != clusters
                                    ? "the last cluster is empty"
                                    : reference::fault_of_clustering(s.reference, labels);
        labels[f] = from;
        ++statistics.moves;
        if (fault.empty())
          allowed.emplace_back(f, to);
        if (moved != fault.empty() && statistics.wrong++ < 5)
          BOOST_ERROR("face " << f << " to " << to << ": the fast check says " << moved << ", brute force: '" << fault
                              << "'; faces " << text(s.reference.soup()) << " labels " << text(labels));
        if (fast[Index(f)] != from)
          fast.move(Index(f), Index(from));
      }
    }
    statistics.allowed += allowed.size();
    if (allowed.empty())
      return;
    const auto move = allowed[engine() % allowed.size()];
    fast.move(Index(move.first), Index(move.second));
    labels[move.first] = move.second;
  }
  BOOST_CHECK(fast.boundary_counts() == fast.recounted());
}

bool fast_validity(const Surface& s, const Labels& labels)
{
  return SMC::is_valid_clustering(
    s.mesh, boost::make_function_property_map<Mesh::Face_index>([&](Mesh::Face_index f) { return labels[f]; }));
}

// Seeds and grows; empty if the number is too small, or if faces had to be subdivided.
Labels labels_of_library(const Mesh& mesh, std::size_t n)
{
  try {
    SMC::Mwcvd_clustering<Mesh, SMC::Uniform_weight> c(mesh);
    c.seed(n);
    c.grow();
    return c.report().subdivided_components == 0 ? test::labels_in(c, mesh) : Labels();
  } catch (const SMC::Unreachable_number_of_vertices&) {
    return {};
  }
}

// Every move from random valid clusterings of a surface.
void check_moves(const Soup& soup, std::size_t tries, std::size_t steps, std::mt19937& engine, Statistics& statistics)
{
  Surface s(soup);
  ++statistics.surfaces;
  for (std::size_t i = 0; i < tries; ++i) {
    const std::size_t faces = s.reference.number_of_faces();
    const std::size_t clusters = (std::min)(faces, 3 + engine() % (std::max)(std::size_t(2), faces / 2));
    const Labels labels = random_connected_labels(s.reference, clusters, engine);
    const std::string fault = reference::fault_of_clustering(s.reference, labels);
    const bool valid = fast_validity(s, labels);
    if (valid != fault.empty() && statistics.wrong++ < 5)
      BOOST_ERROR("labels are valid for the library: " << valid << ", brute force: '" << fault << "'; faces "
                                                       << text(soup) << " labels " << text(labels));
    if (fault.empty())
      walk(s, labels, steps, engine, statistics);
  }
  // Clusterings computed by the library.
  const std::size_t vertices = s.reference.number_of_vertices();
  for (std::size_t n = (std::min)(std::size_t(4), vertices); n < vertices; n += 1 + vertices / 5) {
    const Labels labels = labels_of_library(s.mesh, n);
    if (labels.empty())
      continue;
    BOOST_CHECK_EQUAL(reference::fault_of_clustering(s.reference, labels), "");
    walk(s, labels, steps, engine, statistics);
  }
}

void report(const char* what, const Statistics& s)
{
  BOOST_TEST_MESSAGE(what << ": " << s.surfaces << " surfaces, " << s.clusterings << " clusterings, " << s.moves
                          << " moves, " << s.allowed << " allowed, " << s.wrong << " wrong");
  BOOST_CHECK_EQUAL(s.wrong, 0u);
}

void check_family(const char* what, const Soup& start, std::size_t surfaces, std::size_t changes,
                  std::size_t min_moves, unsigned seed)
{
  std::mt19937 engine(seed);
  Statistics statistics;
  for (std::size_t i = 0; i < surfaces; ++i) {
    const Soup soup = generated::random_surface(start, engine() % (changes + 1), i % 3 == 2, engine);
    check_moves(soup, 12, 40, engine, statistics);
  }
  report(what, statistics);
  BOOST_CHECK_GT(statistics.moves, min_moves);
  BOOST_CHECK_GT(statistics.allowed, min_moves / 20);
}

} // namespace

BOOST_AUTO_TEST_CASE(moves_on_spheres)
{
  check_family("sphere", generated::tetrahedron(), 100, 60, 200000, 1);
  check_family("cube", generated::cube_grid(2), 100, 40, 100000, 2);
}

BOOST_AUTO_TEST_CASE(moves_on_tori)
{
  check_family("torus", generated::seven_vertex_torus(), 100, 80, 100000, 3);
  check_family("quad torus", generated::torus(4, 5), 60, 60, 100000, 4);
  check_family("double torus", generated::triangulated(generated::plate_with_windows(2)), 40, 60, 50000, 5);
}

BOOST_AUTO_TEST_CASE(moves_on_surfaces_with_border)
{
  check_family("disc", generated::triangulated(generated::grid(3, 3)), 60, 60, 200000, 6);
  check_family("fan", generated::fan(12), 80, 30, 200000, 7);
  check_family("annulus", generated::triangulated(generated::tube(6, 3)), 40, 60, 200000, 8);
  check_family("quad annulus", generated::tube(8, 3), 40, 40, 100000, 9);
  check_family("sphere with holes", generated::with_holes(generated::triangle_sphere(2), 4), 25, 60, 200000, 10);
  check_family("two parts", generated::joined(generated::torus(4, 4), generated::grid(4, 4)), 60, 40, 200000, 11);
}

// Arbitrary labels: the library's verdict is correct, and so is the fault that it names.
BOOST_AUTO_TEST_CASE(arbitrary_labels)
{
  std::mt19937 engine(12);
  const std::vector<Soup> starts{generated::tetrahedron(), generated::octahedron(), generated::seven_vertex_torus(),
                                 generated::fan(6),        generated::grid(2, 2),   generated::cube_grid(1)};
  std::size_t valid = 0, invalid = 0, wrong = 0;
  std::map<std::string, std::size_t> kinds;
  for (std::size_t i = 0; i < 600; ++i) {
    const Soup soup = generated::random_surface(starts[i % starts.size()], engine() % 12, i % 2 == 1, engine);
    const Surface s(soup);
    for (int k = 0; k < 40; ++k) {
      const std::size_t n = 1 + engine() % s.reference.number_of_faces();
      Labels labels(s.reference.number_of_faces());
      if (k % 2 == 0)
        labels = random_connected_labels(s.reference, n, engine);
      else
        for (std::size_t& x : labels)
          x = engine() % n;
      std::map<std::size_t, std::size_t> names;
      for (const std::size_t x : labels)
        names.insert({x, names.size()});
      Labels compact;
      for (const std::size_t x : labels)
        compact.push_back(names[x]);
      const bool expected = reference::fault_of_clustering(s.reference, compact).empty();
      const std::string fault = SMC::clustering_fault(
        s.mesh, boost::make_function_property_map<Mesh::Face_index>([&](Mesh::Face_index f) { return labels[f]; }));
      (expected ? valid : invalid) += 1;
      if (fault.empty() != expected && wrong++ < 5)
        BOOST_ERROR("library: '" << fault << "', brute force: '" << reference::fault_of_clustering(s.reference, compact)
                                 << "'; faces " << text(soup) << " labels " << text(labels));
      for (const char* kind : {"touches itself", "is not connected", "is not a disc", "fewer than three", "meet twice",
                               "meets the border twice", "covers a closed component"})
        kinds[kind] += fault.find(kind) != std::string::npos;
      if (!fault.empty()) {
        BOOST_CHECK_EQUAL(fault.compare(0, 8, "cluster "), 0);
        BOOST_CHECK_EQUAL(names.count(std::stoul(fault.substr(8))), 1u); // the label as given
      }
    }
  }
  BOOST_TEST_MESSAGE(valid << " valid, " << invalid << " not");
  for (const auto& kind : kinds) {
    BOOST_TEST_MESSAGE("  " << kind.first << ": " << kind.second);
    BOOST_CHECK_MESSAGE(kind.second > 0, "never seen: " << kind.first);
  }
  BOOST_CHECK_EQUAL(wrong, 0u);
  BOOST_CHECK_GT(valid, 300u);
  BOOST_CHECK_GT(invalid, 3000u);
}

// The message for labels with a known fault.
BOOST_AUTO_TEST_CASE(named_faults)
{
  const auto fault = [](const Soup& soup, const Labels& labels) {
    const Mesh mesh = test::to_mesh(soup);
    return SMC::clustering_fault(
      mesh, boost::make_function_property_map<Mesh::Face_index>([&](Mesh::Face_index f) { return labels[f]; }));
  };
  const Soup grid = generated::grid(3, 3);
  BOOST_CHECK_EQUAL(fault(grid, {0, 0, 0, 1, 1, 1, 2, 2, 2}), "cluster 0 has fewer than three neighbors");
  BOOST_CHECK_EQUAL(fault(grid, {5, 7, 7, 7, 7, 7, 9, 9, 5}), "cluster 5 is not connected: face 8 lies apart");
  BOOST_CHECK_EQUAL(fault(grid, {0, 0, 0, 0, 1, 0, 0, 0, 0}), "cluster 0 is not a disc: its Euler characteristic is 0");
  BOOST_CHECK_EQUAL(fault(grid, {4, 4, 4, 4, 6, 5, 4, 5, 6}), "cluster 6 touches itself at vertex 10");
  BOOST_CHECK_EQUAL(fault(grid, {0, 0, 1, 2, 2, 1, 2, 2, 1}), "");
  BOOST_CHECK_EQUAL(fault(generated::tetrahedron(), {3, 3, 3, 3}), "cluster 3 covers a closed component");
  BOOST_CHECK_EQUAL(fault(generated::tetrahedron(), {3, 1, 0, 2}), "");
  BOOST_CHECK_EQUAL(fault(generated::single_triangle(), {0}), "cluster 0 has fewer than three neighbors");
}

BOOST_AUTO_TEST_SUITE_END()
