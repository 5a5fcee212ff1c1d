// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_QUAD_SUBDIVISION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_QUAD_SUBDIVISION_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh_builder.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/face_geometry.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Subdivides chosen faces into one quadrilateral per corner, spanned by the corner, the midpoints of its two edges and
// the center of the face. The surface does not change. Adjacent faces get the midpoints of common edges as additional
// corners. The pieces of a face are consecutive, in the order of its corners; vertices keep their numbers, and new
// vertices follow.
//
// If whole components are subdivided, any two of these quadrilaterals meet in a vertex, in an arc, or not at all, even
// if the faces meet twice. Hence each quadrilateral can be a cluster.
class Quad_subdivision
{
public:
  Quad_subdivision(const Flat_mesh& m, const std::vector<char>& is_cut)
    : m_(m), is_cut_(is_cut), builder_(m.points), middle_(m.corner_vertex.size(), NONE), center_(m.number_of_faces(), NONE) {}

  Flat_mesh run(const Cancellation_point& cancellation)
  {
    number_new_elements(cancellation);
    for (Index f = 0; f < m_.number_of_faces(); ++f) {
      cancellation.poll();
      is_cut_[f] ? cut(f) : copy(f);
    }
    return builder_.finish(cancellation);
  }

  // The original face of each new face.
  const std::vector<Index>& old_face() const { return old_face_; }
  // Returns the piece of face `f` at its vertex `v`.
  Index piece_at(Index f, Index v) const
  {
    return is_cut_[f] ? first_piece_[f] + (m_.corner_of(f, v) - m_.first_corner[f]) : first_piece_[f];
  }
  // The midpoint of the edge after each corner; NONE if neither of its faces is subdivided.
  const std::vector<Index>& middle() const { return middle_; }

private:
  void number_new_elements(const Cancellation_point& cancellation)
  {
    std::size_t corners = 0;
    first_piece_.reserve(m_.number_of_faces());
    for (Index f = 0; f < m_.number_of_faces(); ++f) {
      cancellation.poll();
      first_piece_.push_back(Index(old_face_.size()));
      old_face_.insert(old_face_.end(), is_cut_[f] ? m_.degree(f) : 1, f);
      corners += is_cut_[f] ? 4 * m_.degree(f) : m_.degree(f) + number_of_cut_neighbors(f);
      check_countable(corners, "face corners after faces were cut");
      if (is_cut_[f])
        add_points(f);
    }
    builder_.reserve(old_face_.size(), corners);
  }

  Index number_of_cut_neighbors(Index f) const
  {
    Index n = 0;
    for (const Index c : m_.corners(f))
      n += m_.face_across[c] != NONE && is_cut_[m_.face_across[c]];
    return n;
  }

  void add_points(Index f)
  {
    center_[f] = builder_.add_point(mean_of_corners(m_, f));
    for (const Index c : m_.corners(f)) {
      if (middle_[c] != NONE)
        continue;
      const Index g = m_.face_across[c], end = m_.corner_vertex[m_.next_corner(f, c)];
      middle_[c] = builder_.add_point(0.5 * (m_.points[m_.corner_vertex[c]] + m_.points[end]));
      if (g != NONE)
        middle_[m_.corner_of(g, end)] = middle_[c];
    }
  }

  // Returns the piece at `v` of the face across the edge after corner `c`.
  Index piece_across(Index c, Index v) const
  {
    const Index g = m_.face_across[c];
    return g == NONE ? NONE : piece_at(g, v);
  }

  void cut(Index f)
  {
    for (const Index c : m_.corners(f)) {
      const Index v = m_.corner_vertex[c], next = m_.next_corner(f, c), previous = m_.previous_corner(f, c);
      builder_.add_corner(v, piece_across(c, v));
      builder_.add_corner(middle_[c], first_piece_[f] + (next - m_.first_corner[f]));
      builder_.add_corner(center_[f], first_piece_[f] + (previous - m_.first_corner[f]));
      builder_.add_corner(middle_[previous], piece_across(previous, v));
      builder_.end_face();
    }
  }

  void copy(Index f)
  {
    for (const Index c : m_.corners(f)) {
      const Index v = m_.corner_vertex[c];
      builder_.add_corner(v, piece_across(c, v));
      if (middle_[c] != NONE)
        builder_.add_corner(middle_[c], piece_across(c, m_.corner_vertex[m_.next_corner(f, c)]));
    }
    builder_.end_face();
  }

  const Flat_mesh& m_;
  const std::vector<char>& is_cut_; // per face
  Flat_mesh_builder builder_;
  std::vector<Index> middle_, center_, first_piece_, old_face_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_QUAD_SUBDIVISION_H
