// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CUT_INPUT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CUT_INPUT_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Visitor_handle.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh_builder.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Quad_subdivision.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Computes the centroids of the faces if one face has a large part of all corners. In other meshes, computing them takes less
// time than reading.
inline void store_centroids_if_slow(Clustering_input& input, const Cancellation_point& cancellation, Execution execution)
{
  constexpr std::size_t many_corners = 64, part = 64;
  const Flat_mesh& m = input.mesh;
  std::size_t most = 0;
  for (std::size_t f = 0; f < m.number_of_faces(); ++f)
    most = (std::max)(most, std::size_t(m.degree(Index(f))));
  if (most < many_corners || part * most < m.corner_vertex.size())
    return;
  std::vector<Vector> centroids(m.number_of_faces());
  for_each_number(execution, centroids.size(), cancellation, [&](Index f) { centroids[f] = input.centroid(f); });
  input.item_centroid.swap(centroids);
}

// Computes the areas of the faces, and their centroids where these are stored.
inline void compute_areas_and_centroids(Clustering_input& input,
                                        const Cancellation_point& cancellation = Cancellation_point(),
                                        Execution execution = Execution::SEQUENTIAL)
{
  input.area.resize(input.mesh.number_of_faces());
  for_each_number(execution, input.area.size(), cancellation, [&](Index f) { input.area[f] = face_area(input.mesh, f); });
  store_centroids_if_slow(input, cancellation, execution);
}

// Returns the input for pieces of the polygons of `whole`, or for some of these polygons. Densities and parents are
// inherited.
inline Clustering_input cut_input(const Clustering_input& whole, Flat_mesh pieces, const std::vector<Index>& whole_face,
                                  const Cancellation_point& cancellation = Cancellation_point())
{
  Clustering_input result;
  result.mesh = std::move(pieces);
  result.density.reserve(whole_face.size());
  result.parent.reserve(whole_face.size());
  for (const Index f : whole_face) {
    result.density.push_back(whole.density[f]);
    result.parent.push_back(whole.parent_of(f));
  }
  compute_areas_and_centroids(result, cancellation);
  return result;
}

// Returns the input with the faces of the chosen components subdivided into one piece per corner.
inline Clustering_input subdivided_input(const Clustering_input& input, const std::vector<bool>& chosen_component,
                                         const Cancellation_point& cancellation)
{
  std::vector<char> is_cut(input.mesh.number_of_faces());
  for (std::size_t f = 0; f < is_cut.size(); ++f)
    is_cut[f] = chosen_component[input.mesh.component[f]];
  Quad_subdivision cutting(input.mesh, is_cut);
  Flat_mesh pieces = cutting.run(cancellation);
  return cut_input(input, std::move(pieces), cutting.old_face(), cancellation);
}

// Removes components whose area is less than `min_area`. Returns their number.
inline std::size_t drop_components_below(Clustering_input& input, double min_area, const Cancellation_point& cancellation)
{
  const Flat_mesh& m = input.mesh;
  std::vector<double> areas(m.components.size(), 0);
  for (std::size_t f = 0; f < input.area.size(); ++f)
    areas[m.component[f]] += input.area[f];
  const auto dropped = std::size_t(std::count_if(areas.begin(), areas.end(), [&](double a) { return a < min_area; }));
  if (dropped == 0)
    return 0;
  std::vector<Index> new_number(m.number_of_faces(), NONE), kept;
  for (std::size_t f = 0; f < new_number.size(); ++f)
    if (!(areas[m.component[f]] < min_area)) {
      new_number[f] = Index(kept.size());
      kept.push_back(Index(f));
    }
  Flat_mesh_builder builder(m.points);
  for (const Index f : kept) {
    cancellation.poll();
    for (const Index c : m.corners(f)) {
      const Index g = m.face_across[c];
      builder.add_corner(m.corner_vertex[c], g == NONE ? NONE : new_number[g]);
    }
    builder.end_face();
  }
  input = cut_input(input, builder.finish(cancellation), kept, cancellation);
  return dropped;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CUT_INPUT_H
