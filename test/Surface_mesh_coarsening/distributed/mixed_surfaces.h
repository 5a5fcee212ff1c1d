// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_TEST_MIXED_SURFACES_H
#define CGAL_SURFACE_MESH_COARSENING_TEST_MIXED_SURFACES_H

#include "support/generate_meshes.h"

namespace generated {

// Handles, loops and several components, of triangles and quadrilaterals.
inline Soup mixed_surfaces()
{
  Soup soup = torus(40, 20);
  soup = joined(soup, translated(triangulated(tube(24, 30)), 4, 0, 0));
  soup = joined(soup, translated(with_holes(triangle_sphere(4), 3), 0, 4, 0));
  return joined(soup, translated(plate_with_windows(2, 4), 5, 5, 0));
}

} // namespace generated

#endif // CGAL_SURFACE_MESH_COARSENING_TEST_MIXED_SURFACES_H
