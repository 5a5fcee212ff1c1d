// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_PLACEMENT_REPAIR_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_PLACEMENT_REPAIR_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Input_oracle.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Repair_counts.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Repair_proposals.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Triangle_conflicts.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/rounding.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/sort_unique.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Moves vertices of a coarse mesh, and flips edges, where triangles intersect that do not in the input, or face away from the
// surface that they approximate. For each fault, many small changes are tried: moving vertices towards the centroids of their
// clusters or towards their neighbors, or along the normal of the surface, and flipping edges. The change with the least harm
// to the distance per removed fault is made.
class Placement_repair
{
public:
  // Maps positions to coordinates of the output.
  typedef std::function<Vector(const Vector&)> Output_coordinates;

  Placement_repair(const Clustered_surface& surface, const Border_arcs& border, const Output_coordinates& output,
                   std::vector<Triangle>& triangles, std::vector<Vector>& positions, const Cancellation_point& cancellation)
    : cancellation_(cancellation), execution_(surface.execution()), surface_(surface), border_(border), output_(output),
      result_(triangles), positions_(positions), coarse_(triangles, positions.size(), surface.features()), reference_(surface)
  {
    points_.reserve(positions.size());
    for (const Vector& p : positions)
      points_.push_back(point(p));
  }

  // Restricts vertices to positions of input vertices of their clusters.
  void stay_at_input_vertices() { at_input_vertices_ = true; }

  Repair_counts run()
  {
    Repair_counts counts;
    find_faults();
    counts.intersections_found = pairs_.size();
    counts.reversals_found = reversed_.size();
    std::size_t least = number_of_faults(), rounds_in_vain = 0;
    std::vector<Triangle> best_triangles = coarse_.triangles();
    std::vector<Vector> best_positions = positions_;
    for (std::size_t round = 0; is_worth_trying(round, rounds_in_vain); ++round) {
      is_in_hurry_ = round >= 2;
      if (rounds_in_vain > 0)
        shake_around_faults(rounds_in_vain);
      repair_faults();
      find_faults();
      ++rounds_in_vain;
      if (number_of_faults() < least) {
        least = number_of_faults();
        best_triangles = coarse_.triangles();
        best_positions = positions_;
        rounds_in_vain = 0;
      }
    }
    if (counts.intersections_found + counts.reversals_found == 0)
      return counts;
    result_ = best_triangles;
    positions_ = best_positions;
    count_what_is_left(counts);
    return counts;
  }

private:
  static constexpr std::size_t max_rounds = 20;
  // Bounds on the number of exact tests of two triangles whose boxes overlap, in all rounds together, per triangle and in
  // total: a second or two. Faults of sheets that are too close to each other everywhere may remain.
  static constexpr std::size_t max_tests_each = 20000, max_tests = 2000000;
  static constexpr std::size_t max_measured = 500; // triangles

  // The number of faults that a change removes, and the squared distance from the input after it.
  struct Effect
  {
    long gain = 0;
    double harm = 0;
  };
  Exact_point point(const Vector& p) const
  {
    const Vector q = output_(p);
    return Exact_point(q[0], q[1], q[2]);
  }

  bool is_worth_trying(std::size_t round, std::size_t rounds_in_vain) const
  {
    return round < max_rounds && number_of_faults() > 0 && rounds_in_vain < 6 && may_test();
  }

  bool may_test() const { return tests_ < (std::min)(max_tests, max_tests_each * coarse_.triangles().size()); }

  std::size_t number_of_faults() const { return pairs_.size() + reversed_.size(); }

  void find_faults()
  {
    pairs_.clear();
    reversed_.clear();
    for (const Triangle_pair& pair : conflicting_pairs(coarse_.triangles(), points_, execution_, cancellation_))
      if (!is_in_input(pair))
        pairs_.push_back(pair);
    std::vector<char> reversed(coarse_.triangles().size());
    for_each_chunk(execution_, reversed.size(), 256, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t)
        reversed[t] = is_reversed(Index(t));
    });
    for (std::size_t t = 0; t < reversed.size(); ++t)
      if (reversed[t])
        reversed_.push_back(Index(t));
  }

  bool is_in_input(const Triangle_pair& pair)
  {
    return reference_.intersects_itself(coarse_.triangles()[pair.first], coarse_.triangles()[pair.second]);
  }

  // Degenerate triangles count, too. Triangles without area of the input never do.
  bool is_reversed(Index t) const
  {
    const Triangle& triangle = coarse_.triangles()[t];
    return reference_.has_area(triangle) &&
           (Triangle_conflict(points_).is_flat(triangle) || reference_.is_against(triangle, positions_));
  }

  void repair_faults()
  {
    const std::vector<Triangle_pair> pairs = pairs_;
    const std::vector<Index> reversed = reversed_;
    const Triangle_conflict conflict(points_);
    for (const Triangle_pair& p : pairs)
      if (may_test() && conflict(coarse_.triangles()[p.first], coarse_.triangles()[p.second]))
        repair({p.first, p.second});
    for (const Index t : reversed)
      if (may_test() && is_reversed(t))
        repair({t});
  }

  // Makes the best change at a few triangles, if one reduces the faults.
  void repair(const std::vector<Index>& faulty)
  {
    const std::vector<Index> vertices = corners_of(faulty);
    find_near(vertices);
    last_altered_.clear();
    distance_before_ = squared_distance_around(vertices);
    Placement_change best;
    Effect least;
    const Repair_proposals proposals(surface_, border_, coarse_, reference_, positions_, at_input_vertices_);
    for (const Placement_change& change : proposals.at(faulty, vertices)) {
      const Effect effect = effect_of(change, vertices, least);
      if (is_better(effect, least)) {
        least = effect;
        best = change;
      }
    }
    if (least.gain > 0)
      make(best);
  }

  // Changes of least harm come first; later, if faults remain, changes that remove most faults.
  bool is_better(const Effect& a, const Effect& b) const
  {
    if (a.gain <= 0 || b.gain <= 0)
      return a.gain > 0;
    if (is_in_hurry_ && a.gain != b.gain)
      return a.gain > b.gain;
    // On symmetric meshes harms are equal; rounding must not decide.
    const double harm = a.harm * double(b.gain), other = b.harm * double(a.gain);
    return other - harm > 1e-9 * (std::abs(harm) + std::abs(other) + distance_before_ * double(a.gain + b.gain));
  }

  std::vector<Index> corners_of(const std::vector<Index>& triangles) const
  {
    std::vector<Index> vertices;
    for (const Index t : triangles)
      for (const Index v : coarse_.triangles()[t])
        if (std::find(vertices.begin(), vertices.end(), v) == vertices.end())
          vertices.push_back(v);
    return vertices;
  }

  // Returns the triangles that changes at these vertices may affect.
  void find_near(const std::vector<Index>& vertices)
  {
    const Triangle_conflict conflict(points_);
    Bbox_3 region;
    for (const Index v : vertices)
      for (const Index t : coarse_.around(v))
        region += conflict.box(coarse_.triangles()[t]);
    for (const Index v : vertices)
      region += point(surface_.cluster_centroid(v)).bbox();
    const double w = 0.25 * (std::max)({region.x_span(), region.y_span(), region.z_span()});
    region = Bbox_3(region.xmin() - w, region.ymin() - w, region.zmin() - w, region.xmax() + w, region.ymax() + w,
                    region.zmax() + w);
    near_.clear();
    cancellation_.poll(coarse_.triangles().size());
    for (std::size_t t = 0; t < coarse_.triangles().size(); ++t)
      if (do_overlap(region, conflict.box(coarse_.triangles()[t])))
        near_.push_back(Index(t));
  }

  // Returns the triangles that a change alters.
  std::vector<Index> altered_by(const Placement_change& change) const
  {
    std::vector<Index> altered;
    for (const Vertex_move& m : change.moves)
      altered.insert(altered.end(), coarse_.around(m.vertex).begin(), coarse_.around(m.vertex).end());
    if (change.flipped != NONE) {
      altered.push_back(change.flipped);
      altered.push_back(coarse_.across(change.flipped, change.corner));
    }
    sort_unique(altered);
    return altered;
  }

  // Computes only as much as is needed to decide whether the effect is better than another one.
  Effect effect_of(const Placement_change& change, const std::vector<Index>& vertices, const Effect& other)
  {
    const std::vector<Index> altered = altered_by(change);
    Effect effect;
    const long before = faults_before(altered);
    if (before == 0)
      return effect;
    const auto measure = [&] {
      effect.gain = (std::max)(0l, before - faults_of(altered, before));
      if (effect.gain > 0)
        effect.harm = squared_distance_around(vertices, distance_before_ + max_harm(effect.gain, other)) - distance_before_;
    };
    if (change.flipped == NONE) {
      std::vector<Vertex_move> back;
      for (const Vertex_move& m : change.moves)
        back.push_back({m.vertex, positions_[m.vertex]});
      make(change);
      measure();
      make({back, NONE, 0});
    } else {
      const Index t = change.flipped, u = coarse_.across(t, change.corner);
      const Triangle old_t = coarse_.triangles()[t], old_u = coarse_.triangles()[u];
      make(change);
      measure();
      coarse_.undo_flip(t, old_t, u, old_u);
    }
    return effect;
  }

  // Returns the harm limit for pruning: from this harm on, an effect with this gain is not better than another one.
  double max_harm(long gain, const Effect& other) const
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    if (other.gain <= 0 || (is_in_hurry_ && gain > other.gain))
      return infinite;
    // A change that removes fewer faults is not made, but must not count as harmless.
    return other.harm > 0 ? 1.000001 * other.harm * double(gain) / double(other.gain) : infinite;
  }

  // Returns the current number of faults of triangles; changes of the same vertex alter the same triangles.
  long faults_before(const std::vector<Index>& altered)
  {
    if (altered != last_altered_) {
      last_faults_ = faults_of(altered, std::numeric_limits<long>::max());
      last_altered_ = altered;
    }
    return last_faults_;
  }

  // Returns the squared distance of the clusters of some vertices and of adjacent clusters. At vertices of very high valence
  // it would take quadratic time, and is ignored.
  double squared_distance_around(const std::vector<Index>& vertices,
                                 double limit = std::numeric_limits<double>::infinity()) const
  {
    std::vector<Index> triangles, clusters;
    for (const Index v : vertices)
      for (const Index t : coarse_.around(v))
        clusters.insert(clusters.end(), coarse_.triangles()[t].begin(), coarse_.triangles()[t].end());
    sort_unique(clusters);
    for (const Index v : clusters)
      triangles.insert(triangles.end(), coarse_.around(v).begin(), coarse_.around(v).end());
    sort_unique(triangles);
    if (triangles.size() > max_measured)
      return 0;
    std::vector<Triangle> corners;
    corners.reserve(triangles.size());
    for (const Index t : triangles)
      corners.push_back(coarse_.triangles()[t]);
    return reference_.squared_distance(clusters, corners, positions_, limit);
  }

  void make(const Placement_change& change)
  {
    for (const Vertex_move& m : change.moves) {
      positions_[m.vertex] = m.to;
      points_[m.vertex] = point(m.to);
    }
    if (change.flipped != NONE)
      coarse_.flip(change.flipped, change.corner, coarse_.across(change.flipped, change.corner));
  }

  // Returns the number of faults, or at least `limit`.
  long faults_of(const std::vector<Index>& altered, long limit)
  {
    const Triangle_conflict conflict(points_);
    long faults = 0;
    for (const Index t : altered) {
      const Triangle triangle = coarse_.triangles()[t];
      const Bbox_3 box = conflict.box(triangle);
      faults += is_reversed(t);
      if (faults >= limit)
        return faults;
      cancellation_.poll(near_.size());
      tests_ += near_.size() / 16; // a comparison of boxes takes a fraction of a test
      for (const Index u : near_) {
        if (u == t || (u < t && std::binary_search(altered.begin(), altered.end(), u)))
          continue;
        const Triangle& other = coarse_.triangles()[u];
        if (!do_overlap(box, conflict.box(other)))
          continue;
        ++tests_;
        if (conflict(triangle, other) && !is_in_input({t, u}))
          ++faults;
      }
    }
    return faults;
  }

  // If nothing helped, moves the surrounding vertices half way to the centroids of their clusters, outwards, which
  // thickens thin parts, or inwards, which widens gaps; then tries changes again.
  void shake_around_faults(std::size_t time)
  {
    std::set<Index> vertices;
    const auto add_ring = [&](Index t) {
      for (const Index v : coarse_.triangles()[t])
        for (const Index u : coarse_.around(v))
          vertices.insert(coarse_.triangles()[u].begin(), coarse_.triangles()[u].end());
    };
    for (const Triangle_pair& p : pairs_) {
      add_ring(p.first);
      add_ring(p.second);
    }
    for (const Index t : reversed_)
      add_ring(t);
    for (const Index v : vertices) {
      if (at_input_vertices_ || border_.is_on_border(v))
        continue;
      const bool goes_back = time % 3 == 2;
      const Vector way = goes_back ? surface_.cluster_centroid(v) - positions_[v]
                                   : size_around(coarse_, positions_, v) * reference_.normal(v);
      const double part = goes_back ? 0.5 : time % 3 == 1 ? 0.03 : -0.03;
      make({{{v, surface_.within_bounds(v, without_last_digits(positions_[v] + part * way))}}, NONE, 0});
    }
  }

  void count_what_is_left(Repair_counts& counts)
  {
    coarse_ = Flippable_triangulation(result_, positions_.size(), surface_.features());
    for (std::size_t v = 0; v < positions_.size(); ++v)
      points_[v] = point(positions_[v]);
    find_faults();
    counts.intersections_left = pairs_;
    counts.reversals_left = reversed_.size();
  }

  const Cancellation_point cancellation_;
  const Execution execution_;
  const Clustered_surface& surface_;
  const Border_arcs& border_;
  const Output_coordinates output_;
  std::vector<Triangle>& result_;
  std::vector<Vector>& positions_;
  Flippable_triangulation coarse_;
  Input_oracle reference_;
  std::vector<Exact_point> points_; // of the vertices, in coordinates of the output
  std::vector<Triangle_pair> pairs_;
  std::vector<Index> reversed_;
  std::vector<Index> near_;
  std::vector<Index> last_altered_; // the last triangles whose faults were counted before a change
  long last_faults_ = 0;
  std::size_t tests_ = 0;
  double distance_before_ = 0; // around the current fault
  bool is_in_hurry_ = false, at_input_vertices_ = false;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_PLACEMENT_REPAIR_H
