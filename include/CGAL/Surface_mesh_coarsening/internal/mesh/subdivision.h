// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_SUBDIVISION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_SUBDIVISION_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Replaces the faces of a mesh by pieces, which are added face by face. New vertices may lie on edges of the mesh, and divide
// them into parts. Vertices keep their numbers, and new vertices follow.
class Face_cutting
{
public:
  // The original face of each new face, and the original corner before the edge that contains the edge after each new corner;
  // NONE inside the face.
  const std::vector<Index>& old_face() const { return old_face_; }
  const std::vector<Index>& old_corner() const { return old_corner_; }
  // The midpoint of the edge after each corner; NONE if it is not halved.
  const std::vector<Index>& middle() const { return middle_; }

protected:
  // The opposite edge has the parts in the other order.
  enum Part : unsigned char { AT_SOURCE, WHOLE, AT_TARGET };

  // A vertex on the boundary of a face, the corner before it or at it, and the part of the edge of this corner after the vertex.
  struct Place
  {
    Index vertex, corner;
    Part part;
  };

  explicit Face_cutting(const Flat_mesh& m) : m_(m), middle_(m.corner_vertex.size(), NONE), piece_(m.corner_vertex.size())
  {
    mesh_.points = m.points;
    mesh_.first_corner.push_back(0);
  }

  void reserve(std::size_t pieces, std::size_t corners)
  {
    mesh_.first_corner.reserve(pieces + 1);
    mesh_.corner_vertex.reserve(corners);
    mesh_.face_across.reserve(corners);
    old_face_.reserve(pieces);
    old_corner_.reserve(corners);
    part_.reserve(corners);
  }

  // The number of the piece that is being added.
  Index number() const { return Index(old_face_.size()); }

  Index add_point(const Vector& p)
  {
    mesh_.points.push_back(p);
    return Index(mesh_.points.size() - 1);
  }

  void add_outer_corner(const Place& place)
  {
    piece_[place.corner][place.part] = number();
    add_corner(place, NONE); // build() finds the piece across the edge
  }

  // Adds a corner before an edge inside the original face.
  void add_inner_corner(Index vertex, Index piece_across) { add_corner({vertex, NONE, WHOLE}, piece_across); }

  void add_corner(const Place& place, Index face_across)
  {
    mesh_.corner_vertex.push_back(place.vertex);
    mesh_.face_across.push_back(face_across);
    old_corner_.push_back(place.corner);
    part_.push_back(place.part);
  }

  void end_piece(Index f)
  {
    mesh_.first_corner.push_back(Index(mesh_.corner_vertex.size()));
    old_face_.push_back(f);
  }

  // Adds a whole face, with the midpoints of its edges.
  void copy(Index f)
  {
    for (const Place& place : boundary(f))
      add_outer_corner(place);
    end_piece(f);
  }

  // Adds the pieces of each face by `add_pieces(f)` and returns their mesh.
  template <class Add_pieces>
  Flat_mesh build(const Run_context& context, const Add_pieces& add_pieces)
  {
    for (Index f = 0; f < m_.number_of_faces(); ++f) {
      context.poll();
      add_pieces(f);
    }
    for (std::size_t piece = 0; piece < old_face_.size(); ++piece)
      for (const Index corner : mesh_.corners(piece))
        if (old_corner_[corner] != NONE) {
          const Index opposite = m_.opposite_corner(old_face_[piece], old_corner_[corner]);
          mesh_.face_across[corner] = opposite == NONE ? NONE : piece_[opposite][AT_TARGET - part_[corner]];
        }
    check_countable(mesh_.corner_vertex.size(), "face corners after faces were cut");
    // Otherwise, these arrays would determine the largest memory.
    std::vector<std::array<Index, 3> >().swap(piece_);
    std::vector<Part>().swap(part_);
    complete_topology(mesh_, mesh_.points.size(), context);
    return std::move(mesh_);
  }

  std::vector<Place> boundary(Index f) const
  {
    std::vector<Place> places;
    places.reserve(2 * m_.degree(f));
    for (const Index c : m_.corners(f)) {
      places.push_back({m_.corner_vertex[c], c, middle_[c] == NONE ? WHOLE : AT_SOURCE});
      if (middle_[c] != NONE)
        places.push_back({middle_[c], c, AT_TARGET});
    }
    return places;
  }

  void halve(Index f, Index c)
  {
    const Index opposite = m_.opposite_corner(f, c);
    middle_[c] = add_point(0.5 * (m_.point_at(c) + m_.point_at(m_.next_corner(f, c))));
    if (opposite != NONE)
      middle_[opposite] = middle_[c];
  }

  // Adds the pieces of a face between the places `ends` of its boundary: the sectors around `center` or, without a center, the
  // parts on both sides of a cut.
  void add_sectors(Index f, const std::vector<std::size_t>& ends, Index center)
  {
    const std::vector<Place> places = boundary(f);
    const Index n = Index(ends.size()), first = number();
    for (Index i = 0; i < n; ++i) {
      const std::size_t end = i + 1 < n ? ends[i + 1] : ends[0] + places.size();
      for (std::size_t k = ends[i]; k < end; ++k)
        add_outer_corner(places[k % places.size()]);
      add_inner_corner(places[end % places.size()].vertex, first + (i + 1) % n);
      if (center != NONE)
        add_inner_corner(center, first + (i + n - 1) % n);
      end_piece(f);
    }
  }

  const Flat_mesh& m_;
  Flat_mesh mesh_; // of the pieces
  std::vector<Index> middle_;
  std::vector<std::array<Index, 3> > piece_; // at each part of the edge after each corner
  std::vector<Index> old_face_, old_corner_;
  std::vector<Part> part_; // of the edge after each new corner
};

// Subdivides chosen faces into the triangles between their edges and `center(face)`. The triangles of a face are consecutive, in
// the order of its corners.
class Star_subdivision : public Face_cutting
{
public:
  Star_subdivision(const Flat_mesh& m, std::vector<char> is_cut) : Face_cutting(m), is_cut_(std::move(is_cut)) {}

  template <class Center>
  Flat_mesh run(const Center& center, const Run_context& context)
  {
    std::size_t pieces = 0, corners = 0;
    for (Index f = 0; f < m_.number_of_faces(); ++f) {
      pieces += is_cut_[f] ? m_.degree(f) : 1;
      corners += (is_cut_[f] ? 3 : 1) * m_.degree(f);
    }
    reserve(pieces, corners);
    return build(context, [&](Index f) {
      if (!is_cut_[f])
        return copy(f);
      std::vector<std::size_t> ends(m_.degree(f));
      std::iota(ends.begin(), ends.end(), std::size_t(0));
      add_sectors(f, ends, add_point(center(f)));
    });
  }

private:
  const std::vector<char> is_cut_; // per face
};

// Subdivides chosen faces into one quadrilateral per corner, spanned by the corner, the midpoints of its two edges and
// the center of the face. The surface does not change. Adjacent faces get the midpoints of common edges as additional
// corners. The pieces of a face are consecutive, in the order of its corners; vertices keep their numbers, and new
// vertices follow.
//
// If whole components are subdivided, any two of these quadrilaterals meet in a vertex, in an arc, or not at all, even
// if the faces meet twice. Hence each quadrilateral can be a cluster.
class Quad_subdivision : public Face_cutting
{
public:
  Quad_subdivision(const Flat_mesh& m, std::vector<char> is_cut)
    : Face_cutting(m), is_cut_(std::move(is_cut)), center_(m.number_of_faces(), NONE) {}

  Flat_mesh run(const Run_context& context)
  {
    add_points(context);
    return build(context, [this](Index f) {
      if (!is_cut_[f])
        return copy(f);
      const Index first = number() - m_.first_corner[f];
      for (const Index c : m_.corners(f)) {
        const Index previous = m_.previous_corner(f, c);
        add_outer_corner({m_.corner_vertex[c], c, AT_SOURCE});
        add_inner_corner(middle_[c], first + m_.next_corner(f, c));
        add_inner_corner(center_[f], first + previous);
        add_outer_corner({middle_[previous], previous, AT_TARGET});
        end_piece(f);
      }
    });
  }

private:
  void add_points(const Run_context& context)
  {
    std::size_t pieces = m_.number_of_faces(), corners = m_.corner_vertex.size();
    for (Index f = 0; f < m_.number_of_faces(); ++f) {
      context.poll();
      if (!is_cut_[f])
        continue;
      pieces += m_.degree(f) - 1;
      corners += 3 * m_.degree(f);
      center_[f] = add_point(mean_of_corners(m_, f));
      for (const Index c : m_.corners(f)) {
        corners += m_.face_across[c] != NONE && !is_cut_[m_.face_across[c]]; // the face across gets the midpoint
        if (middle_[c] == NONE)
          halve(f, c);
      }
      check_countable(corners, "face corners after faces were cut");
    }
    reserve(pieces, corners);
  }

  const std::vector<char> is_cut_; // per face
  std::vector<Index> center_;
};

// Halves edges that are longer than a bound, and cuts their faces from midpoint to midpoint: to a common center if there are more
// than two, and to an opposite vertex if there is only one. The surface does not change. Repeated cuts divide long faces into
// round pieces, which subdivisions of all edges would never do.
class Long_edge_cutting : public Face_cutting
{
public:
  Long_edge_cutting(const Flat_mesh& m, double max_squared_length) : Face_cutting(m)
  {
    for (Index f = 0; f < m.number_of_faces(); ++f)
      for (const Index c : m.corners(f))
        if (middle_[c] == NONE && squared_length(m.edge_vector(f, c)) > max_squared_length)
          halve(f, c);
  }

  bool has_cut() const { return mesh_.points.size() > m_.points.size(); }

  Flat_mesh run(const Run_context& context)
  {
    return build(context, [this](Index f) {
      const std::vector<Place> places = boundary(f);
      std::vector<std::size_t> ends; // where pieces meet
      for (std::size_t i = 0; i < places.size(); ++i)
        if (places[i].part == AT_TARGET)
          ends.push_back(i);
      if (ends.empty())
        return copy(f);
      if (ends.size() == 1)
        ends.push_back((ends[0] + places.size() / 2) % places.size());
      std::sort(ends.begin(), ends.end());
      add_sectors(f, ends, ends.size() > 2 ? add_point(mean_of_corners(m_, f)) : NONE);
    });
  }
};

// Cuts chosen corners off their faces, as triangles that contain the corner and a third of each of its two edges. The surface
// does not change. The triangles cut off a face follow the face.
class Corner_truncation : public Face_cutting
{
public:
  Corner_truncation(const Flat_mesh& m, const std::vector<bool>& is_cut)
    : Face_cutting(m), is_cut_(is_cut), near_source_(m.corner_vertex.size(), NONE), near_target_(near_source_) {}

  Flat_mesh run()
  {
    for (Index f = 0; f < m_.number_of_faces(); ++f)
      for (const Index c : m_.corners(f))
        if (is_cut_[c])
          add_points(f, c);
    return build(Run_context(), [this](Index f) {
      const Index rest = number();
      add_rest(f);
      for (const Index c : m_.corners(f)) {
        if (!is_cut_[c])
          continue;
        const Index previous = m_.previous_corner(f, c);
        add_outer_corner({m_.corner_vertex[c], c, AT_SOURCE});
        add_inner_corner(near_source_[c], rest);
        add_outer_corner({near_target_[previous], previous, AT_TARGET});
        end_piece(f);
      }
    });
  }

private:
  // Adds the points on both sides of corner `c`. Both faces of an edge share the points on it.
  void add_points(Index f, Index c)
  {
    const Vector& p = m_.point_at(c);
    const auto add_third = [&](Index edge, Index other_end, std::vector<Index>& points, std::vector<Index>& points_across) {
      if (points[edge] != NONE)
        return;
      points[edge] = add_point(p + (1. / 3) * (m_.point_at(other_end) - p));
      if (const Index opposite = m_.opposite_corner(f, edge); opposite != NONE)
        points_across[opposite] = points[edge];
    };
    const Index previous = m_.previous_corner(f, c);
    add_third(c, m_.next_corner(f, c), near_source_, near_target_);
    add_third(previous, previous, near_target_, near_source_);
  }

  void add_rest(Index f)
  {
    Index cut_off = number();
    for (const Index c : m_.corners(f)) {
      if (is_cut_[c])
        add_inner_corner(near_target_[m_.previous_corner(f, c)], ++cut_off);
      else
        add_outer_corner({m_.corner_vertex[c], c, near_source_[c] == NONE ? WHOLE : AT_SOURCE});
      if (near_source_[c] != NONE)
        add_outer_corner({near_source_[c], c, WHOLE});
      if (near_target_[c] != NONE && !is_cut_[m_.next_corner(f, c)])
        add_outer_corner({near_target_[c], c, AT_TARGET});
    }
    end_piece(f);
  }

  const std::vector<bool>& is_cut_;              // per corner
  std::vector<Index> near_source_, near_target_; // points on the edge after each corner
};

// Returns which faces belong to the chosen components.
inline std::vector<char> faces_of_components(const Flat_mesh& m, const std::vector<bool>& is_chosen)
{
  std::vector<char> result(m.number_of_faces());
  for (std::size_t f = 0; f < result.size(); ++f)
    result[f] = is_chosen[m.component[f]];
  return result;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_SUBDIVISION_H
