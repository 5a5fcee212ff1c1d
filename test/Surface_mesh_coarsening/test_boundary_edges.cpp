// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares the list of edges between clusters with a search of all edges of the mesh.

#define BOOST_TEST_MODULE boundary_edges
#include "support/face_graphs.h"
#include "support/generate_meshes.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Coarsening_visitor_base.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Boundary_edges.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <random>
#include <vector>

namespace SMC = CGAL::Surface_mesh_coarsening;
using namespace SMC::internal;

namespace {

typedef Boundary_edges<SMC::Uniform_weight> Edges;
typedef std::vector<std::array<Index, 2> > Pairs_of_faces;

constexpr Index number_of_clusters = 5;

// Square faces with random labels; the list does not require clusters to be discs.
struct Labelled_grid
{
  explicit Labelled_grid(std::size_t n) : mesh(test::to_mesh(generated::grid(n, n)))
  {
    const auto np = CGAL::parameters::default_values();
    Local_frame frame;
    input = clustering_input(mesh, np, numbering(mesh, np), frame, Cancellation_point());
    labels.emplace(input.mesh);
    for (Index f = 0; f < input.mesh.number_of_faces(); ++f)
      labels->set(f, engine() % number_of_clusters);
  }

  // Relabels a part of the faces.
  void change(double part, Edges& edges)
  {
    for (std::size_t i = 0; i < part * double(input.mesh.number_of_faces()); ++i) {
      const Index f = engine() % input.mesh.number_of_faces(), from = (*labels)[f], to = engine() % number_of_clusters;
      if (from == to)
        continue;
      labels->set(f, to);
      edges.note_change(from);
      edges.note_change(to);
      edges.note_edges(f, to);
    }
  }

  Pairs_of_faces expected() const
  {
    Pairs_of_faces pairs;
    const Flat_mesh& m = input.mesh;
    for (Index f = 0; f < m.number_of_faces(); ++f)
      for (const Index c : m.corners(f)) {
        const Index g = m.face_across[c];
        if (g != NONE && f < g && (*labels)[f] != (*labels)[g])
          pairs.push_back({{f, g}});
      }
    return pairs;
  }

  test::Mesh mesh;
  Clustering_input input;
  std::optional<Cluster_labels> labels;
  std::mt19937 engine;
};

// In their order. Removed edges lie at no cluster that can change.
Pairs_of_faces listed(const Edges& edges, const Labelled_grid& grid)
{
  std::vector<Index> numbers;
  edges.list_changed(0, edges.size(), at_any_time, numbers);
  Pairs_of_faces pairs;
  for (const Index i : numbers) {
    const std::array<Index, 2>& faces = edges.faces(i);
    pairs.push_back(faces);
    for (int side : {0, 1}) {
      BOOST_REQUIRE_EQUAL(edges.clusters(i)[side], (*grid.labels)[faces[side]]);
      BOOST_REQUIRE_EQUAL(edges.terms(i)[side].mass, grid.input.mass(faces[side]));
      BOOST_REQUIRE(edges.terms(i)[side].centroid == grid.input.centroid(faces[side]));
    }
  }
  return pairs;
}

Pairs_of_faces sorted(Pairs_of_faces pairs)
{
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

struct Refusing_visitor : SMC::Coarsening_visitor_base
{
  bool go_further() { return false; }
};

} // namespace

BOOST_AUTO_TEST_CASE(same_as_all_edges_of_the_mesh)
{
  // The second mesh has a long list.
  for (const std::size_t n : {20, 310}) {
    Labelled_grid grid(n);
    const Cluster_energy<SMC::Uniform_weight> energy((SMC::Uniform_weight()));
    Edges edges(grid.input, *grid.labels, energy, number_of_clusters);
    edges.list_all(Cancellation_point(), Execution::SEQUENTIAL);
    BOOST_CHECK(listed(edges, grid) == grid.expected());
    bool was_out_of_order = false, was_put_in_order = false;
    for (int round = 0; round < 12; ++round) {
      grid.change(0.2, edges);
      edges.update(Cancellation_point(), Execution::SEQUENTIAL);
      edges.end_round();
      const Pairs_of_faces pairs = listed(edges, grid), expected = grid.expected();
      BOOST_CHECK(sorted(pairs) == sorted(expected));
      was_put_in_order = was_put_in_order || (was_out_of_order && pairs == expected);
      was_out_of_order = was_out_of_order || pairs != expected;
    }
    BOOST_CHECK(was_out_of_order);
    BOOST_CHECK_EQUAL(was_put_in_order, n == 310);
  }
}

BOOST_AUTO_TEST_CASE(listed_again_after_a_refusal)
{
  Labelled_grid grid(300);
  Refusing_visitor visitor;
  const Visitor_handle handle(std::ref(visitor));
  const Cluster_energy<SMC::Uniform_weight> energy((SMC::Uniform_weight()));
  Edges edges(grid.input, *grid.labels, energy, number_of_clusters);
  BOOST_CHECK_THROW(edges.list_all(Cancellation_point(handle), Execution::SEQUENTIAL), SMC::Coarsening_cancelled);
  BOOST_CHECK(!edges.is_complete());
  edges.list_all(Cancellation_point(), Execution::SEQUENTIAL);
  BOOST_CHECK(edges.is_complete());
  BOOST_CHECK(listed(edges, grid) == grid.expected());
}
