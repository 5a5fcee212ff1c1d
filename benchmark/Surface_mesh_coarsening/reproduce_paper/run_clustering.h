// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef REPRODUCE_PAPER_RUN_CLUSTERING_H
#define REPRODUCE_PAPER_RUN_CLUSTERING_H

#include "report/Stage_times.h"
#include "Paper_model.h"

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>

#include <cstddef>
#include <vector>

namespace reproduce_paper {

struct Clustering_run
{
  std::vector<std::size_t> labels_after_growth, labels; // per face
  Mesh dual;
  CGAL::Surface_mesh_coarsening::Coarsening_report report;
  Stage_times times;
};

// Runs the steps of the paper one after the other.
Clustering_run run_clustering(const Mesh& mesh, unsigned level, Paper_weight weight, double maximum_density);

// Runs them with equal weights for all clusters: the ordinary centroidal Voronoi diagram that the paper compares with.
Clustering_run run_uniform_clustering(const Mesh& mesh, unsigned level, double maximum_density);

} // namespace reproduce_paper

#endif // REPRODUCE_PAPER_RUN_CLUSTERING_H
