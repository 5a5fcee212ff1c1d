// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_COMPUTE_FACE_DENSITIES_H
#define CGAL_SURFACE_MESH_COARSENING_COMPUTE_FACE_DENSITIES_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// computes the density of each face from the deviation of its normal from the normals around it (section 5.2 of the paper),
/// and from the curvature of borders.
///
/// The deviation of a face is the mean of \f$ \| n - n_k \| \f$ over all pairs of a vertex of the face and a face \f$ k \f$
/// around that vertex. It is mapped linearly from \f$ [0, m] \f$, with \f$ m \f$ the largest deviation, to \f$ [1, r] \f$,
/// with \f$ r \f$ the maximum density. If no face deviates by more than \f$ 10^{-6} \f$, all densities are 1. Faces without
/// area have no deviation. Around a vertex of more than 256 faces, each face is compared with 256 evenly spread faces.
///
/// Near a curved border, deviations are raised to at least \f$ 32 \sqrt{A} / (R + s) \f$, but not above \f$ 4 m \f$. Here
/// \f$ A \f$ is the area of the face, and \f$ R \f$ is the radius of curvature of the border, measured over three edges on either
/// side of a vertex. \f$ s \f$ is the distance from the border along edges, up to a tenth of the length of the border loop. Page
/// \ref smc_theory explains these constants.
///
/// \tparam FaceGraph a model of `FaceListGraph`
/// \tparam FaceDensityMap a model of `WritablePropertyMap` with the faces as keys and values that `double` converts to
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a 2-manifold polygon mesh
/// \param densities the map that receives the densities
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": \smcParam{maximum_density},
/// \smcParam{paper_rules}, with which densities are not raised near borders, \smcParam{vertex_point_map} and
/// \smcParam{geom_traits}, as in `coarsen_mesh()`
///
/// \throws Invalid_input if the mesh is not a 2-manifold, if a coordinate is not finite, or if the maximum density is out
/// of range.
///
/// The time is linear in the sum of the squared valences of the vertices, where valences above 256 count only once, plus
/// \f$ k \log k \f$, where \f$ k \f$ is the number of vertices near borders.
template <class FaceGraph, class FaceDensityMap, class NamedParameters = parameters::Default_named_parameters>
void compute_face_densities(const FaceGraph& mesh, FaceDensityMap densities,
                            const NamedParameters& np = parameters::default_values())
{
  internal::accept_parameters<NamedParameters, internal::Geometry_parameters, internal::Order_parameters,
                              internal::Density_parameters>();
  typedef typename boost::property_traits<FaceDensityMap>::value_type Value;
  const internal::Numbering<FaceGraph> n = internal::numbering(mesh, np);
  const internal::Density_choice choice = internal::density_choice(np);
  internal::Flat_mesh m = internal::flat_connectivity(mesh, n);
  internal::copy_points(mesh, np, n, m);
  const std::vector<double> values = internal::compute_densities(m, choice.maximum, choice.at_borders, internal::Run_context());
  for (std::size_t i = 0; i < values.size(); ++i)
    put(densities, n.faces[i], Value(values[i]));
}

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_COMPUTE_FACE_DENSITIES_H
