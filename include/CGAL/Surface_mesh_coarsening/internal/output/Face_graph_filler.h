// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_FACE_GRAPH_FILLER_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_FACE_GRAPH_FILLER_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

template <class GeomTraits>
std::vector<typename GeomTraits::Point_3> to_points(const std::vector<Vector>& positions, const Local_frame& frame,
                                                    const GeomTraits& traits)
{
  typedef typename GeomTraits::FT FT;
  const auto construct = traits.construct_point_3_object();
  std::vector<typename GeomTraits::Point_3> points;
  points.reserve(positions.size());
  for (const Vector& position : positions) {
    const Vector p = frame.to_mesh(position);
    points.push_back(construct(FT(p[0]), FT(p[1]), FT(p[2])));
  }
  return points;
}

// Returns the map from positions in the arrays to coordinates of the output.
template <class GeomTraits>
auto output_coordinates(const Local_frame& frame)
{
  return [frame](const Vector& p) {
    Vector q = frame.to_mesh(p);
    for (double& x : q)
      x = CGAL::to_double(typename GeomTraits::FT(x));
    return q;
  };
}

// The halfedges of a triangulated 2-manifold. Edge `e` has the halfedges `2 e` and `2 e + 1`; edges are numbered in the
// order of the triangles, and halfedge `2 e` belongs to the first triangle of the edge.
struct Halfedges
{
  std::vector<Index> target, next, face; // per halfedge; `face` is NONE on the border
  std::vector<Index> of_vertex, of_face; // a halfedge that ends in the vertex, on the border if possible

  Halfedges(const std::vector<Triangle>& triangles, std::size_t vertices, const Run_context& context)
    : of_vertex(vertices, NONE), of_face(triangles.size())
  {
    const std::vector<Index> twin = opposite_sides(triangles.size(), vertices, [&](Index s) { return triangles[s / 3][s % 3]; });
    std::vector<Index> of_side(twin.size(), NONE);
    for (Index s = 0; s < Index(twin.size()); ++s) {
      context.poll();
      if (of_side[s] != NONE)
        continue;
      const Index h = Index(target.size()), t = s / 3;
      of_side[s] = h;
      if (twin[s] != NONE)
        of_side[twin[s]] = h + 1;
      target.insert(target.end(), {triangles[t][(s + 1) % 3], triangles[t][s % 3]});
      face.insert(face.end(), {t, twin[s] == NONE ? NONE : twin[s] / 3});
    }
    next.assign(target.size(), NONE);
    for (Index t = 0; t < Index(triangles.size()); ++t) {
      of_face[t] = of_side[3 * t];
      for (Index i = 0; i < 3; ++i)
        next[of_side[3 * t + i]] = of_side[3 * t + (i + 1) % 3];
    }
    for (Index h = 0; h < Index(target.size()); ++h)
      if (face[h] == NONE || of_vertex[target[h]] == NONE)
        of_vertex[target[h]] = h;
    for (Index h = 0; h < Index(target.size()); ++h)
      if (face[h] == NONE) { // its predecessor is the last halfedge around its source
        Index arriving = h ^ 1;
        while (face[arriving] != NONE)
          arriving = next[arriving] ^ 1;
        next[arriving] = h;
      }
  }
};

template <class Output, class NamedParameters>
auto output_points(const std::vector<Vector>& positions, const Local_frame& frame, const NamedParameters& np)
{
  typedef typename GetGeomTraits<Output, NamedParameters>::type Traits;
  return to_points(positions, frame, choose_parameter<Traits>(get_parameter(np, CGAL::internal_np::geom_traits)));
}

// Replaces a face graph by a triangulated surface in two steps. The constructor does everything that can fail and changes
// nothing; `commit()` changes the face graph.
//
// A face graph of arbitrary type can be filled only element by element. If this fails, because memory is exhausted or a point
// map throws, the face graph is left empty.
template <class Output, class NamedParameters>
class Face_graph_filler
{
  typedef std::vector<typename GetGeomTraits<Output, NamedParameters>::type::Point_3> Points;

  Output& output_;
  const NamedParameters& np_;
  Points points_;
  std::vector<Triangle> triangles_;

public:
  Face_graph_filler(Points points, const std::vector<Triangle>& triangles, Output& output, const NamedParameters& np,
                    const Run_context& = Run_context())
    : output_(output), np_(np), points_(std::move(points)), triangles_(triangles)
  {}

  void commit()
  {
    const auto point_map = choose_parameter(get_parameter(np_, CGAL::internal_np::vertex_point),
                                            get_property_map(CGAL::vertex_point, output_));
    clear(output_);
    try {
      Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points_, triangles_, output_,
                                                            CGAL::parameters::default_values(),
                                                            CGAL::parameters::vertex_point_map(point_map));
    } catch (...) {
      clear(output_);
      throw;
    }
  }
};

// A `Surface_mesh` allocates all memory before it changes, so it is unchanged after any failure. It keeps its property maps,
// which `clear()` would remove, because the caller may refer to them.
template <class Point, class NamedParameters>
class Face_graph_filler<Surface_mesh<Point>, NamedParameters>
{
  typedef Surface_mesh<Point> Mesh;
  typedef typename Mesh::size_type size_type;
  typedef typename Mesh::Vertex_index Vertex;
  typedef typename Mesh::Halfedge_index Halfedge;
  typedef typename Mesh::Face_index Face;
  typedef std::vector<typename GetGeomTraits<Mesh, NamedParameters>::type::Point_3> Points;

  Mesh& mesh_;
  const NamedParameters& np_;
  Points points_;
  Halfedges halfedges_;

  size_type vertices() const { return size_type(points_.size()); }
  size_type edges() const { return size_type(halfedges_.target.size() / 2); }
  size_type faces() const { return size_type(halfedges_.of_face.size()); }

public:
  Face_graph_filler(Points points, const std::vector<Triangle>& triangles, Mesh& mesh, const NamedParameters& np,
                    const Run_context& context = Run_context())
    : mesh_(mesh), np_(np), points_(std::move(points)), halfedges_(triangles, points_.size(), context)
  {
    if (!mesh_.has_garbage())
      reserve();
  }

  void commit()
  {
    // Only a mesh without elements marked as removed can be emptied without freeing its memory. Garbage collection
    // renumbers elements, so it is done as late as possible.
    if (mesh_.has_garbage()) {
      mesh_.collect_garbage();
      reserve();
    }
    put_points();
    for (size_type h = 0; h < 2 * edges(); ++h) {
      mesh_.set_target(Halfedge(h), Vertex(halfedges_.target[h]));
      mesh_.set_next(Halfedge(h), Halfedge(halfedges_.next[h]));
      mesh_.set_face(Halfedge(h), halfedges_.face[h] == NONE ? Mesh::null_face() : Face(halfedges_.face[h]));
    }
    for (size_type v = 0; v < vertices(); ++v)
      mesh_.set_halfedge(Vertex(v), Halfedge(halfedges_.of_vertex[v]));
    for (size_type f = 0; f < faces(); ++f)
      mesh_.set_halfedge(Face(f), Halfedge(halfedges_.of_face[f]));
  }

private:
  void reserve()
  {
    mesh_.reserve((std::max)(vertices(), mesh_.number_of_vertices()), (std::max)(edges(), mesh_.number_of_edges()),
                  (std::max)(faces(), mesh_.number_of_faces()));
  }

  // Resizes the mesh to its final number of elements.
  void put_points()
  {
    if constexpr (has_parameter<CGAL::internal_np::vertex_point_t, NamedParameters>) {
      // The caller's map may throw. Until it has accepted all points, the mesh only has additional elements.
      const auto map = get_parameter(np_, CGAL::internal_np::vertex_point);
      const size_type v = mesh_.number_of_vertices(), e = mesh_.number_of_edges(), f = mesh_.number_of_faces();
      mesh_.resize((std::max)(v, vertices()), e, f);
      try {
        for (size_type i = 0; i < vertices(); ++i)
          put(map, Vertex(i), points_[i]);
      } catch (...) {
        mesh_.resize(v, e, f);
        throw;
      }
    } else {
      mesh_.resize(0, 0, 0); // so all properties start with their default values
      mesh_.resize(vertices(), 0, 0);
      for (size_type i = 0; i < vertices(); ++i)
        mesh_.point(Vertex(i)) = points_[i];
    }
    mesh_.resize(vertices(), 0, 0);
    mesh_.resize(vertices(), edges(), faces());
  }
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_OUTPUT_FACE_GRAPH_FILLER_H
