// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_SET_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_SET_H

#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Words.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Where a face has come from.
struct Face_origin
{
  Index piece; // the rank
  Index face;  // its number there
};

inline std::string name_of(const Face_origin& origin)
{
  return "face " + std::to_string(origin.face) + " of piece " + std::to_string(origin.piece);
}

// Faces that stand for themselves: each has the global numbers and the coordinates of its vertices, beginning with the smallest
// number. Two faces differ in the first two vertices, because an edge has one face on each side. So these, after a place on a
// space-filling curve, put the faces in an order that depends on the mesh alone.
struct Face_set
{
  std::vector<std::uint64_t> place;       // of each face on the curve
  std::vector<double> density;
  std::vector<Index> cluster;
  std::vector<Face_origin> origin;
  std::vector<std::size_t> first_corner = std::vector<std::size_t>(1, 0);
  std::vector<std::uint64_t> vertex;      // of each corner
  std::vector<Vector> point;              // of each corner

  std::size_t size() const { return place.size(); }
  std::size_t degree(std::size_t f) const { return first_corner[f + 1] - first_corner[f]; }

  auto rank_in_order(std::size_t f) const
  {
    return std::make_tuple(place[f], vertex[first_corner[f]], vertex[first_corner[f] + 1]);
  }

  Vector mean_of_corners(std::size_t f) const
  {
    Vector sum{{0, 0, 0}};
    for (std::size_t c = first_corner[f]; c != first_corner[f + 1]; ++c)
      sum = sum + point[c];
    return (1. / double(degree(f))) * sum;
  }

  void write(std::size_t f, Words& words) const
  {
    words.push_back(place[f]);
    words.push_back(to_word(density[f]));
    words.push_back(packed(Index(degree(f)), cluster[f]));
    words.push_back(packed(origin[f].piece, origin[f].face));
    for (std::size_t c = first_corner[f]; c != first_corner[f + 1]; ++c) {
      words.push_back(vertex[c]);
      for (const double x : point[c])
        words.push_back(to_word(x));
    }
  }

  // Appends the face that begins at `word` and returns what follows.
  const std::uint64_t* read(const std::uint64_t* word)
  {
    place.push_back(*word++);
    density.push_back(to_double(*word++));
    const Index corners = high_half(*word);
    cluster.push_back(low_half(*word++));
    origin.push_back({high_half(*word), low_half(*word)});
    ++word;
    for (Index i = 0; i < corners; ++i, word += 4) {
      vertex.push_back(word[0]);
      point.push_back({{to_double(word[1]), to_double(word[2]), to_double(word[3])}});
    }
    first_corner.push_back(vertex.size());
    return word;
  }

  void append(const Face_set& other, std::size_t f)
  {
    place.push_back(other.place[f]);
    density.push_back(other.density[f]);
    cluster.push_back(other.cluster[f]);
    origin.push_back(other.origin[f]);
    const std::size_t begin = other.first_corner[f], end = other.first_corner[f + 1];
    for (std::size_t c = begin; c != end; ++c) {
      vertex.push_back(other.vertex[c]);
      point.push_back(other.point[c]);
    }
    first_corner.push_back(vertex.size());
  }
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_SET_H
