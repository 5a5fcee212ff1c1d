// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_VERTEX_NUMBER_RANGE_H
#define CGAL_SURFACE_MESH_COARSENING_VERTEX_NUMBER_RANGE_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>

#include <CGAL/tags.h>

#include <cstddef>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// The range of the numbers of vertices to which a mesh can be coarsened.
struct Vertex_number_range
{
  /// the smallest number, which depends on the topology of the mesh
  std::size_t least = 0;
  /// the largest number: the number of vertices of the mesh or, if the mesh is subdivided, the maximum number of clusters
  std::size_t most = 0;
};

/// \ingroup PkgSurfaceMeshCoarseningRef
/// finds the range of the numbers of vertices that `coarsen_mesh()` accepts for a mesh: all numbers from `least` to `most`.
///
/// \tparam FaceGraph a model of `FaceListGraph`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
/// \param mesh a 2-manifold polygon mesh
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", the parameters of the planned coarsening. The
/// range depends on \smcParam{subdivide_input}, \smcParam{feature_angle},
/// \smcParam{edge_is_constrained_map}, \smcParam{vertex_is_constrained_map} and \smcParam{face_patch_map}
/// \throws Invalid_input as `coarsen_mesh()` does.
/// \throws Coarsening_cancelled if the visitor cancels.
///
/// The function takes as long as a coarsening to very few vertices without minimization.
template <class FaceGraph, class NamedParameters = parameters::Default_named_parameters>
Vertex_number_range vertex_number_range(const FaceGraph& mesh, const NamedParameters& np = parameters::default_values())
{
  internal::accept_parameters<NamedParameters, internal::Coarsening_parameters>();
  internal::Numbering<FaceGraph> numbering;
  internal::Clustering_state state;
  internal::prepare<Sequential_tag>(mesh, np, numbering, state);
  const auto range = internal::vertex_number_range(state);
  return {range.first, range.second};
}

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_VERTEX_NUMBER_RANGE_H
