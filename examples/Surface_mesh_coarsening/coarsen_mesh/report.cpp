// SPDX-License-Identifier: GPL-3.0-or-later

#include "report.h"

#include <CGAL/Surface_mesh_coarsening/version.h>

#include <nlohmann/json.hpp>

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
  result["neighborhood_level"] = options.neighborhood_level ? Json(*options.neighborhood_level) : Json();
  result["rounds"] = options.rounds ? Json(*options.rounds) : Json();
  result["weight"] = options.weight;
  result["maximum_density"] = options.maximum_density;
  result["placement"] = options.placement;
  result["threads"] = {{"allowed", options.threads}, {"used", 1}};
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
          {"subdivided_components", report.subdivided_components}};
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
          {"orientation_kept", certificate.orientation_kept},
          {"components", components}};
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
                        const std::optional<std::string>& fault, const Certificate& certificate,
                        const Stage_times& times)
{
  Json report;
  report["program"] = "coarsen_mesh";
  report["version"] = CGAL_SURFACE_MESH_COARSENING_VERSION;
  report["input"] = input_of(options, input);
  report["parameters"] = parameters_of(options);
  report["clustering"] = clustering_of(result.report);
  report["output"] = sizes_of(options.output, result.mesh);
  report["output"]["valid"] = !fault;
  report["output"]["fault"] = fault ? Json(*fault) : Json();
  report["certificate"] = certificate_of(certificate);
  report["seconds"] = seconds_of(times);
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; // file names need not be UTF-8
}

} // namespace coarsen_mesh_tool
