// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_SUBDIVIDE_FLAT_MESH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_SUBDIVIDE_FLAT_MESH_H

#include <CGAL/Surface_mesh_coarsening/internal/build_flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/face_geometry.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Cuts each face of the chosen components into one quadrilateral per corner, from the corner to the middles of its two
// edges and the middle of the face; the surface does not change. Any two of these quadrilaterals meet in a vertex, in
// an arc, or not at all, even where the faces themselves meet twice: each of them can be a cluster of its own.
class Flat_mesh_subdivision
{
public:
  // `parent`: the face of the unsubdivided mesh of each face; brought up to date.
  static Flat_mesh run(const Flat_mesh& m, const std::vector<bool>& chosen_component, std::vector<Index>& parent,
                       const Checkpoint& checkpoint = Checkpoint())
  {
    Flat_mesh_subdivision s(m, chosen_component);
    s.number_new_elements(checkpoint);
    std::vector<Index> new_parent;
    for (std::size_t f = 0; f < m.number_of_faces(); ++f)
      for (Index i = 0; i < s.pieces(Index(f)); ++i)
        new_parent.push_back(parent[f]);
    for (std::size_t f = 0; f < m.number_of_faces(); ++f) {
      checkpoint.pass();
      s.chosen_[m.component[f]] ? s.cut(Index(f)) : s.copy(Index(f));
    }
    Flat_mesh_topology::complete(s.result_, s.result_.points.size(), checkpoint);
    parent.swap(new_parent);
    return std::move(s.result_);
  }

private:
  Flat_mesh_subdivision(const Flat_mesh& m, const std::vector<bool>& chosen) : m_(m), chosen_(chosen) {}

  Index pieces(Index f) const { return chosen_[m_.component[f]] ? m_.degree(f) : 1; }

  void number_new_elements(const Checkpoint& checkpoint)
  {
    std::size_t faces = 0, corners = 0;
    first_piece_.reserve(m_.number_of_faces());
    middle_.assign(m_.corner_vertex.size(), NONE);
    center_.assign(m_.number_of_faces(), NONE);
    result_.points = m_.points;
    for (std::size_t f = 0; f < m_.number_of_faces(); ++f) {
      checkpoint.pass();
      first_piece_.push_back(Index(faces));
      faces += pieces(Index(f));
      corners += chosen_[m_.component[f]] ? 4 * m_.degree(Index(f)) : m_.degree(Index(f));
      if (chosen_[m_.component[f]])
        add_points(Index(f));
      check_countable(corners, "face corners after subdivision");
    }
    result_.first_corner.assign(1, 0);
    result_.first_corner.reserve(faces + 1);
    result_.corner_vertex.reserve(corners);
    result_.face_across.reserve(corners);
  }

  void add_points(Index f)
  {
    center_[f] = Index(result_.points.size());
    result_.points.push_back(mean_of_corners(m_, f));
    for (Index c = m_.first_corner[f]; c != m_.first_corner[f + 1]; ++c) {
      const Index g = m_.face_across[c], end = m_.corner_vertex[m_.next_corner(f, c)];
      if (g != NONE && g < f) {
        middle_[c] = middle_[m_.corner_of(g, end)];
        continue;
      }
      middle_[c] = Index(result_.points.size());
      result_.points.push_back(0.5 * (m_.points[m_.corner_vertex[c]] + m_.points[end]));
    }
  }

  Index piece(Index f, Index corner) const { return first_piece_[f] + (corner - m_.first_corner[f]); }

  // The piece at `v` of the face across the edge after corner `c`.
  Index piece_across(Index c, Index v) const
  {
    const Index g = m_.face_across[c];
    return g == NONE ? NONE : piece(g, m_.corner_of(g, v));
  }

  void push(Index vertex, Index across)
  {
    result_.corner_vertex.push_back(vertex);
    result_.face_across.push_back(across);
  }

  void cut(Index f)
  {
    for (Index c = m_.first_corner[f]; c != m_.first_corner[f + 1]; ++c) {
      const Index v = m_.corner_vertex[c], next = m_.next_corner(f, c), previous = m_.previous_corner(f, c);
      push(v, piece_across(c, v));
      push(middle_[c], piece(f, next));
      push(center_[f], piece(f, previous));
      push(middle_[previous], piece_across(previous, v));
      result_.first_corner.push_back(Index(result_.corner_vertex.size()));
    }
  }

  void copy(Index f)
  {
    for (Index c = m_.first_corner[f]; c != m_.first_corner[f + 1]; ++c)
      push(m_.corner_vertex[c], m_.face_across[c] == NONE ? NONE : first_piece_[m_.face_across[c]]);
    result_.first_corner.push_back(Index(result_.corner_vertex.size()));
  }

  const Flat_mesh& m_;
  const std::vector<bool>& chosen_;
  Flat_mesh result_;
  std::vector<Index> first_piece_; // of each face
  std::vector<Index> middle_;      // vertex in the middle of the edge after each corner
  std::vector<Index> center_;      // vertex in the middle of each face
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_SUBDIVIDE_FLAT_MESH_H
