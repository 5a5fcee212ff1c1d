// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FLAT_MESH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FLAT_MESH_H

#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/Visitor_handle.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

constexpr Index NONE = (std::numeric_limits<Index>::max)();

typedef std::array<double, 3> Vector;

inline Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator*(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Where the corners of each face begin. As long as all faces are triangles, nothing is stored.
class Corner_offsets
{
public:
  Index operator[](std::size_t i) const { return is_listed_ ? offsets_[i] : Index(3 * i); }
  std::size_t size() const { return size_; }
  void reserve(std::size_t n) { reserved_ = n; }
  void push_back(Index offset)
  {
    if (!is_listed_ && offset != Index(3 * size_))
      list();
    if (is_listed_)
      offsets_.push_back(offset);
    ++size_;
  }
  void assign(std::size_t n, Index offset)
  {
    *this = Corner_offsets();
    for (std::size_t i = 0; i < n; ++i)
      push_back(offset);
  }

private:
  void list()
  {
    offsets_.reserve((std::max)(reserved_, size_ + 1));
    for (std::size_t i = 0; i < size_; ++i)
      offsets_.push_back(Index(3 * i));
    is_listed_ = true;
  }

  std::vector<Index> offsets_;
  std::size_t size_ = 0, reserved_ = 0;
  bool is_listed_ = false;
};

// The component of each face. Nothing is stored if there is only one.
class Component_numbers
{
public:
  Index operator[](std::size_t f) const { return numbers_.empty() ? 0 : numbers_[f]; }
  void set(std::vector<Index> numbers, std::size_t components)
  {
    if (components < 2)
      numbers = std::vector<Index>();
    numbers_.swap(numbers);
  }

private:
  std::vector<Index> numbers_;
};

// What topology says of one connected component.
struct Component
{
  std::size_t faces = 0;
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t loops = 0;
  // Where there are features: the vertices before faces were cut at them, the clusters that they need, and their corners.
  std::size_t original_vertices = 0, feature_clusters = 0, feature_corners = 0;

  std::size_t max_clusters() const { return original_vertices > 0 ? original_vertices : vertices; }
  long euler_characteristic() const { return long(vertices) - long(edges) + long(faces); }
  std::size_t genus() const { return std::size_t(2 - euler_characteristic() - long(loops)) / 2; }
};

// A polygon mesh in arrays: the corners of each face in counterclockwise order, the face across the edge that follows
// each corner, and the faces around each vertex in counterclockwise order. The star of a vertex on the border begins
// at its clockwise end, that of an inner vertex at its face of the smallest index.
struct Flat_mesh
{
  Corner_offsets first_corner;       // of each face, and one past the last
  std::vector<Index> corner_vertex;  // of each corner
  std::vector<Index> face_across;    // the edge from each corner to the next; NONE beyond the border
  std::vector<Index> first_in_star;  // of each vertex, and one past the last
  std::vector<Index> star;
  std::vector<Index> loop;           // border loop of each vertex; NONE inside
  Component_numbers component;       // of each face
  std::vector<Component> components;
  std::vector<Vector> points;        // relative to a local origin

  std::size_t number_of_faces() const { return first_corner.size() - 1; }
  std::size_t number_of_vertices() const { return first_in_star.size() - 1; }
  std::size_t number_of_loops() const
  {
    std::size_t n = 0;
    for (const Component& c : components)
      n += c.loops;
    return n;
  }
  bool is_on_border(Index v) const { return loop[v] != NONE; }
  Index degree(Index f) const { return first_corner[f + 1] - first_corner[f]; }

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
  // Position of face `f` in the star of `v`, as an index into `star`.
  Index position_in_star(Index v, Index f) const
  {
    Index i = first_in_star[v];
    while (star[i] != f)
      ++i;
    return i;
  }
};

// Fills what follows from the corners and the faces across edges; throws where they do not form a 2-manifold.
class Flat_mesh_topology
{
public:
  static void complete(Flat_mesh& m, std::size_t number_of_vertices,
                       const Cancellation_point& cancellation = Cancellation_point(), Execution execution = Execution::SEQUENTIAL)
  {
    check_faces(m, cancellation, execution);
    count_stars(m, number_of_vertices);
    std::vector<Index> start = first_corners_of_stars(m, number_of_vertices, cancellation);
    const std::size_t wrong = first_of(execution, number_of_vertices, cancellation,
                                       [&](Index v) { return !walk_star(m, v, start[v]); });
    if (wrong < number_of_vertices)
      throw Invalid_input("vertex " + std::to_string(wrong) +
                          " is not a manifold vertex: the faces around it form more than one fan");
    number_components(m, cancellation);
    number_loops(m, cancellation);
  }

private:
  static void check_faces(const Flat_mesh& m, const Cancellation_point& cancellation, Execution execution)
  {
    const std::size_t wrong = first_of(execution, m.number_of_faces(), cancellation, [&](Index f) {
      return m.degree(f) < 3 || is_own_neighbor(m, f) || vertex_visited_twice(m, f) != NONE;
    });
    if (wrong == m.number_of_faces())
      return;
    const Index f = Index(wrong);
    const std::string name = "face " + std::to_string(f);
    if (m.degree(f) < 3)
      throw Invalid_input(name + " has " + std::to_string(m.degree(f)) + " sides");
    if (is_own_neighbor(m, f))
      throw Invalid_input(name + " is its own neighbor across an edge");
    throw Invalid_input(name + " visits vertex " + std::to_string(vertex_visited_twice(m, f)) + " twice");
  }

  static bool is_own_neighbor(const Flat_mesh& m, Index f)
  {
    for (Index c = m.first_corner[f]; c != m.first_corner[f + 1]; ++c)
      if (m.face_across[c] == f)
        return true;
    return false;
  }

  // NONE if there is none.
  static Index vertex_visited_twice(const Flat_mesh& m, Index f)
  {
    const auto begin = m.corner_vertex.begin() + m.first_corner[f], end = m.corner_vertex.begin() + m.first_corner[f + 1];
    auto twice = end;
    if (end - begin <= 8) {
      for (auto i = begin; i != end && twice == end; ++i)
        if (std::find(i + 1, end, *i) != end)
          twice = i;
      return twice == end ? NONE : *twice;
    } else {
      std::vector<Index> sorted(begin, end);
      std::sort(sorted.begin(), sorted.end());
      const auto pair = std::adjacent_find(sorted.begin(), sorted.end());
      return pair == sorted.end() ? NONE : *std::find(begin, end, *pair);
    }
  }

  static void count_stars(Flat_mesh& m, std::size_t number_of_vertices)
  {
    m.first_in_star.assign(number_of_vertices + 1, 0);
    for (Index v : m.corner_vertex)
      ++m.first_in_star[v + 1];
    for (std::size_t v = 0; v < number_of_vertices; ++v)
      m.first_in_star[v + 1] += m.first_in_star[v];
    m.star.resize(m.corner_vertex.size());
  }

  // The face where each star begins. Kept per vertex as a face index; NONE for isolated vertices.
  static std::vector<Index> first_corners_of_stars(Flat_mesh& m, std::size_t number_of_vertices,
                                                   const Cancellation_point& cancellation)
  {
    std::vector<Index> start(number_of_vertices, NONE);
    m.loop.assign(number_of_vertices, NONE);
    for (std::size_t f = m.number_of_faces(); f-- > 0;) {
      cancellation.poll();
      for (Index c = m.first_corner[f]; c != m.first_corner[f + 1]; ++c) {
        const Index v = m.corner_vertex[c];
        if (m.face_across[c] == NONE) {
          if (m.loop[v] != NONE)
            throw Invalid_input("vertex " + std::to_string(v) + " lies on the border twice");
          m.loop[v] = 0; // on some loop; numbered later
          start[v] = Index(f);
        } else if (m.loop[v] == NONE) {
          start[v] = Index(f);
        }
      }
    }
    return start;
  }

  // Returns whether the faces around the vertex form one fan, closed or from border to border.
  static bool walk_star(Flat_mesh& m, Index v, Index f)
  {
    const Index begin = m.first_in_star[v], end = m.first_in_star[v + 1];
    if (begin == end)
      return true;
    const Index first = f;
    Index i = begin;
    do {
      m.star[i++] = f;
      f = m.face_across[m.previous_corner(f, m.corner_of(f, v))];
    } while (f != NONE && f != first && i != end);
    const bool closed = m.loop[v] == NONE;
    return i == end && (closed ? f == first : f == NONE);
  }

  static void number_components(Flat_mesh& m, const Cancellation_point& cancellation)
  {
    std::vector<Index> number(m.number_of_faces(), NONE);
    m.components.clear();
    std::vector<Index> stack;
    for (std::size_t seed = 0; seed < m.number_of_faces(); ++seed) {
      if (number[seed] != NONE)
        continue;
      const Index id = Index(m.components.size());
      Component component;
      std::size_t border_edges = 0, corners = 0;
      stack.assign(1, Index(seed));
      number[seed] = id;
      while (!stack.empty()) {
        const Index f = stack.back();
        stack.pop_back();
        cancellation.poll();
        ++component.faces;
        for (Index c = m.first_corner[f]; c != m.first_corner[f + 1]; ++c) {
          const Index g = m.face_across[c];
          ++corners;
          if (g == NONE)
            ++border_edges;
          else if (number[g] == NONE) {
            number[g] = id;
            stack.push_back(g);
          }
        }
      }
      component.edges = (corners + border_edges) / 2;
      m.components.push_back(component);
    }
    m.component.set(std::move(number), m.components.size());
    for (std::size_t v = 0; v < m.number_of_vertices(); ++v)
      if (m.first_in_star[v] != m.first_in_star[v + 1])
        ++m.components[m.component[m.star[m.first_in_star[v]]]].vertices;
  }

  static void number_loops(Flat_mesh& m, const Cancellation_point& cancellation)
  {
    std::vector<bool> done(m.number_of_vertices(), false);
    Index loops = 0;
    for (std::size_t v = 0; v < m.number_of_vertices(); ++v) {
      if (m.loop[v] == NONE || done[v])
        continue;
      for (Index w = Index(v); !done[w]; w = next_on_border(m, w)) {
        cancellation.poll();
        done[w] = true;
        m.loop[w] = loops;
      }
      ++m.components[m.component[m.star[m.first_in_star[v]]]].loops;
      ++loops;
    }
  }

public:
  // The end of the border edge that begins at border vertex `v` and has its face on the left.
  static Index next_on_border(const Flat_mesh& m, Index v)
  {
    const Index f = m.star[m.first_in_star[v]];
    return m.corner_vertex[m.next_corner(f, m.corner_of(f, v))];
  }
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FLAT_MESH_H
