// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_COMPLETE_MESH_IMPL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_COMPLETE_MESH_IMPL_H

#include <CGAL/Surface_mesh_coarsening/internal/base/inline.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh_builder.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/complete_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Raises the deviations of faces near the border in proportion to the curvature of the border, at most to four times the
// largest deviation. The largest deviation scales the densities and does not change.
//
// Where the border has the radius of curvature R, its parallel curve at distance s on the outer side has radius R + s. The raised
// deviation is proportional to the angle by which this parallel curve turns between neighboring faces.
class Border_deviations
{
public:
  explicit Border_deviations(const Flat_mesh& m, const Run_context& context = Run_context())
    : mesh_(m), context_(context), radius_(m.number_of_vertices(), std::numeric_limits<double>::infinity()),
      reach_(m.number_of_vertices(), 0)
  {}

  void raise(std::vector<double>& deviations)
  {
    measure_border();
    spread();
    const double most = max_raised * largest_of(deviations);
    for (std::size_t f = 0; f < deviations.size(); ++f) {
      context_.poll();
      double radius = std::numeric_limits<double>::infinity();
      for (const Index c : mesh_.corners(f))
        radius = (std::min)(radius, radius_[mesh_.corner_vertex[c]]);
      if (!(radius < std::numeric_limits<double>::infinity()))
        continue;
      const double turn = strength * std::sqrt(face_area(mesh_, Index(f)));
      if (turn > deviations[f] * radius)
        deviations[f] = turn < most * radius ? turn / radius : most;
    }
  }

private:
  // The number of border edges on each side of a vertex between which the turning angle is measured; with fewer edges, the zigzag
  // of triangles contributes.
  //! [border]
  static constexpr std::size_t edges_aside = 3;
  // The range of a border relative to the length of its loop: a small hole needs few vertices, even if it has a large
  // curvature.
  static constexpr double far = 0.1;
  // In a regular mesh of triangles of area 1, the distance between two faces around a vertex is 1.09 on average, and
  // the distance of a circle from an inscribed polygon is sqrt(6) times the distance from the best polygon. This gives
  // 2.7. But the remaining distance of the border extends over the whole border, and the distance of the surface occurs
  // mostly where densities are low. With these two constants, measured on open meshes, both distances are about equal.
  static constexpr double strength = 32;
  static constexpr double max_raised = 4;
  //! [border]

  void measure_border()
  {
    std::vector<bool> done(mesh_.number_of_vertices(), false);
    for (std::size_t v = 0; v < done.size(); ++v) {
      if (!mesh_.is_on_border(Index(v)) || done[v])
        continue;
      std::vector<Index> loop;
      double perimeter = 0;
      for (Index w = Index(v); !done[w];) {
        context_.poll();
        done[w] = true;
        loop.push_back(w);
        const Index next = mesh_.next_on_border(w);
        perimeter += distance(w, next);
        w = next;
      }
      measure_loop(loop, perimeter);
    }
  }

  void measure_loop(const std::vector<Index>& loop, double perimeter)
  {
    const std::size_t n = loop.size(), k = (std::max)(std::size_t(1), (std::min)(edges_aside, n / 4));
    for (std::size_t i = 0; i < n; ++i) {
      const Index before = loop[(i + n - k) % n], at = loop[i], after = loop[(i + k) % n];
      const double a = distance(before, at), b = distance(at, after);
      if (!(a > 0 && b > 0))
        continue;
      const Vector d = (1 / a) * (mesh_.points[at] - mesh_.points[before]) - (1 / b) * (mesh_.points[after] - mesh_.points[at]);
      const double turn = length(d);
      if (!(turn > straight))
        continue;
      radius_[at] = 0.5 * (a + b) / turn;
      reach_[at] = radius_[at] + far * perimeter;
    }
  }

  // Computes for each vertex near the border the smallest radius of the parallels through it: Dijkstra's algorithm with
  // the lengths of edges and of face diagonals.
  void spread()
  {
    typedef std::pair<double, Index> Entry;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
    for (std::size_t v = 0; v < radius_.size(); ++v)
      if (radius_[v] < reach_[v])
        queue.push({radius_[v], Index(v)});
    while (!queue.empty()) {
      const Entry entry = queue.top();
      queue.pop();
      const Index v = entry.second;
      if (entry.first > radius_[v])
        continue;
      context_.poll(mesh_.first_in_star[v + 1] - mesh_.first_in_star[v]);
      for (const Index f : mesh_.faces_around(v))
        for_each_neighbor(f, v, [&](Index w) {
          const double radius = entry.first + distance(v, w);
          if (radius <= reach_[v] && radius < radius_[w]) {
            radius_[w] = radius;
            reach_[w] = reach_[v];
            queue.push({radius, w});
          }
        });
    }
  }

  // Visits all vertices of a triangle or quadrilateral. Of a larger face, visits only the two adjacent vertices, which keeps the
  // time linear.
  template <class Visit>
  void for_each_neighbor(Index f, Index v, const Visit& visit) const
  {
    const Index c = mesh_.corner_of(f, v), before = mesh_.previous_corner(f, c), after = mesh_.next_corner(f, c);
    visit(mesh_.corner_vertex[before]);
    visit(mesh_.corner_vertex[after]);
    if (mesh_.degree(f) == 4)
      visit(mesh_.corner_vertex[mesh_.next_corner(f, after)]);
  }

  double distance(Index v, Index w) const { return length(mesh_.points[w] - mesh_.points[v]); }

  static constexpr double straight = 1e-6;
  const Flat_mesh& mesh_;
  const Run_context context_;
  std::vector<double> radius_, reach_; // per vertex; the largest radius to propagate
};

CGAL_SURFACE_MESH_COARSENING_INLINE void complete_topology(Flat_mesh& mesh, std::size_t number_of_vertices,
                                                           const Run_context& context)
{
  Flat_mesh_topology::complete(mesh, number_of_vertices, context);
}

CGAL_SURFACE_MESH_COARSENING_INLINE void complete_stars(Flat_mesh& mesh, std::size_t number_of_vertices,
                                                        const Run_context& context)
{
  Flat_mesh_topology::complete_stars(mesh, number_of_vertices, context);
}

CGAL_SURFACE_MESH_COARSENING_INLINE std::vector<double> compute_densities(const Flat_mesh& mesh, double maximum, bool at_borders,
                                                                          const Run_context& context)
{
  std::vector<double> densities = mean_normal_deviations(mesh, context);
  const double largest = largest_of(densities);
  if (at_borders)
    Border_deviations(mesh, context).raise(densities);
  map_to_densities(densities, largest, maximum);
  return densities;
}

// Computes the centroids of the faces if one face has a large part of all corners. In other meshes, computing them takes less
// time than reading.
inline void store_centroids_if_slow(Clustering_input& input, const Run_context& context)
{
  constexpr std::size_t many_corners = 64, part = 64;
  const Flat_mesh& m = input.mesh;
  std::size_t most = 0;
  for (std::size_t f = 0; f < m.number_of_faces(); ++f)
    most = (std::max)(most, std::size_t(m.degree(Index(f))));
  if (most < many_corners || part * most < m.corner_vertex.size())
    return;
  std::vector<Vector> centroids(m.number_of_faces());
  for_each_number(context, centroids.size(), [&](Index f) { centroids[f] = input.centroid(f); });
  input.item_centroid.swap(centroids);
}

CGAL_SURFACE_MESH_COARSENING_INLINE void compute_areas_and_centroids(Clustering_input& input, const Run_context& context)
{
  input.area.resize(input.mesh.number_of_faces());
  for_each_number(context, input.area.size(), [&](Index f) { input.area[f] = face_area(input.mesh, f); });
  store_centroids_if_slow(input, context);
}

CGAL_SURFACE_MESH_COARSENING_INLINE Clustering_input cut_input(const Clustering_input& whole, Flat_mesh pieces,
                                                               const std::vector<Index>& whole_face, const Run_context& context)
{
  Clustering_input result;
  result.mesh = std::move(pieces);
  result.density.reserve(whole_face.size());
  result.parent.reserve(whole_face.size());
  for (const Index f : whole_face) {
    result.density.push_back(whole.density[f]);
    result.parent.push_back(whole.parent_of(f));
  }
  compute_areas_and_centroids(result, context);
  return result;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_COMPLETE_MESH_IMPL_H
