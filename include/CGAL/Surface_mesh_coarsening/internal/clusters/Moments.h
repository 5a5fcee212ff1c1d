// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_MOMENTS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_MOMENTS_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The mass of a set of faces, their centroid (7), and the inertia about it; the energy (8) is a multiple of the
// inertia.
struct Moments
{
  double mass = 0;            // sum r A
  Vector centroid{{0, 0, 0}}; // sum r A g / mass
  double inertia = 0;         // sum r A |g - centroid|^2
};

// Returns the inertia of the union of two sets minus their own inertias (parallel axis theorem).
inline double inertia_between(const Moments& a, const Moments& b)
{
  const double mass = a.mass + b.mass;
  const Vector d = b.centroid - a.centroid;
  return mass > 0 ? a.mass * b.mass / mass * dot(d, d) : 0;
}

// Computes the moments of the clusters; `moments` begin with zero. `also(x, f)` is called once for each face `f` and
// the sums `x` of its cluster.
template <class Derived, class Also>
void add_up_moments(const Clustering_input& input, const Cluster_labels& labels, std::vector<Derived>& moments,
                    const Cancellation_point& cancellation, Execution execution, const Also& also)
{
  const std::vector<Index>& clusters = labels.labels();
  for_each_in_groups(execution, clusters, moments.size(), cancellation, [&](Index f) {
    Moments& x = moments[clusters[f]];
    x.mass += input.mass(f);
    x.centroid = x.centroid + input.mass(f) * input.centroid(f);
  });
  for (Moments& x : moments)
    if (x.mass > 0)
      x.centroid = (1 / x.mass) * x.centroid;
  for_each_in_groups(execution, clusters, moments.size(), cancellation, [&](Index f) {
    Derived& x = moments[clusters[f]];
    const Vector d = input.centroid(f) - x.centroid;
    x.inertia += input.mass(f) * dot(d, d);
    also(x, f);
  });
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_MOMENTS_H
