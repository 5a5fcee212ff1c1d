// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Vertex_relocation.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Fits all vertices together, starting from quadrics: see `Fitted_placement`. `mean_angle` is in degrees. After the rounds, as
// many follow as `relocation` wants, which exchange vertices for as long as there are some to exchange, then two without. The
// plain fit is the result if none of the last meshes is nearer at angles as large. Returns the squared distance of the plain fit;
// 0 if that is the result.
double fit_vertices(const Clustered_faces& surface, const Border_arcs& border, std::size_t rounds, double mean_angle,
                    std::vector<Triangle>& triangles, std::vector<Vector>& positions,
                    const Vertex_relocation& relocation = Vertex_relocation());

// The mean squared distance of a surface from a coarse mesh, or the other way if that is larger, as `Sampled_distance` has it.
double squared_distance(const Clustered_faces& surface, const std::vector<Triangle>& triangles,
                        const std::vector<Vector>& positions);

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#ifndef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#include <CGAL/Surface_mesh_coarsening/internal/placement/fit_vertices_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_VERTICES_H
