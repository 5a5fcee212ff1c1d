// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef REPRODUCE_PAPER_RUN_CLUSTERING_H
#define REPRODUCE_PAPER_RUN_CLUSTERING_H

#include "report/Stage_times.h"
#include "Paper_model.h"

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace reproduce_paper {

struct Clustering_run
{
  std::vector<Face> seeds;
  std::vector<std::size_t> labels_after_growth, labels; // per face
  Mesh dual;
  CGAL::Surface_mesh_coarsening::Coarsening_report report;
  Stage_times times;
};

// Runs the steps of the paper one after the other. Without rounds of minimization, the dual is that of seeds and
// growth.
Clustering_run run_clustering(const Mesh& mesh, unsigned level, Paper_weight weight, double maximum_density,
                              bool with_minimization = true);

// Runs them with equal weights for all clusters: the ordinary centroidal Voronoi diagram that the paper compares with.
Clustering_run run_uniform_clustering(const Mesh& mesh, unsigned level, double maximum_density);

// The number of seeds if the faces are visited in breadth-first order across edges, from the first face of each component. Seeds
// are then dense: each is as near to the previous ones as it may be.
std::size_t seeds_in_breadth_first_order(const Mesh& mesh, unsigned level);

// The smallest and the largest number of seeds in ten random orders of the faces.
std::pair<std::size_t, std::size_t> seeds_in_random_orders(const Mesh& mesh, unsigned level);

// The relative standard deviation of the areas of the clusters.
double deviation_of_areas(const Mesh& mesh, const std::vector<std::size_t>& labels);

// The same for the seeds of a level, after growth and after their clusters are merged to half their number by area (section 6).
double deviation_of_areas_after_merging(const Mesh& mesh, unsigned level);

// The number of connected components that have more clusters than seeds.
std::size_t components_with_clusters_beyond_seeds(const Mesh& mesh, const Clustering_run& run);

} // namespace reproduce_paper

#endif // REPRODUCE_PAPER_RUN_CLUSTERING_H
