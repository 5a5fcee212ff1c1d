// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_TEST_RANDOM_SURFACES_H
#define CGAL_SURFACE_MESH_COARSENING_TEST_RANDOM_SURFACES_H

#include "face_graphs.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <random>
#include <set>
#include <vector>

// Random surfaces of a given topology.
namespace generated {
namespace internal {

typedef test::Mesh::Halfedge_index Halfedge;

inline Halfedge random_halfedge(const test::Mesh& m, std::mt19937& engine)
{
  const std::size_t n = m.number_of_halfedges() + m.number_of_removed_halfedges();
  Halfedge h;
  do
    h = Halfedge(static_cast<test::Mesh::size_type>(engine() % n));
  while (m.is_removed(h));
  return h;
}

inline std::set<std::size_t> vertices_of(const test::Mesh& m, Halfedge h)
{
  std::set<std::size_t> vertices;
  for (const auto v : CGAL::vertices_around_face(h, m))
    vertices.insert(v);
  return vertices;
}

// Flips an edge if both faces are triangles and the other diagonal is no edge yet.
inline void try_flip(test::Mesh& m, Halfedge h)
{
  const Halfedge o = m.opposite(h);
  if (m.is_border(h) || m.is_border(o) || !CGAL::is_triangle(h, m) || !CGAL::is_triangle(o, m))
    return;
  const auto a = m.target(m.next(h)), b = m.target(m.next(o));
  if (a == b || m.halfedge(a, b) != Halfedge())
    return;
  CGAL::Euler::flip_edge(h, m);
}

inline void try_split_face(test::Mesh& m, Halfedge h)
{
  if (!m.is_border(h))
    CGAL::Euler::add_center_vertex(h, m);
}

// A new vertex on an edge, joined with the opposite corner on each side.
inline void try_split_edge(test::Mesh& m, Halfedge h)
{
  const Halfedge at = CGAL::Euler::split_edge(h, m);
  for (const Halfedge g : {m.next(at), m.opposite(at)}) {
    // The face of `g`, which leaves the new vertex.
    if (m.is_border(g))
      continue;
    const Halfedge arriving = m.prev(g), far = m.next(g);
    if (m.next(far) != arriving && m.halfedge(m.target(far), m.source(g)) == Halfedge())
      CGAL::Euler::split_face(arriving, far, m);
  }
}

// Joins two faces that meet in this edge only, unless a vertex would have two faces or fewer.
inline void try_join_faces(test::Mesh& m, Halfedge h)
{
  const Halfedge o = m.opposite(h);
  if (m.is_border(h) || m.is_border(o) || m.face(h) == m.face(o))
    return;
  if (CGAL::degree(m.target(h), m) <= 3 || CGAL::degree(m.source(h), m) <= 3 || CGAL::degree(m.face(h), m) > 6)
    return;
  const std::set<std::size_t> a = vertices_of(m, h), b = vertices_of(m, o);
  std::size_t common = 0;
  for (const std::size_t v : a)
    common += b.count(v);
  if (common == 2)
    CGAL::Euler::join_face(h, m);
}

} // namespace internal

// Applies edge flips, face splits, edge splits and, on request, joins of faces: all keep the topology.
inline Soup random_surface(const Soup& start, std::size_t changes, bool polygons, std::mt19937& engine)
{
  test::Mesh m = test::to_mesh(start);
  for (std::size_t i = 0; i < changes; ++i) {
    const internal::Halfedge h = internal::random_halfedge(m, engine);
    switch (engine() % (polygons ? 6 : 5)) {
    case 0:
    case 1:
    case 2:
      internal::try_flip(m, h);
      break;
    case 3:
      internal::try_split_face(m, h);
      break;
    case 4:
      internal::try_split_edge(m, h);
      break;
    default:
      internal::try_join_faces(m, h);
    }
  }
  m.collect_garbage();
  // Energies do not matter: points only have to differ.
  Soup soup = test::to_soup(m);
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    soup.points[v] = {symmetric_random(engine), symmetric_random(engine), double(v)};
  return soup;
}

} // namespace generated

#endif // CGAL_SURFACE_MESH_COARSENING_TEST_RANDOM_SURFACES_H
