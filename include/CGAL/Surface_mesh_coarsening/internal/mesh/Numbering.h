// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_NUMBERING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_NUMBERING_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Run_context.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/complete_mesh.h>

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

template <class FaceGraph>
struct Is_surface_mesh : std::false_type
{};
template <class Point>
struct Is_surface_mesh<CGAL::Surface_mesh<Point> > : std::true_type
{};

// The faces or vertices of a face graph in the order of their numbers, and these numbers. Elements of a `Surface_mesh` without
// removed elements already have consecutive numbers, so nothing is stored for them.
template <class FaceGraph, class Descriptor, class Number_property>
class Numbered_elements
{
  static constexpr bool is_indexed = Is_surface_mesh<FaceGraph>::value;
  typedef typename boost::property_map<FaceGraph, Number_property>::const_type Number_map;

  struct Element
  {
    const Numbered_elements* elements;
    Descriptor operator()(std::size_t i) const { return (*elements)[i]; }
  };

public:
  typedef boost::transform_iterator<Element, boost::counting_iterator<std::size_t> > iterator;

  // For elements numbered from 0 to `n` by the mesh.
  void assign_numbered(std::size_t n) { size_ = n; }

  void assign(const FaceGraph& mesh, std::vector<Descriptor> elements, const Run_context& context)
  {
    list_ = std::move(elements);
    size_ = list_.size();
    if constexpr (is_indexed)
      number_.assign(size_ == 0 ? 0 : std::size_t(*std::max_element(list_.begin(), list_.end())) + 1, NONE);
    else
      number_ = get(Number_property(), mesh);
    for (std::size_t i = 0; i < size_; ++i) {
      context.poll();
      if constexpr (is_indexed)
        number_[list_[i]] = Index(i);
      else
        put(number_, list_[i], Index(i));
    }
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  iterator begin() const { return {boost::counting_iterator<std::size_t>(0), Element{this}}; }
  iterator end() const { return {boost::counting_iterator<std::size_t>(size_), Element{this}}; }

  Descriptor operator[](std::size_t i) const
  {
    if constexpr (is_indexed)
      return list_.empty() ? Descriptor(typename Descriptor::size_type(i)) : list_[i];
    else
      return list_[i];
  }
  Index number_of(Descriptor element) const
  {
    if constexpr (is_indexed)
      return list_.empty() ? Index(element) : number_[element];
    else
      return get(number_, element);
  }

private:
  std::vector<Descriptor> list_;
  std::size_t size_ = 0;
  std::conditional_t<is_indexed, std::vector<Index>, Number_map> number_;
};

// The numbers of the faces and vertices of a face graph in the arrays. Vertices are numbered in the order of iteration, and
// faces in the order of iteration or by the caller's face index map.
template <class FaceGraph>
struct Numbering
{
  typedef typename boost::graph_traits<FaceGraph>::face_descriptor face_descriptor;
  typedef typename boost::graph_traits<FaceGraph>::vertex_descriptor vertex_descriptor;

  Numbered_elements<FaceGraph, face_descriptor, dynamic_face_property_t<Index> > faces;
  Numbered_elements<FaceGraph, vertex_descriptor, dynamic_vertex_property_t<Index> > vertices;

  Index number_of(face_descriptor f) const { return faces.number_of(f); }
  Index number_of(vertex_descriptor v) const { return vertices.number_of(v); }
};

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
Flat_mesh flat_connectivity(const FaceGraph& mesh, const Numbering<FaceGraph>& n, const Run_context& context = Run_context())
{
  Flat_mesh m;
  m.first_corner.reserve(n.faces.size() + 1);
  m.first_corner.push_back(0);
  m.corner_vertex.reserve(3 * n.faces.size());
  m.face_across.reserve(3 * n.faces.size());
  for_each_part<Face_list>(
    context, n.faces.size(), 1024,
    [&](Face_list& list, std::size_t begin, std::size_t end) { list_faces(mesh, n, begin, end, list); },
    [&](const Face_list& list) {
      std::size_t corners = m.corner_vertex.size();
      m.corner_vertex.insert(m.corner_vertex.end(), list.corner_vertex.begin(), list.corner_vertex.end());
      m.face_across.insert(m.face_across.end(), list.face_across.begin(), list.face_across.end());
      for (const Index degree : list.degree)
        m.first_corner.push_back(Index(corners += degree));
    });
  check_countable(m.corner_vertex.size(), "face corners");
  complete_topology(m, n.vertices.size(), context);
  return m;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_NUMBERING_H
