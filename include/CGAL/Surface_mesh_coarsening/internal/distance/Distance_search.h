// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_DISTANCE_SEARCH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_DISTANCE_SEARCH_H

#include <CGAL/Surface_mesh_coarsening/Distance_report.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/number_text.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/Distance_estimate.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/Level_hierarchy.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/hausdorff_bound.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/boxes.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/place_and_exchange.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Searches the levels of a fine clustering for the coarsest result within a distance. If the placement exchanges vertices, also
// searches clusterings for fewer vertices.
class Distance_search
{
public:
  // `quick` is the placement from which `placement` starts, if there is one. `vertices` is the maximum number of
  // clusters.
  Distance_search(Clustering_state& state, const Placement_model& placement, const std::optional<Placement_model>& quick,
                  const Output_coordinates& output_coordinates, double distance, const Minimization_end& end,
                  std::size_t vertices, Distance_report& report)
    : state_(state),
      placement_(placement),
      quick_(quick),
      output_coordinates_(output_coordinates),
      minimization_end_(end),
      vertices_(vertices),
      number_((std::max)(vertices / 16, std::size_t(4))),
      report_(report),
      distance_(distance),
      local_distance_((std::min)(state.frame.length_to_local(distance), max_distance(state.base_input()))),
      surface_(triangles_of(state.base_input().mesh))
  {}

  void run()
  {
    do {
      find_clustering();
      find_level();
    } while (!bound_result());
    clusters_ = clusters_of_level();
    report_placement(state_, result_->triangles, result_->positions, result_->counts);
    if (may_exchange_vertices(state_, placement_))
      cluster_for_fewer();
  }

  // Every result is closer, because vertices lie near their clusters. Squares of much larger distances would overflow.
  static double max_distance(const Clustering_input& input)
  {
    Bbox_3 box;
    for (const Vector& p : input.mesh.points)
      box += box_of_point(p);
    return (std::max)(8 * std::sqrt(squared_diagonal(box)), (std::numeric_limits<double>::min)());
  }

  // Members of the result:
  const std::vector<Vector>& positions() const { return result_->positions; }
  const std::vector<Triangle>& triangles() const { return result_->triangles; }
  const std::vector<Index>& clusters_of_base_faces() const { return clusters_; }

private:
  struct Result
  {
    std::size_t level;
    std::vector<Triangle> triangles;
    std::vector<Vector> positions;
    double estimate;
    Repair_counts counts;
  };

  std::vector<Index> clusters_of_level() const
  {
    const Clustering_input& base = state_.base_input();
    const std::size_t faces = base.mesh.number_of_faces();
    std::size_t number = 0; // the number of faces of the caller's mesh
    for (std::size_t f = 0; f < faces; ++f)
      number = (std::max)(number, std::size_t(base.parent_of(Index(f))) + 1);
    const std::vector<Index> all = levels_->clusters_of_faces(result_->level, number);
    std::vector<Index> clusters;
    clusters.reserve(faces);
    for (std::size_t f = 0; f < faces; ++f)
      clusters.push_back(all[base.parent_of(Index(f))]);
    return clusters;
  }

  // Estimates are slightly smaller than bounds.
  double wanted() const { return 0.97 * local_distance_; }

  // The distances of a quick placement are larger than the distances of the placement that starts from it.
  double quick_goal() const { return quick_ ? wanted() / usual_gain : wanted(); }
  static constexpr double usual_gain = 0.6;

  // Uses the first of several numbers of vertices whose clustering is close enough.
  void find_clustering()
  {
    for (;;) {
      number_ = (std::min)(number_, vertices_);
      levels_.reset();
      result_.reset();
      try {
        seed(state_, {Seeding::FOR_NUMBER, number_});
        grow(state_);
      } catch (const Unreachable_number_of_vertices& e) {
        if (e.nearest() > number_)
          number_ = vertices_ = e.nearest();
        seed(state_, {Seeding::FOR_NUMBER, e.nearest()});
        grow(state_);
      }
      minimize(state_, minimization_end_);
      ++report_.clusterings;
      levels_.emplace(state_);
      estimates_by_level_.clear();
      quick_estimates_.clear();
      if (number_ >= vertices_ || quick_estimate(levels_->finest()) <= quick_goal() ||
          (quick_ && try_level(levels_->finest()) <= wanted()))
        return;
      number_ *= 2;
    }
  }

  double quick_estimate(std::size_t n)
  {
    if (!quick_)
      return try_level(n);
    const auto known = quick_estimates_.find(n);
    return known != quick_estimates_.end() ? known->second : quick_estimates_[n] = place(n, *quick_, false).estimate;
  }

  // Estimates the distance of a level with the requested placement. Keeps the level if it is close enough and coarser
  // than the level kept before.
  double try_level(std::size_t n)
  {
    const auto known = estimates_by_level_.find(n);
    if (known != estimates_by_level_.end())
      return known->second;
    Result x = place(n, placement_, state_.repairs_output);
    const double e = estimates_by_level_[n] = x.estimate;
    if (e <= wanted() && (!result_ || n < result_->level))
      result_ = std::move(x);
    return e;
  }

  void find_level()
  {
    const std::size_t finest = levels_->finest();
    const auto estimate = [this](std::size_t i) { return try_level(i); };
    std::size_t n = finest;
    if (quick_) {
      n = bracket(n, wanted() / expected_gain(), 1.2, 5, quick_estimates_, [this](std::size_t i) { return quick_estimate(i); });
      estimate(n);
      n = bracket(n, wanted(), 1.25, 2, estimates_by_level_, estimate);
    } else {
      n = bracket(n, wanted(), 1.06, 5, estimates_by_level_, estimate);
    }
    for (; !result_ && n < finest; n = (std::min)(finest, n + n / 4 + 1))
      try_level(n);
    // If clusters have few faces each, a coarser level may be closer.
    for (n = finest; !result_ && n >= levels_->coarsest() && n > finest / 16; n /= 2)
      try_level(n);
  }

  // Returns the expected ratio of the distance of the placement to the distance of the quick placement: the ratio on the
  // finest level, if known.
  double expected_gain()
  {
    const auto known = estimates_by_level_.find(levels_->finest());
    return known != estimates_by_level_.end() ? (std::min)(known->second / quick_estimate(levels_->finest()), 1.) : usual_gain;
  }

  // Brackets the coarsest level within a distance by at most `most` estimates in addition to the known estimates.
  //
  // On smooth surfaces, the estimate decreases with about the power -1 of the number of vertices. Until two estimates
  // determine the slope, steps assume a somewhat steeper slope, because a step too far costs more than an additional step.
  template <class Estimate>
  std::size_t bracket(std::size_t first, double distance, double width, int most, const std::map<std::size_t, double>& known,
                      const Estimate& estimate)
  {
    double low = double(levels_->coarsest()) - 1, high = double(levels_->finest()); // too coarse, and possibly fine enough
    double low_estimate = 0, high_estimate = 0;                                      // 0 if unknown
    double next = double(first);
    const auto take = [&](double n, double e) {
      (e <= distance ? high : low) = n;
      (e <= distance ? high_estimate : low_estimate) = e;
      const double slope = low_estimate > 0 && high_estimate > 0 && high_estimate < low_estimate
                             ? std::log(high_estimate / low_estimate) / std::log(high / low) : -1.25;
      next = n * std::pow(0.98 * distance / e, 1 / slope);
      // The next level keeps a distance from the ends of the bracket.
      next = (std::max)(next, low_estimate > 0 ? low * std::pow(high / low, 0.15) : low + 1);
      next = (std::min)(next, high_estimate > 0 ? high * std::pow((std::max)(low, 1.) / high, 0.1) : high);
      next = std::floor((std::min)((std::max)(next, low + 1), high));
    };
    for (auto i = known.rbegin(); i != known.rend() && low_estimate == 0; ++i)
      take(double(i->first), i->second);
    for (int i = 0; i < most && high > width * low + 1 && !(width * high_estimate >= distance); ++i)
      take(next, estimate(std::size_t(next)));
    return std::size_t(high_estimate > 0 ? high : (std::max)(next, low));
  }

  // Replaces the estimate of the result by a bound. If the estimate was too small, a finer level is needed. Returns
  // whether a finer level, or a finer clustering, is close enough.
  bool bound_result()
  {
    const std::size_t finest = levels_->finest();
    if (!result_)
      result_ = place(finest, placement_, state_.repairs_output);
    for (;;) {
      const double bound = bound_of(*result_), external = state_.frame.length_to_mesh(bound);
      if (bound <= local_distance_) {
        report_.vertices = result_->level;
        report_.distance_bound = external;
        return true;
      }
      if (result_->level == finest) {
        if (number_ >= vertices_)
          throw Unreachable_distance("no result within a distance of " + number_text(distance_) + " was found", external);
        number_ *= 2;
        return false;
      }
      const double finer = double(result_->level) * (std::min)(2., (std::max)(1.05, std::pow(bound / local_distance_, 1.2)));
      result_ = place((std::min)(finest, std::size_t(finer) + 1), placement_, state_.repairs_output);
    }
  }

  // A clustering of its own for a number of vertices, with exchanged vertices, is closer than a level with the same number.
  // Searches for the smallest sufficient number below the level found, until it is known to about a tenth or `max_runs` is
  // reached.
  void cluster_for_fewer()
  {
    constexpr int max_runs = 3;
    constexpr double width = 1.1, usual_part = 0.75;
    double low = 0, high = double(result_->level); // too few vertices, and enough vertices
    levels_.reset();
    Coarsening_report best = state_.report;
    double next = usual_part * high * std::pow(state_.frame.length_to_local(report_.distance_bound) / local_distance_, 0.8);
    for (int i = 0; i < max_runs && high > width * low + 1; ++i) {
      const double n = std::floor((std::min)((std::max)(next, (std::max)(low, 3.) + 1), high - 1));
      if (!(n > low))
        break;
      const double distance = try_clustering(std::size_t(n));
      (distance <= local_distance_ ? high : low) = n;
      if (distance <= local_distance_)
        best = state_.report;
      const double from = low > 0 ? low : high / 2, ratio = high / from;
      next = n * std::pow(distance / wanted(), 0.8);
      next = (std::min)((std::max)(next, from * std::pow(ratio, 0.3)), from * std::pow(ratio, 0.7));
    }
    state_.report = best;
  }

  // Returns the distance of the result; infinity if the number is not attainable or triangles intersect. Keeps the result if it
  // is close enough.
  double try_clustering(std::size_t n)
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    try {
      seed(state_, {Seeding::FOR_NUMBER, n});
      grow(state_);
    } catch (const Unreachable_number_of_vertices&) {
      return infinite;
    }
    minimize(state_, minimization_end_);
    ++report_.clusterings;
    Repair_budget budget = repair_budget(state_);
    Placed_dual dual = place_and_exchange(state_, placement_, output_coordinates_, budget);
    report_placement(state_, dual.triangles, dual.positions, dual.counts);
    if (dual.number_left() > 0)
      return infinite;
    Result result{n, std::move(dual.triangles), std::move(dual.positions), 0, std::move(dual.counts)};
    result.estimate = Distance_estimate(labels(state_), result.positions, result.triangles, state_.cancellation())
                        .distance(0.5 * local_distance_);
    ++report_.estimates;
    if (result.estimate > wanted())
      return (std::max)(result.estimate, std::nextafter(local_distance_, infinite));
    const double bound = bound_of(result);
    if (bound <= local_distance_) {
      clusters_ = internal::clusters_of_base_faces(state_);
      report_.vertices = n;
      report_.distance_bound = state_.frame.length_to_mesh(bound);
      result_ = std::move(result);
    }
    return bound;
  }

  double bound_of(const Result& result)
  {
    ++report_.bounds;
    return hausdorff_bound(surface_, output_positions(result), result.triangles, local_distance_ / 32);
  }

  Result place(std::size_t n, const Placement_model& placement, bool with_repair)
  {
    Placed_level placed = levels_->place(n, placement, with_repair, output_coordinates_);
    ++report_.estimates;
    const double estimate = levels_->estimate(placed, 0.5 * local_distance_);
    return {n, std::move(placed.triangles), std::move(placed.positions), estimate, std::move(placed.counts)};
  }

  // Returns the positions after rounding to the output, in coordinates of the arrays.
  std::vector<Vector> output_positions(const Result& of) const
  {
    std::vector<Vector> result;
    for (const Vector& p : of.positions)
      result.push_back(state_.frame.to_local(output_coordinates_(p)));
    return result;
  }

  Clustering_state& state_;
  std::optional<Level_hierarchy> levels_;
  Placement_model placement_;
  std::optional<Placement_model> quick_;
  Output_coordinates output_coordinates_;
  Minimization_end minimization_end_;
  std::size_t vertices_; // the maximum number of clusters
  std::size_t number_;   // number of clusters of the clustering
  Distance_report& report_;
  double distance_, local_distance_;
  std::map<std::size_t, double> estimates_by_level_, quick_estimates_; // estimates of the current clustering
  const Distance_mesh surface_;
  std::optional<Result> result_;
  std::vector<Index> clusters_; // the clusters of the faces of the mesh in the result
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_DISTANCE_SEARCH_H
