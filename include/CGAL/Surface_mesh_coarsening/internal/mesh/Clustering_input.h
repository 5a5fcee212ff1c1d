// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CLUSTERING_INPUT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CLUSTERING_INPUT_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/face_geometry.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

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

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CLUSTERING_INPUT_H
