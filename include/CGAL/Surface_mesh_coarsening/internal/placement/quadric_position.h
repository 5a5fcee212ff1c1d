// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_QUADRIC_POSITION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_QUADRIC_POSITION_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>

#include <cstddef>

namespace CGAL::Surface_mesh_coarsening::internal {

// The position that minimizes the quadric of a cluster: see `Quadric_placement`.
Vector quadric_position(const Clustered_faces& surface, std::size_t cluster, double pull);

} // namespace CGAL::Surface_mesh_coarsening::internal

#ifndef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#include <CGAL/Surface_mesh_coarsening/internal/placement/quadric_position_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_QUADRIC_POSITION_H
