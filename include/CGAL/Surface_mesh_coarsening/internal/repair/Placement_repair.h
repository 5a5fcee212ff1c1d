// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_PLACEMENT_REPAIR_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_PLACEMENT_REPAIR_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Coarse_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Placement_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Trial_fan.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Guarded_improvement.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Input_oracle.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Placement_faults.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Repair_budget.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Repair_proposals.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Moves vertices and flips edges of a coarse mesh where triangles intersect that do not in the input, and where triangles face
// away from the surface that they approximate. For each fault, the repair tries many small changes: it moves vertices towards the
// centroids of their clusters or towards their neighbors, vertices on feature lines towards the middle of their part of the line,
// moves vertices along the normal of the surface, and flips edges. It makes the change that increases the distance least for each
// fault that it removes; new triangles with small angles count as distance. If there are many times more faults than triangles,
// it changes nothing, because local changes would not remove them.
class Placement_repair
{
public:
  typedef Placement_faults::Output_coordinates Output_coordinates;

  // `surface` has the current clusters.
  Placement_repair(Coarse_mesh& mesh, const Clustered_faces& surface, const Output_coordinates& output, Repair_budget& budget)
    : mesh_(mesh), surface_(surface), positions_(mesh.positions()), reference_(surface, budget),
      faults_(mesh, reference_, output, budget), distance_(mesh, surface), budget_(budget)
  {}

  Repair_counts run(const Placement_model& placement)
  {
    surface_.context().stage_begins(Coarsening_stage::REPAIR);
    at_input_vertices_ = placement.is_at_input_vertices;
    Repair_counts counts;
    budget_.begin_repair();
    faults_.find();
    counts.intersections_found = faults_.pairs().size();
    counts.reversals_found = faults_.number() - counts.intersections_found;
    if (faults_.number() > 0 && faults_.number() <= max_faults_of_triangle * mesh_.triangles().size()) {
      const std::vector<Vector> positions = positions_;
      const std::vector<Triangle> triangles = mesh_.triangles();
      search();
      if (!at_input_vertices_) {
        Guarded_improvement improvement(mesh_, faults_, budget_);
        improvement.improve_changes(triangles, positions, placement.fitted.has_value());
        if (placement.fitted && has_moved_many(positions))
          improvement.fit_again();
      }
    }
    counts.intersections_left = faults_.pairs();
    counts.reversals_left = faults_.reversed().size();
    surface_.context().stage_ends(Coarsening_stage::REPAIR);
    return counts;
  }

private:
  static constexpr std::size_t max_rounds = 20, max_faults_of_triangle = 8;
  static constexpr std::size_t kinds_of_perturbation = 3; // outwards, back, inwards
  static constexpr std::size_t comparisons_of_test = 48; // bounds of distances that take as long as an exact test
  // The increase of the distance that a triangle without area is worth, as a part of the distance around the fault.
  static constexpr double harm_of_narrowness = 1;

  // The number of faults that a change removes, and the increase of the squared distance from the input, with the harm done to
  // the angles.
  struct Effect
  {
    long gain = 0;
    double harm = 0;
  };

  // Ends with the smallest number of faults that was reached.
  void search()
  {
    const std::size_t found = faults_.number();
    std::size_t least = found, rounds_without_gain = 0;
    std::vector<Triangle> best_triangles = mesh_.triangles();
    std::vector<Vector> best_positions = positions_;
    for (std::size_t round = 0; round < max_rounds && faults_.number() > 0 && !budget_.is_spent_for_repair(); ++round) {
      prefers_gain_ = round >= 2;
      tries_faces_ = rounds_without_gain >= kinds_of_perturbation;
      const std::vector<Triangle_pair> pairs = faults_.pairs();
      const std::vector<Index> reversed = faults_.reversed();
      // If no vertex can move, only a round with the other preference can change anything.
      if (rounds_without_gain > 0 && !perturb_around(pairs, reversed, rounds_without_gain) && prefers_gain_)
        break;
      repair_faults(pairs, reversed);
      ++rounds_without_gain;
      if (faults_.number() < least) {
        least = faults_.number();
        best_triangles = mesh_.triangles();
        best_positions = positions_;
        rounds_without_gain = 0;
      }
      surface_.context().step_done(Coarsening_stage::REPAIR, found - least, found);
    }
    if (rounds_without_gain > 0) {
      mesh_.restore(best_triangles, best_positions);
      faults_.find();
    }
  }

  void repair_faults(const std::vector<Triangle_pair>& pairs, const std::vector<Index>& reversed)
  {
    for (const Triangle_pair& p : pairs)
      if (!budget_.is_spent_for_repair() && faults_.are_in_conflict(p))
        repair({p.first, p.second});
    for (const Index t : reversed)
      if (!budget_.is_spent_for_repair() && faults_.is_reversed(t))
        repair({t});
  }

  // Makes the best change at a few triangles, if a change reduces the number of faults.
  void repair(const std::vector<Index>& faulty)
  {
    const std::vector<Index> vertices = corners_of(faulty);
    faults_.look_around(vertices);
    last_altered_.clear();
    is_measured_ = false;
    Placement_change best;
    Effect least;
    const Repair_proposals proposals(mesh_, reference_, at_input_vertices_);
    for (const Placement_change& change : proposals.at(faulty, vertices, tries_faces_)) {
      if (budget_.is_spent_for_repair())
        break;
      const Effect effect = effect_of(change, vertices, least);
      if (is_better(effect, least)) {
        least = effect;
        best = change;
      }
    }
    budget_.spend(distance_.take_comparisons() / comparisons_of_test);
    if (least.gain > 0)
      make_for_good(best);
  }

  // Returns whether the repair has moved so many vertices that the others no longer fit them.
  bool has_moved_many(const std::vector<Vector>& before) const
  {
    constexpr std::size_t vertices_of_moved = 10;
    std::size_t moved = 0;
    for (std::size_t v = 0; v < before.size(); ++v)
      moved += positions_[v] != before[v];
    return vertices_of_moved * moved > before.size();
  }

  // At first the change of least harm per removed fault is preferred; if this does not succeed, the change of largest gain.
  bool is_better(const Effect& a, const Effect& b) const
  {
    if (a.gain <= 0 || b.gain <= 0)
      return a.gain > 0;
    if (prefers_gain_ && a.gain != b.gain)
      return a.gain > b.gain;
    // The margin prevents rounding errors from deciding where a mesh is symmetric and harms are equal.
    const double harm = a.harm * double(b.gain), other = b.harm * double(a.gain);
    return other - harm > 1e-9 * (std::abs(harm) + std::abs(other) + distance_.current() * double(a.gain + b.gain));
  }

  std::vector<Index> corners_of(const std::vector<Index>& triangles) const
  {
    std::vector<Index> vertices;
    for (const Index t : triangles)
      for (const Index v : mesh_.triangles()[t])
        if (std::find(vertices.begin(), vertices.end(), v) == vertices.end())
          vertices.push_back(v);
    return vertices;
  }

  // Returns the triangles that a change alters.
  std::vector<Index> altered_by(const Placement_change& change) const
  {
    std::vector<Index> altered;
    for (const Vertex_move& m : change.moves)
      altered.insert(altered.end(), mesh_.around(m.vertex).begin(), mesh_.around(m.vertex).end());
    if (change.flipped != NONE) {
      altered.push_back(change.flipped);
      altered.push_back(mesh_.across(change.flipped, change.corner));
    }
    sort_unique(altered);
    return altered;
  }

  // Stops the computation when the effect is known to be no better than `other`. The distance around the vertices is measured when
  // a change reduces the number of faults: at many faults, no change does.
  Effect effect_of(const Placement_change& change, const std::vector<Index>& vertices, const Effect& other)
  {
    const std::vector<Index> altered = altered_by(change);
    Effect effect;
    const long before = faults_before(altered);
    if (before == 0)
      return effect;
    const long least_gain = prefers_gain_ ? (std::max)(1l, other.gain) : 1;
    during(change, [&] {
      effect.gain = (std::max)(0l, before - faults_.number_after_change(altered, before - least_gain + 1));
    });
    if (effect.gain == 0)
      return effect;
    if (!std::exchange(is_measured_, true))
      distance_.measure_around(vertices);
    during(change, [&] {
      effect.harm = distance_.changed(altered, distance_.current() + max_harm(effect.gain, other)) - distance_.current() +
                    harm_of_narrowing(altered);
    });
    return effect;
  }

  // Makes a change, calls `visit`, and undoes the change.
  template <class Visit>
  void during(const Placement_change& change, const Visit& visit)
  {
    if (change.flipped == NONE) {
      std::vector<Vertex_move> back;
      for (const Vertex_move& m : change.moves)
        back.push_back({m.vertex, positions_[m.vertex]});
      make(change);
      visit();
      make({back, NONE, 0});
    } else {
      const Index t = change.flipped, u = mesh_.across(t, change.corner);
      const Triangle old_t = mesh_.triangles()[t], old_u = mesh_.triangles()[u];
      make(change);
      visit();
      mesh_.undo_flip(t, old_t, u, old_u);
    }
  }

  // Harm limit for pruning: with this gain, an effect of larger harm is not better than `other`.
  double max_harm(long gain, const Effect& other) const
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    if (other.gain <= 0 || (prefers_gain_ && gain > other.gain))
      return infinite;
    // A change that removes fewer faults is not made, but it must not be mistaken for a change without harm.
    return other.harm > 0 ? 1.000001 * other.harm * double(gain) / double(other.gain) : infinite;
  }

  // Returns the harm done to the angles of triangles since their faults were counted.
  double harm_of_narrowing(const std::vector<Index>& altered) const
  {
    return harm_of_narrowness * distance_.current() * (std::max)(0., narrowness_of(altered) - last_narrowness_);
  }

  // Returns the sum of the parts by which the smallest angles of triangles fall below the least angle that flips create.
  double narrowness_of(const std::vector<Index>& triangles) const
  {
    double sum = 0;
    for (const Index t : triangles)
      sum += (std::max)(0., 1 - mesh_.angle(t) / min_angle);
    return sum;
  }

  // Returns the current number of faults of triangles. Changes of the same vertex alter the same triangles.
  long faults_before(const std::vector<Index>& altered)
  {
    if (altered != last_altered_) {
      last_faults_ = faults_.number_of(altered);
      last_narrowness_ = narrowness_of(altered);
      last_altered_ = altered;
    }
    return last_faults_;
  }

  void make(const Placement_change& change)
  {
    for (const Vertex_move& m : change.moves) {
      positions_[m.vertex] = m.to;
      faults_.follow(m.vertex);
    }
    if (change.flipped != NONE)
      mesh_.flip(change.flipped, change.corner, mesh_.across(change.flipped, change.corner));
  }

  void make_for_good(const Placement_change& change)
  {
    const std::vector<Index> altered = altered_by(change);
    make(change);
    faults_.update(altered);
  }

  // If no change has helped, moves the vertices around faults outwards, which thickens thin parts, halfway to the centroids of
  // their clusters, or inwards, which widens gaps, each time farther. Then changes are tried again. When each perturbation has
  // been made once, moves to faces of the clusters are tried, too. Returns whether a vertex has moved.
  bool perturb_around(const std::vector<Triangle_pair>& pairs, const std::vector<Index>& reversed, std::size_t time)
  {
    std::set<Index> vertices;
    const auto add_ring = [&](Index t) {
      for (const Index v : mesh_.triangles()[t])
        for (const Index u : mesh_.around(v))
          vertices.insert(mesh_.triangles()[u].begin(), mesh_.triangles()[u].end());
    };
    for (const Triangle_pair& p : pairs) {
      add_ring(p.first);
      add_ring(p.second);
    }
    for (const Index t : reversed)
      add_ring(t);
    bool has_moved = false;
    for (const Index v : vertices) {
      if (at_input_vertices_ || mesh_.is_on_border(v))
        continue;
      const bool goes_back = time % kinds_of_perturbation == 2;
      const Vector direction = goes_back ? surface_.cluster_centroid(v) - positions_[v]
                                         : size_around(mesh_, positions_, v) * reference_.normal(v);
      const double farther = 0.03 * double(1 + (time - 1) / kinds_of_perturbation);
      const double part = goes_back ? 0.5 : time % kinds_of_perturbation == 1 ? farther : -farther;
      const Vector from = positions_[v];
      make_for_good({{{v, mesh_.within_bounds(v, without_last_digits(from + part * direction))}}, NONE, 0});
      has_moved = has_moved || positions_[v] != from;
    }
    return has_moved;
  }

  Coarse_mesh& mesh_;
  const Clustered_faces& surface_;
  std::vector<Vector>& positions_;
  Input_oracle reference_;
  Placement_faults faults_;
  Trial_distance distance_; // around the current fault
  Repair_budget& budget_;
  std::vector<Index> last_altered_; // the triangles whose faults were counted last before a change
  long last_faults_ = 0;
  double last_narrowness_ = 0;
  bool is_measured_ = false; // the distance around the current fault
  bool prefers_gain_ = false, tries_faces_ = false, at_input_vertices_ = false;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_PLACEMENT_REPAIR_H
