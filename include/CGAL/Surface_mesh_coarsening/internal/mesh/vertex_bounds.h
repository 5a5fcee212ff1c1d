// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_VERTEX_BOUNDS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_VERTEX_BOUNDS_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/boxes.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Returns the bounding box of the faces of a cluster, enlarged by half its diagonal.
template <class FaceRange>
Bbox_3 vertex_bounds(const Flat_mesh& mesh, const FaceRange& faces)
{
  Bbox_3 box;
  for (const Index f : faces)
    for (const Index c : mesh.corners(f))
      box += box_of_point(mesh.points[mesh.corner_vertex[c]]);
  // Computed positions may differ by their rounding.
  double largest = 0;
  for (int i = 0; i < 3; ++i)
    largest = (std::max)({largest, std::abs((box.min)(i)), std::abs((box.max)(i))});
  return grown(box, 0.5 * std::sqrt(squared_diagonal(box)) + 1e-12 * largest);
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_VERTEX_BOUNDS_H
