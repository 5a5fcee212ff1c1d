// SPDX-License-Identifier: GPL-3.0-or-later

#include "coarsening.h"

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
#include <CGAL/Surface_mesh_coarsening/parameters.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <functional>

namespace coarsen_mesh_tool {

namespace SMC = CGAL::Surface_mesh_coarsening;

namespace {

template <class Clustering>
void extract(const Clustering& clustering, const std::string& placement, Mesh& output)
{
  if (placement == "centroid")
    clustering.extract_dual_mesh(output, SMC::Centroid_placement());
  else if (placement == "closest-vertex")
    clustering.extract_dual_mesh(output, SMC::Closest_vertex_placement());
  else if (placement == "quadric")
    clustering.extract_dual_mesh(output, SMC::Quadric_placement());
  else
    clustering.extract_dual_mesh(output, SMC::Fitted_placement());
}

template <class Weight>
Coarsening_result coarsen_with(const Mesh& input, const Options& options, Tool_visitor& visitor)
{
  Coarsening_result result;
  SMC::Mwcvd_clustering<Mesh, Weight, CGAL::Parallel_if_available_tag> clustering(
    input, SMC::parameters::maximum_density(options.maximum_density)
             .minimum_component_area(options.minimum_component_area)
             .subdivide_input(options.subdivide)
             .visitor(std::ref(visitor)));
  const unsigned default_level = 7;
  if (options.vertices)
    clustering.seed(*options.vertices);
  else
    clustering.seed_from_level(options.neighborhood_level.value_or(default_level));
  clustering.grow();
  clustering.minimize(options.rounds.value_or(clustering.default_number_of_iterations));
  extract(clustering, options.placement, result.mesh);
  result.report = clustering.report();
  result.labels.reserve(input.number_of_faces());
  for (Face f : input.faces())
    result.labels.push_back(clustering.cluster(f));
  return result;
}

struct Named_weight
{
  std::string name;
  Coarsening_result (*coarsen)(const Mesh&, const Options&, Tool_visitor&);
};

const std::vector<Named_weight>& weights()
{
  static const std::vector<Named_weight> all = {{"uniform", coarsen_with<SMC::Uniform_weight>},
                                                {"area", coarsen_with<SMC::Weighted_area_weight>},
                                                {"maximum", coarsen_with<SMC::Maximum_density_weight>},
                                                {"exact-maximum", coarsen_with<SMC::Exact_maximum_density_weight>},
                                                {"variance", coarsen_with<SMC::Density_variance_weight>}};
  return all;
}

} // namespace

const std::vector<std::string>& weight_names()
{
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const Named_weight& weight : weights())
      result.push_back(weight.name);
    return result;
  }();
  return names;
}

const std::vector<std::string>& placement_names()
{
  static const std::vector<std::string> names = {"centroid", "closest-vertex", "quadric", "fitted"};
  return names;
}

unsigned most_threads()
{
#ifdef CGAL_LINKED_WITH_TBB
  return unsigned(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
#else
  return 1;
#endif
}

std::string default_weight() { return "area"; }

std::string default_placement() { return "fitted"; }

Coarsening_result coarsen(const Mesh& input, const Options& options, Tool_visitor& visitor)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, options.threads);
#endif
  for (const Named_weight& weight : weights())
    if (weight.name == options.weight)
      return weight.coarsen(input, options, visitor);
  throw Wrong_usage("there is no weight '" + options.weight + "'");
}

} // namespace coarsen_mesh_tool
