// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFINEMENT_CLUSTER_RELOCATION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFINEMENT_CLUSTER_RELOCATION_H

#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_cells.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/refinement/Cluster_editing.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Relocates clusters of a valid clustering. The clustering remains valid and keeps the number of clusters. A cluster may move to
// another component, unless the component would have more clusters than vertices. All relocations can be undone.
class Cluster_relocation
{
public:
  Cluster_relocation(const Featured_input& input, Cluster_labels& labels, Index clusters)
    : mesh_(input.items.mesh), cells_(input.cells.get()), labels_(labels), old_labels_(labels.labels()),
      editing_(input, labels, clusters), bounds_(clusters),
      clusters_of_component_(input.items.mesh.components.size(), 0)
  {
    for (Index x = 0; x < clusters; ++x)
      ++clusters_of_component_[component_of(x)];
  }

  // The number of relocated clusters.
  std::size_t number() const { return number_; }
  bool is_undone() const { return is_undone_; }

  // Returns the admissible position of the vertex of a cluster that is nearest to `p`. `surface` has the clusters before relocations.
  // Many threads may call this function, so the faces are visited earlier.
  Vector within_bounds(const Clustered_faces& surface, Index x, const Vector& p) const
  {
    return bounds_[x] ? closest_in_box(p, *bounds_[x]) : surface.within_bounds(x, p);
  }

  // Merges cluster `x` into a neighbor, if possible into `into`, and forms a new cluster `x` around one of some faces of the
  // input, or around a piece of a face if features are kept. The positions of the vertices must remain within their bounds.
  Relocation relocate(Index x, Index into, std::vector<Index> faces, const std::vector<Vector>& positions)
  {
    if (cells_)
      for (Index& f : faces)
        f = cells_->polygon(f);
    const Index from = component_of(x);
    faces.erase(std::remove_if(faces.begin(), faces.end(), [&](Index f) { return !has_room_for_cluster(f, from); }),
                faces.end());
    std::vector<Index> changed;
    const Relocation outcome = editing_.relocate(x, into, faces, positions, changed);
    for (const Index y : changed)
      bounds_[y] = internal::vertex_bounds(mesh_, editing_.faces(y));
    if (outcome == Relocation::DONE) {
      ++number_;
      --clusters_of_component_[from];
      ++clusters_of_component_[component_of(x)];
    }
    return outcome;
  }

  // Restores the labels; afterwards, nothing can be relocated.
  void undo()
  {
    bounds_.assign(bounds_.size(), std::nullopt);
    labels_.move_all(old_labels_);
    number_ = 0;
    is_undone_ = true;
  }

private:
  Index component_of(Index x) const { return mesh_.component[editing_.face(x)]; }

  bool has_room_for_cluster(Index face, Index from) const
  {
    const Index c = mesh_.component[face];
    return c == from || clusters_of_component_[c] < mesh_.components[c].max_clusters();
  }

  const Flat_mesh& mesh_;
  const Feature_cells* cells_; // null without features
  Cluster_labels& labels_;
  const std::vector<Index> old_labels_;
  Cluster_editing editing_;
  std::vector<std::optional<Bbox_3> > bounds_; // of the vertices of changed clusters
  std::size_t number_ = 0;
  bool is_undone_ = false;
  std::vector<std::size_t> clusters_of_component_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFINEMENT_CLUSTER_RELOCATION_H
