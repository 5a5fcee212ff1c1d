// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FIND_FEATURES_IMPL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FIND_FEATURES_IMPL_H

#include <CGAL/Surface_mesh_coarsening/internal/base/inline.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_cells.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/find_features.h>

#include <utility>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

CGAL_SURFACE_MESH_COARSENING_INLINE std::shared_ptr<const Feature_edges>
find_features(const Clustering_input& input, const Feature_request& request, const std::vector<long long>& patches)
{
  Feature_detection detection(input.mesh);
  if (request.angle < 180) {
    detection.add_sharp_edges(request.angle);
    detection.add_tips(request.angle);
  }
  if (!patches.empty())
    detection.add_patch_borders([&](Index f) { return patches[f]; });
  for (const Feature_request::Edge& e : request.edges)
    detection.add_edge(e.face, e.corner);
  for (const Index v : request.corners)
    detection.add_corner(v);
  auto edges = std::make_shared<const Feature_edges>(detection.result());
  return edges->empty() ? nullptr : edges;
}

CGAL_SURFACE_MESH_COARSENING_INLINE std::vector<Index> corners_of(const Feature_edges& edges)
{
  std::vector<Index> corners;
  for (std::size_t v = 0; v < edges.is_corner.size(); ++v)
    if (edges.is_corner[v])
      corners.push_back(Index(v));
  return corners;
}

CGAL_SURFACE_MESH_COARSENING_INLINE void make_cells(Featured_input& input, const Feature_edges& edges, const Run_context& context)
{
  input = Feature_cells::run(Clustering_input(std::move(input.items)), edges, context);
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FIND_FEATURES_IMPL_H
