// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_SEARCH_STARTS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_SEARCH_STARTS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// At most 32 points of the input with their faces. A search for a closest point begins at one of them. Refers to the points.
class Search_starts
{
public:
  void add(const Vector& p, Index face) { points_[number_++] = {&p, face}; }

  // Returns NONE if there are no points.
  Index face_of_nearest(const Vector& p) const
  {
    Index face = NONE;
    double nearest = 0;
    for (std::size_t i = 0; i < number_; ++i) {
      const Vector d = *points_[i].position - p;
      if (face == NONE || dot(d, d) < nearest) {
        nearest = dot(d, d);
        face = points_[i].face;
      }
    }
    return face;
  }

private:
  struct Start
  {
    const Vector* position;
    Index face;
  };

  std::array<Start, 32> points_;
  std::size_t number_ = 0;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_SEARCH_STARTS_H
