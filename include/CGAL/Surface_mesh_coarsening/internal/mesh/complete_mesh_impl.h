// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_COMPLETE_MESH_IMPL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_COMPLETE_MESH_IMPL_H

#include <CGAL/Surface_mesh_coarsening/internal/base/inline.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Border_deviations.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh_topology.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/complete_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/face_geometry.h>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

CGAL_SURFACE_MESH_COARSENING_INLINE void complete_topology(Flat_mesh& mesh, std::size_t number_of_vertices,
                                                           const Cancellation_point& cancellation, Execution execution)
{
  Flat_mesh_topology::complete(mesh, number_of_vertices, cancellation, execution);
}

CGAL_SURFACE_MESH_COARSENING_INLINE void complete_stars(Flat_mesh& mesh, std::size_t number_of_vertices,
                                                        const Cancellation_point& cancellation, Execution execution)
{
  Flat_mesh_topology::complete_stars(mesh, number_of_vertices, cancellation, execution);
}

CGAL_SURFACE_MESH_COARSENING_INLINE std::vector<double> compute_densities(const Flat_mesh& mesh, double maximum, bool at_borders,
                                                                          const Cancellation_point& cancellation,
                                                                          Execution execution)
{
  std::vector<double> densities = mean_normal_deviations(mesh, cancellation, execution);
  const double largest = largest_of(densities);
  if (at_borders)
    Border_deviations(mesh, cancellation).raise(densities);
  map_to_densities(densities, largest, maximum);
  return densities;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_COMPLETE_MESH_IMPL_H
