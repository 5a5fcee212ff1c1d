// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTER_ENERGY_WEIGHTED_INERTIA_ENERGY_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTER_ENERGY_WEIGHTED_INERTIA_ENERGY_H

#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Clustered_face.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Additive_cluster_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Moments.h>

#include <boost/type_traits/is_detected.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL::Surface_mesh_coarsening {
/// \cond SKIP_IN_MANUAL
namespace internal {

// Optional member of the concept `ClusterWeight`: `cannot_gain(trial_move)` rejects moves by their moments.
template <class Weight>
using Judgement_of_move = decltype(std::declval<const Weight&>().cannot_gain(std::declval<const Trial_move&>()));
template <class Weight>
constexpr bool judges_moves = boost::is_detected_v<Judgement_of_move, Weight>;

// Optional members: `min_weight_with(data, face, weight)` and `min_weight_without(data, face, weight)` are lower bounds of the
// weight after a move; `weight` is the current weight.
template <class Weight>
using Bound_of_weight = decltype(std::declval<const Weight&>().min_weight_with(
  std::declval<const typename Weight::Cluster_data&>(), std::declval<const typename Weight::Face_data&>(), 0.));
template <class Weight>
constexpr bool has_bounds = boost::is_detected_v<Bound_of_weight, Weight>;

// Optional member of the concepts `ClusterWeight` and `ClusterEnergy`.
template <class Model, class = void>
constexpr bool depends_on_densities = true;
template <class Model>
constexpr bool depends_on_densities<Model, std::void_t<decltype(Model::depends_on_densities)> > = Model::depends_on_densities;

} // namespace internal
/// \endcond

/// \ingroup PkgSurfaceMeshCoarseningEnergies
/// \cgalModels `ClusterEnergy`
///
/// The energy of the paper, \f$ w_i \sum_j \rho_j A_j |g_j - z_i|^2 \f$ (section 5.1, formula (8)): the weight of the cluster
/// times the inertia of its faces about their centroid \f$ z_i \f$. Named parameter `cluster_weight` selects the weight.
///
/// \tparam ClusterWeight a model of `ClusterWeight`
template <class ClusterWeight = Weighted_area_weight>
class Weighted_inertia_energy
{
public:
  /// \cond SKIP_IN_MANUAL
  static constexpr bool depends_on_densities = internal::depends_on_densities<ClusterWeight>;

  struct Face_data
  {
    double mass;
    internal::Vector centroid;
    typename ClusterWeight::Face_data data;
  };

  struct Cluster_data : internal::Moments
  {
    double weight = 0;
    typename ClusterWeight::Cluster_data data{};
  };

  // An energy together with its weight, which is expensive to compute.
  struct Outcome
  {
    double weight = 0;
    double energy = 0;
    operator double() const { return energy; }
  };
  /// \endcond

  /// \param weight the weight
  explicit Weighted_inertia_energy(const ClusterWeight& weight = ClusterWeight()) : weight_(weight) {}

  /// \cond SKIP_IN_MANUAL
  Face_data face_data(const Clustered_face& face) const
  {
    return {face.mass(), face.plain_centroid(), weight_.face_data(face.density(), face.area())};
  }

  void add(Cluster_data& x, const Face_data& face) const
  {
    x.join(face.mass, face.centroid);
    weight_.add(x.data, face.data);
  }
  void remove(Cluster_data& x, const Face_data& face) const
  {
    x.leave(face.mass, face.centroid);
    weight_.remove(x.data, face.data);
  }

  void add_to_center(Cluster_data& x, const Clustered_face& face) const { x.add_to_centroid(face.mass(), face.plain_centroid()); }
  void set_center(Cluster_data& x) const { x.end_centroid(); }
  void add_about_center(Cluster_data& x, const Face_data& face) const
  {
    x.add_to_inertia(face.mass, face.centroid);
    weight_.add(x.data, face.data);
  }

  Outcome energy(const Cluster_data& x, std::size_t faces) const
  {
    const double weight = x.mass > 0 ? weight_.weight(x.data, x.mass, faces) : 0;
    return {weight, weight * x.inertia};
  }
  Outcome energy_with(const Cluster_data& x, const Face_data& face, std::size_t faces) const
  {
    const double mass = x.mass + face.mass;
    if (!(mass > 0))
      return {};
    const double weight = weight_.weight_with(x.data, face.data, mass, faces);
    return {weight, weight * x.inertia_with(face.mass, mass, x.squared_distance(face.centroid))};
  }
  Outcome energy_without(const Cluster_data& x, const Face_data& face, std::size_t faces) const
  {
    const double mass = x.mass - face.mass;
    if (!(mass > 0))
      return {};
    const double weight = weight_.weight_without(x.data, face.data, mass, faces);
    return {weight, weight * x.inertia_without(face.mass, mass, x.squared_distance(face.centroid))};
  }
  void keep(Cluster_data& x, const Outcome& outcome) const { x.weight = outcome.weight; }

  // Rejects a move by its moments, or by bounds of the weights.
  bool cannot_gain(const Cluster_data& source, const Cluster_data& target, const Face_data& face) const
  {
    const double rest = source.mass - face.mass, sum = target.mass + face.mass;
    if (!(rest > 0))
      return false;
    if constexpr (internal::judges_moves<ClusterWeight>)
      return weight_.cannot_gain(Trial_move{face.mass, source.mass, source.inertia, source.squared_distance(face.centroid),
                                            target.mass, target.inertia, target.squared_distance(face.centroid)});
    else if constexpr (internal::has_bounds<ClusterWeight>)
      return source.weight * source.inertia + target.weight * target.inertia <
             weight_.min_weight_without(source.data, face.data, source.weight) *
                 source.inertia_without(face.mass, rest, source.squared_distance(face.centroid)) +
               weight_.min_weight_with(target.data, face.data, target.weight) *
                 target.inertia_with(face.mass, sum, target.squared_distance(face.centroid));
    else
      return false;
  }
  /// \endcond

private:
  ClusterWeight weight_;
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTER_ENERGY_WEIGHTED_INERTIA_ENERGY_H
