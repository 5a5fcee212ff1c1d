// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tool's transfer of properties other than points and polygons, and its results for a distance and for levels.

#include "io/read_soup.h"
#include "support/Tool_process.h"
#include "support/mesh_files.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_tool_properties)

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

typedef std::array<double, 3> Place;

// The edges of one face only whose ends are at `x`, as pairs of places.
std::set<std::pair<Place, Place> > border_edges_at(double x, const Soup& soup)
{
  std::map<std::pair<Place, Place>, int> faces;
  for (const auto& polygon : soup.polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto &a = soup.points[polygon[i]], &b = soup.points[polygon[(i + 1) % polygon.size()]];
      if (a.x() == x && b.x() == x)
        ++faces[std::minmax(Place{a.x(), a.y(), a.z()}, Place{b.x(), b.y(), b.z()})];
    }
  std::set<std::pair<Place, Place> > result;
  for (const auto& edge : faces)
    if (edge.second == 1)
      result.insert(edge.first);
  return result;
}

// A part of a hilly surface that begins at `x`.
std::string tile(double x)
{
  generated::Soup soup = generated::grid(20, 20);
  for (auto& p : soup.points) {
    p[0] += x;
    p[2] = 2 * std::sin(0.5 * p[1]) * std::cos(0.3 * p[0]);
  }
  return mesh_files::off(soup);
}

// A square of 10 x 10 faces whose vertices with x = 5, or faces beside them, are marked.
std::string marked_ply(bool faces)
{
  const generated::Soup soup = generated::grid(10, 10);
  std::ostringstream os;
  os << "ply\nformat ascii 1.0\nelement vertex " << soup.points.size()
     << "\nproperty float x\nproperty float y\nproperty float z\n"
     << (faces ? "" : "property uchar mark\n") << "element face " << soup.polygons.size()
     << "\nproperty list uchar int vertex_indices\n"
     << (faces ? "property uchar mark\n" : "") << "end_header\n";
  for (const auto& p : soup.points)
    os << p[0] << ' ' << p[1] << ' ' << p[2] << (faces ? "" : p[0] == 5 ? " 1" : " 0") << '\n';
  for (const auto& p : soup.polygons)
    os << "4 " << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << p[3]
       << (!faces                      ? ""
           : soup.points[p[0]][0] == 5 ? " 1"
                                       : " 0")
       << '\n';
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

// A sphere whose faces are labelled by the nearest of some points; points that are far apart have the same label.
std::string parcels_ply()
{
  const generated::Soup soup = generated::triangle_sphere(5);
  constexpr std::size_t parcels = 36, labels = 18;
  std::ostringstream os;
  os << "ply\nformat ascii 1.0\nelement vertex " << soup.points.size()
     << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << soup.polygons.size()
     << "\nproperty list uchar int vertex_indices\nproperty int label\nend_header\n";
  for (const auto& p : soup.points)
    os << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const auto& polygon : soup.polygons) {
    std::size_t nearest = 0;
    double largest = -2;
    for (std::size_t i = 0; i < parcels; ++i) {
      const double z = 1 - (2 * double(i) + 1) / parcels, r = std::sqrt(1 - z * z), angle = 2.4 * double(i);
      double product = 0;
      for (const std::size_t v : polygon)
        product += r * std::cos(angle) * soup.points[v][0] + r * std::sin(angle) * soup.points[v][1] + z * soup.points[v][2];
      if (product > largest) {
        largest = product;
        nearest = i;
      }
    }
    os << "3 " << polygon[0] << ' ' << polygon[1] << ' ' << polygon[2] << ' ' << nearest % labels << '\n';
  }
  return os.str();
}

// Returns the number of regions of adjacent faces with the same value of the first field of faces.
std::size_t number_of_regions(const Soup& soup)
{
  const auto& label = soup.of_polygons.at(0).values;
  std::vector<std::size_t> parent(soup.polygons.size());
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  const auto root = [&](std::size_t f) {
    while (parent[f] != f)
      f = parent[f] = parent[parent[f]];
    return f;
  };
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> face_at;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f)
    for (std::size_t i = 0; i < soup.polygons[f].size(); ++i) {
      const std::size_t a = soup.polygons[f][i], b = soup.polygons[f][(i + 1) % soup.polygons[f].size()];
      const auto other = face_at.emplace(std::minmax(a, b), f).first->second;
      if (label[other] == label[f])
        parent[root(f)] = root(other);
    }
  std::size_t regions = 0;
  for (std::size_t f = 0; f < parent.size(); ++f)
    regions += parent[f] == f;
  return regions;
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
}

BOOST_AUTO_TEST_CASE(repair_and_hole_filling_keep_fields)
{
  const Tool_directory shop;
  shop.write("in.ply", colored_ply());
  check_done(shop.run("in.ply out.ply -n 40"));
  check_done(shop.run("in.ply repaired.ply -n 40 --repair"));
  BOOST_CHECK(test::content_of(shop / "repaired.ply") == test::content_of(shop / "out.ply"));
  shop.write("in.obj", textured_obj());
  check_done(shop.run("in.obj out.obj -n 40"));
  check_done(shop.run("in.obj repaired.obj -n 40 --repair"));
  BOOST_CHECK(test::content_of(shop / "repaired.obj") == test::content_of(shop / "out.obj"));

  // An open box whose faces have the label 5: so has the lid that fills its hole.
  const generated::Soup box = generated::cube_grid(6);
  std::ostringstream os;
  std::size_t faces = 0;
  std::ostringstream list;
  for (const auto& p : box.polygons) {
    double low = 10;
    for (const std::size_t v : p)
      low = (std::min)(low, box.points[v][2]);
    const bool is_lid = low == (*std::max_element(box.points.begin(), box.points.end(), [](const auto& a, const auto& b) {
      return a[2] < b[2];
    }))[2];
    if (is_lid)
      continue;
    list << p.size();
    for (const std::size_t v : p)
      list << ' ' << v;
    list << " 5 0 0 255\n";
    ++faces;
  }
  os << "ply\nformat ascii 1.0\ncomment TextureFile stone.png\nelement vertex " << box.points.size()
     << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << faces
     << "\nproperty list uchar int vertex_indices\nproperty short label\nproperty uchar red\nproperty uchar green\nproperty "
        "uchar blue\nend_header\n";
  for (const auto& p : box.points)
    os << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  shop.write("box.ply", os.str() + list.str());
  check_done(shop.run("box.ply lid.ply -n 60 --fill-holes all"));
  const Soup lid = parse_soup(test::content_of(shop / "lid.ply"), "ply");
  BOOST_CHECK(lid.notes.comments == std::vector<std::string>{"TextureFile stone.png"});
  BOOST_REQUIRE_EQUAL(lid.of_polygons.size(), 4u);
  BOOST_CHECK_EQUAL(lid.polygons.size(), 116u); // closed
  for (std::size_t f = 0; f < lid.polygons.size(); ++f) {
    BOOST_CHECK_EQUAL(lid.of_polygons[0].values[f], 5);
    BOOST_CHECK_EQUAL(lid.of_polygons[3].values[f], 255);
  }
}

// A torus with normals and colors of vertices, which go through all formats that have them.
BOOST_AUTO_TEST_CASE(fields_go_from_format_to_format)
{
  const Tool_directory shop;
  const generated::Soup torus = generated::torus(24, 16);
  std::ostringstream os;
  os << "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex " << torus.points.size()
     << "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float "
        "nz\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face "
     << torus.polygons.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& p : torus.points) {
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    os << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << p[0] / length << ' ' << p[1] / length << ' ' << p[2] / length
       << " 200 100 50\n";
  }
  for (const auto& p : torus.polygons) {
    os << p.size();
    for (const std::size_t v : p)
      os << ' ' << v;
    os << '\n';
  }
  shop.write("0.ply", os.str());
  const char* const steps[] = {"0.ply 1.off -n 100", "1.off 2.obj -n 80", "2.obj 3.ply -n 60", "3.ply 4.obj -n 50"};
  for (const std::string step : steps) {
    const Tool_outcome outcome = shop.run(step);
    check_done(outcome);
    BOOST_CHECK_EQUAL(outcome.err, ""); // nothing is lost
    const std::string file = step.substr(6, 5);
    const Soup soup = parse_soup(test::content_of(shop / file), file.substr(2));
    BOOST_REQUIRE_GE(soup.of_points.size(), 6u);
    std::map<std::string, std::vector<double> > values;
    for (const auto& property : soup.of_points)
      values[property.name] = property.values;
    for (std::size_t v = 0; v < soup.points.size(); ++v) {
      BOOST_CHECK_SMALL(std::hypot(values["nx"][v], values["ny"][v], values["nz"][v]) - 1, 1e-6);
      BOOST_CHECK_EQUAL(values["red"][v], 200);
      BOOST_CHECK_EQUAL(values["green"][v], 100);
      BOOST_CHECK_EQUAL(values["blue"][v], 50);
    }
  }
  BOOST_CHECK(test::content_of(shop / "1.off").find("# made by hand") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(what_a_format_cannot_hold_is_named_once)
{
  const Tool_directory shop;
  shop.write("in.ply", colored_ply());
  const Tool_outcome outcome = shop.run("in.ply out.off -n 40 --levels 1 --report report.json");
  check_done(outcome);
  BOOST_CHECK_EQUAL(
    outcome.err, "coarsen_mesh: warning: out.off: the numbers 'red' of vertices are left out, the format OFF cannot hold them\n"
                 "coarsen_mesh: warning: out.off: the numbers 'quality' of vertices are left out, the format OFF cannot hold "
                 "them\n"
                 "coarsen_mesh: warning: out.off: the numbers 'label' of faces are left out, the format OFF cannot hold them\n");
  BOOST_CHECK(test::content_of(shop / "report.json").find("'quality'") != std::string::npos);
  BOOST_CHECK_EQUAL(shop.run("in.ply out.off -n 40 --quiet").err, "");
  BOOST_CHECK_EQUAL(shop.run("in.ply out.ply -n 40").err, "");
  shop.write("in.obj", textured_obj() + "s 1\nl 1 2\n");
  const Tool_outcome lines = shop.run("in.obj out.stl -n 40");
  check_done(lines);
  for (const char* field :
       {"smoothing groups are not read", "lines are not read", "the texture coordinates of corners are left out",
        "the materials of faces are left out", "the groups of faces are left out"})
    BOOST_CHECK_MESSAGE(lines.err.find(field) != std::string::npos, lines.err);
}

// Colors and normals behind the coordinates of OFF, in its order; normals of OBJ that differ at a vertex stay with the corners.
BOOST_AUTO_TEST_CASE(fields_of_text)
{
  const Soup off =
    parse_soup("CNOFF\n3 1 0\n0 0 0 0 0 1 0.2 0.4 1 1\n1 0 0 0 0 1 0 0 1 1\n0 1 0 0 0 1 0 0 1 1\n3 0 1 2 255 0 9\n", "off");
  BOOST_REQUIRE_EQUAL(off.of_points.size(), 6u); // opaque
  BOOST_CHECK_EQUAL(off.of_points[2].name, "nz");
  BOOST_CHECK_EQUAL(off.of_points[2].values[1], 1);
  BOOST_CHECK_EQUAL(off.of_points[3].name, "red");
  BOOST_CHECK_EQUAL(off.of_points[3].values[0], 51);
  BOOST_CHECK_EQUAL(off.of_points[4].values[0], 102);
  BOOST_CHECK_EQUAL(off.of_points[5].values[2], 255);
  BOOST_REQUIRE_EQUAL(off.of_polygons.size(), 3u);
  BOOST_CHECK_EQUAL(off.of_polygons[0].values[0], 255);
  BOOST_CHECK_EQUAL(off.of_polygons[2].values[0], 9);
  BOOST_CHECK(off.left_out.empty());
  BOOST_CHECK_EQUAL(parse_soup("OFF\n3 1 0\n0 0 0 7\n1 0 0 x\n0 1 0\n3 0 1 2\n", "off").left_out.size(), 1u);

  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvn 0 1 0\n";
  const Soup smooth = parse_soup(points + "f 1//1 2//1 3//1\nf 1//1 3//1 4//2\n", "obj");
  BOOST_REQUIRE_EQUAL(smooth.of_points.size(), 3u);
  BOOST_CHECK(smooth.of_points[1].values == (std::vector<double>{0, 0, 0, 1}));
  BOOST_CHECK(smooth.normal_corners.empty());
  const Soup creased = parse_soup(points + "f 1//1 2//1 3//1\nf 1//2 3//2 4//2\n", "obj");
  BOOST_CHECK(creased.of_points.empty());
  BOOST_CHECK_EQUAL(creased.normal_corners.size(), 2u);
}

// Comments at the head of a file describe the file, and those below the first vertex describe elements that do not return.
BOOST_AUTO_TEST_CASE(comments_of_text)
{
  const std::vector<std::string> comments = {"made by hand", "TextureFile stone.png"};
  const std::string head = "####\n# made by hand\n  #TextureFile stone.png #\n";
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  const Soup off = parse_soup("OFF\n" + head + "3 1 0\n" + vertices + "3 0 1 2\n", "off");
  BOOST_CHECK(off.notes.comments == comments);
  BOOST_CHECK(off.left_out.empty());
  const Soup obj = parse_soup(head + "g part#1\nv 0 0 0\nv 1 0 0\nv 0 1 0\ng part#2\nf 1 2 3\n", "obj");
  BOOST_CHECK(obj.notes.comments == comments);
  BOOST_CHECK(obj.left_out.empty());
  for (const Soup& soup : {parse_soup("OFF\n3 1 0\n" + vertices + "# face\n3 0 1 2\n", "off"),
                           parse_soup("v 0 0 0\nv 1 0 0 # second\nv 0 1 0\nf 1 2 3\n", "obj")}) {
    BOOST_CHECK(soup.notes.comments.empty());
    BOOST_CHECK(soup.left_out == std::vector<std::string>{"comments below the first vertex"});
  }

  const Tool_directory shop;
  shop.write("in.obj", head + textured_obj() + "# the end\n");
  const Tool_outcome outcome = shop.run("in.obj out.ply -n 40");
  check_done(outcome);
  BOOST_CHECK(outcome.names("warning: in.obj: comments below the first vertex are not read"));
  BOOST_CHECK(parse_soup(test::content_of(shop / "out.ply"), "ply").notes.comments == comments);
  check_done(shop.run("out.ply out.obj -n 30"));
  BOOST_CHECK(parse_soup(test::content_of(shop / "out.obj"), "obj").notes.comments == comments);
  BOOST_CHECK(shop.run("in.obj out.stl -n 40").names("warning: out.stl: the comments are left out"));
}

BOOST_AUTO_TEST_CASE(names_of_obj)
{
  const Tool_directory shop;
  shop.write("in.obj", "mtllib a.mtl b.mtl\nmtllib c.mtl\ng left half\nusemtl old  stone # of the wall\nv 0 0 0\nv 1 0 0\n"
                       "v 1 1 0\nv 0 1 0\nvt 0 0 .5\nf 1 2 3\nusemtl old wood\nf 1 3 4\n");
  const Tool_outcome outcome = shop.run("in.obj out.obj -n 4 --patches material");
  check_done(outcome);
  BOOST_CHECK(outcome.names("third coordinates of textures are not read"));
  const Soup soup = parse_soup(test::content_of(shop / "out.obj"), "obj");
  BOOST_CHECK(soup.notes.material_libraries == (std::vector<std::string>{"a.mtl b.mtl", "c.mtl"}));
  BOOST_CHECK(soup.groups == std::vector<std::string>(2, "left half"));
  BOOST_CHECK((std::set<std::string>(soup.materials.begin(), soup.materials.end()) ==
               std::set<std::string>{"old stone", "old wood"}));
}

// The solids of a text STL are groups, and their borders are kept on request.
BOOST_AUTO_TEST_CASE(solids_of_stl)
{
  const generated::Soup soup = generated::grid(20, 20);
  std::ostringstream os;
  for (const bool is_left : {true, false}) {
    os << "solid " << (is_left ? "left part #1" : "right") << '\n';
    for (const auto& p : soup.polygons)
      for (std::size_t i = 2; i < p.size(); ++i)
        if ((soup.points[p[0]][0] < 10) == is_left) {
          os << "facet normal 0 0 1\nouter loop\n";
          for (const std::size_t v : {p[0], p[i - 1], p[i]})
            os << "vertex " << soup.points[v][0] << ' ' << soup.points[v][1] << ' ' << soup.points[v][2] << '\n';
          os << "endloop\nendfacet\n";
        }
    os << "endsolid\n";
  }
  const Tool_directory shop;
  shop.write("in.stl", os.str());
  const Tool_outcome outcome = shop.run("in.stl out.obj -n 40 --patches solid");
  check_done(outcome);
  BOOST_CHECK_EQUAL(outcome.err, "");
  const Soup result = parse_soup(test::content_of(shop / "out.obj"), "obj");
  BOOST_REQUIRE_EQUAL(result.groups.size(), result.polygons.size());
  for (std::size_t f = 0; f < result.polygons.size(); ++f)
    for (const std::size_t v : result.polygons[f])
      BOOST_CHECK_GE((result.points[v].x() - 10) * (result.groups[f] == "left part _1" ? -1 : 1), -0.05);
  BOOST_CHECK(shop.run("in.stl out.ply -n 40").names("the groups of faces are left out"));
  shop.write("plain.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n");
  BOOST_CHECK(parse_soup(test::content_of(shop / "plain.stl"), "stl").groups.empty());
  BOOST_CHECK(shop.run("plain.stl out.obj -n 3 --patches solid").names("has no solids of faces"));
}

BOOST_AUTO_TEST_CASE(objects_of_obj)
{
  const Tool_directory shop;
  std::string text = textured_obj();
  for (std::size_t at = text.find("g part"); at != std::string::npos; at = text.find("g part", at + 1))
    text.replace(at, 1, "o");
  shop.write("in.obj", text);
  check_done(shop.run("in.obj out.obj -n 40 --patches object --repair"));
  const Soup soup = parse_soup(test::content_of(shop / "out.obj"), "obj");
  BOOST_CHECK(std::set<std::string>(soup.objects.begin(), soup.objects.end()) ==
              (std::set<std::string>{"part_of_granite", "part_of_marble"}));
  BOOST_CHECK(soup.groups.empty());
  BOOST_CHECK(shop.run("in.obj out.off -n 40").names("the names of objects are left out, the format OFF cannot hold them"));
}

BOOST_AUTO_TEST_CASE(losses_of_reading_are_named)
{
  const std::string faces = "v 1 0 0 0 0 0\nv 0 1 0 1 1 1\nf 1 2 3\n";
  const std::vector<std::string> loss = {"the digits of colors beyond 8 bits"};
  BOOST_CHECK(parse_soup("v 0 0 0 0.2 0.502 0\n" + faces, "obj").left_out.empty());
  BOOST_CHECK(parse_soup("v 0 0 0 0.0019 0 0\n" + faces, "obj").left_out == loss);
  std::string stl = mesh_files::binary_stl(generated::octahedron());
  BOOST_CHECK(parse_soup(stl, "stl").left_out.empty());
  stl[84 + 48] = '\x1f';
  stl[84 + 49] = '\x80';
  BOOST_CHECK(parse_soup(stl, "stl").left_out == std::vector<std::string>{"the attributes of triangles (often colors)"});
}

// Two strips of a square of four triangles around its middle, one with a vertex that is repeated.
BOOST_AUTO_TEST_CASE(strips_of_triangles)
{
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
                             "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                             "0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 .5 0\n";
  const Soup soup = parse_soup(header + "9 0 1 4 2 -1 2 3 4 0\n", "ply");
  BOOST_REQUIRE_EQUAL(soup.polygons.size(), 4u);
  const std::vector<std::vector<std::size_t> > expected = {{0, 1, 4}, {4, 1, 2}, {2, 3, 4}, {4, 3, 0}};
  BOOST_CHECK(soup.polygons.lists() == expected);
  const Soup turned = parse_soup(header + "5 0 1 4 4 3\n", "ply");
  BOOST_CHECK(turned.polygons.lists() == (std::vector<std::vector<std::size_t> >{{0, 1, 4}}));
  BOOST_CHECK_THROW(parse_soup(header + "9 0 1 4 2\n", "ply"), coarsening_support::Format_fault);
}

BOOST_AUTO_TEST_CASE(distances_become_numbers_of_vertices)
{
  const Tool_directory shop;
  shop.write("sphere.off", mesh_files::off(generated::triangle_sphere(4)));
  const Tool_outcome outcome = shop.run("sphere.off out.ply -n 40 --distances --measure --report report.json");
  check_done(outcome);
  const Soup soup = parse_soup(test::content_of(shop / "out.ply"), "ply");
  BOOST_REQUIRE_EQUAL(soup.of_points.size(), 1u);
  BOOST_CHECK_EQUAL(soup.of_points[0].name, "distance");
  const auto& distances = soup.of_points[0].values;
  const auto range = std::minmax_element(distances.begin(), distances.end());
  BOOST_CHECK_GT(*range.first, 0.001); // of a sphere of radius 1 and clusters of a radius of about 0.3
  BOOST_CHECK_LT(*range.second, 0.1);
  check_done(shop.run("out.ply again.ply -n 20 --distances")); // the numbers are not carried over
  const Soup again = parse_soup(test::content_of(shop / "again.ply"), "ply");
  BOOST_REQUIRE_EQUAL(again.of_points.size(), 1u);
  BOOST_CHECK(shop.run("sphere.off out.off -n 40 --distances").names("the numbers 'distance' of vertices are left out"));
}

BOOST_AUTO_TEST_CASE(borders_of_materials_are_kept_on_request)
{
  const Tool_directory shop;
  shop.write("in.obj", textured_obj());
  check_done(shop.run("in.obj out.obj -n 60 --patches material"));
  const Soup soup = parse_soup(test::content_of(shop / "out.obj"), "obj");
  for (std::size_t f = 0; f < soup.polygons.size(); ++f)
    for (const std::size_t v : soup.polygons[f])
      if (soup.materials[f] == "granite")
        BOOST_CHECK_LE(soup.points[v].x(), 10.05); // of a face of side 1
      else
        BOOST_CHECK_GE(soup.points[v].x(), 9.95);
  const Tool_outcome outcome = shop.run("in.obj out.obj -n 60 --patches colour");
  BOOST_CHECK_EQUAL(outcome.status, 1);
  BOOST_CHECK(outcome.names("has no whole numbers 'colour' of faces"));
}

BOOST_AUTO_TEST_CASE(patches_are_those_of_the_input)
{
  const Tool_directory shop;
  shop.write("in.ply", parcels_ply());
  BOOST_CHECK_EQUAL(number_of_regions(parse_soup(test::content_of(shop / "in.ply"), "ply")), 36u);
  for (const char* number : {"100", "200", "400"}) {
    check_done(shop.run(std::string("in.ply out.ply --patches label -n ") + number));
    BOOST_CHECK_EQUAL(number_of_regions(parse_soup(test::content_of(shop / "out.ply"), "ply")), 36u);
  }
  const Tool_outcome outcome = shop.run("in.ply out.ply --patches label -n 20");
  BOOST_CHECK_EQUAL(outcome.status, 1);
  BOOST_CHECK(outcome.names("corners of features to keep"));
}

BOOST_AUTO_TEST_CASE(textures_go_from_obj_to_ply)
{
  const Tool_directory shop;
  shop.write("in.obj", textured_obj());
  check_done(shop.run("in.obj out.ply -n 40"));
  check_done(shop.run("in.obj out.obj -n 40"));
  check_done(shop.run("out.ply again.obj -n 20"));
  const Soup ply = parse_soup(test::content_of(shop / "out.ply"), "ply"),
             obj = parse_soup(test::content_of(shop / "out.obj"), "obj");
  BOOST_REQUIRE_EQUAL(ply.texture_corners.size(), ply.polygons.size());
  const auto ply_polygons = ply.polygons.lists(), obj_polygons = obj.polygons.lists();
  for (std::size_t f = 0; f < ply_polygons.size(); ++f) { // in another order in OBJ, grouped by material
    const auto found = std::find(obj_polygons.begin(), obj_polygons.end(), ply_polygons[f]);
    BOOST_REQUIRE(found != obj_polygons.end());
    const std::size_t g = std::size_t(found - obj_polygons.begin());
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 2; ++k)
        BOOST_CHECK_SMALL(ply.texture_points[ply.texture_corners[f][i]][k] - obj.texture_points[obj.texture_corners[g][i]][k],
                          1e-6);
  }
  BOOST_CHECK(!parse_soup(test::content_of(shop / "again.obj"), "obj").texture_points.empty());
}

// OFF has texture coordinates of vertices: it holds those of corners that agree at each vertex.
BOOST_AUTO_TEST_CASE(textures_go_from_obj_to_off)
{
  const Tool_directory shop;
  shop.write("in.obj", textured_obj());
  const Tool_outcome outcome = shop.run("in.obj out.off -n 40");
  check_done(outcome);
  BOOST_CHECK(!outcome.names("texture"));
  const Soup soup = parse_soup(test::content_of(shop / "out.off"), "off");
  BOOST_REQUIRE_EQUAL(soup.of_points.size(), 2u);
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    for (int k = 0; k < 2; ++k)
      BOOST_CHECK_SMALL(soup.of_points[k].values[v] - soup.points[v][k] / 20, 1e-9);

  // The same square with another texture on the right half.
  std::string cut = textured_obj();
  const std::size_t marble = cut.find("usemtl marble");
  cut.insert(cut.find("f ", marble), "vt 9 9\n");
  std::string right = cut.substr(marble);
  for (std::size_t at = right.find('/'); at != std::string::npos; at = right.find('/', at + 1))
    right.replace(at + 1, right.find_first_of(" \n", at) - at - 1, "-1");
  shop.write("cut.obj", cut.substr(0, marble) + right);
  BOOST_CHECK(shop.run("cut.obj out.off -n 40").names("the texture coordinates of corners are left out"));
}

BOOST_AUTO_TEST_CASE(obj_files_keep_textures_and_materials)
{
  const Tool_directory shop;
  shop.write("in.obj", textured_obj());
  const Tool_outcome outcome = shop.run("in.obj out.obj -n 40");
  check_done(outcome);
  BOOST_CHECK(outcome.names("out.obj: the lines between materials are not kept (--patches material keeps them)"));
  BOOST_CHECK(!shop.run("in.obj kept.obj -n 40 --patches material").names("--patches"));
  BOOST_CHECK(!shop.run("in.obj out.off -n 40").names("--patches"));
  // Faces are grouped by material.
  for (const std::string file : {"out.obj", "kept.obj"}) {
    const std::string text = test::content_of(shop / file);
    std::size_t runs = 0;
    for (std::size_t at = text.find("usemtl "); at != std::string::npos; at = text.find("usemtl ", at + 1))
      ++runs;
    BOOST_CHECK_EQUAL(runs, 2u);
  }
  const Soup soup = parse_soup(test::content_of(shop / "out.obj"), "obj");
  BOOST_REQUIRE_EQUAL(soup.points.size(), 40u);
  BOOST_CHECK(soup.notes.material_libraries == std::vector<std::string>{"stones.mtl"});
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
                            "--maximum-distance 0.1 -k 2", "--maximum-distance 0.1 --maximum-distance-absolute 1",
                            "--maximum-distance 0.1 --faces 20", "--faces 20 -n 20", "-n 20 --keep-small",
                            "--maximum-distance 0.1 --levels 2"})
    BOOST_CHECK_EQUAL(shop.run(std::string("in.off out.off ") + wrong).status, 2);
  // The input itself is within any distance that exceeds rounding errors.
  check_done(shop.run("in.off out.off --maximum-distance-absolute 1e-9"));
  BOOST_CHECK_EQUAL(parse_soup(test::content_of(shop / "out.off"), "off").points.size(),
                    generated::triangle_sphere(4).points.size());
  const Tool_outcome outcome = shop.run("in.off out.off --maximum-distance-absolute 1e-30");
  BOOST_CHECK_EQUAL(outcome.status, 1);
  BOOST_CHECK(outcome.names("within a distance of 1e-30"));
  BOOST_CHECK(outcome.names("--subdivide"));
  // The nearest distance can be asked for.
  for (const double size : {1., 1.11, 1.9}) {
    shop.write("small.off", mesh_files::off(generated::scaled(generated::triangle_sphere(2), size)));
    for (const std::string option : {"--maximum-distance", "--maximum-distance-absolute"}) {
      const std::string arguments = "small.off out.off --placement quadric " + option + " ", lead = "nearest distance found: ";
      const Tool_outcome refused = shop.run(arguments + "1e-30");
      BOOST_REQUIRE(refused.names(lead));
      const std::string rest = refused.err.substr(refused.err.find(lead) + lead.size());
      check_done(shop.run(arguments + rest.substr(0, rest.find_first_of(" ;)"))));
    }
  }
  // Relative distances are reported as relative.
  BOOST_CHECK(shop.run("in.off out.off --maximum-distance 1e-30").names("no result within 1e-30 of the diagonal ("));
  BOOST_CHECK(shop.run("in.off out.off --maximum-distance 0.02").out.find(" of the diagonal (") != std::string::npos);
  // A number beside the distance is the maximum.
  const Tool_outcome limited = shop.run("in.off out.off --maximum-distance 0.001 -n 20 --report r.json");
  BOOST_CHECK_EQUAL(parse_soup(test::content_of(shop / "out.off"), "off").points.size(), 20u);
  BOOST_CHECK(limited.out.find("where the number of vertices ended the search") != std::string::npos);
  BOOST_CHECK(test::content_of(shop / "r.json").find("\"is_within_distance\": false") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(numbers_of_faces)
{
  using namespace generated;
  const Tool_directory shop;
  shop.write("closed.off", mesh_files::off(triangle_sphere(4)));
  shop.write("open.off", mesh_files::off(grid(20, 20)));
  check_done(shop.run("closed.off out.off --faces 100"));
  BOOST_CHECK_EQUAL(parse_soup(test::content_of(shop / "out.off"), "off").polygons.size(), 100u);
  check_done(shop.run("closed.off out.off --faces 101"));
  BOOST_CHECK_EQUAL(parse_soup(test::content_of(shop / "out.off"), "off").polygons.size(), 102u);
  // No number of vertices gives a number of faces that is nearer.
  const auto difference = [&](const std::string& arguments) {
    check_done(shop.run("open.off out.off " + arguments));
    return std::abs(double(parse_soup(test::content_of(shop / "out.off"), "off").polygons.size()) - 60);
  };
  const double least = difference("--faces 60");
  for (int n = 30; n <= 50; ++n)
    BOOST_CHECK_LE(least, difference("-n " + std::to_string(n)));
}

BOOST_AUTO_TEST_CASE(small_components_are_kept)
{
  using namespace generated;
  const Tool_directory shop;
  generated::Soup soup = joined(triangle_sphere(4), translated(tetrahedron(), 4, 0, 0));
  soup = joined(soup, translated(single_triangle(), 8, 0, 0));
  shop.write("in.off", mesh_files::off(soup));
  BOOST_CHECK_EQUAL(shop.run("in.off out.off -n 0.2%").status, 1);
  check_done(shop.run("in.off out.off -n 2% --keep-small"));
  const auto output = parse_soup(test::content_of(shop / "out.off"), "off");
  BOOST_CHECK_EQUAL(output.points.size(), std::size_t(std::lround(0.02 * double(triangle_sphere(4).points.size()))) + 7);
  for (std::size_t v = triangle_sphere(4).points.size(); v < soup.points.size(); ++v)
    BOOST_CHECK(std::any_of(output.points.begin(), output.points.end(), [&](const auto& p) {
      return p.x() == soup.points[v][0] && p.y() == soup.points[v][1] && p.z() == soup.points[v][2];
    }));
}

// Components that are removed take their fields along, also if they are the first of the file.
BOOST_AUTO_TEST_CASE(small_components_are_removed)
{
  using namespace generated;
  const generated::Soup sphere = triangle_sphere(3);
  std::istringstream lines(
    mesh_files::obj(joined(joined(translated(scaled(tetrahedron(), 0.01), 9, 0, 0), sphere), translated(sphere, 4, 0, 0))));
  std::string text, line;
  for (std::size_t f = 0; std::getline(lines, line); text += line + '\n')
    if (line[0] == 'f') {
      text += f < 4 ? "g debris\n" : f < 4 + sphere.polygons.size() ? "g left\n" : "g right\n";
      ++f;
    }
  const Tool_directory shop;
  shop.write("in.obj", text);
  check_done(shop.run("in.obj out.obj -n 60 --minimum-component-area 0.1"));
  const auto output = parse_soup(test::content_of(shop / "out.obj"), "obj");
  BOOST_CHECK_EQUAL(output.points.size(), 60u);
  BOOST_REQUIRE_EQUAL(output.groups.size(), output.polygons.size());
  for (std::size_t f = 0; f < output.polygons.size(); ++f)
    BOOST_CHECK_EQUAL(output.groups[f], output.points[output.polygons[f][0]].x() < 2 ? "left" : "right");
}

BOOST_AUTO_TEST_CASE(neighboring_tiles_fit)
{
  const Tool_directory shop;
  shop.write("left.off", tile(0));
  shop.write("right.off", tile(20));
  for (const std::string name : {"left", "right"})
    check_done(shop.run(name + ".off " + name + "_out.off -n 130 --keep-borders"));
  const auto edges = [&](const std::string& file) {
    return border_edges_at(20, parse_soup(test::content_of(shop / file), "off"));
  };
  BOOST_CHECK_EQUAL(edges("left.off").size(), 20u);
  BOOST_CHECK(edges("left_out.off") == edges("left.off"));
  BOOST_CHECK(edges("right_out.off") == edges("left.off"));
  BOOST_CHECK_EQUAL(shop.run("left.off out.off --keep-borders -n 130 --levels 1").status, 2);
  check_done(shop.run("left.off left_out.off --keep-borders --maximum-distance 0.01"));
  BOOST_CHECK(edges("left_out.off") == edges("left.off"));
}

BOOST_AUTO_TEST_CASE(marked_vertices_are_kept)
{
  const Tool_directory shop;
  for (const bool faces : {false, true}) {
    shop.write("in.ply", marked_ply(faces));
    check_done(shop.run("in.ply out.ply -n 60 --keep mark"));
    const Soup soup = parse_soup(test::content_of(shop / "out.ply"), "ply");
    std::set<std::pair<double, double> > places;
    for (const auto& p : soup.points)
      places.emplace(p.x(), p.y());
    for (int y = 0; y <= 10; ++y)
      for (int x = 5; x <= 5 + faces; ++x)
        BOOST_CHECK(places.count({x, y}) == 1);
  }
  const Tool_outcome outcome = shop.run("in.ply out.ply -n 60 --keep seam");
  BOOST_CHECK_EQUAL(outcome.status, 1);
  BOOST_CHECK(outcome.names("has no numbers 'seam' of vertices or faces"));
  BOOST_CHECK(shop.run("--range in.ply --keep mark").out.find("22 to 121") == 0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
