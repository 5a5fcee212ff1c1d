// SPDX-License-Identifier: GPL-3.0-or-later

#include "run_and_report.h"

#include "check/certificate.h"
#include "io/Descriptor.h"
#include "io/Failure.h"
#include "io/Number_property.h"
#include "io/Output_files.h"
#include "io/file_type.h"
#include "io/write_mesh.h"
#include "io/write_obj.h"
#include "render/cluster_bytes.h"
#include "render/face_distances.h"
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
#include "counted.h"
#include "input.h"
#include "warnings.h"
#include "written.h"

#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/assertions_behaviour.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <poll.h>
#include <unistd.h>

namespace coarsen_mesh_tool {
namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;

std::string shown(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

// Rounds up: `unit` times the number that is read back is at least `distance`, which can be asked for.
std::string shown_above(double distance, double unit)
{
  double x = distance / unit;
  std::string text = shown(x);
  while (std::strtod(text.c_str(), nullptr) * unit < distance) {
    const double last_digit = std::pow(10, std::floor(std::log10(x)) - 3);
    x = (std::max)(x + last_digit, std::nextafter(x, std::numeric_limits<double>::infinity()));
    text = shown(x);
  }
  return text;
}

// A distance that holds, in the unit of the mesh, and before it in the requested unit if that is another.
std::string length_text(const Options& options, const Mesh& mesh, double distance)
{
  return options.distance_is_relative
           ? shown_above(distance, diagonal(mesh)) + " of the diagonal (" + shown_above(distance, 1) + ")"
           : shown_above(distance, 1);
}

std::string distance_text(const Options& options, const std::string& length)
{
  return (options.distance_is_relative ? "within " : "within a distance of ") + length;
}

std::string requested_distance_text(const Options& options, const Mesh& mesh)
{
  const double asked = *options.maximum_distance;
  return distance_text(options, options.distance_is_relative
                                  ? shown(asked) + " of the diagonal (" + shown(asked * diagonal(mesh)) + ")"
                                  : shown(asked));
}

// Why a distance was not reached.
std::string unreachable_text(const Options& options, const Mesh& mesh, double nearest)
{
  const std::string rounding = rounding_text(mesh, type_of(options, options.output), 0);
  return "no result " + requested_distance_text(options, mesh) +
         " was found (nearest distance found: " + length_text(options, mesh, nearest) +
         (!rounding.empty()   ? "): " + rounding
          : options.subdivide ? ")"
                              : "; smaller faces, which --subdivide makes, may come nearer)");
}

// Returns what `use` does with a visitor, or throws Failure with the reason why it could not.
template <class Use>
auto explained(const Input& input, const Options& options, Stage_times& times, Progress_line& progress, const Use& use)
{
  Tool_visitor visitor(times, progress);
  try {
    auto result = use(visitor);
    times.end();
    return result;
  } catch (const SMC::Coarsening_cancelled&) {
    Interruption::throw_if_requested();
    throw;
  } catch (const SMC::Unreachable_distance& e) {
    throw Failure(options.input, unreachable_text(options, input.mesh, e.nearest()));
  } catch (const SMC::Unreachable_number_of_vertices& e) {
    const double asked =
      options.vertices ? double(*options.vertices) : options.vertex_ratio.value_or(0) * double(input.mesh.number_of_vertices());
    throw Failure(options.input, one_line(e.what()) + " (nearest number that works: " + std::to_string(e.nearest()) + ")" +
                                   (asked < double(e.nearest()) ? remedy_for_components(options, input.mesh) : ""));
  } catch (const SMC::Invalid_input& e) {
    throw Failure(options.input, one_line(e.what()));
  }
}

// The number of filled holes, and the lengths of the others, in the unit of --fill-holes.
std::string holes_text(const Options& options, const Mesh& mesh, const Hole_filling& filling)
{
  const std::string text = counted(filling.number(Hole_state::FILLED), "hole") + " filled, ";
  std::vector<double> left;
  for (const Hole& hole : filling.holes)
    if (hole.state != Hole_state::FILLED)
      left.push_back(hole.length);
  if (left.empty())
    return text;
  const auto range = std::minmax_element(left.begin(), left.end());
  const double unit = options.hole_length_is_relative ? diagonal(mesh) / 100 : 1;
  return text + counted(left.size(), "hole") + " of length " + shown(*range.first / unit) +
         (left.size() > 1 ? " to " + shown(*range.second / unit) : "") +
         (options.hole_length_is_relative ? "% of the diagonal" : "") + " left, ";
}

// Whose topology is kept, if it is not that of the file.
std::string prepared_text(const Input& input, const Findings& findings)
{
  const bool has_new_faces = findings.holes && findings.holes->number(Hole_state::FILLED) > 0;
  if (input.repairs.empty() && !has_new_faces)
    return "";
  return std::string(" (that of the ") + (input.repairs.empty() ? "" : "repaired ") + "input" +
         (has_new_faces ? " with filled holes)" : ")");
}

std::string summary(const Options& options, const Input& input, const Coarsening_result& result, const Findings& findings,
                    const Stage_times& times)
{
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.2f s", times.total());
  const auto sizes = [](const Mesh& mesh) {
    return counted_vertices(mesh.number_of_vertices()) + ", " + counted(mesh.number_of_faces(), "face");
  };
  const auto& report = result.report;
  std::string remarks;
  if (findings.holes)
    remarks += holes_text(options, input.mesh, *findings.holes);
  if (options.features || !options.patches.empty() || !options.keep.empty() || options.keep_borders)
    remarks += counted(report.feature_lines, "feature line") + " and " + counted(report.feature_corners, "corner") + " kept by " +
               counted_vertices(result.vertices_on_features) + ", ";
  if (result.distance_bound)
    remarks += distance_text(options, length_text(options, input.mesh, *result.distance_bound)) +
               (result.is_within_distance ? ", " : ", where the number of vertices ended the search, ");
  if (!result.levels.empty())
    remarks += counted(result.levels.size(), "level") + ", ";
  if (input.dropped_components > 0)
    remarks += counted(input.dropped_components, "component") + " left out, ";
  const std::string dropped = input.unused_points > 0 ? ", " + counted(input.unused_points, "unused point") + " dropped" : "";
  return escaped_utf8(options.input) + " (" + sizes(input.mesh) + dropped + ") -> " + escaped_utf8(options.output) + " (" +
         sizes(result.mesh) + "), " + counted(report.rounds, "round") + ", " + remarks +
         "topology kept" + prepared_text(input, findings) + ", " + seconds +
         (findings.quality ? "\n" + quality_text(result.mesh, *findings.quality) : "");
}

bool is_closed_pipe(int descriptor)
{
  pollfd polled = {descriptor, 0, 0};
  return poll(&polled, 1, 0) > 0 && (polled.revents & POLLERR) != 0;
}

// Throws Failure if standard output has not accepted all output, unless its reader has had enough.
void flush_output()
{
  errno = 0;
  if (std::cout.flush())
    return;
  const int error = errno ? errno : EIO; // of an earlier write
  if (!is_closed_pipe(STDOUT_FILENO))
    throw Failure("standard output", "cannot be written: " + std::generic_category().message(error));
  std::cout.clear(); // other inputs may follow
}

void warn(const std::vector<std::string>& warnings)
{
  for (const std::string& warning : warnings)
    std::cerr << "coarsen_mesh: warning: " << escaped_utf8(warning) << std::endl;
}

typedef std::vector<std::pair<std::string, std::string> > Files; // name and content

// Commits the files and the report, and prints their names. The report is created last because it contains the times of
// the others.
void write_files(const Options& options, const Files& files, const std::function<std::string()>& make_report,
                 const std::function<std::string()>& make_summary)
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
  if (!options.quiet) {
    const bool is_taken = options.output == standard_stream || options.report == standard_stream;
    (is_taken ? std::cerr : std::cout) << make_summary() << '\n';
  }
  flush_output();
  const Deferred_interruption deferred;
  Interruption::throw_if_requested();
  outputs.commit();
}

void print_range(const Input& input, const Options& options, Stage_times& times, Progress_line& progress)
{
  const SMC::Vertex_number_range range =
    explained(input, options, times, progress, [&](Tool_visitor& visitor) { return range_of(input.mesh, options, visitor); });
  progress.end();
  std::cout << range.least << " to " << range.most << " vertices\n";
  flush_output();
}

void check_result(const Options& options, const Input& input, const Coarsening_result& result, Stage_times& times,
                  Progress_line& progress, Findings& findings)
{
  Interruption::throw_if_requested();
  times.begin("check");
  progress.say("checking the result");
  findings.fault = triangle_mesh_fault(result.mesh);
  for (const Coarser_level& level : result.levels)
    if (!findings.fault)
      findings.fault = triangle_mesh_fault(level.mesh);
  if (findings.fault)
    throw Failure(options.input, "the result is not a valid mesh and is not written: " + *findings.fault);
  // Clusters are not made of whole faces where faces are subdivided, at features, and without rounds if vertices are clustered.
  const auto& report = result.report;
  const bool faces_are_whole = report.subdivided_components == 0 && report.feature_lines == 0 && report.feature_corners == 0 &&
                               report.rounds > 0;
  findings.certificate = certify(input.mesh, result.labels, result.mesh, faces_are_whole);
  if (const auto change = findings.certificate.change())
    throw Failure(options.input, "the result does not have the topology of the input and is not written: " + *change);
  if (options.measure) {
    times.begin("measuring");
    progress.say("measuring");
    findings.quality = measure(input.mesh, result.mesh);
    if (!options.paper) // which does without repair
      findings.quality->self_intersections_left = result.report.intersections_left;
    Interruption::throw_if_requested();
  }
}

// Gives the vertices of the result the largest distance of the faces that they stand for.
void add_distances(const Mesh& input, Coarsening_result& result)
{
  use_numbers<Vertex>(result.mesh, "v:distance", [&](auto map) { result.mesh.remove_property_map(map); }); // of the input
  const auto largest = result.mesh.add_property_map<Vertex, float>("v:distance", 0).first;
  const std::vector<double> distances = face_distances(input, result.mesh, Interruption::throw_if_requested);
  for (std::size_t f = 0; f < distances.size(); ++f) {
    const Vertex v{Mesh::size_type(result.labels[f])};
    largest[v] = (std::max)(largest[v], float(distances[f]));
  }
}

// Moves the vertices to where the files have them: all that is checked, measured and drawn later is what is written.
void round_to_files(const Options& options, const Mesh& input, Coarsening_result& result, Findings& findings)
{
  const std::string type = type_of(options, options.output);
  const double moved = move_to_stored_points(result.mesh, options.output, type);
  for (std::size_t i = 0; i < result.levels.size(); ++i)
    move_to_stored_points(result.levels[i].mesh, level_file(options.output, i + 1), type);
  const std::string rounding = rounding_text(result.mesh, type, moved);
  if (!rounding.empty())
    findings.warnings.push_back(options.output + ": " + rounding);
  if (!result.distance_bound)
    return;
  *result.distance_bound += moved;
  const double unit = options.distance_is_relative ? diagonal(input) : 1;
  if (result.is_within_distance && *result.distance_bound > *options.maximum_distance * unit)
    throw Failure(options.output, "cannot be written " + requested_distance_text(options, input) +
                                    ": the numbers of the format " + upper_case(type) + " move vertices by up to " +
                                    shown(moved) + " (use .ply, .off or .obj, which keep all digits)");
}

// The faces have other numbers in an OBJ file, which groups them by material.
void number_faces_as_written(const Options& options, Coarsening_result& result)
{
  if (type_of(options, options.output) != "obj")
    return;
  std::vector<std::size_t> number(result.mesh.number_of_faces());
  std::size_t next = 0;
  for (const Face f : obj_face_order(result.mesh))
    number[f] = next++;
  for (auto& faces : result.report.intersecting_faces)
    faces = std::minmax({number[faces.first], number[faces.second]});
  for (std::size_t& f : result.report.narrow_faces)
    f = number[f];
}

// The contents of all files but the report.
Files files_of(const Options& options, const Input& input, const Coarsening_result& result, Stage_times& times,
               Progress_line& progress)
{
  Files files;
  if (!options.picture.empty()) {
    times.begin("picture");
    progress.say("rendering");
    files.emplace_back(options.picture, picture_bytes(input.mesh, result.labels, result.mesh, options.view, options.up,
                                                      Interruption::throw_if_requested));
  }
  Interruption::throw_if_requested();
  times.begin("write");
  progress.say("writing");
  const auto add_mesh = [&](const std::string& file, const Mesh& mesh) {
    const std::string type = type_of(options, file);
    files.emplace_back(file, mesh_bytes(mesh, type, input.notes));
    check_written(file, type, files.back().second, mesh);
  };
  add_mesh(options.output, result.mesh);
  for (std::size_t i = 0; i < result.levels.size(); ++i)
    add_mesh(level_file(options.output, i + 1), result.levels[i].mesh);
  if (!options.clusters.empty())
    files.emplace_back(options.clusters, cluster_bytes(input.mesh, result.labels, face_densities(input.mesh, options)));
  return files;
}

// Computes everything, and only then commits the files.
void run(const Options& options)
{
#ifdef CGAL_LINKED_WITH_TBB
  // Applies to the process. Its destructor would start a thread, for which memory may be lacking.
  if (options.threads) {
    [[maybe_unused]] static const auto* const limit =
      new tbb::global_control(tbb::global_control::max_allowed_parallelism, *options.threads);
  }
#endif
  Stage_times times;
  Progress_line progress(!options.quiet);
  Input input = read_input(options, times, progress);
  Findings findings;
  if (options.fill_holes > 0) {
    times.begin("hole filling");
    progress.say("filling holes");
    const double unit = options.hole_length_is_relative ? diagonal(input.mesh) : 1;
    findings.holes = fill_holes(input.mesh, options.fill_holes * unit, Interruption::throw_if_requested);
    times.end();
  }
  if (options.asks_range) {
    print_range(input, options, times, progress);
    return;
  }
  Coarsening_result result =
    explained(input, options, times, progress, [&](Tool_visitor& visitor) { return coarsen(input.mesh, options, visitor); });

  round_to_files(options, input.mesh, result, findings);
  check_result(options, input, result, times, progress, findings);
  if (options.distances) {
    times.begin("distances");
    progress.say("measuring the distances of faces");
    add_distances(input.mesh, result);
  }

  const Files files = files_of(options, input, result, times, progress);
  progress.end();
  for (const std::string& warning : warnings_of(options, input, result))
    findings.warnings.push_back(warning);
  number_faces_as_written(options, result);
  write_files(
    options, files,
    [&] {
      times.end();
      return options.report.empty() ? "" : report_text(options, input, result, findings, times);
    },
    [&] { return summary(options, input, result, findings, times); });
  if (!options.quiet)
    warn(findings.warnings); // of what there is: failures are one line
}

int complain(const std::string& what, int status)
{
  std::cerr << "coarsen_mesh: " << one_line(what) << (status == 2 ? " (see coarsen_mesh --help)" : "") << std::endl;
  return status;
}

} // namespace

int run_and_report(int argc, char* argv[])
{
  // CGAL's own messages span several lines; an exception reports them, too.
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  CGAL::set_warning_handler([](const char*, const char*, const char*, int, const char*) {});
  std::string subject = "the command line";
  int status = 0;
  try {
    const std::vector<Options> all = read_options(argc, argv);
    if (all.empty())
      flush_output();
    for (const Options& options : all) {
      subject = options.input;
      try {
        run(options);
      } catch (const Failure& e) { // the other inputs may do better
        status = complain(e.what(), 1);
      }
    }
    return status;
  } catch (const Wrong_usage& e) {
    return complain(e.what(), 2);
  } catch (const Closed_pipe&) {
    return 128 + SIGPIPE;
  } catch (const Interrupted& e) {
    return complain(subject + ": " + e.what(), e.exit_status());
  } catch (const std::bad_alloc&) {
    return complain(subject + ": there is not enough memory", 1);
  } catch (const std::exception& e) {
    return complain(e.what(), 1);
  }
}

} // namespace coarsen_mesh_tool
