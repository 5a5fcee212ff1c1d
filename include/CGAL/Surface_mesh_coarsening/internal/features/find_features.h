// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FIND_FEATURES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FIND_FEATURES_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Visitor_handle.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Featured_input.h>

#include <memory>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

struct Feature_edges;

// The features that the caller requests, except the borders of patches.
struct Feature_request
{
  struct Edge
  {
    Index face, corner; // the edge from the corner to the next corner
  };
  double angle = 180; // in degrees
  std::vector<Edge> edges;
  std::vector<Index> corners;
};

// Finds the features of the faces; returns null if there are none. `patches` is empty or holds the patch of each face of the
// caller's mesh.
std::shared_ptr<const Feature_edges> find_features(const Clustering_input& input, const Feature_request& request,
                                                   const std::vector<long long>& patches);

std::vector<Index> corners_of(const Feature_edges& edges);

// Replaces the items by cells that keep the features.
void make_cells(Featured_input& input, const Feature_edges& edges, const Cancellation_point& cancellation);

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#ifndef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#include <CGAL/Surface_mesh_coarsening/internal/features/find_features_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FIND_FEATURES_H
