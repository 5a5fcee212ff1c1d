// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_LABEL_CLUSTERS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_LABEL_CLUSTERS_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Numbering.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/sort_unique.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Reads arbitrary labels as clusters numbered from 0 in the order of their labels. Returns the label of each cluster.
template <class FaceGraph, class FaceClusterMap>
auto label_clusters(const Numbering<FaceGraph>& n, const FaceClusterMap& map, Cluster_labels& labels)
{
  typedef typename boost::property_traits<FaceClusterMap>::value_type Label;
  std::vector<Label> of_face, names;
  of_face.reserve(n.faces.size());
  for (const auto f : n.faces)
    of_face.push_back(get(map, f));
  names = of_face;
  sort_unique(names);
  for (std::size_t i = 0; i < of_face.size(); ++i)
    labels.set(Index(i), Index(std::lower_bound(names.begin(), names.end(), of_face[i]) - names.begin()));
  return names;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_LABEL_CLUSTERS_H
