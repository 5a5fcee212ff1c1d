// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURED_INPUT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURED_INPUT_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>

#include <memory>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

class Feature_cells;

// The input of the clustering and, if features are kept, the cells that were built from its faces.
struct Featured_input
{
  Clustering_input items;
  std::shared_ptr<const Feature_cells> cells; // null without features
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURED_INPUT_H
