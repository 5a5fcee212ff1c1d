// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_SHARED_FACES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_SHARED_FACES_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Face_set.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Word_routing.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// A vertex and a group with faces at this vertex.
typedef std::array<std::uint64_t, 2> Place;

// Returns the groups at the vertices of a face. `places` is sorted.
inline void find_groups(const Face_record& face, const std::vector<Place>& places, std::vector<Index>& groups)
{
  groups.clear();
  for (const std::uint64_t v : face.vertex)
    for (auto i = std::lower_bound(places.begin(), places.end(), Place{{v, 0}}); i != places.end() && (*i)[0] == v; ++i)
      groups.push_back(Index((*i)[1]));
  sort_unique(groups);
}

// Gives each group of faces copies of all faces of other groups that share a vertex with its own faces.
//
// Each vertex number belongs to a bin. The bin collects the groups with faces at the vertex and informs each group of the others.
class Shared_faces
{
public:
  Shared_faces(Rank_context& context, const Bin_ranks& groups) : context_(context), groups_(groups)
  {}

  // `faces` holds the own faces of the groups of this rank, and receives the copies.
  void run(Word_store& faces) const
  {
    Word_store shared(groups_.number_of_own(), context_.scratch);
    find_shared_vertices(faces, shared);
    Word_routing routing(context_, groups_, faces);
    routing.run([&] {
      for (std::size_t bin = 0; bin < faces.number_of_bins(); ++bin)
        copy_faces(bin, faces, shared, routing);
    });
  }

private:
  static std::vector<Place> places_in(const Word_store& store, std::size_t bin)
  {
    std::vector<Place> places;
    store.read<Place>(bin, [&](const Place& place) { places.push_back(place); });
    sort_unique(places);
    return places;
  }

  // Consecutive numbers, and numbers that differ by powers of two, belong to different bins.
  std::size_t bin_of_vertex(std::uint64_t number) const
  {
    return std::size_t((number * 0x9e3779b97f4a7c15u) >> 32) % groups_.number_of_bins();
  }

  // `shared` receives, for each group, its shared vertices and the groups with which it shares them.
  void find_shared_vertices(const Word_store& faces, Word_store& shared) const
  {
    Word_store places(groups_.number_of_own(), context_.scratch);
    Word_routing to_bins(context_, groups_, places);
    to_bins.run([&] {
      for (std::size_t bin = 0; bin < faces.number_of_bins(); ++bin)
        for (const std::uint64_t v : vertices_of(faces, bin))
          to_bins.send(bin_of_vertex(v), Place{{v, groups_.first() + bin}});
    });
    Word_routing to_groups(context_, groups_, shared);
    to_groups.run([&] {
      for (std::size_t bin = 0; bin < places.number_of_bins(); ++bin) {
        const std::vector<Place> all = places_in(places, bin);
        places.clear(bin);
        for (std::size_t begin = 0, end; begin < all.size(); begin = end) {
          for (end = begin; end < all.size() && all[end][0] == all[begin][0];)
            ++end;
          for (std::size_t i = begin; i < end; ++i)
            for (std::size_t j = begin; j < end; ++j)
              if (i != j)
                to_groups.send(std::size_t(all[i][1]), all[j]);
        }
      }
    });
  }

  std::vector<std::uint64_t> vertices_of(const Word_store& faces, std::size_t bin) const
  {
    Number_table vertices;
    faces.read<Face_record>(bin, [&](const Face_record& face) {
      context_.poll(words_of_triangle);
      for (const std::uint64_t v : face.vertex)
        vertices.index(v);
    });
    return vertices.numbers();
  }

  void copy_faces(std::size_t bin, const Word_store& faces, Word_store& shared, Word_routing& routing) const
  {
    const std::vector<Place> places = places_in(shared, bin);
    shared.clear(bin);
    // Copies may arrive in this bin while faces are sent, so all copies are collected before.
    std::vector<Index> targets, target_of_copy;
    Words copies;
    faces.read<Face_record>(bin, [&](Face_record& face) {
      if (!face.is_own)
        return;
      find_groups(face, places, targets);
      face.is_own = false;
      for (const Index target : targets) {
        write_record(face, copies);
        target_of_copy.push_back(target);
      }
    });
    Face_record face;
    const std::uint64_t* copy = copies.data();
    for (const Index target : target_of_copy) {
      copy = read_record(copy, face);
      routing.send(target, face);
    }
  }

  Rank_context& context_;
  const Bin_ranks& groups_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_SHARED_FACES_H
