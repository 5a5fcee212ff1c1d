// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the tool coarsen_mesh as a process. Its path is taken from the environment variable COARSEN_MESH.

#include "check/soup_fault.h"
#include "io/read_soup.h"
#include "io/to_mesh.h"
#include "render/Stroke_text.h"
#include "support/generate_meshes.h"

#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/Surface_mesh_coarsening/compute_face_densities.h>
#include <CGAL/Surface_mesh_coarsening/version.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

BOOST_AUTO_TEST_SUITE(test_tool)

namespace {

namespace fs = std::filesystem;
using coarsening_support::Face;
using coarsening_support::Mesh;
using Json = nlohmann::json;

std::string content_of(const fs::path& file)
{
  std::ifstream is(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>());
}

std::string off_text(const generated::Soup& soup)
{
  std::ostringstream os;
  os.precision(17);
  os << "OFF\n" << soup.points.size() << ' ' << soup.polygons.size() << " 0\n";
  for (const auto& p : soup.points)
    os << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const auto& polygon : soup.polygons) {
    os << polygon.size();
    for (std::size_t v : polygon)
      os << ' ' << v;
    os << '\n';
  }
  return os.str();
}

struct Outcome
{
  int status;
  std::string out, err;

  bool is_one_line_error() const { return out.empty() && std::count(err.begin(), err.end(), '\n') == 1; }
  bool names(const std::string& text) const { return err.find(text) != std::string::npos; }
};

std::string quoted(const std::string& text) { return "'" + text + "'"; }

// A separate directory for each test case, in which the tool runs.
class Workshop
{
  fs::path directory = fs::temp_directory_path() / ("test_tool_" + std::to_string(getpid()));

public:
  Workshop()
  {
    fs::remove_all(directory);
    fs::create_directories(directory);
  }
  ~Workshop()
  {
    std::error_code ignored;
    fs::remove_all(directory, ignored);
  }

  fs::path operator/(const std::string& name) const { return directory / name; }

  void write(const std::string& name, const std::string& text) const
  {
    std::ofstream(directory / name, std::ios::binary) << text;
  }
  void write(const std::string& name, const generated::Soup& soup) const { write(name, off_text(soup)); }

  std::vector<std::string> files() const
  {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(directory))
      if (entry.path().filename() != "stdout" && entry.path().filename() != "stderr")
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

  // `arguments` are parsed by a shell.
  Outcome run(const std::string& arguments) const
  {
    const std::string command = "cd " + quoted(directory.string()) + " && " + quoted(std::getenv("COARSEN_MESH")) + " " +
                                arguments + " >stdout 2>stderr </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(directory / "stdout"), content_of(directory / "stderr")};
  }

  void run_well(const std::string& arguments) const
  {
    const Outcome outcome = run(arguments);
    BOOST_TEST(outcome.status == 0, arguments << ": " << outcome.err);
    std::istringstream lines(outcome.err); // of warnings on triangles of very coarse results, and of no others
    for (std::string line; std::getline(lines, line);)
      BOOST_TEST((line.find("coarsen_mesh: warning: ") == 0 && line.find(" triangle") != std::string::npos),
                 arguments << ": " << line);
  }

  Json report(const std::string& name) const { return Json::parse(content_of(directory / name)); }

  Mesh mesh(const std::string& name) const
  {
    const auto soup = coarsening_support::read_soup((directory / name).string());
    const auto fault = coarsening_support::soup_fault(soup);
    BOOST_TEST(!fault.has_value());
    return coarsening_support::to_mesh(soup);
  }
};

boost::test_tools::assertion_result has_tool(boost::unit_test::test_unit_id)
{
  if (std::getenv("COARSEN_MESH"))
    return true;
  std::cout << "Skipped: the environment variable COARSEN_MESH does not name the tool" << std::endl;
  return false;
}

#ifdef CGAL_LINKED_WITH_TBB
const std::string threads = "4";
#else
const std::string threads = "1"; // more are warned of
#endif

const std::vector<std::string> weights = {"uniform", "area", "maximum", "exact-maximum", "variance"};

} // namespace

BOOST_AUTO_TEST_SUITE(tool, *boost::unit_test::precondition(has_tool))

BOOST_AUTO_TEST_CASE(questions)
{
  const Workshop shop;
  const Outcome version = shop.run("--version");
  BOOST_TEST(version.status == 0);
  BOOST_TEST(version.out == "coarsen_mesh " CGAL_SURFACE_MESH_COARSENING_VERSION "\n");
  const Outcome help = shop.run("--help"), short_help = shop.run("-h");
  BOOST_TEST(help.status == 0);
  BOOST_TEST(short_help.status == 0);
  const auto lines = [](const std::string& text) {
    std::vector<std::string> result;
    std::istringstream is(text);
    for (std::string line; std::getline(is, line);)
      result.push_back(line);
    return result;
  };
  BOOST_TEST(lines(short_help.out).size() <= 25u);
  for (const std::string& line : lines(help.out + short_help.out))
    BOOST_TEST(line.size() <= 80u, line);
  for (const char* group : {"Size of the result:", "What is kept:", "Preparation of the input:", "More output:", "Method:"})
    BOOST_TEST(help.out.find(std::string("\n") + group + "\n") != std::string::npos, group);
  std::size_t examples = 0;
  for (const std::string& line : lines(short_help.out)) {
    examples += line.compare(0, 15, "  coarsen_mesh ") == 0;
    std::istringstream words(line);
    for (std::string word; words >> word;)
      if (word.compare(0, 2, "--") == 0)
        BOOST_TEST(help.out.find(word) != std::string::npos, word);
  }
  BOOST_TEST(examples == 3u);
  for (const char* option : {"--vertices",
                             "--range",
                             "--neighborhood-level",
                             "--rounds",
                             "--convergence-tolerance",
                             "--energy",
                             "--weight",
                             "--maximum-density",
                             "--placement",
                             "--paper",
                             "--features",
                             "--clusters",
                             "--picture",
                             "--view",
                             "--report",
                             "--repair",
                             "--weld",
                             "--fill-holes",
                             "--minimum-component-area",
                             "--subdivide",
                             "--measure",
                             "--threads",
                             "--force",
                             "--quiet",
                             "--version",
                             "--help"})
    BOOST_TEST(help.out.find(option) != std::string::npos, option);
  for (const std::string energy : {"weighted", "quadric", "normals"})
    BOOST_TEST(help.out.find(energy) != std::string::npos, energy);
  for (const std::string& weight : weights)
    BOOST_TEST(help.out.find(weight) != std::string::npos, weight);
}

BOOST_AUTO_TEST_CASE(wrong_usage)
{
  const Workshop shop;
  shop.write("in.off", generated::octahedron());
  for (const char* arguments : {"",
                                "in.off",
                                "in.off out.xyz -n 6",
                                "in.xyz out.off -n 6",
                                "in.off out.off -n 6 extra",
                                "in.off out.off -n 6 --no-such-option",
                                "in.off out.off -n 6 --vert 6",
                                "in.off out.off -n",
                                "in.off out.off -n 0",
                                "in.off out.off -n -6",
                                "in.off out.off -n 6.5",
                                "in.off out.off",
                                "in.off out.off -n 0%",
                                "in.off out.off -n -5%",
                                "in.off out.off -n x%",
                                "in.off out.off -n %",
                                "in.off out.off --range",
                                "--range",
                                "in.off out.off -n 10% -k 1",
                                "in.off out.off -n 10% --faces 10",
                                "in.off out.off -n 99999999999999999999999",
                                "in.off out.off -k -1",
                                "in.off out.off -n 6 --rounds x",
                                "in.off out.off -n 6 --convergence-tolerance x",
                                "in.off out.off -n 6 --convergence-tolerance -1",
                                "in.off out.off -n 6 -w heavy",
                                "in.off out.off -n 6 --energy heavy",
                                "in.off out.off -n 6 --energy quadric -w area",
                                "in.off out.off -n 6 -w ''",
                                "in.off out.off -n 6 --maximum-density 0.5",
                                "in.off out.off -n 6 --maximum-density nan",
                                "in.off out.off -n 6 --maximum-density 1e400",
                                "in.off out.off -n 6 --placement nowhere",
                                "in.off out.off -n 6 --features=sharp",
                                "in.off out.off -n 6 --features -1",
                                "in.off out.off -n 6 --features 181",
                                "in.off out.off -n 6 --view 1,2",
                                "in.off out.off -n 6 --view 0,0,0",
                                "in.off out.off -n 6 --view 1,2,x",
                                "in.off out.off -n 6 --view 1,2,3,4",
                                "in.off out.off -n 6 --clusters c.off",
                                "in.off out.off -n 6 --picture p.jpg",
                                "in.off out.off -n 6 --threads 0",
                                "in.off out.off -n 6 --fill-holes -1",
                                "in.off out.off -n 6 --fill-holes nan",
                                "in.off out.off -n 6 --fill-holes",
                                "in.off out.off -n 6 --fill-holes most",
                                "in.off out.off -n 6 --fill-holes -5%",
                                "in.off out.off -n 6 --fill-holes %",
                                "in.off out.off -n 6 --minimum-component-area -2",
                                "in.off out.off -n 6 --minimum-component-area wide",
                                "in.off out.off -n 6 --subdivide 3",
                                "in.off out.ply -n 6 --clusters ./out.ply",
                                "in.off out.off -n 6 --weld 0",
                                "in.off out.off -n 6 --weld near",
                                "in.off out.off -n 6 --report in.off"}) {
    const Outcome outcome = shop.run(arguments);
    BOOST_TEST(outcome.status == 2, arguments);
    BOOST_TEST(outcome.is_one_line_error(), arguments);
  }
  BOOST_TEST(shop.files() == std::vector<std::string>{"in.off"}, boost::test_tools::per_element());
  BOOST_TEST(shop.run("in.off out.off").names("how many vertices?"));
}

// A reader that has had enough, such as head, is no reason for a message. Files appear; a mesh on standard output fails.
BOOST_AUTO_TEST_CASE(closed_pipes_are_silent)
{
  const Workshop shop;
  shop.write("in.off", generated::triangle_sphere(2));
  for (const auto& [arguments, status] : std::map<std::string, std::string>{{"--help", "0"},
                                                                            {"-h", "0"},
                                                                            {"--version", "0"},
                                                                            {"--range in.off", "0"},
                                                                            {"in.off out.off -n 20", "0"},
                                                                            {"in.off - --format off -n 20", "141"}}) {
    const std::string command = "cd " + quoted((shop / "").string()) + " && { sleep .2; " + quoted(std::getenv("COARSEN_MESH")) +
                                " " + arguments + "; echo $? >status; } 2>stderr | true";
    BOOST_TEST(std::system(command.c_str()) == 0);
    for (int waits = 0; waits < 200 && content_of(shop / "status").empty(); ++waits) // for shells that do not
      usleep(50000);
    BOOST_TEST(content_of(shop / "status") == status + "\n", arguments);
    BOOST_TEST(content_of(shop / "stderr").empty(), content_of(shop / "stderr"));
    fs::remove(shop / "status");
  }
  BOOST_TEST(shop.mesh("out.off").number_of_vertices() == 20u);
}

// More threads than there are need a warning.
BOOST_AUTO_TEST_CASE(threads_that_cannot_be_had)
{
  const Workshop shop;
  shop.write("in.off", generated::triangle_sphere(3));
  shop.run_well("in.off out.off -n 50 --threads 1");
  const Outcome outcome = shop.run("in.off out.off -n 50 --threads 4 --report r.json");
  BOOST_TEST(outcome.status == 0);
  const bool can_have_them = shop.report("r.json")["parameters"]["threads"]["used"] == 4;
  BOOST_TEST(outcome.err.empty() == can_have_them);
  BOOST_TEST(outcome.names("warning: --threads 4: there is 1 thread only") != can_have_them, outcome.err);
}

// The numbers can be asked for, and a part of the input's vertices be given.
BOOST_AUTO_TEST_CASE(ranges_and_ratios)
{
  const Workshop shop;
  shop.write("in.off", generated::triangle_sphere(3));
  const Mesh input = shop.mesh("in.off");
  const std::size_t vertices = input.number_of_vertices();
  const Outcome range = shop.run("--range in.off");
  BOOST_TEST(range.status == 0);
  BOOST_TEST(range.out == "4 to " + std::to_string(vertices) + " vertices\n");
  BOOST_TEST(shop.files() == std::vector<std::string>{"in.off"}, boost::test_tools::per_element());
  shop.run_well("in.off out.off -n 4");
  BOOST_TEST(shop.run("in.off out.off -n 3").status == 1);
  BOOST_TEST(shop.run("--range missing.off").status == 1);
  // With 20 faces for each vertex there is hardly a limit; corners of a cube stay.
  BOOST_TEST(shop.run("in.off --range --subdivide").out.substr(0, 5) == "4 to ");
  generated::Soup cross = generated::torus(3, 3); // five faces of it, pieces of which form fewer clusters
  cross.polygons = {cross.polygons[0], cross.polygons[1], cross.polygons[2], cross.polygons[3], cross.polygons[6]};
  shop.write("cross.off", cross);
  BOOST_TEST(shop.run("cross.off --range --subdivide").out.substr(0, 5) == "6 to ");
  shop.run_well("cross.off out.off --subdivide -n 6");
  BOOST_TEST(shop.run("cross.off out.off --subdivide -n 5").status == 1);
  shop.write("cube.off", generated::triangulated(generated::cube_grid(8)));
  BOOST_TEST(shop.run("cube.off --range --features").out.substr(0, 5) == "8 to ");

  shop.run_well("in.off out.off -n 10% --report r.json");
  BOOST_TEST(shop.mesh("out.off").number_of_vertices() == std::size_t(std::round(0.1 * double(vertices))));
  BOOST_TEST(shop.report("r.json")["parameters"]["vertex_ratio"] == 0.1);
  BOOST_TEST(shop.run("in.off out.off -n 101%").status == 1);
}

// The method of the paper; options beside it take precedence.
BOOST_AUTO_TEST_CASE(paper)
{
  const Workshop shop;
  shop.write("in.off", generated::with_noise(generated::triangulated(generated::grid(20, 20)), 0.2));
  shop.run_well("in.off out.off -n 40 --paper -w variance --report r.json");
  const Json report = shop.report("r.json");
  BOOST_TEST(report["parameters"]["paper"] == true);
  BOOST_TEST(report["parameters"]["placement"] == "centroid");
  BOOST_TEST(report["parameters"]["maximum_density"] == 3.);
  BOOST_TEST(report["parameters"]["convergence_tolerance"] == 0.);
  BOOST_TEST(report["parameters"]["error_feedback"] == 0);
  BOOST_TEST(report["clustering"]["refused_by_boundary_counts"] > 0);
  shop.run_well("in.off out.off -n 40 --paper --maximum-density 5 --placement quadric --report r.json");
  BOOST_TEST(shop.report("r.json")["parameters"]["maximum_density"] == 5.);
  BOOST_TEST(shop.report("r.json")["parameters"]["placement"] == "quadric");
  shop.run_well("in.off out.off -n 40 --report r.json");
  BOOST_TEST(shop.report("r.json")["parameters"]["paper"] == false);
  BOOST_TEST(shop.report("r.json")["clustering"]["refused_by_boundary_counts"] == 0);
}

BOOST_AUTO_TEST_CASE(unreadable_input)
{
  const Workshop shop;
  shop.write("empty.off", "");
  shop.write("text.off", "This is no mesh.\n");
  shop.write("short.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n");
  shop.write("greedy.off", "OFF\n2000000000 2000000000 0\n0 0 0\n");
  shop.write("colorless.off", "COFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  shop.write("points.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n");
  shop.write("stray.ply", "ply\nformat ascii 1.0\nproperty double x\nend_header\n");
  shop.write("short.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
                          "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0");
  shop.write("odd.obj", "v 0 0 0\nnonsense\n");
  shop.write("short.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n");
  fs::create_directory(shop / "folder.off");
  const std::vector<std::string> before = shop.files();
  for (const std::string name : {"missing.off", "empty.off", "text.off", "short.off", "greedy.off", "points.off", "stray.ply",
                                 "short.ply", "odd.obj", "short.stl", "folder.off"})
    for (const std::string repair : {"", " --repair"}) {
      const Outcome outcome = shop.run(name + " out.off -n 3 --report out.json" + repair);
      BOOST_TEST(outcome.status == 1, name);
      BOOST_TEST(outcome.is_one_line_error(), name);
      BOOST_TEST(outcome.names("coarsen_mesh: " + name + ": "), outcome.err);
    }
  BOOST_TEST(shop.files() == before, boost::test_tools::per_element());
  shop.run_well("colorless.off out.off -n 3"); // nothing essential is missing
}

BOOST_AUTO_TEST_CASE(formats)
{
  const Workshop shop;
  shop.write("in.off", generated::triangulated(generated::torus(24, 16)));
  for (const std::string type : {"off", "obj", "ply", "stl"}) {
    shop.run_well("in.off fine." + type + " -n 200");
    const Mesh fine = shop.mesh("fine." + type);
    BOOST_TEST(fine.number_of_vertices() == 200u);
    BOOST_TEST(fine.number_of_faces() == 400u);
    shop.run_well("fine." + type + " coarse." + type + " -n 60");
    BOOST_TEST(shop.mesh("coarse." + type).number_of_vertices() == 60u);
  }
  const Mesh off = shop.mesh("fine.off"), ply = shop.mesh("fine.ply"), obj = shop.mesh("fine.obj");
  for (auto v : off.vertices()) // no digit is lost
    BOOST_TEST((off.point(v) == ply.point(v) && off.point(v) == obj.point(v)));
}

BOOST_AUTO_TEST_CASE(choices)
{
  const Workshop shop;
  shop.write("in.off", generated::with_noise(generated::triangle_sphere(3), 0.01));
  for (const std::string& weight : weights)
    for (const std::string placement : {"centroid", "closest-vertex", "quadric", "fitted"}) {
      shop.run_well("in.off out.off -n 50 --threads " + threads + " -w " + weight + " --placement " + placement +
                    " --report r.json");
      const Json report = shop.report("r.json");
      BOOST_TEST(report["parameters"]["weight"] == weight);
      BOOST_TEST(report["parameters"]["placement"] == placement);
      BOOST_TEST(report["parameters"]["threads"]["allowed"] == std::stoi(threads));
      BOOST_TEST(report["parameters"]["maximum_density"] == 10.);
      BOOST_TEST(report["output"]["valid"] == true);
      BOOST_TEST(report["output"]["vertices"] == 50);
      BOOST_TEST(report["clustering"]["clusters"] == 50);
      BOOST_TEST(report["clustering"]["converged"] == true);
      BOOST_TEST(report["clustering"]["final_energy"] <= report["clustering"]["initial_energy"]);
    }
  for (const std::string energy : {"weighted", "quadric", "normals"}) {
    shop.run_well("in.off out.off -n 50 --energy " + energy + " --report r.json");
    const Json report = shop.report("r.json");
    BOOST_TEST(report["parameters"]["energy"] == energy);
    BOOST_TEST(report["parameters"]["weight"].is_null() == (energy != "weighted"));
    BOOST_TEST(report["output"]["vertices"] == 50);
    BOOST_TEST(report["clustering"]["final_energy"] <= report["clustering"]["initial_energy"]);
  }

  shop.run_well("in.off out.off -k 3 --rounds 0 --report r.json");
  const Json rough = shop.report("r.json");
  BOOST_TEST(rough["parameters"]["neighborhood_level"] == 3);
  BOOST_TEST(rough["parameters"]["vertices"].is_null());
  BOOST_TEST(rough["clustering"]["rounds"] == 0);
  BOOST_TEST(rough["clustering"]["moves"] == 0);
  BOOST_TEST(rough["clustering"]["level"] == 3);
  BOOST_TEST(rough["clustering"]["clusters"] == rough["output"]["vertices"]);
  shop.run_well("in.off out.off -k 3 --rounds 2 --report r.json");
  BOOST_TEST(shop.report("r.json")["clustering"]["rounds"] == 2);
  BOOST_TEST(shop.report("r.json")["clustering"]["converged"] == false);
  shop.write("fine.off", generated::with_noise(generated::triangle_sphere(4), 0.01));
  shop.run_well("fine.off out.off -k 2 -n 40 --report r.json");
  BOOST_TEST(shop.report("r.json")["clustering"]["level"] == 2);
  BOOST_TEST(shop.report("r.json")["clustering"]["clusters"] == 40);
  shop.run_well("fine.off out.off -n 50 --report r.json");
  const Json standard = shop.report("r.json");
  BOOST_TEST(standard["parameters"]["convergence_tolerance"] == 0.001);
  shop.run_well("fine.off out.off -n 50 --convergence-tolerance 0 --report r.json");
  const Json exact = shop.report("r.json");
  BOOST_TEST(exact["parameters"]["convergence_tolerance"] == 0.);
  BOOST_TEST(exact["clustering"]["rounds"] > standard["clustering"]["rounds"]);
  BOOST_TEST(exact["clustering"]["final_energy"] < standard["clustering"]["final_energy"]);
  BOOST_TEST(exact["clustering"]["converged"] == true);
}

// Flips and exchanges leave few of the triangles between the clusters.
BOOST_AUTO_TEST_CASE(certificate_of_a_prism)
{
  const Workshop shop;
  shop.write("in.off", generated::prism(200));
  shop.run_well("in.off out.off -n 100 --report r.json");
  BOOST_TEST(shop.report("r.json")["certificate"]["kept"] == true);
}

BOOST_AUTO_TEST_CASE(report_and_certificate)
{
  const Workshop shop;
  // A torus of quadrangles, a tube, and an unused point.
  generated::Soup soup = generated::joined(generated::torus(20, 12), generated::translated(generated::tube(16, 10), 9, 0, 0));
  soup.points.insert(soup.points.begin(), {7, 7, 7});
  for (auto& polygon : soup.polygons)
    for (std::size_t& v : polygon)
      ++v;
  shop.write("in.off", soup);
  shop.run_well("in.off out.off -n 60 --report r.json");
  const Json report = shop.report("r.json");

  BOOST_TEST(report["version"] == CGAL_SURFACE_MESH_COARSENING_VERSION);
  BOOST_TEST(report["input"]["file"] == "in.off");
  BOOST_TEST(report["input"]["points_in_file"] == soup.points.size());
  BOOST_TEST(report["input"]["vertices"] == soup.points.size() - 1);
  BOOST_TEST(report["input"]["unused_points_dropped"] == 1);
  BOOST_TEST(report["input"]["faces"] == soup.polygons.size());
  BOOST_TEST(report["input"]["repair"].is_null());
  BOOST_TEST(report["output"]["vertices"] == 60);
  BOOST_TEST(report["output"]["valid"] == true);
  BOOST_TEST(report["output"]["fault"].is_null());

  const Json& certificate = report["certificate"];
  BOOST_TEST(certificate["kept"] == true);
  BOOST_TEST(certificate["components_one_to_one"] == true);
  BOOST_TEST(certificate["orientation_kept"] == true);
  BOOST_REQUIRE(certificate["components"].size() == 2u);
  const int genus[] = {1, 0}, loops[] = {0, 2};
  std::size_t vertices = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    for (const char* when : {"before", "after"}) {
      const Json& counts = certificate["components"][i][when];
      BOOST_TEST(counts["genus"] == genus[i]);
      BOOST_TEST(counts["border_loops"] == loops[i]);
      BOOST_TEST(counts["euler_characteristic"] == 0);
      BOOST_TEST(counts["vertices"].get<int>() - counts["edges"].get<int>() + counts["faces"].get<int>() == 0);
    }
    vertices += certificate["components"][i]["after"]["vertices"].get<std::size_t>();
  }
  BOOST_TEST(vertices == 60u);

  double sum = 0;
  for (const char* stage : {"read", "preparation", "seeding", "growth", "minimization", "triangulation", "placement",
                            "error feedback", "repair of the result", "check", "write"}) {
    BOOST_REQUIRE(report["seconds"][stage].is_number());
    BOOST_TEST(report["seconds"][stage].get<double>() >= 0);
    sum += report["seconds"][stage].get<double>();
  }
  BOOST_TEST(sum <= report["seconds"]["total"].get<double>());
}

// The characters of captions have shapes of their own, inside the line; only some letters and signs reach below the base line.
BOOST_AUTO_TEST_CASE(captions)
{
  using coarsening_support::Image;
  using coarsening_support::Stroke_text;
  const std::size_t height = 40, base_line = 33;
  std::vector<std::vector<coarsening_support::Rgb> > shapes;
  for (const char c : std::string("0123456789abcdefghijklmnopqrstuvwxyz.,%-+() ")) {
    const Stroke_text text(std::string(1, c), height);
    BOOST_TEST(text.height() == height);
    Image image(40, 60);
    text.draw(image, 0, 0);
    std::size_t dark = 0, below = 0, outside = 0;
    for (std::size_t y = 0; y < image.height; ++y)
      for (std::size_t x = 0; x < image.width; ++x)
        if (image.at(x, y)[0] < 128) {
          ++dark;
          below += y >= base_line && y < height;
          outside += y >= height || x >= text.width();
        }
    BOOST_TEST_CONTEXT(c)
    {
      BOOST_TEST((dark == 0) == (c == ' '));
      BOOST_TEST((below > 0) == (std::string("gjpqy,()").find(c) != std::string::npos));
      BOOST_TEST(outside == 0u);
    }
    shapes.push_back(image.pixels);
  }
  std::sort(shapes.begin(), shapes.end());
  BOOST_TEST((std::adjacent_find(shapes.begin(), shapes.end()) == shapes.end()));
  Image small(10, 10), empty = small;
  Stroke_text("lines", height).draw(small, 3, 3);
  BOOST_TEST((small.pixels != empty.pixels));
  Stroke_text("outside", height).draw(empty, 10, 10);
  BOOST_TEST((empty.pixels == Image(10, 10).pixels));
  BOOST_TEST(Stroke_text("", height).width() == 0u);
  BOOST_TEST(Stroke_text("vertices", height).width() > Stroke_text("vertex", height).width());
}

BOOST_AUTO_TEST_CASE(clusters)
{
  const Workshop shop;
  shop.write("in.off", generated::torus(40, 24)); // vertices of four faces: clusters may meet at a point only
  shop.run_well("in.off out.off -n 70 --clusters clusters.ply");
  const std::string text = content_of(shop / "clusters.ply"), header = text.substr(0, text.find("end_header"));
  BOOST_TEST(header.find("property uint label\n") != std::string::npos);
  for (const char* channel : {"red", "green", "blue"})
    BOOST_TEST(header.find("property uchar " + std::string(channel) + "\n") != std::string::npos);

  Mesh mesh;
  std::ifstream is(shop / "clusters.ply", std::ios::binary);
  std::string comments;
  BOOST_REQUIRE(CGAL::IO::read_PLY(is, mesh, comments));
  BOOST_TEST(mesh.number_of_faces() == 960u);
  std::map<std::size_t, std::array<int, 3> > color_of_label;
  const auto color = mesh.add_property_map<Face, CGAL::IO::Color>("f:color").first;
  const auto label = mesh.add_property_map<Face, std::uint32_t>("f:label").first;
  const auto density = mesh.add_property_map<Face, double>("f:density").first;
  std::vector<double> expected(mesh.number_of_faces());
  CGAL::Surface_mesh_coarsening::compute_face_densities(
    mesh, boost::make_function_property_map<Face>([&](Face f) -> double& { return expected[f]; }));
  BOOST_TEST(*std::max_element(expected.begin(), expected.end()) == 10);
  for (Face f : mesh.faces()) {
    BOOST_TEST(label[f] < 70u);
    BOOST_TEST(density[f] == expected[f], boost::test_tools::tolerance(1e-12));
    const std::array<int, 3> rgb = {color[f].red(), color[f].green(), color[f].blue()};
    BOOST_TEST((color_of_label.emplace(label[f], rgb).first->second == rgb));
  }
  BOOST_TEST(color_of_label.size() == 70u);
  for (auto e : mesh.edges()) {
    const Face f = mesh.face(mesh.halfedge(e, 0)), g = mesh.face(mesh.halfedge(e, 1));
    BOOST_TEST(((label[f] == label[g]) == (color_of_label[label[f]] == color_of_label[label[g]])));
  }
}

BOOST_AUTO_TEST_CASE(picture)
{
  const Workshop shop;
  shop.write("in.off", generated::cube_grid(8)); // of quadrangles
  shop.run_well("in.off out.off -n 60 --picture picture.png");
  const std::string png = content_of(shop / "picture.png");
  BOOST_REQUIRE(png.size() > 1000u);
  BOOST_TEST(png.substr(1, 3) == "PNG");
  const auto number = [&png](std::size_t at) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = 256 * value + static_cast<unsigned char>(png[at + i]);
    return value;
  };
  BOOST_TEST(number(16) > 2 * number(20)); // three panels side by side
  shop.run_well("in.off out.off -n 60 --picture other.png --view -1,0.2,0.3 --up 0,0,1");
  BOOST_TEST((content_of(shop / "other.png") != png));
}

BOOST_AUTO_TEST_CASE(huge_and_tiny_coordinates)
{
  const Workshop shop;
  for (const double factor : {1e-300, 1e-160, 1e160, 1e307}) {
    shop.write("in.off", generated::scaled(generated::triangle_sphere(2), factor));
    shop.run_well("in.off out.off -n 30 --picture picture.png --report r.json");
    BOOST_TEST(shop.report("r.json")["certificate"]["kept"] == true);
  }
}

BOOST_AUTO_TEST_CASE(same_input_same_output)
{
  const Workshop shop;
  shop.write("in.off", generated::with_noise(generated::triangle_sphere(3), 0.01));
  for (const std::string run : {"1", "2"})
    shop.run_well("in.off o" + run + ".off -n 80 --clusters c" + run + ".ply --picture p" + run + ".png");
  BOOST_TEST((content_of(shop / "o1.off") == content_of(shop / "o2.off")));
  BOOST_TEST((content_of(shop / "c1.ply") == content_of(shop / "c2.ply")));
  BOOST_TEST((content_of(shop / "p1.png") == content_of(shop / "p2.png")));
}

BOOST_AUTO_TEST_CASE(messages_on_success)
{
  const Workshop shop;
  shop.write("in.off", generated::octahedron());
  const Outcome loud = shop.run("in.off out.off -n 5");
  BOOST_TEST(loud.status == 0);
  BOOST_TEST(std::count(loud.out.begin(), loud.out.end(), '\n') == 1);
  BOOST_TEST(loud.err.empty()); // no progress line without a terminal
  const Outcome quiet = shop.run("in.off out.off -n 5 --quiet");
  BOOST_TEST(quiet.status == 0);
  BOOST_TEST(quiet.out.empty());
  BOOST_TEST(quiet.err.empty());
}

BOOST_AUTO_TEST_CASE(number_of_vertices_out_of_reach)
{
  const Workshop shop;
  shop.write("in.off", generated::triangulated(generated::torus(20, 12)));
  for (const char* number : {"3", "100000"}) {
    const Outcome outcome = shop.run(std::string("in.off out.off -n ") + number);
    BOOST_TEST(outcome.status == 1);
    BOOST_TEST(outcome.is_one_line_error());
    const std::string lead = "nearest number that works: ";
    const std::size_t found = outcome.err.find(lead);
    BOOST_REQUIRE(found != std::string::npos);
    BOOST_TEST(!fs::exists(shop / "out.off"));
    const std::string nearest = std::to_string(std::stoul(outcome.err.substr(found + lead.size())));
    shop.run_well("in.off out.off -n " + nearest);
    BOOST_TEST(std::to_string(shop.mesh("out.off").number_of_vertices()) == nearest);
    fs::remove(shop / "out.off");
  }
}

// ---- choices that change the input first, and measuring ----

BOOST_AUTO_TEST_CASE(holes_are_filled)
{
  const Workshop shop;
  // 20 holes of one triangle each, and a large one: the upper end of the sphere.
  generated::Soup soup = generated::with_holes(generated::triangle_sphere(4), 20);
  const auto is_high = [&soup](const generated::Polygon& p) {
    return std::any_of(p.begin(), p.end(), [&soup](std::size_t v) { return soup.points[v][2] > 0.95; });
  };
  generated::Soup open = soup;
  open.polygons.erase(std::remove_if(open.polygons.begin(), open.polygons.end(), is_high), open.polygons.end());
  open = generated::without_isolated_vertices(open);
  shop.write("in.off", soup);
  shop.write("open.off", open);
  const std::size_t faces = soup.polygons.size();

  shop.run_well("in.off out.off -n 100 --report r.json");
  BOOST_TEST(shop.report("r.json")["input"]["holes"].is_null());
  BOOST_TEST(shop.report("r.json")["certificate"]["components"][0]["after"]["border_loops"] == 20);

  shop.run_well("in.off out.off -n 30 --fill-holes 0.6 --report r.json");
  Json report = shop.report("r.json");
  BOOST_TEST(report["parameters"]["fill_holes"] == 0.6);
  BOOST_TEST(report["input"]["faces"] == faces + 20);
  BOOST_TEST(report["input"]["polygons_in_file"] == faces);
  BOOST_TEST(report["input"]["holes"]["filled"] == 20);
  BOOST_TEST(report["input"]["holes"]["triangles_added"] == 20);
  BOOST_TEST(report["input"]["holes"]["left_because_longer"] == 0);
  BOOST_TEST(report["input"]["holes"]["not_filled"].empty());
  BOOST_REQUIRE(report["input"]["holes"]["all"].size() == 20u);
  for (const Json& hole : report["input"]["holes"]["all"]) {
    BOOST_TEST(hole["edges"] == 3);
    BOOST_TEST(hole["length"] < 0.6);
    BOOST_TEST(hole["filled"] == true);
  }
  for (const char* when : {"before", "after"}) {
    BOOST_TEST(report["certificate"]["components"][0][when]["euler_characteristic"] == 2);
    BOOST_TEST(report["certificate"]["components"][0][when]["border_loops"] == 0);
  }
  BOOST_TEST(report["certificate"]["kept"] == true);
  BOOST_TEST(report["seconds"]["hole filling"].is_number());
  const Mesh closed = shop.mesh("out.off");
  BOOST_TEST(closed.number_of_vertices() + closed.number_of_faces() - closed.number_of_edges() == 2u);

  // Only short enough holes.
  shop.run_well("open.off out.off -n 80 --fill-holes 0.6 --report r.json");
  report = shop.report("r.json");
  BOOST_TEST(report["input"]["holes"]["left_because_longer"] == 1);
  BOOST_TEST(report["certificate"]["components"][0]["before"]["border_loops"] == 1);
  BOOST_TEST(report["certificate"]["components"][0]["after"]["euler_characteristic"] == 1);
  // The result names the lengths of the holes that are left.
  const Outcome in_percent = shop.run("open.off out.off -n 80 --fill-holes 18% --report r.json"); // 0.6 of a diagonal of 3.4
  const std::string left = " filled, 1 hole of length ";
  const std::size_t at = in_percent.out.find(left);
  BOOST_REQUIRE(at != std::string::npos);
  BOOST_TEST(std::stod(in_percent.out.substr(at + left.size())) > 18);
  BOOST_TEST(in_percent.out.find("% of the diagonal left") != std::string::npos);
  BOOST_TEST(shop.report("r.json")["input"]["holes"]["left_because_longer"] == 1);
  shop.run_well("open.off out.off -n 80 --fill-holes all --report r.json");
  BOOST_TEST(shop.report("r.json")["certificate"]["components"][0]["after"]["euler_characteristic"] == 2);
  shop.run_well("open.off out.off -n 80 --fill-holes 100 --report r.json");
  BOOST_TEST(shop.report("r.json")["certificate"]["components"][0]["after"]["euler_characteristic"] == 2);

  // Quadrilaterals around, and a hole that nothing can fill: the border of a single triangle.
  shop.write("tube.off", generated::tube(12, 5));
  shop.run_well("tube.off out.off -n 30 --fill-holes 10 --report r.json");
  BOOST_TEST(shop.report("r.json")["input"]["holes"]["filled"] == 2);
  BOOST_TEST(shop.report("r.json")["input"]["holes"]["triangles_added"] == 20);
  BOOST_TEST(shop.report("r.json")["certificate"]["components"][0]["after"]["euler_characteristic"] == 2);
  shop.write("triangle.off", generated::single_triangle());
  shop.run_well("triangle.off out.off -n 3 --fill-holes 10 --report r.json");
  const Json not_filled = shop.report("r.json")["input"]["holes"]["not_filled"];
  BOOST_REQUIRE(not_filled.size() == 1u);
  BOOST_TEST(not_filled[0]["edges"] == 3);
  BOOST_TEST(std::abs(not_filled[0]["length"].get<double>() - 2 - std::sqrt(2.)) < 1e-12);
}

BOOST_AUTO_TEST_CASE(small_components_are_left_out)
{
  const Workshop shop;
  // A cube of side 2, and two of area 0.24 and 0.0024.
  const generated::Soup cube = generated::cube_grid(8);
  shop.write("in.off", generated::joined(generated::joined(generated::translated(generated::scaled(cube, 0.1), 5, 0, 0), cube),
                                         generated::translated(generated::scaled(cube, 0.01), 9, 0, 0)));
  shop.run_well("in.off out.off -n 60 --report r.json");
  BOOST_TEST(shop.report("r.json")["input"]["dropped_components"] == 0);
  shop.run_well("in.off out.off -n 60 --minimum-component-area 0.1 --report r.json");
  BOOST_TEST(shop.report("r.json")["input"]["dropped_components"] == 1);
  BOOST_TEST(shop.report("r.json")["certificate"]["components"].size() == 2u);

  const Outcome outcome =
    shop.run("in.off out.off -n 60 --minimum-component-area 20 --measure --clusters c.ply --picture p.png --report r.json");
  BOOST_TEST(outcome.status == 0, outcome.err);
  BOOST_TEST(outcome.out.find("2 components left out, topology kept, ") != std::string::npos, outcome.out);
  const Json report = shop.report("r.json"), &certificate = report["certificate"];
  BOOST_TEST(report["parameters"]["minimum_component_area"] == 20.);
  BOOST_TEST(report["input"]["dropped_components"] == 2);
  BOOST_TEST(report["input"]["faces"] == 384);
  BOOST_TEST(certificate["kept"] == true);
  BOOST_REQUIRE(certificate["components"].size() == 1u);
  BOOST_TEST(certificate["components"][0]["before"]["faces"] == 384);
  BOOST_TEST(certificate["components"][0]["after"]["vertices"] == 60);
  BOOST_TEST(report["quality"]["diagonal"].get<double>() < 3.5); // of the remaining components

  const Outcome all = shop.run("in.off out.off -n 60 --minimum-component-area 25");
  BOOST_TEST(all.status == 1);
  BOOST_TEST(all.is_one_line_error());
  BOOST_TEST(all.names("no component"), all.err);
}

BOOST_AUTO_TEST_CASE(subdivision)
{
  const Workshop shop;
  shop.write("in.off", generated::cube_grid(3)); // 56 vertices
  const Outcome refused = shop.run("in.off out.off -n 200");
  BOOST_TEST(refused.status == 1);
  BOOST_TEST(refused.is_one_line_error());
  shop.run_well("in.off out.off -n 200 --subdivide --report r.json");
  const Json report = shop.report("r.json");
  BOOST_TEST(report["parameters"]["subdivide"] == true);
  BOOST_TEST(report["clustering"]["clusters"] == 200);
  BOOST_TEST(report["certificate"]["kept"] == true);
  BOOST_TEST(shop.mesh("out.off").number_of_vertices() == 200u);
  BOOST_TEST(shop.mesh("out.off").number_of_faces() == 396u);
}

BOOST_AUTO_TEST_CASE(features)
{
  const Workshop shop;
  shop.write("in.off", generated::cube_grid(6));
  for (const char* arguments :
       {"in.off out.off -n 40 --report r.json --features", "--features in.off out.off -n 40 --report r.json",
        "--features 30 in.off out.off -n 40 --report r.json", "in.off out.off --features=30 -n 40 --report r.json"}) {
    shop.run_well(arguments);
    const Json report = shop.report("r.json");
    BOOST_TEST(report["parameters"]["features"] == 30);
    BOOST_TEST(report["clustering"]["feature_lines"] == 12);
    BOOST_TEST(report["clustering"]["feature_corners"] == 8);
    BOOST_TEST(report["certificate"]["kept"] == true);
  }
  shop.run_well("in.off out.off -n 40 --report r.json");
  BOOST_TEST(shop.report("r.json")["parameters"]["features"].is_null());
  BOOST_TEST(shop.report("r.json")["clustering"]["feature_lines"] == 0);
  const Outcome few = shop.run("in.off out.off -n 7 --features");
  BOOST_TEST(few.status == 1);
  BOOST_TEST(few.names("8"), few.err);
}

BOOST_AUTO_TEST_CASE(measuring)
{
  const Workshop shop;
  shop.write("flat.off", generated::triangulated(generated::grid(30, 30)));
  const Outcome flat = shop.run("flat.off out.off -n 60 --measure --report r.json");
  BOOST_TEST(flat.status == 0);
  for (const char* name : {"distance:", "border distance:", "input to result:", "result to input:", "normal deviation:",
                           "smallest angles:", "self-intersections: 0"})
    BOOST_TEST(flat.out.find(name) != std::string::npos, name);
  Json quality = shop.report("r.json")["quality"];
  BOOST_TEST(std::abs(quality["diagonal"].get<double>() - 30 * std::sqrt(2.)) < 1e-9);
  for (const char* what : {"distance_percent", "border_distance_percent"}) // a square remains a square
    for (const char* which : {"rms", "mean", "maximum"})
      BOOST_TEST(quality[what][which].get<double>() < 1e-6);
  for (const char* which : {"rms", "mean", "maximum"}) {
    double larger[2] = {0, 0};
    for (const char* side : {"from_input", "from_output"}) {
      larger[0] = (std::max)(larger[0], quality[side]["distance_percent"][which].get<double>());
      larger[1] = (std::max)(larger[1], quality[side]["normal_deviation_degrees"][which].get<double>());
    }
    BOOST_TEST(larger[0] == quality["distance_percent"][which].get<double>());
    BOOST_TEST(larger[1] == quality["normal_deviation_degrees"][which].get<double>());
    BOOST_TEST(larger[1] < 1e-4);
  }
  BOOST_TEST(quality["smallest_angle_degrees"]["mean"].get<double>() > 30);
  BOOST_TEST(quality["smallest_angle_degrees"]["least"] <= quality["smallest_angle_degrees"]["mean"]);
  BOOST_TEST(quality["self_intersections"] == 0);

  shop.write("sphere.off", generated::triangle_sphere(4));
  const Outcome sphere = shop.run("sphere.off out.off -n 60 --placement centroid --measure --report r.json");
  BOOST_TEST(sphere.out.find("border") == std::string::npos);
  quality = shop.report("r.json")["quality"];
  BOOST_TEST(quality["border_distance_percent"].is_null());
  BOOST_TEST(quality["distance_percent"]["rms"].get<double>() > 0.5); // the centroids lie within the sphere
  BOOST_TEST(quality["distance_percent"]["mean"] <= quality["distance_percent"]["rms"]);
  BOOST_TEST(quality["distance_percent"]["rms"] <= quality["distance_percent"]["maximum"]);
  BOOST_TEST(shop.run("sphere.off out.off -n 60 --measure --quiet").out.empty());
  shop.run_well("sphere.off out.off -n 60 --report r.json");
  BOOST_TEST(shop.report("r.json")["quality"].is_null());
}

// ---- inputs that are no manifolds ----

BOOST_AUTO_TEST_CASE(faulty_input_is_named)
{
  const Workshop shop;
  const generated::Soup good = generated::octahedron();
  const auto expect = [&shop](const generated::Soup& soup, const std::string& message) {
    shop.write("in.off", soup);
    const Outcome outcome = shop.run("in.off out.off -n 4");
    BOOST_TEST(outcome.status == 1);
    BOOST_TEST(outcome.is_one_line_error());
    BOOST_TEST(outcome.names("in.off"), outcome.err);
    BOOST_TEST(outcome.names("--repair"), outcome.err);
    BOOST_TEST(outcome.names(message), outcome.err);
    BOOST_TEST(!fs::exists(shop / "out.off"));
  };

  generated::Soup soup = good;
  std::swap(soup.polygons[3][0], soup.polygons[3][1]);
  expect(soup, "are oriented against each other along the edge between the vertices");

  soup = good;
  soup.polygons.push_back(soup.polygons[2]);
  expect(soup, "is shared by 3 faces (");

  soup = good;
  soup.polygons[5][2] = soup.polygons[5][0];
  expect(soup, "face 5 uses vertex " + std::to_string(good.polygons[5][0]));

  soup = good;
  soup.polygons.push_back({0, 1});
  expect(soup, "face 8 has only 2 vertices");

  soup = good; // a second octahedron that touches a vertex of the first
  for (const auto& p : good.points)
    soup.points.push_back({p[0] + 2, p[1], p[2]});
  const auto at = [&soup](double x) {
    const auto found = std::find(soup.points.begin(), soup.points.end(), generated::Point{x, 0, 0});
    return static_cast<std::size_t>(found - soup.points.begin());
  };
  const std::size_t tip = at(1), n = good.points.size();
  for (auto polygon : good.polygons) {
    for (std::size_t& v : polygon)
      v = good.points[v] == generated::Point{-1, 0, 0} ? tip : v + n;
    soup.polygons.push_back(polygon);
  }
  expect(soup, "the faces around vertex " + std::to_string(tip) + " at (1, 0, 0) form 2 groups");

  expect(generated::moebius_strip(12), "are oriented against each other");
}

BOOST_AUTO_TEST_CASE(faulty_numbers_are_named)
{
  const Workshop shop;
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
                             "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  shop.write("in.ply", header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
  BOOST_TEST(shop.run("in.ply out.off -n 3").names("face 0 names a vertex that is not there"));
  shop.write("in.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 nan 0\nendloop\n"
                       "endfacet\nendsolid\n");
  const Outcome outcome = shop.run("in.stl out.off -n 3");
  BOOST_TEST(outcome.status == 1);
  BOOST_TEST(outcome.is_one_line_error());
}

// The count of each step of the repair.
std::map<std::string, int> steps(const Json& report)
{
  std::map<std::string, int> result;
  for (const Json& step : report["input"]["repair"])
    result[step["action"].get<std::string>()] += step["count"].get<int>();
  return result;
}

BOOST_AUTO_TEST_CASE(repair)
{
  const Workshop shop;
  generated::Soup soup = generated::triangle_sphere(2);
  const std::size_t vertices = soup.points.size();
  std::swap(soup.polygons[3][0], soup.polygons[3][1]); // turned
  soup.polygons.push_back(soup.polygons[7]);           // repeated
  soup.polygons.push_back({0, 0, 1});                  // degenerate
  soup.points.push_back({9, 9, 9});                    // unused
  soup.points.push_back(soup.points[soup.polygons[0][0]]);
  soup.polygons[0][0] = soup.points.size() - 1; // torn off
  shop.write("in.off", soup);
  BOOST_TEST(shop.run("in.off out.off -n 40").status == 1);
  const Outcome outcome = shop.run("in.off out.off -n 40 --repair --report r.json");
  BOOST_TEST(outcome.status == 0);
  BOOST_TEST(outcome.err == "coarsen_mesh: warning: in.off: the repair removed repeated faces and faces without three different "
                            "vertices (2)\n");
  BOOST_TEST(outcome.out.find("topology kept (that of the repaired input), ") != std::string::npos, outcome.out);
  const Json report = shop.report("r.json");
  BOOST_TEST(report["warnings"].size() == 1u);
  BOOST_TEST(report["input"]["vertices"] == vertices);
  BOOST_TEST(report["certificate"]["components"][0]["before"]["euler_characteristic"] == 2);
  BOOST_TEST(report["seconds"]["repair"].is_number());
  std::map<std::string, int> done = steps(report);
  BOOST_TEST(done["merged coincident points"] == 1);
  BOOST_TEST(done["reversed faces"] >= 1);
  BOOST_TEST(done["removed unused points"] == 1);
  BOOST_TEST(done["removed repeated faces and faces without three different vertices"] == 2);

  // Separate triangles are stitched, a degenerate one is removed.
  generated::Soup torn;
  for (const auto& polygon : generated::triangle_sphere(2).polygons) {
    for (std::size_t v : polygon)
      torn.points.push_back(soup.points[v]);
    torn.polygons.push_back({torn.points.size() - 3, torn.points.size() - 2, torn.points.size() - 1});
  }
  shop.write("torn.off", torn);
  const Outcome refused = shop.run("torn.off out.off -n 40");
  BOOST_TEST(refused.is_one_line_error());
  BOOST_TEST(refused.names("vertices of its border coincide, which --repair merges"), refused.err);
  shop.run_well("torn.off out.off -n 40 --repair");
  BOOST_TEST(shop.mesh("out.off").number_of_faces() == 76u);

  generated::Soup flat = generated::grid(4, 4);
  flat = generated::triangulated(flat);
  const auto edge = flat.polygons[0]; // its first edge gets a vertex in the middle, and a triangle without area
  const auto &a = flat.points[edge[0]], &b = flat.points[edge[1]];
  flat.points.push_back({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2});
  const std::size_t middle = flat.points.size() - 1;
  flat.polygons[0] = {edge[0], middle, edge[2]};
  flat.polygons.push_back({middle, edge[1], edge[2]});
  flat.polygons.push_back({edge[0], edge[1], middle});
  shop.write("flat.off", flat);
  BOOST_TEST(shop.run("flat.off out.off -n 8 --repair --report r.json").err ==
             "coarsen_mesh: warning: flat.off: the repair removed degenerate faces (1)\n");
  done = steps(shop.report("r.json"));
  BOOST_TEST(done["removed degenerate faces"] == 1);

  // Non-orientable surfaces are cut.
  shop.write("strip.off", generated::moebius_strip(20));
  BOOST_TEST(shop.run("strip.off out.off -n 8 --repair --report r.json").names("the repair duplicated points"));
  BOOST_TEST(shop.report("r.json")["certificate"]["components"][0]["before"]["border_loops"] == 1);
  BOOST_TEST(shop.report("r.json")["certificate"]["components"][0]["before"]["euler_characteristic"] == 1);

  // A valid input does not change.
  shop.write("sound.off", generated::cube_grid(3));
  shop.run_well("sound.off out.off -n 20 --repair --report r.json");
  BOOST_TEST(shop.report("r.json")["input"]["repair"].empty());
}

// A hull with a deck: three faces at each edge of the deck's border.
BOOST_AUTO_TEST_CASE(repair_names_what_it_separates)
{
  const Workshop shop;
  generated::Soup hull = generated::cube_grid(6);
  const auto vertex = [&hull](int i, int j) {
    const generated::Point p = {i / 3. - 1, j / 3. - 1, 0};
    const auto found = std::find_if(hull.points.begin(), hull.points.end(), [&p](const generated::Point& q) {
      return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]) < 0.1;
    });
    const std::size_t v = std::size_t(found - hull.points.begin());
    if (found == hull.points.end())
      hull.points.push_back(p);
    return v;
  };
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      hull.polygons.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
  shop.write("in.off", hull);
  BOOST_TEST(shop.run("in.off out.off -n 60").names("--repair may help"));
  const Outcome outcome = shop.run("in.off out.off -n 60 --repair --report r.json");
  BOOST_TEST(outcome.status == 0);
  BOOST_TEST(outcome.names("warning: in.off: the repair duplicated "), outcome.err);
  BOOST_TEST(outcome.names("warning: in.off: the repair separated connected components from others (2)\n"), outcome.err);
  BOOST_TEST(shop.report("r.json")["certificate"]["components"].size() == 3u);
  BOOST_TEST(shop.run("in.off out.off -n 60 --repair --quiet").err.empty());
}

// Corners that nearly coincide.
BOOST_AUTO_TEST_CASE(welding)
{
  const Workshop shop;
  const generated::Soup whole = generated::triangle_sphere(2);
  generated::Soup torn;
  for (const auto& polygon : whole.polygons)
    for (const std::size_t v : polygon) {
      torn.points.push_back(whole.points[v]);
      torn.points.back()[0] += 1e-6 * double(torn.points.size() % 3);
      if (torn.points.size() % 3 == 0)
        torn.polygons.push_back({torn.points.size() - 3, torn.points.size() - 2, torn.points.size() - 1});
    }
  shop.write("in.off", torn);
  for (const std::string repair : {"", " --repair"}) {
    const Outcome refused = shop.run("in.off out.off -n 40" + repair);
    BOOST_TEST(refused.status == 1);
    BOOST_TEST(refused.is_one_line_error());
    BOOST_TEST(refused.names(std::to_string(torn.polygons.size()) + " connected components, needs"), refused.err);
  }
  BOOST_TEST(shop.run("in.off out.off -n 40 --repair").names("--weld T"));
  shop.run_well("in.off out.off -n 40 --weld 1e-5 --report r.json");
  BOOST_TEST(shop.report("r.json")["input"]["vertices"] == whole.points.size());
  BOOST_TEST(shop.report("r.json")["parameters"]["weld"] == 1e-5);
  BOOST_TEST(steps(shop.report("r.json"))["merged coincident points"] == torn.points.size() - whole.points.size());
  BOOST_TEST(shop.mesh("out.off").number_of_faces() == 76u);
}

BOOST_AUTO_TEST_CASE(debris_has_a_remedy)
{
  const Workshop shop;
  generated::Soup soup = generated::triangle_sphere(2);
  for (int i = 0; i < 5; ++i)
    soup = generated::joined(soup, generated::translated(generated::scaled(generated::tetrahedron(), 0.01), 3 + i, 0, 0));
  shop.write("in.off", soup);
  const Outcome refused = shop.run("in.off out.off -n 20");
  BOOST_TEST(refused.is_one_line_error());
  BOOST_TEST(refused.names("--minimum-component-area A leaves small components out"), refused.err);
  shop.run_well("in.off out.off -n 20 --minimum-component-area 0.1");
  shop.write("one.off", generated::torus(20, 12));
  BOOST_TEST(!shop.run("one.off out.off -n 4").names("--minimum"));
}

// A plate that is too thin for its vertices.
BOOST_AUTO_TEST_CASE(faults_that_are_left_are_named)
{
  const Workshop shop;
  shop.write("in.off", generated::thin_plate(16, 1e-3));
  const std::string arguments = "in.off out.off -n 200 --placement closest-vertex --report r.json";
  const Outcome outcome = shop.run(arguments);
  BOOST_TEST(outcome.status == 0);
  const Json report = shop.report("r.json"), &clustering = report["clustering"], &warnings = report["warnings"];
  const std::size_t pairs = clustering["self_intersections_left"], reversed = clustering["reversed_triangles_left"];
  BOOST_REQUIRE(pairs > 1u);
  BOOST_REQUIRE(reversed > 1u);
  BOOST_REQUIRE(warnings.size() == 3u);
  BOOST_TEST(warnings[0] == "out.off: " + std::to_string(pairs) + " pairs of triangles intersect where the input does not");
  BOOST_TEST(warnings[1] == "out.off: " + std::to_string(reversed) + " triangles are degenerate or reversed");
  const std::string narrow = warnings[2];
  BOOST_TEST(narrow.find(" triangles have an angle of less than 1 degree") != std::string::npos, narrow);
  BOOST_TEST(std::stoul(narrow.substr(narrow.find(' '))) < clustering["narrow_faces"].size());
  for (const Json& warning : warnings)
    BOOST_TEST(outcome.names("coarsen_mesh: warning: " + warning.get<std::string>() + "\n"), outcome.err);
  BOOST_TEST(shop.run(arguments + " --quiet").err.empty());
}

// ---- output files appear whole or not at all ----

BOOST_AUTO_TEST_CASE(nothing_is_left_after_a_failure)
{
  const Workshop shop;
  shop.write("in.off", generated::octahedron());
  shop.write("out.off", "old");
  fs::create_directory(shop / "folder");
  const std::vector<std::string> before = shop.files();
  for (const char* arguments :
       {"in.off out.off -n 5 --clusters c.ply --picture p.png --report missing/r.json",
        "in.off out.off -n 5 --clusters missing/c.ply --report r.json", "in.off missing/out.off -n 5 --report r.json",
        "in.off out.off -n 5 --clusters c.ply --report folder",
        "in.off out.off -n 1 --clusters c.ply --picture p.png --report r.json"}) {
    const Outcome outcome = shop.run(arguments);
    BOOST_TEST(outcome.status == 1, arguments);
    BOOST_TEST(outcome.is_one_line_error(), arguments);
    BOOST_TEST(shop.files() == before, boost::test_tools::per_element());
    BOOST_TEST(content_of(shop / "out.off") == "old");
  }
}

BOOST_AUTO_TEST_CASE(files_are_replaced)
{
  const Workshop shop;
  shop.write("in.off", generated::octahedron());
  shop.write("target.off", "old");
  fs::permissions(shop / "target.off", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("target.off", shop / "link.off");
  shop.run_well("in.off link.off -n 5 --report r.json");
  BOOST_TEST(fs::is_symlink(shop / "link.off"));
  BOOST_TEST(shop.mesh("target.off").number_of_vertices() == 5u);
  BOOST_TEST((fs::status(shop / "target.off").permissions() == (fs::perms::owner_read | fs::perms::owner_write)));

  // The input is replaced on request only, whatever its name.
  fs::create_hard_link(shop / "in.off", shop / "hard.off");
  fs::create_symlink("in.off", shop / "soft.off");
  for (const std::string output : {"in.off", "./in.off", "hard.off", "soft.off"}) {
    const Outcome outcome = shop.run("in.off " + output + " -n 4");
    BOOST_TEST(outcome.status == 2);
    BOOST_TEST(outcome.is_one_line_error());
    BOOST_TEST(outcome.names("--force"), outcome.err);
  }
  BOOST_TEST(shop.run("in.off . -n 4").names("--force"));
  BOOST_TEST(shop.run("in.off out.off -n 4 --force --report in.off").status == 2); // which is no mesh then
  BOOST_TEST(shop.mesh("in.off").number_of_vertices() == 6u);
  fs::remove(shop / "hard.off");
  fs::remove(shop / "soft.off");
  shop.run_well("in.off in.off -n 4 --force");
  BOOST_TEST(shop.mesh("in.off").number_of_vertices() == 4u);
  const std::vector<std::string> expected = {"in.off", "link.off", "r.json", "target.off"};
  BOOST_TEST(shop.files() == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(pipes_are_written_to)
{
  const Workshop shop;
  shop.write("in.off", generated::octahedron());
  BOOST_REQUIRE(mkfifo((shop / "pipe").c_str(), 0600) == 0);
  BOOST_REQUIRE(std::system(("cat " + quoted((shop / "pipe").string()) + " >" + quoted((shop / "copy").string()) +
                             " & echo $! >" + quoted((shop / "reader").string()))
                              .c_str()) == 0);
  shop.run_well("in.off out.off -n 5 --report pipe");
  BOOST_TEST(fs::is_fifo(shop / "pipe"));
  for (int waits = 0; waits < 100 && content_of(shop / "copy").find("seconds") == std::string::npos; ++waits)
    usleep(50000);
  BOOST_TEST(shop.report("copy")["output"]["vertices"] == 5);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
