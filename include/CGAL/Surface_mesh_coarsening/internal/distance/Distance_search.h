// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_DISTANCE_SEARCH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_DISTANCE_SEARCH_H

#include <CGAL/Surface_mesh_coarsening/Distance_report.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/number_text.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/Distance_estimate.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/Level_hierarchy.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/Distance_bound.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/boxes.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/place_and_exchange.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Searches for the coarsest result within a distance. If the placement exchanges vertices, tries clusterings for several numbers
// of vertices, which the levels of a fine clustering predict. Otherwise, or if none is close enough, searches these levels.
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
      local_distance_((std::min)(state.frame.length_to_local(distance), max_distance(state.base_input())))
  {}

  void run()
  {
    const bool exchanges = placement_.exchanging && state_.exchange_rounds > 0 && minimization_end_.max_rounds > 0;
    find_clustering();
    if (exchanges && quick_estimate(levels_->finest()) <= quick_goal()) {
      cluster_directly(direct_part * double(bracket_quickly(quick_goal(), 4)));
      if (result_)
        return;
      find_clustering();
    }
    for (find_level(); !bound_result(); find_level())
      find_clustering();
    report_placement(state_.report, result_->triangles, result_->positions, result_->counts);
    if (exchanges) {
      enough_ = double(result_->level);
      cluster_directly(direct_part * enough_);
    }
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

  std::vector<Index> clusters_of_level(std::size_t level) const
  {
    const Clustering_input& base = state_.base_input();
    const std::size_t faces = base.mesh.number_of_faces();
    std::size_t number = 0; // the number of faces of the caller's mesh
    for (std::size_t f = 0; f < faces; ++f)
      number = (std::max)(number, std::size_t(base.parent_of(Index(f))) + 1);
    const std::vector<Index> all = levels_->clusters_of_faces(level, number);
    std::vector<Index> clusters;
    clusters.reserve(faces);
    for (std::size_t f = 0; f < faces; ++f)
      clusters.push_back(all[base.parent_of(Index(f))]);
    return clusters;
  }

  static constexpr double infinite = std::numeric_limits<double>::infinity();

  // Estimates are slightly smaller than bounds.
  double wanted() const { return 0.97 * local_distance_; }

  // The distances of a quick placement are larger than the distances of the placement that starts from it.
  double quick_goal() const { return quick_ ? wanted() / usual_gain : wanted(); }
  static constexpr double usual_gain = 0.6;
  // The usual number of vertices of a clustering of its own, as part of the number of a level.
  static constexpr double direct_part = 0.45;

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
      n = bracket_quickly(wanted() / expected_gain(), 5);
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

  std::size_t bracket_quickly(double distance, int most)
  {
    return bracket(levels_->finest(), distance, 1.2, most, quick_estimates_, [this](std::size_t i) { return quick_estimate(i); });
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
      clusters_ = clusters_of_level(result_->level);
      const Distance_bound bound_of(state_.base_input().mesh, clusters_, result_->level, state_.cancellation());
      const auto bound_below = [&](double limit, double error) {
        return bound_after_rounding(bound_of, result_->positions, result_->triangles, error, limit, nullptr);
      };
      const double bound = bound_below(local_distance_, permitted_error());
      if (bound <= local_distance_) {
        report_.vertices = result_->level;
        report_.distance_bound = state_.frame.length_to_mesh(bound);
        return true;
      }
      if (result_->level == finest) {
        // With the number of all vertices, the result is the surface of the input.
        if (number_ >= vertices_ && try_clustering(number_of_vertices(state_, 1)) <= local_distance_)
          return true;
        if (number_ >= vertices_)
          throw Unreachable_distance("no result within a distance of " + number_text(distance_) + " was found",
                                     state_.frame.length_to_mesh(bound_below(infinite, bound / 32)));
        number_ *= 2;
        return false;
      }
      const double finer = double(result_->level) * (std::min)(2., (std::max)(1.05, std::pow(bound / local_distance_, 1.2)));
      result_ = place((std::min)(finest, std::size_t(finer) + 1), placement_, state_.repairs_output);
    }
  }

  // Tries clusterings for several numbers of vertices, beginning with `next`. With exchanged vertices, they are closer than
  // levels.
  void cluster_directly(double next)
  {
    constexpr int max_trials = 4;
    constexpr double width = 1.15;
    levels_.reset();
    if (enough_ == 0)
      result_.reset();
    Coarsening_report best = state_.report;
    for (int i = 0; i < max_trials && (too_few_ == 0 || enough_ == 0 || enough_ > width * too_few_ + 1); ++i) {
      const double n = std::floor((std::max)(next, (std::max)(too_few_ + 1, 4.)));
      if (n >= (enough_ > 0 ? enough_ : double(vertices_)))
        break;
      const double distance = try_clustering(std::size_t(n));
      (distance <= local_distance_ ? enough_ : too_few_) = n;
      if (distance <= local_distance_)
        best = state_.report;
      next = next_number(n, distance);
    }
    state_.report = best;
  }

  // Returns the number to try after a number whose result has a distance.
  double next_number(double n, double distance) const
  {
    const double next = n * (std::min)((std::max)(std::pow(distance / wanted(), 0.8), 0.6), 1.7);
    if (too_few_ == 0)
      return (std::min)(next, 0.88 * enough_);
    if (enough_ == 0)
      return (std::max)(next, 1.1 * too_few_);
    const double ratio = enough_ / too_few_;
    return too_few_ * (std::min)((std::max)(next / too_few_, std::pow(ratio, 0.4)), std::pow(ratio, 0.7));
  }

  // Returns the distance of the result; infinity if the number is not attainable or triangles intersect. Keeps the result if it
  // is close enough.
  double try_clustering(std::size_t n)
  {
    try {
      seed(state_, {Seeding::FOR_NUMBER, n, true});
      grow(state_);
    } catch (const Unreachable_number_of_vertices&) {
      return infinite;
    }
    minimize(state_, minimization_end_);
    ++report_.clusterings;
    Repair_budget budget = repair_budget(state_);
    Placed_dual dual = place_and_exchange(state_, placement_, output_coordinates_, budget);
    std::vector<Index> clusters = internal::clusters_of_base_faces(state_);
    const double bound = approach_everywhere(clusters, dual, budget);
    if (dual.number_left() > 0)
      return infinite;
    if (bound <= local_distance_) {
      report_placement(state_.report, dual.triangles, dual.positions, dual.counts);
      clusters_ = std::move(clusters);
      report_.vertices = n;
      report_.distance_bound = state_.frame.length_to_mesh(bound);
      result_ = Result{n, std::move(dual.triangles), std::move(dual.positions), bound, std::move(dual.counts)};
    }
    return bound;
  }

  // Moves vertices where the result is too far: the fit minimizes the mean of the squared distances, and a few places determine
  // the maximum. Returns a bound of the distance, unless triangles intersect.
  double approach_everywhere(const std::vector<Index>& clusters, Placed_dual& dual, Repair_budget& budget)
  {
    constexpr int max_steps = 3;
    constexpr double max_ratio = 2;
    const std::unique_ptr<Bordered_surface> surface = bordered_surface(state_, dual);
    const Distance_bound bound_of(state_.base_input().mesh, clusters, dual.positions.size(), state_.cancellation());
    for (int i = 0;; ++i) {
      std::vector<Far_point> far;
      const double bound =
        bound_after_rounding(bound_of, dual.positions, dual.triangles, permitted_error(), local_distance_, &far);
      if (dual.number_left() > 0 || bound <= local_distance_ || bound > max_ratio * local_distance_ || i == max_steps)
        return bound;
      approach_far_points(far, local_distance_, *surface->faces, surface->border, dual.triangles, dual.positions);
      dual.counts = repair_exchanged(state_, *surface, placement_, output_coordinates_, dual, budget);
    }
  }

  double permitted_error() const { return local_distance_ / 32; }

  // Bounds the distance after rounding to the output; see `Distance_bound`.
  double bound_after_rounding(const Distance_bound& bound_of, const std::vector<Vector>& positions,
                              const std::vector<Triangle>& triangles, double error, double limit,
                              std::vector<Far_point>* far)
  {
    std::vector<Vector> rounded;
    for (const Vector& p : positions)
      rounded.push_back(state_.frame.to_local(output_coordinates_(p)));
    ++report_.bounds;
    return bound_of(rounded, triangles, error, limit, far);
  }

  Result place(std::size_t n, const Placement_model& placement, bool with_repair)
  {
    Placed_level placed = levels_->place(n, placement, with_repair, output_coordinates_);
    ++report_.estimates;
    const double estimate = levels_->estimate(placed, 0.5 * local_distance_);
    return {n, std::move(placed.triangles), std::move(placed.positions), estimate, std::move(placed.counts)};
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
  double too_few_ = 0, enough_ = 0; // numbers of vertices of clusterings; 0 if unknown
  std::optional<Result> result_;
  std::vector<Index> clusters_; // the clusters of the faces of the mesh in the result
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_DISTANCE_SEARCH_H
