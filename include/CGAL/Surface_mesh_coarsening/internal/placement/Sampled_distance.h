// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_SAMPLED_DISTANCE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_SAMPLED_DISTANCE_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Nearest_point_search.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Input_surface.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The distance between a surface and coarse meshes, measured as in `measure_coarsening()`: samples of each surface find their
// nearest points on the other surface. The samples of the surface are the same for all meshes. The samples of a fit are not
// suitable for this comparison, because the vertices have been fitted to them and their feet are local.
class Sampled_distance
{
public:
  // `triangles` is about the number of triangles of the coarse meshes.
  Sampled_distance(const Clustered_faces& surface, std::size_t triangles)
    : surface_(surface), number_((std::max)(samples_per_triangle * triangles, min_samples)),
      on_surface_(surface.input().mesh, surface.labels().labels(), surface.number_of_clusters())
  {}

  // Returns the mean squared distance of the direction in which it is larger.
  double squared(const std::vector<Triangle>& triangles, const std::vector<Vector>& positions) const
  {
    const Coarse_mesh_search on_coarse(triangles, positions);
    const Cluster_labels& labels = surface_.labels();
    return (std::max)(mean(surface_.input().mesh, on_coarse, [&](Index f) { return labels[f]; }),
                      mean(on_coarse.mesh(), on_surface_, [&](Index t) { return on_coarse.first_corner(t); }));
  }

private:
  static constexpr std::size_t samples_per_triangle = 3, min_samples = 4000;

  // `group(face)` is the group in which the search for points of a face begins.
  template <class Search, class Group>
  double mean(const Flat_mesh& from, const Search& to, const Group& group) const
  {
    const Cancellation_point& cancellation = surface_.cancellation();
    const Input_surface samples(from);
    std::vector<Input_point> points;
    points.reserve(number_);
    samples.for_each_sample(number_, samples.area(cancellation), cancellation,
                            [&](const Input_point& p) { points.push_back(p); });
    std::vector<double> squares(points.size());
    for_each_chunk(surface_.execution(), points.size(), 64, cancellation,
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     for (std::size_t i = begin; i < end; ++i)
                       squares[i] = to(points[i].position, group(points[i].face)).squared_distance;
                   });
    double sum = 0;
    for (const double square : squares)
      sum += square;
    return squares.empty() ? 0 : sum / double(squares.size());
  }

  const Clustered_faces& surface_;
  const std::size_t number_;
  const Nearest_point_search on_surface_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_SAMPLED_DISTANCE_H
