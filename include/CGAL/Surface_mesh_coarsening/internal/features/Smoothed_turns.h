// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_SMOOTHED_TURNS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_SMOOTHED_TURNS_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Finds the sharp turns of lines between patches. These lines follow the edges of faces, so they zigzag at any resolution. The
// direction on each side of a vertex is therefore the regression line of several edges. The turn at a corner does not depend on
// the number of edges, but the turn of a round line does: a corner turns sharply over some edges and over half of them.
class Smoothed_turns
{
public:
  // `neighbors` are the vertices before and after each vertex of a line; lines end at corners.
  Smoothed_turns(const Flat_mesh& m, const std::vector<std::vector<Index> >& neighbors, const std::vector<char>& is_corner)
    : m_(m), neighbors_(neighbors), is_corner_(is_corner) {}

  // Returns the vertices where a line turns by more than 60 degrees, and more than at the vertices around. `is_candidate(v)` returns
  // whether `v` is a vertex inside a line between patches.
  template <class Is_candidate>
  std::vector<Index> run(const Is_candidate& is_candidate)
  {
    cosine_.assign(neighbors_.size(), 1);
    for (std::size_t v = 0; v < neighbors_.size(); ++v)
      if (is_candidate(Index(v)))
        cosine_[v] = cosine_of_turn(Index(v));
    std::vector<Index> result;
    for (std::size_t v = 0; v < neighbors_.size(); ++v)
      if (cosine_[v] < 0.5 && is_sharpest(Index(v)))
        result.push_back(Index(v));
    return result;
  }

private:
  // Zigzags turn the direction of 8 edges by less than 30 degrees.
  static constexpr std::size_t edges_aside = 8;
  // Fewer edges before the end of a line have no direction but that of the zigzag.
  static constexpr std::size_t min_edges_aside = 2;

  // Returns the vertices from `v` along at most `edges` edges of the line, up to a corner or around a loop.
  std::vector<Index> walk(Index v, std::size_t side, std::size_t edges) const
  {
    std::vector<Index> vertices(1, v);
    Index previous = v, at = neighbors_[v][side];
    vertices.push_back(at);
    while (vertices.size() <= edges && !is_corner_[at] && at != v) {
      const Index next = neighbors_[at][neighbors_[at][0] == previous];
      previous = at;
      at = next;
      vertices.push_back(at);
    }
    return vertices;
  }

  // Returns the number of edges that determine the direction on each side: at most a quarter of a loop.
  std::size_t edges_beside(Index v) const
  {
    const std::vector<Index> around = walk(v, 0, 4 * edges_aside);
    return around.back() == v ? (std::max)((around.size() - 1) / 4, std::size_t(1)) : edges_aside;
  }

  double cosine_of_turn(Index v) const
  {
    const std::size_t edges = edges_beside(v);
    const std::vector<Index> before = walk(v, 0, edges), after = walk(v, 1, edges);
    const std::size_t m = before.size() - 1, n = after.size() - 1;
    if ((std::min)(m, n) < (std::min)(edges, min_edges_aside))
      return 1;
    const auto cosine = [&](std::size_t i, std::size_t j) {
      const Vector a = direction(before, i), b = direction(after, j);
      return -dot(a, b) / std::sqrt(dot(a, a) * dot(b, b));
    };
    return (std::max)(cosine(m, n), cosine((m + 1) / 2, (n + 1) / 2));
  }

  // Returns the direction of the regression line of the vertices on the first edges of a walk.
  Vector direction(const std::vector<Index>& vertices, std::size_t edges) const
  {
    Vector sum{{0, 0, 0}};
    for (std::size_t i = 0; i <= edges; ++i)
      sum = sum + (double(i) - 0.5 * double(edges)) * m_.points[vertices[i]];
    return sum;
  }

  bool is_sharpest(Index v) const
  {
    const std::size_t edges = edges_beside(v);
    for (const std::size_t side : {0, 1})
      for (const Index w : walk(v, side, edges))
        if (cosine_[w] < cosine_[v] || (cosine_[w] == cosine_[v] && w < v))
          return false;
    return true;
  }

  const Flat_mesh& m_;
  const std::vector<std::vector<Index> >& neighbors_;
  const std::vector<char>& is_corner_;
  std::vector<double> cosine_; // of the turn at each vertex
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_SMOOTHED_TURNS_H
