// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgSurfaceMeshCoarseningConcepts
/// \cgalConcept
///
/// The concept `VertexPlacement` describes functors that compute the position of the vertex of one cluster. A model of
/// `GlobalVertexPlacement` computes the positions of all vertices together.
///
/// The functor is called for clusters without an edge on the border of the mesh. The vertex of a cluster with a border edge lies
/// on the border, independently of the placement, see section \ref smc_borders of the manual.
///
/// An object that is not passed is default constructed. If an object is passed, the default constructor is not needed.
///
/// \cgalRefines{`CopyConstructible`}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{`CGAL::Surface_mesh_coarsening::Centroid_placement`}
/// \cgalHasModels{`CGAL::Surface_mesh_coarsening::Closest_vertex_placement`}
/// \cgalHasModels{`CGAL::Surface_mesh_coarsening::Quadric_placement`}
/// \cgalHasModelsEnd
class VertexPlacement
{
public:
  /// Optional: whether several threads may call the placement at a time, with `CGAL::Parallel_tag`; `false` if it is missing.
  static constexpr bool may_run_in_parallel = unspecified_value;

  /// Optional: whether all positions are points of vertices of the input, which the repair of the output then preserves; `false`
  /// if it is missing.
  static constexpr bool is_at_input_vertices = unspecified_value;

  /// returns the position of the vertex of cluster `cluster`, in the coordinates of `surface`, which are relative to a local
  /// origin.
  ///
  /// The position must lie in `surface.vertex_bounds(cluster)`, the bounding box of the cluster enlarged by half its diagonal;
  /// `surface.within_bounds()` moves a position into these bounds. If the position lies outside,
  /// `CGAL::Surface_mesh_coarsening::Invalid_input` is thrown and the output does not change. A position that is not finite is
  /// replaced by the centroid of the cluster.
  CGAL::Surface_mesh_coarsening::Clustered_surface::Point_3
  operator()(const CGAL::Surface_mesh_coarsening::Clustered_surface& surface, std::size_t cluster) const;
};
