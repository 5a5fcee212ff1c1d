// SPDX-License-Identifier: GPL-3.0-or-later

#include "coarsening.h"

#include "named_energies.h"
#include "repair/drop_small_components.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_levels.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Closest_vertex_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh_to_distance.h>
#include <CGAL/Surface_mesh_coarsening/parameters.h>
#include <CGAL/Surface_mesh_coarsening/vertex_number_range.h>

#include <CGAL/tags.h>

#include <boost/property_map/function_property_map.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace coarsening_python {
namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;
typedef SMC::Coarsening_defaults Defaults;

template <class Use>
void with_placement(const Options& options, const Use& use)
{
  const std::string& name = options.placement;
  if (name == "centroid")
    use(SMC::Centroid_placement());
  else if (name == "closest-vertex")
    use(SMC::Closest_vertex_placement());
  else if (name == "quadric")
    use(SMC::Quadric_placement());
  else if (name == "fitted")
    use(SMC::Fitted_placement(SMC::Fitted_placement::default_rounds, options.mean_angle));
  else
    throw SMC::Invalid_input("there is no placement '" + name + "' (centroid, closest-vertex, quadric, fitted)");
}

auto map_to(std::vector<std::int64_t>& labels)
{
  return boost::make_function_property_map<Face>([&labels](Face f) -> std::int64_t& { return labels[f]; });
}

// The marks of elements, none if they are empty.
template <class Key>
auto marks(const std::vector<bool>& marks)
{
  return boost::make_function_property_map<Key>(
    [&marks](Key k) -> bool { return !marks.empty() && marks[std::size_t(k)]; });
}

auto parameters_of(const Options& options, const Fields& fields, Python_visitor& visitor)
{
  return SMC::parameters::maximum_density(options.maximum_density)
    .subdivide_input(options.subdivide)
    .paper_rules(options.paper)
    .repair_output(options.repair_output)
    .error_feedback(options.error_feedback)
    .feature_angle(options.feature_angle)
    .face_patch_map(boost::make_function_property_map<Face>(
      [&fields](Face f) -> std::int64_t { return fields.patches ? fields.patches[f] : 0; }))
    .edge_is_constrained_map(marks<Edge>(fields.kept_edges))
    .vertex_is_constrained_map(marks<Vertex>(fields.kept_vertices))
    .visitor(std::ref(visitor));
}

// The patches of a result are in this property map of its mesh.
auto map_of_patches(Mesh& result) { return result.add_property_map<Face, std::int64_t>("f:patch", 0).first; }

void keep_border_vertices(const Mesh& input, Fields& fields)
{
  fields.kept_vertices.resize(input.num_vertices(), false);
  for (const Halfedge h : input.halfedges())
    if (input.is_border(h))
      fields.kept_vertices[input.target(h)] = true;
}

template <class NamedParameters>
std::vector<Coarsening> coarsen_to_distance(const Mesh& input, const Options& options, const NamedParameters& np)
{
  std::vector<Coarsening> results(1);
  Coarsening& result = results[0];
  result.labels.resize(input.num_faces());
  std::size_t most = (std::numeric_limits<std::size_t>::max)();
  if (options.vertex_ratio)
    most = std::size_t((std::max)(std::round(*options.vertex_ratio * double(input.number_of_vertices())), 1.));
  else if (!options.vertices.empty())
    most = options.vertices.front();
  with_placement(options, [&](const auto& placement) {
    const SMC::Distance_report report = SMC::coarsen_mesh_to_distance<CGAL::Parallel_if_available_tag>(
      input, *options.maximum_distance, most, result.mesh,
      np.number_of_iterations(options.iterations.value_or(Defaults::number_of_iterations))
        .convergence_tolerance(options.convergence_tolerance)
        .vertex_placement(placement)
        .face_cluster_map(map_to(result.labels)),
      SMC::parameters::face_patch_map(map_of_patches(result.mesh)));
    result.report = report.clustering;
    result.distance_bound = report.distance_bound;
    result.is_within_distance = report.is_within_distance;
  });
  return results;
}

template <class Clustering>
void make_clusters(Clustering& clustering, const Options& options, const Fields& fields)
{
  if (fields.clusters) {
    clustering.set_clusters(
      boost::make_function_property_map<Face>([&fields](Face f) -> std::int64_t { return fields.clusters[f]; }));
    return;
  }
  if (options.vertex_ratio)
    clustering.seed_from_ratio(*options.vertex_ratio, options.keep_small);
  else if (options.faces)
    clustering.seed_from_number_of_faces(*options.faces, options.iterations.value_or(Defaults::number_of_iterations),
                                         options.convergence_tolerance);
  else if (options.level && !options.vertices.empty())
    clustering.seed_from_level(*options.level, options.vertices.front());
  else if (options.level)
    clustering.seed_from_level(*options.level);
  else
    clustering.seed_faces_or_cells(options.vertices.front());
  clustering.grow();
}

template <class NamedParameters>
std::vector<Coarsening> coarsen_to_numbers(const Mesh& input, const Options& options, const Fields& fields,
                                           const NamedParameters& np)
{
  typedef SMC::Mwcvd_clustering<Mesh, SMC::Any_cluster_energy, CGAL::Parallel_if_available_tag> Clustering;
  Clustering clustering(input, np);
  const std::size_t rounds = options.iterations.value_or(Defaults::number_of_iterations);
  with_placement(options, [&](const auto& placement) {
    clustering.choose_items_for(placement, rounds, options.convergence_tolerance);
  });
  make_clusters(clustering, options, fields);
  clustering.minimize(rounds, options.convergence_tolerance);
  std::vector<Coarsening> results((std::max)(options.vertices.size(), std::size_t(1)));
  for (Coarsening& result : results)
    result.labels.resize(input.num_faces());
  std::vector<std::int64_t>& counts = results[0].boundary_counts;
  counts.resize(input.num_vertices());
  with_placement(options, [&](const auto& placement) {
    clustering.extract_embedded_dual_mesh(results[0].mesh, placement,
                                          SMC::parameters::face_patch_map(map_of_patches(results[0].mesh)));
    results[0].report = clustering.report();
    clustering.write_clusters(map_to(results[0].labels));
    clustering.write_boundary_counts(
      boost::make_function_property_map<Vertex>([&counts](Vertex v) -> std::int64_t& { return counts[v]; }));
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

std::vector<Coarsening> coarsen_with(const SMC::Any_cluster_energy& energy, const Mesh& input, const Options& options,
                                     const Fields& fields, Python_visitor& visitor)
{
  const auto np = parameters_of(options, fields, visitor).cluster_energy(energy);
  const auto run = [&](const auto& all) {
    return options.maximum_distance ? coarsen_to_distance(input, options, all)
                                    : coarsen_to_numbers(input, options, fields, all);
  };
  if (!fields.density)
    return run(np);
  return run(np.face_density_map(
    boost::make_function_property_map<Face>([&fields](Face f) -> double { return fields.density[f]; })));
}

SMC::Any_cluster_energy energy_of(const Options& options)
{
  using namespace coarsen_mesh_tool;
  const bool is_weighted = options.energy == energies().front().first;
  const std::string& wanted = is_weighted ? options.weight : options.energy;
  std::string names;
  for (const auto& [name, energy] : is_weighted ? weighted_energies() : energies()) {
    if (name == wanted)
      return energy;
    names += (names.empty() ? "" : ", ") + name;
  }
  throw SMC::Invalid_input((is_weighted ? "there is no weight '" : "there is no energy '") + wanted + "' (" + names + ")");
}

// Calls `use` with the requested number of threads. Exceptions that the visitor holds replace the cancellation.
template <class Use>
auto with_threads(int threads, const Python_visitor& visitor, const Use& use)
{
  try {
#ifdef CGAL_LINKED_WITH_TBB
    if (threads > 0) // for this call only, independently of other threads of the interpreter
      return tbb::task_arena(threads).execute(use);
#endif
    return use();
  } catch (const SMC::Coarsening_cancelled&) {
    visitor.rethrow();
    throw;
  }
}

} // namespace

std::vector<Coarsening> coarsen(Mesh input, const Options& options, Fields fields, Python_visitor& visitor)
{
  const std::size_t dropped = coarsen_mesh_tool::drop_small_components(input, options.minimum_component_area);
  if (options.keep_borders)
    keep_border_vertices(input, fields);
  const SMC::Any_cluster_energy energy = energy_of(options);
  std::vector<Coarsening> results =
    with_threads(options.threads, visitor, [&] { return coarsen_with(energy, input, options, fields, visitor); });
  for (Coarsening& result : results) {
    result.dropped_components = dropped;
    for (std::size_t f = 0; f < result.labels.size(); ++f)
      if (input.is_removed(Face(Mesh::size_type(f))))
        result.labels[f] = result.mesh.number_of_vertices();
  }
  if (fields.patches) {
    const auto patch = map_of_patches(results[0].mesh);
    results[0].patches.assign(patch.begin(), patch.end());
  }
  return results;
}

std::pair<std::size_t, std::size_t> range_of(Mesh input, const Options& options, Fields fields, Python_visitor& visitor)
{
  coarsen_mesh_tool::drop_small_components(input, options.minimum_component_area);
  if (options.keep_borders)
    keep_border_vertices(input, fields);
  const SMC::Vertex_number_range range = with_threads(options.threads, visitor, [&] {
    return SMC::vertex_number_range(input, parameters_of(options, fields, visitor));
  });
  return {range.least, range.most};
}

} // namespace coarsening_python
