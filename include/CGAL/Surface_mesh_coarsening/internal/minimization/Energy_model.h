// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_MODEL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_MODEL_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The end of a minimization: after a number of rounds, or with the first round that lowers the energy by at most the
// relative amount `tolerance`.
struct Minimization_end
{
  std::size_t max_rounds = 0;
  double tolerance = 0;
};

// What was done in rounds of a minimization. Moves that would lower the energy are refused by the paper's check of boundary-edge
// counts, or, after passing it, because the dual would not be a surface.
struct Minimization_progress
{
  std::size_t rounds = 0, moves = 0, tests = 0, refused_by_boundary_counts = 0, refused_by_guarantee = 0;

  // Adds what was done in parts of the clustering that run their rounds at the same time.
  Minimization_progress& operator+=(const Minimization_progress& other)
  {
    rounds = (std::max)(rounds, other.rounds);
    moves += other.moves;
    tests += other.tests;
    refused_by_boundary_counts += other.refused_by_boundary_counts;
    refused_by_guarantee += other.refused_by_guarantee;
    return *this;
  }
};

// A minimization in progress, independent of the type of the energy.
class Minimization
{
public:
  virtual ~Minimization() = default;
  // Runs rounds until the end. Parts of the clustering may reach it earlier than others.
  virtual Minimization_progress run(const Minimization_end& end) = 0;
  // Returns the number of rounds that a call should run.
  virtual std::size_t rounds_at_a_time() const = 0;
  virtual double energy() const = 0;
};

// The energy of a clustering with its type erased: the stages of the pipeline are compiled once for all energies.
class Energy_model
{
public:
  virtual ~Energy_model() = default;
  virtual std::unique_ptr<Minimization> minimization(const Featured_input& input, Cluster_labels& labels, std::size_t clusters,
                                                     bool checks_boundary_counts, const Run_context& context) const = 0;
  // Computes the energies and weights of the clusters; the other members remain empty.
  virtual std::vector<Cluster_report> cluster_reports(const Clustering_input& input, const Cluster_labels& labels,
                                                      std::size_t clusters) const = 0;
  virtual bool depends_on_densities() const = 0;
  // Whether this is the energy of a clustering for which none is chosen.
  virtual bool is_default() const = 0;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_MODEL_H
