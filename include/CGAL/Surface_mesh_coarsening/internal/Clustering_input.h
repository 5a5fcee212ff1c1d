// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERING_INPUT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERING_INPUT_H

#include <CGAL/Surface_mesh_coarsening/internal/face_geometry.h>
#include <CGAL/Surface_mesh_coarsening/internal/subdivide_flat_mesh.h>

#include <numeric>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// What the clustering works on: the mesh in arrays, and of each face its area A, centroid g and density r. Faces may
// be pieces of faces of the caller's mesh, then `parent` tells of which.
struct Clustering_input
{
  Flat_mesh mesh;
  std::vector<double> area;
  std::vector<Vector> centroid;
  std::vector<double> density;
  std::vector<Index> parent;

  double mass(Index f) const { return density[f] * area[f]; }

  void complete()
  {
    parent.resize(mesh.number_of_faces());
    std::iota(parent.begin(), parent.end(), Index(0));
    measure();
  }

  // Cuts the faces of the chosen components into one piece per corner.
  void subdivide(const std::vector<bool>& chosen_component)
  {
    std::vector<Index> cut_from(mesh.number_of_faces());
    std::iota(cut_from.begin(), cut_from.end(), Index(0));
    mesh = Flat_mesh_subdivision::run(mesh, chosen_component, cut_from);
    std::vector<double> densities;
    std::vector<Index> parents;
    for (const Index f : cut_from) {
      densities.push_back(density[f]);
      parents.push_back(parent[f]);
    }
    density.swap(densities);
    parent.swap(parents);
    measure();
  }

private:
  void measure()
  {
    area.resize(mesh.number_of_faces());
    centroid.resize(mesh.number_of_faces());
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
      const Face_geometry g = face_geometry(mesh, Index(f));
      area[f] = g.area;
      centroid[f] = g.centroid;
    }
  }
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERING_INPUT_H
