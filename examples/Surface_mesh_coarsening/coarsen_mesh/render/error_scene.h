// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_ERROR_SCENE_H
#define COARSENING_SUPPORT_ERROR_SCENE_H

#include "render/Scene.h"
#include "render/scale_color.h"

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace coarsening_support {

// The surface of a mesh with each face in the color of its distance, from 0 to the largest.
inline Scene error_scene(const Mesh& polygon_mesh, const std::vector<double>& distances)
{
  std::vector<std::size_t> face_of_triangle(polygon_mesh.number_of_faces()); // faces of more sides are cut for the picture
  std::iota(face_of_triangle.begin(), face_of_triangle.end(), std::size_t(0));
  const Mesh mesh = CGAL::is_triangle_mesh(polygon_mesh) ? polygon_mesh : triangulated(polygon_mesh, face_of_triangle);
  const double largest = distances.empty() ? 0 : *std::max_element(distances.begin(), distances.end());
  const auto color = [&](Face f) { return scale_color(largest > 0 ? distances[face_of_triangle[f]] / largest : 0); };
  return make_scene(
    mesh, true, color, [](Edge) { return false; }, 1, 0);
}

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_ERROR_SCENE_H
