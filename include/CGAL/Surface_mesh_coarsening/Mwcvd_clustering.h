// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_MWCVD_CLUSTERING_H
#define CGAL_SURFACE_MESH_COARSENING_MWCVD_CLUSTERING_H

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/defaults.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Typed_energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// clusters the faces of a polygon mesh by a multiplicatively weighted centroidal Voronoi diagram, step by step.
///
/// The steps follow the paper in this order: `seed()` or `seed_from_level()`, then `grow()`, then any number of rounds
/// of the minimization. After `grow()`, the clustering is valid after every step: each cluster is a closed disc, and
/// the dual is a triangulated 2-manifold with one vertex per cluster. Each component of the dual has the genus, the number
/// of border loops and the orientation of its component of the mesh.
///
/// Only the constructor, `set_clusters()` and the functions that write into property maps access the mesh. They do not modify
/// it.
///
/// \tparam FaceGraph a model of `FaceListGraph`
/// \tparam ClusterWeight a model of `ClusterWeight`, which is the factor of the inertia of a cluster, or a model of
/// `ClusterEnergy`, which replaces weight and inertia
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`; the clusters do
/// not depend on the tag
template <class FaceGraph, class ClusterWeight = Weighted_area_weight, class ConcurrencyTag = Sequential_tag>
class Mwcvd_clustering
{
  typedef internal::Index Index;

public:
  /// The face descriptor of the mesh.
  typedef typename boost::graph_traits<FaceGraph>::face_descriptor face_descriptor;
  /// The vertex descriptor of the mesh.
  typedef typename boost::graph_traits<FaceGraph>::vertex_descriptor vertex_descriptor;

  /// checks the mesh, and computes or reads the densities of its faces.
  ///
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  /// \param mesh a 2-manifold polygon mesh
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": \smcParam{face_density_map},
  /// \smcParam{maximum_density}, \smcParam{cluster_weight}, \smcParam{cluster_energy}, \smcParam{subdivide_input},
  /// \smcParam{paper_rules}, \smcParam{repair_output}, \smcParam{error_feedback}, \smcParam{feature_angle},
  /// \smcParam{edge_is_constrained_map}, \smcParam{vertex_is_constrained_map}, \smcParam{face_patch_map},
  /// \smcParam{vertex_point_map}, \smcParam{face_index_map}, \smcParam{geom_traits} and \smcParam{visitor}, as in
  /// `coarsen_mesh()`
  /// \throws Invalid_input if the mesh has no faces, is not a 2-manifold, has a coordinate that is not finite, or if a
  /// parameter is out of range.
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Mwcvd_clustering(const FaceGraph& mesh, const NamedParameters& np = parameters::default_values())
    : Mwcvd_clustering(Accepted(), mesh, np)
  {
    internal::accept_parameters<NamedParameters, internal::Clustering_parameters>();
  }

  /// \cond SKIP_IN_MANUAL
  struct Accepted
  {};

  // For functions that accept more parameters and read these parameters themselves.
  template <class NamedParameters>
  Mwcvd_clustering(Accepted, const FaceGraph& mesh, const NamedParameters& np)
  {
    internal::prepare<ConcurrencyTag>(mesh, np, numbering_, state_);
    state_.energy = internal::energy_model(internal::chosen_energy<ClusterWeight>(np));
    state_.may_use_quadrics = state_.energy->is_default() && !state_.follows_paper &&
                              !internal::has_parameter<internal_np::face_density_t, NamedParameters> &&
                              internal::density_choice(np).maximum == Coarsening_defaults::maximum_density;
  }

  Mwcvd_clustering(const Mwcvd_clustering&) = delete; // its members refer to each other
  Mwcvd_clustering& operator=(const Mwcvd_clustering&) = delete;
  /// \endcond

  /// \name Seeds and growth (sections 6 and 8.1)
  /// @{

  /// finds seeds from which `grow()` computes exactly `number_of_clusters` clusters. The number is apportioned among the
  /// components by mass, which is area times density. The level of the seeds of a component is the highest level with twice the
  /// number of seeds for the component or, if the mesh is too coarse for that, with at least the number itself.
  /// \return the number of seeds
  /// \throws Unreachable_number_of_vertices if the mesh has fewer vertices, or if its topology needs more clusters.
  std::size_t seed(std::size_t number_of_clusters) { return seed_as({internal::Seeding::FOR_NUMBER, number_of_clusters}); }

  /// lets later calls of `seed_faces_or_cells()`, `seed_from_ratio()` and `seed_from_number_of_faces()` choose the items and the
  /// method for a placement, and for the limits that are passed to `minimize()`. With other placements than `Fitted_placement`, or
  /// with other limits than the defaults, they do the same as `seed()`. `coarsen_mesh()` and `coarsen_mesh_to_distance()` call this
  /// function.
  /// \tparam Placement a model of `VertexPlacement` or `GlobalVertexPlacement`
  template <class Placement>
  void choose_items_for(const Placement& placement, std::size_t max_rounds = Coarsening_defaults::number_of_iterations,
                        double tolerance = Coarsening_defaults::convergence_tolerance)
  {
    internal::choose_items_for(placement, {max_rounds, tolerance}, state_);
  }

  /// finds seeds from which `grow()` merges clusters by the residuals of their quadrics (see `Quadric_energy`), as suits
  /// `Fitted_placement` with error feedback; `minimize()` then changes nothing. `coarsen_mesh()` calls this function.
  ///
  /// The level of the seeds is the highest level with five times the number of seeds. If `number_of_clusters` exceeds 0.09 times
  /// the number of vertices of the mesh, the items of the clustering are the dual cells of vertices instead of faces, and every cell
  /// is a seed. The cell of a vertex is the part of the faces around the vertex that is bounded by the centers of faces and edges.
  /// If the number of clusters equals the number of vertices, each cell is a cluster, and `Fitted_placement` returns the vertices of
  /// the mesh. `cluster()` returns the cluster with the largest part of a face.
  ///
  /// The function does the same as `seed()` if the energy, its weight or the maximum density is not the default, if densities are
  /// given, with \smcParam{subdivide_input} or \smcParam{paper_rules}, if `choose_items_for()` requests it, and where merging by
  /// quadrics does not reach the number. With \smcParam{error_feedback} 0, it does the same for clusters of faces.
  /// \return the number of seeds
  /// \throws Unreachable_number_of_vertices as `seed()` does.
  std::size_t seed_faces_or_cells(std::size_t number_of_clusters)
  {
    return seed_as({internal::Seeding::FOR_NUMBER, number_of_clusters, true});
  }

  /// finds seeds for a number of clusters that is `vertex_ratio` times the number of vertices of the mesh, rounded, and at least
  /// 1, as `seed_faces_or_cells()` does.
  ///
  /// If `keeps_small_components` is `true`, components whose topology needs more vertices than their part stay as they are, as
  /// features: their vertices are corners and their edges are lines. The ratio then applies to the other components.
  /// \return the number of seeds
  /// \throws Invalid_input if the ratio is not positive and finite.
  /// \throws Unreachable_number_of_vertices as `seed()` does.
  std::size_t seed_from_ratio(double vertex_ratio, bool keeps_small_components = false)
  {
    return seed_faces_or_cells(keeps_small_components ? internal::keep_small_components(state_, vertex_ratio)
                                                      : internal::number_of_vertices(state_, vertex_ratio));
  }

  /// finds seeds for a number of clusters whose dual has `number_of_faces` triangles, or nearly as many, as
  /// `seed_faces_or_cells()` does. The number follows from Euler's formula. A closed mesh gets an even number of triangles. With
  /// borders, the function clusters the mesh for up to 8 numbers of vertices, and selects the number that comes nearest.
  /// \param number_of_faces the number of triangles
  /// \param number_of_iterations, convergence_tolerance the later arguments of `minimize()`
  /// \return the number of seeds
  /// \throws Unreachable_number_of_vertices as `seed()` does.
  /// \throws Invalid_input if the tolerance is negative or not a number.
  std::size_t seed_from_number_of_faces(std::size_t number_of_faces,
                                        std::size_t number_of_iterations = Coarsening_defaults::number_of_iterations,
                                        double convergence_tolerance = Coarsening_defaults::convergence_tolerance)
  {
    const internal::Minimization_end end = internal::minimization_end(number_of_iterations, convergence_tolerance);
    return seed_faces_or_cells(internal::vertices_for_faces(state_, number_of_faces, end));
  }

  /// The number of faces per cluster that the subdivision with parameter `subdivide_input` provides. A cluster of this many
  /// faces can be round.
  static constexpr std::size_t faces_per_cluster = internal::faces_per_cluster;

  /// selects seeds whose neighborhoods of `level` steps are disjoint, as many as a traversal of the faces finds.
  /// \return the number of seeds, which is the number of clusters after `grow()` unless the topology of the mesh needs
  /// more
  std::size_t seed_from_level(std::size_t level) { return seed_as({internal::Seeding::AT_LEVEL, level}); }

  /// selects the seeds of a level, from which `grow()` merges exactly `number_of_clusters` clusters, as in section 6 of the paper.
  /// A component whose topology does not permit this from the seeds of the level begins from other levels, as after `seed()`.
  /// \return the number of seeds
  /// \throws Unreachable_number_of_vertices if the level gives fewer seeds, or if the topology of the mesh needs more clusters.
  /// \throws Invalid_input if the number is 0.
  std::size_t seed_from_level(std::size_t level, std::size_t number_of_clusters)
  {
    if (number_of_clusters == 0)
      throw Invalid_input("0 clusters were asked for");
    return seed_as({internal::Seeding::AT_LEVEL, level, false, number_of_clusters});
  }

  /// grows the clusters from the seeds, one layer per round, until they cover the mesh.
  /// \pre `seed()` or `seed_from_level()` was called.
  /// \throws std::logic_error if neither was called.
  void grow() { internal::grow(state_); }

  /// reads the clusters from a property map instead of growing them.
  ///
  /// \tparam FaceClusterMap a model of `ReadablePropertyMap` with the faces as keys and an integral value type
  /// \param clusters the clusters, numbered from 0 without gaps
  /// \throws Invalid_input if a label is missing or out of range, if the clustering is not valid in the sense of
  /// `is_valid_clustering()`, or if features are kept.
  template <class FaceClusterMap>
  void set_clusters(const FaceClusterMap& clusters)
  {
    internal::cluster_faces(state_);
    const internal::Clustering_input& input = state_.input.items;
    if (state_.input.cells)
      throw Invalid_input("clusters cannot be taken over where features are kept");
    std::size_t number = 0;
    auto labels = std::make_unique<internal::Cluster_labels>(input.mesh);
    for (std::size_t i = 0; i < input.mesh.number_of_faces(); ++i) {
      const std::size_t label = std::size_t(get(clusters, numbering_.faces[i]));
      if (label >= numbering_.faces.size())
        throw Invalid_input("the cluster of face " + std::to_string(i) + " is " + std::to_string(label) +
                            " in a mesh of " + std::to_string(numbering_.faces.size()) + " faces");
      number = (std::max)(number, label + 1);
      labels->set(Index(i), Index(label));
    }
    internal::set_clusters(state_, std::move(labels), number);
  }
  /// @}

  /// \name Minimization (sections 5.1 and 8.2)
  /// \pre `grow()` or `set_clusters()` was called; `std::logic_error` is thrown otherwise.
  /// @{

  /// runs one round. For each edge between two clusters, the round compares the current energy with the energies after the face
  /// on either side has joined the cluster on the other side. If there are many clusters, `minimize()` runs several rounds in one
  /// block of clusters after another, so its result can differ from the result of single rounds.
  /// \return whether a face has changed cluster
  bool minimize_round() { return internal::minimize_round(state_); }

  /// runs rounds until a round lowers the energy by at most the relative amount `convergence_tolerance` or changes nothing, or
  /// until `number_of_iterations` rounds have been run. If there are many clusters, several rounds are run together in blocks of
  /// clusters, unless \smcParam{paper_rules} is set. Then the energies are compared, and the visitor is notified, after these rounds only.
  /// \throws Invalid_input if the tolerance is negative or not a number.
  void minimize(std::size_t number_of_iterations = Coarsening_defaults::number_of_iterations,
                double convergence_tolerance = Coarsening_defaults::convergence_tolerance)
  {
    internal::minimize(state_, internal::minimization_end(number_of_iterations, convergence_tolerance));
  }

  /// returns the energy of the clustering: the value of formula (8), in the sixth (weighted area) or fourth power of the unit of
  /// length, or the sum of the energies of a `ClusterEnergy`.
  double energy() const { return internal::energy(state_); }
  /// @}

  /// \name Results
  /// @{

  /// returns the number of clusters.
  std::size_t number_of_clusters() const { return state_.number_of_clusters(); }

  /// returns the current statistics.
  const Coarsening_report& report() const { return state_.report; }

  /// returns the faces, centroid, weight and energy of each cluster, in time linear in the number of faces.
  std::vector<Cluster_report> cluster_reports() const { return internal::cluster_reports(state_, numbering_.faces.size()); }

  /// writes the seeds; after `grow()`, one face of each cluster.
  template <class OutputIterator>
  OutputIterator seeds(OutputIterator out) const
  {
    for (const Index f : internal::seeds(state_))
      *out++ = numbering_.faces[f];
    return out;
  }

  /// returns the cluster of a face. If the faces of a component are subdivided internally, the function returns the cluster of
  /// the largest part of the face.
  std::size_t cluster(face_descriptor f) const { return internal::cluster_of_face(state_, numbering_.number_of(f)); }

  /// writes the cluster of each face, see `cluster()`.
  /// \tparam FaceClusterMap a model of `WritablePropertyMap` with the faces as keys and an integral value type
  template <class FaceClusterMap>
  void write_clusters(FaceClusterMap clusters) const
  {
    typedef typename boost::property_traits<FaceClusterMap>::value_type Value;
    for (std::size_t i = 0; i < numbering_.faces.size(); ++i)
      put(clusters, numbering_.faces[i], Value(internal::cluster_of_face(state_, Index(i))));
  }

  /// writes the boundary-edge count (section 7) of each vertex: the number of incident edges that lie between two clusters or
  /// on the border.
  /// \tparam VertexBoundaryCountMap a model of `WritablePropertyMap` with the vertices as keys and an integral value type
  template <class VertexBoundaryCountMap>
  void write_boundary_counts(VertexBoundaryCountMap counts) const
  {
    typedef typename boost::property_traits<VertexBoundaryCountMap>::value_type Value;
    for (std::size_t i = 0; i < numbering_.vertices.size(); ++i)
      put(counts, numbering_.vertices[i], Value(internal::labels(state_).boundary_count(Index(i))));
  }

  /// returns whether the minimization may move a face to another cluster: whether both clusters remain closed discs and the dual
  /// a triangulated 2-manifold, and, if \smcParam{paper_rules} is set, `boundary_counts_allow()` agrees.
  /// \throws Invalid_input if there is no such cluster, or if features are kept or faces subdivided.
  bool may_move(face_descriptor f, std::size_t cluster)
  {
    return (!state_.follows_paper || boundary_counts_allow(f, cluster)) &&
           internal::guarantee_allows_move(state_, numbering_.number_of(f), cluster);
  }

  /// returns whether the paper's check of boundary-edge counts (section 7), as printed, allows this move of a triangle. It allows
  /// all moves of other polygons. Throws as `may_move()` does.
  bool boundary_counts_allow(face_descriptor f, std::size_t cluster) const
  {
    return internal::boundary_counts_allow_move(state_, numbering_.number_of(f), cluster);
  }
  /// @}

  /// \name Output (section 8.3)
  /// @{

  /// replaces `output` by the dual triangulation. Its `i`-th vertex is the vertex of cluster `i`.
  ///
  /// \tparam Output a model of `MutableFaceGraph`
  /// \tparam VertexPlacement a model of `VertexPlacement` or `GlobalVertexPlacement`
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  /// \param output is cleared and filled
  /// \param placement computes the position of the vertex of each cluster in the interior; vertices of clusters on the border or
  /// on features lie on the border or on the features
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": \smcParam{vertex_point_map},
  /// \smcParam{geom_traits}, \smcParam{edge_is_constrained_map}, \smcParam{vertex_is_constrained_map} and
  /// \smcParam{face_patch_map} of `output`
  /// \pre `grow()` or `set_clusters()` was called; `std::logic_error` is thrown otherwise.
  template <class Output, class VertexPlacement = Fitted_placement,
            class NamedParameters = parameters::Default_named_parameters>
  void extract_dual_mesh(Output& output, const VertexPlacement& placement = VertexPlacement(),
                         const NamedParameters& np = parameters::default_values())
  {
    internal::accept_parameters<NamedParameters, internal::Geometry_parameters, internal::Feature_map_parameters>();
    internal::emit(state_, internal::place(state_, internal::placement_model(placement), coordinates<Output, NamedParameters>()),
                   output, np, [](const auto&) {});
  }

  /// replaces `output` by the dual triangulation, as `extract_dual_mesh()` does. If more than one pair of triangles for 100
  /// vertices still intersects after the repair, the function raises the densities in the clusters of these triangles by a factor
  /// of four and reclusters the mesh, which gives more clusters there and fewer elsewhere. It selects the result with the fewest
  /// intersections, or the first if no other has fewer, or no other has half as few after clusters were merged by quadrics.
  ///
  /// Seeding, growth and minimization are repeated at most twice, and once more to restore the selected result. They are
  /// not repeated if the weight is `Uniform_weight`, which does not depend on densities, if parameter `repair_output` is
  /// `false`, if clusters were given, edited or frozen, or if the number of intersecting pairs of triangles exceeds half the
  /// number of clusters. The parameters are the parameters of `extract_dual_mesh()`. `Coarsening_report::clusterings` is the
  /// number of clusterings. The densities of the selected result remain.
  template <class Output, class VertexPlacement = Fitted_placement,
            class NamedParameters = parameters::Default_named_parameters>
  void extract_embedded_dual_mesh(Output& output, const VertexPlacement& placement = VertexPlacement(),
                                  const NamedParameters& np = parameters::default_values())
  {
    internal::accept_parameters<NamedParameters, internal::Geometry_parameters, internal::Feature_map_parameters>();
    internal::emit(state_,
                   internal::place_embedded(state_, internal::placement_model(placement), coordinates<Output, NamedParameters>()),
                   output, np, [](const auto&) {});
  }
  /// @}

  /// \name Steering
  /// These functions let an application edit the clusters between rounds of the minimization. The clustering remains valid.
  /// All functions throw `std::logic_error` if there are no clusters yet, and `Invalid_input` if the given cluster does not
  /// exist.
  /// @{

  /// freezes a cluster: no face joins or leaves the cluster until it is thawed or the mesh is reclustered.
  void freeze_cluster(std::size_t cluster, bool is_frozen = true) { internal::freeze_cluster(state_, cluster, is_frozen); }

  /// thaws a cluster.
  void thaw_cluster(std::size_t cluster) { freeze_cluster(cluster, false); }

  /// returns whether a cluster is frozen.
  bool is_frozen(std::size_t cluster) const { return internal::is_frozen(state_, cluster); }

  /// splits a cluster into two clusters of similar extent. The new cluster gets the next number.
  /// \throws Invalid_input if features are kept.
  /// \return the number of the new cluster; empty if the cluster is frozen, or if no valid split was found, for example for a
  /// cluster of a single face
  std::optional<std::size_t> split_cluster(std::size_t cluster)
  {
    return internal::split_cluster(state_, cluster) ? std::make_optional(number_of_clusters() - 1) : std::nullopt;
  }

  /// removes a cluster: its faces join a neighbor that is not frozen and can receive them. Among these neighbors, the function
  /// selects the neighbor for which the sum of the inertias increases least. The last cluster gets the number of the removed one.
  /// \throws Invalid_input if features are kept.
  /// \return whether the cluster was removed. It remains if it is frozen, or if the topology of the mesh needs it.
  bool remove_cluster(std::size_t cluster) { return internal::remove_cluster(state_, cluster); }
  /// @}

  /// \cond SKIP_IN_MANUAL
  const internal::Clustering_state& state() const { return state_; }
  internal::Clustering_state& state() { return state_; }
  const internal::Numbering<FaceGraph>& numbering() const { return numbering_; }
  /// \endcond

private:
  std::size_t seed_as(const internal::Seeding& seeding)
  {
    internal::seed(state_, seeding);
    return state_.report.seeds;
  }

  template <class Output, class NamedParameters>
  internal::Output_coordinates coordinates() const
  {
    return internal::output_coordinates<typename GetGeomTraits<Output, NamedParameters>::type>(state_.frame);
  }

  internal::Numbering<FaceGraph> numbering_;
  internal::Clustering_state state_;
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_MWCVD_CLUSTERING_H
