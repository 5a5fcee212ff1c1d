// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CLUSTERING_INPUT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CLUSTERING_INPUT_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/face_geometry.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

constexpr double largest_density = 1e20; // its inverse is the smallest

// What is clustered: items with additive sums, as neighbors and corners have them in `mesh`. The items are faces, pieces of
// faces, or cells of several. Of each item: its area A, its mass r A, with the density r, its centroid g.
struct Clustering_input
{
  Flat_mesh mesh;
  std::vector<double> area;
  std::vector<double> density;
  std::vector<Vector> item_centroid; // empty where the items are polygons: to compute centroids takes less time than memory
  std::vector<double> item_faces;    // of how many faces an item consists, parts included; empty where that is 1
  std::vector<Index> parent;         // a face of the caller's mesh; empty where the items are these faces

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
