// SPDX-License-Identifier: GPL-3.0-or-later

#include "run_and_report.h"

#include "check/certificate.h"
#include "io/Failure.h"
#include "io/Output_files.h"
#include "io/file_type.h"
#include "io/write_mesh.h"
#include "render/cluster_bytes.h"
#include "render/picture.h"
#include "repair/fill_holes.h"
#include "report/Stage_times.h"
#include "report/quality.h"
#include "report/report.h"
#include "Interruption.h"
#include "Options.h"
#include "Progress_line.h"
#include "Tool_visitor.h"
#include "coarsening.h"
#include "input.h"

#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/assertions_behaviour.h>

#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace coarsen_mesh_tool {
namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;

Coarsening_result coarsen_or_explain(const Input& input, const Options& options, Stage_times& times,
                                     Progress_line& progress)
{
  Tool_visitor visitor(times, progress);
  try {
    Coarsening_result result = coarsen(input.mesh, options, visitor);
    times.end();
    return result;
  } catch (const SMC::Coarsening_cancelled&) {
    Interruption::throw_if_requested();
    throw;
  } catch (const SMC::Unreachable_number_of_vertices& e) {
    throw Failure(options.input,
                  one_line(e.what()) + " (nearest number that works: " + std::to_string(e.nearest()) + ")");
  } catch (const SMC::Invalid_input& e) {
    throw Failure(options.input, one_line(e.what()));
  }
}

std::string shown(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

std::string summary(const Options& options, const Input& input, const Coarsening_result& result,
                    const Findings& findings, const Stage_times& times)
{
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.2f s", times.total());
  const std::string dropped =
    input.unused_points > 0 ? ", " + std::to_string(input.unused_points) + " unused points dropped" : "";
  const std::size_t left_out = result.report.dropped_components;
  std::string remarks;
  if (findings.holes)
    remarks += std::to_string(findings.holes->filled) + " holes filled, ";
  if (result.distance_bound)
    remarks += "within a distance of " + shown(*result.distance_bound) + ", ";
  if (!result.levels.empty())
    remarks += std::to_string(result.levels.size()) + " levels, ";
  if (left_out > 0)
    remarks += std::to_string(left_out) + " components left out, ";
  return options.input + " (" + std::to_string(input.mesh.number_of_vertices()) + " vertices, " +
         std::to_string(input.mesh.number_of_faces()) + " faces" + dropped + ") -> " + options.output + " (" +
         std::to_string(result.mesh.number_of_vertices()) + " vertices, " +
         std::to_string(result.mesh.number_of_faces()) + " faces), " + std::to_string(result.report.rounds) +
         " rounds, " + remarks + (findings.certificate.kept() ? "topology kept, " : "topology changed, ") + seconds +
         (findings.quality ? "\n" + quality_text(result.mesh, *findings.quality) : "");
}

typedef std::vector<std::pair<std::string, std::string> > Files; // name and content

// Lets the files and the report appear, which is made last as it tells how long the others took.
void write_files(const Options& options, const Files& files, const std::function<std::string()>& make_report)
{
  Output_files outputs;
  {
    const Deferred_interruption deferred;
    Interruption::files_are_there();
    for (const auto& file : files)
      outputs.stage(file.first, file.second);
    const std::string report = make_report();
    if (!options.report.empty())
      outputs.stage(options.report, report);
  }
  Interruption::throw_if_requested();
  outputs.write_streams(Interruption::throw_if_requested);
  const Deferred_interruption deferred;
  Interruption::throw_if_requested();
  outputs.commit();
}

// Computes everything, and only then lets the files appear.
std::string run(const Options& options)
{
  Stage_times times;
  Progress_line progress(!options.quiet);
  Input input = read_input(options, times, progress);
  Findings findings;
  if (options.fill_holes > 0) {
    times.begin("hole filling");
    progress.say("filling holes");
    findings.holes = fill_holes(input.mesh, options.fill_holes);
    times.end();
  }
  const Coarsening_result result = coarsen_or_explain(input, options, times, progress);

  Interruption::throw_if_requested();
  times.begin("check");
  progress.say("checking the result");
  findings.fault = triangle_mesh_fault(result.mesh);
  for (const Coarser_level& level : result.levels)
    if (!findings.fault)
      findings.fault = triangle_mesh_fault(level.mesh);
  if (findings.fault)
    throw Failure(options.input, "the result is not a valid mesh and is not written: " + *findings.fault);
  findings.certificate = certify(input.mesh, result.labels, result.mesh, result.report.dropped_components,
                                result.report.subdivided_components == 0 && result.report.feature_lines == 0 &&
                                  result.report.feature_corners == 0);
  if (options.measure) {
    times.begin("measuring");
    progress.say("measuring");
    findings.quality = measure(input.mesh, result);
    Interruption::throw_if_requested();
  }

  Files files;
  if (!options.picture.empty()) {
    times.begin("picture");
    progress.say("rendering");
    files.emplace_back(options.picture,
                       picture_bytes(input.mesh, result.labels, result.mesh, options.view, options.up));
  }
  Interruption::throw_if_requested();
  times.begin("write");
  progress.say("writing");
  files.emplace_back(options.output, mesh_bytes(result.mesh, file_type(options.output), input.material_library));
  for (std::size_t i = 0; i < result.levels.size(); ++i)
    files.emplace_back(level_file(options.output, i + 1),
                       mesh_bytes(result.levels[i].mesh, file_type(options.output), input.material_library));
  if (!options.clusters.empty())
    files.emplace_back(options.clusters, cluster_bytes(input.mesh, result.labels));
  progress.end();
  write_files(options, files, [&] {
    times.end();
    return options.report.empty() ? "" : report_text(options, input, result, findings, times);
  });
  return summary(options, input, result, findings, times);
}

int complain(const std::string& what, int status)
{
  std::cerr << "coarsen_mesh: " << one_line(what) << (status == 2 ? " (see coarsen_mesh --help)" : "") << std::endl;
  return status;
}

} // namespace

int run_and_report(int argc, char* argv[])
{
  // CGAL's own messages span several lines; what they say arrives as an exception too.
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  CGAL::set_warning_handler([](const char*, const char*, const char*, int, const char*) {});
  std::string subject = "the command line";
  try {
    const auto options = read_options(argc, argv);
    if (!options) {
      std::cout.flush();
      return std::cout ? 0 : complain("standard output: cannot be written", 1);
    }
    subject = options->input;
    const std::string done = run(*options);
    if (!options->quiet)
      std::cout << done << std::endl;
    return 0;
  } catch (const Wrong_usage& e) {
    return complain(e.what(), 2);
  } catch (const Interrupted& e) {
    return complain(subject + ": " + e.what(), e.exit_status());
  } catch (const std::bad_alloc&) {
    return complain(subject + ": there is not enough memory", 1);
  } catch (const std::exception& e) {
    return complain(e.what(), 1);
  }
}

} // namespace coarsen_mesh_tool
