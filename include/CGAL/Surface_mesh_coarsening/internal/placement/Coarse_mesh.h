// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_COARSE_MESH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_COARSE_MESH_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Fit_samples.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Trial_fan.h>
#include <CGAL/Surface_mesh_coarsening/internal/refinement/Cluster_editing.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The mesh that a fit and a repair change, with one vertex per cluster: what all their steps need to know. Refers to the positions, so
// that these are the result.
class Coarse_mesh : public Flippable_triangulation
{
public:
  Coarse_mesh(const Clustered_faces& surface, const Border_arcs& border, const std::vector<Triangle>& triangles,
              std::vector<Vector>& positions, Cluster_relocation* clusters)
    : Flippable_triangulation(triangles, positions.size(), surface.features()), surface_(surface), border_(border),
      clusters_(clusters), positions_(positions)
  {}
  // The samples refer to the mesh.
  Coarse_mesh(const Coarse_mesh&) = delete;

  const Clustered_faces& surface() const { return surface_; }
  const Border_arcs& border() const { return border_; }
  const Run_context& context() const { return surface_.context(); }
  std::vector<Vector>& positions() { return positions_; }
  const std::vector<Vector>& positions() const { return positions_; }
  // The samples are made when they are first needed.
  Fit_samples& samples()
  {
    if (!samples_)
      samples_.emplace(surface_, *this, positions_, std::vector<char>(positions_.size(), true));
    return *samples_;
  }
  const Fit_samples& samples() const { return *samples_; }
  // Finds the feet of the samples after many changes at the marked vertices. If there are no samples yet, makes the samples of their
  // clusters and the neighboring clusters. Their feet are searched everywhere: a descent from the vertex of a cluster could end far
  // from them.
  void find_feet_around(const std::vector<char>& is_marked)
  {
    if (samples_)
      return samples_->find_feet(1);
    samples_.emplace(surface_, *this, positions_, with_neighbors(is_marked));
    samples_->find_feet_everywhere();
  }

  const Triangle& triangle(Index t) const { return triangles()[t]; }
  const Vector& point(Index v) const { return positions_[v]; }
  Vector normal(Index t) const { return normal_of(positions_, triangle(t)); }
  // The smallest angle of a triangle.
  double angle(Index t) const { return smallest_angle(positions_, triangle(t)); }
  // The smallest angle of some triangles, at most the least angle that changes may create.
  double angle_of(const std::vector<Index>& triangles) const
  {
    double least = min_angle;
    for (const Index t : triangles)
      least = (std::min)(least, angle(t));
    return least;
  }
  bool is_on_border(Index v) const { return border_.is_on_border(v); }

  // Whether vertices may leave their clusters, which follow them.
  bool may_relocate() const { return clusters_; }
  Cluster_relocation& clusters() const { return *clusters_; }

  // Returns the nearest admissible position of a vertex.
  Vector within_bounds(Index v, const Vector& p) const
  {
    return clusters_ && clusters_->has_changed(v) ? closest_in_box(p, clusters_->vertex_bounds(v))
                                                  : surface_.within_bounds(v, p);
  }

  // Returns the contribution of some triangles to the squared distance in both directions.
  double cost_of(const std::vector<Index>& triangles) const
  {
    double sum = 0;
    for (const Index t : triangles)
      sum += samples().cost(t);
    return sum;
  }

  // The same without the worth of the angles.
  double cost(Index t, const Angle_worth& worth) const { return samples().cost(t) - worth(angle(t)); }
  double cost_of(const std::vector<Index>& triangles, const Angle_worth& worth) const
  {
    double sum = 0;
    for (const Index t : triangles)
      sum += cost(t, worth);
    return sum;
  }

  // Returns the mean cost of a triangle.
  double mean_cost() const
  {
    double total = 0;
    for (std::size_t t = 0; t < triangles().size(); ++t)
      total += samples().cost(Index(t));
    return total / (std::max)(double(samples().number_of_triangles()), 1.);
  }

  // Returns the worth of angles; `rate` is the worth of one radian, relative to the mean cost of a triangle.
  Angle_worth worth(double rate) const
  {
    const double mean = mean_cost();
    return {rate * mean, narrow_part * mean};
  }

  // Replaces all triangles and positions.
  void restore(const std::vector<Triangle>& triangles, const std::vector<Vector>& positions)
  {
    Flippable_triangulation::operator=(Flippable_triangulation(triangles, positions.size(), surface_.features()));
    positions_ = positions;
  }

  // Moves a vertex and finds the feet around it again. Returns whether `is_better()` holds then; otherwise undoes the movement.
  template <class Is_better>
  bool move_if(Index v, const Vector& to, const Is_better& is_better)
  {
    const Vector from = std::exchange(positions_[v], to);
    samples().redistribute(around(v), around(v));
    if (is_better())
      return true;
    positions_[v] = from;
    samples().redistribute(around(v), around(v));
    return false;
  }

private:
  std::vector<char> with_neighbors(const std::vector<char>& is_marked) const
  {
    std::vector<char> result = is_marked;
    for (const Triangle& t : triangles())
      if (is_marked[t[0]] || is_marked[t[1]] || is_marked[t[2]])
        for (const Index v : t)
          result[v] = true;
    return result;
  }

  const Clustered_faces& surface_;
  const Border_arcs& border_;
  Cluster_relocation* const clusters_; // null without exchanges
  std::vector<Vector>& positions_;
  std::optional<Fit_samples> samples_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_COARSE_MESH_H
