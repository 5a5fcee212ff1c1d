// SPDX-License-Identifier: GPL-3.0-or-later
//
// The border of the output against the border of the input, and measure_coarsening() on meshes of known distances.

#include "support/face_graphs.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_borders)

namespace SMC = CGAL::Surface_mesh_coarsening;
namespace PMP = CGAL::Polygon_mesh_processing;
using generated::Soup;
using SMC::internal::Border_arc;
using test::Mesh;

namespace {

typedef boost::mpl::list<SMC::Uniform_weight, SMC::Weighted_area_weight, SMC::Maximum_density_weight,
                         SMC::Density_variance_weight>
  Weights;

std::size_t border_length(const Mesh& mesh)
{
  std::size_t n = 0;
  for (const auto h : mesh.halfedges())
    n += mesh.is_border(h);
  return n;
}

SMC::Coarsening_quality quality(const Soup& a, const Soup& b)
{
  return SMC::measure_coarsening(test::to_mesh(a), test::to_mesh(b));
}

// The border of a flat disc: a circle with waves.
Soup wavy_disc(std::size_t n)
{
  Soup s = generated::triangulated(generated::tube(n, n / 4));
  for (generated::Point& p : s.points) {
    const double angle = std::atan2(p[1], p[0]), depth = 0.2 + 0.8 * p[2] / (2 * generated::pi * double(n / 4) / double(n));
    const double radius = depth * (1 + 0.15 * depth * std::cos(6 * angle));
    p = {radius * std::cos(angle), radius * std::sin(angle), 0};
  }
  return s;
}

double squared_distance_from_side(const SMC::internal::Vector& p, const SMC::internal::Vector& a,
                                  const SMC::internal::Vector& b)
{
  using namespace SMC::internal;
  const Vector ab = b - a, ap = p - a;
  const double u = (std::max)(0., (std::min)(1., dot(ab, ap) / dot(ab, ab)));
  const Vector d = ap - u * ab;
  return dot(d, d);
}

} // namespace

// Four corners, each in the arc of one cluster, are vertices of the output: the square remains a square.
BOOST_AUTO_TEST_CASE_TEMPLATE(corners_are_kept, Weight, Weights)
{
  const Mesh mesh = test::to_mesh(generated::triangulated(generated::grid(30, 30)));
  for (const std::size_t n : {20, 60, 150}) {
    Mesh output;
    SMC::coarsen_mesh(mesh, n, output, SMC::parameters::cluster_weight(Weight()).vertex_placement(SMC::Centroid_placement()));
    const SMC::Coarsening_quality q = SMC::measure_coarsening(mesh, output, 10000);
    BOOST_CHECK_SMALL(q.border_maximum_distance, 1e-9);
    BOOST_CHECK_CLOSE(PMP::area(output), 900, 1e-9);
  }
}

// The vertices on the border lie on the input's border, and the polygon is about as close to it as possible with its
// number of vertices; with vertices at the middle of the arcs it is not.
BOOST_AUTO_TEST_CASE_TEMPLATE(close_to_a_curved_border, Weight, Weights)
{
  const Mesh mesh = test::to_mesh(wavy_disc(240));
  for (const std::size_t n : {60, 150}) {
    Mesh output;
    SMC::coarsen_mesh(mesh, n, output, SMC::parameters::cluster_weight(Weight()).vertex_placement(SMC::Centroid_placement()));
    const auto fine = SMC::internal::triangulated_copy(mesh, SMC::parameters::default_values()),
               coarse = SMC::internal::triangulated_copy(output, SMC::parameters::default_values());
    const SMC::internal::Segments border = SMC::internal::border_segments(fine);
    for (const auto v : coarse.vertices())
      if (coarse.is_border(v)) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& s : border)
          nearest = (std::min)(nearest, CGAL::squared_distance(s, coarse.point(v)));
        BOOST_CHECK_SMALL(nearest, 1e-18);
      }
    const double per_vertex = double(border_length(output));
    const double rms = SMC::measure_coarsening(mesh, output, 10000).border_rms_distance;
    BOOST_TEST_MESSAGE("border distance " << rms << " with " << per_vertex << " vertices");
    // The distance of a circle of radius 1 from a regular polygon is about pi^2 / 2 / n^2 * sqrt(8 / 15); the waves are
    // sharper.
    BOOST_CHECK_LT(rms, 4 * 3.6 / (per_vertex * per_vertex) * 3);
  }
}

// Dynamic programming agrees with exhaustive search.
BOOST_AUTO_TEST_CASE(best_of_all_polygons)
{
  std::mt19937 engine(5);
  for (int round = 0; round < 40; ++round) {
    const std::size_t n = 3 + round % 3;
    std::vector<SMC::internal::Vector> loop;
    const std::size_t edges = 3;
    for (std::size_t i = 0; i < n * edges; ++i) {
      const double angle = 2 * generated::pi * double(i) / double(n * edges);
      const double radius = 1 + 0.4 * generated::symmetric_random(engine);
      loop.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.4 * generated::symmetric_random(engine)});
    }
    std::vector<Border_arc> arcs;
    for (std::size_t k = 0; k < n; ++k) {
      std::vector<SMC::internal::Vector> points;
      for (std::size_t i = 0; i <= edges; ++i)
        points.push_back(loop[(k * edges + i) % loop.size()]);
      arcs.emplace_back(points);
      BOOST_CHECK_EQUAL(arcs.back().size(), edges + 2); // the additional one is at the middle
    }
    const auto error = [&](const std::vector<std::size_t>& chosen) {
      double sum = 0;
      for (std::size_t k = 0; k < n; ++k) {
        const Border_arc &arc = arcs[k], &next = arcs[(k + 1) % n];
        const auto a = arc[chosen[k]], b = next[chosen[(k + 1) % n]];
        std::vector<SMC::internal::Vector> way;
        for (std::size_t i = chosen[k]; i < arc.size(); ++i)
          way.push_back(arc[i]);
        for (std::size_t i = 1; i <= chosen[(k + 1) % n]; ++i)
          way.push_back(next[i]);
        if (way.size() < 2)
          return std::numeric_limits<double>::infinity();
        using namespace SMC::internal;
        for (std::size_t i = 0; i + 1 < way.size(); ++i) {
          const Vector edge = way[i + 1] - way[i];
          sum += std::sqrt(dot(edge, edge)) / 6 *
                 (squared_distance_from_side(way[i], a, b) + squared_distance_from_side(way[i + 1], a, b) +
                  4 * squared_distance_from_side(0.5 * (way[i] + way[i + 1]), a, b));
        }
        const double off = next.part(chosen[(k + 1) % n]) - 0.5;
        sum += 3e-4 * off * off * std::pow(next.length(), 3);
      }
      return sum;
    };
    double least = std::numeric_limits<double>::infinity();
    std::vector<std::size_t> trial(n, 0);
    for (bool more = true; more;) {
      least = (std::min)(least, error(trial));
      std::size_t k = 0;
      while (k < n && ++trial[k] == arcs[k].size())
        trial[k++] = 0;
      more = k < n;
    }
    BOOST_CHECK_CLOSE(error(SMC::internal::Border_fit(arcs).run()), least, 1e-9);
  }
}

// Arcs of very many edges are simplified; the sharp corner remains.
BOOST_AUTO_TEST_CASE(long_arcs)
{
  std::vector<SMC::internal::Vector> points;
  for (int i = 0; i <= 1000; ++i)
    points.push_back({i < 377 ? double(i) : 377., i < 377 ? 0. : double(i) - 377, 0});
  const Border_arc arc(points);
  BOOST_CHECK_LE(arc.size(), Border_arc::max_pieces + 3);
  bool has_corner = false;
  for (std::size_t i = 0; i < arc.size(); ++i)
    has_corner = has_corner || arc[i] == SMC::internal::Vector{{377, 0, 0}};
  BOOST_CHECK(has_corner);
  // An arc without length, and one of a single edge.
  BOOST_CHECK_EQUAL(Border_arc({{{1, 1, 1}}, {{1, 1, 1}}}).size(), 3u);
  BOOST_CHECK_EQUAL(Border_arc({{{0, 0, 0}}, {{1, 0, 0}}}).size(), 3u);
}

// ---- measuring ----

BOOST_AUTO_TEST_CASE(parallel_grids)
{
  const Soup grid = generated::grid(10, 6);
  const SMC::Coarsening_quality q =
    quality(grid, generated::translated(generated::triangulated(generated::scaled(generated::grid(5, 3), 2)), 0, 0, 0.25));
  BOOST_CHECK_CLOSE(q.rms_distance, 0.25, 1e-9);
  BOOST_CHECK_CLOSE(q.mean_distance, 0.25, 1e-9);
  BOOST_CHECK_CLOSE(q.maximum_distance, 0.25, 1e-9);
  BOOST_CHECK_CLOSE(q.border_rms_distance, 0.25, 1e-9);
  BOOST_CHECK_CLOSE(q.border_mean_distance, 0.25, 1e-9);
  BOOST_CHECK_CLOSE(q.border_maximum_distance, 0.25, 1e-9);
  for (const SMC::Surface_error& e : {q.from_mesh, q.from_coarse}) {
    BOOST_CHECK_CLOSE(e.rms_distance, 0.25, 1e-9);
    BOOST_CHECK_CLOSE(e.mean_distance, 0.25, 1e-9);
    BOOST_CHECK_CLOSE(e.maximum_distance, 0.25, 1e-9);
    BOOST_CHECK_SMALL(e.maximum_normal_deviation, 1e-6);
  }
  BOOST_CHECK_SMALL(q.maximum_normal_deviation, 1e-6);
  BOOST_CHECK_CLOSE(q.mean_smallest_angle, 45, 1e-9);
  BOOST_CHECK_CLOSE(q.smallest_angle, 45, 1e-9);
  BOOST_CHECK_EQUAL(q.part_below_30_degrees, 0);
  BOOST_CHECK_EQUAL(q.self_intersections, 0u);
  BOOST_CHECK_CLOSE(q.diagonal, std::sqrt(136.), 1e-9);
}

// A square of side 1 and its translation by s along a side. The translated side is at distance s, less near its ends;
// the other two sides protrude by s.
BOOST_AUTO_TEST_CASE(shifted_square)
{
  const Soup square = generated::scaled(generated::grid(10, 10), 0.1);
  for (const double s : {0.01, 0.1, 0.4}) {
    const SMC::Coarsening_quality q = quality(square, generated::translated(square, s, 0, 0));
    BOOST_CHECK_CLOSE(q.border_rms_distance, std::sqrt((2 * s * s - 2 * s * s * s / 3) / 4), 0.1);
    BOOST_CHECK_CLOSE(q.border_mean_distance, (2 * s - s * s + s * s) / 4, 0.1);
    BOOST_CHECK_CLOSE(q.border_maximum_distance, s, 0.1);
    BOOST_CHECK_CLOSE(q.maximum_distance, s, 1);
  }
}

BOOST_AUTO_TEST_CASE(directions_and_angles)
{
  // The larger direction counts: a mesh is far from its half, but the half is not far from the mesh.
  const SMC::Coarsening_quality q = quality(generated::grid(2, 1), generated::grid(1, 1));
  BOOST_CHECK_CLOSE(q.maximum_distance, 1, 1);
  BOOST_CHECK_CLOSE(q.mean_distance, 0.25, 1);
  BOOST_CHECK_CLOSE(q.rms_distance, std::sqrt(1 / 6.), 1);
  BOOST_CHECK_CLOSE(q.from_mesh.rms_distance, q.rms_distance, 1e-9);
  BOOST_CHECK_SMALL(q.from_coarse.maximum_distance, 1e-9);
  // A roof of 30 degrees over a plane.
  const double h = std::tan(generated::pi / 6);
  const Soup roof{{{0, 0, 0}, {1, 0, h}, {2, 0, 0}, {0, 4, 0}, {1, 4, h}, {2, 4, 0}}, {{0, 1, 4, 3}, {1, 2, 5, 4}}};
  const SMC::Coarsening_quality r = quality(generated::scaled(generated::grid(2, 4), 1), roof);
  BOOST_CHECK_CLOSE(r.mean_normal_deviation, 30, 1e-6);
  BOOST_CHECK_CLOSE(r.rms_normal_deviation, 30, 1e-6);
  // Half a roof, over the plane, ends at a side: a quarter of its samples deviates by 30 degrees, and three quarters by none.
  const Soup bent{{{0, 0, 0}, {3, 0, 0}, {3 + std::cos(generated::pi / 6), 0, 0.5}, {0, 4, 0}, {3, 4, 0},
                   {3 + std::cos(generated::pi / 6), 4, 0.5}},
                  {{0, 1, 4, 3}, {1, 2, 5, 4}}};
  const SMC::Coarsening_quality b = quality(generated::grid(3, 4), bent);
  BOOST_CHECK_CLOSE(b.from_coarse.mean_normal_deviation, 7.5, 1e-2);
  BOOST_CHECK_CLOSE(b.from_coarse.rms_normal_deviation, 15, 1e-2);
  BOOST_CHECK_CLOSE(b.from_coarse.maximum_normal_deviation, 30, 1e-6);
  BOOST_CHECK_SMALL(b.from_mesh.mean_normal_deviation, 1e-6);
  BOOST_CHECK_EQUAL(b.mean_normal_deviation, b.from_coarse.mean_normal_deviation);
  BOOST_CHECK_EQUAL(b.rms_normal_deviation, b.from_coarse.rms_normal_deviation);
  // A triangle with angles of 30, 60 and 90 degrees beside one with 45, 45 and 90.
  const Soup two{{{0, 0, 0}, {std::sqrt(3.), 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {3, 4, 5}}};
  const SMC::Coarsening_quality a = quality(two, two);
  BOOST_CHECK_CLOSE(a.smallest_angle, 30, 1e-9);
  BOOST_CHECK_CLOSE(a.mean_smallest_angle, 37.5, 1e-9);
  Soup needle = two;
  needle.points[2][1] = 0.5;
  BOOST_CHECK_EQUAL(quality(needle, needle).part_below_30_degrees, 0.5);
  // Two triangles that cross.
  const Soup cross{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, -1}, {0.5, 0.5, 1}, {3, 3, 0}}, {{0, 1, 2}, {3, 4, 5}}};
  BOOST_CHECK_EQUAL(quality(cross, cross).self_intersections, 1u);
}

BOOST_AUTO_TEST_CASE(borders_on_one_side_only)
{
  const Soup closed = generated::triangle_sphere(2), open = generated::with_holes(closed, 1);
  BOOST_CHECK_EQUAL(quality(closed, closed).border_rms_distance, 0);
  BOOST_CHECK(std::isinf(quality(closed, open).border_rms_distance));
  BOOST_CHECK(std::isinf(quality(open, closed).border_maximum_distance));
}

BOOST_AUTO_TEST_SUITE_END()
