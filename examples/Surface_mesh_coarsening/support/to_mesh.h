// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_TO_MESH_H
#define COARSENING_SUPPORT_TO_MESH_H

#include "Mesh.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

namespace coarsening_support {

// Makes a mesh of a soup without faults and without unused points; faces and vertices keep their numbers.
inline Mesh to_mesh(const Soup& soup)
{
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  return mesh;
}

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_TO_MESH_H
