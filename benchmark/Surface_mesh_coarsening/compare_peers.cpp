// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs this package and the other compiled-in coarsening methods on the same meshes, and prints as CSV the seconds, the
// distances of the results from the meshes in percent of the diagonal of the bounding box, and the shape of their triangles
// with angles in degrees. Reading files is not timed. The methods take turns, so that other load affects all alike. Medians
// and their ratios are more reliable than single times, and processor seconds more than wall-clock seconds on a loaded
// machine.

#include "support/Surface_certificate.h"
#include "support/all_methods.h"
#include "support/models.h"

#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace benchmark_support;

double quantile(const std::vector<double>& sorted, double q)
{
  const double at = q * double(sorted.size() - 1);
  const std::size_t i = std::size_t(at);
  return i + 1 < sorted.size() ? sorted[i] + (at - double(i)) * (sorted[i + 1] - sorted[i]) : sorted.back();
}

// Sorts the times; a failed method without times gets one of 0.
std::vector<double> sorted(std::vector<double> seconds)
{
  if (seconds.empty())
    seconds.push_back(0);
  std::sort(seconds.begin(), seconds.end());
  return seconds;
}

struct Times
{
  std::vector<double> clock, processor;
  Result result;
  std::string failure;
};

std::string judged(const Times& times, const Mesh& mesh)
{
  if (!times.failure.empty())
    return times.failure;
  const Surface_certificate after(times.result.polygons, times.result.points.size(), true);
  if (!after.fault().empty())
    return after.fault();
  Surface_certificate::Polygons polygons;
  for (Face f : mesh.faces()) {
    polygons.emplace_back();
    for (Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      polygons.back().push_back(v);
  }
  const Surface_certificate before(polygons, mesh.number_of_vertices(), false);
  const bool same = before.components().size() == after.components().size() &&
                    before.total().same_surface_as(after.total());
  return same ? "valid" : "manifold of another topology";
}

// Duplicates non-manifold vertices for the measurement.
void print_quality(const Mesh& mesh, Result result)
{
  Mesh output;
  CGAL::Polygon_mesh_processing::orient_polygon_soup(result.points, result.polygons);
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(result.points, result.polygons, output);
  const SMC::Coarsening_quality q = SMC::measure_coarsening(mesh, output);
  std::cout << 100 * q.rms_distance / q.diagonal << ',' << 100 * q.maximum_distance / q.diagonal << ','
            << 100 * q.border_rms_distance / q.diagonal << ',' << q.mean_smallest_angle << ',' << q.smallest_angle << ','
            << q.self_intersections;
}

void compare(const std::string& name, const Mesh& mesh, std::size_t number, std::size_t rounds)
{
  const std::vector<Method> methods = all_methods();
  std::vector<Times> times(methods.size());
  for (std::size_t round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < methods.size(); ++i) {
      if (!times[i].failure.empty())
        continue;
      try {
        Result result;
        const Seconds seconds = methods[i].run(mesh, number, result);
        times[i].clock.push_back(seconds.clock);
        times[i].processor.push_back(seconds.processor);
        times[i].result = result;
      } catch (const std::exception& e) {
        times[i].failure = "failed";
        std::cerr << name << ", " << methods[i].name << ": " << e.what() << std::endl;
      }
    }
  double first_median = 0;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    if (times[i].clock.empty()) {
      std::cout << name << ',' << mesh.number_of_faces() << ',' << number << ",\"" << methods[i].name << "\",,\"failed\",0"
                << std::string(13, ',') << std::endl;
      continue;
    }
    const std::vector<double> clock = sorted(times[i].clock), processor = sorted(times[i].processor);
    const double median = quantile(processor, 0.5);
    if (i == 0)
      first_median = median;
    std::cout << name << ',' << mesh.number_of_faces() << ',' << number << ",\"" << methods[i].name << "\","
              << times[i].result.points.size() << ",\"" << judged(times[i], mesh) << "\"," << times[i].clock.size() << ','
              << quantile(clock, 0.5) << ',' << median << ',' << median / first_median << ','
              << processor.front() << ',' << quantile(processor, 0.25) << ',' << quantile(processor, 0.75) << ','
              << processor.back() << ',';
    if (times[i].result.polygons.empty())
      std::cout << ",,,,,";
    else
      print_quality(mesh, times[i].result);
    std::cout << std::endl;
  }
}

// Parses a list of numbers and percentages.
std::vector<std::size_t> numbers(const std::string& list, std::size_t whole)
{
  std::vector<std::size_t> result;
  std::istringstream stream(list);
  for (std::string item; std::getline(stream, item, ',');) {
    const double x = std::stod(item);
    result.push_back(std::size_t(item.back() == '%' ? x / 100 * double(whole) : x));
  }
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 4 || argc % 2 != 0) {
    std::cerr << "usage: compare_peers ROUNDS FILE VERTICES [FILE VERTICES]...\n"
                 "VERTICES: a number, several with commas, or percentages of the vertices of the file, as in 1%,5%" << std::endl;
    return 2;
  }
  try {
    std::cout.precision(4);
    std::cout << "model,faces,asked,method,vertices,result,runs,clock_median_s,processor_median_s,ratio_to_first,"
                 "minimum_s,quartile_1_s,quartile_3_s,maximum_s,rms_%,maximum_%,border_rms_%,mean_smallest_angle,smallest_angle,"
                 "self_intersections"
              << std::endl;
    const std::size_t rounds = (std::max)(1ul, std::strtoul(argv[1], nullptr, 10));
    for (int i = 2; i + 1 < argc; i += 2) {
      const Mesh mesh = benchmark_support::read_model(argv[i]);
      for (const std::size_t number : numbers(argv[i + 1], mesh.number_of_vertices()))
        compare(std::filesystem::path(argv[i]).stem().string(), mesh, number, rounds);
    }
  } catch (const std::exception& e) {
    std::cerr << "compare_peers: " << e.what() << std::endl;
    return 1;
  }
  return 0;
}
