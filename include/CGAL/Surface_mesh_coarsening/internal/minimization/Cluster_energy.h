// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_CLUSTER_ENERGY_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_CLUSTER_ENERGY_H

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Trial_move.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Moments.h>

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The terms of a face in the energy.
template <class Weight>
struct Face_terms
{
  double mass;
  Vector centroid;
  typename Weight::Face_data data;
};

// The terms of the energy (8) of a cluster, which is the weight times the inertia about the centroid (7).
template <class Weight>
struct Cluster_sums : Moments
{
  double weight = 0;
  double energy = 0; // weight times inertia
  Index faces = 0;
  typename Weight::Cluster_data data;
};

// An optional member of the concept `ClusterWeight`: `cannot_gain(trial_move)` judges moves by moments.
template <class Weight, class = void>
constexpr bool judges_moves = false;
template <class Weight>
constexpr bool judges_moves<
  Weight, std::void_t<decltype(std::declval<const Weight&>().cannot_gain(std::declval<const Trial_move&>()))> > = true;

// Optional members: `min_weight_with(data, face, weight)` and `min_weight_without(data, face, weight)` bound the weight
// after a move from below; `weight` is the current one.
template <class Weight, class = void>
constexpr bool has_bounds = false;
template <class Weight>
constexpr bool has_bounds<Weight, std::void_t<decltype(std::declval<const Weight&>().min_weight_with(
                                    std::declval<const typename Weight::Cluster_data&>(),
                                    std::declval<const typename Weight::Face_data&>(), 0.))> > = true;

// The energy of a cluster, also with one face more or less.
template <class Weight>
class Cluster_energy
{
public:
  typedef Face_terms<Weight> Face;
  typedef Cluster_sums<Weight> Sums;

  explicit Cluster_energy(const Weight& weight) : weight_(weight) {}

  Face terms_of(const Clustering_input& input, Index f) const
  {
    return {input.mass(f), input.centroid(f), weight_.face_data(input.density[f], input.area[f])};
  }

  // Computes all sums of the clusters.
  void add_up(const Clustering_input& input, const Cluster_labels& labels, std::vector<Sums>& clusters,
              const Cancellation_point& cancellation, Execution execution = Execution::SEQUENTIAL) const
  {
    std::fill(clusters.begin(), clusters.end(), Sums());
    const auto add_data = [&](Sums& x, Index f) {
      ++x.faces;
      weight_.add(x.data, weight_.face_data(input.density[f], input.area[f]));
    };
    add_up_moments(input, labels, clusters, cancellation, execution, add_data);
    for (Sums& x : clusters)
      update_energy(x);
  }

  static double squared_distance(const Face& face, const Sums& x)
  {
    const Vector d = face.centroid - x.centroid;
    return dot(d, d);
  }

  // Returns the inertia after a mass has joined or left, by the parallel axis theorem.
  static double inertia_with(const Sums& x, double mass, double sum, double squared_distance)
  {
    return x.inertia + (sum > 0 ? mass * x.mass / sum * squared_distance : 0);
  }
  static double inertia_without(const Sums& x, double mass, double rest, double squared_distance)
  {
    return (std::max)(0., x.inertia - (rest > 0 ? mass * x.mass / rest * squared_distance : 0));
  }

  // Weight and energy of a cluster after a face has joined or left.
  struct Outcome
  {
    double weight = 0;
    double energy = 0;
  };

  Outcome outcome_with(const Sums& x, const Face& face) const
  {
    const double mass = x.mass + face.mass;
    if (!(mass > 0))
      return {};
    const double weight = weight_.weight_with(x.data, face.data, mass, x.faces + 1);
    return {weight, weight * inertia_with(x, face.mass, mass, squared_distance(face, x))};
  }

  Outcome outcome_without(const Sums& x, const Face& face) const
  {
    const double mass = x.mass - face.mass;
    if (!(mass > 0))
      return {};
    const double weight = weight_.weight_without(x.data, face.data, mass, x.faces - 1);
    return {weight, weight * inertia_without(x, face.mass, mass, squared_distance(face, x))};
  }

  // `outcome`: the result of `outcome_with()`, passed because weights take long to compute.
  void add(Sums& x, const Face& face, const Outcome& outcome) const
  {
    const double mass = x.mass + face.mass;
    x.inertia = inertia_with(x, face.mass, mass, squared_distance(face, x));
    if (mass > 0)
      x.centroid = x.centroid + (face.mass / mass) * (face.centroid - x.centroid);
    x.mass = mass;
    ++x.faces;
    weight_.add(x.data, face.data);
    set(x, outcome);
  }

  // `outcome`: the result of `outcome_without()`.
  void remove(Sums& x, const Face& face, const Outcome& outcome) const
  {
    const double mass = x.mass - face.mass;
    x.inertia = inertia_without(x, face.mass, mass, squared_distance(face, x));
    if (mass > 0)
      x.centroid = x.centroid - (face.mass / mass) * (face.centroid - x.centroid);
    x.mass = mass;
    --x.faces;
    weight_.remove(x.data, face.data);
    set(x, outcome);
  }

  // Quick rejection: returns whether moments, or bounds of the weights, show that moving a face from cluster `source`
  // to cluster `target` gains nothing.
  bool cannot_gain(const Sums& source, const Sums& target, const Face& face) const
  {
    const double rest = source.mass - face.mass, sum = target.mass + face.mass;
    if (!(rest > 0))
      return false;
    if constexpr (judges_moves<Weight>)
      return weight_.cannot_gain(Trial_move{face.mass, source.mass, source.inertia, squared_distance(face, source), target.mass,
                                            target.inertia, squared_distance(face, target)});
    else if constexpr (has_bounds<Weight>)
      return source.energy + target.energy <
             weight_.min_weight_without(source.data, face.data, source.weight) *
                 inertia_without(source, face.mass, rest, squared_distance(face, source)) +
               weight_.min_weight_with(target.data, face.data, target.weight) *
                 inertia_with(target, face.mass, sum, squared_distance(face, target));
    else
      return false;
  }

private:
  void update_energy(Sums& x) const
  {
    const double weight = x.mass > 0 ? weight_.weight(x.data, x.mass, x.faces) : 0;
    set(x, {weight, weight * x.inertia});
  }

  static void set(Sums& x, const Outcome& outcome)
  {
    x.weight = outcome.weight;
    x.energy = outcome.energy;
  }

  Weight weight_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_CLUSTER_ENERGY_H
