// SPDX-License-Identifier: GPL-3.0-or-later

#include "run_clustering.h"

#include "report/Timing_visitor.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/neighborhood_seeds.h>
#include <CGAL/Surface_mesh_coarsening/paper.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <random>

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
Clustering_run run_with(const Mesh& mesh, unsigned level, double maximum_density, bool with_minimization)
{
  Clustering_run run;
  Timing_visitor visitor(run.times);
  SMC::Mwcvd_clustering<Mesh, Weight> clustering(
    mesh, SMC::parameters::paper_clustering(Weight(), maximum_density).visitor(std::ref(visitor)));
  clustering.seed_from_level(level);
  clustering.seeds(std::back_inserter(run.seeds));
  clustering.grow();
  run.labels_after_growth = labels_of(mesh, clustering);
  if (with_minimization)
    clustering.minimize(SMC::Coarsening_defaults::number_of_iterations, 0);
  run.labels = labels_of(mesh, clustering);
  clustering.extract_dual_mesh(run.dual, SMC::Centroid_placement());
  run.report = clustering.report();
  return run;
}

// Visits the faces in the order of their places.
std::size_t number_of_seeds(const Mesh& mesh, unsigned level, const std::vector<std::size_t>& place)
{
  std::vector<Face> seeds;
  SMC::neighborhood_seeds(mesh, level, std::back_inserter(seeds),
                          SMC::parameters::face_index_map(CGAL::make_property_map(place)));
  return seeds.size();
}

} // namespace

Clustering_run run_clustering(const Mesh& mesh, unsigned level, Paper_weight weight, double maximum_density,
                              bool with_minimization)
{
  switch (weight) {
  case AREA:
    return run_with<SMC::Weighted_area_weight>(mesh, level, maximum_density, with_minimization);
  case MAXIMUM:
    return run_with<SMC::Maximum_density_weight>(mesh, level, maximum_density, with_minimization);
  case VARIANCE:
    break;
  }
  return run_with<SMC::Density_variance_weight>(mesh, level, maximum_density, with_minimization);
}

std::size_t seeds_in_breadth_first_order(const Mesh& mesh, unsigned level)
{
  std::vector<std::size_t> place(mesh.number_of_faces(), mesh.number_of_faces());
  std::vector<Face> order;
  const auto reach = [&](Face f) {
    if (place[f] == place.size()) {
      place[f] = order.size();
      order.push_back(f);
    }
  };
  for (Face first : mesh.faces()) {
    const std::size_t begin = order.size();
    reach(first);
    for (std::size_t i = begin; i < order.size(); ++i)
      for (Face f : mesh.faces_around_face(mesh.halfedge(order[i])))
        if (f != mesh.null_face())
          reach(f);
  }
  return number_of_seeds(mesh, level, place);
}

std::pair<std::size_t, std::size_t> seeds_in_random_orders(const Mesh& mesh, unsigned level)
{
  std::mt19937 engine;
  std::vector<std::size_t> place(mesh.number_of_faces());
  std::iota(place.begin(), place.end(), std::size_t(0));
  std::pair<std::size_t, std::size_t> range(mesh.number_of_faces(), 0);
  for (int order = 0; order < 10; ++order) {
    for (std::size_t i = place.size(); i > 1; --i)
      std::swap(place[i - 1], place[engine() % i]);
    const std::size_t seeds = number_of_seeds(mesh, level, place);
    range = {(std::min)(range.first, seeds), (std::max)(range.second, seeds)};
  }
  return range;
}

double deviation_of_areas(const Mesh& mesh, const std::vector<std::size_t>& labels)
{
  std::vector<double> area(*std::max_element(labels.begin(), labels.end()) + 1, 0);
  for (Face f : mesh.faces())
    area[labels[f]] += CGAL::Polygon_mesh_processing::face_area(f, mesh);
  const double mean = std::accumulate(area.begin(), area.end(), 0.) / double(area.size());
  double sum = 0;
  for (const double a : area)
    sum += (a - mean) * (a - mean);
  return std::sqrt(sum / double(area.size())) / mean;
}

double deviation_of_areas_after_merging(const Mesh& mesh, unsigned level)
{
  SMC::Mwcvd_clustering<Mesh, SMC::Uniform_weight> clustering(mesh, SMC::parameters::paper_clustering(SMC::Uniform_weight()));
  clustering.seed_from_level(level, clustering.seed_from_level(level) / 2);
  clustering.grow();
  return deviation_of_areas(mesh, labels_of(mesh, clustering));
}

std::size_t components_with_clusters_beyond_seeds(const Mesh& mesh, const Clustering_run& run)
{
  std::vector<std::size_t> component(mesh.number_of_faces());
  std::vector<std::ptrdiff_t> beyond(
    CGAL::Polygon_mesh_processing::connected_components(mesh, CGAL::make_property_map(component)), 0);
  std::vector<bool> is_counted(run.report.clusters, false);
  for (Face f : mesh.faces())
    if (!is_counted[run.labels[f]]) {
      is_counted[run.labels[f]] = true;
      ++beyond[component[f]];
    }
  for (Face f : run.seeds)
    --beyond[component[f]];
  return std::size_t(std::count_if(beyond.begin(), beyond.end(), [](std::ptrdiff_t b) { return b > 0; }));
}

Clustering_run run_uniform_clustering(const Mesh& mesh, unsigned level, double maximum_density)
{
  return run_with<SMC::Uniform_weight>(mesh, level, maximum_density, true);
}

} // namespace reproduce_paper
