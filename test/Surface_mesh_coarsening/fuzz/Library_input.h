// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_FUZZ_LIBRARY_INPUT_H
#define CGAL_SURFACE_MESH_COARSENING_FUZZ_LIBRARY_INPUT_H

#include "Feature_marks.h"
#include "Fuzz_bytes.h"
#include "build_mesh.h"

#include "check/soup_fault.h"
#include "support/Reference_mesh.h"
#include "support/mesh_files.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Exact_maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Closest_vertex_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/compute_face_densities.h>
#include <CGAL/Surface_mesh_coarsening/is_valid_clustering.h>

#include <cmath>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// Converts bytes to a small mesh and parameters, and calls the library with them. Checks all promises of the library after
// each call, independently of the library.
namespace fuzz {

namespace SMC = CGAL::Surface_mesh_coarsening;
using generated::Soup;
using reference::Labels;

struct Parameters
{
  std::size_t number, level, rounds, weight;
  bool subdivide, own_densities, repair, marks_features;
  double feature_angle;

  bool has_features() const { return marks_features || feature_angle < 180; }
};

inline Parameters read_parameters(Bytes& bytes, std::size_t vertices)
{
  Parameters p;
  const std::size_t flags = bytes.next();
  p.weight = flags % 5;
  p.subdivide = flags >= 240;
  p.own_densities = flags / 5 % 4 == 3;
  const std::size_t more = bytes.next();
  p.rounds = more / 4 % 8 == 7 ? 1000 : more / 4 % 8;
  p.number = bytes.below(vertices + 3);
  const std::size_t features = bytes.next();
  p.repair = more % 4 == 3 && vertices < 50; // takes long on such irregular surfaces
  p.marks_features = features % 4 == 1;
  p.feature_angle = features % 4 == 2 ? 30 : 180;
  p.level = flags / 20 % 4 == 0 ? 1 + p.number % 8 : 0; // 0: use the number
  return p;
}

struct Result
{
  Mesh mesh;
  Soup output;
  Labels labels;
  std::vector<std::size_t> counts;
  std::optional<Feature_topology> features;
  SMC::Coarsening_report report;
};

struct Call
{
  const Mesh& mesh;
  const Parameters& parameters;
  const std::map<Mesh::Face_index, double>& densities;
  Feature_marks& marks;

  template <class Weight, class Placement, class Parameters_in>
  Result run_as(Mesh& output, std::size_t number, const Placement& placement, const Parameters_in& np) const
  {
    Result result;
    std::map<Mesh::Face_index, std::size_t> label_of;
    std::map<Mesh::Vertex_index, std::size_t> count_of;
    Feature_marks marks_of_output((Mesh()));
    const auto all = np.cluster_weight(Weight())
                       .vertex_placement(placement)
                       .number_of_iterations(parameters.rounds)
                       .subdivide_input(parameters.subdivide)
                       .repair_output(parameters.repair)
                       .feature_angle(parameters.feature_angle)
                       .edge_is_constrained_map(boost::make_assoc_property_map(marks.edges))
                       .vertex_is_constrained_map(boost::make_assoc_property_map(marks.vertices))
                       .face_patch_map(boost::make_assoc_property_map(marks.patches))
                       .face_cluster_map(boost::make_assoc_property_map(label_of))
                       .vertex_boundary_count_map(boost::make_assoc_property_map(count_of));
    const auto of_output =
      SMC::parameters::edge_is_constrained_map(boost::make_assoc_property_map(marks_of_output.edges))
        .vertex_is_constrained_map(boost::make_assoc_property_map(marks_of_output.vertices))
        .face_patch_map(boost::make_assoc_property_map(marks_of_output.patches));
    result.report = parameters.level == 0
                      ? SMC::coarsen_mesh(mesh, number, output, all, of_output)
                      : SMC::coarsen_mesh(mesh, output, all.neighborhood_level(parameters.level), of_output);
    for (const auto f : faces(mesh))
      result.labels.push_back(label_of.at(f));
    for (const auto v : vertices(mesh))
      result.counts.push_back(count_of.at(v));
    result.mesh = output;
    result.output = to_soup(output);
    if (parameters.marks_features)
      result.features = feature_topology(output, marks_of_output);
    return result;
  }

  template <class Weight, class Placement>
  Result run_with(Mesh& output, std::size_t number, const Placement& placement) const
  {
    // One type of map for both kinds of densities, which saves compile time.
    std::map<Mesh::Face_index, double> computed;
    if (!parameters.own_densities)
      SMC::compute_face_densities(mesh, boost::make_assoc_property_map(computed));
    const auto& used = parameters.own_densities ? densities : computed;
    return run_as<Weight>(output, number, placement,
                          SMC::parameters::face_density_map(boost::make_assoc_property_map(used)));
  }

  Result operator()(Mesh& output, std::size_t number) const
  {
    switch (parameters.weight) {
    case 0: return run_with<SMC::Uniform_weight>(output, number, SMC::Centroid_placement());
    case 1: return run_with<SMC::Weighted_area_weight>(output, number, SMC::Closest_vertex_placement());
    case 2: return run_with<SMC::Maximum_density_weight>(output, number, SMC::Centroid_placement());
    case 3: return run_with<SMC::Exact_maximum_density_weight>(output, number, SMC::Quadric_placement());
    default: return run_with<SMC::Density_variance_weight>(output, number, SMC::Fitted_placement());
    }
  }
};

inline bool equal(const Soup& a, const Soup& b)
{
  // Compares bits, since coordinates may be NaN.
  const auto same = [](const generated::Point& p, const generated::Point& q) {
    return std::memcmp(&p, &q, sizeof p) == 0;
  };
  return a.polygons == b.polygons && std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(), same);
}

inline std::string surface_fault(const Soup& soup)
{
  coarsening_support::Soup converted;
  for (const auto& p : soup.points)
    converted.points.emplace_back(p[0], p[1], p[2]);
  converted.polygons = coarsening_support::Polygons(soup.polygons);
  return coarsening_support::soup_fault(converted).value_or("");
}

inline void check_result(const Call& call, const Soup& soup, const Result& r, std::size_t number)
{
  const Mesh& mesh = call.mesh;
  const Parameters& p = call.parameters;
  require(r.output.points.size() == r.report.clusters, "the report has another number of clusters");
  if (p.level == 0)
    require(r.output.points.size() == number, "there are " + std::to_string(r.output.points.size()) +
                                                  " vertices instead of " + std::to_string(number));
  const std::string fault = surface_fault(r.output);
  require(fault.empty(), "the output is no surface: " + fault);
  require(r.report.final_energy <= r.report.initial_energy * (1 + 1e-6), "the energy has risen");
  require(std::isfinite(r.report.final_energy), "the energy is not finite");
  require(p.rounds < 1000 || r.report.converged, "it has not converged in 1000 rounds");
  if (!surface_fault(soup).empty())
    return;
  require(topologies(mesh) == topologies(r.mesh), "the topology has changed");
  if (r.features) {
    const Feature_topology features = feature_topology(mesh, call.marks);
    require(features.is_kept_in(*r.features),
            "features have changed from " + to_string(features) + " to " + to_string(*r.features));
  }
  if (r.report.subdivided_components == 0 && !p.subdivide && !p.has_features() && !has_double_edges(mesh)) {
    const reference::Reference_mesh m(soup);
    const std::string clustering = reference::fault_of_clustering(m, r.labels);
    require(clustering.empty(), "the clustering is not valid: " + clustering);
    require(reference::boundary_counts(m, r.labels) == r.counts, "the boundary counts are not right");
    std::map<Mesh::Face_index, std::size_t> label_of;
    std::size_t i = 0;
    for (const auto f : faces(mesh))
      label_of[f] = r.labels[i++];
    const auto map = boost::make_assoc_property_map(label_of);
    require(SMC::clustering_fault(mesh, map).empty(), "the library calls its own clustering invalid");
  }
}

// Returns whether the library has a reason to refuse the mesh or a density.
inline bool has_reason(const Mesh& mesh, const Soup& soup, const Parameters& p,
                const std::map<Mesh::Face_index, double>& densities)
{
  if (faces(mesh).begin() == faces(mesh).end() || !surface_fault(soup).empty())
    return true;
  if (p.own_densities)
    for (const auto& d : densities)
      if (!(d.second >= 1e-20 && d.second <= 1e20))
        return true;
  return false;
}

// Returns whether the call gave a result.
inline bool check_call(const Call& call, const Soup& soup, std::size_t number, bool is_second)
{
  const Soup old_output = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  Mesh output;
  add_to(output, old_output);
  std::optional<Result> result;
  std::optional<std::size_t> nearest;
  try {
    result = call(output, number);
  } catch (const SMC::Unreachable_number_of_vertices& e) {
    nearest = e.nearest();
    require(call.parameters.level == 0, std::string("a level gives: ") + e.what());
    require(!is_second, "the nearest number is refused: " + std::to_string(number) + ": " + e.what());
  } catch (const SMC::Invalid_input& e) {
    require(has_reason(call.mesh, soup, call.parameters, call.densities), std::string("refused: ") + e.what());
  }
  require(equal(to_soup(call.mesh), soup), "the input has changed");
  if (!result)
    require(equal(to_soup(output), old_output), "the output has changed though the call failed");
  if (nearest)
    check_call(call, soup, *nearest, true);
  if (!result)
    return false;
  check_result(call, soup, *result, number);
  if (!is_second) {
    Mesh again;
    const Result second = call(again, number);
    require(second.labels == result->labels && equal(second.output, result->output), "a second run gives another result");
  }
  return true;
}

// Prints the data of a finding.
inline void print(const Soup& soup, const Parameters& p)
{
  std::printf("# number %zu, level %zu, rounds %zu, weight %zu, subdivide %d, own densities %d, repair %d, marks %d, "
              "angle %g\n", p.number, p.level, p.rounds, p.weight, p.subdivide, p.own_densities,
              p.repair, p.marks_features, p.feature_angle);
  std::printf("%s", mesh_files::off(soup).c_str());
  std::fflush(stdout);
}

// A mesh and all parameters of a call except the number of vertices.
struct Library_input
{
  Mesh mesh;
  Soup soup;
  Parameters parameters;
  std::map<Mesh::Face_index, double> densities;
  Feature_marks marks;

  // The first four bytes are the parameters, the others the mesh, densities and features.
  Library_input(const std::uint8_t* data, std::size_t size) : marks((Mesh()))
  {
    constexpr std::size_t parameters_at = 4;
    Bytes bytes(data, size), head(data, (std::min)(size, parameters_at));
    for (std::size_t i = 0; i < parameters_at; ++i)
      bytes.next();
    mesh = build_mesh(bytes);
    soup = to_soup(mesh);
    parameters = read_parameters(head, soup.points.size());
    const int bad = bytes.next() == 7;
    for (const auto f : faces(mesh))
      densities[f] = bad && densities.size() == 2 ? -1. : std::pow(10., double(bytes.next() % 13) - 6);
    marks = Feature_marks(mesh);
    if (parameters.marks_features)
      marks.mark(bytes);
  }

  bool check(std::size_t number) { return check_call({mesh, parameters, densities, marks}, soup, number, false); }
};

} // namespace fuzz

#endif // CGAL_SURFACE_MESH_COARSENING_FUZZ_LIBRARY_INPUT_H
