// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_TO_MESH_H
#define COARSENING_SUPPORT_TO_MESH_H

#include "io/Mesh.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace coarsening_support {

// The connectivity of a soup without faults, made edge by edge. To add face by face, as CGAL's functions do, takes quadratic time
// where very many faces are around a vertex, or a face has very many sides.
class Soup_connectivity
{
  struct Side
  {
    std::size_t low, high; // the ends of the edge
    std::size_t source, face, number;
  };

  Mesh& mesh_;
  std::vector<Mesh::Halfedge_index> halfedge_of_side_;
  std::vector<Mesh::Halfedge_index> border_from_; // the border halfedge that leaves each vertex

  static std::vector<Side> sides_of(const Soup& soup)
  {
    std::vector<Side> sides;
    for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
      const auto& p = soup.polygons[f];
      for (std::size_t i = 0; i < p.size(); ++i) {
        const std::size_t a = p[i], b = p[i + 1 == p.size() ? 0 : i + 1];
        sides.push_back({(std::min)(a, b), (std::max)(a, b), a, f, sides.size()});
      }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
      return std::tie(s.low, s.high, s.number) < std::tie(t.low, t.high, t.number);
    });
    return sides;
  }

  void take(Mesh::Halfedge_index h, const Side& s)
  {
    mesh_.set_target(h, Mesh::Vertex_index(Mesh::size_type(s.source == s.low ? s.high : s.low)));
    mesh_.set_target(mesh_.opposite(h), Mesh::Vertex_index(Mesh::size_type(s.source)));
    mesh_.set_face(h, Mesh::Face_index(Mesh::size_type(s.face)));
    halfedge_of_side_[s.number] = h;
  }

  void add_edges(const std::vector<Side>& sides)
  {
    halfedge_of_side_.resize(sides.size());
    for (std::size_t i = 0; i < sides.size();) {
      const Mesh::Halfedge_index h = mesh_.add_edge();
      take(h, sides[i]);
      const bool is_inner = i + 1 < sides.size() && sides[i].low == sides[i + 1].low && sides[i].high == sides[i + 1].high;
      if (is_inner)
        take(mesh_.opposite(h), sides[i + 1]);
      else
        border_from_[mesh_.source(mesh_.opposite(h))] = mesh_.opposite(h);
      i += is_inner ? 2 : 1;
    }
  }

  void link_faces(const Soup& soup)
  {
    std::size_t first = 0;
    for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
      const std::size_t n = soup.polygons[f].size();
      for (std::size_t i = 0; i < n; ++i) {
        const Mesh::Halfedge_index h = halfedge_of_side_[first + i];
        mesh_.set_next(h, halfedge_of_side_[first + (i + 1 == n ? 0 : i + 1)]);
        mesh_.set_halfedge(mesh_.target(h), h);
      }
      mesh_.set_halfedge(Mesh::Face_index(Mesh::size_type(f)), halfedge_of_side_[first]);
      first += n;
    }
  }

  void link_borders()
  {
    for (const Mesh::Halfedge_index h : border_from_)
      if (h != Mesh::null_halfedge()) {
        mesh_.set_next(h, border_from_[mesh_.target(h)]);
        mesh_.set_halfedge(mesh_.target(h), h);
      }
  }

public:
  // The mesh has the vertices of the soup, and nothing else.
  explicit Soup_connectivity(Mesh& mesh)
    : mesh_(mesh), border_from_(mesh.number_of_vertices(), Mesh::null_halfedge()) {}

  void add_faces(const Soup& soup)
  {
    for (std::size_t f = 0; f < soup.polygons.size(); ++f)
      mesh_.add_face();
    add_edges(sides_of(soup));
    link_faces(soup);
    link_borders();
  }
};

// Makes a mesh of a soup without faults; faces and vertices keep their numbers.
inline Mesh to_mesh(const Soup& soup)
{
  Mesh mesh;
  for (const auto& p : soup.points)
    mesh.add_vertex(p);
  Soup_connectivity(mesh).add_faces(soup);
  return mesh;
}

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_TO_MESH_H
