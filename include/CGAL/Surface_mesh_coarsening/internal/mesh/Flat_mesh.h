// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FLAT_MESH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FLAT_MESH_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

inline void check_countable(std::size_t n, const char* what, const char* mesh = "the mesh")
{
  // The upper half of the range is reserved for the labels of border loops.
  if (n >= NONE / 2)
    throw Invalid_input(std::string(mesh) + " has " + std::to_string(n) + " " + what + ", more than the " +
                        std::to_string(NONE / 2 - 1) + " that can be numbered");
}

// The first corner of each face. Stores nothing while all faces are triangles.
class Corner_offsets
{
public:
  Index operator[](std::size_t i) const { return is_listed_ ? offsets_[i] : Index(3 * i); }
  std::size_t size() const { return size_; }
  bool are_of_triangles() const { return !is_listed_; }
  void reserve(std::size_t n) { reserved_ = n; }
  void push_back(Index offset)
  {
    if (!is_listed_ && offset != Index(3 * size_)) {
      is_listed_ = true;
      offsets_.reserve((std::max)(reserved_, size_ + 1));
      for (std::size_t i = 0; i < size_; ++i)
        offsets_.push_back(Index(3 * i));
    }
    if (is_listed_)
      offsets_.push_back(offset);
    ++size_;
  }

private:
  std::vector<Index> offsets_;
  std::size_t size_ = 0, reserved_ = 0;
  bool is_listed_ = false;
};

// The component of each face. Stores nothing if there is only one, and 16 bits if there are few.
class Component_numbers
{
public:
  Index operator[](std::size_t f) const { return !short_.empty() ? short_[f] : long_.empty() ? 0 : long_[f]; }
  void set(std::vector<Index> numbers, std::size_t components)
  {
    *this = Component_numbers();
    if (components > std::size_t(1) << 16)
      long_ = std::move(numbers);
    else if (components > 1)
      short_.assign(numbers.begin(), numbers.end());
  }

private:
  std::vector<std::uint16_t> short_;
  std::vector<Index> long_;
};

// The topology of one connected component.
struct Component
{
  std::size_t faces = 0;
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t loops = 0;
  // With features: the number of vertices before subdivision, and the numbers of clusters and corners of the features.
  std::size_t original_vertices = 0, feature_clusters = 0, feature_corners = 0;

  std::size_t max_clusters() const { return original_vertices > 0 ? original_vertices : vertices; }
  long euler_characteristic() const { return long(vertices) - long(edges) + long(faces); }
  std::size_t genus() const { return std::size_t(2 - euler_characteristic() - long(loops)) / 2; }
};

// A polygon mesh in arrays: the corners of each face in counterclockwise order, the face across the edge after each
// corner, and the faces around each vertex in counterclockwise order. The star of a border vertex begins at its
// clockwise end, the star of an inner vertex at its face of smallest index.
struct Flat_mesh
{
  Corner_offsets first_corner;       // per face, and the total
  std::vector<Index> corner_vertex;  // per corner
  std::vector<Index> face_across;    // for the edge from each corner to the next; NONE on the border
  std::vector<Index> first_in_star;  // per vertex, and the total
  std::vector<Index> star;
  std::vector<Index> loop;           // border loop of each vertex; NONE inside
  Component_numbers component;       // per face
  std::vector<Component> components;
  std::vector<Vector> points;        // relative to a local origin

  std::size_t number_of_faces() const { return first_corner.size() - 1; }
  std::size_t number_of_vertices() const { return first_in_star.size() - 1; }
  bool is_triangle_mesh() const { return first_corner.are_of_triangles(); }
  bool is_on_border(Index v) const { return loop[v] != NONE; }
  Index valence(std::size_t v) const { return first_in_star[v + 1] - first_in_star[v]; }
  Index degree(Index f) const { return first_corner[f + 1] - first_corner[f]; }
  Number_range corners(std::size_t f) const { return number_range(first_corner[f], first_corner[f + 1]); }
  template <class Predicate>
  bool any_corner(std::size_t f, const Predicate& is_true) const
  {
    const Number_range range = corners(f);
    return std::any_of(range.begin(), range.end(), is_true);
  }
  bool has_border_edge(std::size_t f) const { return any_corner(f, [this](Index c) { return face_across[c] == NONE; }); }
  Iterator_range<std::vector<Index>::const_iterator> faces_around(std::size_t v) const
  {
    return {star.begin() + first_in_star[v], star.begin() + first_in_star[v + 1]};
  }

  const Vector& point_at(Index corner) const { return points[corner_vertex[corner]]; }
  Index next_corner(Index f, Index c) const { return c + 1 == first_corner[f + 1] ? first_corner[f] : c + 1; }
  Index previous_corner(Index f, Index c) const
  {
    return c == first_corner[f] ? first_corner[f + 1] - 1 : c - 1;
  }
  Index corner_of(Index f, Index v) const
  {
    Index c = first_corner[f];
    while (corner_vertex[c] != v)
      ++c;
    return c;
  }
  // Returns the vector from corner `c` to the next corner.
  Vector edge_vector(Index f, Index c) const { return point_at(next_corner(f, c)) - point_at(c); }
  // Returns the corner before the same edge in the face across the edge after corner `c`; NONE on the border.
  Index opposite_corner(Index f, Index c) const
  {
    return face_across[c] == NONE ? NONE : corner_of(face_across[c], corner_vertex[next_corner(f, c)]);
  }
  // Returns the end of the border edge that begins at border vertex `v` and has its face on the left.
  Index next_on_border(Index v) const
  {
    const Index f = star[first_in_star[v]];
    return corner_vertex[next_corner(f, corner_of(f, v))];
  }
};

// Traverses the faces breadth first from `seed`, which the caller has marked. The edge after corner `c` is crossed to
// face `g` if `enter(c, g)`, which marks `g`. Appends the faces to `reached` in the order of traversal.
// `CGAL::Polygon_mesh_processing::connected_component()` stores visited faces in a tree and cannot be cancelled.
template <class Enter>
void flood_fill(const Flat_mesh& m, Index seed, std::vector<Index>& reached, const Run_context& context, const Enter& enter)
{
  reached.assign(1, seed);
  for (std::size_t i = 0; i < reached.size(); ++i) {
    context.poll();
    for (const Index c : m.corners(reached[i])) {
      const Index g = m.face_across[c];
      if (g != NONE && enter(c, g))
        reached.push_back(g);
    }
  }
}

// Numbers the connected parts of `faces` in the order of their first faces. A part continues across the edge after corner `c` to
// face `g` if `may_enter(c, g)`. `part` holds NONE for each face that has no part yet. Returns the number of parts.
template <class Faces, class May_enter>
Index number_parts(const Flat_mesh& m, const Faces& faces, std::vector<Index>& part, const Run_context& context,
                   const May_enter& may_enter)
{
  Index parts = 0;
  std::vector<Index> reached;
  for (const Index seed : faces) {
    if (part[seed] != NONE)
      continue;
    part[seed] = parts;
    flood_fill(m, seed, reached, context, [&](Index c, Index g) {
      const bool is_new = part[g] == NONE && may_enter(c, g);
      if (is_new)
        part[g] = parts;
      return is_new;
    });
    ++parts;
  }
  return parts;
}

// Calls `visit(loop)` for the vertices of each border loop, from the smallest along the border.
template <class Visit>
void for_each_border_loop(const Flat_mesh& m, const Run_context& context, const Visit& visit)
{
  std::vector<bool> done(m.number_of_vertices(), false);
  std::vector<Index> loop;
  for (std::size_t v = 0; v < done.size(); ++v) {
    if (!m.is_on_border(Index(v)) || done[v])
      continue;
    loop.clear();
    for (Index w = Index(v); !done[w]; w = m.next_on_border(w)) {
      context.poll();
      done[w] = true;
      loop.push_back(w);
    }
    visit(loop);
  }
}

// Returns the bounding box of the faces of a cluster, enlarged by half its diagonal.
template <class FaceRange>
Bbox_3 vertex_bounds(const Flat_mesh& mesh, const FaceRange& faces)
{
  Bbox_3 box;
  for (const Index f : faces)
    for (const Index c : mesh.corners(f))
      box += box_of_point(mesh.point_at(c));
  // Computed positions may differ by their rounding.
  const double largest = (std::max)(largest_coordinate(low_corner(box)), largest_coordinate(high_corner(box)));
  return grown(box, 0.5 * std::sqrt(squared_diagonal(box)) + 1e-12 * largest);
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FLAT_MESH_H
