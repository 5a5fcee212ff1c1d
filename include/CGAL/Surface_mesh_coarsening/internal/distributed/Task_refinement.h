// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_TASK_REFINEMENT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_TASK_REFINEMENT_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Cell_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Distributed_choice.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Dual_parts.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Face_set.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Word_routing.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Two divisions of the clusters into tasks. A task is a run of clusters along the curve with at most `max_faces` faces, or a
// single cluster with more faces. The second division begins with half a run, so the borders of the first division lie in
// the middle of its tasks.
struct Cluster_tasks
{
  std::array<std::vector<Index>, 2> task; // of each cluster
  std::array<Index, 2> number{{0, 0}};

  Cluster_tasks() = default;

  Cluster_tasks(const Clustering_input& cells, const std::vector<Index>& faces_of_cell, const std::vector<Index>& cluster_of_cell,
                std::size_t clusters, const Morton_curve& curve, std::size_t max_faces)
  {
    std::vector<std::size_t> faces(clusters, 0);
    std::vector<Vector> sum(clusters, Vector{{0, 0, 0}});
    for (Index x = 0; x < faces_of_cell.size(); ++x) {
      const Index cluster = cluster_of_cell[x];
      faces[cluster] += faces_of_cell[x];
      sum[cluster] = sum[cluster] + double(faces_of_cell[x]) * cells.centroid(x);
    }
    std::vector<std::pair<std::uint64_t, Index> > order;
    for (Index i = 0; i < clusters; ++i)
      order.emplace_back(curve((1 / double(faces[i])) * sum[i]), i);
    std::sort(order.begin(), order.end());
    for (std::size_t k = 0; k < 2; ++k) {
      task[k].resize(clusters);
      std::size_t room = k == 0 ? max_faces : max_faces / 2;
      for (const auto& [place, i] : order) {
        if (faces[i] > room && (number[k] > 0 || room < max_faces / (k + 1))) {
          ++number[k];
          room = max_faces;
        }
        task[k][i] = number[k];
        room -= (std::min)(room, faces[i]);
      }
      ++number[k];
    }
  }

  Words words() const
  {
    Words words(1, packed(number[0], number[1]));
    for (std::size_t i = 0; i < task[0].size(); ++i)
      words.push_back(packed(task[0][i], task[1][i]));
    return words;
  }

  explicit Cluster_tasks(const Words& words) : number{{high_half(words[0]), low_half(words[0])}}
  {
    for (std::size_t i = 1; i < words.size(); ++i) {
      task[0].push_back(high_half(words[i]));
      task[1].push_back(low_half(words[i]));
    }
  }
};

// Refines the clusters face by face, in tasks of nearby clusters. Two divisions into tasks alternate.
class Task_refinement
{
public:
  // Receives the faces of each task at the end, and may send results.
  typedef std::function<void(const Patch&, const Patch_clusters&, Word_routing&)> Receiver;

  Task_refinement(Rank_context& context, const Distributed_choice& choice, const Cluster_tasks& tasks, const Face_names& names)
    : context_(context), choice_(choice), tasks_(tasks), names_(names),
      number_of_phases_(tasks.number[0] == 1 ? 1 : max_phases)
  {}

  // `faces` holds the faces of the tasks of the first division. `receive` may send to the bins `last`, which `last_store` holds.
  // Returns the number of rounds.
  std::size_t run(std::unique_ptr<Word_store> faces, const Bin_ranks& last, Word_store& last_store,
                  const Receiver& receive) const
  {
    const std::array<Bin_ranks, 2> divisions{
      {Bin_ranks(context_, tasks_.number[0]), Bin_ranks(context_, tasks_.number[1])}};
    std::size_t rounds = 0;
    for (std::size_t phase = 0; phase < number_of_phases_; ++phase) {
      const bool is_last = phase + 1 == number_of_phases_;
      const std::size_t next = (phase + 1) % 2;
      auto faces_of_next = std::make_unique<Word_store>(is_last ? 0 : divisions[next].number_of_own(), context_.scratch);
      Word_routing routing(context_, is_last ? last : divisions[next], is_last ? last_store : *faces_of_next);
      std::size_t rounds_of_phase = 0;
      routing.run([&] {
        for (std::size_t bin = 0; bin < faces->number_of_bins(); ++bin) {
          Patch patch = read_patch(*faces, bin, names_, context_.cancellation);
          faces->clear(bin);
          Patch_clusters clusters(patch);
          rounds_of_phase = (std::max)(rounds_of_phase, clusters.minimize(*choice_.energy, end_of_phase(),
                                                                          context_.cancellation, choice_.execution));
          if (is_last)
            receive(patch, clusters, routing);
          else
            send(patch, clusters, tasks_.task[next], routing);
        }
      });
      rounds += boost::mpi::all_reduce(context_.communicator, rounds_of_phase, boost::mpi::maximum<std::size_t>());
      faces = std::move(faces_of_next);
    }
    return rounds;
  }

private:
  static constexpr std::size_t max_phases = 4, max_rounds_of_phase = 20;
  // Clusters of cells have a low energy, but vertices of irregular degree. Rounds that hardly lower the energy remove them.
  static constexpr double part_of_tolerance = 0.01;

  Minimization_end end_of_phase() const
  {
    const std::size_t max_rounds = max_rounds_of_phase * (max_phases / number_of_phases_);
    return {(std::min)(choice_.end.max_rounds, max_rounds), part_of_tolerance * choice_.end.tolerance};
  }

  // Sends the own faces to their tasks in the next division, and copies to the tasks of all faces with which they share a vertex.
  // Faces that share a vertex with another task have not moved, so the clusters of the faces of other tasks are still valid.
  void send(const Patch& patch, const Patch_clusters& clusters, const std::vector<Index>& task, Word_routing& routing) const
  {
    const Flat_mesh& m = clusters.input().mesh;
    const std::vector<Index>& cluster = patch.faces.cluster;
    std::vector<std::pair<Index, Index> > meetings; // vertices between several tasks, and these tasks
    std::vector<char> is_meeting(m.number_of_vertices(), false);
    for (Index v = 0; v < is_meeting.size(); ++v) {
      const Index first = task[cluster[m.star[m.first_in_star[v]]]];
      for (const Index f : m.faces_around(v))
        is_meeting[v] = is_meeting[v] || task[cluster[f]] != first;
      if (is_meeting[v])
        for (const Index f : m.faces_around(v))
          meetings.emplace_back(v, task[cluster[f]]);
    }
    sort_unique(meetings);
    std::vector<Index> targets;
    Face_record face;
    Words words;
    for (Index f = 0; f < patch.faces.size(); ++f) {
      if (!patch.is_own(f))
        continue;
      patch.get(f, m, face);
      face.write(words);
      routing.send(task[cluster[f]], words);
      targets.clear();
      for (const Index c : m.corners(f))
        if (is_meeting[m.corner_vertex[c]])
          for (auto i = std::lower_bound(meetings.begin(), meetings.end(), std::make_pair(m.corner_vertex[c], Index(0)));
               i != meetings.end() && i->first == m.corner_vertex[c]; ++i)
            targets.push_back(i->second);
      sort_unique(targets);
      face.is_own = false;
      for (const Index target : targets)
        if (target != task[cluster[f]]) {
          face.write(words);
          routing.send(target, words);
        }
    }
  }

  Rank_context& context_;
  const Distributed_choice& choice_;
  const Cluster_tasks& tasks_;
  const Face_names& names_;
  std::size_t number_of_phases_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_TASK_REFINEMENT_H
