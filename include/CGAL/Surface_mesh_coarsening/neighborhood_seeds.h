// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_NEIGHBORHOOD_SEEDS_H
#define CGAL_SURFACE_MESH_COARSENING_NEIGHBORHOOD_SEEDS_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>
#include <CGAL/Surface_mesh_coarsening/internal/seeding/Cluster_growth.h>

#include <vector>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// finds faces that are spread evenly over a mesh, by adjacency alone (section 6 of the paper).
///
/// The faces are traversed in order. A face becomes a seed if its neighborhood, the faces within `level` steps across
/// edges, is disjoint from the neighborhoods of earlier seeds. On a regular triangle mesh a neighborhood has
/// \f$ 1 + 3 k (k + 1) / 2 \f$ faces for level \f$ k \f$.
///
/// \tparam FaceGraph a model of `FaceListGraph`
/// \tparam OutputIterator a model of `OutputIterator` that accepts face descriptors
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a 2-manifold polygon mesh
/// \param level the number of steps; with 0, every face is a seed
/// \param seeds receives the seeds in the order of the traversal
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": \smcParam{face_index_map}, the order of
/// traversal, as in `coarsen_mesh()`
///
/// \return `seeds` past the last seed.
///
/// \throws Invalid_input if the mesh is not a 2-manifold or the face index map is not a bijection.
///
/// The time is linear in the number of faces for every level.
template <class FaceGraph, class OutputIterator, class NamedParameters = parameters::Default_named_parameters>
OutputIterator neighborhood_seeds(const FaceGraph& mesh, std::size_t level, OutputIterator seeds,
                                  const NamedParameters& np = parameters::default_values())
{
  using namespace internal;
  accept_parameters<NamedParameters, Order_parameters>();
  const Numbering<FaceGraph> n = numbering(mesh, np);
  const Flat_mesh m = flat_connectivity(mesh, n);
  std::vector<Index> found;
  Seed_walk(m).run(numbers_below(Index(m.number_of_faces())), Index((std::min)(level, std::size_t(NONE))), found);
  for (const Index f : found)
    *seeds++ = n.faces[f];
  return seeds;
}

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_NEIGHBORHOOD_SEEDS_H
