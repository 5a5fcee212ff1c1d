// SPDX-License-Identifier: GPL-3.0-or-later

#include "written.h"

#include "check/soup_fault.h"
#include "io/Failure.h"
#include "io/file_type.h"
#include "io/read_soup.h"
#include "io/write_mesh.h"
#include "Interruption.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace coarsen_mesh_tool {
namespace {

CGAL::Bbox_3 box_of(const Mesh& mesh)
{
  CGAL::Bbox_3 box;
  for (const Vertex v : mesh.vertices())
    box += mesh.point(v).bbox();
  return box;
}

double diagonal_of(const CGAL::Bbox_3& box) { return std::hypot(box.x_span(), box.y_span(), box.z_span()); }

double largest_coordinate(const CGAL::Bbox_3& box, int axis) { return (std::max)(std::abs(box.min(axis)), std::abs(box.max(axis))); }

// How far rounding to single precision can move a point in the box.
double single_precision_error(const CGAL::Bbox_3& box)
{
  double half_steps[3];
  for (int i = 0; i < 3; ++i) {
    const float x = float(largest_coordinate(box, i));
    half_steps[i] = (double(std::nextafter(x, std::numeric_limits<float>::infinity())) - x) / 2;
  }
  return std::hypot(half_steps[0], half_steps[1], half_steps[2]);
}

// The move to the origin helps only where most of the coordinates' digits are the same.
std::string remedy(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = box_of(mesh);
  const double most = (std::max)({largest_coordinate(box, 0), largest_coordinate(box, 1), largest_coordinate(box, 2)});
  return std::string("use .ply, .off or .obj, which keep all digits and tell vertices at one point apart") +
         (most > 2 * diagonal_of(box) ? ", or move the mesh to the origin" : "");
}

Soup read_back(const std::string& file, const std::string& type, const std::string& bytes)
{
  try {
    return parse_soup(bytes, type, Interruption::throw_if_requested);
  } catch (const Format_fault& e) { // of another library
    throw Failure(file, std::string("cannot be written: it cannot be read back: ") + e.what());
  }
}

// Whether a triangle whose coordinates take all digits of single precision comes back with fewer digits, as from formats that
// write six. Where it comes back turned, the vertices of a result are not found in a file.
bool has_fewer_digits(const std::string& file, const std::string& type)
{
  const std::vector<Point> points = {Point(-1.23456787e-3f, 0, 6000001.5f), Point(0, 123.456787f, 0), Point(1, 1, 0.333333343f)};
  Mesh mesh;
  mesh.add_face(mesh.add_vertex(points[0]), mesh.add_vertex(points[1]), mesh.add_vertex(points[2]));
  const Soup soup = read_back(file, type, mesh_bytes(mesh, type));
  double largest = 0;
  for (const Point& p : points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point& q : soup.points)
      nearest = (std::min)(nearest, CGAL::approximate_sqrt(CGAL::squared_distance(p, q) / (p - CGAL::ORIGIN).squared_length()));
    largest = (std::max)(largest, nearest);
  }
  constexpr double least_precision = 1e-3;
  return largest > 0 && largest < least_precision;
}

// The first two vertices at the same point, in words.
std::optional<std::string> coinciding_vertices(const Mesh& mesh, const std::string& type)
{
  const bool rounds = rounds_coordinates(mesh, type);
  const auto stored = [rounds](double x) { return rounds ? double(float(x)) : x; };
  std::map<Point, Vertex> met;
  for (const Vertex v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    const auto found = met.emplace(Point(stored(p.x()), stored(p.y()), stored(p.z())), v);
    if (!found.second)
      return "vertices " + std::to_string(std::size_t(found.first->second)) + " and " + std::to_string(std::size_t(v)) +
             " coincide";
  }
  return std::nullopt;
}

std::size_t faces_without_area(const Mesh& mesh)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Exact_kernel;
  const auto is_degenerate = [&mesh](Face f) {
    const Halfedge h = mesh.halfedge(f);
    const auto point = [&mesh](Halfedge g) {
      const Point& p = mesh.point(mesh.target(g));
      return Exact_kernel::Point_3(p.x(), p.y(), p.z());
    };
    return CGAL::collinear(point(h), point(mesh.next(h)), point(mesh.prev(h)));
  };
  return std::size_t(std::count_if(mesh.faces_begin(), mesh.faces_end(), is_degenerate));
}

} // namespace

bool stores_all_digits(const std::string& type) { return type == "off" || type == "obj" || type == "ply"; }

bool rounds_coordinates(const Mesh& mesh, const std::string& type)
{
  if (stores_all_digits(type))
    return false;
  const CGAL::Bbox_3 box = box_of(mesh);
  constexpr double most = (std::numeric_limits<float>::max)() / 2.; // beyond, a file is refused
  return largest_coordinate(box, 0) < most && largest_coordinate(box, 1) < most && largest_coordinate(box, 2) < most;
}

double move_to_stored_points(Mesh& mesh, const std::string& file, const std::string& type)
{
  if (is_own_file_type(type) || !has_fewer_digits(file, type))
    return 0;
  typedef CGAL::Search_traits_3<Kernel> Traits;
  typedef CGAL::Orthogonal_k_neighbor_search<Traits> Search;
  Mesh bare = mesh;
  bare.remove_all_property_maps();
  const Soup soup = read_back(file, type, mesh_bytes(bare, type));
  Search::Tree tree(soup.points.begin(), soup.points.end());
  std::vector<Point> points;
  double largest = 0;
  for (const Vertex v : mesh.vertices()) {
    const Search search(tree, mesh.point(v), 1);
    if (search.begin() == search.end())
      break;
    points.push_back(search.begin()->first);
    largest = (std::max)(largest, std::sqrt(search.begin()->second));
  }
  if (std::set<Point>(points.begin(), points.end()).size() != mesh.number_of_vertices())
    throw Failure(file, "cannot be written: the numbers of the format " + upper_case(type) + " put several of the " +
                          std::to_string(mesh.number_of_vertices()) + " vertices to one point (" + remedy(mesh) + ")");
  for (const Vertex v : mesh.vertices())
    mesh.point(v) = points[std::size_t(v)];
  return largest;
}

std::string rounding_text(const Mesh& mesh, const std::string& type, double moved)
{
  if (stores_all_digits(type))
    return "";
  constexpr double visible_part = 1e-4; // of the diagonal: distances of results are given in hundredths of a percent
  const CGAL::Bbox_3 box = box_of(mesh);
  const double error = moved + single_precision_error(box);
  if (!(error > visible_part * diagonal_of(box)))
    return "";
  char lengths[64];
  std::snprintf(lengths, sizeof lengths, "%.2g (%.2g %% of the diagonal)", error, 100 * error / diagonal_of(box));
  const std::size_t flat = faces_without_area(mesh);
  return "the numbers of the format " + upper_case(type) + " move vertices by up to " + lengths +
         (flat > 0 ? ", and " + std::to_string(flat) + (flat == 1 ? " face has" : " faces have") + " no area" : "") + " (" +
         remedy(mesh) + ")";
}

void check_written(const std::string& file, const std::string& type, const std::string& bytes, const Mesh& mesh)
{
  const Soup soup = read_back(file, type, bytes);
  std::optional<std::string> fault = soup_fault(soup);
  if (soup.points.size() != mesh.number_of_vertices() || soup.polygons.size() != mesh.number_of_faces()) {
    const std::optional<std::string> coinciding = coinciding_vertices(mesh, type);
    fault = "its " + std::to_string(mesh.number_of_vertices()) + " vertices are at " + std::to_string(soup.points.size()) +
            " different points only" + (coinciding ? ", " + *coinciding : "");
  }
  if (fault)
    throw Failure(file, "cannot be written: as numbers of the format " + upper_case(type) + " can tell, the result is no surface: " +
                          *fault + (stores_all_digits(type) ? "" : " (" + remedy(mesh) + ")"));
}

} // namespace coarsen_mesh_tool
