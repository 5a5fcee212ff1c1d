// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_PLACEMENT_FAULTS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_PLACEMENT_FAULTS_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Box_hierarchy.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Triangle_conflicts.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Coarse_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Input_oracle.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Repair_budget.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The faults of a coarse mesh: triangles that intersect where the input does not, and triangles that face away from the surface
// that they approximate. They are found once, and followed through the changes that are made.
class Placement_faults
{
public:
  // Maps a position to its coordinates in the output.
  typedef std::function<Vector(const Vector&)> Output_coordinates;

  Placement_faults(const Coarse_mesh& mesh, Input_oracle& reference, const Output_coordinates& output, Repair_budget& budget)
    : budget_(budget), surface_(reference.surface()), reference_(reference), coarse_(mesh), positions_(mesh.positions()),
      output_(output), exponent_(exponent_of_unit()), points_(positions_.size()), exact_test_(points_)
  {}

  // Finds all faults of the current positions.
  void find()
  {
    for (std::size_t v = 0; v < positions_.size(); ++v)
      follow(Index(v));
    boxes_.build(exact_test_.boxes(coarse_.triangles()));
    conflicts_.assign(coarse_.triangles().size(), {});
    number_of_pairs_ = 0;
    std::size_t work = 0;
    for (const Triangle_pair& pair : conflicting_pairs(coarse_.triangles(), exact_test_, boxes_, surface_.context(), work))
      if (!is_in_input(pair))
        add_pair(pair.first, pair.second);
    budget_.spend(work);
    find_reversed();
  }

  // Returns the pairs of intersecting triangles, in order.
  std::vector<Triangle_pair> pairs() const
  {
    std::vector<Triangle_pair> all;
    for (std::size_t t = 0; t < conflicts_.size(); ++t)
      for (const Index u : conflicts_[t])
        if (t < u)
          all.emplace_back(Index(t), u);
    std::sort(all.begin(), all.end());
    return all;
  }

  // Returns the reversed triangles, in order.
  std::vector<Index> reversed() const
  {
    std::vector<Index> all;
    for (std::size_t t = 0; t < is_reversed_.size(); ++t)
      if (is_reversed_[t])
        all.push_back(Index(t));
    return all;
  }

  std::size_t number() const { return number_of_pairs_ + number_of_reversed_; }

  bool are_in_conflict(const Triangle_pair& p) const
  {
    const std::vector<Index>& others = conflicts_[p.first];
    return std::find(others.begin(), others.end(), p.second) != others.end();
  }

  // Returns whether a triangle is reversed or has no area. Where the input has no area, no triangle is reversed.
  bool is_reversed(Index t) const { return is_reversed_[t]; }

  // Updates the position of a vertex. The change may be undone if no search has begun since.
  void follow(Index v) { points_[v] = in_unit(output_(positions_[v])); }

  // Updates the faults of triangles after a permanent change.
  void update(const std::vector<Index>& triangles)
  {
    for (const Index t : triangles) {
      boxes_.grow(t, exact_test_.box(coarse_.triangles()[t]));
      remove_pairs_of(t);
    }
    for (const Index t : triangles) {
      surface_.context().poll();
      boxes_.for_each_overlapping(exact_test_.box(coarse_.triangles()[t]), [&](Index u) {
        if (u == t || (u < t && std::binary_search(triangles.begin(), triangles.end(), u)))
          return;
        if (is_fault(t, u))
          add_pair(t, u);
      });
      set_reversed(t, is_reversed_now(t));
    }
  }

  // Finds the triangles that changes at some vertices may affect.
  void look_around(const std::vector<Index>& vertices)
  {
    Bbox_3 region;
    for (const Index v : vertices)
      for (const Index t : coarse_.around(v))
        region += exact_test_.box(coarse_.triangles()[t]);
    for (const Index v : vertices)
      region += box_of_point(in_unit(output_(surface_.cluster_centroid(v))));
    region = grown(region, 0.25 * (std::max)({region.x_span(), region.y_span(), region.z_span()}));
    near_.clear();
    boxes_.for_each_overlapping(region, [this](Index t) { near_.push_back(t); });
    surface_.context().poll(near_.size());
    std::sort(near_.begin(), near_.end());
    near_boxes_.resize(near_.size());
    update_near_boxes(near_);
    last_altered_.clear();
  }

  // Returns the number of faults of some triangles, and remembers these faults.
  long number_of(const std::vector<Index>& altered)
  {
    known_pairs_.clear();
    known_reversed_.clear();
    for (const Index t : altered) {
      for (const Index u : conflicts_[t])
        if (t < u || !std::binary_search(altered.begin(), altered.end(), u))
          known_pairs_.emplace_back(t, u);
      if (is_reversed_[t])
        known_reversed_.push_back(t);
    }
    return long(known_pairs_.size() + known_reversed_.size());
  }

  // The same after a change of these triangles; stops when the number reaches `limit`. Only triangles near the place of the search
  // are tested. Most changes do not remove the remembered faults, so these are tested first.
  long number_after_change(const std::vector<Index>& altered, long limit)
  {
    const long left = number_left(limit);
    return left < limit ? number_near(altered, limit) : left;
  }

private:
  // Returns the exponent of the power of two by which coordinates are divided, since the filters of exact tests fail far from 1.
  // The division does not round the smallest coordinates.
  int exponent_of_unit() const
  {
    constexpr int usual = 128, least_normal = -1000;
    int least = (std::numeric_limits<int>::max)(), largest = (std::numeric_limits<int>::min)();
    for (const Vector& p : positions_)
      for (const double x : output_(p))
        if (x != 0) {
          least = (std::min)(least, std::ilogb(x));
          largest = (std::max)(largest, std::ilogb(x));
        }
    if (least > largest || std::abs(largest) <= usual)
      return 0;
    return (std::min)(largest, least - least_normal);
  }

  Vector in_unit(const Vector& p) const
  {
    const auto scaled = [this](double x) { return std::ldexp(x, -exponent_); };
    return exponent_ == 0 ? p : Vector{{scaled(p[0]), scaled(p[1]), scaled(p[2])}};
  }

  bool is_fault(Index t, Index u)
  {
    const bool is_conflict = exact_test_(coarse_.triangles()[t], coarse_.triangles()[u]);
    budget_.spend(exact_test_.take_work());
    return is_conflict && !is_in_input({t, u});
  }

  void add_pair(Index t, Index u)
  {
    conflicts_[t].push_back(u);
    conflicts_[u].push_back(t);
    ++number_of_pairs_;
  }

  void remove_pairs_of(Index t)
  {
    for (const Index u : conflicts_[t]) {
      std::vector<Index>& others = conflicts_[u];
      others.erase(std::find(others.begin(), others.end(), t));
    }
    number_of_pairs_ -= conflicts_[t].size();
    conflicts_[t].clear();
  }

  void set_reversed(Index t, bool is_reversed)
  {
    number_of_reversed_ += std::size_t(is_reversed) - std::size_t(is_reversed_[t]);
    is_reversed_[t] = is_reversed;
  }

  // Returns the number of remembered faults that remain; stops when it reaches `limit`.
  long number_left(long limit)
  {
    long faults = 0;
    for (std::size_t i = 0; i < known_pairs_.size() && faults < limit; ++i)
      faults += is_fault(known_pairs_[i].first, known_pairs_[i].second);
    for (std::size_t i = 0; i < known_reversed_.size() && faults < limit; ++i)
      faults += is_reversed_now(known_reversed_[i]);
    return faults;
  }

  // Returns the number of all faults of some triangles; stops when it reaches `limit`.
  long number_near(const std::vector<Index>& altered, long limit)
  {
    update_near_boxes(last_altered_); // their changes may have been undone
    update_near_boxes(altered);
    last_altered_ = altered;
    long faults = 0;
    for (std::size_t i = 0; i < altered.size() && faults < limit; ++i) {
      const Index t = altered[i];
      surface_.context().poll(near_.size());
      budget_.spend(near_.size() / 16); // a comparison of boxes takes a fraction of the time of an exact test
      near_boxes_.for_each_overlapping(exact_test_.box(coarse_.triangles()[t]), [&](std::size_t n) {
        const Index u = near_[n];
        if (faults >= limit || u == t || (u < t && std::binary_search(altered.begin(), altered.end(), u)))
          return;
        faults += is_fault(t, u);
      });
    }
    for (std::size_t i = 0; i < altered.size() && faults < limit; ++i)
      faults += is_reversed_now(altered[i]);
    return faults;
  }

  void update_near_boxes(const std::vector<Index>& triangles)
  {
    for (const Index t : triangles) {
      const auto place = std::lower_bound(near_.begin(), near_.end(), t);
      if (place != near_.end() && *place == t)
        near_boxes_.set(std::size_t(place - near_.begin()), exact_test_.box(coarse_.triangles()[t]));
    }
  }

  bool is_reversed_now(Index t)
  {
    std::size_t visited = 0;
    const bool result = is_reversed_now(t, visited);
    budget_.spend(visited / 4); // the distance from a face takes a fraction of the time of an exact test
    return result;
  }

  // The same; adds the number of visited faces of the input to `visited`.
  bool is_reversed_now(Index t, std::size_t& visited)
  {
    const Triangle& triangle = coarse_.triangles()[t];
    return reference_.has_area(triangle) &&
           (Triangle_conflict(points_).is_flat(triangle) || reference_.is_against(triangle, positions_, visited));
  }

  void find_reversed()
  {
    is_reversed_.assign(coarse_.triangles().size(), false);
    reference_.prepare(coarse_.triangles(), positions_);
    const Run_context context = surface_.context().uninterrupted();
    for_each_chunk(context, is_reversed_.size(), 256, [&](std::size_t, std::size_t begin, std::size_t end) {
      std::size_t visited = 0;
      for (std::size_t t = begin; t < end; ++t)
        is_reversed_[t] = is_reversed_now(Index(t), visited);
    });
    number_of_reversed_ = std::size_t(std::count(is_reversed_.begin(), is_reversed_.end(), char(true)));
  }

  bool is_in_input(const Triangle_pair& pair)
  {
    return reference_.intersects_itself(coarse_.triangles()[pair.first], coarse_.triangles()[pair.second]);
  }

  Repair_budget& budget_;
  const Clustered_faces& surface_;
  Input_oracle& reference_;
  const Flippable_triangulation& coarse_;
  const std::vector<Vector>& positions_;
  const Output_coordinates output_;
  const int exponent_;
  std::vector<Vector> points_; // of the vertices, with the coordinates of the output in this unit
  const Triangle_conflict exact_test_;
  Box_hierarchy boxes_;
  std::vector<std::vector<Index> > conflicts_; // the triangles that intersect each triangle where the input does not
  std::vector<char> is_reversed_;              // each triangle
  std::size_t number_of_pairs_ = 0, number_of_reversed_ = 0;
  std::vector<Index> near_;
  Box_list near_boxes_;                    // of these triangles
  std::vector<Index> last_altered_;        // the triangles of the last count
  std::vector<Triangle_pair> known_pairs_; // the remembered faults
  std::vector<Index> known_reversed_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_PLACEMENT_FAULTS_H
