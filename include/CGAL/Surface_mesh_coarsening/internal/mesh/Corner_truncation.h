// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CORNER_TRUNCATION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CORNER_TRUNCATION_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh_builder.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Cuts chosen corners off their faces, as triangles that contain the corner and a third of each of its two edges. The surface
// does not change. The triangles cut off a face follow the face.
class Corner_truncation
{
public:
  Corner_truncation(const Flat_mesh& mesh, const std::vector<bool>& is_cut)
    : m_(mesh), is_cut_(is_cut), near_source_(mesh.corner_vertex.size(), NONE), near_target_(mesh.corner_vertex.size(), NONE),
      builder_(mesh.points)
  {}

  Flat_mesh run()
  {
    number_faces();
    add_points();
    for (Index f = 0; f < m_.number_of_faces(); ++f) {
      add_rest(f);
      for (const Index c : m_.corners(f))
        if (is_cut_[c])
          add_corner(f, c);
    }
    return builder_.finish();
  }

  // The original face of each new face, and its corner if the new face was cut off; otherwise NONE.
  const std::vector<Index>& old_face() const { return old_face_; }
  const std::vector<Index>& old_corner() const { return old_corner_; }

private:
  void number_faces()
  {
    rest_.resize(m_.number_of_faces());
    cut_off_.assign(m_.corner_vertex.size(), NONE);
    for (Index f = 0; f < m_.number_of_faces(); ++f) {
      rest_[f] = Index(old_face_.size());
      old_face_.push_back(f);
      old_corner_.push_back(NONE);
      for (const Index c : m_.corners(f))
        if (is_cut_[c]) {
          cut_off_[c] = Index(old_face_.size());
          old_face_.push_back(f);
          old_corner_.push_back(c);
        }
    }
  }

  // Both faces of an edge share the points on it.
  void add_points()
  {
    for (Index f = 0; f < m_.number_of_faces(); ++f)
      for (const Index c : m_.corners(f)) {
        if (is_cut_[c] && near_source_[c] == NONE)
          add_point_after(f, c);
        const Index previous = m_.previous_corner(f, c);
        if (is_cut_[c] && near_target_[previous] == NONE)
          add_point_before(c, previous);
      }
  }

  // Adds the point near corner `c` on the edge after it.
  void add_point_after(Index f, Index c)
  {
    const Index v = m_.corner_vertex[c], w = m_.corner_vertex[m_.next_corner(f, c)], g = m_.face_across[c];
    near_source_[c] = add_point(v, w);
    if (g != NONE)
      near_target_[m_.corner_of(g, w)] = near_source_[c];
  }

  // Adds the point near corner `c` on the edge before it.
  void add_point_before(Index c, Index previous)
  {
    const Index v = m_.corner_vertex[c], w = m_.corner_vertex[previous], g = m_.face_across[previous];
    near_target_[previous] = add_point(v, w);
    if (g != NONE)
      near_source_[m_.corner_of(g, v)] = near_target_[previous];
  }

  Index add_point(Index v, Index w)
  {
    return builder_.add_point(m_.points[v] + (1. / 3) * (m_.points[w] - m_.points[v]));
  }

  // Return the new faces across the edge after corner `c`: across its part at `v`, and across the rest.
  Index across_near(Index c, Index v) const
  {
    const Index g = m_.face_across[c];
    if (g == NONE)
      return NONE;
    const Index corner = m_.corner_of(g, v);
    return is_cut_[corner] ? cut_off_[corner] : rest_[g];
  }
  Index across(Index c) const { return m_.face_across[c] == NONE ? NONE : rest_[m_.face_across[c]]; }

  void add_rest(Index f)
  {
    for (const Index c : m_.corners(f)) {
      const Index next = m_.next_corner(f, c), v = m_.corner_vertex[c], w = m_.corner_vertex[next];
      if (!is_cut_[c]) {
        builder_.add_corner(v, near_source_[c] == NONE ? across(c) : across_near(c, v));
        if (near_source_[c] != NONE)
          builder_.add_corner(near_source_[c], across(c));
      } else {
        builder_.add_corner(near_target_[m_.previous_corner(f, c)], cut_off_[c]);
        builder_.add_corner(near_source_[c], across(c));
      }
      if (near_target_[c] != NONE && !is_cut_[next])
        builder_.add_corner(near_target_[c], across_near(c, w));
    }
    builder_.end_face();
  }

  void add_corner(Index f, Index c)
  {
    const Index v = m_.corner_vertex[c], previous = m_.previous_corner(f, c);
    builder_.add_corner(v, across_near(c, v));
    builder_.add_corner(near_source_[c], rest_[f]);
    builder_.add_corner(near_target_[previous], across_near(previous, v));
    builder_.end_face();
  }

  const Flat_mesh& m_;
  const std::vector<bool>& is_cut_; // per corner
  std::vector<Index> near_source_, near_target_; // points on the edge after each corner
  std::vector<Index> rest_, cut_off_;            // new faces: per face, per corner
  std::vector<Index> old_face_, old_corner_;
  Flat_mesh_builder builder_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CORNER_TRUNCATION_H
