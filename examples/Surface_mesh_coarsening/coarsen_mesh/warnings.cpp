// SPDX-License-Identifier: GPL-3.0-or-later

#include "warnings.h"

#include "check/certificate.h"
#include "io/file_type.h"
#include "io/soup_properties.h"
#include "io/write_mesh.h"
#include "counted.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace coarsen_mesh_tool {
namespace {

// Lengths are divided by the largest of the edges', whose squares may not be numbers.
double smallest_angle(const Mesh& mesh, Face f)
{
  double smallest = CGAL_PI;
  for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
    const Vector a = mesh.point(mesh.source(h)) - mesh.point(mesh.target(h));
    const Vector b = mesh.point(mesh.target(mesh.next(h))) - mesh.point(mesh.target(h));
    const double u = std::hypot(a.x(), a.y(), a.z()), v = std::hypot(b.x(), b.y(), b.z());
    if (!(u > 0 && v > 0))
      return 0;
    const Vector normal = CGAL::cross_product(a / u, b / v);
    smallest = (std::min)(smallest, std::atan2(std::hypot(normal.x(), normal.y(), normal.z()), (a / u) * (b / v)));
  }
  return smallest;
}

void add_faults(const Options& options, const Coarsening_result& result, std::vector<std::string>& warnings)
{
  const auto& report = result.report;
  if (report.intersections_left > 0)
    warnings.push_back(options.output + ": " + counted(report.intersections_left, "pair") + " of triangles " +
                       (report.intersections_left == 1 ? "intersects" : "intersect") + " where the input does not");
  if (report.reversals_left > 0)
    warnings.push_back(options.output + ": " + counted(report.reversals_left, "triangle") +
                       (report.reversals_left == 1 ? " is" : " are") + " degenerate or reversed");
  constexpr double least_angle = CGAL_PI / 180;
  const std::size_t narrow =
    std::size_t(std::count_if(report.narrow_faces.begin(), report.narrow_faces.end(), [&](std::size_t f) {
      return smallest_angle(result.mesh, Face(Mesh::size_type(f))) < least_angle;
    }));
  if (narrow > 0)
    warnings.push_back(options.output + ": " + counted(narrow, "triangle") + (narrow == 1 ? " has" : " have") +
                       " an angle of less than 1 degree");
}

// Whether faces of the result have several materials.
bool has_materials(const Mesh& mesh)
{
  const Found_property<Face, std::string> material(mesh, material_property);
  return material && std::any_of(mesh.faces_begin(), mesh.faces_end(),
                                 [&](Face f) { return material.map[f] != material.map[*mesh.faces_begin()]; });
}

void add_losses(const Options& options, const Input& input, const Mesh& result, std::vector<std::string>& warnings)
{
  for (const std::string& field : input.left_out)
    warnings.push_back(options.input + ": " + field + " are not read");
  const std::string type = type_of(options, options.output);
  const std::string reason = is_own_file_type(type) ? ", the format " + upper_case(type) + " cannot hold them"
                                                    : ", Assimp does not write them as " + upper_case(type);
  for (const std::string& field : fields_without_room(result, type, input.notes))
    warnings.push_back(options.output + ": " + field + " are left out" + reason);
  if (type == "obj" && options.patches.empty() && has_materials(result))
    warnings.push_back(options.output + ": the lines between materials are not kept (--patches material keeps them)");
}

bool has_coincident_border_vertices(const Mesh& mesh)
{
  std::set<Point> points;
  std::size_t vertices = 0;
  for (const Vertex v : mesh.vertices())
    if (mesh.is_border(v)) {
      points.insert(mesh.point(v));
      ++vertices;
    }
  return points.size() < vertices;
}

} // namespace

std::vector<std::string> warnings_of(const Options& options, const Input& input, const Coarsening_result& result)
{
  std::vector<std::string> warnings;
  if (options.threads && *options.threads > max_threads())
    warnings.push_back("--threads " + std::to_string(*options.threads) + ": there is " + counted(max_threads(), "thread") +
                       " only, as the program is built without oneTBB");
  for (const Repair_step& step : input.repairs)
    if (step.needs_warning)
      warnings.push_back(options.input + ": the repair " + step.action + " (" + std::to_string(step.count) + ")");
  add_faults(options, result, warnings);
  add_losses(options, input, result.mesh, warnings);
  return warnings;
}

std::string remedy_for_components(const Options& options, const Mesh& input)
{
  if (mesh_components(input).counts.size() < 2)
    return "";
  if (!options.repair && has_coincident_border_vertices(input))
    return " (vertices of its border coincide, which --repair merges)";
  if (std::all_of(input.edges_begin(), input.edges_end(), [&](Edge e) { return input.is_border(e); }))
    return " (all faces are separate; --weld T repairs and merges vertices within the distance T of each other)";
  return " (--minimum-component-area A leaves small components out)";
}

} // namespace coarsen_mesh_tool
