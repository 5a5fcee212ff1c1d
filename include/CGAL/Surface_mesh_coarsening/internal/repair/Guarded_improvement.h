// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_GUARDED_IMPROVEMENT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_GUARDED_IMPROVEMENT_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Coarse_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Surface_fit.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Placement_faults.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The worth of angles when a mesh is repaired: see `Coarse_mesh::worth()`. With 2, the mean angle falls.
constexpr double rate_of_repaired = 5;

// Improves a repaired mesh by movements of single vertices and flips of single edges. Each is made if the squared distance in both
// directions, minus the worth of the angles, decreases and no fault results.
class Guarded_improvement
{
public:
  Guarded_improvement(Coarse_mesh& mesh, Placement_faults& faults, Repair_budget& budget)
    : mesh_(mesh), faults_(faults), budget_(budget)
  {}

  // Moves vertices back towards their positions before the repair: not all perturbed vertices had to move, and later changes may have
  // removed obstacles. Moves the corners of narrow triangles towards the means of their neighbors. If the mesh was fitted, flips edges
  // around vertices that the repair has changed; where other meshes are symmetric, rounding errors could decide which ones.
  void improve_changes(const std::vector<Triangle>& triangles_before, const std::vector<Vector>& positions_before, bool is_fitted)
  {
    constexpr int times = 3;
    const auto is_narrow = [&](Index t) { return mesh_.angle(t) < min_angle; };
    const std::vector<char> is_changed = changed_vertices(triangles_before, positions_before);
    std::vector<char> may_move(is_changed.size(), is_fitted);
    for (Index v = 0; v < may_move.size(); ++v)
      may_move[v] = may_move[v] || is_changed[v] || std::any_of(mesh_.around(v).begin(), mesh_.around(v).end(), is_narrow);
    mesh_.find_feet_around(may_move);
    measure();
    for (int i = 0; i < times; ++i)
      for (Index v = 0; v < is_changed.size(); ++v) {
        if (mesh_.point(v) != positions_before[v])
          move_towards(v, positions_before[v]);
        const std::vector<Index>& around = mesh_.around(v);
        if (!mesh_.is_on_border(v) && std::any_of(around.begin(), around.end(), is_narrow))
          move_towards(v, mesh_.mean_of_neighbors(v, mesh_.positions()));
        if (is_fitted && is_changed[v])
          flip_around(v);
      }
  }

  // Fits the vertices again. Each moves alone towards the solution of the fit. Vertices on lines stay, because single ones could pass
  // their neighbors.
  void fit_again()
  {
    constexpr int rounds = 3;
    std::vector<Vector>& positions = mesh_.positions();
    const std::vector<Vector> repaired = positions;
    Surface_fit fit(mesh_);
    positions = repaired; // the construction fits the lines
    for (int i = 0; i < rounds; ++i) {
      fit.find_feet(1);
      measure();
      const std::vector<Vector> before = positions;
      fit.move_vertices(tolerance);
      const std::vector<Vector> wanted = std::exchange(positions, before);
      for (Index v = 0; v < wanted.size(); ++v)
        if (!mesh_.is_on_border(v))
          move_towards(v, wanted[v]);
    }
  }

private:
  static constexpr double tolerance = 1e-3; // of the solution
  // A change is made if it gains this part of the mean cost of a triangle.
  static constexpr double least_gain = 2e-3;
  // Rounding errors must not decide. On planes, all costs are below this part of the square of the area of a triangle; in symmetric
  // meshes, angles before and after a change differ by less than the second number.
  static constexpr double rounding = 1e-18, equal_angles = 1e-9;
  // Vertices of more triangles stay, because they would take quadratic time.
  static constexpr std::size_t max_valence = 100;

  void measure()
  {
    const double area = mesh_.samples().area() / double(mesh_.triangles().size());
    worth_ = mesh_.worth(rate_of_repaired);
    min_gain_ = least_gain * mesh_.mean_cost() + rounding * area * area;
  }

  std::vector<char> changed_vertices(const std::vector<Triangle>& triangles, const std::vector<Vector>& positions) const
  {
    std::vector<char> is_changed(positions.size());
    for (Index v = 0; v < positions.size(); ++v)
      is_changed[v] = mesh_.point(v) != positions[v];
    for (Index t = 0; t < triangles.size(); ++t)
      if (triangles[t] != mesh_.triangle(t))
        for (const Index v : mesh_.triangle(t))
          is_changed[v] = true;
    return is_changed;
  }

  void spend(std::size_t tests)
  {
    mesh_.context().poll(tests);
    budget_.spend(tests);
  }

  // Returns the value that a change of some triangles must fall below.
  double limit(const std::vector<Index>& triangles) const { return mesh_.cost_of(triangles, worth_) - min_gain_; }

  // Returns whether a change of some triangles at a vertex has made no fault.
  bool makes_no_fault(Index v, const std::vector<Index>& altered)
  {
    faults_.look_around({v});
    const long before = faults_.number_of(altered);
    return faults_.number_after_change(altered, before + 1) <= before;
  }

  void move_towards(Index v, const Vector& wanted)
  {
    std::vector<Index> altered = mesh_.around(v);
    if (altered.size() > max_valence || budget_.is_spent_for_repair())
      return;
    sort_unique(altered);
    spend(altered.size() * altered.size());
    const double most = limit(altered), angle = mesh_.angle_of(altered);
    const Vector from = mesh_.point(v);
    for (const double part : {1., 0.5, 0.25}) {
      const Vector to = mesh_.within_bounds(v, without_last_digits(from + part * (wanted - from)));
      const auto is_better = [&]() {
        if (!(mesh_.cost_of(altered, worth_) < most && mesh_.angle_of(altered) >= angle - equal_angles))
          return false;
        faults_.follow(v);
        return makes_no_fault(v, altered);
      };
      const bool has_moved = mesh_.move_if(v, to, is_better);
      faults_.follow(v);
      if (has_moved) {
        faults_.update(altered);
        return;
      }
    }
  }

  void flip_around(Index v)
  {
    const std::vector<Index> around = mesh_.around(v);
    for (const Index t : around)
      for (int i = 0; i < 3; ++i) {
        const Index u = mesh_.across(t, i);
        if (u != NONE && mesh_.may_flip(t, i, u) && !budget_.is_spent_for_repair())
          flip_if_better(t, i, u);
      }
  }

  void flip_if_better(Index t, int i, Index u)
  {
    const std::vector<Index> altered{(std::min)(t, u), (std::max)(t, u)};
    const Triangle old_t = mesh_.triangle(t), old_u = mesh_.triangle(u);
    const double most = limit(altered), angle = mesh_.angle_of(altered);
    mesh_.flip(t, i, u);
    const double allowed = most + worth_(mesh_.angle(t)) + worth_(mesh_.angle(u));
    spend(altered.size() * altered.size());
    if (mesh_.angle_of(altered) >= angle - equal_angles && allowed > 0 &&
        mesh_.samples().cost_instead(t, u, mesh_.triangle(t), mesh_.triangle(u), allowed, true) < allowed &&
        makes_no_fault(mesh_.triangle(t)[0], altered)) {
      mesh_.samples().redistribute(t, u);
      faults_.update(altered);
    } else {
      mesh_.undo_flip(t, old_t, u, old_u);
    }
  }

  Coarse_mesh& mesh_;
  Placement_faults& faults_;
  Repair_budget& budget_;
  double min_gain_ = 0;
  Angle_worth worth_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_GUARDED_IMPROVEMENT_H
