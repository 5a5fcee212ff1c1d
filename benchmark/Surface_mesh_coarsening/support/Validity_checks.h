// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_BENCHMARK_VALIDITY_CHECKS_H
#define COARSENING_BENCHMARK_VALIDITY_CHECKS_H

#include "io/Mesh.h"
#include "Surface_certificate.h"

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/is_valid_clustering.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// Checks the result of one coarsening from the two meshes and the labels. All functions return the fault, or
// nothing.
namespace benchmark_support {

using coarsening_support::Face;
using coarsening_support::Halfedge;
using coarsening_support::Mesh;
using coarsening_support::Point;
using coarsening_support::Vertex;

typedef Surface_certificate::Polygons Polygons;

inline Polygons polygons_of(const Mesh& mesh)
{
  Polygons polygons;
  polygons.reserve(mesh.number_of_faces());
  for (Face f : mesh.faces()) {
    polygons.emplace_back();
    for (Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      polygons.back().push_back(v);
  }
  return polygons;
}

struct Examined_mesh
{
  std::string name;
  Mesh mesh;
  Polygons polygons;
  std::optional<Surface_certificate> certificate;

  // The mesh must not move: the certificate refers to the polygons.
  Examined_mesh(const std::string& name, const Mesh& m) : name(name), mesh(m), polygons(polygons_of(m))
  {
    certificate.emplace(polygons, mesh.number_of_vertices(), false);
  }
  Examined_mesh(const Examined_mesh&) = delete;
  Examined_mesh& operator=(const Examined_mesh&) = delete;
};

typedef Mesh::Property_map<Face, std::size_t> Labels;

inline std::string fault_of_components(const Examined_mesh& input, const Labels& labels,
                                       const Surface_certificate& output)
{
  const auto& before = input.certificate->components();
  const auto& after = output.components();
  if (after.size() != before.size())
    return std::to_string(after.size()) + " components instead of " + std::to_string(before.size());
  const std::size_t none = std::size_t(-1);
  std::vector<std::size_t> partner(before.size(), none);
  std::vector<bool> taken(after.size(), false);
  for (Face f : input.mesh.faces()) {
    const std::size_t b = input.certificate->component(input.polygons[f][0]), a = output.component(labels[f]);
    if (partner[b] == a)
      continue;
    if (partner[b] != none || taken[a])
      return "components were split or joined";
    partner[b] = a;
    taken[a] = true;
  }
  for (std::size_t b = 0; b < before.size(); ++b)
    if (!before[b].same_surface_as(after[partner[b]]))
      return "component " + std::to_string(b) + " has genus " + std::to_string(after[partner[b]].genus()) + " and " +
             std::to_string(after[partner[b]].loops) + " border loops instead of " +
             std::to_string(before[b].genus()) + " and " + std::to_string(before[b].loops);
  return {};
}

// Returns the clusters around a vertex in the interior, counterclockwise as the faces are oriented.
inline std::vector<std::size_t> clusters_around(const Mesh& mesh, const Labels& labels, Vertex v)
{
  std::vector<std::size_t> runs;
  const Halfedge first = mesh.halfedge(v);
  Halfedge h = first;
  do {
    if (mesh.is_border(h))
      return {};
    if (runs.empty() || runs.back() != labels[mesh.face(h)])
      runs.push_back(labels[mesh.face(h)]);
    h = mesh.prev(mesh.opposite(h));
  } while (h != first);
  if (runs.size() > 1 && runs.front() == runs.back())
    runs.pop_back();
  return runs;
}

// Where exactly three clusters meet, the output has to have their triangle with the same orientation. Labels of
// subdivided faces are not exact: clusters may seem to meet that do not. Most meetings are real only if clusters have
// several faces, so only a clear majority counts against a component.
inline std::string fault_of_orientation(const Examined_mesh& input, const Labels& labels, const Polygons& output,
                                        bool exact)
{
  std::vector<std::array<std::size_t, 3> > triangles;
  const auto add_to = [](auto& list, std::size_t a, std::size_t b, std::size_t c) {
    std::array<std::size_t, 3> t{a, b, c};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    list.push_back(t);
  };
  for (const auto& p : output)
    add_to(triangles, p[0], p[1], p[2]);
  std::sort(triangles.begin(), triangles.end());
  std::vector<std::size_t> votes_for(input.certificate->components().size(), 0), votes_against(votes_for);
  for (Vertex v : input.mesh.vertices()) {
    if (input.mesh.is_isolated(v))
      continue;
    const std::vector<std::size_t> runs = clusters_around(input.mesh, labels, v);
    if (runs.size() != 3 || runs[0] == runs[1] || runs[1] == runs[2] || runs[0] == runs[2])
      continue;
    std::vector<std::array<std::size_t, 3> > both;
    add_to(both, runs[0], runs[1], runs[2]);
    add_to(both, runs[0], runs[2], runs[1]);
    const bool straight = std::binary_search(triangles.begin(), triangles.end(), both[0]);
    const bool turned = std::binary_search(triangles.begin(), triangles.end(), both[1]);
    if (exact && (turned || !straight))
      return "the triangle of the clusters around vertex " + std::to_string(std::size_t(v)) +
             (turned ? " is turned" : " is missing");
    votes_for[input.certificate->component(v)] += straight;
    votes_against[input.certificate->component(v)] += turned;
  }
  for (std::size_t i = 0; i < votes_for.size(); ++i)
    if (votes_against[i] > 3 * votes_for[i] + 3)
      return "component " + std::to_string(i) + " is turned inside out";
  return {};
}

inline std::string fault_of_labels(const Examined_mesh& input, const Labels& labels, std::size_t number, bool exact)
{
  std::vector<bool> occurs(number, false);
  for (Face f : input.mesh.faces()) {
    if (labels[f] >= number)
      return "face " + std::to_string(std::size_t(f)) + " has label " + std::to_string(labels[f]);
    occurs[labels[f]] = true;
  }
  if (!exact)
    return {};
  const auto missing = std::find(occurs.begin(), occurs.end(), false);
  if (missing != occurs.end())
    return "no face has label " + std::to_string(missing - occurs.begin());
  return CGAL::Surface_mesh_coarsening::clustering_fault(input.mesh, labels);
}

// `keeps_order`: whether the faces keep their order. In another order, fans begin at other faces, and the clusters are not valid in
// the order of the mesh; then only the output is checked.
inline std::string fault_of_result(const Examined_mesh& input, const Labels& labels, std::size_t number,
                                   const Mesh& output,
                                   const CGAL::Surface_mesh_coarsening::Coarsening_report& report, bool keeps_order)
{
  if (output.number_of_vertices() != number || report.clusters != number)
    return std::to_string(output.number_of_vertices()) + " vertices instead of " + std::to_string(number);
  const Polygons triangles = polygons_of(output);
  const Surface_certificate certificate(triangles, number, true);
  if (!certificate.fault().empty())
    return certificate.fault();
  if (!output.is_valid(false))
    return "the halfedges of the output are inconsistent";
  const bool exact = report.subdivided_components == 0 && keeps_order;
  std::string fault = fault_of_labels(input, labels, number, exact);
  if (fault.empty())
    fault = fault_of_components(input, labels, certificate);
  if (fault.empty())
    fault = fault_of_orientation(input, labels, triangles, exact);
  if (!fault.empty())
    return fault;
  for (Vertex v : output.vertices()) {
    const Point& p = output.point(v);
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      return "vertex " + std::to_string(std::size_t(v)) + " has a coordinate that is not finite";
  }
  if (!std::isfinite(report.final_energy) || report.final_energy > report.initial_energy * (1 + 1e-12))
    return "the energy went from " + std::to_string(report.initial_energy) + " to " +
           std::to_string(report.final_energy);
  return {};
}

} // namespace benchmark_support

#endif // COARSENING_BENCHMARK_VALIDITY_CHECKS_H
