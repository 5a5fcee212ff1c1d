// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_NUMBERING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_NUMBERING_H

#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/Run_context.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The numbers of the faces and vertices of a face graph in the arrays. Vertices are numbered in the order of iteration, and
// faces in the order of iteration or by the caller's face index map.
template <class FaceGraph>
struct Numbering
{
  typedef typename boost::graph_traits<FaceGraph>::face_descriptor face_descriptor;
  typedef typename boost::graph_traits<FaceGraph>::vertex_descriptor vertex_descriptor;

  std::vector<face_descriptor> faces;
  std::vector<vertex_descriptor> vertices;
  typename boost::property_map<FaceGraph, dynamic_face_property_t<Index> >::const_type face_number;
  typename boost::property_map<FaceGraph, dynamic_vertex_property_t<Index> >::const_type vertex_number;

  Index number_of(face_descriptor f) const { return get(face_number, f); }
  Index number_of(vertex_descriptor v) const { return get(vertex_number, v); }
};

// The elements of a `Surface_mesh` without removed elements already have consecutive numbers.
template <class Descriptor>
class Descriptor_list
{
public:
  void assign_numbered(std::size_t n) { size_ = n; }
  template <class Iterator>
  void assign(Iterator begin, Iterator end)
  {
    list_.assign(begin, end);
    size_ = list_.size();
  }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  Descriptor operator[](std::size_t i) const
  {
    typedef typename Descriptor::size_type Number;
    return list_.empty() ? Descriptor(Number(i)) : list_[i];
  }

  class iterator
  {
  public:
    iterator(const Descriptor_list& list, std::size_t i) : list_(&list), i_(i) {}
    Descriptor operator*() const { return (*list_)[i_]; }
    iterator& operator++()
    {
      ++i_;
      return *this;
    }
    bool operator!=(const iterator& other) const { return i_ != other.i_; }

  private:
    const Descriptor_list* list_;
    std::size_t i_;
  };
  iterator begin() const { return {*this, 0}; }
  iterator end() const { return {*this, size_}; }
  void swap(std::vector<Descriptor>& ordered) { list_.swap(ordered); }

private:
  std::vector<Descriptor> list_;
  std::size_t size_ = 0;
};

template <class Point>
struct Numbering<CGAL::Surface_mesh<Point> >
{
  typedef CGAL::Surface_mesh<Point> Mesh;
  typedef typename Mesh::Face_index face_descriptor;
  typedef typename Mesh::Vertex_index vertex_descriptor;

  Descriptor_list<face_descriptor> faces;
  Descriptor_list<vertex_descriptor> vertices;
  std::vector<Index> face_number, vertex_number; // empty if numbered by the mesh

  Index number_of(face_descriptor f) const { return face_number.empty() ? Index(f) : face_number[f]; }
  Index number_of(vertex_descriptor v) const { return vertex_number.empty() ? Index(v) : vertex_number[v]; }
};

inline void check_countable(std::size_t n, const char* what)
{
  // The upper half of the range is reserved for the labels of border loops.
  if (n >= NONE / 2)
    throw Invalid_input("the mesh has " + std::to_string(n) + " " + what + ", more than the " +
                        std::to_string(NONE / 2 - 1) + " that can be numbered");
}

template <class FaceGraph, class FaceIndexMap>
void number_faces_by_map(const FaceGraph&, const FaceIndexMap& index, Numbering<FaceGraph>& numbering, const Run_context& context)
{
  const auto none = boost::graph_traits<FaceGraph>::null_face();
  std::vector<bool> taken(numbering.faces.size(), false);
  std::vector<typename Numbering<FaceGraph>::face_descriptor> ordered(numbering.faces.size(), none);
  for (const auto f : numbering.faces) {
    context.poll();
    const std::size_t i = std::size_t(get(index, f));
    if (i >= ordered.size() || taken[i])
      throw Invalid_input("the face index map gives " + std::to_string(i) + (i < ordered.size() ? " twice" : "") +
                          " for a mesh of " + std::to_string(ordered.size()) + " faces");
    taken[i] = true;
    ordered[i] = f;
  }
  numbering.faces.swap(ordered);
}

template <class FaceGraph>
void number_faces_by_map(const FaceGraph&, const CGAL::internal_np::Param_not_found&, Numbering<FaceGraph>&, const Run_context&)
{}

template <class FaceGraph, class FaceIndexMap>
Numbering<FaceGraph> number_elements(const FaceGraph& mesh, const FaceIndexMap& index, const Run_context& context)
{
  Numbering<FaceGraph> n;
  n.faces.assign(faces(mesh).begin(), faces(mesh).end());
  n.vertices.assign(vertices(mesh).begin(), vertices(mesh).end());
  check_countable(n.faces.size(), "faces");
  check_countable(n.vertices.size(), "vertices");
  number_faces_by_map(mesh, index, n, context);
  n.face_number = get(dynamic_face_property_t<Index>(), mesh);
  n.vertex_number = get(dynamic_vertex_property_t<Index>(), mesh);
  for (std::size_t i = 0; i < n.faces.size(); ++i) {
    context.poll();
    put(n.face_number, n.faces[i], Index(i));
  }
  for (std::size_t i = 0; i < n.vertices.size(); ++i) {
    context.poll();
    put(n.vertex_number, n.vertices[i], Index(i));
  }
  return n;
}

template <class Point, class FaceIndexMap>
Numbering<CGAL::Surface_mesh<Point> > number_elements(const CGAL::Surface_mesh<Point>& mesh, const FaceIndexMap& index,
                                                      const Run_context& context)
{
  constexpr bool has_index = !std::is_same<FaceIndexMap, CGAL::internal_np::Param_not_found>::value;
  Numbering<CGAL::Surface_mesh<Point> > n;
  check_countable(mesh.number_of_faces(), "faces");
  check_countable(mesh.number_of_vertices(), "vertices");
  if (has_index || mesh.number_of_removed_faces() > 0) {
    n.faces.assign(mesh.faces_begin(), mesh.faces_end());
    number_faces_by_map(mesh, index, n, context);
    n.face_number.assign(mesh.number_of_faces() + mesh.number_of_removed_faces(), NONE);
    for (std::size_t i = 0; i < n.faces.size(); ++i) {
      context.poll();
      n.face_number[n.faces[i]] = Index(i);
    }
  } else {
    n.faces.assign_numbered(mesh.number_of_faces());
  }
  if (mesh.number_of_removed_vertices() > 0) {
    n.vertices.assign(mesh.vertices_begin(), mesh.vertices_end());
    n.vertex_number.assign(mesh.number_of_vertices() + mesh.number_of_removed_vertices(), NONE);
    for (std::size_t i = 0; i < n.vertices.size(); ++i) {
      context.poll();
      n.vertex_number[n.vertices[i]] = Index(i);
    }
  } else {
    n.vertices.assign_numbered(mesh.number_of_vertices());
  }
  return n;
}

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
void copy_connectivity(const FaceGraph& mesh, const Numbering<FaceGraph>& n, Flat_mesh& m, const Run_context& context)
{
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
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_NUMBERING_H
