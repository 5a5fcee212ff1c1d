// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DUAL_PARTS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DUAL_PARTS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Patch.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Rank_context.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/place_vertices.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The clusters of a patch whose own faces are all faces of some clusters. A face moves only if all faces around its vertices
// belong to these clusters. Such moves neither affect the moves in other patches nor depend on them, so the patches can be
// processed at the same time and in any order.
class Patch_clusters
{
public:
  explicit Patch_clusters(Patch& patch) : patch_(patch), labels_(patch.mesh())
  {
    Clustering_input& items = patch.input.items;
    items.density.reserve(patch.faces.size());
    for (const Face_data& face : patch.faces)
      items.density.push_back(face.density);
    compute_areas_and_centroids(items);
    // Most faces have the same cluster as the previous face.
    for (std::size_t f = 0; f < patch.faces.size(); ++f)
      if (clusters_.empty() || clusters_.back() != cluster_of(f))
        clusters_.push_back(cluster_of(f));
    sort_unique(clusters_);
    Index number = 0;
    for (std::size_t f = 0; f < patch.faces.size(); ++f) {
      if (clusters_[number] != cluster_of(f))
        number = Index(std::lower_bound(clusters_.begin(), clusters_.end(), cluster_of(f)) - clusters_.begin());
      labels_.set(Index(f), number);
    }
    labels_.recount();
  }

  const Cluster_labels& labels() const { return labels_; }
  std::size_t size() const { return clusters_.size(); }
  // Whether a cluster consists of own faces; these come first.
  bool is_own(Index x) const { return !clusters_[x].first; }
  Index global_number(Index x) const { return clusters_[x].second; }

  // Runs at most `end.max_rounds` rounds of the minimization. Returns the number of rounds.
  std::size_t minimize(const Energy_model& energy, const Minimization_end& end, const Run_context& context)
  {
    for (Index f = 0; f < patch_.faces.size(); ++f)
      if (!patch_.is_inner_face(f))
        labels_.pin(f);
    const std::unique_ptr<Minimization> minimization = energy.minimization(patch_.input, labels_, size(), false, context);
    std::size_t rounds = 0;
    bool has_ended = false;
    double before = minimization->energy();
    while (rounds < end.max_rounds && !has_ended) {
      const std::size_t some = (std::min)(end.max_rounds - rounds, minimization->rounds_at_a_time());
      const Minimization_progress progress = minimization->run({some, end.tolerance});
      const double after = minimization->energy();
      has_ended = progress.moves == 0 || before - after <= end.tolerance * before;
      before = after;
      rounds += progress.rounds;
    }
    for (std::size_t f = 0; f < patch_.faces.size(); ++f)
      patch_.faces[f].cluster = global_number(labels_[Index(f)]);
    return rounds;
  }

private:
  // Whether the cluster consists of foreign faces, and its number.
  std::pair<bool, Index> cluster_of(std::size_t f) const { return {!patch_.is_own(f), patch_.faces[f].cluster}; }

  Patch& patch_;
  Cluster_labels labels_;
  std::vector<std::pair<bool, Index> > clusters_;
};

// The parts from which the dual of all clusters is assembled.
struct Dual_parts
{
  struct Cluster_part
  {
    Index cluster;
    double energy;
    Vector position; // unless the cluster lies on the border
    Bbox_3 bounds;   // of the position
    bool operator<(const Cluster_part& p) const { return cluster < p.cluster; }
  };
  typedef std::array<std::uint64_t, 2> Center_part; // a face that represents its cell, and its cluster
  struct Triangle_part // a triangle of the fan at a vertex where several clusters meet
  {
    std::uint64_t vertex;
    Index number; // in the fan
    Triangle triangle;
    bool operator<(const Triangle_part& p) const { return std::tie(vertex, number) < std::tie(p.vertex, p.number); }
  };

  std::vector<Cluster_part> clusters;
  std::vector<Center_part> centers;
  std::vector<Triangle_part> triangles;

  void add(const Patch& patch, const Patch_clusters& local, const Distributed_choice& choice)
  {
    const Clustering_input& input = patch.input.items;
    const Flat_mesh& m = input.mesh;
    for (const Face_data& face : patch.faces)
      if (face.is_own && face.is_center)
        centers.push_back({{face.origin, face.cluster}});
    const Clustered_faces surface(input, local.labels(), local.size(), choice);
    const auto place = [&](Index x) {
      return choice.placement.fitted ? quadric_position(surface, x, Quadric_placement::default_pull)
                                     : choice.placement.local(surface, x);
    };
    const std::vector<Cluster_report> reports = choice.energy->cluster_reports(input, local.labels(), local.size());
    const auto is_on_border = [&m](Index f) {
      const Number_range corners = m.corners(f);
      return std::any_of(corners.begin(), corners.end(), [&m](Index c) { return m.face_across[c] == NONE; });
    };
    for (Index x = 0; x < local.size() && local.is_own(x); ++x) {
      const Clustered_faces::Range faces = surface.faces(x);
      choice.poll(faces.size());
      const bool has_border = std::any_of(faces.begin(), faces.end(), is_on_border);
      const Vector p = has_border ? Vector{{0, 0, 0}} : checked_position(surface, x, place(x));
      clusters.push_back({local.global_number(x), reports[x].energy, p, surface.vertex_bounds(x)});
    }
    for_each_meeting_point(local.labels(), [&](Index v, const std::vector<Index>& runs) {
      if (!patch.is_own(m.star[m.first_in_star[v]]))
        return; // the first face around the vertex belongs to another patch
      const auto number = [&](std::size_t i) { return local.global_number(runs[i]); };
      for (std::size_t i = 2; i < runs.size(); ++i)
        triangles.push_back({patch.number[v], Index(i), {number(0), number(i - 1), number(i)}});
    });
  }

  // Moves the parts of all ranks to rank 0. Their order does not depend on the ranks.
  void gather(Rank_context& context)
  {
    gather_sorted(context, clusters);
    gather_sorted(context, centers);
    gather_sorted(context, triangles);
  }

  // Returns the cluster of the cell that a face represents, if the parts are gathered.
  Index cluster_at(std::uint64_t origin) const
  {
    return Index((*std::lower_bound(centers.begin(), centers.end(), Center_part{{origin, 0}}))[1]);
  }
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DUAL_PARTS_H
