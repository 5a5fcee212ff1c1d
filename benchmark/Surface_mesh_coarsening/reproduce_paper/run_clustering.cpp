// SPDX-License-Identifier: GPL-3.0-or-later

#include "run_clustering.h"

#include "report/Timing_visitor.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/parameters.h>

#include <functional>

namespace reproduce_paper {
namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;

template <class Clustering>
std::vector<std::size_t> labels_of(const Mesh& mesh, const Clustering& clustering)
{
  std::vector<std::size_t> labels;
  labels.reserve(mesh.number_of_faces());
  for (Face f : mesh.faces())
    labels.push_back(clustering.cluster(f));
  return labels;
}

template <class Weight>
Clustering_run run_with(const Mesh& mesh, unsigned level, double maximum_density)
{
  Clustering_run run;
  Timing_visitor visitor(run.times);
  SMC::Mwcvd_clustering<Mesh, Weight> clustering(
    mesh, SMC::parameters::maximum_density(maximum_density).border_densities(false).visitor(std::ref(visitor)));
  clustering.seed_from_level(level);
  clustering.grow();
  run.labels_after_growth = labels_of(mesh, clustering);
  clustering.minimize(clustering.default_number_of_iterations, 0); // the paper's end
  run.labels = labels_of(mesh, clustering);
  clustering.extract_dual_mesh(run.dual);
  run.report = clustering.report();
  return run;
}

} // namespace

Clustering_run run_clustering(const Mesh& mesh, unsigned level, Paper_weight weight, double maximum_density)
{
  switch (weight) {
  case AREA:
    return run_with<SMC::Weighted_area_weight>(mesh, level, maximum_density);
  case MAXIMUM:
    return run_with<SMC::Maximum_density_weight>(mesh, level, maximum_density);
  case VARIANCE:
    break;
  }
  return run_with<SMC::Density_variance_weight>(mesh, level, maximum_density);
}

Clustering_run run_uniform_clustering(const Mesh& mesh, unsigned level, double maximum_density)
{
  return run_with<SMC::Uniform_weight>(mesh, level, maximum_density);
}

} // namespace reproduce_paper
