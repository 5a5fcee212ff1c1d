// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tool's transfer of properties other than points and polygons, and its results for a distance and for levels.

#define BOOST_TEST_MODULE tool_properties
#include "io/read_soup.h"
#include "support/Tool_process.h"
#include "support/mesh_files.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <iostream>
#include <set>
#include <sstream>
#include <string>

namespace {

using coarsening_support::parse_soup;
using coarsening_support::Soup;
using test::Tool_directory;
using test::Tool_outcome;

boost::test_tools::assertion_result has_tool(boost::unit_test::test_unit_id)
{
  if (std::getenv("COARSEN_MESH"))
    return true;
  std::cout << "Skipped: the environment variable COARSEN_MESH does not name the tool" << std::endl;
  return false;
}

void check_done(const Tool_outcome& outcome) { BOOST_TEST(outcome.status == 0, outcome.err); }

// A square of 20 x 20 faces with a color that is x, a number that is y, and a label for each half.
std::string colored_ply()
{
  const generated::Soup soup = generated::grid(20, 20);
  std::ostringstream os;
  os << "ply\nformat ascii 1.0\nelement vertex " << soup.points.size()
     << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty float quality\nelement face "
     << soup.polygons.size() << "\nproperty list uchar int vertex_indices\nproperty int label\nend_header\n";
  for (const auto& p : soup.points)
    os << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << int(10 * p[0]) << ' ' << p[1] / 20 << '\n';
  for (const auto& p : soup.polygons)
    os << "4 " << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << p[3] << ' ' << (soup.points[p[0]][0] < 10 ? -7 : 3) << '\n';
  return os.str();
}

std::string textured_obj()
{
  const generated::Soup soup = generated::grid(20, 20);
  std::ostringstream os;
  os << "mtllib stones.mtl\n";
  for (const auto& p : soup.points)
    os << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << "\nvt " << p[0] / 20 << ' ' << p[1] / 20 << '\n';
  std::string last;
  for (const auto& p : soup.polygons) {
    const std::string name = soup.points[p[0]][0] < 10 ? "granite" : "marble";
    if (name != last)
      os << "g part_of_" << name << "\nusemtl " << name << '\n';
    last = name;
    os << 'f';
    for (const std::size_t v : p)
      os << ' ' << v + 1 << '/' << v + 1;
    os << '\n';
  }
  return os.str();
}

} // namespace

BOOST_AUTO_TEST_SUITE(tool, *boost::unit_test::precondition(has_tool))

BOOST_AUTO_TEST_CASE(ply_files_keep_their_numbers)
{
  const Tool_directory shop;
  shop.write("in.ply", colored_ply());
  check_done(shop.run("in.ply out.ply -n 40"));
  const Soup soup = parse_soup(test::content_of(shop / "out.ply"), "ply");
  BOOST_REQUIRE_EQUAL(soup.points.size(), 40u);
  BOOST_REQUIRE_EQUAL(soup.of_points.size(), 2u);
  BOOST_REQUIRE_EQUAL(soup.of_polygons.size(), 1u);
  BOOST_CHECK_EQUAL(soup.of_points[0].name, "red");
  BOOST_CHECK(soup.of_points[0].type == coarsening_support::Number_type::UINT8);
  BOOST_CHECK_EQUAL(soup.of_points[1].name, "quality");
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    BOOST_CHECK_SMALL(soup.of_points[0].values[v] - 10 * soup.points[v].x(), 0.51);
    BOOST_CHECK_SMALL(soup.of_points[1].values[v] - soup.points[v].y() / 20, 1e-5);
  }
  const std::set<double> labels(soup.of_polygons[0].values.begin(), soup.of_polygons[0].values.end());
  BOOST_CHECK(labels == (std::set<double>{-7, 3}));
  check_done(shop.run("in.ply repaired.ply -n 40 --repair"));
  BOOST_CHECK(parse_soup(test::content_of(shop / "repaired.ply"), "ply").of_points.empty());
}

BOOST_AUTO_TEST_CASE(obj_files_keep_textures_and_materials)
{
  const Tool_directory shop;
  shop.write("in.obj", textured_obj());
  check_done(shop.run("in.obj out.obj -n 40"));
  const Soup soup = parse_soup(test::content_of(shop / "out.obj"), "obj");
  BOOST_REQUIRE_EQUAL(soup.points.size(), 40u);
  BOOST_CHECK_EQUAL(soup.material_library, "stones.mtl");
  BOOST_REQUIRE_EQUAL(soup.texture_corners.size(), soup.polygons.size());
  BOOST_REQUIRE_EQUAL(soup.materials.size(), soup.polygons.size());
  BOOST_REQUIRE_EQUAL(soup.groups.size(), soup.polygons.size());
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    BOOST_CHECK_EQUAL(soup.groups[f], "part_of_" + soup.materials[f]);
    BOOST_REQUIRE_EQUAL(soup.texture_corners[f].size(), 3u);
    for (int i = 0; i < 3; ++i) {
      const auto& texture = soup.texture_points[soup.texture_corners[f][i]];
      BOOST_CHECK_SMALL(texture[0] - soup.points[soup.polygons[f][i]].x() / 20, 1e-9);
      BOOST_CHECK_SMALL(texture[1] - soup.points[soup.polygons[f][i]].y() / 20, 1e-9);
    }
  }
  BOOST_CHECK((std::set<std::string>(soup.materials.begin(), soup.materials.end()) ==
               std::set<std::string>{"granite", "marble"}));
}

BOOST_AUTO_TEST_CASE(levels_are_written_beside_the_result)
{
  const Tool_directory shop;
  shop.write("in.off", mesh_files::off(generated::triangle_sphere(4)));
  check_done(shop.run("in.off out.off -n 200 --levels 3"));
  std::size_t vertices = 200;
  for (const char* file : {"out.off", "out.1.off", "out.2.off", "out.3.off"}) {
    BOOST_CHECK_EQUAL(parse_soup(test::content_of(shop / file), "off").points.size(), vertices);
    vertices /= 2;
  }
  BOOST_CHECK_EQUAL(shop.run("in.off out.off -n 200 --levels 99").status, 2);
  BOOST_CHECK_EQUAL(shop.run("out.1.off out.off -n 20 --levels 1").status, 2); // would be overwritten
}

BOOST_AUTO_TEST_CASE(distances_take_the_place_of_numbers)
{
  const Tool_directory shop;
  shop.write("in.off", mesh_files::off(generated::triangle_sphere(4)));
  check_done(shop.run("in.off coarse.off --maximum-distance-absolute 0.1 --placement centroid"));
  check_done(shop.run("in.off fine.off --maximum-distance 0.01 --placement centroid"));
  const std::size_t coarse = parse_soup(test::content_of(shop / "coarse.off"), "off").points.size();
  BOOST_CHECK_LT(coarse, 200u);
  BOOST_CHECK_LT(coarse, parse_soup(test::content_of(shop / "fine.off"), "off").points.size());
  for (const char* wrong : {"--maximum-distance 0", "--maximum-distance -1", "--maximum-distance x",
                            "--maximum-distance 0.1 -n 20", "--maximum-distance 0.1 --maximum-distance-absolute 1",
                            "--maximum-distance 0.1 --levels 2"})
    BOOST_CHECK_EQUAL(shop.run(std::string("in.off out.off ") + wrong).status, 2);
  const Tool_outcome outcome = shop.run("in.off out.off --maximum-distance-absolute 1e-9");
  BOOST_CHECK_EQUAL(outcome.status, 1);
  BOOST_CHECK(outcome.names("within a distance of 1e-09"));
  // Relative distances are reported as relative.
  BOOST_CHECK(shop.run("in.off out.off --maximum-distance 1e-9").names("no result within 1e-09 of the diagonal"));
  BOOST_CHECK(shop.run("in.off out.off --maximum-distance 0.02").out.find(" of the diagonal, ") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
