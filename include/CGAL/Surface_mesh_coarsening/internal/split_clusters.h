// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_SPLIT_CLUSTERS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_SPLIT_CLUSTERS_H

#include <CGAL/Surface_mesh_coarsening/internal/Dual_walk.h>
#include <CGAL/Surface_mesh_coarsening/internal/grow_clusters.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Splits clusters, all of them closed discs, until their dual is a simplicial surface: until the neighbors of every
// cluster form a simple cycle. Each split makes two or more smaller discs of one, so this ends, at the latest with
// clusters of one face; what is wrong then lies in the mesh itself, and the component is reported.
class Cluster_splitting
{
public:
  Cluster_splitting(Cluster_labels& labels, Index number_of_clusters)
    : labels_(labels), mesh_(labels.mesh()), walk_(labels), growth_(labels), clusters_(number_of_clusters) {}

  // Returns the number of splits.
  std::size_t run()
  {
    std::size_t splits = 0;
    fruitless_.assign(mesh_.components.size(), false);
    for (;;) {
      survey();
      const std::vector<Index> to_split = faulty_clusters();
      if (to_split.empty())
        return splits;
      for (const Index x : to_split)
        split(x);
      splits += to_split.size();
    }
  }

  Index number_of_clusters() const { return clusters_; }

  // Components in which clusters of one face are at fault.
  std::vector<Index> fruitless_components() const
  {
    std::vector<Index> list;
    for (std::size_t i = 0; i < fruitless_.size(); ++i)
      if (fruitless_[i])
        list.push_back(Index(i));
    return list;
  }

private:
  // Size, a face, and a boundary edge of each cluster.
  void survey()
  {
    size_.assign(clusters_, 0);
    face_.assign(clusters_, NONE);
    edge_.assign(clusters_, Directed_edge());
    stamp_of_cluster_.resize(clusters_, 0);
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f) {
      const Index x = labels_[Index(f)];
      ++size_[x];
      if (face_[x] == NONE)
        face_[x] = Index(f);
      if (edge_[x].face == NONE)
        edge_[x] = walk_.boundary_edge(Index(f));
    }
  }

  std::vector<Index> faulty_clusters()
  {
    std::vector<Index> list;
    std::vector<bool> listed(clusters_, false);
    for (Index x = 0; x < clusters_; ++x) {
      const Index component = mesh_.component[face_[x]];
      if (fruitless_[component])
        continue;
      const Index fault = edge_[x].face == NONE ? x : walk_.fault_of_link(edge_[x], stamp_of_cluster_, stamp_);
      if (fault == NONE)
        continue;
      const Index larger = cluster_to_split(x, fault);
      if (larger == NONE)
        fruitless_[component] = true;
      else if (!listed[larger]) {
        listed[larger] = true;
        list.push_back(larger);
      }
    }
    return list;
  }

  // The larger of the two at fault; a neighbor, where both have a single face; NONE, where those have, too.
  Index cluster_to_split(Index x, Index fault)
  {
    Index largest = x;
    const auto consider = [&](Index y) {
      if (!Cluster_labels::is_beyond_border(y) && size_[y] > size_[largest])
        largest = y;
      return true;
    };
    consider(fault);
    if (size_[largest] == 1 && edge_[x].face != NONE)
      walk_.along_link(edge_[x], consider);
    return size_[largest] == 1 ? NONE : largest;
  }

  // Grows the cluster anew from two faces far apart.
  void split(Index x)
  {
    const std::vector<Index> faces = faces_outward(face_[x]);
    const std::vector<Index> back = faces_outward(faces.back());
    for (const Index f : faces)
      labels_.set(f, NONE);
    growth_.plant(back.front(), x);
    growth_.plant(back.back(), clusters_++);
    growth_.run();
    clusters_ = growth_.cover(faces, clusters_);
  }

  // The faces of the cluster of `f` in the order of a breadth-first walk from there.
  std::vector<Index> faces_outward(Index f)
  {
    const Index x = labels_[f];
    std::vector<Index> queue(1, f);
    labels_.set(f, NONE);
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (Index c = mesh_.first_corner[queue[i]]; c != mesh_.first_corner[queue[i] + 1]; ++c) {
        const Index g = mesh_.face_across[c];
        if (g != NONE && labels_[g] == x) {
          labels_.set(g, NONE);
          queue.push_back(g);
        }
      }
    for (const Index g : queue)
      labels_.set(g, x);
    return queue;
  }

  Cluster_labels& labels_;
  const Flat_mesh& mesh_;
  Dual_walk walk_;
  Cluster_growth growth_;
  Index clusters_;
  std::vector<Index> size_, face_;
  std::vector<Directed_edge> edge_;
  std::vector<bool> fruitless_; // per component
  std::vector<Index> stamp_of_cluster_;
  Index stamp_ = 0;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_SPLIT_CLUSTERS_H
