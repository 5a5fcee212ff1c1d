// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFINEMENT_CLUSTER_RELOCATION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFINEMENT_CLUSTER_RELOCATION_H

#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_cells.h>
#include <CGAL/Surface_mesh_coarsening/internal/refinement/Cluster_editing.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Relocates clusters of a valid clustering, which remains valid and keeps the number of clusters; can undo all
// relocations.
class Cluster_relocation
{
public:
  Cluster_relocation(const Featured_input& input, Cluster_labels& labels, Index clusters)
    : cells_(input.cells.get()), labels_(labels), old_labels_(labels.labels()), editing_(input, labels, clusters),
      has_changed_(clusters, false) {}

  // The number of relocated clusters.
  std::size_t number() const { return number_; }
  bool has_changed(Index x) const { return has_changed_[x]; }
  // Returns the faces of a cluster, as faces of the input.
  std::vector<Index> faces(Index x) { return editing_.faces(x); }

  // Merges cluster `x` into a neighbor, if possible into `into`, and forms a new cluster `x` around a face of the
  // input, or around a piece of it if features are kept. Returns whether this was possible.
  bool relocate(Index x, Index into, Index face)
  {
    std::vector<Index> changed;
    if (!editing_.relocate(x, into, cells_ ? cells_->polygon(face) : face, changed))
      return false;
    for (const Index y : changed)
      has_changed_[y] = true;
    ++number_;
    return true;
  }

  void undo()
  {
    for (std::size_t f = 0; f < old_labels_.size(); ++f)
      if (labels_[Index(f)] != old_labels_[f])
        labels_.move(Index(f), old_labels_[f]);
    has_changed_.assign(has_changed_.size(), false);
    number_ = 0;
  }

private:
  const Feature_cells* cells_; // null without features
  Cluster_labels& labels_;
  const std::vector<Index> old_labels_;
  Cluster_editing editing_;
  std::vector<char> has_changed_;
  std::size_t number_ = 0;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFINEMENT_CLUSTER_RELOCATION_H
