// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Vertex_relocation.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Fits all vertices together, starting from quadrics: see `Fitted_placement`. `mean_angle` is in degrees. After two thirds of
// the rounds, up to the number of rounds in `relocation` exchange vertices, until none is profitable, and then one or more
// rounds without exchange follow; if all these do not lower the distance, they are undone.
void fit_vertices(const Clustered_surface& surface, const Border_arcs& border, std::size_t rounds, double mean_angle,
                  std::vector<Triangle>& triangles, std::vector<Vector>& positions,
                  const Vertex_relocation& relocation = Vertex_relocation());

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#ifndef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#include <CGAL/Surface_mesh_coarsening/internal/placement/fit_vertices_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_H
