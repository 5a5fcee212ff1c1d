// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PATCH_CLUSTERS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PATCH_CLUSTERS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/sort_unique.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Patch.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Featured_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/cut_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_model.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The clusters of a patch whose own faces are all faces of some clusters. A face moves only if all faces around its vertices
// belong to these clusters. Such moves neither affect the moves in other patches nor depend on them, so the patches can be
// processed at the same time and in any order.
class Patch_clusters
{
public:
  explicit Patch_clusters(Patch& patch) : patch_(patch), input_{input_of(patch), nullptr}, labels_(input_.items.mesh)
  {
    global_ = clusters_of(true);
    own_ = global_.size();
    const std::vector<Index> foreign = clusters_of(false);
    global_.insert(global_.end(), foreign.begin(), foreign.end());
    Index last = NONE, number = NONE;
    for (std::size_t f = 0; f < patch.faces.size(); ++f) {
      if (patch.faces.cluster[f] != last) {
        last = patch.faces.cluster[f];
        number = local_number(last);
      }
      labels_.set(Index(f), number);
    }
    labels_.recount();
  }

  const Clustering_input& input() const { return input_.items; }
  const Cluster_labels& labels() const { return labels_; }
  std::size_t size() const { return global_.size(); }
  // The clusters of the own faces come first.
  std::size_t number_of_own() const { return own_; }
  Index global_number(Index x) const { return global_[x]; }

  // Runs at most `end.max_rounds` rounds of the minimization. Returns the number of rounds.
  std::size_t minimize(const Energy_model& energy, const Minimization_end& end, const Cancellation_point& cancellation,
                       Execution execution)
  {
    for (Index f = 0; f < input().mesh.number_of_faces(); ++f)
      if (!may_move(f))
        labels_.pin(f);
    const std::unique_ptr<Minimization> minimization =
      energy.minimization(input_, labels_, size(), false, cancellation, execution);
    std::size_t rounds = 0;
    bool has_ended = false;
    double before = minimization->energy();
    while (rounds < end.max_rounds && !has_ended) {
      const std::size_t some = (std::min)(end.max_rounds - rounds, minimization->rounds_at_a_time());
      const Minimization::Progress progress = minimization->run({some, end.tolerance});
      const double after = minimization->energy();
      has_ended = progress.moves == 0 || before - after <= end.tolerance * before;
      before = after;
      rounds += progress.rounds;
    }
    for (std::size_t f = 0; f < patch_.faces.size(); ++f)
      patch_.faces.cluster[f] = global_[labels_[Index(f)]];
    return rounds;
  }

private:
  // Moves the mesh out of the patch.
  static Clustering_input input_of(Patch& patch)
  {
    Clustering_input input;
    input.mesh = std::move(patch.mesh);
    input.density = patch.faces.density;
    compute_areas_and_centroids(input);
    return input;
  }

  // Returns the clusters of the own or the foreign faces, in order. Most faces have the same cluster as the previous face.
  std::vector<Index> clusters_of(bool own) const
  {
    std::vector<Index> clusters;
    for (std::size_t f = 0; f < patch_.faces.size(); ++f)
      if (patch_.is_own(f) == own && (clusters.empty() || clusters.back() != patch_.faces.cluster[f]))
        clusters.push_back(patch_.faces.cluster[f]);
    sort_unique(clusters);
    return clusters;
  }

  Index local_number(Index cluster) const
  {
    const auto middle = global_.begin() + std::ptrdiff_t(own_);
    const auto i = std::lower_bound(global_.begin(), middle, cluster);
    return Index((i != middle && *i == cluster ? i : std::lower_bound(middle, global_.end(), cluster)) - global_.begin());
  }

  bool may_move(Index f) const
  {
    const Flat_mesh& m = input().mesh;
    for (Index c = m.first_corner[f]; c != m.first_corner[f + 1]; ++c)
      if (!patch_.is_inner[m.corner_vertex[c]])
        return false;
    return true;
  }

  Patch& patch_;
  Featured_input input_; // without features
  Cluster_labels labels_;
  std::vector<Index> global_; // number of each cluster
  std::size_t own_ = 0;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PATCH_CLUSTERS_H
