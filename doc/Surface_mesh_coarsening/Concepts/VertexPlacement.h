// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgSurfaceMeshCoarseningConcepts
/// \cgalConcept
///
/// The concept `VertexPlacement` describes where the vertex of a cluster is put in the output, one cluster at a time. See
/// `GlobalVertexPlacement` for all of them together.
///
/// It is asked for clusters that have no edge on the border of the mesh. Those that have one get their vertex on the border,
/// whatever the placement, see section \ref smc_borders of the manual.
///
/// An object that is not passed is default constructed; otherwise the default constructor is not needed.
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

  /// Optional: whether all positions are points of vertices of the input, to which the repair of the output has to keep then;
  /// `false` if it is missing.
  static constexpr bool is_at_input_vertices = unspecified_value;

  /// returns the position of the vertex of cluster `cluster`, in the coordinates of `surface`: those of its faces and
  /// vertices, which are relative to a local origin.
  ///
  /// The position lies in `surface.vertex_bounds(cluster)`, the bounding box of the cluster grown by half its diagonal, where
  /// `surface.within_bounds()` brings it: `CGAL::Surface_mesh_coarsening::Invalid_input` is thrown for one that lies outside,
  /// and the output is not touched. A position that is not finite stands for the centroid of the cluster.
  CGAL::Surface_mesh_coarsening::Clustered_surface::Point_3
  operator()(const CGAL::Surface_mesh_coarsening::Clustered_surface& surface, std::size_t cluster) const;
};
