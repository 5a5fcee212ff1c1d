// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgSurfaceMeshCoarseningConcepts
/// \cgalConcept
///
/// The concept `GlobalVertexPlacement` describes where the vertices of all clusters are put in the output, with a view to the
/// triangles that they form. It can be passed wherever a `VertexPlacement` can; the two are told apart by their arguments.
///
/// An object that is not passed is default constructed; otherwise the default constructor is not needed.
///
/// \cgalRefines{`CopyConstructible`}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{`CGAL::Surface_mesh_coarsening::Fitted_placement`}
/// \cgalHasModelsEnd
class GlobalVertexPlacement
{
public:
  /// Optional: a default constructible model of `VertexPlacement` that takes less time and comes nearly as close to the surface.
  /// `CGAL::Surface_mesh_coarsening::coarsen_mesh_to_distance()` takes it to find out about how many vertices are needed.
  typedef unspecified_type Start;

  /// places all vertices.
  ///
  /// \param surface the faces, with their geometry, cluster by cluster
  /// \param border the parts of the border that belong to clusters; it can bring vertices back onto the border
  /// \param triangles the triangles of the output, as numbers of clusters, counterclockwise. Inner edges may be flipped as
  /// long as no edge comes to exist twice; the topology must not be changed otherwise.
  /// \param positions the position of the vertex of each cluster, in the coordinates of `surface`. On entry, those of the
  /// clusters on the border are on it, and the others are not set.
  /// On return, each lies in `surface.vertex_bounds()` of its cluster, where `surface.within_bounds()` brings it:
  /// `CGAL::Surface_mesh_coarsening::Invalid_input` is thrown for one that lies outside, and the output is not touched. A
  /// position that is not finite stands for the centroid of its cluster.
  void operator()(const CGAL::Surface_mesh_coarsening::Clustered_surface& surface,
                  const CGAL::Surface_mesh_coarsening::Border_arcs& border,
                  std::vector<std::array<std::uint32_t, 3> >& triangles,
                  std::vector<CGAL::Surface_mesh_coarsening::Clustered_surface::Point_3>& positions) const;
};
