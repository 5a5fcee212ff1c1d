// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_SEED_WALK_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_SEED_WALK_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/Visitor_handle.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Selection of seeds (section 6 of the paper): traverses the faces in order, and takes a face as a seed if no face within `level`
// steps across edges belongs to the neighborhood of an earlier seed.
//
// Two neighborhoods of `level` steps are disjoint if and only if their centers are more than 2 * level steps apart. So each new
// seed marks the faces within 2 * level steps, and the test of a face reads only its mark. Marking stops at faces that an earlier
// seed reached in as few steps, because the earlier seed has marked all faces behind them. Seeds are far apart, so few of them
// reach a face, and the time is linear in the number of faces for every level.
class Seed_walk
{
public:
  explicit Seed_walk(const Flat_mesh& mesh, const Cancellation_point& cancellation = Cancellation_point())
    : mesh_(mesh), cancellation_(cancellation) {}

  // Appends the seeds among the faces `candidates` to `seeds`.
  template <class FaceRange>
  void run(const FaceRange& candidates, Index level, std::vector<Index>& seeds)
  {
    steps_.resize(mesh_.number_of_faces(), NONE);
    for (const Index f : candidates) {
      cancellation_.poll();
      if (steps_[f] == NONE) {
        seeds.push_back(f);
        mark(f, level);
      }
    }
  }

  // Takes face `f` as a seed, independently of other seeds.
  void take(Index f, Index level, std::vector<Index>& seeds)
  {
    steps_.resize(mesh_.number_of_faces(), NONE);
    seeds.push_back(f);
    mark(f, level);
  }

  // Clears the marks on the faces `candidates`.
  template <class FaceRange>
  void forget(const FaceRange& candidates)
  {
    if (!steps_.empty())
      for (const Index f : candidates)
        steps_[f] = NONE;
  }

  // Clears all marks and frees their memory.
  void release() { steps_ = std::vector<Index>(); }

private:
  void mark(Index seed, Index level)
  {
    const Index reach = level < NONE / 4 ? 2 * level : NONE / 2;
    queue_.assign(1, seed);
    steps_[seed] = 0;
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const Index f = queue_[i], next = steps_[f] + 1;
      if (next > reach)
        break;
      cancellation_.poll();
      for (const Index c : mesh_.corners(f)) {
        const Index g = mesh_.face_across[c];
        if (g != NONE && next < steps_[g]) {
          steps_[g] = next;
          queue_.push_back(g);
        }
      }
    }
  }

  const Flat_mesh& mesh_;
  Cancellation_point cancellation_;
  std::vector<Index> steps_; // the number of steps to the nearest seed found; NONE: none within reach
  std::vector<Index> queue_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_SEED_WALK_H
