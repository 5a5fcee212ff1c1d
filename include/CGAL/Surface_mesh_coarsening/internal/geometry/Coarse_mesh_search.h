// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_COARSE_MESH_SEARCH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_COARSE_MESH_SEARCH_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Nearest_point_search.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Finds nearest points on the triangles of a coarse mesh.
class Coarse_mesh_search
{
public:
  Coarse_mesh_search(const std::vector<Triangle>& triangles, const std::vector<Vector>& positions)
    : first_corners_(first_corners(triangles)),
      mesh_(mesh_of(triangles, positions)),
      search_(mesh_, first_corners_, positions.size())
  {}

  Coarse_mesh_search(const Coarse_mesh_search&) = delete;
  Coarse_mesh_search& operator=(const Coarse_mesh_search&) = delete;

  const Flat_mesh& mesh() const { return mesh_; }

  // The first corner of a triangle.
  Index first_corner(Index t) const { return first_corners_[t]; }

  // The search begins at the triangles whose first corner is `vertex`.
  Nearest_point operator()(const Vector& p, Index vertex) const { return search_(p, vertex); }

private:
  static std::vector<Index> first_corners(const std::vector<Triangle>& triangles)
  {
    std::vector<Index> corners;
    corners.reserve(triangles.size());
    for (const Triangle& t : triangles)
      corners.push_back(t[0]);
    return corners;
  }

  static Flat_mesh mesh_of(const std::vector<Triangle>& triangles, const std::vector<Vector>& positions)
  {
    Flat_mesh mesh;
    mesh.points = positions;
    mesh.first_corner.push_back(0);
    for (const Triangle& t : triangles) {
      mesh.corner_vertex.insert(mesh.corner_vertex.end(), t.begin(), t.end());
      mesh.first_corner.push_back(Index(mesh.corner_vertex.size()));
    }
    return mesh;
  }

  const std::vector<Index> first_corners_;
  const Flat_mesh mesh_;
  const Nearest_point_search search_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_GEOMETRY_COARSE_MESH_SEARCH_H
