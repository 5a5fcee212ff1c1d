// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACE_VERTICES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACE_VERTICES_H

#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Places the vertices of the clusters that have a part of the border: on that part, at its sharpest corner if it has
// one, and otherwise half way along it. So the border of the dual is inscribed in that of the mesh.
class Border_placement
{
public:
  Border_placement(const Clustered_surface& surface, std::vector<Vector>& positions)
    : mesh_(surface.input().mesh), labels_(surface.labels()), positions_(positions),
      is_placed_(surface.number_of_clusters(), false)
  {
    std::vector<bool> done(mesh_.number_of_vertices(), false);
    for (std::size_t v = 0; v < mesh_.number_of_vertices(); ++v)
      if (mesh_.is_on_border(Index(v)) && !done[v]) {
        place_along_loop(Index(v));
        for (const Index w : loop_)
          done[w] = true;
      }
  }

  bool is_placed(std::size_t cluster) const { return is_placed_[cluster]; }

private:
  // The label of the face at the border edge that begins at `v`: the first of its star.
  Index label_after(Index v) const { return labels_[mesh_.star[mesh_.first_in_star[v]]]; }

  void place_along_loop(Index v)
  {
    loop_.assign(1, v);
    for (Index w = Flat_mesh_topology::next_on_border(mesh_, v); w != v; w = Flat_mesh_topology::next_on_border(mesh_, w))
      loop_.push_back(w);
    const std::size_t n = loop_.size();
    std::size_t begin = 0; // of a part of the loop that belongs to one cluster
    while (begin < n && label_after(loop_[begin]) == label_after(loop_[(begin + n - 1) % n]))
      ++begin;
    for (std::size_t i = 0; i < n;) {
      std::size_t length = 1; // in edges
      while (label_after(loop_[(begin + i + length) % n]) == label_after(loop_[(begin + i) % n]))
        ++length;
      place_on_part(begin + i, length);
      i += length;
    }
  }

  const Vector& point(std::size_t i) const { return mesh_.points[loop_[i % loop_.size()]]; }

  void place_on_part(std::size_t first, std::size_t edges)
  {
    const Index cluster = label_after(loop_[first % loop_.size()]);
    is_placed_[cluster] = true;
    // Turns of less than 30 degrees are no corners.
    double sharpest = std::cos(30. * 3.14159265358979323846 / 180.);
    double length = 0;
    bool has_corner = false;
    for (std::size_t i = 0; i < edges; ++i) {
      const Vector side = point(first + i + 1) - point(first + i);
      length += std::sqrt(dot(side, side));
      if (i == 0)
        continue;
      const Vector before = point(first + i) - point(first + i - 1);
      const double product = std::sqrt(dot(side, side) * dot(before, before));
      if (product > 0 && dot(side, before) / product < sharpest - 1e-6) {
        sharpest = dot(side, before) / product;
        positions_[cluster] = point(first + i);
        has_corner = true;
      }
    }
    if (!has_corner)
      positions_[cluster] = half_way(first, edges, length);
  }

  Vector half_way(std::size_t first, std::size_t edges, double length) const
  {
    double rest = 0.5 * length;
    for (std::size_t i = 0; i < edges; ++i) {
      const Vector side = point(first + i + 1) - point(first + i);
      const double part = std::sqrt(dot(side, side));
      if (rest <= part && part > 0)
        return point(first + i) + (rest / part) * side;
      rest -= part;
    }
    return point(first + edges / 2);
  }

  const Flat_mesh& mesh_;
  const Cluster_labels& labels_;
  std::vector<Vector>& positions_;
  std::vector<bool> is_placed_; // per cluster
  std::vector<Index> loop_;
};

// One position per cluster, those on the border on it, the others as `placement` says.
template <class VertexPlacement>
std::vector<Vector> place_vertices(const Clustered_surface& surface, const VertexPlacement& placement)
{
  std::vector<Vector> positions(surface.number_of_clusters());
  const Border_placement border(surface, positions);
  for (std::size_t x = 0; x < positions.size(); ++x)
    if (!border.is_placed(x))
      positions[x] = placement(surface, x);
  return positions;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACE_VERTICES_H
