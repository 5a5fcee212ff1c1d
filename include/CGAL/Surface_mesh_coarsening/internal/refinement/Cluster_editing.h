// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFINEMENT_CLUSTER_EDITING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFINEMENT_CLUSTER_EDITING_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Moments.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_cells.h>
#include <CGAL/Surface_mesh_coarsening/internal/seeding/Cluster_growth.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The result of the relocation of a cluster.
enum class Relocation
{
  DONE,
  TOO_FAR,       // the distance would become too large
  NOT_FROM_HERE, // the cluster cannot be removed from its place
  NOT_THERE      // no cluster can be formed at the destination
};

// Splits a cluster of a valid clustering, or merges it into a neighbor, if the clustering remains valid. Checks only the changed
// clusters and the links of the clusters around them, because everything else remains valid. The time depends only on the sizes
// of these clusters.
class Cluster_editing
{
public:
  Cluster_editing(const Featured_input& input, Cluster_labels& labels, Index clusters)
    : input_(input.items),
      cells_(input.cells.get()),
      mesh_(input.items.mesh),
      labels_(labels),
      walk_(labels),
      face_of_(clusters, NONE)
  {
    for (std::size_t f = mesh_.number_of_faces(); f-- > 0;)
      face_of_[labels_[Index(f)]] = Index(f);
  }

  Index number_of_clusters() const { return Index(face_of_.size()); }

  // The new cluster has the next number. Returns whether the split was possible.
  bool split(Index x)
  {
    face_of_.push_back(face_of_[x]);
    if (split_anyhow(x, number_of_clusters() - 1, outward(face_of_[x])))
      return true;
    face_of_.pop_back();
    return false;
  }

  // Tries the neighbors in the order of the added inertia. The last cluster gets the number of `x`.
  bool remove(Index x)
  {
    if (merge(x, outward(face_of_[x])) == NONE)
      return false;
    const Index last = number_of_clusters() - 1;
    if (x != last) {
      move(outward(face_of_[last]), x);
      face_of_[x] = face_of_[last];
      labels_.freeze(x, labels_.is_frozen(last));
    }
    labels_.freeze(last, false);
    face_of_.pop_back();
    return true;
  }

protected:
  std::vector<Index> outward(Index f) { return faces_in_bfs_order(labels_, f); }

  void move(const std::vector<Index>& faces, Index to)
  {
    for (const Index f : faces)
      labels_.move(f, to);
  }

  // Moves the faces of cluster `x` to a neighbor that can receive them: to `first` if possible, otherwise to the neighbor
  // whose inertia increases least. Returns this neighbor; NONE if there is none.
  Index merge(Index x, const std::vector<Index>& faces, Index first = NONE)
  {
    std::vector<Index> neighbors;
    for (const Index f : faces)
      for (const Index c : mesh_.corners(f))
        neighbors.push_back(labels_.label_across(c));
    sort_unique(neighbors);
    const Moments moments = moments_of(faces);
    std::vector<std::pair<double, Index> > candidates;
    for (const Index y : neighbors)
      if (y != x && !Cluster_labels::is_cap(y) && !labels_.is_frozen(y))
        candidates.emplace_back(y == first ? 0 : inertia_between(moments, moments_of(outward(face_of_[y]))), y);
    std::sort(candidates.begin(), candidates.end());
    for (const auto& [added_inertia, y] : candidates) {
      move(faces, y);
      if (is_valid_around(y))
        return y;
      move(faces, x);
    }
    return NONE;
  }

  // Splits cluster `x` into two clusters of similar extent. The new cluster is `y`.
  bool split_anyhow(Index x, Index y, const std::vector<Index>& faces)
  {
    constexpr std::size_t attempts = 8;
    for (std::size_t i = 0; i < (std::min)(attempts, faces.size()) && faces.size() > 1; ++i) {
      const Index first = outward(faces[i * faces.size() / (std::min)(attempts, faces.size())]).back();
      const Index second = outward(first).back();
      if (try_split(x, y, faces, {first}, second))
        return true;
    }
    return false;
  }

  // Grows cluster `x` from some of its faces, and cluster `y` from another one, over the faces of `x`.
  bool try_split(Index x, Index y, const std::vector<Index>& faces, const std::vector<Index>& first, Index second)
  {
    if (first.front() == second)
      return false;
    for (const Index f : faces)
      labels_.set(f, NONE);
    Cluster_growth growth(labels_);
    for (const Index f : first)
      growth.plant(f, x);
    growth.plant(second, y);
    growth.run();
    std::vector<Index> of_second;
    bool is_covered = true;
    for (const Index f : faces) {
      is_covered = is_covered && labels_[f] != NONE;
      if (labels_[f] == y)
        of_second.push_back(f);
      labels_.set(f, x);
    }
    if (!is_covered)
      return false;
    move(of_second, y);
    const Index former = std::exchange(face_of_[x], first.front()), former_of_y = std::exchange(face_of_[y], second);
    if (is_valid_around(x) && is_valid_around(y))
      return true;
    move(of_second, x);
    face_of_[x] = former;
    face_of_[y] = former_of_y;
    return false;
  }

  // Returns the mass and the centroid; the inertia is not computed.
  Moments moments_of(const std::vector<Index>& faces) const
  {
    Moments result;
    for (const Index f : faces)
      result.add_to_centroid(input_.mass(f), input_.centroid(f));
    result.end_centroid();
    return result;
  }

  // Returns whether cluster `x` is a disc, and the links of `x` and of its neighbors are simple.
  bool is_valid_around(Index x)
  {
    const std::vector<Index> faces = outward(face_of_[x]);
    if (!is_disc(x, faces) || !has_simple_link(faces))
      return false;
    const std::vector<Index> link = walk_.simple_link(); // a copy: the walk continues
    return std::all_of(link.begin(), link.end(), [this](Index y) {
      return Cluster_labels::is_cap(y) || has_simple_link(outward(face_of_[y]));
    });
  }

  bool has_simple_link(const std::vector<Index>& faces)
  {
    for (const Index f : faces)
      if (const Directed_edge e = walk_.boundary_edge(f); e.face != NONE)
        return walk_.first_link_defect(e) == NONE;
    return false;
  }

  // The faces form a connected component of the cluster.
  bool is_disc(Index x, const std::vector<Index>& faces) const
  {
    long euler = long(faces.size());
    std::vector<Index> vertices, runs;
    for (const Index f : faces)
      for (const Index c : mesh_.corners(f)) {
        vertices.push_back(mesh_.corner_vertex[c]);
        euler -= labels_.label_across(c) != x || mesh_.face_across[c] > f;
      }
    sort_unique(vertices);
    for (const Index v : vertices) {
      clusters_around_vertex(labels_, v, runs);
      if (std::count(runs.begin(), runs.end(), x) != 1)
        return false;
    }
    return euler + long(vertices.size()) == 1;
  }

  const Clustering_input& input_;
  const Feature_cells* cells_; // null without features
  const Flat_mesh& mesh_;
  Cluster_labels& labels_;
  Dual_walk walk_;
  std::vector<Index> face_of_; // a face of each cluster
};

// Relocates clusters of a valid clustering. The clustering remains valid and keeps the number of clusters. A cluster may move to
// another component, unless the component would have more clusters than vertices. All relocations can be undone.
class Cluster_relocation : private Cluster_editing
{
public:
  Cluster_relocation(const Featured_input& input, Cluster_labels& labels, Index clusters)
    : Cluster_editing(input, labels, clusters), bounds_(clusters),
      clusters_of_component_(mesh_.components.size(), 0)
  {
    for (Index x = 0; x < clusters; ++x)
      ++clusters_of_component_[component_of(x)];
  }

  // The number of relocated clusters.
  std::size_t number() const { return end_of_relocation_.size(); }
  bool is_undone() const { return is_undone_; }
  bool has_changed(Index x) const { return bounds_[x].has_value(); }
  // Returns the bounds of the vertex of a changed cluster. Many threads may call this function, so the faces are visited earlier.
  const Bbox_3& vertex_bounds(Index x) const { return *bounds_[x]; }

  // Merges cluster `x` into a neighbor, if possible into `into`, and forms a new cluster `x` around one of some faces of the
  // input, the first possible one, from the cluster of this face, or around a piece of a face if features are kept. The vertices
  // remain within the bounds of their clusters. Faces on the border or on features remain in their clusters, and frozen clusters
  // do not change.
  Relocation relocate(Index x, Index into, std::vector<Index> to, const std::vector<Vector>& positions)
  {
    if (cells_)
      for (Index& f : to)
        f = cells_->polygon(f);
    const Index from = component_of(x);
    const auto has_no_room = [&](Index f) {
      const Index c = mesh_.component[f];
      return c != from && clusters_of_component_[c] >= mesh_.components[c].max_clusters();
    };
    to.erase(std::remove_if(to.begin(), to.end(), has_no_room), to.end());
    // Only a cluster without vertices on the border and on features may lose its faces.
    const std::vector<Index> faces = outward(face_of_[x]);
    if (labels_.is_frozen(x) || std::any_of(faces.begin(), faces.end(), [this](Index f) { return is_on_border(f); }))
      return Relocation::NOT_FROM_HERE;
    const Index heir = merge(x, faces, into);
    if (heir == NONE)
      return Relocation::NOT_FROM_HERE;
    Relocation outcome = Relocation::NOT_FROM_HERE;
    if (is_within_bounds(heir, positions) && (into == NONE || is_within_bounds(into, positions))) {
      const Index y = split_one(x, to, positions);
      if (y != NONE) {
        for (const Index changed : {x, y, heir})
          bounds_[changed] = bounds(changed);
        for (const Index f : faces)
          moved_.push_back({f, x});
        for (const Index f : outward(face_of_[x]))
          moved_.push_back({f, y});
        end_of_relocation_.push_back(moved_.size());
        --clusters_of_component_[from];
        ++clusters_of_component_[component_of(x)];
        return Relocation::DONE;
      }
      outcome = Relocation::NOT_THERE;
    }
    face_of_[x] = faces.front();
    move(faces, x);
    return outcome;
  }

  // Restores the labels; afterwards, nothing can be relocated.
  void undo()
  {
    bounds_.assign(bounds_.size(), std::nullopt);
    undo_all_after(0);
    is_undone_ = true;
  }

  // Restores the labels after the first `number` relocations; afterwards, nothing can be relocated.
  void undo_all_after(std::size_t number)
  {
    const std::size_t left = number == 0 ? 0 : end_of_relocation_[number - 1];
    for (; moved_.size() > left; moved_.pop_back())
      labels_.move(moved_.back().face, moved_.back().from);
    end_of_relocation_.resize(number);
  }

private:
  // A face and its cluster before a relocation.
  struct Moved_face
  {
    Index face, from;
  };

  Index component_of(Index x) const { return mesh_.component[face_of_[x]]; }
  Bbox_3 bounds(Index x) { return internal::vertex_bounds(mesh_, outward(face_of_[x])); }

  // Returns whether a face has a vertex on the border or on a feature.
  bool is_on_border(Index f) const
  {
    if (cells_ && (cells_->node(f) != NONE || cells_->is_at_border(f)))
      return true;
    return mesh_.any_corner(f, [this](Index c) { return mesh_.is_on_border(mesh_.corner_vertex[c]); });
  }

  bool is_within_bounds(Index x, const std::vector<Vector>& positions)
  {
    return closest_in_box(positions[x], bounds(x)) == positions[x];
  }

  // Splits a cluster `x` off the cluster of one of some faces. Returns the other part; NONE if there is no admissible split.
  Index split_one(Index x, const std::vector<Index>& to, const std::vector<Vector>& positions)
  {
    constexpr std::size_t max_tried = 4;
    std::vector<Index> tried;
    for (const Index f : to) {
      const Index y = labels_[f];
      if (std::find(tried.begin(), tried.end(), y) != tried.end())
        continue;
      if (tried.size() == max_tried)
        break;
      tried.push_back(y);
      if (labels_.is_frozen(y) || !split_around(y, x, f, positions[y]))
        continue;
      if (is_within_bounds(x, positions) && is_within_bounds(y, positions))
        return y;
      move(outward(face_of_[x]), y);
    }
    return NONE;
  }

  // Splits a cluster `x` around face `f` off cluster `y`, which keeps the face nearest to its vertex `p`, or the face farthest from
  // `f`; if this fails, a half of `y`. The faces of `y` on the border remain in `y`; then `x` begins with the face nearest to `f`
  // that is not on the border.
  bool split_around(Index y, Index x, Index f, const Vector& p)
  {
    const std::vector<Index> faces = outward(f);
    std::vector<Index> on_border;
    std::copy_if(faces.begin(), faces.end(), std::back_inserter(on_border), [this](Index g) { return is_on_border(g); });
    if (!on_border.empty()) {
      const auto inside = std::find_if(faces.begin(), faces.end(), [this](Index g) { return !is_on_border(g); });
      return inside != faces.end() && try_split(y, x, faces, on_border, *inside);
    }
    const auto squared_distance = [&](Index g) { return dot(input_.centroid(g) - p, input_.centroid(g) - p); };
    const Index nearest = *std::min_element(faces.begin(), faces.end(), [&](Index g, Index h) {
      return squared_distance(g) < squared_distance(h);
    });
    return try_split(y, x, faces, {nearest}, f) || try_split(y, x, faces, {faces.back()}, f) || split_anyhow(y, x, faces);
  }

  std::vector<std::optional<Bbox_3> > bounds_; // of the vertices of changed clusters
  std::vector<Moved_face> moved_;
  std::vector<std::size_t> end_of_relocation_; // in `moved_`
  bool is_undone_ = false;
  std::vector<std::size_t> clusters_of_component_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFINEMENT_CLUSTER_EDITING_H
