// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs this package and the other compiled-in coarsening methods on meshes, at several sizes, and prints means over the meshes as
// CSV. Distances and deviations of normals are divided by the ones of the edge collapse of CGAL by its default cost, that of
// Lindstrom and Turk, at the same size: below 1 a method is closer. Their means are geometric. Runs that fail, or return no
// 2-manifold, are counted and left out of the means.

#include "support/Surface_certificate.h"
#include "support/models.h"
#include "support/peers.h"

#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace benchmark_support;

// The others are compared with the first one.
std::vector<Method> all_methods()
{
  std::vector<Method> methods{{"CGAL edge collapse", run_lindstrom_turk},
                              {"CGAL edge collapse by planes", run_garland_heckbert<Plane_quadrics>}};
#ifdef COARSENING_HAS_LINE_QUADRICS
  methods.push_back({"CGAL edge collapse by planes and lines", run_garland_heckbert<Plane_and_line_quadrics>});
#endif
#ifdef COARSENING_HAS_ACVD
  const auto seed = CGAL::parameters::random_seed(0);
  methods.push_back(acvd("CGAL ACVD", seed));
  methods.push_back(acvd("CGAL ACVD by quadrics", seed.use_qem_based_energy(true)));
  methods.push_back(acvd("CGAL ACVD with gradation", seed.gradation_factor(1.)));
#endif
  methods.push_back(our_method_with_energy<SMC::Weighted_inertia_energy<> >("ours"));
  methods.push_back(our_method_with_energy<SMC::Quadric_energy>("ours by quadrics"));
  methods.push_back(our_method_with_energy<SMC::Normal_deviation_energy>("ours by normals"));
  return methods;
}

struct Run
{
  SMC::Coarsening_quality quality;
  double seconds = 0;
};

std::optional<Run> run(const Method& method, const Mesh& mesh, std::size_t number)
{
  try {
    Result result;
    Run done;
    done.seconds = method.run(mesh, number, result).processor;
    if (!Surface_certificate(result.polygons, result.points.size(), true).fault().empty())
      return std::nullopt;
    Mesh coarse;
    CGAL::Polygon_mesh_processing::orient_polygon_soup(result.points, result.polygons);
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(result.points, result.polygons, coarse);
    done.quality = SMC::measure_coarsening(mesh, coarse);
    return done;
  } catch (const std::exception& e) {
    std::cerr << method.name << ", " << number << " vertices: " << e.what() << std::endl;
    return std::nullopt;
  }
}

class Geometric_mean
{
public:
  void add(double ratio)
  {
    if (!(ratio > 0 && std::isfinite(ratio)))
      return;
    logarithms_ += std::log(ratio);
    ++number_;
  }
  double value() const { return number_ == 0 ? 0 : std::exp(logarithms_ / double(number_)); }

private:
  double logarithms_ = 0;
  std::size_t number_ = 0;
};

// What a method has reached, with regard to the edge collapse.
struct Record
{
  explicit Record(std::size_t sizes) : distance_at(sizes) {}

  void add(const Run& run, const Run& anchor, std::size_t size)
  {
    const double ratio = run.quality.rms_distance / anchor.quality.rms_distance;
    distance.add(ratio);
    distance_at[size].add(ratio);
    worst = (std::max)(worst, ratio);
    closer += ratio < 1;
    normals.add(run.quality.rms_normal_deviation / anchor.quality.rms_normal_deviation);
    seconds.add(run.seconds / anchor.seconds);
    angles += run.quality.mean_smallest_angle;
    below_30 += run.quality.part_below_30_degrees;
    self_intersections += run.quality.self_intersections;
    ++runs;
  }

  Geometric_mean distance, normals, seconds;
  std::vector<Geometric_mean> distance_at; // of each size
  double worst = 0, angles = 0, below_30 = 0;
  std::size_t runs = 0, failed = 0, closer = 0, self_intersections = 0;
};

void compare(const Mesh& mesh, const std::vector<double>& sizes, const std::vector<Method>& methods,
             std::vector<Record>& records)
{
  for (std::size_t s = 0; s < sizes.size(); ++s) {
    const std::size_t number = (std::max)(std::size_t(sizes[s] / 100 * double(mesh.number_of_vertices())), std::size_t(4));
    const std::optional<Run> anchor = run(methods.front(), mesh, number);
    if (!anchor)
      throw std::runtime_error("the edge collapse, which the others are compared with, has failed");
    for (std::size_t i = 0; i < methods.size(); ++i) {
      const std::optional<Run> done = i == 0 ? anchor : run(methods[i], mesh, number);
      if (done)
        records[i].add(*done, *anchor, s);
      else
        ++records[i].failed;
    }
  }
}

void print(const std::vector<double>& sizes, const std::vector<Method>& methods, const std::vector<Record>& records)
{
  std::cout << "method,runs,failed,rms";
  for (const double size : sizes)
    std::cout << ",at_" << size << "%";
  std::cout << ",largest_rms,closer_in,rms_of_normals,mean_smallest_angle,below_30_%,self_intersections,seconds" << std::endl;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const Record& r = records[i];
    const double runs = double((std::max)(r.runs, std::size_t(1)));
    std::cout << methods[i].name << ',' << r.runs << ',' << r.failed << ',' << r.distance.value();
    for (const Geometric_mean& mean : r.distance_at)
      std::cout << ',' << mean.value();
    std::cout << ',' << r.worst << ',' << r.closer << ',' << r.normals.value() << ',' << r.angles / runs << ','
              << 100 * r.below_30 / runs << ',' << r.self_intersections << ',' << r.seconds.value() << std::endl;
  }
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 3) {
    std::cerr << "usage: compare_quality SIZES FILE...\n"
                 "SIZES: parts of the vertices of each file in percent, as in 1,2,5,10,20"
              << std::endl;
    return 2;
  }
  try {
    std::vector<double> sizes;
    std::istringstream stream(argv[1]);
    for (std::string item; std::getline(stream, item, ',');)
      sizes.push_back(std::stod(item));
    const std::vector<Method> methods = all_methods();
    std::vector<Record> records(methods.size(), Record(sizes.size()));
    for (int i = 2; i < argc; ++i)
      compare(read_model(argv[i]), sizes, methods, records);
    std::cout.precision(3);
    print(sizes, methods, records);
  } catch (const std::exception& e) {
    std::cerr << "compare_quality: " << e.what() << std::endl;
    return 1;
  }
  return 0;
}
