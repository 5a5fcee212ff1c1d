// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_SURFACE_LOCATION_H
#define CGAL_SURFACE_MESH_COARSENING_SURFACE_LOCATION_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Nearest_point_search.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// A point on the surface of a mesh, given by a face and coordinates in the face.
///
/// In a triangle, the coordinates are barycentric. In a larger polygon, they are mean value coordinates in the plane of the
/// polygon. If mean value coordinates would be negative, or would yield another point because the polygon is not planar, the
/// coordinates are barycentric in one of the triangles of a fan, and 0 for the other corners. Coordinates are never negative, and
/// their sum is 1.
///
/// \tparam FaceGraph a model of `FaceGraph`
template <class FaceGraph>
struct Surface_location
{
  /// The face descriptor of the mesh.
  typedef typename boost::graph_traits<FaceGraph>::face_descriptor face_descriptor;

  /// the face.
  face_descriptor face = boost::graph_traits<FaceGraph>::null_face();
  /// the coordinates. The first one belongs to the source of `halfedge(face, mesh)`, and the others follow around the face, in
  /// the order of `CGAL::Polygon_mesh_processing::Face_location`.
  std::vector<double> coordinates;
};

/// \cond SKIP_IN_MANUAL
namespace internal {

// Returns coordinates of a point of a face, one per corner in the order of the corners. In a triangle they are
// barycentric. In a polygon they are mean value coordinates in its plane if these are not negative, as in every convex
// polygon. If they are negative, or if the polygon is not planar so that they would yield another point, the coordinates are
// barycentric in the triangle of the fan.
inline std::vector<double> coordinates_in_face(const Flat_mesh& m, const Nearest_point& nearest, const Vector& normal)
{
  const Index begin = m.first_corner[nearest.face], degree = m.degree(nearest.face);
  std::vector<double> fan(degree, 0);
  const Index corners[3] = {0, nearest.corner - begin, nearest.corner + 1 - begin};
  Vector p{{0, 0, 0}};
  for (int i = 0; i < 3; ++i) {
    fan[corners[i]] += nearest.barycentric[i];
    p = p + nearest.barycentric[i] * m.points[m.corner_vertex[begin + corners[i]]];
  }
  const double normal_length = length(normal);
  if (degree == 3 || !(normal_length > 0))
    return fan;
  // With r_i the distance of corner i and t_i the tangent of half the angle under which side i is seen, the weight of
  // corner i is (t_{i-1} + t_i) / r_i.
  std::vector<Vector> to_corner(degree);
  std::vector<double> r(degree), tangent(degree), weight(degree);
  double extent = 0;
  for (Index i = 0; i < degree; ++i) {
    to_corner[i] = m.points[m.corner_vertex[begin + i]] - p;
    r[i] = length(to_corner[i]);
    extent = (std::max)(extent, r[i]);
  }
  for (Index i = 0; i < degree; ++i) {
    const Index j = (i + 1) % degree;
    const double sine = dot(cross(to_corner[i], to_corner[j]), normal) / normal_length;
    const double cosine = dot(to_corner[i], to_corner[j]);
    // On a side or at a corner, the coordinates in the fan are the same.
    if (r[i] * r[j] + cosine <= 1e-12 * extent * extent)
      return fan;
    tangent[i] = sine / (r[i] * r[j] + cosine);
  }
  double sum = 0;
  for (Index i = 0; i < degree; ++i) {
    if (!(r[i] > 1e-12 * extent))
      return fan;
    weight[i] = (tangent[(i + degree - 1) % degree] + tangent[i]) / r[i];
    if (!(weight[i] >= 0))
      return fan;
    sum += weight[i];
  }
  Vector offset{{0, 0, 0}};
  for (Index i = 0; i < degree; ++i) {
    weight[i] /= sum;
    offset = offset + weight[i] * to_corner[i];
  }
  return dot(offset, offset) <= 1e-24 * extent * extent ? weight : fan;
}

// Returns the halfedge that begins at the nearest corner.
template <class FaceGraph>
auto halfedge_from_nearest_corner(const Surface_location<FaceGraph>& location, const FaceGraph& mesh)
{
  const auto largest = std::max_element(location.coordinates.begin(), location.coordinates.end());
  auto h = halfedge(location.face, mesh);
  for (auto i = location.coordinates.begin(); i != largest; ++i)
    h = next(h, mesh);
  return h;
}

template <class FaceGraph>
Surface_location<FaceGraph> surface_location(const FaceGraph& mesh, const Numbering<FaceGraph>& n, const Flat_mesh& m,
                                             const Nearest_point& nearest)
{
  Surface_location<FaceGraph> location;
  location.face = n.faces[nearest.face];
  location.coordinates = coordinates_in_face(m, nearest, vector_area(m, nearest.face));
  // The first corner of the face may be another one in the arrays.
  const Index first = n.number_of(source(halfedge(location.face, mesh), mesh));
  const Index shift = m.corner_of(nearest.face, first) - m.first_corner[nearest.face];
  std::rotate(location.coordinates.begin(), location.coordinates.begin() + shift, location.coordinates.end());
  return location;
}

// Returns the locations of positions with clusters of the faces of `input`.
template <class FaceGraph>
std::vector<Surface_location<FaceGraph> > surface_locations(const FaceGraph& mesh, const Numbering<FaceGraph>& n,
                                                            const Clustering_input& input,
                                                            const std::vector<Index>& cluster_of_face,
                                                            const std::vector<Vector>& positions,
                                                            const Run_context& context)
{
  const Flat_mesh& m = input.mesh;
  const Nearest_point_search search(m, cluster_of_face, positions.size());
  std::vector<Surface_location<FaceGraph> > locations;
  locations.reserve(positions.size());
  for (std::size_t x = 0; x < positions.size(); ++x) {
    context.poll(64);
    locations.push_back(surface_location(mesh, n, m, search(positions[x], Index(x))));
  }
  return locations;
}

} // namespace internal
/// \endcond

/// \ingroup PkgSurfaceMeshCoarseningRef
/// returns the corner with the largest coordinate of a surface location.
/// \relates Surface_location
template <class FaceGraph>
typename boost::graph_traits<FaceGraph>::vertex_descriptor nearest_corner(const Surface_location<FaceGraph>& location,
                                                                          const FaceGraph& mesh)
{
  return source(internal::halfedge_from_nearest_corner(location, mesh), mesh);
}

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_SURFACE_LOCATION_H
