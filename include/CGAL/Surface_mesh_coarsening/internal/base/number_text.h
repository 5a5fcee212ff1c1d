// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_NUMBER_TEXT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_NUMBER_TEXT_H

#include <cstdio>
#include <string>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Returns the number as text of any magnitude; `std::to_string()` prints only six digits after the point.
inline std::string number_text(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_NUMBER_TEXT_H
