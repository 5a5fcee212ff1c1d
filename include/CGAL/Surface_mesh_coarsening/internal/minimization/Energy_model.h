// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_MODEL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_MODEL_H

#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_minimization.h>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The energy of a clustering, without the type of its weight: the stages of the pipeline are compiled once for all weights.
class Energy_model
{
public:
  virtual ~Energy_model() = default;
  virtual std::unique_ptr<Minimization> minimization(const Clustering_input& input, Cluster_labels& labels,
                                                     std::size_t clusters, const Cancellation_point& cancellation,
                                                     Execution execution) const = 0;
  virtual double energy(const Clustering_input& input, const Cluster_labels& labels, std::size_t clusters) const = 0;
  virtual bool depends_on_densities() const = 0;
};

template <class Weight, class = void>
constexpr bool depends_on_densities = true;
template <class Weight>
constexpr bool depends_on_densities<Weight, std::void_t<decltype(Weight::depends_on_densities)> > = Weight::depends_on_densities;

template <class Weight>
class Weighted_energy_model : public Energy_model
{
public:
  explicit Weighted_energy_model(const Weight& weight) : weight_(weight) {}

  std::unique_ptr<Minimization> minimization(const Clustering_input& input, Cluster_labels& labels, std::size_t clusters,
                                             const Cancellation_point& cancellation, Execution execution) const override
  {
    return std::make_unique<Energy_minimization<Weight> >(input, labels, clusters, weight_, cancellation, execution);
  }

  double energy(const Clustering_input& input, const Cluster_labels& labels, std::size_t clusters) const override
  {
    std::vector<Cluster_sums<Weight> > sums(clusters);
    Cluster_energy<Weight>(weight_).add_up(input, labels, sums, Cancellation_point());
    double energy = 0;
    for (const Cluster_sums<Weight>& x : sums)
      energy += x.energy;
    return energy;
  }

  bool depends_on_densities() const override { return internal::depends_on_densities<Weight>; }

private:
  Weight weight_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_MODEL_H
