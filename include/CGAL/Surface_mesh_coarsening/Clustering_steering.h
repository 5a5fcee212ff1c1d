// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTERING_STEERING_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTERING_STEERING_H

#include <CGAL/Surface_mesh_coarsening/internal/refinement/Cluster_editing.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/Clustering_access.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace CGAL {
namespace Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// The part of `Mwcvd_clustering` by which an application steers the clusters by hand, between rounds of the minimization.
///
/// After each of these functions the clustering is as valid as before. All throw `std::logic_error` if there are no clusters
/// yet, and `Invalid_input` if there is no cluster of the number given.
///
/// \tparam Clustering the class that derives from this one
template <class Clustering>
class Clustering_steering
{
  typedef internal::Index Index;
  typedef internal::Clustering_access Access;

public:
  /// freezes a cluster: no face joins or leaves it, until it is thawed or all clusters are made anew.
  void freeze_cluster(std::size_t cluster, bool is_frozen = true)
  {
    Access::mutable_labels(checked(cluster)).freeze(Index(cluster), is_frozen);
  }

  /// thaws a cluster.
  void thaw_cluster(std::size_t cluster) { freeze_cluster(cluster, false); }

  /// returns whether a cluster is frozen.
  bool is_frozen(std::size_t cluster) const
  {
    check(cluster);
    return Access::labels(clustering()).is_frozen(Index(cluster));
  }

  /// splits a cluster in two of about the same extent. The new one gets the next number.
  /// \throws Invalid_input if features are kept.
  /// \return the number of the new cluster; nothing if the cluster is frozen, or if no way was found to make two of it, as
  /// where it has only one face
  std::optional<std::size_t> split_cluster(std::size_t cluster)
  {
    if (!edit(cluster, &internal::Cluster_editing::split))
      return std::nullopt;
    return clustering().number_of_clusters() - 1;
  }

  /// removes a cluster: its faces join a neighbor, the one for which the sum of the moments about the centers grows least of
  /// those that are not frozen and allow it. The last cluster gets the number of the one that is gone.
  /// \throws Invalid_input if features are kept.
  /// \return whether it was possible. It is not if the cluster is frozen, or if the topology of the mesh needs it.
  bool remove_cluster(std::size_t cluster)
  {
    return edit(cluster, &internal::Cluster_editing::remove);
  }

/// \cond SKIP_IN_MANUAL
protected:
  // Has to be called when clusters change in other ways.
  void forget_editing() { editing_.reset(); }
  /// \endcond

private:
  const Clustering& clustering() const { return static_cast<const Clustering&>(*this); }

  void check(std::size_t cluster) const
  {
    Access::labels(clustering());
    if (cluster >= clustering().number_of_clusters())
      throw Invalid_input("there is no cluster " + std::to_string(cluster) + " of " +
                          std::to_string(clustering().number_of_clusters()));
  }
  Clustering& checked(std::size_t cluster)
  {
    check(cluster);
    return static_cast<Clustering&>(*this);
  }

  // Returns whether it was possible. Of what is refused before the first change, the clusters know nothing.
  bool edit(std::size_t cluster, bool (internal::Cluster_editing::*change)(Index))
  {
    Clustering& c = checked(cluster);
    if (is_frozen(cluster))
      return false;
    if (!editing_)
      editing_ = std::make_unique<internal::Cluster_editing>(Access::input_without_features(c), Access::mutable_labels(c),
                                                             Index(c.number_of_clusters()));
    bool is_possible = false;
    Access::all_or_nothing(c, [&] { is_possible = (*editing_.*change)(Index(cluster)); });
    if (is_possible)
      Access::have_changed(c, editing_->number_of_clusters());
    return is_possible;
  }

  std::unique_ptr<internal::Cluster_editing> editing_;
};

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTERING_STEERING_H
