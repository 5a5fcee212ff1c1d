// SPDX-License-Identifier: GPL-3.0-or-later

#include "input.h"

#include "check/soup_fault.h"
#include "io/Edge_pairing.h"
#include "io/Failure.h"
#include "io/read_soup.h"
#include "io/soup_properties.h"
#include "io/to_mesh.h"
#include "repair/Muted_streams.h"
#include "repair/drop_small_components.h"
#include "Interruption.h"

#include <CGAL/Surface_mesh_coarsening/exceptions.h>

#include <exception>
#include <optional>

namespace coarsen_mesh_tool {
namespace {

std::vector<Repair_step> try_repair(const Options& options, Soup& soup)
{
  const Muted_streams muted; // one line on standard error is promised
  try {
    return repair(soup, options.weld);
  } catch (const std::exception& e) {
    throw Failure(options.input, "cannot be repaired: " + one_line(e.what()));
  }
}

std::size_t try_to_drop_components(const Options& options, Mesh& mesh)
{
  try {
    const std::size_t dropped = drop_small_components(mesh, options.minimum_component_area);
    mesh.collect_garbage();
    return dropped;
  } catch (const CGAL::Surface_mesh_coarsening::Invalid_input& e) {
    throw Failure(options.input, e.what());
  }
}

} // namespace

Input read_input(const Options& options, Stage_times& times, Progress_line& progress)
{
  times.begin("read");
  progress.say("reading " + options.input);
  Soup soup = read_soup(options.input, Interruption::throw_if_requested, options.format);
  Input result;
  result.points_in_file = soup.points.size();
  result.polygons_in_file = soup.polygons.size();
  if (options.repair) {
    times.begin("repair");
    progress.say("repairing");
    result.repairs = try_repair(options, soup);
    Interruption::throw_if_requested();
    times.begin("read");
  }
  std::optional<Edge_pairing> pairing;
  if (const auto fault = soup_fault(soup, pairing, Interruption::throw_if_requested))
    throw Failure(options.input, (options.repair ? "is not an oriented 2-manifold even after the repair: "
                                                 : "is not an oriented 2-manifold (--repair may help): ") +
                                   *fault);
  result.unused_points = drop_unused_points(soup);
  result.mesh = to_mesh(soup, *pairing, Interruption::throw_if_requested);
  add_properties(soup, result.mesh);
  result.notes = soup.notes;
  result.left_out = soup.left_out;
  result.dropped_components = try_to_drop_components(options, result.mesh);
  times.end();
  return result;
}

} // namespace coarsen_mesh_tool
