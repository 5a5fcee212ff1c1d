// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CLUSTERING_INPUT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CLUSTERING_INPUT_H

#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

struct Face_geometry
{
  double area;
  Vector centroid;
};

// Returns half the sum of the cross products of a fan: its length is the area of a planar polygon, its direction the
// normal.
inline Vector vector_area(const Flat_mesh& m, Index f)
{
  const Index begin = m.first_corner[f], end = m.first_corner[f + 1];
  const Vector& p = m.point_at(begin);
  Vector sum{{0, 0, 0}};
  Vector side = m.point_at(begin + 1) - p;
  for (Index c = begin + 2; c != end; ++c) {
    const Vector next = m.point_at(c) - p;
    sum = sum + cross(side, next);
    side = next;
  }
  return 0.5 * sum;
}

inline Vector mean_of_corners(const Flat_mesh& m, Index f)
{
  const Number_range corners = m.corners(f);
  Vector sum{{0, 0, 0}};
  for (const Index c : corners)
    sum = sum + m.point_at(c);
  return (1. / double(corners.size())) * sum;
}

inline double face_area(const Flat_mesh& m, Index f) { return length(vector_area(m, f)); }

inline Bbox_3 face_box(const Flat_mesh& m, Index f)
{
  Bbox_3 box;
  for (const Index c : m.corners(f))
    box += box_of_point(m.point_at(c));
  return box;
}

// Returns the centroid of the triangles between the edges of a face and the mean of its corners, with positive areas.
// It lies in the convex hull of the corners for any shape of face.
inline Vector centroid_of_star(const Flat_mesh& m, Index f)
{
  const Vector center = mean_of_corners(m, f);
  Vector sum{{0, 0, 0}};
  double weight = 0;
  Vector a = m.point_at(m.first_corner[f + 1] - 1) - center;
  for (const Index c : m.corners(f)) {
    const Vector b = m.point_at(c) - center, n = cross(a, b);
    const double size = length(n);
    sum = sum + (size / 3) * (a + b);
    weight += size;
    a = b;
  }
  return weight > 0 ? closest_in_box(center + (1 / weight) * sum, face_box(m, f)) : center;
}

// Returns the area and the centroid of a planar simple polygon. For other faces, returns the length of the vector area, and a
// point in their bounding box.
inline Face_geometry face_geometry(const Flat_mesh& m, Index f)
{
  const Vector normal = vector_area(m, f);
  const double area = length(normal);
  const Index begin = m.first_corner[f], end = m.first_corner[f + 1];
  if (end - begin == 3)
    return {area, mean_of_corners(m, f)};
  if (!(area > 0))
    return {area, centroid_of_star(m, f)};
  // Fan triangles on the other side of the boundary have negative weights.
  const Vector& p = m.point_at(begin);
  Vector sum{{0, 0, 0}};
  double absolute_weight = 0;
  for (Index c = begin + 2; c != end; ++c) {
    const Vector a = m.point_at(c - 1) - p, b = m.point_at(c) - p;
    const double weight = dot(cross(a, b), normal) / (6 * area * area);
    sum = sum + weight * (a + b);
    absolute_weight += std::abs(weight);
  }
  const Vector centroid = p + sum;
  // Weights sum to a third. With negative weights, the sum is a centroid only if the polygon is simple and nearly
  // planar; it then lies in the bounding box. If weights nearly cancel, the sum consists of rounding errors.
  constexpr double convex = (1 + 1e-6) / 3, cancelling = 1e9;
  if (absolute_weight < convex || (absolute_weight < cancelling && squared_distance_from_box(centroid, face_box(m, f)) == 0))
    return {area, centroid};
  return {area, centroid_of_star(m, f)};
}

// Computes the deviation of section 5.2 before the mapping: for each face, the mean length of the difference between its normal
// and the normals of the faces around its vertices. A pair of faces counts once for each common vertex. Faces without a
// normal have no deviation. At a vertex of very high degree, each face is compared with a fixed number of evenly spread
// faces, which keeps the time linear.
inline std::vector<double> mean_normal_deviations(const Flat_mesh& m, const Run_context& context = Run_context())
{
  //! [valence]
  constexpr Index max_compared = 256;
  //! [valence]
  constexpr Vector none{{0, 0, 0}};
  std::vector<Vector> normals(m.number_of_faces(), none); // of unit length
  for_each_number(context, normals.size(), [&](Index f) {
    const Vector n = vector_area(m, f);
    if (const double size = length(n); size > 0)
      normals[f] = (1 / size) * n;
  });
  std::vector<double> deviations(m.number_of_faces(), 0);
  for_each_number(context, deviations.size(), [&](Index f) {
    if (normals[f] == none)
      return;
    double sum = 0;
    std::size_t pairs = 0;
    for (const Index c : m.corners(f)) {
      const Index v = m.corner_vertex[c], begin = m.first_in_star[v], valence = m.first_in_star[v + 1] - begin;
      const Index compared = (std::min)(valence, max_compared);
      pairs += compared;
      for (Index j = 0; j < compared; ++j) {
        const Index place = valence == compared ? j : Index(std::uint64_t(j) * valence / max_compared);
        const Vector& other = normals[m.star[begin + place]];
        sum += other == none ? 0 : length(normals[f] - other);
      }
    }
    deviations[f] = sum / double(pairs);
  });
  return deviations;
}

inline double largest_of(const std::vector<double>& deviations)
{
  return deviations.empty() ? 0 : *std::max_element(deviations.begin(), deviations.end());
}

// Maps [0, maximum] linearly to [1, maximum_density] (section 5.2). The mesh counts as flat if no deviation exceeds the
// rounding errors of the coordinates.
inline void map_to_densities(std::vector<double>& deviations, double maximum, double maximum_density)
{
  //! [flat]
  constexpr double flat = 1e-6;
  for (double& d : deviations)
    d = maximum > flat ? 1 + (maximum_density - 1) * (d / maximum) : 1;
  //! [flat]
}

//! [density]
constexpr double largest_density = 1e20; // its inverse is the smallest density
//! [density]

// The input of the clustering: items with additive sums. `mesh` holds their neighbors and corners. Items are faces,
// pieces of faces, or cells of several faces. An item has an area A, a density r, a mass r A, and a centroid g.
struct Clustering_input
{
  Flat_mesh mesh;
  std::vector<double> area;
  std::vector<double> density;
  std::vector<Vector> item_centroid; // empty if items are polygons whose centroids are faster to compute than to read
  std::vector<double> item_faces;    // faces per item, fractions included; empty if 1
  std::vector<Index> parent;         // face of the caller's mesh; empty if items are these faces

  double mass(Index f) const { return density[f] * area[f]; }
  Vector centroid(Index f) const
  {
    if (!item_centroid.empty())
      return item_centroid[f];
    return mesh.degree(f) == 3 ? mean_of_corners(mesh, f) : face_geometry(mesh, f).centroid;
  }
  double number_of_faces_in(Index f) const { return item_faces.empty() ? 1 : item_faces[f]; }
  Index parent_of(Index f) const { return parent.empty() ? f : parent[f]; }
};

// Computes the stars, components and loops of a mesh from its faces; throws if these do not form a 2-manifold.
void complete_topology(Flat_mesh& mesh, std::size_t number_of_vertices, const Run_context& context);

// The same without components, which are not known of a part of a mesh.
void complete_stars(Flat_mesh& mesh, std::size_t number_of_vertices, const Run_context& context);

// Computes the densities of section 5.2, raised near borders on request.
std::vector<double> compute_densities(const Flat_mesh& mesh, double maximum, bool at_borders, const Run_context& context);

// Computes the areas of the faces, and their centroids where these are stored.
void compute_areas_and_centroids(Clustering_input& input, const Run_context& context = Run_context());

// Returns the input for pieces of the polygons of `whole`. Densities and parents are inherited.
Clustering_input cut_input(const Clustering_input& whole, Flat_mesh pieces, const std::vector<Index>& whole_face,
                           const Run_context& context = Run_context());

class Feature_cells;

// The input of the clustering and, if features are kept, the cells that were built from its faces.
struct Featured_input
{
  Clustering_input items;
  std::shared_ptr<const Feature_cells> cells; // null without features
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#ifndef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CLUSTERING_INPUT_H
