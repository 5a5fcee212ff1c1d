// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_COPY_CONNECTIVITY_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_COPY_CONNECTIVITY_H

#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Numbering.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// A sequence of faces.
struct Face_list
{
  std::vector<Index> degree;
  std::vector<Index> corner_vertex, face_across; // per corner
};

// Lists the faces from `begin` to `end`. Each face begins with its vertex of smallest number, so that the arrays do not
// depend on the halfedge that the face graph stores for a face.
template <class FaceGraph>
void list_faces(const FaceGraph& mesh, const Numbering<FaceGraph>& n, std::size_t begin, std::size_t end, Face_list& list)
{
  list.degree.clear();
  list.corner_vertex.clear();
  list.face_across.clear();
  for (std::size_t f = begin; f != end; ++f) {
    const std::size_t first = list.corner_vertex.size();
    for (const auto h : halfedges_around_face(halfedge(n.faces[f], mesh), mesh)) {
      const auto beyond = face(opposite(h, mesh), mesh);
      list.corner_vertex.push_back(n.number_of(source(h, mesh)));
      list.face_across.push_back(beyond == boost::graph_traits<FaceGraph>::null_face() ? NONE : n.number_of(beyond));
    }
    const auto corner = list.corner_vertex.begin() + std::ptrdiff_t(first),
               across = list.face_across.begin() + std::ptrdiff_t(first);
    const std::ptrdiff_t shift = std::min_element(corner, list.corner_vertex.end()) - corner;
    std::rotate(corner, corner + shift, list.corner_vertex.end());
    std::rotate(across, across + shift, list.face_across.end());
    list.degree.push_back(Index(list.corner_vertex.size() - first));
  }
}

template <class FaceGraph>
void copy_connectivity(const FaceGraph& mesh, const Numbering<FaceGraph>& n, Flat_mesh& m, const Cancellation_point& cancellation,
                       Execution execution)
{
  m.first_corner.reserve(n.faces.size() + 1);
  m.first_corner.push_back(0);
  m.corner_vertex.reserve(3 * n.faces.size());
  m.face_across.reserve(3 * n.faces.size());
  for_each_part<Face_list>(
    execution, n.faces.size(), 1024, cancellation,
    [&](Face_list& list, std::size_t begin, std::size_t end) { list_faces(mesh, n, begin, end, list); },
    [&](const Face_list& list) {
      std::size_t corners = m.corner_vertex.size();
      m.corner_vertex.insert(m.corner_vertex.end(), list.corner_vertex.begin(), list.corner_vertex.end());
      m.face_across.insert(m.face_across.end(), list.face_across.begin(), list.face_across.end());
      for (const Index degree : list.degree)
        m.first_corner.push_back(Index(corners += degree));
    });
  check_countable(m.corner_vertex.size(), "face corners");
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_COPY_CONNECTIVITY_H
