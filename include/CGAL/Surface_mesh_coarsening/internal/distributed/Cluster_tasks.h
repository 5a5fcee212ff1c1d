// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CLUSTER_TASKS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CLUSTER_TASKS_H

#include <CGAL/Surface_mesh_coarsening/internal/distributed/Cell_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Morton_curve.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
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

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CLUSTER_TASKS_H
