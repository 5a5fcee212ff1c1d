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
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/parameters.h>

#include <functional>

namespace coarsen_mesh_tool {

namespace SMC = CGAL::Surface_mesh_coarsening;

namespace {

template <class Weight, class Placement>
Coarsening_result coarsen_as(const Mesh& input, const Options& options, Tool_visitor& visitor)
{
  Coarsening_result result;
  const auto label = get(CGAL::dynamic_face_property_t<std::size_t>(), input);
  const unsigned default_level = 7;
  const std::size_t default_rounds = SMC::Mwcvd_clustering<Mesh, Weight>::default_number_of_iterations;
  // The one place where a number of threads would be handed on; the library computes on one.
  const auto np = SMC::parameters::cluster_weight(Weight())
                    .vertex_placement(Placement())
                    .maximum_density(options.maximum_density)
                    .neighborhood_level(options.neighborhood_level.value_or(default_level))
                    .number_of_iterations(options.rounds.value_or(default_rounds))
                    .face_cluster_map(label)
                    .visitor(std::ref(visitor));
  if (options.vertices)
    result.report = SMC::coarsen_mesh(input, *options.vertices, result.mesh, np);
  else
    result.report = SMC::coarsen_mesh(input, result.mesh, np);
  result.labels.reserve(input.number_of_faces());
  for (Face f : input.faces())
    result.labels.push_back(get(label, f));
  return result;
}

template <class Weight>
Coarsening_result coarsen_with(const Mesh& input, const Options& options, Tool_visitor& visitor)
{
  return options.placement == "closest-vertex"
           ? coarsen_as<Weight, SMC::Closest_vertex_placement>(input, options, visitor)
           : coarsen_as<Weight, SMC::Centroid_placement>(input, options, visitor);
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
  static const std::vector<std::string> names = {"centroid", "closest-vertex"};
  return names;
}

std::string default_weight() { return "maximum"; }

std::string default_placement() { return "centroid"; }

Coarsening_result coarsen(const Mesh& input, const Options& options, Tool_visitor& visitor)
{
  for (const Named_weight& weight : weights())
    if (weight.name == options.weight)
      return weight.coarsen(input, options, visitor);
  throw Wrong_usage("there is no weight '" + options.weight + "'");
}

} // namespace coarsen_mesh_tool
