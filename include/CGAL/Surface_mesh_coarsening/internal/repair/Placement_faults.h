// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_PLACEMENT_FAULTS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_PLACEMENT_FAULTS_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Box_hierarchy.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Box_list.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Triangle_conflicts.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Input_oracle.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Repair_budget.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The faults of a coarse mesh: triangles that intersect where the input does not, and triangles that face away from the surface
// that they approximate.
class Placement_faults
{
public:
  // Maps a position to its coordinates in the output.
  typedef std::function<Vector(const Vector&)> Output_coordinates;

  Placement_faults(const Clustered_faces& surface, Input_oracle& reference, const Flippable_triangulation& coarse,
                   const std::vector<Vector>& positions, const Output_coordinates& output, Repair_budget& budget,
                   const Cancellation_point& cancellation)
    : budget_(budget), cancellation_(cancellation), execution_(surface.execution()), surface_(surface), reference_(reference),
      coarse_(coarse), positions_(positions), output_(output), points_(positions.size())
  {}

  // Finds all faults of the current positions.
  void find()
  {
    for (std::size_t v = 0; v < positions_.size(); ++v)
      follow(Index(v));
    const Triangle_conflict conflict(points_);
    std::vector<Bbox_3> boxes;
    boxes.reserve(coarse_.triangles().size());
    for (const Triangle& t : coarse_.triangles())
      boxes.push_back(conflict.box(t));
    boxes_.build(std::move(boxes));
    pairs_.clear();
    for (const Triangle_pair& pair : conflicting_pairs(coarse_.triangles(), points_, execution_, cancellation_))
      if (!is_in_input(pair))
        pairs_.push_back(pair);
    find_reversed();
  }

  const std::vector<Triangle_pair>& pairs() const { return pairs_; }
  const std::vector<Index>& reversed() const { return reversed_; }
  std::size_t number() const { return pairs_.size() + reversed_.size(); }

  bool are_in_conflict(const Triangle_pair& p) const
  {
    return Triangle_conflict(points_)(coarse_.triangles()[p.first], coarse_.triangles()[p.second]);
  }

  // Returns whether a triangle is reversed or has no area. Where the input has no area, no triangle is reversed.
  bool is_reversed(Index t)
  {
    std::size_t visited = 0;
    const bool result = is_reversed(t, visited);
    spend(visited / 4); // the distance from a face takes a fraction of the time of an exact test
    return result;
  }

  // Returns whether neither the budget nor the maximum number of exact tests of this repair is exhausted.
  bool may_test() const { return tests_ < max_tests && !budget_.is_spent(); }

  // Updates the position of a vertex. The change may be undone if no search has begun since.
  void follow(Index v)
  {
    const Vector q = output_(positions_[v]);
    points_[v] = Exact_point(q[0], q[1], q[2]);
  }

  // Updates the data of triangles after a permanent change.
  void update(const std::vector<Index>& triangles)
  {
    const Triangle_conflict conflict(points_);
    for (const Index t : triangles)
      boxes_.grow(t, conflict.box(coarse_.triangles()[t]));
  }

  // Finds the triangles that changes at some vertices may affect.
  void look_around(const std::vector<Index>& vertices)
  {
    const Triangle_conflict conflict(points_);
    Bbox_3 region;
    for (const Index v : vertices)
      for (const Index t : coarse_.around(v))
        region += conflict.box(coarse_.triangles()[t]);
    for (const Index v : vertices) {
      const Vector q = output_(surface_.cluster_centroid(v));
      region += Bbox_3(q[0], q[1], q[2], q[0], q[1], q[2]);
    }
    region = grown(region, 0.25 * (std::max)({region.x_span(), region.y_span(), region.z_span()}));
    near_.clear();
    boxes_.for_each_overlapping(region, [this](Index t) { near_.push_back(t); });
    cancellation_.poll(near_.size());
    std::sort(near_.begin(), near_.end());
    near_boxes_.resize(near_.size());
    for (std::size_t i = 0; i < near_.size(); ++i)
      near_boxes_.set(i, conflict.box(coarse_.triangles()[near_[i]]));
    last_altered_.clear();
  }

  // Returns the number of faults of some of these triangles; stops when it reaches `limit`.
  long number_of(const std::vector<Index>& altered, long limit)
  {
    const Triangle_conflict conflict(points_);
    update_near_boxes(last_altered_); // their changes may have been undone
    update_near_boxes(altered);
    last_altered_ = altered;
    long faults = 0;
    for (const Index t : altered) {
      const Triangle triangle = coarse_.triangles()[t];
      faults += is_reversed(t);
      if (faults >= limit)
        return faults;
      cancellation_.poll(near_.size());
      spend(near_.size() / 16); // a comparison of boxes takes a fraction of the time of an exact test
      near_boxes_.for_each_overlapping(conflict.box(triangle), [&](std::size_t i) {
        const Index u = near_[i];
        if (u == t || (u < t && std::binary_search(altered.begin(), altered.end(), u)))
          return;
        spend(1);
        if (conflict(triangle, coarse_.triangles()[u]) && !is_in_input({t, u}))
          ++faults;
      });
    }
    return faults;
  }

private:
  // The maximum number of exact tests, or of steps that take as long, in all rounds of a repair together: one or two seconds.
  static constexpr std::size_t max_tests = 8000000;

  void spend(std::size_t tests)
  {
    tests_ += tests;
    budget_.spend(tests);
  }

  void update_near_boxes(const std::vector<Index>& triangles)
  {
    const Triangle_conflict conflict(points_);
    for (const Index t : triangles) {
      const auto place = std::lower_bound(near_.begin(), near_.end(), t);
      if (place != near_.end() && *place == t)
        near_boxes_.set(std::size_t(place - near_.begin()), conflict.box(coarse_.triangles()[t]));
    }
  }

  // The same, for several threads. Adds the number of visited faces of the input to `visited`.
  bool is_reversed(Index t, std::size_t& visited) const
  {
    const Triangle& triangle = coarse_.triangles()[t];
    return reference_.has_area(triangle) &&
           (Triangle_conflict(points_).is_flat(triangle) || reference_.is_against(triangle, positions_, visited));
  }

  void find_reversed()
  {
    reversed_.clear();
    std::vector<char> reversed(coarse_.triangles().size());
    for_each_chunk(execution_, reversed.size(), 256, [&](std::size_t, std::size_t begin, std::size_t end) {
      std::size_t visited = 0;
      for (std::size_t t = begin; t < end; ++t)
        reversed[t] = is_reversed(Index(t), visited);
    });
    for (std::size_t t = 0; t < reversed.size(); ++t)
      if (reversed[t])
        reversed_.push_back(Index(t));
  }

  bool is_in_input(const Triangle_pair& pair)
  {
    return reference_.intersects_itself(coarse_.triangles()[pair.first], coarse_.triangles()[pair.second]);
  }

  Repair_budget& budget_;
  const Cancellation_point cancellation_;
  const Execution execution_;
  const Clustered_faces& surface_;
  Input_oracle& reference_;
  const Flippable_triangulation& coarse_;
  const std::vector<Vector>& positions_;
  const Output_coordinates output_;
  std::vector<Exact_point> points_; // of the vertices, with the coordinates of the output
  Box_hierarchy boxes_;
  std::vector<Triangle_pair> pairs_;
  std::vector<Index> reversed_;
  std::vector<Index> near_;
  Box_list near_boxes_;              // of these triangles
  std::vector<Index> last_altered_; // the triangles of the last count
  std::size_t tests_ = 0;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_PLACEMENT_FAULTS_H
