// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_STAR_SUBDIVISION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_STAR_SUBDIVISION_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/build_flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/face_geometry.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Cuts chosen faces into the triangles between their edges and their middle; the surface does not change. The triangles of a face
// follow each other in the order of its corners; vertices keep their numbers, and the middles follow. `old_face` receives the
// face that each new one is a piece of.
inline Flat_mesh star_subdivision(const Flat_mesh& m, const std::vector<char>& is_cut, std::vector<Index>& old_face,
                               const Cancellation_point& cancellation)
{
  std::vector<Index> first_piece;
  old_face.clear();
  for (Index f = 0; f < m.number_of_faces(); ++f) {
    first_piece.push_back(Index(old_face.size()));
    old_face.insert(old_face.end(), is_cut[f] ? m.degree(f) : 1, f);
  }
  Flat_mesh result;
  result.points = m.points;
  result.first_corner.assign(1, 0);
  const auto push = [&result](Index vertex, Index across) {
    result.corner_vertex.push_back(vertex);
    result.face_across.push_back(across);
  };
  // The new face beyond the edge after corner `c` of face `f`.
  const auto across = [&](Index f, Index c) {
    const Index g = m.face_across[c];
    if (g == NONE)
      return NONE;
    return first_piece[g] +
           (is_cut[g] ? m.corner_of(g, m.corner_vertex[m.next_corner(f, c)]) - m.first_corner[g] : 0);
  };
  for (Index f = 0; f < m.number_of_faces(); ++f) {
    cancellation.poll();
    const Index middle = Index(result.points.size());
    if (is_cut[f])
      result.points.push_back(mean_of_corners(m, f));
    for (Index c = m.first_corner[f]; c != m.first_corner[f + 1]; ++c) {
      push(m.corner_vertex[c], across(f, c));
      if (!is_cut[f])
        continue;
      push(m.corner_vertex[m.next_corner(f, c)], first_piece[f] + m.next_corner(f, c) - m.first_corner[f]);
      push(middle, first_piece[f] + m.previous_corner(f, c) - m.first_corner[f]);
      result.first_corner.push_back(Index(result.corner_vertex.size()));
    }
    if (!is_cut[f])
      result.first_corner.push_back(Index(result.corner_vertex.size()));
  }
  check_countable(result.corner_vertex.size(), "face corners after faces were cut");
  Flat_mesh_topology::complete(result, result.points.size(), cancellation);
  return result;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_STAR_SUBDIVISION_H
