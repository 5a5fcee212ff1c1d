// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_TASK_REFINEMENT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_TASK_REFINEMENT_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Distributed_choice.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Dual_parts.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Face_set.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Shared_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Word_routing.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Two divisions of the clusters into tasks: the two tasks of each cluster. A task is a run of clusters along the curve with at
// most `max_faces` faces, or a single cluster with more faces. The second division begins with half a run, so the borders of the
// first division lie in the middle of its tasks.
typedef std::vector<std::array<Index, 2> > Cluster_tasks;

inline Cluster_tasks divide_into_tasks(const std::vector<std::size_t>& faces, const std::vector<std::uint64_t>& places,
                                       std::size_t max_faces)
{
  std::vector<Index> order(faces.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::sort(order.begin(), order.end(),
            [&](Index i, Index j) { return std::make_pair(places[i], i) < std::make_pair(places[j], j); });
  Cluster_tasks tasks(faces.size());
  for (std::size_t k = 0; k < 2; ++k) {
    Index task = 0;
    std::size_t room = k == 0 ? max_faces : max_faces / 2;
    for (const Index i : order) {
      if (faces[i] > room && (task > 0 || room < max_faces / (k + 1))) {
        ++task;
        room = max_faces;
      }
      tasks[i][k] = task;
      room -= (std::min)(room, faces[i]);
    }
  }
  return tasks;
}

inline std::size_t number_of_tasks(const Cluster_tasks& tasks, std::size_t division)
{
  Index last = 0;
  for (const std::array<Index, 2>& of_cluster : tasks)
    last = (std::max)(last, of_cluster[division]);
  return last + std::size_t(1);
}

// Refines the clusters face by face, in tasks of nearby clusters. Two divisions into tasks alternate.
class Task_refinement
{
public:
  // Receives the faces of each task at the end, and may send results.
  typedef std::function<void(const Patch&, const Patch_clusters&, Word_routing&)> Receiver;

  Task_refinement(Rank_context& context, const Distributed_choice& choice, const Cluster_tasks& tasks, const Face_names& names)
    : context_(context), choice_(choice), tasks_(tasks), names_(names),
      number_of_phases_(number_of_tasks(tasks, 0) == 1 ? 1 : max_phases)
  {}

  // `faces` holds the faces of the tasks of the first division. `receive` may send to the bins `last`, which `last_store` holds.
  // Returns the number of rounds.
  std::size_t run(std::unique_ptr<Word_store> faces, const Bin_ranks& last, Word_store& last_store,
                  const Receiver& receive) const
  {
    const std::array<Bin_ranks, 2> divisions{
      {Bin_ranks(context_, number_of_tasks(tasks_, 0)), Bin_ranks(context_, number_of_tasks(tasks_, 1))}};
    std::size_t rounds = 0;
    for (std::size_t phase = 0; phase < number_of_phases_; ++phase) {
      const bool is_last = phase + 1 == number_of_phases_;
      const std::size_t next = (phase + 1) % 2;
      auto faces_of_next = std::make_unique<Word_store>(is_last ? 0 : divisions[next].number_of_own(), context_.scratch);
      Word_routing routing(context_, is_last ? last : divisions[next], is_last ? last_store : *faces_of_next);
      std::size_t rounds_of_phase = 0;
      routing.run([&] {
        for (std::size_t bin = 0; bin < faces->number_of_bins(); ++bin) {
          Patch patch = read_patch(*faces, bin, names_, context_);
          faces->clear(bin);
          Patch_clusters clusters(patch);
          rounds_of_phase = (std::max)(rounds_of_phase, clusters.minimize(*choice_.energy, end_of_phase(), context_));
          if (is_last)
            receive(patch, clusters, routing);
          else
            send(patch, clusters, next, routing);
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
  void send(const Patch& patch, const Patch_clusters& clusters, std::size_t division, Word_routing& routing) const
  {
    const Flat_mesh& m = clusters.input().mesh;
    const auto task_of = [&](Index f) { return tasks_[patch.faces[f].cluster][division]; };
    std::vector<char> is_between(m.number_of_vertices(), false); // whether a vertex lies between several tasks
    std::vector<Place> places;                                   // these vertices, and these tasks
    for (Index v = 0; v < is_between.size(); ++v) {
      const auto around = m.faces_around(v);
      is_between[v] = std::any_of(around.begin(), around.end(), [&](Index f) { return task_of(f) != task_of(*around.begin()); });
      if (is_between[v])
        for (const Index f : around)
          places.push_back({{patch.number[v], task_of(f)}});
    }
    sort_unique(places);
    std::vector<Index> targets;
    Face_record face;
    for (Index f = 0; f < patch.faces.size(); ++f) {
      if (!patch.is_own(f))
        continue;
      patch.get(f, m, face);
      routing.send(task_of(f), face);
      const Number_range corners = m.corners(f);
      if (std::none_of(corners.begin(), corners.end(), [&](Index c) { return is_between[m.corner_vertex[c]]; }))
        continue;
      find_groups(face, places, targets);
      face.is_own = false;
      for (const Index target : targets)
        if (target != task_of(f))
          routing.send(target, face);
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
