// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_BOUNDARY_EDGES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_BOUNDARY_EDGES_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Chunked_list.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Cluster_energy.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/prefetch.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The rounds in which a cluster has changed: bits, in any combination.
typedef unsigned char Change_times;
constexpr Change_times at_any_time = 1, in_last_round = 2, in_this_round = 4;

// The edges between clusters, in the order of their insertion, and the terms of their two faces. Terms are stored with
// the edges because rounds traverse the list in order but the faces of the mesh out of order.
//
// In most rounds most clusters do not change. Whether an edge lies at a changed cluster follows from its two clusters
// at the last look_up(): a later exchange would count as their change.
template <class Weight>
class Boundary_edges
{
public:
  typedef std::array<Face_terms<Weight>, 2> Terms;

  Boundary_edges(const Clustering_input& input, const Cluster_labels& labels, const Cluster_energy<Weight>& energy,
                 std::size_t number_of_clusters)
    : input_(input),
      mesh_(input.mesh),
      labels_(labels),
      energy_(energy),
      nowhere_(Index(number_of_clusters)),
      change_(number_of_clusters, at_any_time | in_last_round)
  {
    change_.push_back(0); // nowhere, nothing changes
  }

  // Lists all edges face by face. If the cancellation interrupts this, it has to be repeated before any other call.
  void list_all(const Cancellation_point& cancellation, Execution execution)
  {
    clear();
    for_each_part<std::vector<Edge> >(
      execution, mesh_.number_of_faces(), 4096, cancellation,
      [this](std::vector<Edge>& edges, std::size_t begin, std::size_t end) { find_edges(Index(begin), Index(end), edges); },
      [&](const std::vector<Edge>& edges) {
        new_edges_.insert(new_edges_.end(), edges.begin(), edges.end());
        if (new_edges_.size() >= new_at_a_time)
          list_new(execution);
      });
    list_new(execution);
    is_complete_ = true;
  }
  bool is_complete() const { return is_complete_; }

  std::size_t size() const { return edges_.size(); }
  // The two faces at an edge, the smaller index first.
  const std::array<Index, 2>& faces(Index i) const { return edges_[i].face; }
  const Terms& terms(Index i) const { return terms_[i]; }
  // The two clusters at the last `look_up()`.
  const std::array<Index, 2>& clusters(Index i) const { return clusters_[i]; }
  void look_up(Index i) { clusters_[i] = {{labels_[edges_[i].face[0]], labels_[edges_[i].face[1]]}}; }

  void note_change(Index cluster) { change_[cluster] |= in_this_round; }

  // Lists the edges at clusters changed at one of the times, among `most` edges from the `first` on. Returns the end of
  // this range.
  std::size_t list_changed(std::size_t first, std::size_t most, Change_times times, std::vector<Index>& changed) const
  {
    changed.clear();
    std::size_t i = first;
    for (std::size_t seen = 0; seen < most && i < size();) {
      const std::size_t end = (std::min)({i + most - seen, size(), i + clusters_.number_in_chunk_from(i)});
      seen += append_changed(i, end, times, changed);
      i = end;
    }
    return i;
  }

  // Records the edges of a face that has joined cluster `to`: they may lie between clusters now.
  void note_edges(Index f, Index to)
  {
    for (const Index c : mesh_.corners(f)) {
      const Index g = mesh_.face_across[c];
      if (g == NONE || labels_[g] == to)
        continue;
      const Index corner = f < g ? c : mesh_.corner_of(g, mesh_.corner_vertex[mesh_.next_corner(f, c)]);
      if (!is_listed_[corner]) {
        is_listed_[corner] = true;
        new_edges_.push_back({{{(std::min)(f, g), (std::max)(f, g)}}, corner});
      }
    }
  }

  // Removes edges that lie within a cluster now, and appends new edges that still lie between two: one pass over the
  // list is one pass over the mesh for each round that added edges. On a long list this takes more time than rebuilding
  // it, so it is rebuilt when half of it was added.
  void update(const Cancellation_point& cancellation, Execution execution)
  {
    added_ += new_edges_.size();
    if (size() >= long_list && added_ > size() / 2) {
      list_all(cancellation, execution);
      return;
    }
    look_up_changed(execution);
    for (const std::vector<Index>& part : inner_)
      for (const Index i : part)
        take_out(i);
    if (taken_out_ > size() / 16)
      close_gaps();
    list_new(execution);
  }

  void end_round()
  {
    for (Change_times& times : change_)
      times = Change_times((times & at_any_time) | (times & in_this_round ? in_last_round : 0));
  }

private:
  // An edge by its corner in the face of smaller index.
  struct Edge
  {
    std::array<Index, 2> face;
    Index corner;
  };

  static constexpr std::size_t new_at_a_time = 1024; // they stay in the caches
  static constexpr std::size_t long_list = 1 << 17;  // the data of its edges exceed the caches

  void clear()
  {
    is_complete_ = false;
    is_listed_.assign(mesh_.corner_vertex.size(), false);
    new_edges_.clear();
    edges_ = Chunked_list<Edge>();
    terms_ = Chunked_list<Terms>();
    clusters_ = Chunked_list<std::array<Index, 2> >();
    taken_out_ = added_ = 0;
  }

  // Finds the edges between clusters at the faces from `begin` to `end`, each at its face of smaller index.
  void find_edges(Index begin, Index end, std::vector<Edge>& edges) const
  {
    edges.clear();
    for (Index f = begin; f != end; ++f)
      for (const Index c : mesh_.corners(f)) {
        const Index g = mesh_.face_across[c];
        if (g != NONE && g > f && labels_[g] != labels_[f])
          edges.push_back({{{f, g}}, c});
      }
  }

  // Implements `list_changed()` for the edges from `begin` to `end`, which are contiguous in memory. Returns the number
  // of edges that are not removed.
  std::size_t append_changed(std::size_t begin, std::size_t end, Change_times times, std::vector<Index>& changed) const
  {
    const std::array<Index, 2>* const clusters = &clusters_[begin];
    std::size_t n = changed.size(), seen = 0;
    changed.resize(n + end - begin);
    for (std::size_t k = 0; k < end - begin; ++k) {
      changed[n] = Index(begin + k);
      n += ((change_[clusters[k][0]] | change_[clusters[k][1]]) & times) != 0;
      seen += clusters[k][0] != nowhere_;
    }
    changed.resize(n);
    return seen;
  }

  // Looks up edges whose clusters have changed, and finds edges that lie within a cluster now.
  void look_up_changed(Execution execution)
  {
    constexpr std::size_t chunk = Chunked_list<Edge>::chunk;
    inner_.resize((size() + chunk - 1) / chunk);
    for_each_chunk(execution, size(), chunk, [this](std::size_t part, std::size_t begin, std::size_t end) {
      std::vector<Index>& inner = inner_[part];
      inner.clear();
      append_changed(begin, end, in_this_round, inner);
      for (const Index i : inner)
        look_up(i);
      const auto is_between_two = [this](Index i) { return clusters_[i][0] != clusters_[i][1]; };
      inner.erase(std::remove_if(inner.begin(), inner.end(), is_between_two), inner.end());
    });
  }

  void list(const Edge& e, const Terms& terms)
  {
    is_listed_[e.corner] = true;
    edges_.push_back(e);
    terms_.push_back(terms);
    clusters_.push_back({{labels_[e.face[0]], labels_[e.face[1]]}});
  }

  Terms terms_of(const Edge& e) const { return {{energy_.terms_of(input_, e.face[0]), energy_.terms_of(input_, e.face[1])}}; }

  void list_new(Execution execution)
  {
    constexpr std::size_t part = 64;
    for (std::size_t first = 0; first < new_edges_.size(); first += new_at_a_time) {
      const std::size_t last = (std::min)(first + new_at_a_time, new_edges_.size());
      fresh_.resize(last - first);
      for_each_chunk(execution, last - first, part,
                     [&](std::size_t, std::size_t begin, std::size_t end) { compute_terms(first, first + begin, first + end); });
      for (std::size_t i = first; i < last; ++i) {
        if (fresh_[i - first])
          list(new_edges_[i], *fresh_[i - first]);
        else
          is_listed_[new_edges_[i].corner] = false;
      }
    }
    new_edges_.clear();
  }

  // Computes the terms of the new edges from `begin` to `end` that lie between clusters; `fresh_` begins with edge
  // `first`.
  void compute_terms(std::size_t first, std::size_t begin, std::size_t end)
  {
    constexpr std::size_t ahead = 8;
    for (std::size_t i = begin; i < end; ++i) {
      if (i + 2 * ahead < new_edges_.size()) {
        prefetch_faces(new_edges_[i + 2 * ahead]);
        prefetch_points(new_edges_[i + ahead]);
      }
      const Edge& e = new_edges_[i];
      fresh_[i - first].reset();
      if (labels_[e.face[0]] != labels_[e.face[1]])
        fresh_[i - first].emplace(terms_of(e));
    }
  }

  void take_out(Index i)
  {
    clusters_[i] = {{nowhere_, nowhere_}};
    is_listed_[edges_[i].corner] = false;
    ++taken_out_;
  }

  // Closes the gaps of removed edges, unless there are few.
  void close_gaps()
  {
    std::vector<Index> gone;
    gone.reserve(taken_out_);
    for (std::size_t i = 0; i < size(); ++i)
      if (clusters_[i][0] == nowhere_)
        gone.push_back(Index(i));
    edges_.remove(gone);
    terms_.remove(gone);
    clusters_.remove(gone);
    taken_out_ = 0;
  }

  BOOST_FORCEINLINE void prefetch_faces(const Edge& e) const
  {
    for (const Index f : e.face) {
      prefetch(&labels_.labels()[f]);
      prefetch(&input_.density[f]);
      prefetch(&input_.area[f]);
      prefetch(&mesh_.corner_vertex[mesh_.first_corner[f]]);
    }
  }
  BOOST_FORCEINLINE void prefetch_points(const Edge& e) const
  {
    for (const Index f : e.face)
      for (const Index c : mesh_.corners(f))
        prefetch(&mesh_.points[mesh_.corner_vertex[c]]);
  }

  const Clustering_input& input_;
  const Flat_mesh& mesh_;
  const Cluster_labels& labels_;
  const Cluster_energy<Weight>& energy_;
  const Index nowhere_;                      // replaces the clusters of removed edges
  std::vector<Change_times> change_;         // per cluster
  std::vector<bool> is_listed_;              // per corner
  std::vector<Edge> new_edges_;              // possibly between clusters since the last update
  std::vector<std::optional<Terms> > fresh_; // of some new edges
  std::vector<std::vector<Index> > inner_;   // edges within clusters, per chunk
  std::size_t taken_out_ = 0;                // removed edges still in the lists
  std::size_t added_ = 0;                    // edges since all were listed
  bool is_complete_ = false;
  // Per edge:
  Chunked_list<Edge> edges_;
  Chunked_list<Terms> terms_;
  Chunked_list<std::array<Index, 2> > clusters_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_BOUNDARY_EDGES_H
