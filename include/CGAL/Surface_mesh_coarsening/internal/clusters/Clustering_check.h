// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_CLUSTERING_CHECK_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_CLUSTERING_CHECK_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

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

// Checks a clustering by its labels alone: every cluster must be a closed disc, and the dual a simplicial surface.
class Clustering_check
{
public:
  Clustering_check(const Cluster_labels& labels, std::size_t clusters)
    : labels_(labels), mesh_(labels.mesh()), clusters_(clusters), first_face_(clusters, NONE), boundary_(clusters) {}

  typedef std::function<std::string(std::size_t)> Name;

  // Describes the first fault; empty if there is none. `name(x)` is the name of cluster `x`.
  std::string fault(const Name& name)
  {
    const std::string message = fault_of_clusters(name);
    return message.empty() ? fault_of_dual(name) : message;
  }

  // The same for the clusters only, without their dual.
  std::string fault_of_clusters(const Name& name)
  {
    const std::string message = fault_of_labels(name);
    return message.empty() ? fault_of_discs(name) : message;
  }

private:
  std::string fault_of_labels(const Name& name)
  {
    const Dual_walk walk(labels_);
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f) {
      const Index x = labels_[Index(f)];
      if (x >= clusters_)
        return "face " + std::to_string(f) + " has no cluster";
      if (first_face_[x] == NONE)
        first_face_[x] = Index(f);
      if (boundary_[x].face == NONE)
        boundary_[x] = walk.boundary_edge(Index(f));
    }
    for (std::size_t x = 0; x < clusters_; ++x)
      if (first_face_[x] == NONE)
        return name(x) + " has no face";
      else if (boundary_[x].face == NONE)
        return name(x) + " covers a closed component";
    return {};
  }

  // A cluster is a closed disc if its faces are connected across edges, its faces around every vertex are consecutive,
  // and its Euler characteristic is 1.
  std::string fault_of_discs(const Name& name) const
  {
    std::vector<long> euler_characteristic(clusters_, 0);
    std::vector<Index> runs;
    for (std::size_t v = 0; v < mesh_.number_of_vertices(); ++v) {
      if (mesh_.first_in_star[v] == mesh_.first_in_star[v + 1])
        continue;
      clusters_around_vertex(labels_, Index(v), runs);
      for (std::size_t i = 0; i < runs.size(); ++i) {
        if (Cluster_labels::is_cap(runs[i]))
          continue;
        if (std::find(runs.data() + i + 1, runs.data() + runs.size(), runs[i]) != runs.data() + runs.size())
          return name(runs[i]) + " touches itself at vertex " + std::to_string(v);
        ++euler_characteristic[runs[i]];
      }
    }
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f) {
      const Index x = labels_[Index(f)];
      ++euler_characteristic[x];
      for (const Index c : mesh_.corners(f))
        if (labels_.label_across(c) != x || mesh_.face_across[c] > f)
          --euler_characteristic[x];
    }
    std::vector<bool> reached(mesh_.number_of_faces(), false);
    std::vector<Index> faces;
    for (const Index face : first_face_) {
      reached[face] = true;
      flood_fill(mesh_, face, faces, Run_context(), [&](Index, Index g) {
        if (reached[g] || labels_[g] != labels_[face])
          return false;
        reached[g] = true;
        return true;
      });
    }
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f)
      if (!reached[f])
        return name(labels_[Index(f)]) + " is not connected: face " + std::to_string(f) + " lies apart";
    for (std::size_t x = 0; x < clusters_; ++x)
      if (euler_characteristic[x] != 1)
        return name(x) + " is not a disc: its Euler characteristic is " + std::to_string(euler_characteristic[x]);
    return {};
  }

  std::string fault_of_dual(const Name& name) const
  {
    Dual_walk walk(labels_);
    for (std::size_t x = 0; x < clusters_; ++x) {
      const Index y = walk.first_link_defect(boundary_[x]);
      if (y == x)
        return name(x) + " has fewer than three neighbors";
      if (Cluster_labels::is_cap(y))
        return name(x) + " meets the border twice";
      if (y != NONE)
        return name(x) + " and " + name(y) + " meet twice";
    }
    return {};
  }

  const Cluster_labels& labels_;
  const Flat_mesh& mesh_;
  std::size_t clusters_;
  std::vector<Index> first_face_;
  std::vector<Directed_edge> boundary_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_CLUSTERING_CHECK_H
