// SPDX-License-Identifier: GPL-3.0-or-later
//
// Formats that the tool reads and writes through the library Assimp, where it is built with it.

#include "io/assimp_formats.h"
#include "io/read_soup.h"
#include "support/Tool_process.h"
#include "support/mesh_files.h"

#include <boost/test/unit_test.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_tool_assimp)

namespace {

using coarsening_support::assimp_reads;
using coarsening_support::assimp_writes;
using coarsening_support::Format_fault;
using coarsening_support::parse_soup;
using coarsening_support::Soup;
using coarsening_support::Soup_property;
using test::Tool_directory;
using test::Tool_outcome;

boost::test_tools::assertion_result has_tool(boost::unit_test::test_unit_id) { return std::getenv("COARSEN_MESH") != nullptr; }

boost::test_tools::assertion_result has_assimp(boost::unit_test::test_unit_id id)
{
  if (assimp_reads("glb"))
    return has_tool(id);
  std::cout << "Skipped: the tool is built without Assimp" << std::endl;
  return false;
}

boost::test_tools::assertion_result has_no_assimp(boost::unit_test::test_unit_id id)
{
  return !assimp_reads("glb") && has_tool(id);
}

// A square of two materials, each with its texture, with normals of vertices.
std::string painted_obj()
{
  const generated::Soup soup = generated::grid(20, 20);
  std::ostringstream os;
  for (const auto& p : soup.points)
    os << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << " 0.2 0.4 1\nvt " << p[0] / 20 << ' ' << p[1] / 20 << "\n";
  os << "vn 0 0 1\n";
  for (const auto& p : soup.polygons) {
    os << "usemtl " << (soup.points[p[0]][0] < 10 ? "granite" : "marble") << "\nf";
    for (const std::size_t v : p)
      os << ' ' << v + 1 << '/' << v + 1 << "/1";
    os << '\n';
  }
  return os.str();
}

const Soup_property* find(const Soup& soup, const std::string& name)
{
  for (const Soup_property& property : soup.of_points)
    if (property.name == name)
      return &property;
  return nullptr;
}

void check_texture_and_normals(const Soup& soup)
{
  BOOST_REQUIRE_EQUAL(soup.texture_corners.size(), soup.polygons.size());
  for (std::size_t f = 0; f < soup.polygons.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const auto& p = soup.points[soup.polygons[f][i]];
      const auto& t = soup.texture_points[soup.texture_corners[f][i]];
      BOOST_CHECK_SMALL(t[0] - p.x() / 20, 2e-2); // positions are fitted, texture coordinates interpolated
      BOOST_CHECK_SMALL(t[1] - p.y() / 20, 2e-2);
    }
  BOOST_REQUIRE(find(soup, "nz"));
  for (const double z : find(soup, "nz")->values)
    BOOST_CHECK_SMALL(z - 1, 1e-6);
}

} // namespace

BOOST_AUTO_TEST_SUITE(assimp, *boost::unit_test::precondition(has_assimp))

// What a format holds returns, and what it does not is named.
BOOST_AUTO_TEST_CASE(round_trips)
{
  const Tool_directory shop;
  shop.write("in.obj", painted_obj());
  for (const std::string type : {"glb", "gltf", "dae", "3mf"}) {
    if (!assimp_reads(type) || !assimp_writes(type)) {
      BOOST_TEST_MESSAGE("this Assimp does not read and write " << type);
      continue;
    }
    BOOST_TEST_CONTEXT(type)
    {
      const Tool_outcome there = shop.run("in.obj out." + type + " -n 60");
      BOOST_TEST_REQUIRE(there.status == 0, there.err);
      const Soup soup = parse_soup(test::content_of(shop / ("out." + type)), type);
      BOOST_CHECK_EQUAL(soup.points.size(), 60u);
      const auto says = [&](const char* field) { return there.names(std::string("the ") + field + " are left out"); };
      BOOST_CHECK_EQUAL(find(soup, "red") == nullptr, says("colors of vertices"));
      BOOST_CHECK_EQUAL(soup.materials.empty(), says("materials of faces"));
      BOOST_CHECK_EQUAL(find(soup, "nx") == nullptr, says("normals of vertices"));
      BOOST_CHECK_EQUAL(soup.texture_points.empty(), says("texture coordinates of corners"));
      const Tool_outcome back = shop.run("out." + type + " back.ply -n 30");
      BOOST_TEST_REQUIRE(back.status == 0, back.err);
      BOOST_CHECK_EQUAL(parse_soup(test::content_of(shop / "back.ply"), "ply").points.size(), 30u);
    }
  }
}

BOOST_AUTO_TEST_CASE(gltf_has_all)
{
  const Tool_directory shop;
  shop.write("in.obj", painted_obj());
  for (const std::string type : {"glb", "gltf"}) {
    const Tool_outcome outcome = shop.run("in.obj out." + type + " -n 60 --patches material");
    BOOST_TEST_REQUIRE(outcome.status == 0, outcome.err);
    BOOST_CHECK_EQUAL(outcome.err, "");
    const Soup soup = parse_soup(test::content_of(shop / ("out." + type)), type);
    check_texture_and_normals(soup);
    BOOST_REQUIRE_EQUAL(soup.materials.size(), soup.polygons.size());
    for (std::size_t f = 0; f < soup.polygons.size(); ++f)
      for (const std::size_t v : soup.polygons[f])
        BOOST_CHECK_GE((soup.points[v].x() - 10) * (soup.materials[f] == "granite" ? -1 : 1), -0.05);
    const double color[] = {51, 102, 255};
    const char* const names[] = {"red", "green", "blue"};
    for (int i = 0; i < 3; ++i) {
      BOOST_REQUIRE(find(soup, names[i]));
      for (const double x : find(soup, names[i])->values)
        BOOST_CHECK_EQUAL(x, color[i]);
    }
  }
}

// A 3MF file has one object with all faces, also of several materials.
BOOST_AUTO_TEST_CASE(solids)
{
  const Tool_directory shop;
  if (!assimp_reads("3mf") || !assimp_writes("3mf"))
    return;
  shop.write("in.obj", painted_obj());
  const Tool_outcome outcome = shop.run("in.obj out.3mf -n 60");
  BOOST_TEST_REQUIRE(outcome.status == 0, outcome.err);
  for (const char* field : {"materials of faces", "colors of vertices", "normals of vertices", "texture coordinates of corners"})
    BOOST_CHECK(outcome.names(std::string("the ") + field + " are left out, Assimp does not write them as 3MF"));
  BOOST_CHECK_EQUAL(parse_soup(test::content_of(shop / "out.3mf"), "3mf").points.size(), 60u);
}

BOOST_AUTO_TEST_CASE(opacities)
{
  const Tool_directory shop;
  std::string text = painted_obj();
  for (std::size_t at = text.find(" 0.2 0.4 1\n"); at != std::string::npos; at = text.find(" 0.2 0.4 1\n"))
    text.replace(at, 11, " .2 .4 1 .6\n");
  shop.write("in.obj", text);
  BOOST_CHECK_EQUAL(shop.run("in.obj out.glb -n 60").err, "");
  const Tool_outcome outcome = shop.run("out.glb out.ply -n 30");
  BOOST_CHECK(!outcome.names("opacities"));
  const Soup soup = parse_soup(test::content_of(shop / "out.ply"), "ply");
  BOOST_REQUIRE(find(soup, "alpha"));
  for (const double x : find(soup, "alpha")->values)
    BOOST_CHECK_EQUAL(x, 153);
}

// Points are repeated where materials meet, and are one again when they are read.
BOOST_AUTO_TEST_CASE(pieces_are_put_together)
{
  const nlohmann::json gltf = nlohmann::json::parse(R"({"asset": {"version": "2.0"}, "scene": 0,
    "scenes": [{"nodes": [0, 1]}],
    "nodes": [{"mesh": 0, "name": "left"}, {"mesh": 0, "scale": [-1, 1, 1], "name": "right"}],
    "materials": [{"name": "old stone"}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                  {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
    "buffers": [{"byteLength": 60, "uri": "numbers.bin"}]})");
  const float points[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
const std::uint16_t corners[] = {0, 1, 2, 0, 2, 3};
const std::string numbers = std::string(reinterpret_cast<const char*>(points), sizeof points) +
                            std::string(reinterpret_cast<const char*>(corners), sizeof corners);
const Tool_directory shop;
shop.write("two.gltf", gltf.dump());
shop.write("numbers.bin", numbers);
const Soup soup = coarsening_support::read_soup((shop / "two.gltf").string());
BOOST_CHECK_EQUAL(soup.points.size(), 6u); // of eight, two pairs are one
BOOST_REQUIRE_EQUAL(soup.polygons.size(), 4u);
for (const auto& polygon : soup.polygons) { // the mirrored one too is seen from the same side
  const auto &p = soup.points[polygon[0]], &q = soup.points[polygon[1]], &r = soup.points[polygon[2]];
  BOOST_CHECK_GT(CGAL::cross_product(q - p, r - p).z(), 0);
}
BOOST_CHECK((soup.materials == std::vector<std::string>(4, "old_stone")));
BOOST_CHECK((soup.left_out == std::vector<std::string>{"the properties of materials"}));
const Tool_outcome outcome = shop.run("two.gltf out.off -n 4");
BOOST_CHECK_EQUAL(outcome.status, 0);
BOOST_CHECK(outcome.names("warning: two.gltf: the properties of materials are not read"));
// Other files are read in the same directory and below only.
std::filesystem::create_directory(shop / "sub");
std::string outside = gltf.dump();
outside.replace(outside.find("numbers.bin"), 11, "../numbers.bin");
shop.write("sub/two.gltf", outside);
BOOST_CHECK_EQUAL(shop.run("sub/two.gltf out.off -n 4").status, 1);
}

BOOST_AUTO_TEST_CASE(losses_of_gltf_are_named)
{
  const Tool_directory shop;
  shop.write("in.obj", painted_obj());
  BOOST_TEST_REQUIRE(shop.run("in.obj in.gltf -n 60").status == 0);
  nlohmann::json gltf = nlohmann::json::parse(test::content_of(shop / "in.gltf"));
  for (auto& primitive : gltf["meshes"][0]["primitives"])
    primitive["attributes"]["_HEAT"] = primitive["attributes"]["POSITION"];
  shop.write("heat.gltf", gltf.dump());
  BOOST_CHECK(shop.run("heat.gltf out.off -n 20").names("warning: heat.gltf: the numbers '_HEAT' of vertices are not read"));
  BOOST_CHECK(!shop.run("in.gltf out.off -n 20").names("_HEAT"));
}

// A format with six digits: the vertices are moved there before they are measured.
BOOST_AUTO_TEST_CASE(formats_with_few_digits)
{
  const Tool_directory shop;
  if (!assimp_reads("3mf") || !assimp_writes("3mf"))
    return;
  generated::Soup far = generated::triangle_sphere(2);
  for (auto& p : far.points)
    p[0] += 100000;
  shop.write("far.off", mesh_files::off(far));
  const auto distance = [&shop](const std::string& file) {
    const Tool_outcome outcome = shop.run("far.off " + file + " -n 40 --measure");
    BOOST_TEST_REQUIRE(outcome.status == 0, outcome.err);
    BOOST_CHECK_EQUAL(outcome.names("the numbers of the format"), file != "out.off");
    return std::stod(outcome.out.substr(outcome.out.find("RMS ") + 4));
  };
  const double all_digits = distance("out.off"), single = distance("out.glb"), six = distance("out.3mf");
  BOOST_CHECK_LT(single, 1.2 * all_digits);
  BOOST_CHECK_GT(six, 1.2 * all_digits);
  BOOST_CHECK_EQUAL(parse_soup(test::content_of(shop / "out.3mf"), "3mf").points.size(), 40u);
}

BOOST_AUTO_TEST_CASE(standard_streams)
{
  const Tool_directory shop;
  shop.write("in.obj", painted_obj());
  BOOST_CHECK_EQUAL(shop.run("in.obj in.glb -n 200 --quiet").status, 0);
  const Tool_outcome outcome = shop.run("- - --format glb -n 30 <in.glb >stdout 2>stderr #");
  BOOST_TEST_REQUIRE(outcome.status == 0, outcome.err);
  BOOST_CHECK_EQUAL(parse_soup(outcome.out, "glb").points.size(), 30u);
}

// Cut and changed files end in one line, or in a mesh; the program does not crash, and takes bounded time and memory.
BOOST_AUTO_TEST_CASE(hostile_files)
{
  const Tool_directory shop;
  shop.write("in.obj", painted_obj());
  std::mt19937 random(1);
  std::size_t refused = 0, crashed = 0;
  for (const std::string type : {"glb", "gltf", "dae"}) {
    if (!assimp_reads(type) || !assimp_writes(type))
      continue;
    BOOST_TEST_REQUIRE(shop.run("in.obj sound." + type + " -n 60 --quiet").status == 0);
    const std::string sound = test::content_of(shop / ("sound." + type));
    for (int i = 0; i < 12; ++i) {
      std::string bytes = sound;
      if (i < 4)
        bytes.resize(1 + random() % bytes.size());
      else
        for (int k = 0; k < 1 << (i / 2); ++k)
          bytes[random() % bytes.size()] = char(random());
      shop.write("hostile." + type, bytes);
      const Tool_outcome outcome = shop.run("hostile." + type + " out.off -n 20 --quiet");
      BOOST_TEST_CONTEXT(type << ' ' << i << ": " << outcome.err)
      {
        BOOST_CHECK(outcome.status == 0 || outcome.status == 1);
        BOOST_CHECK_EQUAL(std::count(outcome.err.begin(), outcome.err.end(), '\n'), outcome.status);
        refused += outcome.status == 1;
        crashed += outcome.names("Assimp: crashes");
      }
    }
  }
  BOOST_TEST_MESSAGE(refused << " refused, in " << crashed << " of them Assimp has crashed");
  BOOST_CHECK_GT(refused, 5u);
  shop.write("empty.glb", "");
  BOOST_CHECK(shop.run("empty.glb out.off -n 20").names("is empty"));
  shop.write("text.glb", "this is no mesh\n");
  BOOST_CHECK(shop.run("text.glb out.off -n 20").names("text.glb: cannot be read as GLB: Assimp: "));
}

BOOST_AUTO_TEST_CASE(reading_can_be_stopped)
{
  const Tool_directory shop;
  shop.write("in.obj", painted_obj());
  BOOST_REQUIRE_EQUAL(shop.run("in.obj in.glb -n 100 --quiet").status, 0);
  const std::string bytes = test::content_of(shop / "in.glb");
  struct Stopped
  {};
  BOOST_CHECK_THROW(parse_soup(bytes, "glb", [] { throw Stopped(); }), Stopped);
}

BOOST_AUTO_TEST_CASE(unknown_types)
{
  const Tool_directory shop;
  for (const char* arguments : {"in.xyzzy out.off -n 20", "in.off out.xyzzy -n 20", "- out.off --format xyzzy -n 20"}) {
    const Tool_outcome outcome = shop.run(arguments);
    BOOST_CHECK_EQUAL(outcome.status, 2);
    BOOST_CHECK(outcome.names("Assimp does not know that either"));
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_CASE(without_assimp, *boost::unit_test::precondition(has_no_assimp))
{
  const Tool_directory shop;
  shop.write("in.obj", painted_obj());
  for (const char* arguments : {"in.glb out.off -n 20", "in.obj out.glb -n 20"}) {
    const Tool_outcome outcome = shop.run(arguments);
    BOOST_CHECK_EQUAL(outcome.status, 2);
    BOOST_CHECK(outcome.names("the format glb takes a program that is built with the library Assimp"));
  }
}

BOOST_AUTO_TEST_SUITE_END()
