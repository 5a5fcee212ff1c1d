// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_MOMENTS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_MOMENTS_H

#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Clustered_face.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The mass of a set of faces, their centroid (7), and the inertia about the centroid. The energy (8) is a multiple of the
// inertia. The parallel axis theorem gives the moments after a face joins or leaves. A computation from scratch takes two passes
// over the faces, which is more accurate.
struct Moments
{
  double mass = 0;            // sum r A
  Vector centroid{{0, 0, 0}}; // sum r A g / mass
  double inertia = 0;         // sum r A |g - centroid|^2

  // The first pass, its end, and the second pass.
  void add_to_centroid(double m, const Vector& p)
  {
    mass += m;
    centroid = centroid + m * p;
  }
  void end_centroid()
  {
    if (mass > 0)
      centroid = (1 / mass) * centroid;
  }
  void add_to_inertia(double m, const Vector& p) { inertia += m * squared_distance(p); }

  double squared_distance(const Vector& p) const { return squared_length(p - centroid); }

  // Return the inertia after mass `m` has joined or left. `sum` and `rest` are the masses after the move.
  double inertia_with(double m, double sum, double squared_distance) const
  {
    return inertia + (sum > 0 ? m * mass / sum * squared_distance : 0);
  }
  double inertia_without(double m, double rest, double squared_distance) const
  {
    return (std::max)(0., inertia - (rest > 0 ? m * mass / rest * squared_distance : 0));
  }

  void join(double m, const Vector& p)
  {
    const double sum = mass + m;
    inertia = inertia_with(m, sum, squared_distance(p));
    if (sum > 0)
      centroid = centroid + (m / sum) * (p - centroid);
    mass = sum;
  }
  void leave(double m, const Vector& p)
  {
    const double rest = mass - m;
    inertia = inertia_without(m, rest, squared_distance(p));
    if (rest > 0)
      centroid = centroid - (m / rest) * (p - centroid);
    mass = rest;
  }
};

// Returns the inertia of the union of two sets minus their own inertias (parallel axis theorem).
inline double inertia_between(const Moments& a, const Moments& b)
{
  const double mass = a.mass + b.mass;
  return mass > 0 ? a.mass * b.mass / mass * squared_length(b.centroid - a.centroid) : 0;
}

inline Moments joined(const Moments& a, const Moments& b)
{
  Moments s;
  s.mass = a.mass + b.mass;
  if (!(s.mass > 0))
    return a;
  s.centroid = a.centroid + (b.mass / s.mass) * (b.centroid - a.centroid);
  s.inertia = a.inertia + b.inertia + inertia_between(a, b);
  return s;
}

// Computes the masses and centroids of the clusters. `moments` must be zero on entry.
inline void add_up_centroids(const Clustering_input& input, const Cluster_labels& labels, std::vector<Moments>& moments,
                             const Run_context& context)
{
  const std::vector<Index>& clusters = labels.labels();
  for_each_in_groups(context, clusters, moments.size(),
                     [&](Index f) { moments[clusters[f]].add_to_centroid(input.mass(f), input.centroid(f)); });
  for (Moments& x : moments)
    x.end_centroid();
}

// The same with inertias.
inline void add_up_moments(const Clustering_input& input, const Cluster_labels& labels, std::vector<Moments>& moments,
                           const Run_context& context)
{
  const std::vector<Index>& clusters = labels.labels();
  add_up_centroids(input, labels, moments, context);
  for_each_in_groups(context, clusters, moments.size(),
                     [&](Index f) { moments[clusters[f]].add_to_inertia(input.mass(f), input.centroid(f)); });
}

// The base class of energies that measure planes, to which a multiple of the inertia is added.
class Regularized_energy
{
public:
  struct Face_data
  {
    double mass;
    Vector centroid, normal;
  };

  Face_data face_data(const Clustered_face& face) const { return {face.mass(), face.plain_centroid(), face.plain_normal()}; }

protected:
  Regularized_energy(double regularization, const std::string& energy) : regularization_(regularization)
  {
    if (!(regularization > 0) || std::isinf(regularization))
      throw Invalid_input("the regularization of the " + energy + " is " + number_text(regularization));
  }

  double regularization_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_CLUSTERS_MOMENTS_H
