// SPDX-License-Identifier: GPL-3.0-or-later

#include "coarsening.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_levels.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Exact_maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Closest_vertex_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh_to_distance.h>
#include <CGAL/Surface_mesh_coarsening/parameters.h>

#include <CGAL/tags.h>

#include <boost/property_map/function_property_map.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <functional>
#include <utility>

namespace coarsening_python {
namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;
typedef SMC::Coarsening_defaults Defaults;

template <class Use>
void with_placement(const std::string& name, const Use& use)
{
  if (name == "centroid")
    use(SMC::Centroid_placement());
  else if (name == "closest-vertex")
    use(SMC::Closest_vertex_placement());
  else if (name == "quadric")
    use(SMC::Quadric_placement());
  else if (name == "fitted")
    use(SMC::Fitted_placement());
  else
    throw SMC::Invalid_input("there is no placement '" + name + "' (centroid, closest-vertex, quadric, fitted)");
}

auto map_to(std::vector<std::int64_t>& labels)
{
  return boost::make_function_property_map<Face>([&labels](Face f) -> std::int64_t& { return labels[f]; });
}

template <class NamedParameters>
std::vector<Coarsening> coarsen_to_distance(const Mesh& input, const Options& options, const NamedParameters& np)
{
  std::vector<Coarsening> results(1);
  Coarsening& result = results[0];
  result.labels.resize(input.number_of_faces());
  with_placement(options.placement, [&](const auto& placement) {
    const SMC::Distance_report report = SMC::coarsen_mesh_to_distance<CGAL::Parallel_if_available_tag>(
      input, *options.maximum_distance, result.mesh,
      np.number_of_iterations(options.iterations.value_or(Defaults::number_of_iterations))
        .convergence_tolerance(options.convergence_tolerance)
        .vertex_placement(placement)
        .face_cluster_map(map_to(result.labels)));
    result.report = report.clustering;
    result.distance_bound = report.distance_bound;
  });
  return results;
}

template <class Weight, class NamedParameters>
std::vector<Coarsening> coarsen_to_numbers(const Mesh& input, const Options& options, const NamedParameters& np)
{
  typedef SMC::Mwcvd_clustering<Mesh, Weight, CGAL::Parallel_if_available_tag> Clustering;
  Clustering clustering(input, np);
  clustering.seed(options.vertices.front());
  clustering.grow();
  clustering.minimize(options.iterations.value_or(Defaults::number_of_iterations), options.convergence_tolerance);
  std::vector<Coarsening> results(options.vertices.size());
  for (Coarsening& result : results)
    result.labels.resize(input.number_of_faces());
  with_placement(options.placement, [&](const auto& placement) {
    clustering.extract_embedded_dual_mesh(results[0].mesh, placement);
    results[0].report = clustering.report();
    clustering.write_clusters(map_to(results[0].labels));
    if (results.size() == 1)
      return;
    const SMC::Cluster_levels<Clustering> levels(clustering);
    for (std::size_t i = 1; i < results.size(); ++i) {
      levels.extract_dual_mesh(options.vertices[i], results[i].mesh, placement);
      levels.write_clusters(options.vertices[i], map_to(results[i].labels));
      results[i].report = results[0].report;
      results[i].report.clusters = options.vertices[i];
    }
  });
  return results;
}

template <class Weight>
std::vector<Coarsening> coarsen_with(const Mesh& input, const Options& options, Python_visitor& visitor)
{
  const auto np =
    SMC::parameters::cluster_weight(Weight())
      .maximum_density(options.maximum_density)
      .minimum_component_area(options.minimum_component_area)
      .subdivide_input(options.subdivide)
      .repair_output(options.repair)
      .error_feedback(options.error_feedback)
      .feature_angle(options.feature_angle)
      .face_patch_map(boost::make_function_property_map<Face>(
        [&options](Face f) -> std::int64_t { return options.patches ? options.patches[f] : 0; }))
      .visitor(std::ref(visitor));
  const auto run = [&](const auto& all) {
    return options.maximum_distance ? coarsen_to_distance(input, options, all) : coarsen_to_numbers<Weight>(input, options, all);
  };
  if (!options.density)
    return run(np);
  return run(np.face_density_map(
    boost::make_function_property_map<Face>([&options](Face f) -> double { return options.density[f]; })));
}

std::vector<Coarsening> coarsen_on_this_arena(const Mesh& input, const Options& options, Python_visitor& visitor)
{
  const auto run = options.weight == "uniform"         ? coarsen_with<SMC::Uniform_weight>
                   : options.weight == "area"          ? coarsen_with<SMC::Weighted_area_weight>
                   : options.weight == "maximum"       ? coarsen_with<SMC::Maximum_density_weight>
                   : options.weight == "exact-maximum" ? coarsen_with<SMC::Exact_maximum_density_weight>
                   : options.weight == "variance"      ? coarsen_with<SMC::Density_variance_weight>
                                                       : nullptr;
  if (run == nullptr)
    throw SMC::Invalid_input("there is no weight '" + options.weight + "' (uniform, area, maximum, exact-maximum, variance)");
  return run(input, options, visitor);
}

} // namespace

std::vector<Coarsening> coarsen(const Mesh& input, const Options& options, Python_visitor& visitor)
{
  try {
#ifdef CGAL_LINKED_WITH_TBB
    if (options.threads > 0) // for this call only, independently of other threads of the interpreter
      return tbb::task_arena(options.threads).execute([&] { return coarsen_on_this_arena(input, options, visitor); });
#endif
    return coarsen_on_this_arena(input, options, visitor);
  } catch (const SMC::Coarsening_cancelled&) {
    visitor.rethrow();
    throw;
  }
}

} // namespace coarsening_python
