// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every vertex of the output lies in the bounding box of its cluster enlarged by half its diagonal, for faces of any shape:
// self-intersecting, nearly degenerate, not planar, or with very many sides.

#include "support/face_graphs.h"
#include "support/generate_meshes.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Exact_maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Closest_vertex_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/extract_dual_mesh.h>

#include <CGAL/Bbox_3.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_vertex_bounds)

namespace SMC = CGAL::Surface_mesh_coarsening;
using generated::Soup;
using test::Mesh;

namespace {

// Returns the distance of a point from a box, in diagonals of the box. Rounding of large coordinates does not count.
double diagonals_outside(const CGAL::Bbox_3& box, double x, double y, double z)
{
  const double p[3] = {x, y, z};
  double square = 0, diagonal = 0, largest = 0;
  for (int i = 0; i < 3; ++i) {
    largest = (std::max)({largest, std::abs((box.min)(i)), std::abs((box.max)(i))});
    diagonal = std::hypot(diagonal, (box.max)(i) - (box.min)(i));
  }
  for (int i = 0; i < 3; ++i) {
    const double d = (std::max)({(box.min)(i) - p[i], p[i] - (box.max)(i), 0.});
    square = (std::max)(square, d);
  }
  return square <= 1e-10 * largest ? 0 : square / diagonal;
}

void check_positions(const Mesh& mesh, const std::vector<std::size_t>& labels, const Mesh& output, const std::string& what)
{
  std::vector<CGAL::Bbox_3> boxes(output.number_of_vertices());
  for (const auto f : mesh.faces())
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      boxes[labels[f]] += mesh.point(v).bbox();
  double farthest = 0;
  for (const auto v : output.vertices()) {
    const auto& p = output.point(v);
    farthest = (std::max)(farthest, diagonals_outside(boxes[v], p.x(), p.y(), p.z()));
  }
  BOOST_TEST(farthest <= 0.5 + 1e-9, what << ": a vertex is " << farthest << " diagonals away from its cluster");
}

template <class Placement>
void check_placement(const Mesh& mesh, const std::vector<std::size_t>& labels, const std::string& what)
{
  const auto map = boost::make_function_property_map<Mesh::Face_index>([&](Mesh::Face_index f) { return labels[f]; });
  for (const bool repair : {false, true}) {
    Mesh output;
    SMC::extract_dual_mesh(mesh, map, output, SMC::parameters::vertex_placement(Placement()).repair_output(repair));
    check_positions(mesh, labels, output, what);
  }
}

template <class Weight>
void check_weight(const Mesh& mesh, std::size_t number, const std::string& what)
{
  std::vector<std::size_t> labels(mesh.number_of_faces());
  SMC::Mwcvd_clustering<Mesh, Weight> clustering(mesh);
  clustering.seed(number);
  clustering.grow();
  clustering.minimize();
  BOOST_TEST(std::isfinite(clustering.energy()), what);
  if (clustering.report().subdivided_components > 0)
    return;
  for (const auto f : mesh.faces())
    labels[f] = clustering.cluster(f);
  check_placement<SMC::Centroid_placement>(mesh, labels, what + ", centroid");
  check_placement<SMC::Closest_vertex_placement>(mesh, labels, what + ", closest vertex");
  check_placement<SMC::Quadric_placement>(mesh, labels, what + ", quadric");
  check_placement<SMC::Fitted_placement>(mesh, labels, what + ", fitted");
}

void check_all(const Soup& soup, std::size_t number, const std::string& what)
{
  const Mesh mesh = test::to_mesh(soup);
  check_weight<SMC::Uniform_weight>(mesh, number, what + ", uniform");
  check_weight<SMC::Weighted_area_weight>(mesh, number, what + ", area");
  check_weight<SMC::Maximum_density_weight>(mesh, number, what + ", maximum");
  check_weight<SMC::Exact_maximum_density_weight>(mesh, number, what + ", exact maximum");
  check_weight<SMC::Density_variance_weight>(mesh, number, what + ", variance");
}

// Nearly swaps two neighboring vertices of a flat grid.
Soup swapped_grid(std::size_t n, std::size_t a, std::size_t b, double off)
{
  Soup s = generated::grid(n, n);
  std::swap(s.points[a], s.points[b]);
  s.points[a][0] += off;
  s.points[a][1] -= 0.3 * off;
  s.points[a][2] += 0.5 * off;
  return s;
}

double with_flipped_bit(double x, unsigned bit)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits ^= std::uint64_t(1) << bit;
  std::memcpy(&x, &bits, sizeof bits);
  return x;
}

// A polygon whose corners go around `turns` times, with a fan of triangles on each side of it.
Soup cone_over_star(std::size_t sides, std::size_t turns, double noise)
{
  Soup s;
  std::mt19937 engine(3);
  generated::Polygon base;
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = 2 * generated::pi * double(turns * i) / double(sides),
                 r = 1 + noise * generated::symmetric_random(engine);
    s.points.push_back({r * std::cos(angle), r * std::sin(angle), noise * generated::symmetric_random(engine)});
    base.push_back(sides - 1 - i);
  }
  s.points.push_back({0, 0, 1});
  s.polygons.push_back(base);
  for (std::size_t i = 0; i < sides; ++i)
    s.polygons.push_back({i, (i + 1) % sides, sides});
  return s;
}

} // namespace

BOOST_AUTO_TEST_CASE(faces_that_cross_themselves)
{
  for (const double off : {0., 1e-15, 1e-6, 1e-3})
    for (const std::size_t neighbor : {61, 71, 72})
      check_all(swapped_grid(10, 60, neighbor, off), 30,
                "60 and " + std::to_string(neighbor) + " swapped, " + std::to_string(off) + " off");
}

BOOST_AUTO_TEST_CASE(a_flipped_bit)
{
  std::mt19937 engine(7);
  for (int i = 0; i < 24; ++i) {
    Soup s = generated::cube_grid(5);
    double& x = s.points[engine() % s.points.size()][engine() % 3];
    const unsigned bit = engine() % 64;
    x = with_flipped_bit(x, bit);
    if (std::isfinite(x))
      check_all(s, 20, "coordinate " + std::to_string(i) + " is " + std::to_string(x));
  }
}

BOOST_AUTO_TEST_CASE(faces_that_are_not_planar)
{
  for (const double noise : {1e-12, 0.1, 1., 10.}) {
    check_all(generated::with_noise(generated::grid(10, 10), noise), 30, "grid, noise " + std::to_string(noise));
    check_all(generated::with_noise(generated::dual(generated::triangle_sphere(3)), noise), 40,
              "hexagons, noise " + std::to_string(noise));
  }
}

BOOST_AUTO_TEST_CASE(faces_of_very_many_sides)
{
  for (const std::size_t turns : {1, 2, 7, 49})
    for (const double noise : {0., 1e-9, 0.2})
      check_all(cone_over_star(101, turns, noise), 20,
                std::to_string(turns) + " turns, noise " + std::to_string(noise));
}

// Lines and corners of features, and the border, where the fit moves vertices along lines.
BOOST_AUTO_TEST_CASE(features_and_borders)
{
  std::size_t seen = 0;
  const auto check = [&](const SMC::Clustered_surface& surface, const SMC::Border_arcs& border,
                         std::vector<std::array<std::uint32_t, 3> >& triangles,
                         std::vector<SMC::Clustered_surface::Point_3>& positions) {
    SMC::Fitted_placement()(surface, border, triangles, positions);
    for (std::size_t x = 0; x < positions.size(); ++x) {
      CGAL::Bbox_3 box;
      for (const std::uint32_t f : surface.faces(x))
        for (const std::uint32_t v : surface.vertices(f)) {
          box += surface.point(v).bbox();
        }
      const auto& p = positions[x];
      BOOST_TEST(diagonals_outside(box, p[0], p[1], p[2]) <= 0.5 + 1e-9);
      ++seen;
    }
  };
  for (const double noise : {0., 1e-6, 0.1})
    for (const std::size_t number : {100, 140}) {
      Mesh output;
      for (const Soup& soup : {generated::with_noise(generated::cube_grid(6), 0.3 * noise), swapped_grid(14, 80, 81, noise)})
        SMC::coarsen_mesh(test::to_mesh(soup), number, output, SMC::parameters::vertex_placement(check).feature_angle(40));
    }
  BOOST_TEST(seen > 0);
}

// A user's placement outside the box is refused without a change of the output; a position that is not finite is replaced by
// the centroid.
BOOST_AUTO_TEST_CASE(placements_that_leave_the_bounds)
{
  const Mesh mesh = test::to_mesh(generated::triangle_sphere(3));
  double off = 0;
  bool clamps = false;
  const auto placement = [&](const SMC::Clustered_surface& surface, std::size_t cluster) {
    const auto c = surface.cluster_centroid(cluster);
    const SMC::Clustered_surface::Point_3 p(c.x(), cluster == 7 ? c.y() + off : c.y(), c.z());
    return clamps ? surface.within_bounds(cluster, p) : p;
  };
  Mesh output;
  const auto np = SMC::parameters::vertex_placement(placement).repair_output(false);
  SMC::coarsen_mesh(mesh, 20, output, np);
  const Mesh before = output;
  for (const double outside : {3., -3., 1e10, -1e300}) {
    off = outside;
    BOOST_CHECK_EXCEPTION(SMC::coarsen_mesh(mesh, 25, output, np), SMC::Invalid_input, [](const SMC::Invalid_input& e) {
      return std::string(e.what()).find("the vertex of cluster 7 at (") != std::string::npos;
    });
    BOOST_TEST(output.number_of_vertices() == 20);
    BOOST_TEST((test::to_soup(output).points == test::to_soup(before).points));
    clamps = true;
    SMC::coarsen_mesh(mesh, 25, output, np);
    BOOST_TEST(output.number_of_vertices() == 25);
    clamps = false;
    output = before;
  }
}

// The centroids of simple polygons: an L of three unit squares, from each of its corners.
BOOST_AUTO_TEST_CASE(centroids_of_polygons)
{
  std::vector<generated::Point> corners = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  for (std::size_t first = 0; first < corners.size(); ++first) {
    Soup s;
    s.points = corners;
    s.points.push_back({1, 1, 1});
    s.polygons.push_back({5, 4, 3, 2, 1, 0});
    for (std::size_t i = 0; i < 6; ++i)
      s.polygons.push_back({i, (i + 1) % 6, 6});
    bool found = false;
    Mesh output;
    const auto placement = [&](const SMC::Clustered_surface& surface, std::size_t cluster) {
      for (const std::uint32_t f : surface.faces(cluster))
        if (surface.vertices(f).size() == 6) {
          found = true;
          const auto c = surface.centroid(f);
          double low[2] = {10, 10}; // the local frame is a translation
          for (const auto v : surface.vertices(f))
            for (int i = 0; i < 2; ++i)
              low[i] = (std::min)(low[i], surface.point(v)[i]);
          BOOST_TEST(surface.area(f) == 3, boost::test_tools::tolerance(1e-12));
          BOOST_TEST(c[0] - low[0] == 5. / 6, boost::test_tools::tolerance(1e-12));
          BOOST_TEST(c[1] - low[1] == 5. / 6, boost::test_tools::tolerance(1e-12));
        }
      return surface.cluster_centroid(cluster);
    };
    SMC::coarsen_mesh(test::to_mesh(s), 5, output, SMC::parameters::vertex_placement(placement));
    BOOST_TEST(found);
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  }
}

BOOST_AUTO_TEST_SUITE_END()
