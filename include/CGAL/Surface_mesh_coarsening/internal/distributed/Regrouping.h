// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_REGROUPING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_REGROUPING_H

#include <CGAL/Surface_mesh_coarsening/internal/base/sort_unique.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Patch.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/exchange.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/on_all_ranks.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Groups of faces go to ranks in their order.
inline std::size_t rank_of_group(Index group, Index groups, std::size_t ranks)
{
  return std::size_t(std::uint64_t(group) * ranks / groups);
}

// Brings the faces of each group, and all that share vertices with them, together on the rank of the group.
//
// The rank that the number of a vertex belongs to learns from all ranks in which groups their faces at the vertex are, and
// answers if there are several.
class Regrouping
{
public:
  Regrouping(const boost::mpi::communicator& communicator, const Face_set& faces, const std::vector<Index>& group, Index groups)
    : communicator_(communicator), ranks_(std::size_t(communicator.size())), faces_(faces), group_(group), groups_(groups)
  {}

  // The patches of the groups of this rank, in their order.
  std::vector<Patch> run(const Cancellation_point& cancellation)
  {
    find_shared_vertices();
    std::vector<Words> outgoing(ranks_);
    std::vector<Index> targets;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      find_targets(f, targets);
      for (const Index group : targets) {
        Words& words = outgoing[rank_of_group(group, groups_, ranks_)];
        words.push_back(packed(group, group == group_[f]));
        faces_.write(f, words);
      }
    }
    std::vector<Patch> patches = own_patches();
    for (Words& words : exchange(communicator_, outgoing))
      read(words, patches);
    on_all_blocks(communicator_, patches, [&](Patch& patch) { Patch_builder(patch).run(cancellation); });
    return patches;
  }

private:
  // A vertex, a group that has faces there, and the rank that these are on.
  typedef std::array<std::uint64_t, 3> Membership;
  // A vertex and a group that has faces there.
  typedef std::array<std::uint64_t, 2> Place;

  // Consecutive numbers, and numbers that differ by powers of two, belong to different ranks.
  std::size_t rank_of_vertex(std::uint64_t number) const { return std::size_t((number * 0x9e3779b97f4a7c15u) >> 32) % ranks_; }

  void find_shared_vertices()
  {
    std::vector<Words> answers(ranks_);
    const std::vector<Membership> all = memberships();
    for (std::size_t begin = 0, end; begin < all.size(); begin = end) {
      for (end = begin; end < all.size() && all[end][0] == all[begin][0];)
        ++end;
      if (all[end - 1][1] == all[begin][1])
        continue;
      for (std::size_t i = begin; i < end; ++i)
        for (std::size_t j = begin; j < end; ++j)
          if (j == begin || all[j][1] != all[j - 1][1])
            answers[all[i][2]].insert(answers[all[i][2]].end(), {all[j][0], all[j][1]});
    }
    for (const Words& words : exchange(communicator_, answers))
      for (std::size_t i = 0; i < words.size(); i += 2)
        shared_.push_back({{words[i], words[i + 1]}});
    sort_unique(shared_);
  }

  // The numbers of this rank, sorted.
  std::vector<Membership> memberships() const
  {
    std::vector<Place> own;
    own.reserve(faces_.vertex.size());
    for (std::size_t f = 0; f < faces_.size(); ++f)
      for (std::size_t c = faces_.first_corner[f]; c != faces_.first_corner[f + 1]; ++c)
        own.push_back({{faces_.vertex[c], group_[f]}});
    sort_unique(own);
    std::vector<Words> outgoing(ranks_);
    for (const Place& place : own)
      outgoing[rank_of_vertex(place[0])].insert(outgoing[rank_of_vertex(place[0])].end(), place.begin(), place.end());
    own = std::vector<Place>();
    std::vector<Membership> all;
    const std::vector<Words> incoming = exchange(communicator_, outgoing);
    for (std::size_t rank = 0; rank < incoming.size(); ++rank)
      for (std::size_t i = 0; i < incoming[rank].size(); i += 2)
        all.push_back({{incoming[rank][i], incoming[rank][i + 1], rank}});
    std::sort(all.begin(), all.end());
    return all;
  }

  // The groups that get a face: its own, and all groups with faces at its vertices.
  void find_targets(std::size_t f, std::vector<Index>& targets) const
  {
    targets.assign(1, group_[f]);
    for (std::size_t c = faces_.first_corner[f]; c != faces_.first_corner[f + 1]; ++c)
      for (auto i = std::lower_bound(shared_.begin(), shared_.end(), Place{{faces_.vertex[c], 0}});
           i != shared_.end() && (*i)[0] == faces_.vertex[c]; ++i)
        targets.push_back(Index((*i)[1]));
    sort_unique(targets);
  }

  std::vector<Patch> own_patches()
  {
    std::size_t number = 0;
    while (first_ < groups_ && rank_of_group(first_, groups_, ranks_) < std::size_t(communicator_.rank()))
      ++first_;
    while (first_ + number < groups_ &&
           rank_of_group(Index(first_ + number), groups_, ranks_) == std::size_t(communicator_.rank()))
      ++number;
    return std::vector<Patch>(number);
  }

  void read(Words& words, std::vector<Patch>& patches) const
  {
    const std::uint64_t* const end = words.data() + words.size();
    for (const std::uint64_t* word = words.data(); word != end;) {
      Patch& patch = patches[high_half(*word) - first_];
      patch.is_own.push_back(char(low_half(*word)));
      word = patch.faces.read(word + 1);
    }
    words = Words();
  }

  const boost::mpi::communicator& communicator_;
  const std::size_t ranks_;
  const Face_set& faces_;
  const std::vector<Index>& group_;
  const Index groups_;
  Index first_ = 0;           // group of this rank
  std::vector<Place> shared_; // by several groups; sorted
};

// The faces of their own of several patches.
inline Face_set own_faces(std::vector<Patch>& patches)
{
  Face_set all;
  for (Patch& patch : patches) {
    for (std::size_t f = 0; f < patch.faces.size(); ++f)
      if (patch.is_own[f])
        all.append(patch.faces, f);
    patch = Patch();
  }
  return all;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_REGROUPING_H
