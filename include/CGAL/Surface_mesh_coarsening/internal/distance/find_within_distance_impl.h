// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_FIND_WITHIN_DISTANCE_IMPL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_FIND_WITHIN_DISTANCE_IMPL_H

#include <CGAL/Surface_mesh_coarsening/internal/distance/Distance_bound.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/find_within_distance.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/place_and_exchange.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Bisects a list of numbers of vertices that does not depend on the distance. Whether the result for a number is within a larger
// distance follows from whether it is within a smaller one: the steps toward the result do not depend on the distance, only
// their end does. Hence a larger distance never leads to more vertices. The distance does not fall with every number: where a
// number misses the distance narrowly, the next number is tried too.
class Distance_search
{
public:
  Distance_search(Clustering_state& state, const Placement_model& placement, const Output_coordinates& output_coordinates,
                  const Distance_goal& goal, Distance_report& report)
    : state_(state),
      placement_(placement),
      output_coordinates_(output_coordinates),
      goal_(goal),
      local_distance_((std::min)(state.frame.length_to_local(goal.distance), max_distance(state.base_input()))),
      report_(report)
  {}

  Placed_dual run()
  {
    const std::vector<std::size_t> numbers = trial_numbers();
    std::vector<char> is_too_far(numbers.size(), false);
    std::size_t first = 0, end = numbers.size() - 1, tried = numbers.size();
    trials_ = 2 + std::size_t(std::ceil(std::log2(double(numbers.size()))));
    std::optional<Result> found;
    const auto try_number = [&](std::size_t i) {
      if (is_too_far[i])
        return false;
      tried = i;
      is_too_far[i] = !is_within_distance(numbers[i], false);
      if (!is_too_far[i])
        found = {numbers[i], labels(state_).labels(), std::move(dual_), state_.report.exchanged_vertices};
      return !is_too_far[i];
    };
    while (first < end) {
      const std::size_t middle = (first + end) / 2;
      if (try_number(middle))
        end = middle;
      else if (tried == middle && middle + 1 < end && nearest_ <= narrow_miss * local_distance_ && try_number(middle + 1))
        end = middle;
      else
        first = middle + 1;
    }
    if (found) {
      cluster(found->number);
      dual_ = std::move(found->dual);
      restore_clusters(state_, found->labels, dual_);
      state_.report.exchanged_vertices = found->exchanged;
      begin_bounds();
    } else if (!is_within_distance(numbers.back(), true) && numbers.back() < goal_.max_vertices) {
      throw Unreachable_distance("no result within a distance of " + number_text(goal_.distance) + " was found",
                                 state_.frame.length_to_mesh(rounded_up * nearest_));
    }
    report_.vertices = state_.number_of_clusters();
    work_left_ = work_of_trial();
    const double bound = measure(true, infinite).bound;
    report_.is_within_distance = bound <= local_distance_;
    report_.distance_bound = state_.frame.length_to_mesh(bound);
    return std::move(dual_);
  }

private:
  // The clusters and the placement of a trial.
  struct Result
  {
    std::size_t number;
    std::vector<Index> labels;
    Placed_dual dual;
    std::size_t exchanged;
  };

  // Every result is closer, because vertices lie near their clusters. Squares of much larger distances would overflow.
  static double max_distance(const Clustering_input& input)
  {
    Bbox_3 box;
    for (const Vector& p : input.mesh.points)
      box += box_of_point(p);
    return (std::max)(8 * std::sqrt(squared_diagonal(box)), (std::numeric_limits<double>::min)());
  }

  // Returns the numbers of vertices that may be the result, in geometric progression.
  std::vector<std::size_t> trial_numbers() const
  {
    constexpr double max_ratio = 1.08;
    const auto range = vertex_number_range(state_);
    const std::size_t most = (std::min)({range.second, number_of_vertices(state_, 1), goal_.max_vertices}),
                      least = (std::min)(range.first, most);
    const double ratio = double(most) / double(least);
    std::size_t steps = 1;
    while (std::pow(ratio, 1. / double(steps)) > max_ratio)
      steps *= 2;
    std::vector<std::size_t> numbers{least};
    for (std::size_t i = 1; i <= steps; ++i) {
      const auto n = std::size_t(std::round(double(least) * std::pow(ratio, double(i) / double(steps))));
      if (n > numbers.back() && n < most)
        numbers.push_back(n);
    }
    if (most > numbers.back())
      numbers.push_back(most);
    return numbers;
  }

  // Returns the work of the bounds of a trial, in comparisons of points with triangles and boxes. For distances from .003 to .02,
  // eleven models need fewer than 4,500 for each triangle. Fans of large polygons need more: with 4,000, a prism of 160 sides has
  // 66 vertices within .01 of its diagonal instead of 54.
  std::size_t work_of_trial() const
  {
    constexpr std::size_t work_of_triangle = 4500, min_triangles = 100;
    const Flat_mesh& mesh = state_.base_input().mesh;
    return work_of_triangle * (std::max)(mesh.corner_vertex.size() - 2 * mesh.number_of_faces(), min_triangles);
  }

  void cluster(std::size_t n)
  {
    seed(state_, {Seeding::FOR_NUMBER, n, true});
    grow(state_);
    minimize(state_, goal_.end);
    ++report_.clusterings;
  }

  // Computes the result for a number of vertices, as far as the answer needs it, or completely.
  bool is_within_distance(std::size_t n, bool is_last)
  {
    nearest_ = infinite;
    is_last_ = is_last;
    try {
      cluster(n);
    } catch (const Unreachable_number_of_vertices&) {
      if (is_last)
        throw;
      return false;
    }
    Repair_budget budget = repair_budget(state_, parts_per_trial * trials_);
    const Placement_request request{placement_, output_coordinates_, budget};
    work_left_ = work_of_trial();
    if (may_exchange_vertices(state_, placement_)) {
      dual_ = place(state_, request);
      if (approach(largest_gain, request))
        return true;
      if (!is_last && nearest_ > largest_gain * local_distance_)
        return false;
    }
    dual_ = place_and_exchange(state_, request);
    return approach(max_ratio_of_step[0], request);
  }

  // Returns whether the result is within the distance. Where it is too far, moves vertices: the fit minimizes the mean of the
  // squared distances, and a few places determine the maximum. Steps end where the distance is too large for the steps that are
  // left, and where it is large and has not fallen. The first bound is computed up to `first_ratio` of the requested distance.
  bool approach(double first_ratio, const Placement_request& request)
  {
    constexpr double max_ratio_without_gain = 1.25;
    begin_bounds();
    std::unique_ptr<Bordered_surface> surface;
    double last_bound = infinite;
    for (std::size_t step = 0;; ++step) {
      const double ratio = max_ratio_of_step[step], known_up_to = step == 0 ? first_ratio : ratio;
      const Measured_distance measured = measure(false, is_last_ ? infinite : known_up_to * local_distance_);
      nearest_ = (std::min)(nearest_, measured.bound);
      if (measured.bound <= local_distance_)
        return true;
      if (measured.bound > ratio * local_distance_ || has_many_intersections(state_, dual_))
        return false;
      if (measured.bound >= last_bound && measured.bound > max_ratio_without_gain * local_distance_)
        return false;
      last_bound = measured.bound;
      const std::size_t left = dual_.number_left();
      if (!surface)
        surface = bordered_surface(state_, dual_);
      approach_far_points(measured, *surface);
      repair(state_, *surface, request, dual_);
      if (dual_.number_left() > left)
        step = max_ratio_of_step.size() - 2; // one more look
    }
  }

  // Moves vertices so that far points come nearer. Vertices on the border stay.
  void approach_far_points(const Measured_distance& measured, const Bordered_surface& surface)
  {
    // A vertex between several far points cannot approach all of them at once.
    constexpr double goal = 0.8;
    std::vector<Vector> moves(dual_.positions.size(), Vector{{0, 0, 0}});
    for (const Far_point& p : measured.far) {
      const double part = 1 - goal * (far_part * measured.reached) / length(p.offset);
      for (int i = 0; i < 3; ++i) {
        const Vector move = part * p.barycentric[i] / dot(p.barycentric, p.barycentric) * p.offset;
        Vector& longest = moves[dual_.triangles[p.triangle][i]];
        if (dot(move, move) > dot(longest, longest))
          longest = move;
      }
    }
    for (std::size_t x = 0; x < moves.size(); ++x)
      if (!surface.border.is_on_border(x))
        dual_.positions[x] = surface.faces.within_bounds(x, dual_.positions[x] + moves[x]);
  }

  void begin_bounds()
  {
    bound_of_.emplace(state_.base_input().mesh, clusters_of_base_faces(state_), dual_.positions.size(), work_left_,
                      state_.context);
  }

  // Bounds the distance after rounding to the output; see `Distance_bound`.
  Measured_distance measure(bool precise, double hopeless)
  {
    std::vector<Vector> rounded;
    for (const Vector& p : dual_.positions)
      rounded.push_back(state_.frame.to_local(output_coordinates_(p)));
    ++report_.bounds;
    return (*bound_of_)(rounded, dual_.triangles, local_distance_, precise, hopeless);
  }

  // A trial is repaired with a small part of the usual work. The numbers found for twelve models and distances from .003 to .02
  // are the same with a whole part.
  static constexpr std::size_t parts_per_trial = 8;
  // The exchange of vertices lowers the largest distance less.
  static constexpr double largest_gain = 4;
  // The bounds, in requested distances, from which the steps that are left may lead to the distance. In 69 searches
  // with 24 models, no result has more vertices than with two requested distances in each step.
  static constexpr std::array<double, 4> max_ratio_of_step{{2, 1.5, 1.3, 1}};
  // The bound of a narrow miss, in requested distances.
  static constexpr double narrow_miss = 1.5;
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  // Makes the nearest distance attainable in spite of the error of its bound.
  static constexpr double rounded_up = 1.002;
  Clustering_state& state_;
  Placement_model placement_;
  Output_coordinates output_coordinates_;
  Distance_goal goal_;
  double local_distance_;
  std::size_t trials_ = 1; // without second ones, each with its part of the repair's budget
  Distance_report& report_;
  Placed_dual dual_;
  std::size_t work_left_ = 0; // of the bounds of a trial
  std::optional<Distance_bound> bound_of_;
  double nearest_ = infinite; // the least bound of the last trial
  bool is_last_ = false;       // whether the distance is to be known even if it is much too large
};

CGAL_SURFACE_MESH_COARSENING_INLINE Placed_dual
find_within_distance(Clustering_state& state, const Placement_model& placement, const Output_coordinates& output_coordinates,
                     const Distance_goal& goal, Distance_report& report)
{
  return Distance_search(state, placement, output_coordinates, goal, report).run();
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_FIND_WITHIN_DISTANCE_IMPL_H
