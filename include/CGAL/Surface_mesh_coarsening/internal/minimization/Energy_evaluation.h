// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_EVALUATION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_EVALUATION_H

#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Clustered_face.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The sums of a cluster, with its energy.
template <class Energy>
struct Cluster_sums : Energy::Cluster_data
{
  Index faces = 0;
  double energy = 0;
};

// The optional members of the concept `ClusterEnergy`.
template <class Energy, class = void>
constexpr bool has_trial_energies = false;
template <class Energy>
constexpr bool has_trial_energies<Energy, std::void_t<decltype(std::declval<const Energy&>().energy_with(
                                            std::declval<const typename Energy::Cluster_data&>(),
                                            std::declval<const typename Energy::Face_data&>(), std::size_t()))> > = true;

template <class Energy, class = void>
constexpr bool has_quick_rejection = false;
template <class Energy>
constexpr bool has_quick_rejection<Energy, std::void_t<decltype(std::declval<const Energy&>().cannot_gain(
                                             std::declval<const typename Energy::Cluster_data&>(),
                                             std::declval<const typename Energy::Cluster_data&>(),
                                             std::declval<const typename Energy::Face_data&>()))> > = true;

template <class Energy, class = void>
constexpr bool has_two_passes = false;
template <class Energy>
constexpr bool has_two_passes<Energy, std::void_t<decltype(std::declval<const Energy&>().set_center(
                                        std::declval<typename Energy::Cluster_data&>()))> > = true;

template <class Energy>
using Energy_outcome = std::decay_t<decltype(std::declval<const Energy&>().energy(
  std::declval<const typename Energy::Cluster_data&>(), std::size_t()))>;

template <class Energy, class = void>
constexpr bool keeps_outcomes = false;
template <class Energy>
constexpr bool keeps_outcomes<
  Energy, std::void_t<decltype(std::declval<const Energy&>().keep(std::declval<typename Energy::Cluster_data&>(),
                                                                  std::declval<const Energy_outcome<Energy>&>()))> > = true;

template <class Energy, class = void>
constexpr bool needs_mean_area = false;
template <class Energy>
constexpr bool needs_mean_area<Energy, std::void_t<decltype(std::declval<Energy&>().set_mean_area(0.))> > = true;

// Computes the energy of a cluster, also with an additional face or without a face, by a model of `ClusterEnergy`.
template <class Energy>
class Energy_evaluation
{
public:
  typedef typename Energy::Face_data Face;
  typedef Cluster_sums<Energy> Sums;
  typedef Energy_outcome<Energy> Outcome; // a number, or a class that converts to a number

  Energy_evaluation(const Energy& energy, const Clustering_input& input, std::size_t clusters) : energy_(energy)
  {
    if constexpr (needs_mean_area<Energy>) {
      double area = 0;
      for (const double a : input.area)
        area += a;
      energy_.set_mean_area(area / double(clusters));
    }
  }

  Face terms_of(const Clustering_input& input, Index f) const { return energy_.face_data(Clustered_face(input, f)); }

  // Computes all sums of the clusters.
  void add_up(const Clustering_input& input, const Cluster_labels& labels, std::vector<Sums>& clusters,
              const Cancellation_point& cancellation, Execution execution = Execution::SEQUENTIAL) const
  {
    std::fill(clusters.begin(), clusters.end(), Sums());
    const std::vector<Index>& cluster = labels.labels();
    if constexpr (has_two_passes<Energy>) {
      for_each_in_groups(execution, cluster, clusters.size(), cancellation,
                         [&](Index f) { energy_.add_to_center(clusters[cluster[f]], Clustered_face(input, f)); });
      for (Sums& x : clusters)
        energy_.set_center(x);
    }
    for_each_in_groups(execution, cluster, clusters.size(), cancellation, [&](Index f) {
      Sums& x = clusters[cluster[f]];
      ++x.faces;
      if constexpr (has_two_passes<Energy>)
        energy_.add_about_center(x, terms_of(input, f));
      else
        energy_.add(x, terms_of(input, f));
    });
    for (Sums& x : clusters)
      set(x, energy_.energy(x, x.faces));
  }

  Outcome outcome_with(const Sums& x, const Face& face) const
  {
    if constexpr (has_trial_energies<Energy>)
      return energy_.energy_with(x, face, x.faces + 1);
    typename Energy::Cluster_data with = x;
    energy_.add(with, face);
    return energy_.energy(with, x.faces + 1);
  }

  Outcome outcome_without(const Sums& x, const Face& face) const
  {
    if constexpr (has_trial_energies<Energy>)
      return energy_.energy_without(x, face, x.faces - 1);
    typename Energy::Cluster_data without = x;
    energy_.remove(without, face);
    return energy_.energy(without, x.faces - 1);
  }

  // `outcome` is the result of `outcome_with()`. It is passed because energies are expensive to compute.
  void add(Sums& x, const Face& face, const Outcome& outcome) const
  {
    energy_.add(x, face);
    ++x.faces;
    set(x, outcome);
  }

  // `outcome`: the result of `outcome_without()`.
  void remove(Sums& x, const Face& face, const Outcome& outcome) const
  {
    energy_.remove(x, face);
    --x.faces;
    set(x, outcome);
  }

  // Quick rejection: returns whether the move of a face from cluster `source` to cluster `target` certainly does not lower the
  // energy.
  bool cannot_gain(const Sums& source, const Sums& target, const Face& face) const
  {
    if constexpr (has_quick_rejection<Energy>)
      return energy_.cannot_gain(source, target, face);
    return false;
  }

private:
  void set(Sums& x, const Outcome& outcome) const
  {
    if constexpr (keeps_outcomes<Energy>)
      energy_.keep(x, outcome);
    x.energy = outcome;
  }

  Energy energy_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_ENERGY_EVALUATION_H
