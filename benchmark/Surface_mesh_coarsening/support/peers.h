// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_BENCHMARK_PEERS_H
#define COARSENING_BENCHMARK_PEERS_H

// This package with several settings, and the other coarsening methods available at compilation.

#include "io/Mesh.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Normal_deviation_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Quadric_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Weighted_inertia_energy.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#if __has_include(<CGAL/Polygon_mesh_processing/approximated_centroidal_Voronoi_diagram_remeshing.h>)
#  include <CGAL/Polygon_mesh_processing/approximated_centroidal_Voronoi_diagram_remeshing.h>
#  define COARSENING_HAS_ACVD
#endif
#if __has_include(<CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_and_line_policies.h>)
#  include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_and_line_policies.h>
#  define COARSENING_HAS_LINE_QUADRICS
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
#include <ctime>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace benchmark_support {

namespace SMC = CGAL::Surface_mesh_coarsening;
using coarsening_support::Face;
using coarsening_support::Mesh;
using coarsening_support::Point;
using coarsening_support::Vertex;

// Points and triangles as lists, the common form of all methods.
struct Result
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t> > polygons;
};

inline Result result_of(Mesh& mesh)
{
  mesh.collect_garbage();
  Result result;
  for (Vertex v : mesh.vertices())
    result.points.push_back(mesh.point(v));
  for (Face f : mesh.faces()) {
    result.polygons.emplace_back();
    for (Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      result.polygons.back().push_back(v);
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

template <class Weight, class Placement = SMC::Centroid_placement, class ConcurrencyTag = CGAL::Sequential_tag>
Method our_method(const std::string& name, double maximum_density, bool repair = true)
{
  return {name, [maximum_density, repair](const Mesh& mesh, std::size_t number, Result& result) {
            Mesh output;
            const Stopwatch watch;
            SMC::coarsen_mesh<ConcurrencyTag>(mesh, number, output,
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

// Returns the number of edges or faces in the proportion of the vertices. Collapses of edges cannot stop at a number of
// vertices.
inline std::size_t part(std::size_t all, std::size_t number, const Mesh& mesh)
{
  return std::size_t(double(all) * double(number) / double(mesh.number_of_vertices()));
}

// Collapses edges in place, in a copy; copying is not timed.
template <class Collapse>
Seconds run_edge_collapse(const Mesh& mesh, std::size_t number, Result& result, const Collapse& collapse)
{
  Mesh copy = mesh;
  const std::size_t edges = part(mesh.number_of_edges(), number, mesh);
  const Stopwatch watch;
  collapse(copy, Few_edges_left{edges});
  const Seconds seconds = watch.seconds();
  result = result_of(copy);
  return seconds;
}

inline Seconds run_lindstrom_turk(const Mesh& mesh, std::size_t number, Result& result)
{
  return run_edge_collapse(mesh, number, result, [](Mesh& copy, const Few_edges_left& stop) {
    CGAL::Surface_mesh_simplification::edge_collapse(copy, stop);
  });
}

// With quadrics.
template <class Policies>
Seconds run_garland_heckbert(const Mesh& mesh, std::size_t number, Result& result)
{
  return run_edge_collapse(mesh, number, result, [](Mesh& copy, const Few_edges_left& stop) {
    const Policies policies(copy);
    CGAL::Surface_mesh_simplification::edge_collapse(
      copy, stop, CGAL::parameters::get_cost(policies.get_cost()).get_placement(policies.get_placement()));
  });
}

typedef CGAL::Surface_mesh_simplification::GarlandHeckbert_plane_policies<Mesh, CGAL::Simple_cartesian<double> > Plane_quadrics;
#ifdef COARSENING_HAS_LINE_QUADRICS
typedef CGAL::Surface_mesh_simplification::GarlandHeckbert_plane_and_line_policies<Mesh, CGAL::Simple_cartesian<double> >
  Plane_and_line_quadrics;
#endif

#ifdef COARSENING_HAS_ACVD
// Works in place. Takes one connected component, and can crash on others.
template <class NamedParameters>
Method acvd(const std::string& name, const NamedParameters& np)
{
  return {name, [np](const Mesh& mesh, std::size_t number, Result& result) {
            Mesh copy = mesh;
            const auto component = copy.add_property_map<Face, std::size_t>("f:component").first;
            if (CGAL::Polygon_mesh_processing::connected_components(copy, component) != 1)
              throw std::invalid_argument("takes one connected component only");
            const Stopwatch watch;
            CGAL::Polygon_mesh_processing::approximated_centroidal_Voronoi_diagram_remeshing(copy, number, np);
            const Seconds seconds = watch.seconds();
            result = result_of(copy);
            return seconds;
          }};
}
#endif

#ifdef COARSENING_HAS_MESHOPTIMIZER
inline Seconds run_meshoptimizer(const Mesh& mesh, std::size_t number, Result& result)
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
  const std::size_t target = 3 * part(mesh.number_of_faces(), number, mesh);
  const Stopwatch watch;
  const std::size_t count = meshopt_simplify(simplified.data(), indices.data(), indices.size(), coordinates.data(),
                                             mesh.number_of_vertices(), 3 * sizeof(float), target, 1e10f);
  const Seconds seconds = watch.seconds();
  std::vector<std::size_t> number_of(mesh.number_of_vertices(), std::size_t(-1));
  for (std::size_t i = 0; i < count; i += 3) {
    result.polygons.emplace_back();
    for (std::size_t j = i; j < i + 3; ++j) {
      std::size_t& n = number_of[simplified[j]];
      if (n == std::size_t(-1)) {
        n = result.points.size();
        result.points.push_back(mesh.point(Vertex(simplified[j])));
      }
      result.polygons.back().push_back(n);
    }
  }
  return seconds;
}
#endif

#ifdef COARSENING_HAS_OPENMESH
// Collapses halfedges by quadrics. Conversion to its own data structure is not timed.
inline Seconds run_openmesh(const Mesh& mesh, std::size_t number, Result& result)
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
  for (const auto v : copy.vertices())
    result.points.push_back(Point(copy.point(v)[0], copy.point(v)[1], copy.point(v)[2]));
  for (const auto f : copy.faces()) {
    result.polygons.emplace_back();
    for (auto v = copy.cfv_iter(f); v.is_valid(); ++v)
      result.polygons.back().push_back(std::size_t(v->idx()));
  }
  return seconds;
}
#endif

// This package by default, with an energy.
template <class Energy>
Method our_method_with_energy(const std::string& name)
{
  return {name, [](const Mesh& mesh, std::size_t number, Result& result) {
            Mesh output;
            const Stopwatch watch;
            SMC::coarsen_mesh(mesh, number, output, SMC::parameters::cluster_energy(Energy()));
            const Seconds seconds = watch.seconds();
            result = result_of(output);
            return seconds;
          }};
}

// Adds the methods of the libraries that have been found.
inline void add_other_libraries([[maybe_unused]] std::vector<Method>& methods)
{
#ifdef COARSENING_HAS_MESHOPTIMIZER
  methods.push_back({"meshoptimizer", run_meshoptimizer});
#endif
#ifdef COARSENING_HAS_OPENMESH
  methods.push_back({"OpenMesh decimation", run_openmesh});
#endif
}

} // namespace benchmark_support

#endif // COARSENING_BENCHMARK_PEERS_H
