// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgSurfaceMeshCoarseningConcepts
/// \cgalConcept
///
/// The concept `ClusterWeight` describes the factor \f$ w_i \f$ of a cluster in the energy (8). The factor is part of
/// `CGAL::Surface_mesh_coarsening::Weighted_inertia_energy`. To replace the whole energy, use `ClusterEnergy`.
///
/// A weight is a function of the densities and areas of the faces of a cluster. The minimization computes weights once or twice
/// per trial move, so it does not pass the faces. `Face_data` holds the terms of a face, and `Cluster_data` the sums of a
/// cluster, which `add()` and `remove()` update when a face joins or leaves.
///
/// The weight must depend only on the set of faces of a cluster, not on the order in which they joined: the proof that the
/// minimization terminates requires that the energy is a function of the clustering. The weight must be finite and must not be
/// negative.
///
/// Derive a weight that is a function of a few sums from `CGAL::Surface_mesh_coarsening::Additive_cluster_weight`, which adds
/// `weight_with()` and `weight_without()`.
///
/// Most trial moves do not lower the energy. The optional member
/// `bool cannot_gain(const CGAL::Surface_mesh_coarsening::Trial_move& move) const` rejects such moves by the moments of the two
/// clusters, before any weight is computed. It returns `true` only if the energy does not decrease. `Uniform_weight` and
/// `Weighted_area_weight` have this member.
///
/// If a weight is expensive to compute, lower bounds save most of the work. The optional members
/// `double min_weight_with(const Cluster_data& data, const Face_data& face, double weight) const`
/// and `double min_weight_without(const Cluster_data& data, const Face_data& face, double weight) const` receive the current
/// weight of the cluster in `weight`. They return numbers that do not exceed the weights with and without the face, also after
/// rounding. `Maximum_density_weight` has these members.
///
/// An object that is not passed as named parameter `cluster_weight` is default constructed. If an object is passed, the
/// default constructor is not needed.
///
/// \cgalRefines{`CopyConstructible`}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{`CGAL::Surface_mesh_coarsening::Uniform_weight`}
/// \cgalHasModels{`CGAL::Surface_mesh_coarsening::Weighted_area_weight`}
/// \cgalHasModels{`CGAL::Surface_mesh_coarsening::Maximum_density_weight`}
/// \cgalHasModels{`CGAL::Surface_mesh_coarsening::Exact_maximum_density_weight`}
/// \cgalHasModels{`CGAL::Surface_mesh_coarsening::Density_variance_weight`}
/// \cgalHasModelsEnd
class ClusterWeight
{
public:
  /// Optional: whether clusters become smaller where densities are raised; `true` if it is missing. If it is `false`, the mesh is
  /// not reclustered with other densities where triangles of the output intersect.
  static constexpr bool depends_on_densities = unspecified_value;

  /// The terms of a face, a model of `CopyConstructible`.
  typedef unspecified_type Face_data;

  /// The sums of a cluster, a model of `DefaultConstructible` and `CopyAssignable`. A default constructed object holds the sums
  /// of a cluster without faces.
  typedef unspecified_type Cluster_data;

  /// returns the terms of a face with density `density` and area `area`. The function may be called several times for a face.
  Face_data face_data(double density, double area) const;

  /// updates `data` after face `face` has joined the cluster.
  void add(Cluster_data& data, const Face_data& face) const;

  /// updates `data` after face `face` has left the cluster.
  void remove(Cluster_data& data, const Face_data& face) const;

  /// returns the weight of the cluster with data `data`. `mass` is its mass, the sum of density times area over its faces, and
  /// `faces` is the number of its faces, at least one.
  double weight(const Cluster_data& data, double mass, std::size_t faces) const;

  /// returns the weight of the cluster with data `data` after face `face`, which does not belong to it, has joined. `mass` and
  /// `faces` are the mass of the cluster and the number of its faces after the move.
  double weight_with(const Cluster_data& data, const Face_data& face, double mass, std::size_t faces) const;

  /// returns the weight of the cluster with data `data` after face `face`, which belongs to it, has left. `mass` and `faces` are
  /// the mass of the cluster and the number of its faces after the move, at least one.
  double weight_without(const Cluster_data& data, const Face_data& face, double mass, std::size_t faces) const;
};
