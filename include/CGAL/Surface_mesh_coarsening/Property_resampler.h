// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_PROPERTY_RESAMPLER_H
#define CGAL_SURFACE_MESH_COARSENING_PROPERTY_RESAMPLER_H

#include <CGAL/Surface_mesh_coarsening/Surface_location.h>
#include <CGAL/Surface_mesh_coarsening/internal/transfer/Surface_correspondence.h>

#include <array>
#include <vector>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// The ways to transfer values of a mesh to its coarse mesh.
enum class Transfer_policy
{
  /// The value at the nearest point of the mesh, for example for colors and fields. A value whose type has no means is the value
  /// of the element that contains the point, or of the nearest corner of that element.
  INTERPOLATED,
  /// The integral over the cluster divided by the coarse area, for densities of conserved quantities. The integrals
  /// over the two meshes are equal up to rounding errors.
  CONSERVATIVE,
  /// The value with the largest area, for example for labels and materials. Of equal areas, the smallest value is selected.
  MAJORITY
};

/// \ingroup PkgSurfaceMeshCoarseningRef
/// transfers property maps of a mesh to its coarse mesh.
///
/// Types with means are numbers, colors (`CGAL::IO::Color`), points and vectors of a kernel, and `std::array` of numbers.
/// `bool` has no means. Integers and colors are rounded.
///
/// The positions of the two meshes may have changed since the coarsening, but not their elements. Values of
/// faces that belong to no cluster are ignored: their label is the number of vertices of the coarse mesh.
///
/// \tparam FaceGraph a model of `FaceListGraph`
/// \tparam CoarseFaceGraph a model of `FaceListGraph`
template <class FaceGraph, class CoarseFaceGraph>
class Property_resampler
{
  typedef internal::Index Index;
  template <class Map>
  using Value = typename boost::property_traits<Map>::value_type;

public:
  /// prepares the transfer. The meshes must exist as long as the object.
  ///
  /// \tparam FaceClusterMap a model of `ReadablePropertyMap` with the faces as keys and an integral value type
  /// \tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
  /// \tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
  /// \param mesh the input of `coarsen_mesh()`
  /// \param clusters the `face_cluster_map` written by `coarsen_mesh()`
  /// \param coarse the output of `coarsen_mesh()`
  /// \param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters": \smcParam{vertex_point_map} and
  /// \smcParam{geom_traits} of `mesh`
  /// \param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters": \smcParam{vertex_point_map} and
  /// \smcParam{geom_traits} of `coarse`
  /// \throws Invalid_input if a mesh has no faces or is not a 2-manifold, if a face of `coarse` is not a triangle, if a
  /// cluster is larger than the number of vertices of `coarse`, or if a coordinate is not finite.
  template <class FaceClusterMap, class NamedParameters1 = parameters::Default_named_parameters,
            class NamedParameters2 = parameters::Default_named_parameters>
  Property_resampler(const FaceGraph& mesh, const FaceClusterMap& clusters, const CoarseFaceGraph& coarse,
                    const NamedParameters1& np1 = parameters::default_values(),
                    const NamedParameters2& np2 = parameters::default_values())
    : mesh_(mesh), coarse_(coarse), numbering_(internal::numbering(mesh, np1)),
      coarse_numbering_(internal::numbering(coarse, np2)),
      surfaces_(internal::clustered_arrays(mesh, np1, numbering_, clusters, coarse_numbering_), coarse, coarse_numbering_, np2)
  {}

  /// \cond SKIP_IN_MANUAL
  Property_resampler(const Property_resampler&) = delete; // its members refer to each other
  Property_resampler& operator=(const Property_resampler&) = delete;
  /// \endcond

  /// writes the source of each vertex of the coarse mesh, which is the nearest point of the mesh.
  /// \tparam VertexSourceMap a model of `WritablePropertyMap` with the vertices of the coarse mesh as keys and
  /// `Surface_location<FaceGraph>` as value
  template <class VertexSourceMap>
  void write_sources(VertexSourceMap sources)
  {
    for (std::size_t x = 0; x < surfaces_.positions().size(); ++x)
      put(sources, coarse_numbering_.vertices[x], location(surfaces_.sources()[x]));
  }

  /// \name Transfer
  /// The value types of `from` and `to` must be equal. With `CONSERVATIVE`, values without means are rejected:
  /// `Invalid_input` is thrown before anything is written.
  /// @{

  /// transfers values of vertices to vertices. A vertex of the mesh represents its share of the area of the incident faces, and a
  /// vertex of the coarse mesh represents a third of the area of the incident triangles.
  template <class From, class To>
  void transfer_vertex_property(From from, To to, Transfer_policy policy = Transfer_policy::INTERPOLATED)
  {
    typedef Value<From> Type;
    const auto read = [&](auto h) { return Type(get(from, source(h, mesh_))); };
    transfer_to_vertices<Type>(policy, to, [&](Index f, const auto& add) {
      const internal::Flat_mesh& m = surfaces_.mesh;
      for (const Index c : m.corners(f))
        add(surfaces_.area[f] / m.degree(f), Type(get(from, numbering_.vertices[m.corner_vertex[c]])));
    }, [&](const internal::Nearest_point& p) {
      const Surface_location<FaceGraph> l = location(p);
      return policy == Transfer_policy::INTERPOLATED ? value_in_face<Type>(l, read)
                                                     : read(internal::halfedge_from_nearest_corner(l, mesh_));
    });
  }

  /// transfers values of faces to vertices: each vertex receives a value from the faces of its cluster.
  template <class From, class To>
  void transfer_face_property_to_vertices(From from, To to, Transfer_policy policy = Transfer_policy::INTERPOLATED)
  {
    typedef Value<From> Type;
    const auto value = [&](Index f) { return Type(get(from, numbering_.faces[f])); };
    transfer_to_vertices<Type>(policy, to, [&](Index f, const auto& add) { add(surfaces_.area[f], value(f)); },
                               [&](const internal::Nearest_point& p) { return value(p.face); });
  }

  /// transfers values of faces to faces. An interpolated value is the value of the face that is nearest to the center of the
  /// coarse face, among the faces of its three clusters. A majority value results from the faces nearest to the coarse face. A
  /// conservative value is the mean of the densities of its three clusters.
  template <class From, class To>
  void transfer_face_property(From from, To to, Transfer_policy policy = Transfer_policy::INTERPOLATED)
  {
    typedef Value<From> Type;
    const auto value = [&](Index f) { return Type(get(from, numbering_.faces[f])); };
    const std::vector<internal::Triangle>& triangles = surfaces_.triangles();
    if (policy == Transfer_policy::CONSERVATIVE) {
      const auto visit = [&](Index f, const auto& add) { add(surfaces_.area[f], value(f)); };
      with_cluster_densities<Type>(visit, [&](const auto& densities) {
        for (std::size_t t = 0; t < triangles.size(); ++t) {
          auto mean = internal::Weighted_sum<Type>();
          for (const Index x : triangles[t])
            mean.add(1. / 3, densities[x]);
          put(to, coarse_numbering_.faces[t], mean.value());
        }
      });
      return;
    }
    std::vector<internal::Majority<Type> > votes(triangles.size());
    if (policy == Transfer_policy::MAJORITY)
      for (std::size_t f = 0; f < numbering_.faces.size(); ++f)
        if (surfaces_.triangles_of_faces()[f] != internal::NONE)
          votes[surfaces_.triangles_of_faces()[f]].add(surfaces_.area[f], value(Index(f)));
    for (std::size_t t = 0; t < triangles.size(); ++t)
      put(to, coarse_numbering_.faces[t], votes[t].empty() ? value(surfaces_.triangle_sources()[t].face) : votes[t].value());
  }

  /// transfers values of edges to edges: the source is the edge nearest to the midpoint of the coarse edge, in the face nearest
  /// to this midpoint among the faces of its two clusters.
  template <class From, class To>
  void transfer_edge_property(From from, To to)
  {
    for (const auto e : edges(coarse_)) {
      const auto h = halfedge(e, coarse_);
      const std::array<Index, 2> ends{
        {coarse_numbering_.number_of(source(h, coarse_)), coarse_numbering_.number_of(target(h, coarse_))}};
      put(to, e, get(from, edge_nearest_to(surfaces_.center(ends), surfaces_.triangle_source(ends).face)));
    }
  }

  /// transfers values of corners to corners, such as texture coordinates. The value of a halfedge is the value of its target in
  /// its face; border halfedges have no values.
  ///
  /// Values are interpolated within a single face of the mesh, and hence never across a seam. Around each vertex of the coarse
  /// mesh, the coarse faces on one side of a seam get the same value. If the vertex does not lie on a seam between two of its
  /// faces, each face gets the value of the nearest point on its own side.
  ///
  /// \tparam EdgeIsConstrainedMap a model of `ReadablePropertyMap` with the edges of the mesh as keys and `bool` as value
  /// \param from the values
  /// \param to receives the values
  /// \param is_seam whether an edge is a seam
  template <class From, class To, class EdgeIsConstrainedMap>
  void transfer_corner_property(From from, To to, const EdgeIsConstrainedMap& is_seam)
  {
    transfer_corners(from, to, [&](auto h) { return bool(get(is_seam, edge(h, mesh_))); });
  }

  /// transfers values of corners to corners, as the previous function. An edge is a seam if its two faces have different values
  /// at one of its ends.
  template <class From, class To>
  void transfer_corner_property(From from, To to)
  {
    transfer_corners(from, to, [&](auto h) {
      const auto o = opposite(h, mesh_);
      const auto value = [&](auto x) { return Value<From>(get(from, x)); };
      return !(value(h) == value(prev(o, mesh_))) || !(value(o) == value(prev(h, mesh_)));
    });
  }
  /// @}

private:
  Surface_location<FaceGraph> location(const internal::Nearest_point& p) const
  {
    return internal::surface_location(mesh_, numbering_, surfaces_.mesh, p);
  }

  // `value(h)` returns the value at the source of halfedge `h` of the face.
  template <class Type, class Read>
  Type value_in_face(const Surface_location<FaceGraph>& l, const Read& value) const
  {
    if constexpr (internal::has_means<Type>) {
      internal::Weighted_sum<Type> sum;
      auto h = halfedge(l.face, mesh_);
      for (const double x : l.coordinates) {
        if (x != 0)
          sum.add(x, value(h));
        h = next(h, mesh_);
      }
      return sum.value();
    } else {
      return value(internal::halfedge_from_nearest_corner(l, mesh_));
    }
  }

  // Calls `use(densities)` with the densities of the clusters. `visit(f, add)` calls `add(area, value)` for each contribution of
  // face `f`.
  template <class Type, class Visit, class Use>
  void with_cluster_densities(const Visit& visit, const Use& use) const
  {
    if constexpr (internal::has_means<Type>) {
      std::vector<internal::Weighted_sum<Type> > densities(surfaces_.positions().size());
      Index last = internal::NONE, taker = internal::NONE;
      for (std::size_t f = 0; f < numbering_.faces.size(); ++f) {
        const Index x = surfaces_.cluster[f];
        if (x == internal::NONE)
          continue;
        if (x != last)
          taker = surfaces_.vertex_with_area(last = x);
        const double area = surfaces_.dual_area(taker);
        visit(Index(f), [&](double weight, const Type& value) {
          if (area > 0)
            densities[taker].add(weight / area, value);
        });
      }
      use(densities);
    } else {
      throw Invalid_input("values that have no means cannot be transferred conservatively");
    }
  }

  // `value_at(p)` returns the value at the nearest point `p` to a vertex. A majority without votes is this value, too.
  template <class Type, class To, class Visit, class Nearest>
  void transfer_to_vertices(Transfer_policy policy, To to, const Visit& visit, const Nearest& value_at)
  {
    if (policy == Transfer_policy::CONSERVATIVE) {
      with_cluster_densities<Type>(visit, [&](const auto& densities) {
        for (std::size_t x = 0; x < densities.size(); ++x)
          put(to, coarse_numbering_.vertices[x], densities[x].value());
      });
      return;
    }
    for (std::size_t x = 0; x < surfaces_.positions().size(); ++x) {
      internal::Majority<Type> votes;
      if (policy == Transfer_policy::MAJORITY)
        for (const Index f : surfaces_.faces(Index(x)))
          visit(f, [&](double weight, const Type& value) { votes.add(weight, value); });
      put(to, coarse_numbering_.vertices[x], votes.empty() ? value_at(surfaces_.sources()[x]) : votes.value());
    }
  }

  auto edge_nearest_to(const internal::Vector& p, Index face) const
  {
    using namespace internal;
    const auto point = [&](auto v) -> const internal::Vector& { return surfaces_.mesh.points[numbering_.number_of(v)]; };
    auto nearest = halfedge(numbering_.faces[face], mesh_);
    double least = -1;
    for (const auto h : halfedges_around_face(nearest, mesh_)) {
      const internal::Vector &a = point(source(h, mesh_)), &b = point(target(h, mesh_));
      const double t = closest_on_segment(p, a, b);
      const internal::Vector d = p - ((1 - t) * a + t * b);
      if (least < 0 || dot(d, d) < least) {
        least = dot(d, d);
        nearest = h;
      }
    }
    return edge(nearest, mesh_);
  }

  template <class From, class To, class IsSeam>
  void transfer_corners(From from, To to, const IsSeam& is_seam)
  {
    typedef Value<From> Type;
    const internal::Flat_mesh& m = surfaces_.mesh;
    std::vector<bool> seams(m.corner_vertex.size(), false);
    for (std::size_t f = 0; f < numbering_.faces.size(); ++f)
      for (const auto h : halfedges_around_face(halfedge(numbering_.faces[f], mesh_), mesh_))
        if (!is_border(opposite(h, mesh_), mesh_))
          seams[m.corner_of(Index(f), numbering_.number_of(source(h, mesh_)))] = is_seam(h);
    internal::Chart_sectors sectors(surfaces_, seams);
    for (std::size_t x = 0; x < surfaces_.positions().size(); ++x)
      sectors.for_each_corner_at(Index(x), [&](Index t, const internal::Nearest_point& p) {
        auto h = halfedge(coarse_numbering_.faces[t], coarse_);
        while (coarse_numbering_.number_of(target(h, coarse_)) != x)
          h = next(h, coarse_);
        put(to, h, value_in_face<Type>(location(p), [&](auto corner) { return Type(get(from, prev(corner, mesh_))); }));
      });
  }

  const FaceGraph& mesh_;
  const CoarseFaceGraph& coarse_;
  internal::Numbering<FaceGraph> numbering_;
  internal::Numbering<CoarseFaceGraph> coarse_numbering_;
  internal::Surface_correspondence surfaces_;
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_PROPERTY_RESAMPLER_H
