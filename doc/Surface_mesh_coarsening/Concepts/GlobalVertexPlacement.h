// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgSurfaceMeshCoarseningConcepts
/// \cgalConcept
///
/// The concept `GlobalVertexPlacement` describes functors that compute the positions of all vertices of the output together,
/// given the triangles of the output. A model can be passed wherever a `VertexPlacement` can. The parameters of the call operator
/// distinguish the two concepts.
///
/// An object that is not passed is default constructed. If an object is passed, the default constructor is not needed.
///
/// \cgalRefines{`CopyConstructible`}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{`CGAL::Surface_mesh_coarsening::Fitted_placement`}
/// \cgalHasModelsEnd
class GlobalVertexPlacement
{
public:
  /// Optional: a default constructible model of `VertexPlacement` that takes less time, with vertices nearly as close to the
  /// surface. `CGAL::Surface_mesh_coarsening::coarsen_distributed_mesh()` starts from it.
  typedef unspecified_type Start;

  /// places all vertices.
  ///
  /// \param surface the faces, with their geometry, cluster by cluster
  /// \param border the border arcs of the clusters; it can move vertices back onto the border
  /// \param triangles the triangles of the output, as numbers of clusters, counterclockwise. Inner edges may be flipped, unless
  /// the flip creates an edge that already exists. The topology must not change otherwise.
  /// \param positions the position of the vertex of each cluster, in the coordinates of `surface`. On entry, the positions of the
  /// clusters on the border are on the border, and the other positions are not set. On return, each position must lie in
  /// `surface.vertex_bounds()` of its cluster; `surface.within_bounds()` moves a position into these bounds. If a position lies
  /// outside, `CGAL::Surface_mesh_coarsening::Invalid_input` is thrown and the output does not change. A position that is not
  /// finite is replaced by the centroid of its cluster.
  void operator()(const CGAL::Surface_mesh_coarsening::Clustered_surface& surface,
                  const CGAL::Surface_mesh_coarsening::Border_arcs& border,
                  std::vector<std::array<std::uint32_t, 3> >& triangles,
                  std::vector<CGAL::Surface_mesh_coarsening::Clustered_surface::Point_3>& positions) const;
};
