// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tool with damaged, inconsistent, unreadable and unwritable files, and with signals.

#include "check/soup_fault.h"
#include "io/read_soup.h"
#include "support/Tool_process.h"
#include "support/mesh_files.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <random>

#include <sys/stat.h>

BOOST_AUTO_TEST_SUITE(test_tool_files)

namespace {

namespace fs = std::filesystem;
using coarsening_support::Format_fault;
using coarsening_support::parse_soup;
using test::Tool_directory;
using test::Tool_outcome;
using test::Tool_process;

// The address sanitizer reserves terabytes.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool can_limit_memory = false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool can_limit_memory = false;
#else
constexpr bool can_limit_memory = true;
#endif
#else
constexpr bool can_limit_memory = true;
#endif
const std::string little_memory = can_limit_memory ? "ulimit -v 400000" : ""; // kilobytes

boost::test_tools::assertion_result has_tool(boost::unit_test::test_unit_id)
{
  if (std::getenv("COARSEN_MESH"))
    return true;
  std::cout << "Skipped: the environment variable COARSEN_MESH does not name the tool" << std::endl;
  return false;
}

// Neither of the two restricts the super-user.
boost::test_tools::assertion_result has_permissions(boost::unit_test::test_unit_id)
{
  boost::test_tools::assertion_result result(geteuid() != 0);
  result.message() << "the super-user may read and write everything";
  return result;
}

generated::Soup sphere() { return generated::triangle_sphere(1); }

void check_refused(const Tool_directory& shop, const std::string& arguments, const std::vector<std::string>& parts,
                   const std::string& limits = "")
{
  const std::vector<std::string> before = shop.files();
  const Tool_outcome outcome = shop.run(arguments, limits);
  BOOST_TEST(outcome.status == 1, arguments << ": status " << outcome.status << ", " << outcome.err);
  BOOST_TEST(outcome.is_one_line_error(), arguments << ": " << outcome.err);
  for (const std::string& part : parts)
    BOOST_TEST(outcome.names(part), "'" << outcome.err << "' does not have '" << part << "'");
  BOOST_TEST(shop.files() == before, boost::test_tools::per_element());
}

void check_done(const Tool_directory& shop, const std::string& arguments, const std::string& limits = "")
{
  const Tool_outcome outcome = shop.run(arguments, limits);
  BOOST_TEST(outcome.status == 0, arguments << ": " << outcome.err);
}

} // namespace

// ---- accepted and refused files ----

BOOST_AUTO_TEST_CASE(every_form_is_read)
{
  const generated::Soup soup = generated::octahedron(); // small integers, which `float` holds
  for (const auto& form : mesh_files::all_forms(soup)) {
    const auto read = parse_soup(form.second, form.first);
    BOOST_REQUIRE(read.polygons.size() == soup.polygons.size());
    for (std::size_t f = 0; f < soup.polygons.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& p = read.points[read.polygons[f][i]];
        const auto& q = soup.points[soup.polygons[f][i]];
        BOOST_TEST((p.x() == q[0] && p.y() == q[1] && p.z() == q[2]));
      }
  }
}

BOOST_AUTO_TEST_CASE(variants_of_the_formats)
{
  const auto same = [](const std::string& type, const std::string& content) {
    const auto soup = parse_soup(content, type);
    BOOST_TEST(soup.points.size() == 3u);
    BOOST_REQUIRE(soup.polygons.size() == 1u);
    const auto polygon = soup.polygons[0];
    BOOST_CHECK((std::vector<std::size_t>(polygon.begin(), polygon.end()) == std::vector<std::size_t>{0, 1, 2}));
    BOOST_TEST((soup.points[2] == coarsening_support::Point(0, 1, -2.5)));
  };
  same("off", "OFF 3 1\n0 0 0\n1 0 0\n0 1 -2.5\n3 0 1 2");
  same("off", "# a comment\r\nOFF\r\n\r\n3 1 0\r\n0 0 0\r\n1 0 0 # here too\r\n0 1 -25e-1\r\n3 0 1 2\r\n");
  same("off", "3 1 0\n0 0 0\n1 0 0\n0 1 -2.5\n3 0 1 2\n");
  same("off", "STCNOFF\n3 1 0\n0 0 0 0 0 1 9 9 9 9 0 0\n1 0 0\n0 1 -2.5\n3 0 1 2 255 0 0\n");
  same("off", "4OFF\n3 1 0\n0 0 0 1\n2 0 0 2\n0 4 -10 4\n3 0 1 2\n");
  same("obj", "mtllib a\\b.mtl\no thing\nv 0 0 0 1 1 1\nv 1 0 \\\n0\nv 0 1 -2.5\nvt 0 0\nvn 0 0 1\nf 1/1/1 2//1 -1\n");
  same("ply", "ply\r\nformat ascii 1.0\r\nobj_info x\r\nelement camera 1\r\nproperty list uchar float view\r\n"
              "element vertex 3\r\nproperty short z2\r\nproperty float z\r\nproperty float y\r\nproperty float x\r\n"
              "element face 1\r\nproperty list uint8 uint vertex_index\r\nproperty int flags\r\nend_header\r\n"
              "2 7 7\r\n1 0 0 0\r\n1 0 0 1\r\n1 -2.5 1 0\r\n3 0 1 2 5\r\n");
  same("stl", "SOLID a thing\nFACET NORMAL nan nan nan OUTER LOOP VERTEX 0 0 0\nvertex 1 0 0 vertex 0 1 -2.5\n"
              "endloop endfacet endsolid a thing\n");
}

// A truncated file is refused, or it is complete except for white space or the end of a word. Only OBJ files do not
// state their number of elements.
BOOST_AUTO_TEST_CASE(every_beginning_of_a_file)
{
  for (const auto& form : mesh_files::all_forms(generated::tetrahedron())) {
    const std::string& content = form.second;
    const bool is_binary = content.find('\0') != std::string::npos;
    const std::size_t last_word = is_binary ? content.size() : content.find_last_of(" \n", content.size() - 2) + 1;
    for (std::size_t size = 0; size < content.size(); ++size)
      try {
        parse_soup(content.substr(0, size), form.first);
        BOOST_TEST((form.first == "obj" || size > last_word), form.first << " cut after " << size << " bytes is read");
      } catch (const Format_fault&) {
      }
  }
}

BOOST_AUTO_TEST_CASE(damaged_at_random)
{
  std::mt19937 engine(11);
  const auto forms = mesh_files::all_forms(generated::octahedron());
  std::size_t refused = 0;
  for (int trial = 0; trial < 40000; ++trial) {
    const auto& form = forms[engine() % forms.size()];
    std::string content = form.second;
    for (std::size_t changes = 1 + engine() % 3; changes > 0; --changes) {
      const std::size_t at = engine() % content.size(), other = engine() % content.size();
      switch (engine() % 4) {
      case 0: content[at] = static_cast<char>(engine()); break;
      case 1: content[at] = content[other]; break;
      case 2: content.erase(at, 1 + engine() % 4); break;
      default: content.insert(at, content.substr(other, engine() % 20));
      }
      if (content.empty())
        break;
    }
    try {
      const auto soup = parse_soup(content, form.first);
      coarsening_support::soup_fault(soup);
    } catch (const Format_fault& e) {
      ++refused;
      const std::string message = e.what();
      BOOST_TEST((message.compare(0, 5, "line ") == 0 || message.compare(0, 5, "byte ") == 0), message);
    }
  }
  BOOST_TEST(refused > 10000u);
}

// ---- the tool ----

BOOST_AUTO_TEST_SUITE(tool, *boost::unit_test::precondition(has_tool))

BOOST_AUTO_TEST_CASE(counts_that_lie)
{
  const Tool_directory shop;
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
                          "property double z\nelement face FACES\nproperty list COUNT int vertex_indices\nend_header\n"
                          "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const auto with = [](std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
  };
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", faces = "3 0 1 2\n3 0 3 1\n";
  const struct
  {
    std::string name, content, place, reason;
  } files[] = {
    {"few.off", "OFF\n3 2 0\n" + points + faces, "line 8: ", "goes on after"},
    {"many.off", "OFF\n4 3 0\n" + points + faces, "line 9: ", "ends before face 2 of the 3"},
    {"less.off", "OFF\n4 1 0\n" + points + faces, "line 8: ", "goes on after the 4 vertices and 1 faces"},
    {"huge.off", "OFF\n4000000000000 2 0\n" + points + faces, "line 2: ", "has room for"},
    {"beyond.off", "OFF\n99999999999999999999999 2 0\n" + points + faces, "line 2: ", "99999999"},
    {"negative.off", "OFF\n4 -2 0\n" + points + faces, "line 2: ", "-2"},
    {"face.off", "OFF\n4 2 0\n" + points + "2000000000 0 1 2\n3 0 3 1\n", "line 7: ", "2000000000"},
    {"short.off", "OFF\n4 2 0\n" + points + "3 0 1\n3 0 3 1\n", "line 7: ", "missing"},
    {"huge.ply", with(with(ply, "COUNT", "uchar"), "FACES", "3000000000"), "line 9: ", "has room for"},
    {"list.ply", with(with(ply, "COUNT", "uint"), "FACES", "1") + "4000000000 0 1 2\n", "line 14: ", "has room for"},
    {"more.ply", with(with(ply, "COUNT", "uint"), "FACES", "1") + "3 0 1 2\n3 0 3 1\n", "line 15: ", "goes on"},
    {"real.ply", with(with(ply, "COUNT", "float"), "FACES", "1") + "3 0 1 2\n", "line 8: ", "not whole"},
    {"huge.stl", std::string(80, 'x') + "\xff\xff\xff\x7f" + std::string(100, 'x'), "byte 84: ", "triangles are announced"},
    {"more.stl", std::string(80, 'x') + std::string("\x01\0\0\0", 4) + std::string(100, 'x'), "byte 134: ", "goes on"},
    {"huge_binary.off", std::string("OFF BINARY\n\x7f\xff\xff\xff\0\0\0\1\0\0\0\0", 23), "byte 23: ", "has room for"},
  };
  for (const auto& file : files) {
    shop.write(file.name, file.content);
    for (const std::string repair : {"", " --repair"})
      check_refused(shop, file.name + " out.off -n 9 --report r.json" + repair,
                    {"coarsen_mesh: " + file.name + ": ", file.place, file.reason}, little_memory);
  }
  std::string list = mesh_files::binary_ply(sphere(), true);
  list.replace(list.find("uchar int"), 9, "uint uchar");
  shop.write("binary.ply", list);
  check_refused(shop, "binary.ply out.off -n 9", {"byte "}, little_memory);
}

BOOST_AUTO_TEST_CASE(indices_that_lie)
{
  const Tool_directory shop;
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
                          "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (const std::string index : {"3", "-1", "4294967296", "18446744073709551615"}) {
    shop.write("in.off", "OFF\n3 1 0\n" + points + "3 0 1 " + index + "\n");
    check_refused(shop, "in.off out.off -n 9", {"in.off", index.size() < 20 ? "face 0" : "line 6: "});
    shop.write("in.ply", ply + points + "3 0 1 " + index + "\n");
    check_refused(shop, "in.ply out.off -n 9", {"in.ply", index.size() < 20 ? "face 0" : "line 13: "});
  }
  for (const std::string index : {"0", "4", "-4", "9999999999"}) {
    shop.write("in.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 " + index + "\n");
    check_refused(shop, "in.obj out.off -n 9", {"in.obj", "face 0 names a vertex that is not there"});
  }
  shop.write("word.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 three\n");
  check_refused(shop, "word.obj out.off -n 9", {"word.obj", "line 4: 'three'"});
  shop.write("word.off", "OFF\n3 1 0\n0 0 zero\n1 0 0\n0 1 0\n3 0 1 2\n");
  check_refused(shop, "word.off out.off -n 9", {"word.off", "line 3: 'zero'"});
}

BOOST_AUTO_TEST_CASE(binary_of_either_order)
{
  const Tool_directory shop;
  for (const bool big_endian : {false, true}) {
    shop.write("in.ply", mesh_files::binary_ply(sphere(), big_endian));
    check_done(shop, "in.ply out" + std::to_string(big_endian) + ".off -n 12");
  }
  shop.write("in.ply", mesh_files::text_ply(sphere()));
  check_done(shop, "in.ply out2.off -n 12");
  const std::string text = test::content_of(shop / "out2.off");
  BOOST_TEST((test::content_of(shop / "out0.off") == text));
  BOOST_TEST((test::content_of(shop / "out1.off") == text));
}

BOOST_AUTO_TEST_CASE(wrong_extensions)
{
  const Tool_directory shop;
  for (const auto& form : mesh_files::all_forms(sphere()))
    for (const std::string type : {"off", "obj", "ply", "stl"})
      if (type != form.first) {
        shop.write("in." + type, form.second);
        check_refused(shop, "in." + type + " out.off -n 9", {"in." + type});
      }
  shop.write("really_ply.off", mesh_files::text_ply(sphere()));
  check_refused(shop, "really_ply.off out.off -n 9", {"really_ply.off", "line 1", "it looks like PLY"});
  shop.write("really_off.stl", mesh_files::off(sphere()));
  check_refused(shop, "really_off.stl out.off -n 9", {"really_off.stl", "it looks like OFF"});
}

BOOST_AUTO_TEST_CASE(inputs_that_are_no_files)
{
  const Tool_directory shop;
  fs::create_directory(shop / "folder.off");
  fs::create_symlink("nowhere.off", shop / "dangling.off");
  fs::create_symlink("loop.off", shop / "loop.off");
  fs::create_symlink("/dev/zero", shop / "zero.off");
  fs::create_symlink("/dev/null", shop / "null.off");
  shop.write("empty.off", "");
  for (const std::string name : {"missing.off", "folder.off", "dangling.off", "loop.off", "zero.off", "null.off", "empty.off",
                                 "folder.off/in.off"})
    check_refused(shop, name + " out.off -n 9", {"coarsen_mesh: " + name + ": "}, little_memory);
  check_refused(shop, std::string(300, 'a') + ".off out.off -n 9", {".off: "});
}

BOOST_AUTO_TEST_CASE(permissions, *boost::unit_test::precondition(has_permissions))
{
  const Tool_directory shop;
  shop.write("in.off", mesh_files::off(sphere()));
  shop.write("secret.off", mesh_files::off(sphere()));
  fs::permissions(shop / "secret.off", fs::perms::none);
  fs::create_directory(shop / "locked");
  fs::permissions(shop / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  check_refused(shop, "secret.off out.off -n 9", {"secret.off: "});
  check_refused(shop, "in.off locked/out.off -n 9", {"locked/out.off: cannot be written"});
}

BOOST_AUTO_TEST_CASE(outputs_that_cannot_be_written)
{
  const Tool_directory shop;
  shop.write("in.off", mesh_files::off(generated::triangle_sphere(3)));
  fs::create_directory(shop / "folder.off");
  fs::create_symlink("/dev/full", shop / "full.off");
  fs::create_symlink("/dev/full", shop / "full.ply");
  fs::create_symlink("loop.off", shop / "loop.off");
  for (const std::string arguments :
       {"in.off full.off -n 100", "in.off full.off -n 100 --report r.json --clusters c.ply",
        "in.off out.off -n 100 --clusters full.ply --report r.json", "in.off out.off -n 100 --report /dev/full",
        "in.off missing/out.off -n 100 --report r.json", "in.off folder.off -n 100 --report r.json",
        "in.off in.off/out.off -n 100 --report r.json"})
    check_refused(shop, arguments, {": cannot be written: "});
  check_refused(shop, "in.off " + std::string(300, 'a') + ".off --report r.json -n 100", {".off: cannot be written: "});
  // A limit of 4 blocks on the size of files simulates a full disk: some bytes can be written. Existing files remain.
  shop.write("out.off", "before");
  check_refused(shop, "in.off out.off -n 250 --report r.json", {"out.off: cannot be written: "}, "ulimit -f 4");
  BOOST_TEST(test::content_of(shop / "out.off") == "before");
}

// A file that a program reads back differently is not written.
BOOST_AUTO_TEST_CASE(numbers_of_formats)
{
  const Tool_directory shop;
  const generated::Soup sphere = generated::triangle_sphere(3);
  shop.write("far.off",
             mesh_files::off(generated::translated(sphere, 6378137, 6378137, 6378137))); // meters from the Earth's center
  check_refused(shop, "far.off out.stl -n 200 --report r.json", {"out.stl: cannot be written: ", "different points", "use .ply"});
  check_done(shop, "far.off out.ply -n 200");
  BOOST_TEST(parse_soup(test::content_of(shop / "out.ply"), "ply").points.size() == 200u);
  shop.write("large.off", mesh_files::off(generated::scaled(sphere, 1e39, 1e39, 1e39)));
  check_refused(shop, "large.off out.stl -n 200", {"out.stl: cannot be written: ", "use .ply"});
  check_refused(shop, "large.off out.stl -n 200 --levels 2", {"out.stl: cannot be written: "});
  shop.write("near.off", mesh_files::off(sphere));
  check_done(shop, "near.off out.stl -n 200");
}

// What is measured is what the file holds: the coordinates are rounded before, and the repair sees them rounded.
BOOST_AUTO_TEST_CASE(rounding_is_measured)
{
  const Tool_directory shop;
  generated::Soup patch = generated::grid(40, 40);
  for (auto& p : patch.points)
    p = {6e6 + p[0] / 2, 4e5 + p[1] / 2, 100 + 3 * std::sin(p[0] / 3) * std::cos(p[1] / 5)};
  shop.write("patch.off", mesh_files::off(patch));
  const Tool_outcome outcome = shop.run("patch.off out.stl -n 200 --measure --report r.json");
  BOOST_TEST(outcome.status == 0, outcome.err);
  BOOST_TEST(outcome.names("warning: out.stl: the numbers of the format STL move vertices by up to 0.25"), outcome.err);
  BOOST_TEST(outcome.names("move the mesh to the origin"));
  BOOST_TEST(test::content_of(shop / "r.json").find("the numbers of the format STL move") != std::string::npos);
  const auto soup = parse_soup(test::content_of(shop / "out.stl"), "stl");
  BOOST_TEST(soup.points.size() == 200u);
  for (const auto& p : soup.polygons) {
    const auto &a = soup.points[p[0]], &b = soup.points[p[1]], &c = soup.points[p[2]];
    BOOST_TEST(CGAL::cross_product(b - a, c - a).squared_length() > 0); // as they are in double precision
  }
  const auto distance = [&shop](const std::string& arguments) {
    const std::string text = shop.run(arguments).out;
    return std::stod(text.substr(text.find("RMS ") + 4));
  };
  BOOST_TEST(distance("patch.off out.stl -n 200 --measure") > 1.1 * distance("patch.off out.ply -n 200 --measure"));

  // A distance is kept by what is written, or refused.
  check_refused(shop, "patch.off out.stl --maximum-distance 0.001",
                {"no result within 0.001", "the numbers of the format STL move vertices"});
  BOOST_TEST(shop.run("patch.off out.ply -n 200").err == "");
  shop.write("near.off", mesh_files::off(sphere()));
  BOOST_TEST(shop.run("near.off out.stl -n 12").err == "");
}

// Two vertices at one point are told apart by numbers of vertices, which STL has not, and not by digits.
BOOST_AUTO_TEST_CASE(twins_are_named)
{
  const Tool_directory shop;
  generated::Soup bow = generated::octahedron();
  const std::size_t n = bow.points.size();
  const auto top = bow.points[0];
  for (std::size_t v = 0; v < n; ++v) // mirrored at the first vertex, which is repeated
    bow.points.push_back({2 * top[0] - bow.points[v][0], 2 * top[1] - bow.points[v][1], 2 * top[2] - bow.points[v][2]});
  for (std::size_t f = 0, faces = bow.polygons.size(); f < faces; ++f) {
    auto polygon = bow.polygons[f];
    for (auto& v : polygon)
      v += n;
    std::reverse(polygon.begin(), polygon.end());
    bow.polygons.push_back(polygon);
  }
  shop.write("bow.off", mesh_files::off(bow));
  check_done(shop, "bow.off out.off -n 12 --repair --placement closest-vertex");
  const Tool_outcome outcome = shop.run("bow.off out.stl -n 12 --repair --placement closest-vertex");
  BOOST_TEST(outcome.status == 1);
  BOOST_TEST(outcome.is_one_line_error(), outcome.err);
  BOOST_TEST(outcome.names(" coincide (use .ply, .off or .obj, which keep all digits and tell vertices at one point apart)"),
             outcome.err);
}

BOOST_AUTO_TEST_CASE(names_of_one_file)
{
  const Tool_directory shop;
  const std::string content = mesh_files::off(generated::triangle_sphere(2));
  shop.write("in.off", content);
  shop.write("out.ply", "old");
  fs::create_directory(shop / "folder");
  fs::create_directory_symlink(shop.path(), shop / "folder" / "here");
  fs::create_symlink("in.off", shop / "input.json");
  fs::create_hard_link(shop / "in.off", shop / "again.json");
  fs::create_symlink("new.ply", shop / "dangling.ply");
  const std::string path = "'" + shop.path().string() + "'";
  const std::vector<std::string> before = shop.files();
  for (const std::string& arguments :
       std::vector<std::string>{"in.off out.ply --clusters " + path + "/out.ply", "in.off out.ply --clusters folder/here/out.ply",
        "in.off new.ply --clusters folder/../new.ply", "in.off new.ply --clusters folder/here/new.ply",
        "in.off new.ply --clusters dangling.ply", "in.off out.ply --report " + path + "/in.off",
        "in.off out.ply --report input.json", "in.off out.ply --report again.json",
        "folder/here/in.off out.ply --report in.off"}) {
    const Tool_outcome outcome = shop.run(arguments + " -n 20");
    BOOST_TEST(outcome.status == 2, arguments << ": status " << outcome.status);
    BOOST_TEST(outcome.is_one_line_error());
  }
  BOOST_TEST(shop.files() == before, boost::test_tools::per_element());
  BOOST_TEST(test::content_of(shop / "in.off") == content);
  BOOST_TEST(test::content_of(shop / "out.ply") == "old");

  check_done(shop, "in.off dangling.ply -n 20");
  BOOST_TEST(fs::is_symlink(shop / "dangling.ply"));
  BOOST_TEST(parse_soup(test::content_of(shop / "new.ply"), "ply").points.size() == 20u);
  fs::create_symlink("loop.ply", shop / "loop.ply");
  check_refused(shop, "in.off loop.ply -n 20", {"loop.ply: cannot be written: "});
}

BOOST_AUTO_TEST_CASE(numbers_at_the_ends)
{
  const Tool_directory shop;
  shop.write("in.off", mesh_files::off(sphere()));
  for (const std::string distance : {"--maximum-distance-absolute 1e200", "--maximum-distance-absolute 1.7e308",
                                     "--maximum-distance 1e308"}) {
    check_done(shop, "in.off out.off " + distance);
    BOOST_TEST(parse_soup(test::content_of(shop / "out.off"), "off").points.size() == 4u);
  }
  fs::remove(shop / "out.off");
  check_refused(shop, "in.off out.off --maximum-distance-absolute 1e-300", {"no result within a distance of 1e-300 was found"});
  for (const std::string number : {"18446744073709551615", "1000000000"})
    check_refused(shop, "in.off out.off --subdivide -n " + number, {"more than can be numbered"}, little_memory);
}

BOOST_AUTO_TEST_CASE(what_a_terminal_gets)
{
  const Tool_directory shop;
  const auto is_printable = [](const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); });
  };
  shop.write("in.off", "OFF\n3 1 0\n0 0 \x1b]0;title\x07\n1 0 0\n0 1 0\n3 0 1 2\n");
  check_refused(shop, "in.off out.off -n 9", {"'\\x1b]0;title\\x07'"});
  shop.write("in.off", "OFF\n3 1 0\n0 0 \xc2\x9b\x33m\xff\n1 0 0\n0 1 0\n3 0 1 2\n");
  check_refused(shop, "in.off out.off -n 9", {"'\\xc2\\x9b3m\\xff'"});
  BOOST_TEST(is_printable(shop.run("in.off out.off -n 9").err));
  for (const std::string name : {"a\x1b[31m.off", "a\x7f.off", "a\xff.off", "a\xc2\x9b.off", "a\xe2\x80\xae.off"}) {
    BOOST_TEST(is_printable(shop.run("'" + name + "' out.off -n 9").err), name);
    shop.write(name, mesh_files::off(sphere()));
    const Tool_outcome outcome = shop.run("'" + name + "' out.off -n 12");
    BOOST_TEST(outcome.status == 0, outcome.err);
    BOOST_TEST(is_printable(outcome.out), name);
  }
  check_refused(shop, "'M\xc3\xbcnchen \xe2\x82\xac.off' out.off -n 9", {"M\xc3\xbcnchen \xe2\x82\xac.off: "});
}

// The first redirection of the streams is the one that counts here.
BOOST_AUTO_TEST_CASE(standard_output_that_is_full)
{
  const Tool_directory shop;
  shop.write("in.off", mesh_files::off(sphere()));
  const std::string full = " >/dev/full 2>stderr </dev/null #";
  check_refused(shop, "in.off out.off -n 12 --report r.json" + full, {"standard output: cannot be written: "});
  check_refused(shop, "--version" + full, {"standard output: cannot be written: "});
  check_refused(shop, "--help" + full, {"standard output: cannot be written: "});
  check_done(shop, "in.off out.off -n 12 --quiet" + full);
}

BOOST_AUTO_TEST_CASE(pipes, *boost::unit_test::timeout(200))
{
  const Tool_directory shop;
  shop.write("fine.off", mesh_files::off(generated::triangle_sphere(4)));
  BOOST_REQUIRE(mkfifo((shop / "in.off").c_str(), 0600) == 0);
  BOOST_REQUIRE(mkfifo((shop / "out.ply").c_str(), 0600) == 0);
  {
    Tool_process tool(shop.path(), "in.off out.off -n 100");
    std::ofstream(shop / "in.off") << test::content_of(shop / "fine.off");
    const Tool_outcome outcome = tool.wait();
    BOOST_TEST(outcome.status == 0, outcome.err);
  }
  check_done(shop, "fine.off same.off -n 100");
  BOOST_TEST((test::content_of(shop / "out.off") == test::content_of(shop / "same.off")));
  {
    Tool_process tool(shop.path(), "in.off never.off -n 100");
    { std::ofstream writer(shop / "in.off"); } // that writes nothing
    const Tool_outcome outcome = tool.wait();
    BOOST_TEST(outcome.status == 1);
    BOOST_TEST(outcome.names("in.off: is empty"), outcome.err);
  }
  {
    Tool_process tool(shop.path(), "fine.off out.ply -n 100 --report r.json");
    const std::string got = test::content_of(shop / "out.ply");
    const Tool_outcome outcome = tool.wait();
    BOOST_TEST(outcome.status == 0, outcome.err);
    BOOST_TEST(parse_soup(got, "ply").points.size() == 100u);
    BOOST_TEST(fs::is_fifo(shop / "out.ply"));
  }
  {
    // A reader that ends at once. A write fails if it does not fit into the pipe.
    shop.write("finer.off", mesh_files::off(generated::triangle_sphere(5)));
    Tool_process tool(shop.path(), "finer.off out.ply -n 4000 --rounds 0 --report never.json");
    { std::ifstream reader(shop / "out.ply"); }
    const Tool_outcome outcome = tool.wait();
    BOOST_TEST(outcome.status == 1);
    BOOST_TEST(outcome.names("out.ply: cannot be written: "), outcome.err);
  }
  BOOST_TEST(!fs::exists(shop / "never.off"));
  BOOST_TEST(!fs::exists(shop / "never.json"));
}

BOOST_AUTO_TEST_CASE(no_memory)
{
  if (!can_limit_memory)
    return;
  const Tool_directory shop;
  shop.write("in.off", mesh_files::off(generated::triangle_sphere(7)));
  check_refused(shop, "in.off out.off -n 1000 --threads 1 --report r.json", {"in.off: there is not enough memory"}, "ulimit -v 30000");
}

// ---- signals ----

BOOST_AUTO_TEST_CASE(signals_while_waiting_for_input, *boost::unit_test::timeout(200))
{
  const Tool_directory shop;
  BOOST_REQUIRE(mkfifo((shop / "in.off").c_str(), 0600) == 0);
  const std::vector<std::string> before = shop.files();
  for (const auto& signal : {std::make_pair(SIGINT, "SIGINT"), {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}}) {
    Tool_process tool(shop.path(), "in.off out.off -n 100");
    std::ofstream writer(shop / "in.off"); // continues when the tool reads
    writer << "OFF\n4 4 0\n" << std::flush;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    tool.send(signal.first);
    const Tool_outcome outcome = tool.wait();
    BOOST_TEST(outcome.status == 128 + signal.first);
    BOOST_TEST(outcome.is_one_line_error());
    BOOST_TEST(outcome.names(std::string("in.off: interrupted by ") + signal.second), outcome.err);
    BOOST_TEST(shop.files() == before, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(signals_while_waiting_for_a_reader)
{
  const Tool_directory shop;
  shop.write("in.off", mesh_files::off(sphere()));
  BOOST_REQUIRE(mkfifo((shop / "out.ply").c_str(), 0600) == 0);
  const std::vector<std::string> before = shop.files();
  Tool_process tool(shop.path(), "in.off out.ply -n 12 --report r.json");
  for (int waits = 0; waits < 5000 && shop.files() == before; ++waits) // until the report is staged
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  BOOST_TEST(shop.files().size() == before.size() + 1);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  tool.send(SIGINT);
  const Tool_outcome outcome = tool.wait();
  BOOST_TEST(outcome.status == 128 + SIGINT);
  BOOST_TEST(outcome.is_one_line_error());
  BOOST_TEST(shop.files() == before, boost::test_tools::per_element());
}

// At any time: all files or none, and quickly.
BOOST_AUTO_TEST_CASE(signals_at_any_time)
{
  const Tool_directory shop;
  shop.write("in.off", mesh_files::off(generated::triangle_sphere(7)));
  const std::vector<std::string> before = shop.files();
  std::size_t interrupted = 0;
  for (int trial = 0; trial < 16; ++trial) {
    Tool_process tool(shop.path(), "in.off out.off -n 1000 --clusters c.ply --report r.json");
    std::this_thread::sleep_for(std::chrono::milliseconds(20 * (trial + 1)));
    tool.send(trial % 2 ? SIGINT : SIGTERM);
    const Tool_outcome outcome = tool.wait(std::chrono::seconds(60));
    std::vector<std::string> expected = before;
    if (outcome.status == 0) {
      expected = {"c.ply", "in.off", "out.off", "r.json"};
      const std::string name = (shop / "out.off").string();
      BOOST_TEST(!coarsening_support::soup_fault(coarsening_support::read_soup(name)).has_value());
    } else {
      // At the start, the signal may end the shell or the start of the tool.
      BOOST_TEST(outcome.status == 128 + (trial % 2 ? SIGINT : SIGTERM), outcome.err);
      interrupted += outcome.is_one_line_error();
    }
    BOOST_TEST(shop.files() == expected, boost::test_tools::per_element());
    for (const std::string& name : shop.files())
      if (name != "in.off")
        fs::remove(shop / name);
  }
  BOOST_TEST(interrupted > 3u);
}

BOOST_AUTO_TEST_CASE(standard_streams)
{
  const Tool_directory shop;
  shop.write("in.off", mesh_files::off(generated::triangle_sphere(4)));
  BOOST_CHECK_EQUAL(shop.run("in.off out.off -n 30 --quiet").status, 0);
  const std::string expected = test::content_of(shop / "out.off");
  // What follows the # are the streams that the test has by default.
  const Tool_outcome outcome = shop.run("- - --format OFF -n 30 <in.off >stdout 2>stderr #");
  BOOST_CHECK_EQUAL(outcome.status, 0);
  BOOST_CHECK(outcome.out == expected);
  BOOST_CHECK(outcome.names("-> - (30 vertices, 56 faces)")); // beside the mesh, not in it
  BOOST_CHECK_EQUAL(shop.run("- out.ply --format off -n 30 <in.off >stdout 2>stderr #").status, 0);
  BOOST_CHECK_EQUAL(shop.run("in.off - --format ply -n 30 --quiet").out.substr(0, 4), "ply\n");
  check_refused(shop, "- out.off --format off -n 30", {"standard input: is empty"});
  for (const char* wrong : {"- out.off", "in.off -", "- - --format png", "in.off - --format off --levels 1",
                            "in.off - --format off --report -"}) {
    const Tool_outcome refused = shop.run(std::string(wrong) + " -n 30");
    BOOST_CHECK_EQUAL(refused.status, 2);
    BOOST_CHECK(refused.is_one_line_error());
  }
}

BOOST_AUTO_TEST_CASE(several_inputs)
{
  const Tool_directory shop;
  for (const char* name : {"a.off", "b.off", "c.off"})
    shop.write(name, mesh_files::off(generated::triangle_sphere(4)));
  shop.write("broken.off", "OFF\n1 1 0\n");
  fs::create_directory(shop / "folder");
  const Tool_outcome all = shop.run("a.off b.off c.off folder -n 30");
  BOOST_CHECK_EQUAL(all.status, 0);
  BOOST_CHECK_EQUAL(std::count(all.out.begin(), all.out.end(), '\n'), 3); // a line each
  const std::string content = test::content_of(shop / "folder" / "a.off");
  BOOST_CHECK(!content.empty());
  for (const char* name : {"b.off", "c.off"})
    BOOST_CHECK(test::content_of(shop / "folder" / name) == content);
  const Tool_outcome some = shop.run("a.off broken.off c.off folder/coarse_%%_%.ply -n 30 --report folder/%.json");
  BOOST_CHECK_EQUAL(some.status, 1);
  BOOST_CHECK_EQUAL(std::count(some.out.begin(), some.out.end(), '\n'), 2);
  BOOST_CHECK_EQUAL(std::count(some.err.begin(), some.err.end(), '\n'), 1);
  BOOST_CHECK(some.names("coarsen_mesh: broken.off: "));
  for (const char* name : {"coarse_%_a.ply", "coarse_%_c.ply", "a.json", "c.json"})
    BOOST_CHECK(fs::exists(shop / "folder" / name));
  BOOST_CHECK(!fs::exists(shop / "folder" / "coarse_%_broken.ply"));
  const std::vector<std::string> before = shop.files();
  for (const char* wrong : {"a.off b.off c.off", "a.off b.off folder --report r.json", "a.off folder/../a.off folder",
                            "a.off b.off ./%.off --report a.off", "a.off b.off missing", "a.off b.off b%.off --picture %.off"}) {
    const Tool_outcome refused = shop.run(std::string(wrong) + " -n 30");
    BOOST_CHECK_MESSAGE(refused.status == 2, wrong);
    BOOST_CHECK(refused.is_one_line_error());
  }
  BOOST_CHECK(shop.files() == before);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
