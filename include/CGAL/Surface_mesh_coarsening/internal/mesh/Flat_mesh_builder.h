// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FLAT_MESH_BUILDER_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FLAT_MESH_BUILDER_H

#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/Run_context.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Numbering.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Computes stars, components and loops from the corners and the faces across edges; throws if they do not form a
// 2-manifold.
class Flat_mesh_topology
{
public:
  static void complete(Flat_mesh& m, std::size_t number_of_vertices, const Run_context& context = Run_context())
  {
    complete_stars(m, number_of_vertices, context);
    number_components(m, context);
    count_loops(m);
  }

  // Computes stars and loops, but no components.
  static void complete_stars(Flat_mesh& m, std::size_t number_of_vertices, const Run_context& context)
  {
    check_faces(m, context);
    count_stars(m, number_of_vertices);
    std::vector<Index> start = first_corners_of_stars(m, number_of_vertices, context);
    const std::size_t wrong = first_of(context, number_of_vertices, [&](Index v) { return !walk_star(m, v, start[v]); });
    if (wrong < number_of_vertices)
      throw Invalid_input("vertex " + std::to_string(wrong) +
                          " is not a manifold vertex: the faces around it form more than one fan");
    number_loops(m, context);
  }

private:
  static void check_faces(const Flat_mesh& m, const Run_context& context)
  {
    const std::size_t wrong = first_of(context, m.number_of_faces(), [&](Index f) {
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
    for (const Index c : m.corners(f))
      if (m.face_across[c] == f)
        return true;
    return false;
  }

  // Returns NONE if there is none.
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

  // Computes the face where each star begins: one face index per vertex, NONE for isolated vertices.
  static std::vector<Index> first_corners_of_stars(Flat_mesh& m, std::size_t number_of_vertices, const Run_context& context)
  {
    std::vector<Index> start(number_of_vertices, NONE);
    m.loop.assign(number_of_vertices, NONE);
    for (std::size_t f = m.number_of_faces(); f-- > 0;) {
      context.poll();
      for (const Index c : m.corners(f)) {
        const Index v = m.corner_vertex[c];
        if (m.face_across[c] == NONE) {
          if (m.loop[v] != NONE)
            throw Invalid_input("vertex " + std::to_string(v) + " lies on the border twice");
          m.loop[v] = 0; // on a loop, which is numbered later
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

  static void number_components(Flat_mesh& m, const Run_context& context)
  {
    std::vector<Index> number(m.number_of_faces(), NONE), reached;
    m.components.clear();
    for (std::size_t seed = 0; seed < m.number_of_faces(); ++seed) {
      if (number[seed] != NONE)
        continue;
      const Index id = Index(m.components.size());
      number[seed] = id;
      flood_fill(m, Index(seed), reached, context, [&](Index, Index g) {
        const bool is_new = number[g] == NONE;
        number[g] = id;
        return is_new;
      });
      m.components.push_back(component_of(m, reached));
    }
    m.component.set(std::move(number), m.components.size());
    for (std::size_t v = 0; v < m.number_of_vertices(); ++v)
      if (m.first_in_star[v] != m.first_in_star[v + 1])
        ++m.components[m.component[m.star[m.first_in_star[v]]]].vertices;
  }

  // Counts faces and edges.
  static Component component_of(const Flat_mesh& m, const std::vector<Index>& faces)
  {
    Component component;
    component.faces = faces.size();
    std::size_t corners = 0, border_edges = 0;
    for (const Index f : faces)
      for (const Index c : m.corners(f)) {
        ++corners;
        border_edges += m.face_across[c] == NONE;
      }
    component.edges = (corners + border_edges) / 2;
    return component;
  }

  static void number_loops(Flat_mesh& m, const Run_context& context)
  {
    std::vector<bool> done(m.number_of_vertices(), false);
    Index loops = 0;
    for (std::size_t v = 0; v < m.number_of_vertices(); ++v) {
      if (m.loop[v] == NONE || done[v])
        continue;
      for (Index w = Index(v); !done[w]; w = m.next_on_border(w)) {
        context.poll();
        done[w] = true;
        m.loop[w] = loops;
      }
      ++loops;
    }
  }

  // Counts the loops of each component.
  static void count_loops(Flat_mesh& m)
  {
    std::vector<Index> component_of_loop;
    for (std::size_t v = 0; v < m.number_of_vertices(); ++v)
      if (m.loop[v] != NONE && m.loop[v] >= component_of_loop.size())
        component_of_loop.push_back(m.component[m.star[m.first_in_star[v]]]);
    for (const Index component : component_of_loop)
      ++m.components[component].loops;
  }
};

class Flat_mesh_builder
{
public:
  explicit Flat_mesh_builder(std::vector<Vector> points)
  {
    mesh_.points = std::move(points);
    mesh_.first_corner.push_back(0);
  }

  void reserve(std::size_t faces, std::size_t corners)
  {
    mesh_.first_corner.reserve(faces + 1);
    mesh_.corner_vertex.reserve(corners);
    mesh_.face_across.reserve(corners);
  }

  Index add_point(const Vector& p)
  {
    mesh_.points.push_back(p);
    return Index(mesh_.points.size() - 1);
  }

  // Adds a corner to the face, and the face across the edge after it; NONE on the border.
  void add_corner(Index vertex, Index face_across)
  {
    mesh_.corner_vertex.push_back(vertex);
    mesh_.face_across.push_back(face_across);
  }

  void end_face() { mesh_.first_corner.push_back(Index(mesh_.corner_vertex.size())); }

  // Throws if the faces do not form a 2-manifold.
  Flat_mesh finish(const Run_context& context = Run_context())
  {
    check_countable(mesh_.corner_vertex.size(), "face corners after faces were cut");
    Flat_mesh_topology::complete(mesh_, mesh_.points.size(), context);
    return std::move(mesh_);
  }

private:
  Flat_mesh mesh_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FLAT_MESH_BUILDER_H
