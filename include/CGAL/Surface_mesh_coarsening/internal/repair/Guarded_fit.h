// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_GUARDED_FIT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_GUARDED_FIT_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Coarse_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Surface_fit.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Input_oracle.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Placement_faults.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Fits the vertices of a repaired mesh again. Each vertex moves alone towards the solution of the fit, as far as the squared distance
// in both directions, minus the worth of the angles, decreases and no fault results.
class Guarded_fit
{
public:
  Guarded_fit(Coarse_mesh& mesh, const Placement_faults::Output_coordinates& output, Repair_budget& budget)
    : mesh_(mesh), reference_(mesh.surface(), budget),
      faults_(mesh.surface(), reference_, mesh, mesh.positions(), output, budget)
  {
    budget.begin_repair(); // the input is tested again
  }

  // Updates the remaining faults of a repair.
  void run(Repair_counts& counts)
  {
    constexpr int rounds = 3;
    // The worth of one radian, relative to the mean cost of a triangle. With 2 instead of 5, the mean angle falls.
    constexpr double rate = 5;
    faults_.find();
    std::vector<Vector>& positions = mesh_.positions();
    const std::vector<Vector> repaired = positions;
    Surface_fit fit(mesh_);
    positions = repaired; // the construction fits the lines
    mesh_.samples().find_feet_everywhere();
    for (int i = 0; i < rounds; ++i) {
      fit.find_feet(1);
      mean_cost_ = mesh_.mean_cost();
      worth_ = {rate * mean_cost_, narrow_part * mean_cost_};
      const std::vector<Vector> before = positions;
      fit.move_vertices(tolerance);
      move_towards(std::exchange(positions, before));
    }
    counts.intersections_left = faults_.pairs();
    counts.reversals_left = faults_.reversed().size();
  }

private:
  static constexpr double tolerance = 1e-3; // of the solution
  // A movement is made if it gains this part of the mean cost of a triangle.
  static constexpr double least_gain = 2e-3;

  // Vertices on lines stay, because single ones could pass their neighbors.
  void move_towards(const std::vector<Vector>& wanted)
  {
    for (Index v = 0; v < wanted.size(); ++v)
      if (!mesh_.is_on_border(v))
        move_towards(v, wanted[v]);
  }

  void move_towards(Index v, const Vector& wanted)
  {
    std::vector<Index> altered = mesh_.around(v);
    sort_unique(altered);
    faults_.look_around({v});
    const long faults = faults_.number_of(altered);
    const double limit = mesh_.cost_of(altered, worth_) - least_gain * mean_cost_;
    const double angle = least_angle(altered);
    const Vector from = mesh_.point(v);
    const auto is_better = [&]() {
      faults_.follow(v);
      return mesh_.cost_of(altered, worth_) < limit && least_angle(altered) >= angle &&
             faults_.number_after_change(altered, faults + 1) <= faults;
    };
    for (const double part : {1., 0.5}) {
      if (mesh_.move_if(v, mesh_.within_bounds(v, without_last_digits(from + part * (wanted - from))), is_better)) {
        faults_.update(altered);
        return;
      }
      faults_.follow(v);
    }
  }

  // Returns the smallest angle of some triangles, at most the least angle that other changes may create.
  double least_angle(const std::vector<Index>& triangles) const
  {
    double least = min_angle;
    for (const Index t : triangles)
      least = (std::min)(least, mesh_.angle(t));
    return least;
  }

  Coarse_mesh& mesh_;
  Input_oracle reference_;
  Placement_faults faults_;
  double mean_cost_ = 0; // of a triangle, in this round
  Angle_worth worth_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_GUARDED_FIT_H
