// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgSurfaceMeshCoarseningConcepts
/// \cgalConcept
///
/// The concept `ClusterEnergy` describes the energy of a cluster. The minimization lowers the sum of the energies of all
/// clusters.
///
/// An energy is a function of sums over the faces of a cluster. `Face_data` holds the terms of a face, `Cluster_data` the sums
/// of a cluster, which `add()` and `remove()` update when a face joins or leaves. `energy()` computes the energy from the sums.
///
/// The energy must depend only on the set of faces of a cluster, not on the order in which they joined, up to rounding errors:
/// the proof that the minimization terminates requires this. The energy must be finite and must not be negative. The validity of
/// the clusters and of the output, and the number of clusters, do not depend on the energy.
///
/// Several threads may call the functions of one object at the same time.
///
/// Sums about an origin far from the cluster lose digits. Coordinates are relative to a local origin near the center of the
/// mesh. If clusters are small, sums about a point of the cluster keep more digits, for example about the centroid of the first
/// face that joins.
///
/// A model may have the following optional members, which save work or provide information.
///
/// - `energy_with(data, face, faces)` and `energy_without(data, face, faces)`, both `const`, return the energy of a cluster
///   with data `data` after face `face` has joined or left; `faces` is the number of faces after the move. If they are missing,
///   a copy of the data is updated.
/// - `bool cannot_gain(const Cluster_data& source, const Cluster_data& target, const Face_data& face) const` returns `true`
///   only if a move of the face from cluster `source` to cluster `target` does not lower the energy. Most trial moves do not
///   lower it.
/// - `energy()`, `energy_with()` and `energy_without()` may return, instead of `double`, an object of a class that is a model of
///   `DefaultConstructible` and `CopyAssignable` and converts to `double`, for example `Outcome`.
///   `void keep(Cluster_data& data, const Outcome& outcome) const` receives the object when it becomes the energy of
///   the cluster, and may store values that are expensive to compute.
/// - `void add_to_center(Cluster_data&, const CGAL::Surface_mesh_coarsening::Clustered_face&) const`,
///   `void set_center(Cluster_data&) const` and `void add_about_center(Cluster_data&, const Face_data&) const` compute the sums
///   of all clusters from scratch in two passes over the faces: the first function is called for each face, then the second for
///   each cluster, and then the third for each face. If they are missing, `add()` is called for each face.
/// - `void set_mean_area(double area)` receives the area of the mesh divided by the number of clusters, before any other
///   function is called. In `coarsen_distributed_mesh()`, area and number are those of the current part of the mesh.
/// - `static constexpr bool depends_on_densities` is whether clusters become smaller where densities are raised; `true` if
///   it is missing. If it is `false`, the mesh is not reclustered with other densities where triangles of the output intersect.
///
/// An object that is not passed as named parameter `cluster_energy` is default constructed. If an object is passed, the
/// default constructor is not needed.
///
/// \cgalRefines{`CopyConstructible`}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{`CGAL::Surface_mesh_coarsening::Weighted_inertia_energy`}
/// \cgalHasModels{`CGAL::Surface_mesh_coarsening::Quadric_energy`}
/// \cgalHasModels{`CGAL::Surface_mesh_coarsening::Normal_deviation_energy`}
/// \cgalHasModelsEnd
class ClusterEnergy
{
public:
  /// The terms of a face, a model of `CopyConstructible`.
  typedef unspecified_type Face_data;

  /// The sums of a cluster: a class that can be a base class, and a model of `DefaultConstructible` and `CopyAssignable`. A
  /// default constructed object holds the sums of a cluster without faces.
  typedef unspecified_type Cluster_data;

  /// returns the terms of a face. The function may be called several times for a face.
  Face_data face_data(const CGAL::Surface_mesh_coarsening::Clustered_face& face) const;

  /// updates `data` after face `face` has joined the cluster.
  void add(Cluster_data& data, const Face_data& face) const;

  /// updates `data` after face `face` has left the cluster.
  void remove(Cluster_data& data, const Face_data& face) const;

  /// returns the energy of the cluster with data `data` and `faces` faces, at least one.
  double energy(const Cluster_data& data, std::size_t faces) const;
};
