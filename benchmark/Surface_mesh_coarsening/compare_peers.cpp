// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs this package and the other coarsening methods that were there when this was compiled on the same meshes, and
// prints the seconds as CSV. Reading files is not timed. The methods take turns, so that what else the machine does hits
// all alike. Medians and their ratios say more than single times, and processor seconds more than those of the clock
// where other programs run.

#include "support/Surface_certificate.h"
#include "support/models.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>

#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#if __has_include(<CGAL/Polygon_mesh_processing/approximated_centroidal_Voronoi_diagram_remeshing.h>)
#  include <CGAL/Polygon_mesh_processing/approximated_centroidal_Voronoi_diagram_remeshing.h>
#  define COARSENING_HAS_ACVD
#endif
#ifdef COARSENING_HAS_MESHOPTIMIZER
#  include <meshoptimizer.h>
#endif
#ifdef COARSENING_HAS_OPENMESH
#  include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#  include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#  include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#endif

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;
using coarsening_support::Face;
using coarsening_support::Mesh;
using coarsening_support::Point;
using coarsening_support::Vertex;

// Triangles as a list, which every method can give.
struct Result
{
  std::size_t vertices = 0;
  std::vector<std::vector<std::size_t> > triangles;
};

Result result_of(Mesh& mesh)
{
  mesh.collect_garbage();
  Result result;
  result.vertices = mesh.number_of_vertices();
  for (Face f : mesh.faces()) {
    result.triangles.emplace_back();
    for (Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      result.triangles.back().push_back(v);
  }
  return result;
}

struct Seconds
{
  double clock = 0, processor = 0;
};

class Stopwatch
{
public:
  Seconds seconds() const
  {
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(),
            double(std::clock() - processor_begin_) / CLOCKS_PER_SEC};
  }

private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::clock_t processor_begin_ = std::clock();
};

struct Method
{
  std::string name;
  std::function<Seconds(const Mesh&, std::size_t, Result&)> run;
};

template <class Weight, class Placement = SMC::Centroid_placement>
Method our_method(const std::string& name, double maximum_density, bool repair = true)
{
  return {name, [maximum_density, repair](const Mesh& mesh, std::size_t number, Result& result) {
            Mesh output;
            const Stopwatch watch;
            SMC::coarsen_mesh(mesh, number, output,
                              SMC::parameters::cluster_weight(Weight())
                                .maximum_density(maximum_density)
                                .vertex_placement(Placement())
                                .repair_output(repair));
            const Seconds seconds = watch.seconds();
            result = result_of(output);
            return seconds;
          }};
}

// Between CGAL 5 and 6 the predicate that does this was renamed.
struct Few_edges_left
{
  std::size_t edges;
  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile&, std::size_t, std::size_t current) const { return current <= edges; }
};

// Collapses edges in place, so that it needs a copy; making it is not counted. The number of edges to stop at is what
// Euler's formula gives for the number of vertices.
Seconds run_edge_collapse(const Mesh& mesh, std::size_t number, Result& result)
{
  Mesh copy = mesh;
  const std::size_t all = mesh.number_of_edges(), removed = mesh.number_of_vertices() - number;
  const std::size_t edges = all - (std::min)(all - 6, 3 * removed);
  const Stopwatch watch;
  CGAL::Surface_mesh_simplification::edge_collapse(copy, Few_edges_left{edges});
  const Seconds seconds = watch.seconds();
  result = result_of(copy);
  return seconds;
}

#ifdef COARSENING_HAS_ACVD
// Works in place.
Seconds run_acvd(const Mesh& mesh, std::size_t number, Result& result)
{
  Mesh copy = mesh;
  const Stopwatch watch;
  CGAL::Polygon_mesh_processing::approximated_centroidal_Voronoi_diagram_remeshing(copy, number);
  const Seconds seconds = watch.seconds();
  result = result_of(copy);
  return seconds;
}
#endif

#ifdef COARSENING_HAS_MESHOPTIMIZER
Seconds run_meshoptimizer(const Mesh& mesh, std::size_t number, Result& result)
{
  std::vector<float> coordinates;
  std::vector<unsigned int> indices, simplified;
  for (Vertex v : mesh.vertices())
    for (int i = 0; i < 3; ++i)
      coordinates.push_back(float(mesh.point(v)[i]));
  for (Face f : mesh.faces())
    for (Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      indices.push_back(v);
  simplified.resize(indices.size());
  const std::size_t removed = mesh.number_of_vertices() - number;
  const std::size_t target = indices.size() - (std::min)(indices.size() - 12, 6 * removed);
  const Stopwatch watch;
  const std::size_t count = meshopt_simplify(simplified.data(), indices.data(), indices.size(), coordinates.data(),
                                             mesh.number_of_vertices(), 3 * sizeof(float), target, 1e10f);
  const Seconds seconds = watch.seconds();
  std::vector<std::size_t> number_of(mesh.number_of_vertices(), std::size_t(-1));
  for (std::size_t i = 0; i < count; i += 3) {
    result.triangles.emplace_back();
    for (std::size_t j = i; j < i + 3; ++j) {
      std::size_t& n = number_of[simplified[j]];
      if (n == std::size_t(-1))
        n = result.vertices++;
      result.triangles.back().push_back(n);
    }
  }
  return seconds;
}
#endif

#ifdef COARSENING_HAS_OPENMESH
// Collapses halfedges by quadrics. Making the copy in its own data structure is not counted.
Seconds run_openmesh(const Mesh& mesh, std::size_t number, Result& result)
{
  typedef OpenMesh::TriMesh_ArrayKernelT<> Open_mesh;
  Open_mesh copy;
  for (Vertex v : mesh.vertices())
    copy.add_vertex(Open_mesh::Point(float(mesh.point(v)[0]), float(mesh.point(v)[1]), float(mesh.point(v)[2])));
  for (Face f : mesh.faces()) {
    std::vector<Open_mesh::VertexHandle> corners;
    for (Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      corners.push_back(Open_mesh::VertexHandle(int(v)));
    copy.add_face(corners);
  }
  copy.request_face_normals();
  copy.update_face_normals();
  const Stopwatch watch;
  OpenMesh::Decimater::DecimaterT<Open_mesh> decimater(copy);
  OpenMesh::Decimater::ModQuadricT<Open_mesh>::Handle quadrics;
  decimater.add(quadrics);
  decimater.module(quadrics).unset_max_err();
  decimater.initialize();
  decimater.decimate_to(number);
  copy.garbage_collection();
  const Seconds seconds = watch.seconds();
  result.vertices = copy.n_vertices();
  for (const auto f : copy.faces()) {
    result.triangles.emplace_back();
    for (auto v = copy.cfv_iter(f); v.is_valid(); ++v)
      result.triangles.back().push_back(std::size_t(v->idx()));
  }
  return seconds;
}
#endif

std::vector<Method> all_methods()
{
  std::vector<Method> methods{
    our_method<SMC::Uniform_weight>("ours uniform", 1),
    our_method<SMC::Weighted_area_weight>("ours area", 50),
    our_method<SMC::Maximum_density_weight>("ours maximum", 50),
    our_method<SMC::Density_variance_weight>("ours variance", 3),
    our_method<SMC::Maximum_density_weight, SMC::Quadric_placement>("ours maximum quadric", 50),
    our_method<SMC::Maximum_density_weight, SMC::Quadric_placement>("ours maximum quadric without repair", 50, false),
    {"CGAL edge collapse", run_edge_collapse}};
#ifdef COARSENING_HAS_ACVD
  methods.push_back({"CGAL ACVD", run_acvd});
#endif
#ifdef COARSENING_HAS_MESHOPTIMIZER
  methods.push_back({"meshoptimizer", run_meshoptimizer});
#endif
#ifdef COARSENING_HAS_OPENMESH
  methods.push_back({"OpenMesh decimation", run_openmesh});
#endif
  return methods;
}

double quantile(const std::vector<double>& sorted, double q)
{
  const double at = q * double(sorted.size() - 1);
  const std::size_t i = std::size_t(at);
  return i + 1 < sorted.size() ? sorted[i] + (at - double(i)) * (sorted[i + 1] - sorted[i]) : sorted.back();
}

// Of no times at all, that of a method that failed, it makes one.
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
  using benchmark_support::Surface_certificate;
  if (!times.failure.empty())
    return times.failure;
  const Surface_certificate after(times.result.triangles, times.result.vertices, true);
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
    const std::vector<double> clock = sorted(times[i].clock), processor = sorted(times[i].processor);
    const double median = quantile(processor, 0.5);
    if (i == 0)
      first_median = median;
    std::cout << name << ',' << mesh.number_of_faces() << ',' << number << ",\"" << methods[i].name << "\","
              << times[i].result.vertices << ",\"" << judged(times[i], mesh) << "\"," << times[i].clock.size() << ','
              << quantile(clock, 0.5) << ',' << median << ',' << median / first_median << ','
              << processor.front() << ',' << quantile(processor, 0.25) << ',' << quantile(processor, 0.75) << ','
              << processor.back() << std::endl;
  }
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 4 || argc % 2 != 0) {
    std::cerr << "usage: compare_peers ROUNDS FILE NUMBER_OF_VERTICES [FILE NUMBER_OF_VERTICES]..." << std::endl;
    return 2;
  }
  try {
    std::cout << "model,faces,asked,method,vertices,result,runs,clock_median_s,processor_median_s,ratio_to_first,"
                 "minimum_s,quartile_1_s,quartile_3_s,maximum_s"
              << std::endl;
    const std::size_t rounds = (std::max)(1ul, std::strtoul(argv[1], nullptr, 10));
    for (int i = 2; i + 1 < argc; i += 2) {
      const Mesh mesh = benchmark_support::read_model(argv[i]);
      compare(std::filesystem::path(argv[i]).stem().string(), mesh, std::strtoul(argv[i + 1], nullptr, 10), rounds);
    }
  } catch (const std::exception& e) {
    std::cerr << "compare_peers: " << e.what() << std::endl;
    return 1;
  }
  return 0;
}
