// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_SUBDIVISION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_SUBDIVISION_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Run_context.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh_builder.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/complete_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Subdivides chosen faces into the triangles between their edges and `center(face)`. The triangles of a face are consecutive, in
// the order of its corners; vertices keep their numbers, and the centers follow. `old_face` receives the original face of each
// new face.
template <class Center>
Flat_mesh star_subdivision(const Flat_mesh& m, const std::vector<char>& is_cut, const Center& center,
                           std::vector<Index>& old_face, const Run_context& context)
{
  std::vector<Index> first_piece;
  std::size_t corners = 0;
  old_face.clear();
  for (Index f = 0; f < m.number_of_faces(); ++f) {
    first_piece.push_back(Index(old_face.size()));
    old_face.insert(old_face.end(), is_cut[f] ? m.degree(f) : 1, f);
    corners += (is_cut[f] ? 3 : 1) * m.degree(f);
  }
  Flat_mesh_builder builder(m.points);
  builder.reserve(old_face.size(), corners);
  // Returns the new face on the other side of the edge after corner `c` of face `f`.
  const auto across = [&](Index f, Index c) {
    const Index g = m.face_across[c];
    if (g == NONE)
      return NONE;
    return first_piece[g] +
           (is_cut[g] ? m.corner_of(g, m.corner_vertex[m.next_corner(f, c)]) - m.first_corner[g] : 0);
  };
  for (Index f = 0; f < m.number_of_faces(); ++f) {
    context.poll();
    const Index middle = is_cut[f] ? builder.add_point(center(f)) : NONE;
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
  return builder.finish(context);
}

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

  Flat_mesh run(const Run_context& context)
  {
    number_new_elements(context);
    for (Index f = 0; f < m_.number_of_faces(); ++f) {
      context.poll();
      is_cut_[f] ? cut(f) : copy(f);
    }
    return builder_.finish(context);
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
  void number_new_elements(const Run_context& context)
  {
    std::size_t corners = 0;
    first_piece_.reserve(m_.number_of_faces());
    for (Index f = 0; f < m_.number_of_faces(); ++f) {
      context.poll();
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

// Halves edges that are longer than a bound, and cuts their faces from midpoint to midpoint: to a common center if there are more
// than two, and to an opposite vertex if there is only one. The surface does not change. Repeated cuts divide long faces into
// round pieces, which subdivisions of all edges would never do.
class Long_edge_cutting
{
public:
  Long_edge_cutting(const Flat_mesh& m, double max_squared_length)
    : m_(m), builder_(m.points), middle_(m.corner_vertex.size(), NONE), first_half_(middle_), second_half_(middle_)
  {
    for (Index f = 0; f < m.number_of_faces(); ++f)
      for (const Index c : m.corners(f))
        if (middle_[c] == NONE)
          halve_if_long(f, c, max_squared_length);
  }

  bool has_cut() const { return has_cut_; }

  Flat_mesh run(const Run_context& context)
  {
    for (Index f = 0; f < m_.number_of_faces(); ++f)
      number_pieces(f);
    for (Index f = 0; f < m_.number_of_faces(); ++f) {
      context.poll();
      add_pieces(f);
    }
    return builder_.finish(context);
  }

  // The original face of each new face, and the original corner before the edge that contains the edge after each new corner;
  // NONE inside the face.
  const std::vector<Index>& old_face() const { return old_face_; }
  const std::vector<Index>& old_corner() const { return old_corner_; }

private:
  // A vertex on the boundary of a face, the corner before it or at it, and whether it is the midpoint of the edge after the corner.
  struct Place
  {
    Index vertex, corner;
    bool is_middle;
  };

  void halve_if_long(Index f, Index c, double max_squared_length)
  {
    const Index end = m_.corner_vertex[m_.next_corner(f, c)], g = m_.face_across[c];
    const Vector &p = m_.points[m_.corner_vertex[c]], &q = m_.points[end];
    if (!(dot(q - p, q - p) > max_squared_length))
      return;
    has_cut_ = true;
    middle_[c] = builder_.add_point(0.5 * (p + q));
    if (g != NONE)
      middle_[m_.corner_of(g, end)] = middle_[c];
  }

  std::vector<Place> boundary(Index f) const
  {
    std::vector<Place> places;
    for (const Index c : m_.corners(f)) {
      places.push_back({m_.corner_vertex[c], c, false});
      if (middle_[c] != NONE)
        places.push_back({middle_[c], c, true});
    }
    return places;
  }

  // Returns the places where pieces meet: none if the face stays whole.
  static std::vector<std::size_t> ends_of_cuts(const std::vector<Place>& places)
  {
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (places[i].is_middle)
        ends.push_back(i);
    if (ends.size() == 1)
      ends.push_back((ends[0] + places.size() / 2) % places.size());
    std::sort(ends.begin(), ends.end());
    return ends;
  }

  void number_pieces(Index f)
  {
    const std::vector<Place> places = boundary(f);
    const std::vector<std::size_t> ends = ends_of_cuts(places);
    const Index pieces = (std::max)(Index(1), Index(ends.size())), first = Index(old_face_.size());
    Index piece = pieces - 1; // the last piece contains the first place
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (std::binary_search(ends.begin(), ends.end(), i))
        piece = (piece + 1) % pieces;
      (places[i].is_middle ? second_half_ : first_half_)[places[i].corner] = first + piece;
    }
    old_face_.insert(old_face_.end(), pieces, f);
  }

  void add_pieces(Index f)
  {
    const std::vector<Place> places = boundary(f);
    const std::vector<std::size_t> ends = ends_of_cuts(places);
    const std::size_t n = ends.size();
    if (n == 0) {
      add_boundary(f, places, 0, places.size());
      builder_.end_face();
      return;
    }
    const Index center = n > 2 ? builder_.add_point(mean_of_corners(m_, f)) : NONE;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t begin = ends[i], end = i + 1 < n ? ends[i + 1] : ends[0] + places.size();
      const auto piece = [&](std::size_t k) { return piece_after(places[ends[k % n]]); };
      add_boundary(f, places, begin, end);
      add_corner(places[end % places.size()].vertex, piece(i + 1), NONE);
      if (n > 2)
        add_corner(center, piece(i + n - 1), NONE);
      builder_.end_face();
    }
  }

  void add_boundary(Index f, const std::vector<Place>& places, std::size_t begin, std::size_t end)
  {
    for (std::size_t i = begin; i < end; ++i) {
      const Place& place = places[i % places.size()];
      add_corner(place.vertex, piece_across(f, place), place.corner);
    }
  }

  void add_corner(Index vertex, Index face_across, Index old_corner)
  {
    builder_.add_corner(vertex, face_across);
    old_corner_.push_back(old_corner);
  }

  // Return the pieces on both sides of the boundary after a place. The other face has the halves of an edge in the other order.
  Index piece_after(const Place& place) const { return (place.is_middle ? second_half_ : first_half_)[place.corner]; }
  Index piece_across(Index f, const Place& place) const
  {
    const Index c = place.corner, g = m_.face_across[c];
    if (g == NONE)
      return NONE;
    const Index corner = m_.corner_of(g, m_.corner_vertex[m_.next_corner(f, c)]);
    return (middle_[c] == NONE || place.is_middle ? first_half_ : second_half_)[corner];
  }

  const Flat_mesh& m_;
  Flat_mesh_builder builder_;
  std::vector<Index> middle_;                   // of the edge after each corner; NONE if it is not halved
  std::vector<Index> first_half_, second_half_; // the pieces at the halves of the edge after each corner
  std::vector<Index> old_face_, old_corner_;
  bool has_cut_ = false;
};

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

// Returns the input with the faces of the chosen components subdivided into one piece per corner.
inline Clustering_input subdivided_input(const Clustering_input& input, const std::vector<bool>& chosen_component,
                                         const Run_context& context)
{
  std::vector<char> is_cut(input.mesh.number_of_faces());
  for (std::size_t f = 0; f < is_cut.size(); ++f)
    is_cut[f] = chosen_component[input.mesh.component[f]];
  Quad_subdivision cutting(input.mesh, is_cut);
  Flat_mesh pieces = cutting.run(context);
  return cut_input(input, std::move(pieces), cutting.old_face(), context);
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_SUBDIVISION_H
