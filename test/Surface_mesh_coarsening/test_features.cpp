// SPDX-License-Identifier: GPL-3.0-or-later
//
// Feature lines and corners: their images in the output, and an independent check of the rules for clusters.

#include "support/face_graphs.h"
#include "support/line_distance.h"

#include "models.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Clustering_check.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Coarse_features.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Input_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_minimization.h>
#include <CGAL/Surface_mesh_coarsening/internal/seeding/Initial_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_levels.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh_to_distance.h>
#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_features)

namespace utf = boost::unit_test;
namespace SMC = CGAL::Surface_mesh_coarsening;
namespace PMP = CGAL::Polygon_mesh_processing;
using generated::Soup;
using SMC::internal::Index;
using SMC::internal::NONE;
using test::Mesh;
using test::Point;

namespace {

typedef Mesh::Edge_index Edge;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Face_index Face;

// A mesh with all parameters of features; by default there are none.
struct Model
{
  Mesh mesh;
  Mesh::Property_map<Edge, bool> is_line;
  Mesh::Property_map<Vertex, bool> is_corner;
  Mesh::Property_map<Face, int> patch;
  double angle = 180;

  explicit Model(const Soup& soup, double angle = 180) : mesh(test::to_mesh(soup)), angle(angle)
  {
    is_line = mesh.add_property_map<Edge, bool>("e:line", false).first;
    is_corner = mesh.add_property_map<Vertex, bool>("v:corner", false).first;
    patch = mesh.add_property_map<Face, int>("f:patch", 0).first;
  }

  auto parameters() const
  {
    return SMC::parameters::feature_angle(angle).edge_is_constrained_map(is_line).vertex_is_constrained_map(is_corner)
      .face_patch_map(patch);
  }
};

struct Output
{
  Mesh mesh;
  Mesh::Property_map<Edge, bool> is_line;
  Mesh::Property_map<Vertex, bool> is_corner;
  Mesh::Property_map<Face, int> patch;
  SMC::Coarsening_report report;
  std::vector<std::size_t> labels;

  Output()
  {
    is_line = mesh.add_property_map<Edge, bool>("e:line", true).first;
    is_corner = mesh.add_property_map<Vertex, bool>("v:corner", true).first;
    patch = mesh.add_property_map<Face, int>("f:patch", -1).first;
  }
  auto parameters() const
  {
    return SMC::parameters::edge_is_constrained_map(is_line).vertex_is_constrained_map(is_corner).face_patch_map(patch);
  }
};

Output coarsened(const Model& model, std::size_t number, bool fitted = false)
{
  Output output;
  SMC::Mwcvd_clustering<Mesh, SMC::Maximum_density_weight> c(model.mesh, model.parameters().maximum_density(50.));
  c.seed(number);
  c.grow();
  c.minimize();
  if (fitted)
    c.extract_dual_mesh(output.mesh, SMC::Fitted_placement(), output.parameters());
  else
    c.extract_dual_mesh(output.mesh, SMC::Centroid_placement(), output.parameters());
  output.report = c.report();
  output.labels = test::labels_in(c, model.mesh);
  return output;
}

// The lines by the points at their ends, the loops, and the corners of marked edges and vertices.
struct Graph
{
  std::set<Point> corners;
  std::multiset<std::pair<Point, Point> > lines;
  std::size_t loops = 0;
  bool operator==(const Graph& g) const { return corners == g.corners && lines == g.lines && loops == g.loops; }
};

template <class IsLine, class IsCorner>
Graph graph_of(const Mesh& m, const IsLine& is_line, const IsCorner& is_corner)
{
  std::map<Vertex, std::vector<Edge> > around;
  for (const Edge e : m.edges())
    if (is_line(e))
      for (int i = 0; i < 2; ++i)
        around[m.vertex(e, i)].push_back(e);
  Graph graph;
  for (const Vertex v : m.vertices())
    if (is_corner(v))
      graph.corners.insert(m.point(v));
  std::set<Edge> done;
  const auto follow = [&](Vertex v, Edge e) {
    while (done.insert(e).second) {
      v = m.vertex(e, 0) == v ? m.vertex(e, 1) : m.vertex(e, 0);
      if (is_corner(v))
        break;
      BOOST_REQUIRE_EQUAL(around[v].size(), 2u);
      e = around[v][0] == e ? around[v][1] : around[v][0];
    }
    return v;
  };
  for (const auto& star : around)
    for (const Edge e : star.second)
      if (is_corner(star.first) && !done.count(e))
        graph.lines.insert(std::minmax(m.point(star.first), m.point(follow(star.first, e))));
  for (const auto& star : around)
    for (const Edge e : star.second)
      if (!done.count(e)) {
        ++graph.loops;
        follow(star.first, e);
      }
  return graph;
}

// The input as prepared by the clustering.
struct Prepared
{
  SMC::internal::Numbering<Mesh> numbering;
  SMC::internal::Local_frame frame;
  SMC::internal::Featured_input input;

  explicit Prepared(const Model& model)
  {
    using namespace SMC::internal;
    const auto np = model.parameters();
    numbering = SMC::internal::numbering(model.mesh, np);
    input.items = clustering_input(model.mesh, np, numbering, frame, Run_context());
    keep_features(input, read_features(model.mesh, np, numbering, input.items.mesh), Run_context());
  }
};

Graph graph_of(const Model& model)
{
  const Prepared p(model);
  if (!p.input.cells)
    return Graph();
  std::set<Edge> lines;
  std::set<Vertex> corners;
  p.input.cells->edges().for_each_edge(p.input.cells->base().mesh, [&](Index v, Index w) {
    lines.insert(model.mesh.edge(model.mesh.halfedge(p.numbering.vertices[v], p.numbering.vertices[w])));
  });
  for (std::size_t v = 0; v < p.numbering.vertices.size(); ++v)
    if (p.input.cells->edges().is_corner[v])
      corners.insert(p.numbering.vertices[v]);
  return graph_of(model.mesh, [&](Edge e) { return lines.count(e) != 0; }, [&](Vertex v) { return corners.count(v) != 0; });
}

template <class IsLine>
std::size_t number_of_regions(Mesh m, const IsLine& is_line)
{
  auto line = m.add_property_map<Edge, bool>("e:border", false).first;
  for (const Edge e : m.edges())
    line[e] = is_line(e);
  auto region = m.add_property_map<Face, std::size_t>("f:region", 0).first;
  return PMP::connected_components(m, region, CGAL::parameters::edge_is_constrained_map(line));
}

// The sums over the cells and the remaining faces equal the sums over the original faces.
void check_sums_of_cells(const SMC::internal::Featured_input& featured)
{
  const SMC::internal::Clustering_input &input = featured.items, &base = featured.cells->base();
  double faces = 0, area = 0, mass = 0, area_of_base = 0, mass_of_base = 0;
  for (Index f = 0; f < Index(input.area.size()); ++f) {
    faces += input.number_of_faces_in(f);
    area += input.area[f];
    mass += input.mass(f);
  }
  for (Index f = 0; f < Index(base.area.size()); ++f) {
    area_of_base += base.area[f];
    mass_of_base += base.mass(f);
  }
  BOOST_TEST(faces == double(base.area.size()), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(area == area_of_base, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(mass == mass_of_base, boost::test_tools::tolerance(1e-9));
}

// The pieces of a whole face have its area. Where a search on this face is said to be sufficient, the descent on the surface finds
// the same point.
void check_whole_faces(const SMC::internal::Labelled_pieces& pieces)
{
  using namespace SMC::internal;
  const Flat_mesh& whole = pieces.whole_mesh();
  std::vector<double> area(whole.number_of_faces(), 0.);
  for (Index piece = 0; piece < pieces.input().mesh.number_of_faces(); ++piece)
    area[pieces.whole_face(piece)] += pieces.input().area[piece];
  const Input_surface surface(whole);
  std::size_t inside = 0;
  for (Index f = 0; f < whole.number_of_faces(); ++f) {
    const Face_geometry g = face_geometry(whole, f);
    BOOST_TEST(area[f] == g.area, boost::test_tools::tolerance(1e-9));
    const Vector normal = vector_area(whole, f);
    for (const double part : {-0.5, 0., 0.05, 1.}) {
      const Vector p = g.centroid + (part / std::sqrt(std::sqrt(dot(normal, normal)))) * normal;
      Input_surface::Closest closest;
      if (!surface.is_closest_inside(p, f, closest))
        continue;
      ++inside;
      const Input_surface::Closest expected = surface.closest_from(p, f, 20);
      BOOST_TEST(closest.point.face == expected.point.face);
      BOOST_TEST(closest.point.position == expected.point.position);
      BOOST_TEST(closest.squared_distance == expected.squared_distance);
    }
  }
  BOOST_TEST((inside > 0 || !whole.is_triangle_mesh()));
}

// The rules, by brute force, for clusters after growth and minimization.
void check_rules(const Model& model, std::size_t number)
{
  using namespace SMC::internal;
  const Prepared p(model);
  check_sums_of_cells(p.input);
  SMC::Coarsening_report report;
  Initial_clustering initial(p.input, Merging::BY_MASS, report, Run_context());
  initial.seed(number);
  Cluster_labels labels = initial.grow();
  typedef SMC::Weighted_inertia_energy<SMC::Maximum_density_weight> Energy;
  Energy_minimization<Energy> minimization(initial.input(), labels, {Energy(), initial.input().items, report.clusters}, false,
                                           Run_context());
  for (int round = 0; round < 3; ++round) {
    BOOST_TEST(Clustering_check(labels, report.clusters).fault([](std::size_t x) { return std::to_string(x); }) == "");
    const Labelled_pieces pieces(initial.input(), labels, report.clusters);
    check_whole_faces(pieces);
    const Feature_cells& cells = *initial.input().cells;
    const Flat_mesh& m = pieces.input().mesh;
    const auto label = [&](Index v) { return pieces.labels()[m.star[m.first_in_star[v]]]; };
    std::map<Index, long> trees; // nodes without edges between them
    std::map<Index, std::set<Index> > lines;
    std::set<Index> with_corner, at_border, at_border_by_right;
    std::set<std::pair<Index, Index> > crossings;
    for (Index i = 0; i < cells.graph().number_of_nodes(); ++i) {
      const Index v = cells.graph().vertex(i), x = label(v);
      for (const Index f : m.faces_around(v))
        BOOST_TEST(pieces.labels()[f] == x); // the star of a node, and the faces at each half of an edge
      ++trees[x];
      if (cells.graph().is_corner(i))
        BOOST_TEST(with_corner.insert(x).second);
      else
        lines[x].insert(cells.graph().line(i));
      if (m.is_on_border(v))
        at_border_by_right.insert(x);
    }
    for (const Feature_line& line : cells.graph().lines())
      for (std::size_t i = line.is_loop ? 0 : 1; i < line.nodes.size(); ++i) {
        const Index previous = line.nodes[(i + line.nodes.size() - 1) % line.nodes.size()];
        const Index x = label(cells.graph().vertex(previous)), y = label(cells.graph().vertex(line.nodes[i]));
        if (x == y)
          --trees[x];
        else
          BOOST_TEST(crossings.insert(std::minmax(x, y)).second);
      }
    for (std::size_t f = 0; f < m.number_of_faces(); ++f)
      for (const Index c : m.corners(f))
        if (m.face_across[c] == NONE)
          at_border.insert(pieces.labels()[Index(f)]);
    for (const auto& tree : trees) {
      BOOST_TEST(tree.second == 1);
      BOOST_TEST((with_corner.count(tree.first) || lines[tree.first].size() == 1));
      BOOST_TEST((!at_border.count(tree.first) || at_border_by_right.count(tree.first)));
    }
    while (minimization.run({1, 0}).moves > 0 && round == 0)
      ;
  }
}

void check(const Model& model, std::size_t number, const Output& output)
{
  BOOST_TEST_CONTEXT(number << " vertices")
  {
    BOOST_TEST(output.mesh.number_of_vertices() == number);
    BOOST_TEST(output.mesh.is_valid());
    BOOST_TEST(CGAL::is_triangle_mesh(output.mesh));
    BOOST_TEST((reference::fault_of_surface(reference::Reference_mesh(test::to_soup(model.mesh)),
                                            test::triangles_of(test::to_soup(output.mesh)),
                                            std::vector<std::size_t>(number, 0)) == ""));
    const Graph before = graph_of(model);
    const Graph after = graph_of(output.mesh, [&](Edge e) { return output.is_line[e]; },
                                 [&](Vertex v) { return output.is_corner[v]; });
    BOOST_TEST((before == after));
    BOOST_TEST(output.report.feature_corners == before.corners.size());
    BOOST_TEST(output.report.feature_lines == before.lines.size() + before.loops);
    // Patches are the patches of the input, and change at lines only.
    std::set<int> patches, given;
    for (const Face f : model.mesh.faces())
      given.insert(model.patch[f]);
    for (const Face f : output.mesh.faces())
      patches.insert(output.patch[f]);
    BOOST_TEST((patches == given));
    for (const Edge e : output.mesh.edges()) {
      const Face f = output.mesh.face(e.halfedge()), g = output.mesh.face(output.mesh.opposite(e.halfedge()));
      if (f != Mesh::null_face() && g != Mesh::null_face() && !output.is_line[e])
        BOOST_TEST(output.patch[f] == output.patch[g]);
    }
  }
}

void check(const Model& model, std::size_t number, bool fitted = false)
{
  check(model, number, coarsened(model, number, fitted));
}

// Checks numbers of vertices from the smallest; one less is refused.
void check_all(const Model& model, std::size_t least, std::size_t lines, std::size_t loops, std::size_t corners,
               std::size_t regions)
{
  const Graph graph = graph_of(model);
  BOOST_TEST(graph.lines.size() == lines);
  BOOST_TEST(graph.loops == loops);
  BOOST_TEST(graph.corners.size() == corners);
  std::size_t nearest = 0;
  try {
    coarsened(model, 1);
  } catch (const SMC::Unreachable_number_of_vertices& e) {
    nearest = e.nearest();
  }
  BOOST_TEST(nearest == least);
  BOOST_CHECK_THROW(coarsened(model, nearest - 1), SMC::Unreachable_number_of_vertices);
  for (const std::size_t number : {nearest, nearest + 1, nearest + 7, 2 * nearest, 4 * nearest})
    if (number <= model.mesh.number_of_vertices()) {
      check(model, number);
      check_rules(model, number);
    }
  const std::size_t some = (std::min)(2 * nearest, std::size_t(model.mesh.number_of_vertices()));
  check(model, some, true);
  const Output output = coarsened(model, some);
  BOOST_TEST(number_of_regions(output.mesh, [&](Edge e) { return output.is_line[e]; }) == regions);
}

// The surface of cubes of a grid, each side divided into `n` x `n` squares.
Soup voxels(const std::set<std::array<int, 3> >& cubes, int n)
{
  Soup s;
  std::map<std::array<int, 3>, std::size_t> number;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto inserted = number.insert({at, s.points.size()});
    if (inserted.second)
      s.points.push_back({double(at[0]) / n, double(at[1]) / n, double(at[2]) / n});
    return inserted.first->second;
  };
  for (const std::array<int, 3>& cube : cubes)
    for (int axis = 0; axis < 3; ++axis)
      for (int far = 0; far < 2; ++far) {
        std::array<int, 3> beside = cube;
        beside[axis] += far ? 1 : -1;
        if (cubes.count(beside))
          continue;
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j) {
            generated::Polygon p;
            for (const std::pair<int, int>& d :
                 {std::make_pair(0, 0), std::make_pair(1, 0), std::make_pair(1, 1), std::make_pair(0, 1)}) {
              std::array<int, 3> at;
              at[axis] = n * (cube[axis] + far);
              at[(axis + 1) % 3] = n * cube[(axis + 1) % 3] + i + d.first;
              at[(axis + 2) % 3] = n * cube[(axis + 2) % 3] + j + d.second;
              p.push_back(vertex(at));
            }
            if (far == 0)
              std::reverse(p.begin(), p.end());
            s.polygons.push_back(p);
          }
      }
  return s;
}

// A tube with flat ends, one or both of them closed by a fan.
Soup cylinder(std::size_t m, std::size_t n, bool both)
{
  Soup s = generated::tube(m, n);
  const auto at = [&](std::size_t i, std::size_t j) { return (i % m) * (n + 1) + j; };
  for (const std::size_t j : {std::size_t(0), n}) {
    if (j == n && !both)
      break;
    s.points.push_back({0, 0, s.points[j][2]});
    for (std::size_t i = 0; i < m; ++i) {
      generated::Polygon p{at(i + 1, j), at(i, j), s.points.size() - 1};
      if (j == n)
        std::swap(p[0], p[1]);
      s.polygons.push_back(p);
    }
  }
  return s;
}

} // namespace

BOOST_AUTO_TEST_CASE(cubes)
{
  check_all(Model(generated::cube_grid(7), 30), 8, 12, 0, 8, 6);
  check_all(Model(generated::triangulated(generated::cube_grid(6)), 30), 8, 12, 0, 8, 6);
  check_all(Model(generated::cube_grid(1), 30), 8, 12, 0, 8, 6);
}

BOOST_AUTO_TEST_CASE(l_shape)
{
  check_all(Model(voxels({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 5), 30), 12, 18, 0, 12, 8);
}

BOOST_AUTO_TEST_CASE(closed_lines)
{
  check_all(Model(cylinder(24, 10, true), 30), 6, 0, 2, 0, 3);
}

BOOST_AUTO_TEST_CASE(closed_line_beside_a_border)
{
  const Model model(cylinder(24, 10, false), 30);
  check_all(model, 6, 0, 1, 0, 2);
}

BOOST_AUTO_TEST_CASE(line_that_ends_on_the_border)
{
  Soup folded = generated::triangulated(generated::grid(12, 9));
  for (generated::Point& p : folded.points)
    p[2] = std::abs(p[0] - 6);
  // Two corners at the ends of the line, one vertex more on the border of each side, and one on the line: without it, the
  // line and the border between its ends would be the same edge.
  const Model model(folded, 30);
  const Graph graph = graph_of(model);
  BOOST_TEST(graph.lines.size() == 1u);
  BOOST_TEST(graph.corners.size() == 2u);
  for (const std::size_t number : {8u, 20u, 40u}) {
    check(model, number);
    check(model, number, true);
    check_rules(model, number);
  }
}

BOOST_AUTO_TEST_CASE(line_that_ends_inside)
{
  Model model(generated::triangulated(generated::grid(12, 12)));
  for (const Edge e : model.mesh.edges()) {
    const Point p = model.mesh.point(model.mesh.vertex(e, 0)), q = model.mesh.point(model.mesh.vertex(e, 1));
    model.is_line[e] = p.x() == 6 && q.x() == 6 && p.y() > 3 && q.y() > 3 && p.y() < 9 && q.y() < 9;
  }
  BOOST_TEST(graph_of(model).lines.size() == 1u);
  for (const std::size_t number : {12u, 30u, 60u}) {
    check(model, number);
    check_rules(model, number);
  }
}

BOOST_AUTO_TEST_CASE(patches_on_a_sphere)
{
  Model model(generated::triangle_sphere(4));
  for (const Face f : model.mesh.faces()) {
    double x = 0, y = 0, z = 0;
    for (const Vertex v : CGAL::vertices_around_face(model.mesh.halfedge(f), model.mesh)) {
      x += model.mesh.point(v).x();
      y += model.mesh.point(v).y();
      z += model.mesh.point(v).z();
    }
    model.patch[f] = 10 + (x > 0) + 2 * (y > 0) + 4 * (z > 0);
  }
  check_all(model, 6, 12, 0, 6, 8);
}

namespace {

typedef test::Kernel::Vector_3 Vector;

// A model whose faces belong to the patches at the sums of their corners.
struct Patched : Model
{
  template <class Patch_at>
  Patched(const Soup& soup, const Patch_at& patch_at) : Model(soup)
  {
    for (const Face f : mesh.faces()) {
      Vector center = CGAL::NULL_VECTOR;
      for (const Vertex v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
        center = center + (mesh.point(v) - CGAL::ORIGIN) / mesh.degree(f);
      patch[f] = patch_at(center);
    }
  }
};

// The nearest of 12 directions that are spread over a sphere.
int parcel_at(const Vector& p)
{
  constexpr int number = 12;
  int nearest = 0;
  double largest = -1;
  for (int i = 0; i < number; ++i) {
    const double z = 1 - (2. * i + 1) / number, r = std::sqrt(1 - z * z), angle = 2.4 * i;
    const double product = p * Vector(r * std::cos(angle), r * std::sin(angle), z);
    if (product > largest) {
      largest = product;
      nearest = i;
    }
  }
  return nearest;
}

} // namespace

// The lines between patches zigzag along the edges of faces. Corners are the junctions of three patches only.
BOOST_AUTO_TEST_CASE(corners_of_zigzags_between_patches)
{
  for (const unsigned level : {4, 5, 6}) {
    const Patched model(generated::triangle_sphere(level), parcel_at);
    std::set<Point> junctions;
    for (const Vertex v : model.mesh.vertices()) {
      const auto around = model.mesh.halfedges_around_target(model.mesh.halfedge(v));
      if (std::count_if(around.begin(), around.end(), [&](auto h) {
            return model.patch[model.mesh.face(h)] != model.patch[model.mesh.face(model.mesh.opposite(h))];
          }) > 2)
        junctions.insert(model.mesh.point(v));
    }
    BOOST_TEST(junctions.size() > 12u);
    BOOST_TEST((graph_of(model).corners == junctions));
  }
}

// At any resolution, an inclined square has four corners and a disc has none.
BOOST_AUTO_TEST_CASE(turns_of_lines_between_patches)
{
  for (const int n : {30, 60, 120}) {
    const Soup soup = generated::triangulated(generated::grid(n, n));
    const auto from_middle = [n](const Vector& p) { return p / n - Vector(0.49, 0.52, 0); };
    const Graph square = graph_of(Patched(soup, [&](const Vector& p) {
      const Vector q = from_middle(p);
      return int(std::abs(0.9 * q.x() + 0.4 * q.y()) < 0.3 && std::abs(0.4 * q.x() - 0.9 * q.y()) < 0.3);
    }));
    BOOST_TEST(square.corners.size() == 4u);
    BOOST_TEST(square.lines.size() == 4u);
    const Graph disc = graph_of(Patched(soup, [&](const Vector& p) { return int(from_middle(p).squared_length() < 0.1); }));
    BOOST_TEST(disc.corners.size() == 0u);
    BOOST_TEST(disc.loops == 1u);
  }
}

// Refusals say what the vertices are needed for.
BOOST_AUTO_TEST_CASE(refusals_name_corners)
{
  const auto message = [](const Model& model) {
    try {
      coarsened(model, 3);
    } catch (const SMC::Unreachable_number_of_vertices& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const Patched parcels(generated::triangle_sphere(4), parcel_at);
  const std::string lead = "3 vertices were asked for, but the input, with ";
  const std::string corners = std::to_string(graph_of(parcels).corners.size()) + " corners of features to keep, needs ";
  BOOST_TEST(message(parcels).find(lead + corners) == 0u);
  BOOST_TEST(message(Model(cylinder(24, 10, true), 30)) ==
             lead + "1 connected component and feature lines to keep, needs 6");
  BOOST_TEST(message(Model(generated::octahedron())) == lead + "1 connected component, needs 4");
}

BOOST_AUTO_TEST_CASE(constrained_vertices_and_edges)
{
  Model model(generated::with_noise(generated::triangulated(generated::torus(30, 20)), 0.001));
  std::size_t i = 0;
  for (const Vertex v : model.mesh.vertices())
    model.is_corner[v] = ++i % 97 == 0;
  const std::size_t corners = graph_of(model).corners.size();
  BOOST_TEST(corners == 6u);
  check(model, 40);
  check_rules(model, 40);
  // And a closed line around.
  for (const Edge e : model.mesh.edges())
    model.is_line[e] = model.mesh.vertex(e, 0) < Vertex(20) && model.mesh.vertex(e, 1) < Vertex(20) &&
                       std::abs(int(model.mesh.vertex(e, 0)) - int(model.mesh.vertex(e, 1))) % 18 == 1;
  BOOST_TEST(graph_of(model).loops == 1u);
  check(model, 40);
  check(model, 80, true);
  check_rules(model, 80);
}

BOOST_AUTO_TEST_CASE(corners_keep_their_points)
{
  // Far from the origin, differences round.
  for (const double factor : {1., 1e-3, 0.7e9}) {
    Soup soup = generated::rotated(generated::scaled(generated::cube_grid(8), 0.3), 0.7, 0.4);
    soup = generated::translated(soup, 100.1, -3.3, 17.7);
    Model model(generated::scaled(soup, factor), 30);
    const Output output = coarsened(model, 60, true);
    std::set<Point> points(model.mesh.points().begin(), model.mesh.points().end());
    std::size_t corners = 0;
    for (const Vertex v : output.mesh.vertices())
      if (output.is_corner[v]) {
        ++corners;
        BOOST_TEST(points.count(output.mesh.point(v)) == 1u);
      }
    BOOST_TEST(corners == 8u);
  }
}

BOOST_AUTO_TEST_CASE(vertices_lie_on_lines)
{
  const Model model(cylinder(40, 12, true), 30);
  const Output output = coarsened(model, 60);
  for (const Edge e : output.mesh.edges())
    if (output.is_line[e])
      for (int i = 0; i < 2; ++i) {
        const Point p = output.mesh.point(output.mesh.vertex(e, i));
        double nearest = 1;
        for (const Edge f : model.mesh.edges())
          nearest = (std::min)(nearest, CGAL::squared_distance(p, test::Kernel::Segment_3(
            model.mesh.point(model.mesh.vertex(f, 0)), model.mesh.point(model.mesh.vertex(f, 1)))));
        BOOST_TEST(nearest < 1e-24);
      }
}

BOOST_AUTO_TEST_CASE(labels_of_faces_at_features)
{
  const Model model(generated::triangulated(generated::cube_grid(12)), 30);
  const Output output = coarsened(model, 100);
  const Prepared p(model);
  for (const Vertex v : model.mesh.vertices()) {
    const Point& q = model.mesh.point(v);
    if (std::abs(q.x()) + std::abs(q.y()) + std::abs(q.z()) != 3)
      continue;
    std::set<std::size_t> around;
    for (const Face f : CGAL::faces_around_target(model.mesh.halfedge(v), model.mesh))
      around.insert(output.labels[f]);
    BOOST_TEST(around.size() == 1u);
  }
  p.input.cells->edges().for_each_edge(p.input.cells->base().mesh, [&](Index v, Index w) {
    const auto h = model.mesh.halfedge(p.numbering.vertices[v], p.numbering.vertices[w]);
    BOOST_TEST(output.labels[model.mesh.face(h)] == output.labels[model.mesh.face(model.mesh.opposite(h))]);
  });
}

BOOST_AUTO_TEST_CASE(detection)
{
  for (const double angle : {0., 20., 60., 90., 120., 180.}) {
    Soup soup = generated::with_noise(generated::triangulated(generated::torus(16, 12)), 0.1, 3);
    Model model(soup, angle);
    Mesh mesh = test::to_mesh(soup);
    auto sharp = mesh.add_property_map<Edge, bool>("e:sharp", false).first;
    PMP::detect_sharp_edges(mesh, angle, sharp);
    std::size_t found = 0;
    const Prepared p(model);
    if (p.input.cells)
      p.input.cells->edges().for_each_edge(p.input.cells->base().mesh, [&](Index v, Index w) {
        ++found;
        BOOST_TEST(sharp[mesh.edge(mesh.halfedge(Vertex(v), Vertex(w)))]);
      });
    BOOST_TEST(found == std::size_t(std::count(sharp.begin(), sharp.end(), true)));
  }
}

// A roof with a vertex on its ridge that only one side has, and one on its border: a face of zero area closes each gap.
BOOST_AUTO_TEST_CASE(faces_of_zero_area)
{
  const Soup soup{{{0, 0, 1}, {2, 0, 1}, {1, 0, 1}, {1, -1, 0}, {1, 1, 0}, {1.5, 0.5, 0.5}},
                  {{0, 3, 1}, {0, 1, 2}, {2, 1, 4}, {0, 2, 4}, {4, 1, 5}}};
  const Model model(soup, 30);
  const Prepared p(model);
  std::set<std::pair<Index, Index> > edges;
  BOOST_REQUIRE(p.input.cells);
  p.input.cells->edges().for_each_edge(p.input.cells->base().mesh, [&](Index v, Index w) {
    edges.insert(std::minmax(v, w));
  });
  BOOST_TEST((edges == std::set<std::pair<Index, Index> >{{0, 2}, {1, 2}}));
}

// The apex of a cone is a corner, but no vertex of a sphere is.
BOOST_AUTO_TEST_CASE(tips)
{
  Soup cone = cylinder(40, 20, true);
  double top = 0, bottom = 0;
  for (const auto& p : cone.points) {
    top = (std::max)(top, p[2]);
    bottom = (std::min)(bottom, p[2]);
  }
  for (auto& p : cone.points)
    for (int i = 0; i < 2; ++i)
      p[i] *= 1e-3 + (top - p[2]) / (top - bottom);
  cone.points.back()[2] += 1e-3 * (top - bottom);
  const Model model(cone, 30);
  BOOST_TEST(graph_of(model).corners.count(model.mesh.point(Vertex(cone.points.size() - 1))) == 1u);
  BOOST_TEST(graph_of(Model(generated::triangle_sphere(3), 30)).corners.empty());
}

// A vertex between two faces only, in the middle of an edge: at a corner, on a line, or between sharp edges only.
BOOST_AUTO_TEST_CASE(vertices_between_two_faces)
{
  Soup soup = generated::triangle_sphere(2);
  const std::size_t v = soup.polygons[0][0], w = soup.polygons[0][1], middle = soup.points.size();
  soup.points.push_back(soup.points[v]);
  for (int i = 0; i < 3; ++i)
    soup.points.back()[i] = 0.5 * (soup.points[v][i] + soup.points[w][i]);
  for (auto& polygon : soup.polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if (std::minmax(a, b) == std::minmax(v, w)) {
        polygon.insert(polygon.begin() + long(i) + 1, middle);
        break;
      }
    }
  BOOST_REQUIRE(std::count_if(soup.polygons.begin(), soup.polygons.end(), [](const auto& p) { return p.size() == 4; }) == 2);
  for (const bool is_corner : {true, false}) {
    Model model(soup);
    for (const Edge e : model.mesh.edges())
      model.is_line[e] = model.mesh.vertex(e, 0) == Vertex(middle) || model.mesh.vertex(e, 1) == Vertex(middle);
    model.is_corner[Vertex(middle)] = is_corner;
    check(model, 20);
    check(model, 67);
  }
  check(Model(soup, 0), 67);
}

// If intersecting triangles cause reclustering, the new clusters keep features, too.
BOOST_AUTO_TEST_CASE(recomputed_clusters)
{
  const Model model(generated::thin_plate(30, 0.02), 60);
  std::size_t most = 0;
  for (const std::size_t n : {60, 300}) {
    Output output;
    output.report = SMC::coarsen_mesh(model.mesh, n, output.mesh,
                                      model.parameters()
                                        .cluster_weight(SMC::Maximum_density_weight())
                                        .maximum_density(10)
                                        .vertex_placement(SMC::Quadric_placement()),
                                      output.parameters());
    check(model, n, output);
    most = (std::max)(most, output.report.clusterings);
  }
  BOOST_TEST(most > 1);
}

BOOST_AUTO_TEST_CASE(without_features)
{
  const Soup soup = generated::triangle_sphere(4);
  const Output output = coarsened(Model(soup, 170), 50), same = coarsened(Model(soup), 50);
  BOOST_TEST((test::to_soup(output.mesh).points == test::to_soup(same.mesh).points));
  for (const Edge e : output.mesh.edges())
    BOOST_TEST(!output.is_line[e]);
  for (const Face f : output.mesh.faces())
    BOOST_TEST(output.patch[f] == 0);
}

// Without given patches, the regions between lines are numbered.
BOOST_AUTO_TEST_CASE(regions_between_lines)
{
  const Mesh mesh = test::to_mesh(generated::triangulated(generated::cube_grid(6)));
  Mesh output;
  const auto patch = output.add_property_map<Face, int>("f:patch", -1).first;
  SMC::coarsen_mesh(mesh, 60, output, SMC::parameters::feature_angle(30), SMC::parameters::face_patch_map(patch));
  std::set<int> patches;
  for (const Face f : output.faces())
    patches.insert(patch[f]);
  BOOST_TEST(patches.size() == 6);
  for (const Edge e : output.edges()) {
    const Face f = output.face(output.halfedge(e, 0)), g = output.face(output.halfedge(e, 1));
    const bool is_flat = PMP::compute_face_normal(f, output) * PMP::compute_face_normal(g, output) > 0.5;
    BOOST_TEST((patch[f] == patch[g]) == is_flat);
  }
}

// Vertices with two faces on lines: their polygons are cut into fans, but the maps are filled for the faces and vertices of the
// input.
BOOST_AUTO_TEST_CASE(maps_where_polygons_are_cut)
{
  Mesh mesh = test::to_mesh(generated::cube_grid(8));
  std::vector<Mesh::Halfedge_index> sharp;
  for (const Edge e : mesh.edges()) {
    const auto h = mesh.halfedge(e);
    if (PMP::compute_face_normal(mesh.face(h), mesh) * PMP::compute_face_normal(mesh.face(mesh.opposite(h)), mesh) < 0.5)
      sharp.push_back(h);
  }
  BOOST_TEST(sharp.size() == 12 * 8);
  for (const auto h : sharp) {
    const Point middle = CGAL::midpoint(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
    mesh.point(mesh.target(CGAL::Euler::split_edge(h, mesh))) = middle;
  }
  const std::size_t unset = mesh.number_of_faces();
  const auto check = [&](const auto& coarsen) {
    auto face_cluster = mesh.add_property_map<Face, std::size_t>("f:cluster", unset).first;
    auto vertex_cluster = mesh.add_property_map<Vertex, std::size_t>("v:cluster", unset).first;
    Mesh output;
    coarsen(output, SMC::parameters::feature_angle(30).face_cluster_map(face_cluster).vertex_to_cluster_map(vertex_cluster));
    std::set<std::size_t> clusters;
    for (const Face f : mesh.faces())
      clusters.insert(face_cluster[f]);
    BOOST_TEST(*clusters.rbegin() < output.number_of_vertices());
    for (const Vertex v : mesh.vertices()) {
      const auto faces = mesh.faces_around_target(mesh.halfedge(v));
      BOOST_TEST(std::any_of(faces.begin(), faces.end(), [&](Face f) { return face_cluster[f] == vertex_cluster[v]; }));
    }
    mesh.remove_property_map(face_cluster);
    mesh.remove_property_map(vertex_cluster);
  };
  check([&](Mesh& output, const auto& np) { SMC::coarsen_mesh(mesh, 60, output, np); });
  check([&](Mesh& output, const auto& np) { SMC::coarsen_mesh_to_distance(mesh, 0.05, output, np); });
}

// The faces of a fan are all neighbors of each other, but the line around it gets vertices as other lines do.
BOOST_AUTO_TEST_CASE(lines_around_fans)
{
  const Mesh mesh = test::to_mesh(generated::triangulated(generated::scaled(cylinder(200, 1, true), 1, 1, 6)));
  for (const std::size_t n : {40, 80}) {
    Mesh output;
    SMC::coarsen_mesh(mesh, n, output, SMC::parameters::feature_angle(30));
    const SMC::Coarsening_quality q = SMC::measure_coarsening(mesh, output);
    BOOST_TEST(q.rms_distance < 0.003 * q.diagonal);
  }
}

namespace {

// A plate of 3 x 2 squares with a round pin or pocket in each, of `m` sides; `m` is a multiple of 8. Each face has long triangles.
Soup plate_with_pins(std::size_t m)
{
  Soup s;
  const auto add = [&](double x, double y, double z) {
    s.points.push_back({x, y, z});
    return s.points.size() - 1;
  };
  const std::array<std::size_t, 2> number{3, 2};
  std::vector<std::size_t> grid;
  for (const double z : {0., 1.})
    for (std::size_t i = 0; i <= number[0]; ++i)
      for (std::size_t j = 0; j <= number[1]; ++j)
        grid.push_back(add(4. * double(i), 4. * double(j), z));
  const auto at = [&](std::size_t i, std::size_t j, bool top) {
    return grid[(top ? grid.size() / 2 : 0) + i * (number[1] + 1) + j];
  };
  const auto add_wall = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
    s.polygons.push_back({at(i, j, false), at(k, l, false), at(k, l, true), at(i, j, true)});
  };
  for (std::size_t i = 0; i < number[0]; ++i) {
    add_wall(i, 0, i + 1, 0);
    add_wall(i + 1, number[1], i, number[1]);
  }
  for (std::size_t j = 0; j < number[1]; ++j) {
    add_wall(0, j + 1, 0, j);
    add_wall(number[0], j, number[0], j + 1);
  }
  for (std::size_t i = 0; i < number[0]; ++i)
    for (std::size_t j = 0; j < number[1]; ++j) {
      s.polygons.push_back({at(i, j, false), at(i, j + 1, false), at(i + 1, j + 1, false), at(i + 1, j, false)});
      const std::array<std::size_t, 4> square{at(i, j, true), at(i + 1, j, true), at(i + 1, j + 1, true), at(i, j + 1, true)};
      const double height = (i + j) % 2 == 0 ? 2 : -0.5, radius = 1 + 0.2 * double(i);
      generated::Polygon foot, cap;
      for (std::size_t k = 0; k < m; ++k) {
        const double angle = generated::pi * (2. * double(k) / double(m) - 0.75);
        const double x = 4 * double(i) + 2 + radius * std::cos(angle), y = 4 * double(j) + 2 + radius * std::sin(angle);
        foot.push_back(add(x, y, 1));
        cap.push_back(add(x, y, 1 + height));
      }
      for (std::size_t k = 0; k < m; ++k) {
        const std::size_t next = (k + 1) % m, side = 4 * k / m;
        const bool is_first_half = 8 * k / m % 2 == 0;
        s.polygons.push_back({foot[k], foot[next], cap[next], cap[k]});
        s.polygons.push_back({foot[k], square[(side + !is_first_half) % 4], foot[next]});
        if (!is_first_half && 8 * k % m == 0)
          s.polygons.push_back({foot[k], square[side], square[(side + 1) % 4]});
      }
      s.polygons.push_back(cap);
    }
  return generated::rotated(generated::triangulated(s), 0.7, 0.4);
}

// Checks that each edge of a line, unless it connects corners, has a third of the mean length of the edges around it, and that
// this costs no angles, distance or validity.
void check_spacing(const Soup& soup, std::size_t number)
{
  const Mesh mesh = test::to_mesh(soup);
  Mesh output;
  const auto is_line = output.add_property_map<Edge, bool>("e:line", false).first;
  const auto is_corner = output.add_property_map<Vertex, bool>("v:corner", false).first;
  const SMC::Coarsening_report report =
    SMC::coarsen_mesh(mesh, number, output, SMC::parameters::feature_angle(30).subdivide_input(true),
                      SMC::parameters::edge_is_constrained_map(is_line).vertex_is_constrained_map(is_corner));
  const auto length = [&](Edge e) {
    return std::sqrt(CGAL::squared_distance(output.point(output.vertex(e, 0)), output.point(output.vertex(e, 1))));
  };
  double least_part = std::numeric_limits<double>::infinity();
  for (const Edge e : output.edges()) {
    if (!is_line[e] || (is_corner[output.vertex(e, 0)] && is_corner[output.vertex(e, 1)]))
      continue;
    double sum = 0, edges = 0;
    for (int i = 0; i < 2; ++i)
      for (const auto h : CGAL::halfedges_around_target(output.vertex(e, i), output)) {
        sum += length(output.edge(h));
        ++edges;
      }
    least_part = (std::min)(least_part, length(e) / (sum / edges));
  }
  const SMC::Coarsening_quality q = SMC::measure_coarsening(mesh, output);
  BOOST_TEST(3 * least_part > 1);
  BOOST_TEST(q.smallest_angle > 1.5);
  BOOST_TEST(q.maximum_distance < 0.005 * q.diagonal);
  BOOST_TEST(q.self_intersections == 0u);
  BOOST_TEST(report.reversals_left == 0u);
}

} // namespace

// Long triangles beside lines that turn by a few degrees at each vertex.
BOOST_AUTO_TEST_CASE(vertices_on_lines_keep_apart)
{
  const Soup prism = generated::triangulated(generated::scaled(cylinder(24, 1, true), 1, 1, 24));
  for (const std::size_t n : {150, 200, 250, 400, 600, 800})
    check_spacing(prism, n);
  const Soup rod = generated::triangulated(generated::scaled(cylinder(60, 1, true), 1, 1, 60 / generated::pi));
  for (const std::size_t n : {150, 500, 600, 800})
    check_spacing(rod, n);
  for (const std::size_t n : {400, 500, 800, 1000})
    check_spacing(plate_with_pins(24), n);
}

namespace {

// A cube whose sides are wavy inside, with straight edges.
generated::Soup wavy_cube()
{
  generated::Soup cube = generated::triangulated(generated::cube_grid(12));
  for (auto& p : cube.points) {
    const auto q = p;
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = q[(i + 1) % 3], y = q[(i + 2) % 3];
      p[i] += std::abs(q[i]) == 1 ? 0.1 * q[i] * (1 - x * x) * (1 - y * y) * std::sin(4 * (x + y)) : 0;
    }
  }
  return cube;
}

} // namespace

// The fit moves vertices along the lines. Triangles would remain reversed if a vertex had passed the next one.
BOOST_AUTO_TEST_CASE(order_of_vertices_on_lines)
{
  const Mesh mesh = test::to_mesh(wavy_cube());
  for (const std::size_t n : {60, 100, 110, 130, 140, 160}) {
    Mesh output;
    BOOST_TEST(SMC::coarsen_mesh(mesh, n, output, SMC::parameters::feature_angle(30)).reversals_left == 0);
  }
}

// Error feedback moves vertices, with triangles around them, from one patch to another.
BOOST_AUTO_TEST_CASE(patches_after_exchanges)
{
  // A cube's sides, numbered by their normals.
  const auto side = [](const Mesh& mesh, Face f) {
    const auto n = PMP::compute_face_normal(f, mesh);
    int largest = 0;
    for (int i = 1; i < 3; ++i)
      if (std::abs(n[i]) > std::abs(n[largest]))
        largest = i;
    return 10 * (largest + 1) + (n[largest] > 0);
  };
  Mesh mesh = test::to_mesh(wavy_cube()), output;
  const auto patch = mesh.add_property_map<Face, int>("f:patch", -1).first;
  for (const Face f : mesh.faces())
    patch[f] = side(mesh, f);
  const auto of_output = output.add_property_map<Face, int>("f:patch", -1).first;
  const auto report = SMC::coarsen_mesh(mesh, 200, output, SMC::parameters::face_patch_map(patch).error_feedback(7),
                                        SMC::parameters::face_patch_map(of_output));
  BOOST_TEST(report.exchanged_vertices > 0);
  for (const Face f : output.faces())
    BOOST_TEST(of_output[f] == side(output, f));
}

BOOST_AUTO_TEST_CASE(refusals)
{
  for (const double angle : {-1., 181., std::numeric_limits<double>::quiet_NaN()})
    BOOST_CHECK_THROW(coarsened(Model(generated::cube_grid(3), angle), 20), SMC::Invalid_input);
  const Model model(generated::cube_grid(4), 30);
  SMC::Mwcvd_clustering<Mesh, SMC::Maximum_density_weight> c(model.mesh, model.parameters().maximum_density(50.));
  std::vector<std::size_t> labels(model.mesh.number_of_faces(), 0);
  const auto map = boost::make_function_property_map<Face>([&](Face f) { return labels[f]; });
  BOOST_CHECK_THROW(c.set_clusters(map), SMC::Invalid_input);
  c.seed(20);
  c.grow();
  BOOST_CHECK_THROW(c.split_cluster(0), SMC::Invalid_input);
  BOOST_CHECK_THROW(c.remove_cluster(0), SMC::Invalid_input);
  BOOST_TEST(c.number_of_clusters() == 20);
  BOOST_CHECK_THROW(SMC::Cluster_levels<decltype(c)>{c}, SMC::Invalid_input);
}

BOOST_AUTO_TEST_CASE(fandisk, *utf::precondition(test::If_found{models::fandisk}))
{
  Model model(test::read_soup(models::fandisk), 30);
  const Output with = coarsened(model, 527, true);
  check(model, 527, true);
  PMP::detect_sharp_edges(model.mesh, 30, model.is_line);
  const auto is_line = [&](Edge e) { return model.is_line[e]; };
  const auto is_coarse_line = [&](Edge e) { return with.is_line[e]; };
  const SMC::Coarsening_quality quality = SMC::measure_coarsening(model.mesh, with.mesh);
  BOOST_TEST(test::line_distance(model.mesh, is_line, with.mesh, is_coarse_line) < 0.0002 * quality.diagonal);
  BOOST_TEST(test::line_distance(with.mesh, is_coarse_line, model.mesh, is_line) < 0.0002 * quality.diagonal);
  BOOST_TEST(!PMP::does_self_intersect(with.mesh));
  Model plain(test::read_soup(models::fandisk));
  const double without = SMC::measure_coarsening(plain.mesh, coarsened(plain, 527, true).mesh).rms_distance;
  BOOST_TEST(quality.rms_distance <= without);
}

BOOST_AUTO_TEST_SUITE_END()
