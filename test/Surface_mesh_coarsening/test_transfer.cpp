// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sources of the vertices of a coarse mesh, and the transfer of properties to it.

#include "support/face_graphs.h"
#include "support/generate_meshes.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_faces.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh_to_distance.h>
#include <CGAL/Surface_mesh_coarsening/transfer_properties.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_transfer)

namespace SMC = CGAL::Surface_mesh_coarsening;
namespace PMP = CGAL::Polygon_mesh_processing;
using test::Mesh;
using Point = Mesh::Point;

namespace {

typedef SMC::Surface_location<Mesh> Location;

Point point_at(const Mesh& mesh, const Location& location)
{
  CGAL::Vector_3<CGAL::Kernel_traits<Point>::Kernel> sum(0, 0, 0);
  auto h = mesh.halfedge(location.face);
  for (const double x : location.coordinates) {
    sum = sum + x * (mesh.point(mesh.source(h)) - CGAL::ORIGIN);
    h = mesh.next(h);
  }
  return CGAL::ORIGIN + sum;
}

// Over all triangles of all fans, each around the corner of smallest number.
double distance_by_brute_force(const Mesh& mesh, const Point& p)
{
  double least = std::numeric_limits<double>::infinity();
  for (const auto f : mesh.faces()) {
    std::vector<Mesh::Vertex_index> corners(mesh.vertices_around_face(mesh.halfedge(f)).begin(),
                                            mesh.vertices_around_face(mesh.halfedge(f)).end());
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    for (std::size_t i = 2; i < corners.size(); ++i) {
      typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
      const auto q = [&](std::size_t j) {
        const Point& r = mesh.point(corners[j]);
        return Kernel::Point_3(r.x(), r.y(), r.z());
      };
      least = (std::min)(least, CGAL::squared_distance(Kernel::Triangle_3(q(0), q(i - 1), q(i)),
                                                       Kernel::Point_3(p.x(), p.y(), p.z())));
    }
  }
  return std::sqrt(least);
}

struct Result
{
  Mesh input, output;
  Mesh::Property_map<Mesh::Face_index, std::size_t> cluster;
  Mesh::Property_map<Mesh::Vertex_index, std::size_t> vertex_cluster;
  Mesh::Property_map<Mesh::Vertex_index, Location> source;

  Result(const generated::Soup& soup, std::size_t vertices) : input(test::to_mesh(soup))
  {
    cluster = input.add_property_map<Mesh::Face_index, std::size_t>("f:cluster").first;
    vertex_cluster = input.add_property_map<Mesh::Vertex_index, std::size_t>("v:cluster").first;
    source = output.add_property_map<Mesh::Vertex_index, Location>("v:source").first;
    SMC::coarsen_mesh(input, vertices, output,
                      SMC::parameters::cluster_weight(SMC::Maximum_density_weight())
                        .maximum_density(50.)
                        .vertex_placement(SMC::Centroid_placement())
                        .face_cluster_map(cluster)
                        .vertex_to_cluster_map(vertex_cluster),
                      SMC::parameters::vertex_source_map(source));
  }
};

double area_at(const Mesh& mesh, Mesh::Vertex_index v)
{
  double sum = 0;
  for (const auto f : mesh.faces_around_target(mesh.halfedge(v)))
    if (f != Mesh::null_face())
      sum += PMP::face_area(f, mesh) / 3;
  return sum;
}

} // namespace

BOOST_AUTO_TEST_CASE(sources_are_nearest_points)
{
  const generated::Soup torus = generated::with_noise(generated::torus(24, 16), 0.05);
  const generated::Soup flat_sheets =
    generated::joined(generated::scaled(generated::grid(20, 20), 1, 1, 1),
                      generated::translated(generated::triangulated(generated::grid(20, 20)), 0.01, 0.02, 0.005));
  for (const generated::Soup& soup :
       {torus, generated::triangulated(torus), generated::dual(generated::triangulated(torus)), flat_sheets,
        generated::scaled(generated::translated(torus, 1e3, 0, 0), 1e200)})
    for (const std::size_t n : {20, 60}) {
      const Result r(soup, n);
      BOOST_REQUIRE_EQUAL(r.output.number_of_vertices(), n);
      for (const auto v : r.output.vertices()) {
        const Location& location = r.source[v];
        BOOST_REQUIRE(r.input.is_valid(location.face));
        BOOST_REQUIRE_EQUAL(location.coordinates.size(), r.input.degree(location.face));
        double sum = 0;
        for (const double x : location.coordinates) {
          BOOST_CHECK_GE(x, 0);
          sum += x;
        }
        BOOST_CHECK_CLOSE(sum, 1, 1e-10);
        if (std::abs(r.output.point(v).x()) > 1e100)
          continue;
        const double found = std::sqrt(CGAL::squared_distance(r.output.point(v), point_at(r.input, location)));
        BOOST_CHECK_SMALL(found - distance_by_brute_force(r.input, r.output.point(v)), 1e-12);
      }
    }
}

BOOST_AUTO_TEST_CASE(clusters_and_their_inverses_agree)
{
  const Result r(generated::triangulated(generated::with_noise(generated::torus(24, 16), 0.05)), 30);
  const SMC::Cluster_faces<Mesh> inverse(r.input, r.cluster, r.output.number_of_vertices());
  BOOST_REQUIRE_EQUAL(inverse.size(), 30u);
  std::set<Mesh::Face_index> seen;
  for (std::size_t x = 0; x < inverse.size(); ++x) {
    BOOST_CHECK_GT(inverse.faces(x).size(), 0u);
    for (const auto f : inverse.faces(x)) {
      BOOST_CHECK_EQUAL(r.cluster[f], x);
      BOOST_CHECK(seen.insert(f).second);
    }
  }
  BOOST_CHECK_EQUAL(seen.size(), r.input.number_of_faces());
  for (const auto v : r.input.vertices()) {
    std::map<std::size_t, double> area;
    for (const auto f : r.input.faces_around_target(r.input.halfedge(v)))
      area[r.cluster[f]] += PMP::face_area(f, r.input);
    for (const auto& other : area)
      BOOST_CHECK_LE(other.second, area.at(r.vertex_cluster[v]) * (1 + 1e-12));
  }
  BOOST_CHECK_THROW(SMC::Cluster_faces<Mesh>(r.input, r.cluster, 10), SMC::Invalid_input);
}

BOOST_AUTO_TEST_CASE(linear_fields_are_exact_on_planes)
{
  const generated::Soup bent = generated::rotated(generated::grid(30, 20), 0.4, 1.1);
  for (const generated::Soup& soup : {bent, generated::triangulated(bent)}) {
    Result r(soup, 40);
    const auto linear = [](const Point& p) { return 3 * p.x() - 2 * p.y() + 0.5 * p.z() + 7; };
    const auto from = r.input.add_property_map<Mesh::Vertex_index, double>("v:linear").first;
    const auto to = r.output.add_property_map<Mesh::Vertex_index, double>("v:linear").first;
    for (const auto v : r.input.vertices())
      from[v] = linear(r.input.point(v));
    SMC::Property_resampler<Mesh, Mesh> transfer(r.input, r.cluster, r.output);
    transfer.transfer_vertex_property(from, to);
    for (const auto v : r.output.vertices())
      BOOST_CHECK_SMALL(to[v] - linear(r.output.point(v)), 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(fields_on_spheres_are_of_second_order)
{
  std::vector<double> errors;
  for (const std::size_t n : {100, 400, 1600}) {
    Result r(generated::triangle_sphere(6), n);
    const auto from = r.input.add_property_map<Mesh::Vertex_index, double>("v:z").first;
    const auto to = r.output.add_property_map<Mesh::Vertex_index, double>("v:z").first;
    for (const auto v : r.input.vertices())
      from[v] = r.input.point(v).z();
    SMC::Property_resampler<Mesh, Mesh>(r.input, r.cluster, r.output).transfer_vertex_property(from, to);
    double sum = 0;
    for (const auto v : r.output.vertices())
      sum += std::pow(to[v] - r.output.point(v).z(), 2) / double(n);
    errors.push_back(std::sqrt(sum));
  }
  BOOST_TEST_MESSAGE("errors " << errors[0] << ' ' << errors[1] << ' ' << errors[2]);
  BOOST_CHECK_GT(errors[0] / errors[1], 3.5);
  BOOST_CHECK_GT(errors[1] / errors[2], 3.5);
}

BOOST_AUTO_TEST_CASE(totals_are_conserved)
{
  Result r(generated::with_noise(generated::torus(40, 30), 0.05), 60);
  const auto of_face = r.input.add_property_map<Mesh::Face_index, double>("f:mass").first;
  const auto of_vertex = r.input.add_property_map<Mesh::Vertex_index, double>("v:mass").first;
  double face_total = 0, vertex_total = 0;
  for (const auto v : r.input.vertices())
    of_vertex[v] = 2 + std::sin(5 * r.input.point(v).x());
  for (const auto f : r.input.faces()) {
    // The area is the area of the projection along the mean normal, as everywhere in the package.
    CGAL::Vector_3<CGAL::Kernel_traits<Point>::Kernel> normal(0, 0, 0);
    const auto h = r.input.halfedge(f);
    for (auto g = r.input.next(h); r.input.target(g) != r.input.source(h); g = r.input.next(g))
      normal = normal + CGAL::cross_product(r.input.point(r.input.source(g)) - r.input.point(r.input.source(h)),
                                            r.input.point(r.input.target(g)) - r.input.point(r.input.source(h)));
    const double area = std::sqrt(normal.squared_length()) / 2;
    of_face[f] = 1 + std::cos(3 * r.input.point(r.input.target(r.input.halfedge(f))).y());
    face_total += of_face[f] * area;
    for (const auto v : r.input.vertices_around_face(r.input.halfedge(f)))
      vertex_total += of_vertex[v] * area / r.input.degree(f);
  }
  SMC::Property_resampler<Mesh, Mesh> transfer(r.input, r.cluster, r.output);
  const auto policy = SMC::Transfer_policy::CONSERVATIVE;
  const auto faces = r.output.add_property_map<Mesh::Face_index, double>("f:mass").first;
  const auto vertices = r.output.add_property_map<Mesh::Vertex_index, double>("v:mass").first;
  const auto cells = r.output.add_property_map<Mesh::Vertex_index, double>("v:cells").first;
  transfer.transfer_face_property(of_face, faces, policy);
  transfer.transfer_vertex_property(of_vertex, vertices, policy);
  transfer.transfer_face_property_to_vertices(of_face, cells, policy);
  double face_sum = 0, vertex_sum = 0, cell_sum = 0;
  for (const auto f : r.output.faces())
    face_sum += faces[f] * PMP::face_area(f, r.output);
  for (const auto v : r.output.vertices()) {
    vertex_sum += vertices[v] * area_at(r.output, v);
    cell_sum += cells[v] * area_at(r.output, v);
  }
  BOOST_CHECK_SMALL(face_sum / face_total - 1, 1e-12);
  BOOST_CHECK_SMALL(cell_sum / face_total - 1, 1e-12);
  BOOST_CHECK_SMALL(vertex_sum / vertex_total - 1, 1e-12);
}

BOOST_AUTO_TEST_CASE(labels_go_by_majority)
{
  Result r(generated::cube_grid(20), 200);
  const auto from = r.input.add_property_map<Mesh::Face_index, std::string>("f:material").first;
  const auto side = [](const Mesh& mesh, Mesh::Face_index f) {
    const auto n = PMP::compute_face_normal(f, mesh);
    return n.x() > 0.9 ? "right" : n.x() < -0.9 ? "left" : "other";
  };
  for (const auto f : r.input.faces())
    from[f] = side(r.input, f);
  SMC::Property_resampler<Mesh, Mesh> transfer(r.input, r.cluster, r.output);
  const auto to = r.output.add_property_map<Mesh::Face_index, std::string>("f:material").first;
  transfer.transfer_face_property(from, to, SMC::Transfer_policy::MAJORITY);
  double total = 0, right = 0;
  for (const auto f : r.output.faces()) {
    const double area = PMP::face_area(f, r.output);
    total += area;
    right += to[f] == "right" ? area : 0;
    if (std::string(side(r.output, f)) == "right")
      BOOST_CHECK_EQUAL(to[f], "right");
  }
  BOOST_CHECK_SMALL(right / total - 1. / 6, 0.03);
  const auto at = r.output.add_property_map<Mesh::Vertex_index, std::string>("v:material").first;
  transfer.transfer_face_property_to_vertices(from, at, SMC::Transfer_policy::MAJORITY);
  const SMC::Cluster_faces<Mesh> inverse(r.input, r.cluster, r.output.number_of_vertices());
  for (std::size_t x = 0; x < inverse.size(); ++x) {
    std::map<std::string, std::size_t> votes;
    for (const auto f : inverse.faces(x))
      ++votes[from[f]];
    for (const auto& vote : votes)
      BOOST_CHECK_LE(vote.second, votes[at[Mesh::Vertex_index(Mesh::size_type(x))]]);
  }
}

// Names cannot be interpolated: they come from the corner of largest coordinate, or from the face.
BOOST_AUTO_TEST_CASE(values_without_means)
{
  Result r(generated::with_noise(generated::triangle_sphere(4), 0.01), 60);
  const auto name = r.input.add_property_map<Mesh::Vertex_index, std::string>("v:name").first;
  const auto face_name = r.input.add_property_map<Mesh::Face_index, std::string>("f:name").first;
  for (const auto v : r.input.vertices())
    name[v] = "vertex " + std::to_string(std::size_t(v));
  for (const auto f : r.input.faces())
    face_name[f] = std::to_string(r.cluster[f]);
  SMC::Property_resampler<Mesh, Mesh> transfer(r.input, r.cluster, r.output);
  const auto to = r.output.add_property_map<Mesh::Vertex_index, std::string>("v:name").first;
  const auto cluster_name = r.output.add_property_map<Mesh::Vertex_index, std::string>("v:cluster").first;
  const auto to_face = r.output.add_property_map<Mesh::Face_index, std::string>("f:name").first;
  transfer.transfer_vertex_property(name, to);
  transfer.transfer_face_property_to_vertices(face_name, cluster_name);
  transfer.transfer_face_property(face_name, to_face);
  for (const auto v : r.output.vertices()) {
    const Location& location = r.source[v];
    auto h = r.input.halfedge(location.face);
    const auto largest = std::max_element(location.coordinates.begin(), location.coordinates.end());
    for (auto i = location.coordinates.begin(); i != largest; ++i)
      h = r.input.next(h);
    BOOST_CHECK_EQUAL(to[v], name[r.input.source(h)]);
    BOOST_CHECK_EQUAL(cluster_name[v], face_name[location.face]);
  }
  for (const auto f : r.output.faces()) {
    std::set<std::string> of_corners;
    for (const auto v : r.output.vertices_around_face(r.output.halfedge(f)))
      of_corners.insert(std::to_string(std::size_t(v)));
    BOOST_CHECK_EQUAL(of_corners.count(to_face[f]), 1u);
  }
  const auto conservative = SMC::Transfer_policy::CONSERVATIVE;
  BOOST_CHECK_THROW(transfer.transfer_vertex_property(name, to, conservative), SMC::Invalid_input);
  BOOST_CHECK_THROW(transfer.transfer_face_property_to_vertices(face_name, to, conservative), SMC::Invalid_input);
  BOOST_CHECK_THROW(transfer.transfer_face_property(face_name, to_face, conservative), SMC::Invalid_input);
}

// A tube with a texture wound around it once: u increases from 0 to 1, with a seam along a line.
BOOST_AUTO_TEST_CASE(seams_do_not_open)
{
  typedef std::array<double, 2> Uv;
  const std::size_t around = 64, along = 64;
  for (const bool given : {false, true}) {
    Result r(generated::triangulated(generated::tube(around, along)), 120);
    const auto uv = r.input.add_property_map<Mesh::Halfedge_index, Uv>("h:uv").first;
    const auto is_seam = r.input.add_property_map<Mesh::Edge_index, bool>("e:seam").first;
    const double pi = std::acos(-1.);
    const auto turn = [pi](const Point& p) { // within [0, 1)
      const double a = std::atan2(p.y(), p.x()) / (2 * pi);
      return a < -1e-9 ? a + 1 : (std::max)(0., a);
    };
    for (const auto f : r.input.faces()) {
      double largest = 0;
      for (const auto v : r.input.vertices_around_face(r.input.halfedge(f)))
        largest = (std::max)(largest, turn(r.input.point(v)));
      for (const auto h : r.input.halfedges_around_face(r.input.halfedge(f))) {
        const Point& p = r.input.point(r.input.target(h));
        uv[h] = Uv{{turn(p) < 0.25 && largest > 0.75 ? turn(p) + 1 : turn(p), p.z()}};
      }
    }
    for (const auto e : r.input.edges()) {
      const auto h = r.input.halfedge(e);
      is_seam[e] = !r.input.is_border(e) && turn(r.input.point(r.input.source(h))) < 1e-9 &&
                   turn(r.input.point(r.input.target(h))) < 1e-9;
    }
    const auto out = r.output.add_property_map<Mesh::Halfedge_index, Uv>("h:uv").first;
    SMC::Property_resampler<Mesh, Mesh> transfer(r.input, r.cluster, r.output);
    if (given)
      transfer.transfer_corner_property(uv, out, is_seam);
    else
      transfer.transfer_corner_property(uv, out);
    std::size_t seams = 0;
    for (const auto f : r.output.faces()) {
      double low = 2, high = -1;
      for (const auto h : r.output.halfedges_around_face(r.output.halfedge(f))) {
        low = (std::min)(low, out[h][0]);
        high = (std::max)(high, out[h][0]);
        // The value agrees with the position, up to the width of a triangle across the seam.
        const double u = turn(r.output.point(r.output.target(h))), d = std::abs(out[h][0] - u);
        BOOST_CHECK_LT((std::min)(d, 1 - d), 0.2);
        BOOST_CHECK_GE(out[h][0], 0);
        BOOST_CHECK_LE(out[h][0], 1);
      }
      BOOST_CHECK_LT(high - low, 0.4); // no triangle runs all around
    }
    // Between two triangles the values agree at both ends, or belong to the two sides of the seam.
    for (const auto e : r.output.edges()) {
      if (r.output.is_border(e))
        continue;
      const auto h = r.output.halfedge(e), o = r.output.opposite(h);
      const double at_target = std::abs(out[h][0] - out[r.output.prev(o)][0]);
      const double at_source = std::abs(out[o][0] - out[r.output.prev(h)][0]);
      BOOST_CHECK_EQUAL(at_target == 0, at_source == 0);
      if (at_target != 0) {
        ++seams;
        BOOST_CHECK_GT(at_target, 0.6);
        BOOST_CHECK_GT(at_source, 0.6);
      }
    }
    BOOST_CHECK_GE(seams, 3u);
  }
}

BOOST_AUTO_TEST_CASE(all_properties_in_one_call)
{
  Result r(generated::with_noise(generated::torus(24, 16), 0.05), 40);
  typedef CGAL::IO::Color Color;
  const auto color = r.input.add_property_map<Mesh::Vertex_index, Color>("v:color").first;
  const auto quality = r.input.add_property_map<Mesh::Vertex_index, float>("v:quality").first;
  const auto label = r.input.add_property_map<Mesh::Face_index, int>("f:label").first;
  r.input.add_property_map<Mesh::Edge_index, bool>("e:flag", true);
  const auto field = r.input.add_property_map<Mesh::Vertex_index, Point>("v:field").first;
  r.input.add_property_map<Mesh::Vertex_index, std::vector<int> >("v:lists");
  typedef CGAL::Kernel_traits<Point>::Kernel::Vector_3 Vector;
  const auto normal = r.input.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  const auto velocity = r.input.add_property_map<Mesh::Vertex_index, Vector>("v:velocity").first;
  for (const auto v : r.input.vertices()) {
    normal[v] = PMP::compute_vertex_normal(v, r.input);
    velocity[v] = Vector(0, 0, 3);
    color[v] = Color(10, 200, 30, 255);
    quality[v] = 0.5f;
    field[v] = r.input.point(v);
  }
  for (const auto f : r.input.faces())
    label[f] = 42;
  Mesh coarse;
  SMC::coarsen_mesh(r.input, 40, coarse);
  BOOST_CHECK_THROW(SMC::transfer_properties(r.input, r.cluster, coarse, {{"e:flag", SMC::Transfer_policy::CONSERVATIVE}}),
                    SMC::Invalid_input);
  BOOST_CHECK(coarse.properties<Mesh::Edge_index>() == Mesh().properties<Mesh::Edge_index>());
  BOOST_CHECK(coarse.properties<Mesh::Vertex_index>() == Mesh().properties<Mesh::Vertex_index>());
  const std::vector<std::string> left =
    SMC::transfer_properties(r.input, r.cluster, coarse, {{"v:quality", SMC::Transfer_policy::CONSERVATIVE}});
  BOOST_CHECK(left == std::vector<std::string>{"v:lists"});
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const char* name : {"v:color", "v:quality", "v:field", "v:cluster"})
    BOOST_CHECK(has(coarse.properties<Mesh::Vertex_index>(), name));
  const auto new_color = coarse.add_property_map<Mesh::Vertex_index, Color>("v:color").first;
  const auto new_field = coarse.add_property_map<Mesh::Vertex_index, Point>("v:field").first;
  const auto new_label = coarse.add_property_map<Mesh::Face_index, int>("f:label").first;
  const auto new_flag = coarse.add_property_map<Mesh::Edge_index, bool>("e:flag").first;
  for (const auto v : coarse.vertices()) {
    BOOST_CHECK(new_color[v] == Color(10, 200, 30, 255));
    BOOST_CHECK_SMALL(std::sqrt(CGAL::squared_distance(new_field[v], coarse.point(v))) -
                        distance_by_brute_force(r.input, coarse.point(v)), 1e-7);
  }
  const auto new_normal = coarse.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  const auto new_velocity = coarse.add_property_map<Mesh::Vertex_index, Vector>("v:velocity").first;
  for (const auto v : coarse.vertices()) {
    BOOST_CHECK_CLOSE(new_normal[v].squared_length(), 1., 1e-9); // unit vectors stay unit vectors
    BOOST_CHECK_CLOSE(new_velocity[v].z(), 3., 1e-9);
  }
  // The clusters are of the input alone.
  for (const std::string& name : r.input.properties<Mesh::Face_index>())
    BOOST_CHECK_EQUAL(has(coarse.properties<Mesh::Face_index>(), name), name != "f:cluster");
  for (const auto f : coarse.faces())
    BOOST_CHECK_EQUAL(new_label[f], 42);
  for (const auto e : coarse.edges())
    BOOST_CHECK(new_flag[e]);
}

// A mesh may be replaced by its result.
BOOST_AUTO_TEST_CASE(output_is_the_input)
{
  typedef CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel> Polyhedron;
  const generated::Soup torus = generated::with_noise(generated::torus(24, 16), 0.05);
  Mesh mesh = test::to_mesh(torus), expected;
  Polyhedron polyhedron;
  test::to_face_graph(torus, polyhedron);
  std::vector<int> labels(mesh.number_of_faces(), -1), expected_labels(labels);
  const auto map_to = [](std::vector<int>& of_faces) {
    return boost::make_function_property_map<Mesh::Face_index>([&](Mesh::Face_index f) -> int& { return of_faces[f]; });
  };
  SMC::coarsen_mesh(mesh, 40, expected, SMC::parameters::face_cluster_map(map_to(expected_labels)));
  const auto source = mesh.add_property_map<Mesh::Vertex_index, Location>("v:source").first;
  BOOST_CHECK_THROW(
    SMC::coarsen_mesh(mesh, 40, mesh, SMC::parameters::default_values(), SMC::parameters::vertex_source_map(source)),
    SMC::Invalid_input);
  BOOST_CHECK_THROW(SMC::coarsen_mesh(mesh, 1000000, mesh), SMC::Unreachable_number_of_vertices);
  BOOST_CHECK_EQUAL(mesh.number_of_faces(), labels.size());
  SMC::coarsen_mesh(mesh, 40, mesh, SMC::parameters::face_cluster_map(map_to(labels)));
  SMC::coarsen_mesh(polyhedron, 40, polyhedron);
  BOOST_CHECK(labels == expected_labels);
  BOOST_REQUIRE_EQUAL(mesh.number_of_vertices(), 40u);
  BOOST_REQUIRE_EQUAL(mesh.number_of_faces(), expected.number_of_faces());
  BOOST_CHECK_EQUAL(polyhedron.size_of_vertices(), 40u);
  BOOST_CHECK_EQUAL(polyhedron.size_of_facets(), expected.number_of_faces());
  for (const auto v : mesh.vertices())
    BOOST_CHECK(mesh.point(v) == expected.point(v));
  for (const auto f : mesh.faces())
    for (const auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
      BOOST_CHECK(mesh.target(h) == expected.target(h));
  Mesh fine = test::to_mesh(torus);
  const SMC::Distance_report report = SMC::coarsen_mesh_to_distance(fine, 0.3, fine);
  BOOST_CHECK_EQUAL(fine.number_of_vertices(), report.vertices);
  BOOST_CHECK_LT(report.vertices, 384u);
}

BOOST_AUTO_TEST_CASE(other_face_graphs_and_wrong_arguments)
{
  typedef CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel> Polyhedron;
  const Result r(generated::with_noise(generated::torus(24, 16), 0.05), 30);
  Polyhedron input, output;
  test::to_face_graph(generated::with_noise(generated::torus(24, 16), 0.05), input);
  typedef boost::graph_traits<Polyhedron> Traits;
  std::map<Traits::vertex_descriptor, SMC::Surface_location<Polyhedron> > sources;
  std::map<Traits::face_descriptor, std::size_t> clusters;
  std::map<Traits::vertex_descriptor, std::size_t> vertex_clusters;
  SMC::coarsen_mesh(input, 30, output,
                    SMC::parameters::cluster_weight(SMC::Maximum_density_weight())
                      .maximum_density(50.)
                      .vertex_placement(SMC::Centroid_placement())
                      .face_cluster_map(boost::make_assoc_property_map(clusters))
                      .vertex_to_cluster_map(boost::make_assoc_property_map(vertex_clusters)),
                    SMC::parameters::vertex_source_map(boost::make_assoc_property_map(sources)));
  BOOST_CHECK_EQUAL(sources.size(), 30u);
  std::size_t i = 0;
  for (const auto v : vertices(output)) {
    const Location& other = r.source[Mesh::Vertex_index(Mesh::size_type(i++))];
    BOOST_CHECK_EQUAL(sources.at(v).coordinates.size(), other.coordinates.size());
    BOOST_CHECK_EQUAL(std::distance(input.facets_begin(), Polyhedron::Facet_handle(sources.at(v).face)),
                      std::ptrdiff_t(std::size_t(other.face)));
  }
  std::map<Traits::vertex_descriptor, double> from, to;
  for (const auto v : vertices(input))
    from[v] = 4;
  SMC::Property_resampler<Polyhedron, Polyhedron> transfer(input, boost::make_assoc_property_map(clusters), output);
  transfer.transfer_vertex_property(boost::make_assoc_property_map(from), boost::make_assoc_property_map(to));
  for (const auto v : vertices(output))
    BOOST_CHECK_CLOSE(to.at(v), 4, 1e-10);
  Mesh empty;
  typedef SMC::Property_resampler<Mesh, Mesh> Transfer;
  BOOST_CHECK_THROW(Transfer(r.input, r.cluster, empty), SMC::Invalid_input);
  BOOST_CHECK_THROW(Transfer(r.input, r.cluster, r.input), SMC::Invalid_input); // faces of four sides
}

BOOST_AUTO_TEST_SUITE_END()
