// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_STAR_SUBDIVISION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_STAR_SUBDIVISION_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh_builder.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/face_geometry.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Subdivides chosen faces into the triangles between their edges and their center. The surface does not change. The
// triangles of a face are consecutive, in the order of its corners; vertices keep their numbers, and the centers
// follow. `old_face` receives the original face of each new face.
inline Flat_mesh star_subdivision(const Flat_mesh& m, const std::vector<char>& is_cut, std::vector<Index>& old_face,
                               const Cancellation_point& cancellation)
{
  std::vector<Index> first_piece;
  old_face.clear();
  for (Index f = 0; f < m.number_of_faces(); ++f) {
    first_piece.push_back(Index(old_face.size()));
    old_face.insert(old_face.end(), is_cut[f] ? m.degree(f) : 1, f);
  }
  Flat_mesh_builder builder(m.points);
  // Returns the new face on the other side of the edge after corner `c` of face `f`.
  const auto across = [&](Index f, Index c) {
    const Index g = m.face_across[c];
    if (g == NONE)
      return NONE;
    return first_piece[g] +
           (is_cut[g] ? m.corner_of(g, m.corner_vertex[m.next_corner(f, c)]) - m.first_corner[g] : 0);
  };
  for (Index f = 0; f < m.number_of_faces(); ++f) {
    cancellation.poll();
    const Index middle = is_cut[f] ? builder.add_point(mean_of_corners(m, f)) : NONE;
    for (const Index c : m.corners(f)) {
      builder.add_corner(m.corner_vertex[c], across(f, c));
      if (!is_cut[f])
        continue;
      builder.add_corner(m.corner_vertex[m.next_corner(f, c)], first_piece[f] + m.next_corner(f, c) - m.first_corner[f]);
      builder.add_corner(middle, first_piece[f] + m.previous_corner(f, c) - m.first_corner[f]);
      builder.end_face();
    }
    if (!is_cut[f])
      builder.end_face();
  }
  return builder.finish(cancellation);
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_STAR_SUBDIVISION_H
