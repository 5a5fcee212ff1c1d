// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_HAUSDORFF_BOUND_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_HAUSDORFF_BOUND_H

#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/kernel_point.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The triangles of a mesh for the bound of a distance, without degenerate triangles.
class Distance_mesh
{
  typedef CGAL::Simple_cartesian<double>::Point_3 Point;

public:
  typedef CGAL::Surface_mesh<Point> Mesh;

  explicit Distance_mesh(const std::vector<Vector>& points)
  {
    for (const Vector& p : points)
      mesh_.add_vertex(to_point(p));
    points_ = &points;
  }

  void add(Index a, Index b, Index c)
  {
    const std::vector<Vector>& p = *points_;
    const Vector n = cross(p[b] - p[a], p[c] - p[a]);
    if (!(dot(n, n) > 0))
      return;
    typedef Mesh::Vertex_index Vertex;
    // Triangles that do not fit into the manifold, for example where fans of polygons share a diagonal, become separate
    // components.
    if (mesh_.add_face(Vertex(a), Vertex(b), Vertex(c)) == Mesh::null_face()) {
      const Vertex x = mesh_.add_vertex(to_point(p[a])), y = mesh_.add_vertex(to_point(p[b])),
                   z = mesh_.add_vertex(to_point(p[c]));
      mesh_.add_face(x, y, z);
    }
  }

  const Mesh& mesh() const
  {
    if (mesh_.number_of_faces() == 0)
      throw Invalid_input("the distance of a surface without area cannot be bounded");
    return mesh_;
  }

private:
  Mesh mesh_;
  const std::vector<Vector>* points_;
};

inline Distance_mesh triangles_of(const Flat_mesh& m)
{
  Distance_mesh mesh(m.points);
  for (std::size_t f = 0; f < m.number_of_faces(); ++f)
    for (Index c = m.first_corner[f] + 2; c != m.first_corner[f + 1]; ++c)
      mesh.add(m.corner_vertex[m.first_corner[f]], m.corner_vertex[c - 1], m.corner_vertex[c]);
  return mesh;
}

// Returns an upper bound of the Hausdorff distance that exceeds it by at most `error`.
inline double hausdorff_bound(const Distance_mesh& a, const std::vector<Vector>& positions,
                              const std::vector<Triangle>& triangles, double error)
{
  Distance_mesh b(positions);
  for (const Triangle& t : triangles)
    b.add(t[0], t[1], t[2]);
  const auto np = CGAL::parameters::match_faces(false);
  // The result deviates from the distance by at most half the error, in either direction.
  return Polygon_mesh_processing::bounded_error_symmetric_Hausdorff_distance<CGAL::Sequential_tag>(
           a.mesh(), b.mesh(), error / 2, np, np) +
         error / 2;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_HAUSDORFF_BOUND_H
