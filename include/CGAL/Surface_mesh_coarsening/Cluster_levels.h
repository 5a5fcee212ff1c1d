// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTER_LEVELS_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTER_LEVELS_H

#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/Level_hierarchy.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <string>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// Levels of detail of one clustering: a sequence of clusterings, each with one cluster less than the previous one.
///
/// Level `n` has `n` clusters, numbered from 0. Each cluster of a level is a union of clusters of any finer level, and each
/// level is valid in the sense of `is_valid_clustering()`. Each level results from the next finer level by the merge of two
/// clusters that increases the energy least, with the weights of formula (9). The cluster with the largest number is merged
/// into its `parent()`.
///
/// The finest level is the given clustering. The memory is linear in its number of clusters. The triangles of a level are
/// computed in time linear in their number.
///
/// \tparam Clustering an instance of `Mwcvd_clustering`
template <class Clustering>
class Cluster_levels
{
public:
  /// merges clusters as long as the topology allows it.
  ///
  /// \param clustering a clustering with clusters; it must not change while the levels are in use
  /// \throws std::logic_error if the clustering has no clusters.
  /// \throws Invalid_input if the clustering keeps features.
  /// \throws Coarsening_cancelled if the visitor of the clustering cancels.
  explicit Cluster_levels(const Clustering& clustering)
    : clustering_(clustering), levels_(clustering.state())
  {}

  /// returns the number of clusters of the finest level.
  std::size_t finest() const { return levels_.history().finest(); }
  /// returns the number of clusters of the coarsest level.
  std::size_t coarsest() const { return levels_.history().coarsest(); }

  /// returns the cluster into which `cluster` is merged between level `cluster + 1` and level `cluster`. Its number is smaller
  /// than `cluster`.
  /// \pre `coarsest() <= cluster < finest()`; `Invalid_input` is thrown otherwise.
  std::size_t parent(std::size_t cluster) const
  {
    if (cluster < coarsest() || cluster >= finest())
      throw Invalid_input("cluster " + std::to_string(cluster) + " has no parent");
    return levels_.history().parent(internal::Index(cluster));
  }

  /// writes, for each cluster of level `fine`, the cluster of level `coarse` that contains it. The time is linear in `fine`.
  /// \pre `coarsest() <= coarse <= fine <= finest()`; `Unreachable_number_of_vertices` or `Invalid_input` is thrown otherwise.
  template <class OutputIterator>
  OutputIterator parents(std::size_t fine, std::size_t coarse, OutputIterator out) const
  {
    check(fine);
    check(coarse);
    if (coarse > fine)
      throw Invalid_input("level " + std::to_string(coarse) + " is not coarser than level " + std::to_string(fine));
    for (const internal::Index x : levels_.history().ancestors(fine, coarse))
      *out++ = std::size_t(x);
    return out;
  }

  /// writes the triangles of the dual of a level, each as an `std::array<std::size_t, 3>` of clusters. The time is linear in the
  /// number of triangles.
  /// \throws Unreachable_number_of_vertices if the level does not exist.
  template <class OutputIterator>
  OutputIterator triangles(std::size_t level, OutputIterator out) const
  {
    check(level);
    for (const internal::Triangle& t : levels_.history().triangles(level))
      *out++ = std::array<std::size_t, 3>{{t[0], t[1], t[2]}};
    return out;
  }

  /// writes the cluster of each face on a level.
  /// \tparam FaceClusterMap a model of `WritablePropertyMap` with the faces as keys and an integral value type
  /// \throws Unreachable_number_of_vertices if the level does not exist.
  template <class FaceClusterMap>
  void write_clusters(std::size_t level, FaceClusterMap clusters) const
  {
    typedef typename boost::property_traits<FaceClusterMap>::value_type Value;
    check(level);
    const auto& faces = clustering_.numbering().faces;
    const std::vector<internal::Index> of_face = levels_.clusters_of_faces(level, faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f)
      put(clusters, faces[f], Value(of_face[f]));
  }

  /// replaces `output` by the dual triangulation of a level, with `level` vertices.
  ///
  /// \tparam Output a model of `MutableFaceGraph`
  /// \tparam VertexPlacement a model of `VertexPlacement` or `GlobalVertexPlacement`
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  /// \param level the number of clusters
  /// \param output is cleared and filled; its `i`-th vertex is the vertex of cluster `i`
  /// \param placement computes the position of the vertex of each cluster in the interior
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": \smcParam{vertex_point_map} and
  /// \smcParam{geom_traits} of `output`
  /// \throws Unreachable_number_of_vertices if the level does not exist.
  /// \throws Coarsening_cancelled if the visitor of the clustering cancels.
  ///
  /// The placement takes time linear in the number of faces.
  template <class Output, class VertexPlacement = Fitted_placement,
            class NamedParameters = parameters::Default_named_parameters>
  void extract_dual_mesh(std::size_t level, Output& output, const VertexPlacement& placement = VertexPlacement(),
                         const NamedParameters& np = parameters::default_values()) const
  {
    using namespace internal;
    typedef typename GetGeomTraits<Output, NamedParameters>::type Traits;
    accept_parameters<NamedParameters, Geometry_parameters>();
    check(level);
    const Clustering_state& state = clustering_.state();
    const Placed_level placed = levels_.place(level, placement_model(placement), output_coordinates<Traits>(state.frame));
    Face_graph_filler<Output, NamedParameters> filler(output_points<Output>(placed.positions, state.frame, np), placed.triangles,
                                                      output, np, state.context);
    state.context.throw_if_cancelled();
    filler.commit();
  }

  /// estimates the distance between a level and the mesh: the largest distance in both directions, at vertices of the mesh and at
  /// points of the triangles of the level. The result approximates the Hausdorff distance, but is no bound of it.
  /// `measure_coarsening()` computes more measures.
  ///
  /// \tparam VertexPlacement a model of `VertexPlacement` or `GlobalVertexPlacement`
  /// \param level the number of clusters
  /// \param placement computes the position of the vertex of each cluster, as in `extract_dual_mesh()`
  /// \throws Unreachable_number_of_vertices if the level does not exist.
  /// \throws Coarsening_cancelled if the visitor of the clustering cancels.
  ///
  /// In addition to the placement, the function takes time about linear in the number of faces.
  template <class VertexPlacement = Fitted_placement>
  double approximate_distance(std::size_t level, const VertexPlacement& placement = VertexPlacement()) const
  {
    using namespace internal;
    check(level);
    const Clustering_state& state = clustering_.state();
    const Placed_level placed =
      levels_.place(level, placement_model(placement), output_coordinates<Simple_cartesian<double> >(state.frame));
    const double distance = levels_.estimate(placed);
    state.context.throw_if_cancelled();
    return state.frame.length_to_mesh(distance);
  }

private:
  void check(std::size_t level) const
  {
    if (level < coarsest() || level > finest())
      throw Unreachable_number_of_vertices("there is no level of " + std::to_string(level) + " vertices, but of " +
                                             std::to_string(coarsest()) + " to " + std::to_string(finest()),
                                           level < coarsest() ? coarsest() : finest());
  }

  const Clustering& clustering_;
  internal::Level_hierarchy levels_;
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTER_LEVELS_H
