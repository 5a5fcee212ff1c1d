// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgSurfaceMeshCoarseningConcepts
/// \cgalConcept
///
/// The concept `ClusterWeight` describes the factor \f$ w_i \f$ by which the energy (8) of a cluster is multiplied.
/// It is part of `CGAL::Surface_mesh_coarsening::Weighted_inertia_energy`; to replace the whole energy, see `ClusterEnergy`.
///
/// A weight is a function of the faces of a cluster, of their densities and areas. It is asked for once or twice per trial
/// move of the minimization, which is why it does not get to see the faces: it keeps what it needs of each face in a
/// `Face_data`, and what it needs of each cluster in a `Cluster_data`, which is brought up to date when a face comes or goes.
///
/// The weight has to depend on the set of the faces of a cluster alone, not on the order in which they came: only then is
/// the energy a function of the clustering, which the proof that the minimization ends relies on. It has to be finite and
/// must not be negative.
///
/// A weight that is a function of a few sums is best derived from
/// `CGAL::Surface_mesh_coarsening::Additive_cluster_weight`, which adds `weight_with()` and `weight_without()`.
///
/// Most trial moves gain nothing. A weight may have a member
/// `bool cannot_gain(const CGAL::Surface_mesh_coarsening::Trial_move& move) const` that says so from the moments of the two
/// clusters, before any weight is computed. It returns `true` only if the energy does not fall. `Uniform_weight` and
/// `Weighted_area_weight` have it.
///
/// If a weight takes long to compute, bounds of it can spare most of the work. A weight may
/// have two more members for this, `double min_weight_with(const Cluster_data& data, const Face_data& face, double weight) const`
/// and `double min_weight_without(const Cluster_data& data, const Face_data& face, double weight) const`, where `weight` is that
/// of the cluster now. They return numbers that are not larger than the weights with and without the face, also after
/// rounding. `Maximum_density_weight` has them.
///
/// An object that is not passed as named parameter `cluster_weight` is default constructed; otherwise the default
/// constructor is not needed.
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
  /// Optional: whether clusters become smaller where densities are raised; `true` if it is missing. With `false` no clustering is
  /// repeated with other densities where triangles of the output intersect.
  static constexpr bool depends_on_densities = unspecified_value;

  /// What is kept of each face. It has to be a model of `CopyConstructible`.
  typedef unspecified_type Face_data;

  /// What is kept of each cluster. It has to be a model of `DefaultConstructible` and `CopyAssignable`; a default
  /// constructed object is that of a cluster without faces.
  typedef unspecified_type Cluster_data;

  /// returns what is to be kept of a face of density `density` and area `area`. It may be called several times for a face.
  Face_data face_data(double density, double area) const;

  /// brings `data` up to date after face `face` has joined the cluster.
  void add(Cluster_data& data, const Face_data& face) const;

  /// brings `data` up to date after face `face` has left the cluster.
  void remove(Cluster_data& data, const Face_data& face) const;

  /// returns the weight of the cluster of data `data`, whose mass, the sum of density times area over its faces, is `mass`,
  /// and which has `faces` faces, at least one.
  double weight(const Cluster_data& data, double mass, std::size_t faces) const;

  /// returns the weight that the cluster of data `data` would have with face `face`, which does not belong to it. `mass` and
  /// `faces` are its mass and the number of its faces afterwards.
  double weight_with(const Cluster_data& data, const Face_data& face, double mass, std::size_t faces) const;

  /// returns the weight that the cluster of data `data` would have without face `face`, which belongs to it. `mass` and
  /// `faces` are its mass and the number of its faces afterwards, of which there is at least one.
  double weight_without(const Cluster_data& data, const Face_data& face, double mass, std::size_t faces) const;
};
