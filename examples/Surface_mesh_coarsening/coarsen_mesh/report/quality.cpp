// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/quality.h"

#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <cstdio>

namespace coarsen_mesh_tool {
namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;

std::string line(const char* name, const char* format, double a, double b, double c)
{
  char text[160];
  std::snprintf(text, sizeof text, format, a, b, c);
  return "  " + std::string(name) + text + "\n";
}

} // namespace

Measured_quality measure(const Mesh& mesh, const Mesh& coarse)
{
  Measured_quality quality;
  static_cast<Coarsening_quality&>(quality) = SMC::measure_coarsening(mesh, coarse);
  if (quality.self_intersections > 0)
    quality.self_intersections_of_input = SMC::measure_coarsening(mesh, mesh, 1).self_intersections;
  return quality;
}

double percent(const Coarsening_quality& quality, double length)
{
  return quality.diagonal > 0 ? 100 * (length / quality.diagonal) : 0;
}

std::string quality_text(const Mesh& result, const Measured_quality& q)
{
  const auto part = [&q](double length) { return percent(q, length); };
  const char* distances = "RMS %.4f, mean %.4f, maximum %.4f %% of the diagonal";
  std::string text =
    line("distance:         ", distances, part(q.rms_distance), part(q.mean_distance), part(q.maximum_distance));
  if (std::isinf(q.border_rms_distance))
    text += "  border:           only one of the meshes has one\n";
  else if (!CGAL::is_closed(result))
    text += line("border distance:  ", distances, part(q.border_rms_distance), part(q.border_mean_distance),
                 part(q.border_maximum_distance));
  const char* angles = "RMS %.2f, mean %.2f, maximum %.2f degrees";
  text += line("normal deviation: ", angles, q.rms_normal_deviation, q.mean_normal_deviation, q.maximum_normal_deviation);
  const char* one_way = "RMS %.4f, maximum %.4f %% of the diagonal, normals RMS %.2f degrees";
  const auto error = [&](const SMC::Surface_error& e, const char* name) {
    return line(name, one_way, part(e.rms_distance), part(e.maximum_distance), e.rms_normal_deviation);
  };
  text += error(q.from_mesh, "input to result:  ") + error(q.from_coarse, "result to input:  ");
  text += line("smallest angles:  ", "mean %.1f, least %.1f degrees, %.1f %% of the triangles below 30",
               q.mean_smallest_angle, q.smallest_angle, 100 * q.part_below_30_degrees);
  text += "  self-intersections: " + std::to_string(q.self_intersections);
  if (q.self_intersections == 0)
    return text;
  if (q.self_intersections_left)
    text += " (" + std::to_string(*q.self_intersections_left) + " where the input has none)";
  return text + ", input " + std::to_string(q.self_intersections_of_input);
}

} // namespace coarsen_mesh_tool
