// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CLUSTERING_INPUT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CLUSTERING_INPUT_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Quad_subdivision.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/face_geometry.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

class Feature_cells;

constexpr double largest_density = 1e20; // its inverse is the smallest

// What the clustering works on: the mesh in arrays, and of each face its area A and density r. Centroids g are computed when
// they are needed, which takes less time than the memory would. Faces may be pieces of faces of the caller's mesh, then
// `parent` tells of which.
struct Clustering_input
{
  Flat_mesh mesh;
  std::vector<double> area;
  std::vector<double> density;
  std::vector<Index> parent; // empty if the faces are those of the caller's mesh
  // Where there are features: what the faces are made of, the centroids of that, and of how many faces it is, parts included.
  std::shared_ptr<const Feature_cells> cells;
  std::vector<Vector> joined_centroid;
  std::vector<double> joined_faces;

  double mass(Index f) const { return density[f] * area[f]; }
  Vector centroid(Index f) const
  {
    if (!joined_centroid.empty())
      return joined_centroid[f];
    return mesh.degree(f) == 3 ? mean_of_corners(mesh, f) : face_geometry(mesh, f).centroid;
  }
  double number_of_faces_in(Index f) const { return joined_faces.empty() ? 1 : joined_faces[f]; }
  Index parent_of(Index f) const { return parent.empty() ? f : parent[f]; }

  // Computes the areas.
  void measure(const Cancellation_point& cancellation = Cancellation_point(), Execution execution = Execution::SEQUENTIAL)
  {
    area.resize(mesh.number_of_faces());
    for_each_number(execution, area.size(), cancellation, [this](Index f) { area[f] = face_area(mesh, f); });
  }

  // Cuts the faces of the chosen components into one piece per corner.
  void subdivide(const std::vector<bool>& chosen_component, const Cancellation_point& cancellation = Cancellation_point())
  {
    std::vector<char> is_cut(mesh.number_of_faces());
    for (std::size_t f = 0; f < is_cut.size(); ++f)
      is_cut[f] = chosen_component[mesh.component[f]];
    Quad_subdivision cutting(mesh, is_cut);
    mesh = cutting.run(cancellation);
    take_from(cutting.old_face(), cancellation);
  }

  // Takes densities and parents over from an input of which the faces are pieces.
  void inherit(const Clustering_input& whole, const std::vector<Index>& whole_face)
  {
    density = whole.density;
    parent = whole.parent;
    take_from(whole_face, Cancellation_point());
  }

  // Leaves out the components whose area is smaller. Returns their number.
  std::size_t drop_components_below(double min_area, const Cancellation_point& cancellation = Cancellation_point())
  {
    std::vector<double> areas(mesh.components.size(), 0);
    for (std::size_t f = 0; f < area.size(); ++f)
      areas[mesh.component[f]] += area[f];
    const auto dropped = std::size_t(std::count_if(areas.begin(), areas.end(), [&](double a) { return a < min_area; }));
    if (dropped == 0)
      return 0;
    std::vector<Index> new_number(mesh.number_of_faces(), NONE), kept;
    for (std::size_t f = 0; f < new_number.size(); ++f)
      if (!(areas[mesh.component[f]] < min_area)) {
        new_number[f] = Index(kept.size());
        kept.push_back(Index(f));
      }
    Flat_mesh smaller;
    smaller.first_corner.assign(1, 0);
    for (const Index f : kept) {
      cancellation.poll();
      for (Index c = mesh.first_corner[f]; c != mesh.first_corner[f + 1]; ++c) {
        const Index g = mesh.face_across[c];
        smaller.corner_vertex.push_back(mesh.corner_vertex[c]);
        smaller.face_across.push_back(g == NONE ? NONE : new_number[g]);
      }
      smaller.first_corner.push_back(Index(smaller.corner_vertex.size()));
    }
    smaller.points.swap(mesh.points);
    Flat_mesh_topology::complete(smaller, smaller.points.size(), cancellation);
    mesh = std::move(smaller);
    take_from(kept, cancellation);
    return dropped;
  }

private:
  // Makes the faces pieces of those in the list, or these themselves.
  void take_from(const std::vector<Index>& old_faces, const Cancellation_point& cancellation)
  {
    std::vector<double> densities;
    std::vector<Index> parents;
    densities.reserve(old_faces.size());
    parents.reserve(old_faces.size());
    for (const Index f : old_faces) {
      densities.push_back(density[f]);
      parents.push_back(parent_of(f));
    }
    density.swap(densities);
    parent.swap(parents);
    measure(cancellation);
  }
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CLUSTERING_INPUT_H
