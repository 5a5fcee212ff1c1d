// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/report.h"

#include "coarsening.h"

#include <CGAL/Surface_mesh_coarsening/version.h>

#include <CGAL/boost/graph/helpers.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace coarsen_mesh_tool {
namespace {

using Json = nlohmann::ordered_json;

Json counts_of(const Component_counts& c)
{
  return {{"vertices", c.vertices}, {"edges", c.edges},
          {"faces", c.faces},       {"euler_characteristic", c.euler_characteristic()},
          {"genus", c.genus()},     {"border_loops", c.border_loops}};
}

Json sizes_of(const std::string& file, const Mesh& mesh)
{
  return {{"file", file},
          {"vertices", mesh.number_of_vertices()},
          {"edges", mesh.number_of_edges()},
          {"faces", mesh.number_of_faces()}};
}

Json input_of(const Options& options, const Input& input)
{
  Json result = sizes_of(options.input, input.mesh);
  result["points_in_file"] = input.points_in_file;
  result["polygons_in_file"] = input.polygons_in_file;
  result["unused_points_dropped"] = input.unused_points;
  result["dropped_components"] = input.dropped_components;
  result["repair"] = nullptr;
  if (options.repair) {
    result["repair"] = Json::array();
    for (const Repair_step& step : input.repairs)
      result["repair"].push_back({{"action", step.action}, {"count", step.count}});
  }
  return result;
}

Json parameters_of(const Options& options)
{
  Json result;
  result["vertices"] = options.vertices ? Json(*options.vertices) : Json();
  result["vertex_ratio"] = options.vertex_ratio ? Json(*options.vertex_ratio) : Json();
  result["neighborhood_level"] = options.neighborhood_level ? Json(*options.neighborhood_level) : Json();
  result["faces"] = options.faces ? Json(*options.faces) : Json();
  result["keep_small"] = options.keep_small;
  result["maximum_distance"] = options.maximum_distance ? Json(*options.maximum_distance) : Json();
  result["maximum_distance_is_relative"] = options.distance_is_relative;
  result["levels"] = options.levels;
  result["rounds"] = options.rounds ? Json(*options.rounds) : Json();
  result["convergence_tolerance"] = options.convergence_tolerance;
  result["energy"] = options.energy;
  result["weight"] = options.energy == default_energy() ? Json(options.weight) : Json();
  result["maximum_density"] = options.maximum_density;
  result["placement"] = options.placement;
  result["mean_angle"] = options.placement == default_placement() ? Json(options.mean_angle) : Json();
  result["paper"] = options.paper;
  result["error_feedback"] = options.error_feedback;
  result["features"] = options.features ? Json(*options.features) : Json();
  result["patches"] = options.patches.empty() ? Json() : Json(options.patches);
  result["keep"] = options.keep.empty() ? Json() : Json(options.keep);
  result["keep_borders"] = options.keep_borders;
  result["minimum_component_area"] = options.minimum_component_area;
  result["weld"] = options.weld;
  result["fill_holes"] = std::isfinite(options.fill_holes) ? Json(options.fill_holes) : Json("all");
  result["hole_length_is_relative"] = options.hole_length_is_relative;
  result["subdivide"] = options.subdivide;
  result["distances"] = options.distances;
  result["threads"] = {{"allowed", options.threads.value_or(max_threads())},
                       {"used", (std::min)(options.threads.value_or(max_threads()), max_threads())}};
  return result;
}

Json clustering_of(const CGAL::Surface_mesh_coarsening::Coarsening_report& report)
{
  return {{"level", report.level},
          {"seeds", report.seeds},
          {"clusters", report.clusters},
          {"splits", report.splits},
          {"merges", report.merges},
          {"rounds", report.rounds},
          {"moves", report.moves},
          {"tests", report.tests},
          {"initial_energy", report.initial_energy},
          {"final_energy", report.final_energy},
          {"converged", report.converged},
          {"subdivided_components", report.subdivided_components},
          {"refused_by_boundary_counts", report.refused_by_boundary_counts},
          {"refused_by_guarantee", report.refused_by_guarantee},
          {"exchanged_vertices", report.exchanged_vertices},
          {"self_intersections_found", report.intersections_found},
          {"self_intersections_left", report.intersections_left},
          {"intersecting_faces", report.intersecting_faces},
          {"narrow_faces", report.narrow_faces},
          {"clusterings", report.clusterings},
          {"reversed_triangles_found", report.reversals_found},
          {"reversed_triangles_left", report.reversals_left},
          {"feature_lines", report.feature_lines},
          {"feature_corners", report.feature_corners}};
}

Json certificate_of(const Certificate& certificate)
{
  Json components = Json::array();
  for (const auto& pair : certificate.components)
    components.push_back({{"before", counts_of(pair.before)},
                          {"after", pair.after ? counts_of(*pair.after) : Json()},
                          {"kept", pair.kept()}});
  return {{"kept", certificate.kept()},
          {"components_one_to_one", certificate.one_to_one},
          {"orientation_kept", certificate.orientation_kept()},
          {"components", components}};
}

Json holes_of(const std::optional<Hole_filling>& holes)
{
  if (!holes)
    return nullptr;
  const auto described = [](const Hole& hole) {
    return Json{{"vertex", hole.vertex}, {"edges", hole.edges}, {"length", hole.length}};
  };
  Json not_filled = Json::array(), all = Json::array();
  for (const Hole& hole : holes->holes) {
    all.push_back(described(hole));
    all.back()["filled"] = hole.state == Hole_state::FILLED;
    if (hole.state == Hole_state::NOT_FILLED)
      not_filled.push_back(described(hole));
  }
  return {{"filled", holes->number(Hole_state::FILLED)},
          {"triangles_added", holes->triangles_added},
          {"left_because_longer", holes->number(Hole_state::LONGER)},
          {"not_filled", not_filled},
          {"all", all}};
}

Json quality_of(const Mesh& result, const std::optional<Measured_quality>& quality)
{
  if (!quality)
    return nullptr;
  const Measured_quality& q = *quality;
  const auto distances = [&q](double rms, double mean, double maximum) {
    return Json{{"rms", percent(q, rms)}, {"mean", percent(q, mean)}, {"maximum", percent(q, maximum)}};
  };
  const auto error_of = [&](const CGAL::Surface_mesh_coarsening::Surface_error& e) {
    return Json{{"distance_percent", distances(e.rms_distance, e.mean_distance, e.maximum_distance)},
                {"normal_deviation_degrees",
                 {{"rms", e.rms_normal_deviation}, {"mean", e.mean_normal_deviation}, {"maximum", e.maximum_normal_deviation}}}};
  };
  const bool has_border = !CGAL::is_closed(result) && std::isfinite(q.border_rms_distance);
  return {{"diagonal", q.diagonal},
          {"distance_percent", distances(q.rms_distance, q.mean_distance, q.maximum_distance)},
          {"border_distance_percent", has_border ? distances(q.border_rms_distance, q.border_mean_distance,
                                                             q.border_maximum_distance)
                                                 : Json()},
          {"normal_deviation_degrees",
           {{"rms", q.rms_normal_deviation}, {"mean", q.mean_normal_deviation}, {"maximum", q.maximum_normal_deviation}}},
          {"from_input", error_of(q.from_mesh)},
          {"from_output", error_of(q.from_coarse)},
          {"smallest_angle_degrees",
           {{"mean", q.mean_smallest_angle}, {"least", q.smallest_angle}, {"part_below_30", q.part_below_30_degrees}}},
          {"self_intersections", q.self_intersections},
          {"self_intersections_of_input", q.self_intersections == 0 ? Json() : Json(q.self_intersections_of_input)}};
}

// With `measure`, includes the distances of each level.
Json levels_of(const Options& options, const Input& input, const Coarsening_result& result)
{
  Json levels = Json::array();
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    const Coarser_level& level = result.levels[i];
    Json description = sizes_of(level_file(options.output, i + 1), level.mesh);
    description["parents"] = level.parents;
    if (options.measure) {
      const auto q = CGAL::Surface_mesh_coarsening::measure_coarsening(input.mesh, level.mesh);
      description["distance_percent"] = {
        {"rms", percent(q, q.rms_distance)}, {"mean", percent(q, q.mean_distance)}, {"maximum", percent(q, q.maximum_distance)}};
    }
    levels.push_back(description);
  }
  return levels;
}

Json seconds_of(const Stage_times& times)
{
  Json result;
  for (const auto& stage : times.all())
    result[stage.first] = stage.second;
  result["total"] = times.total();
  return result;
}

} // namespace

std::string report_text(const Options& options, const Input& input, const Coarsening_result& result,
                        const Findings& findings, const Stage_times& times)
{
  Json report;
  report["program"] = "coarsen_mesh";
  report["version"] = CGAL_SURFACE_MESH_COARSENING_VERSION;
  report["input"] = input_of(options, input);
  report["input"]["holes"] = holes_of(findings.holes);
  report["parameters"] = parameters_of(options);
  report["clustering"] = clustering_of(result.report);
  report["clustering"]["vertices_on_features"] = result.vertices_on_features;
  report["output"] = sizes_of(options.output, result.mesh);
  report["output"]["distance_bound"] = result.distance_bound ? Json(*result.distance_bound) : Json();
  report["output"]["is_within_distance"] = result.distance_bound ? Json(result.is_within_distance) : Json();
  report["output"]["relative_distance_bound"] =
    result.distance_bound ? Json(*result.distance_bound / diagonal(input.mesh)) : Json();
  report["levels"] = levels_of(options, input, result);
  report["output"]["valid"] = !findings.fault;
  report["output"]["fault"] = findings.fault ? Json(*findings.fault) : Json();
  report["certificate"] = certificate_of(findings.certificate);
  report["quality"] = quality_of(result.mesh, findings.quality);
  report["warnings"] = findings.warnings;
  report["seconds"] = seconds_of(times);
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; // file names need not be UTF-8
}

} // namespace coarsen_mesh_tool
