// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_FUZZ_BUILD_MESH_H
#define CGAL_SURFACE_MESH_COARSENING_FUZZ_BUILD_MESH_H

#include "Fuzz_bytes.h"

#include "support/generate_meshes.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace fuzz {

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Mesh::Halfedge_index Halfedge;

inline void add_to(Mesh& mesh, const generated::Soup& soup)
{
  std::vector<Mesh::Point> points;
  for (const auto& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, soup.polygons, mesh);
}

inline generated::Soup to_soup(const Mesh& mesh)
{
  generated::Soup soup;
  std::map<Mesh::Vertex_index, std::size_t> number;
  for (const auto v : vertices(mesh)) {
    number[v] = soup.points.size();
    const auto& p = mesh.point(v);
    soup.points.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto f : faces(mesh)) {
    soup.polygons.emplace_back();
    for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      soup.polygons.back().push_back(number[v]);
  }
  return soup;
}

// Returns Euler characteristic and number of border loops of each component, sorted. Halfedges define them: a hole between
// two edges with the same ends counts, although a soup does not show it.
inline std::vector<std::pair<long, long> > topologies(const Mesh& mesh)
{
  std::map<Mesh::Face_index, std::size_t> component;
  std::vector<std::pair<long, long> > result;
  for (const auto seed : faces(mesh)) {
    if (component.count(seed))
      continue;
    const std::size_t number = result.size();
    result.emplace_back(0, 0);
    std::set<Mesh::Vertex_index> corners;
    std::set<Mesh::Edge_index> edges;
    std::set<Halfedge> border;
    std::vector<Mesh::Face_index> stack(1, seed);
    component[seed] = number;
    while (!stack.empty()) {
      const Mesh::Face_index f = stack.back();
      stack.pop_back();
      ++result[number].first;
      for (const auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh)) {
        corners.insert(mesh.target(h));
        edges.insert(mesh.edge(h));
        const Mesh::Face_index g = mesh.face(mesh.opposite(h));
        if (g == Mesh::null_face())
          border.insert(mesh.opposite(h));
        else if (component.insert({g, number}).second)
          stack.push_back(g);
      }
    }
    result[number].first += long(corners.size()) - long(edges.size());
    while (!border.empty()) {
      ++result[number].second;
      for (Halfedge h = *border.begin(); border.erase(h) != 0;)
        h = mesh.next(h);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

inline bool has_double_edges(const Mesh& mesh)
{
  std::set<std::pair<std::size_t, std::size_t> > ends;
  for (const auto h : halfedges(mesh))
    if (!ends.insert({std::size_t(mesh.source(h)), std::size_t(mesh.target(h))}).second)
      return true;
  return false;
}

inline generated::Soup start_surface(Bytes& bytes)
{
  using namespace generated;
  const std::size_t a = 1 + bytes.below(6), b = 1 + bytes.below(6);
  switch (bytes.below(14)) {
  case 0: return tetrahedron();
  case 1: return octahedron();
  case 2: return single_triangle();
  case 3: return grid(a, b);
  case 4: return triangulated(grid(a, b));
  case 5: return torus(a + 2, b + 2);
  case 6: return triangulated(torus(a + 2, b + 2));
  case 7: return tube(a + 2, b);
  case 8: return seven_vertex_torus();
  case 9: return fan(3 * a + b);
  case 10: return bipyramid(a + b + 1);
  case 11: return cube_grid(a % 3 + 1);
  case 12: return plate_with_windows(a % 3 + 1);
  default: return triangle_sphere(a % 3);
  }
}

class Editor
{
  Mesh& mesh;
  Halfedge h;

  Halfedge beyond() const { return mesh.opposite(h); }

  std::set<std::size_t> vertices_of(Halfedge g) const
  {
    std::set<std::size_t> result;
    for (const auto v : CGAL::vertices_around_face(g, mesh))
      result.insert(v);
    return result;
  }

  void flip()
  {
    if (mesh.is_border(h) || mesh.is_border(beyond()) || !CGAL::is_triangle(h, mesh) ||
        !CGAL::is_triangle(beyond(), mesh))
      return;
    const auto a = mesh.target(mesh.next(h)), b = mesh.target(mesh.next(beyond()));
    if (a != b && mesh.halfedge(a, b) == Halfedge())
      CGAL::Euler::flip_edge(h, mesh);
  }

  void split_edge() { CGAL::Euler::split_edge(h, mesh); }

  void split_face(std::size_t steps)
  {
    if (mesh.is_border(h) || CGAL::is_triangle(h, mesh))
      return;
    const std::size_t degree = CGAL::halfedges_around_face(h, mesh).size();
    Halfedge far = mesh.next(mesh.next(h));
    for (std::size_t i = steps % (degree - 3); i > 0; --i)
      far = mesh.next(far);
    CGAL::Euler::split_face(h, far, mesh);
  }

  void join_faces()
  {
    const Halfedge o = beyond();
    if (mesh.is_border(h) || mesh.is_border(o) || mesh.face(h) == mesh.face(o) ||
        CGAL::degree(mesh.target(h), mesh) <= 2 || CGAL::degree(mesh.source(h), mesh) <= 2)
      return;
    const std::set<std::size_t> a = vertices_of(h), b = vertices_of(o);
    std::size_t common = 0;
    for (const std::size_t v : a)
      common += b.count(v);
    if (common == 2)
      CGAL::Euler::join_face(h, mesh);
  }

  void add_center()
  {
    if (!mesh.is_border(h))
      CGAL::Euler::add_center_vertex(h, mesh);
  }

  // Removes a face, and its edges that have no other face.
  void remove_face()
  {
    if (!mesh.is_border(h))
      CGAL::Euler::remove_face(h, mesh);
  }

  void fill_hole()
  {
    if (mesh.is_border(h) && vertices_of(h).size() >= 3)
      CGAL::Euler::fill_hole(h, mesh);
  }

  void add_triangle()
  {
    if (mesh.is_border(h) && mesh.next(mesh.next(h)) != h)
      CGAL::Euler::add_vertex_and_face_to_border(mesh.prev(h), h, mesh);
  }

  // CGAL's link condition assumes that no two edges have the same ends: otherwise a collapse may break the mesh.
  void collapse()
  {
    if (CGAL::is_triangle_mesh(mesh) && !has_double_edges(mesh) &&
        CGAL::Euler::does_satisfy_link_condition(mesh.edge(h), mesh))
      CGAL::Euler::collapse_edge(mesh.edge(h), mesh);
  }

public:
  Editor(Mesh& mesh, Halfedge h) : mesh(mesh), h(h) {}

  void operator()(std::size_t operation, std::size_t argument)
  {
    switch (operation) {
    case 0: flip(); break;
    case 1: split_edge(); break;
    case 2: split_face(argument); break;
    case 3: join_faces(); break;
    case 4: add_center(); break;
    case 5: remove_face(); break;
    case 6: fill_hole(); break;
    case 7: add_triangle(); break;
    default: collapse();
    }
  }
};

inline void place(Mesh& mesh, std::size_t kind, Bytes& bytes)
{
  std::size_t i = 0;
  for (const auto v : vertices(mesh)) {
    Mesh::Point& p = mesh.point(v);
    const double s = double(++i);
    const auto random = [&] { return double(bytes.next()) - 128; };
    switch (kind) {
    case 0: break;
    case 1: p = Mesh::Point(1, 2, 3); break;
    case 2: p = Mesh::Point(s, 2 * s, -s); break;
    case 3: p = Mesh::Point(1e300 * p.x(), 1e300 * p.y(), 1e300 * p.z()); break;
    case 4: p = Mesh::Point(1e-310 * p.x(), 1e-310 * p.y(), 1e-310 * p.z()); break;
    case 5: p = Mesh::Point(random(), random(), random()); break;
    case 6: p = Mesh::Point(std::pow(10., random() / 10), p.y(), std::pow(10., random())); break;
    default: p = Mesh::Point(p.x() + 1e6, p.y(), std::floor(p.z()));
    }
    if (kind == 6 && i == 3 && bytes.next() == 99)
      p = Mesh::Point(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  }
}

// Builds up to three pieces and changes them. Removed elements remain as garbage unless a byte triggers its collection. The
// mesh need not be a 2-manifold.
inline Mesh build_mesh(Bytes& bytes)
{
  Mesh mesh;
  const std::size_t shape = bytes.next(), kind = bytes.next() % 8;
  for (std::size_t piece = 0; piece <= shape % 4 % 3; ++piece)
    add_to(mesh, generated::translated(start_surface(bytes), 20. * double(piece), 0, 0));
  for (std::size_t changes = bytes.next() % 64; changes > 0 && !bytes.is_empty(); --changes) {
    const std::size_t operation = bytes.below(9), all = mesh.number_of_halfedges() + mesh.number_of_removed_halfedges();
    const Halfedge h(static_cast<Mesh::size_type>(bytes.next2() % (all + !all)));
    if (all != 0 && !mesh.is_removed(h))
      Editor(mesh, h)(operation, bytes.next());
  }
  if (shape & 16)
    mesh.add_vertex(Mesh::Point(0, 0, 0));
  if (shape & 32)
    mesh.collect_garbage();
  place(mesh, kind, bytes);
  return mesh;
}

} // namespace fuzz

#endif // CGAL_SURFACE_MESH_COARSENING_FUZZ_BUILD_MESH_H
