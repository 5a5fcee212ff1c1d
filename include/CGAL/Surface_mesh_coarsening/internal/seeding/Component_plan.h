// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_COMPONENT_PLAN_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_COMPONENT_PLAN_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Returns a lower bound of the number of vertices of simplicial surfaces with the topology of the component. Closed surfaces of
// genus g need ceil((7 + sqrt(1 + 48 g)) / 2) vertices (Jungerman and Ringel, 1980). A surface with border is closed by one more
// vertex per loop. Its loops have no common vertices, and each loop has at least three.
inline std::size_t fewest_vertices(const Component& c)
{
  const std::size_t g = c.genus();
  // The smallest n with (n - 3)(n - 4) >= 12 g, in integers. The exception of the Klein bottle does not apply, because it is not
  // orientable. The exception of genus 2 applies; this surface needs 10.
  std::size_t n = 4;
  while ((n - 3) * (n - 4) < 12 * g)
    ++n;
  if (g == 2)
    n = 10;
  return (std::max)({3 * c.loops, n - (std::min)(n, c.loops), c.feature_clusters});
}

// Names what needs the vertices of the smallest number: corners first, because they outnumber the other needs.
inline std::string needs_of_vertices(const std::vector<Component>& components)
{
  const auto counted = [](std::size_t n, const char* noun) { return std::to_string(n) + " " + noun + (n == 1 ? "" : "s"); };
  std::size_t corners = 0, on_features = 0;
  for (const Component& c : components) {
    corners += c.feature_corners;
    on_features += c.feature_clusters;
  }
  if (corners > 0)
    return counted(corners, "corner") + " of features to keep";
  return counted(components.size(), "connected component") + (on_features > 0 ? " and feature lines to keep" : "");
}

// Apportions `total` in proportion to `shares`, with `least[i] <= result[i] <= most[i]`. `total` must lie between the sums of
// `least` and `most`. Rounds by largest remainders; of equal remainders, the smaller index comes first.
inline std::vector<std::size_t> apportion(std::size_t total, std::vector<double> shares,
                                          const std::vector<std::size_t>& least, const std::vector<std::size_t>& most)
{
  const std::size_t n = shares.size();
  // Shares must be positive, so that components without area receive the rest.
  const double all_shares = std::accumulate(shares.begin(), shares.end(), 0.);
  const double all_most = double(std::accumulate(most.begin(), most.end(), std::size_t(0)));
  for (std::size_t i = 0; i < n; ++i)
    shares[i] = (all_shares > 0 ? shares[i] / all_shares : 0) + 1e-9 * double(most[i]) / all_most;
  const auto clamped = [&](std::size_t i, double x) { return std::clamp(x, double(least[i]), double(most[i])); };
  // Finds by bisection the factor at which the clamped shares add up to the total, up to rounding errors.
  double low = 0, high = 1;
  const auto sum_at = [&](double factor) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i)
      sum += clamped(i, factor * shares[i]);
    return sum;
  };
  while (sum_at(high) < double(total))
    high *= 2;
  for (int step = 0; step < 100; ++step) {
    const double middle = 0.5 * (low + high);
    (sum_at(middle) < double(total) ? low : high) = middle;
  }
  std::vector<std::size_t> result(n), order(n);
  std::vector<double> remainder(n);
  std::size_t given = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double exact = clamped(i, high * shares[i]);
    result[i] = std::size_t(exact + 1e-6);
    remainder[i] = std::floor(1024 * (exact - double(result[i])) + 0.5); // rounded, so that equal shares remain equal
    given += result[i];
  }
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return remainder[a] > remainder[b]; });
  while (given != total) // terminates because the bounds enclose the total
    for (std::size_t k = 0; k < n && given != total; ++k) {
      const std::size_t i = given < total ? order[k] : order[n - 1 - k];
      if (given < total && result[i] < most[i]) {
        ++result[i];
        ++given;
      } else if (given > total && result[i] > least[i]) {
        --result[i];
        --given;
      }
    }
  return result;
}

// The plan that brings a connected component to its number of clusters.
//
// The standard method is the method of the paper: seeds of the largest level that gives twice the number, growth, and merging of
// three clusters at a time. It may end with too many clusters if the faces or the topology leave little freedom. In this case,
// and always below `sufficient_clusters()` clusters, a schedule of levels applies, which is the same for all smaller numbers.
//
// From the seeds of a level, clusters are merged in pairs, in an order that does not depend on the required number. So a
// level gives every number between the start and the end of its merging. The schedule begins with the highest level
// whose merging starts with sufficient_clusters() clusters or more, or with the lowest level. The levels above follow, as
// long as their merging starts no lower than the end of the merging of earlier levels; then the levels below; then the
// same levels with subdivided faces, which can form any clusters. Hence all numbers from the smallest end of a level
// are attainable. The number of consecutive levels without a smaller end is limited, so the work on large components is
// proportional to their number of faces: with large clusters, all levels end near the same number.
class Component_plan
{
public:
  // If merging continues until no two clusters may be merged, the dual is an irreducible triangulation. Closed surfaces of genus
  // g have irreducible triangulations of at most 26 g - 4 vertices (Joret and Wood: Irreducible triangulations are small, 2010).
  // With b border loops the number is also linear in g and b (Boulch, Colin de Verdiere, Nakamoto: Irreducible triangulations of
  // surfaces with boundary, 2013). Features keep clusters apart; these results do not bound the additional clusters.
  static std::size_t sufficient_clusters(const Component& c) { return 8 + 26 * c.genus() + 8 * c.loops + 4 * c.feature_clusters; }

  // Restarts for `wanted` clusters: with the seeds of level `level`, if given, in the standard method. If clusters are merged by
  // quadrics, the standard method is tried first for every number, and the schedule, which does not use quadrics, if it fails.
  void begin(const Component& component, std::size_t wanted, Index level, bool merges_by_quadrics)
  {
    merges_by_quadrics_ = merges_by_quadrics;
    enough_ = sufficient_clusters(component);
    faces_ = component.faces;
    wanted_ = wanted;
    lowest_end_ = (std::numeric_limits<std::size_t>::max)();
    const bool is_scheduled = level == NONE && wanted < enough_ && !merges_by_quadrics;
    if (is_scheduled && wanted >= nearest_)
      restart(true, nearest_from_pieces_, nearest_level_);
    else
      restart(is_scheduled, component.faces < wanted, level);
  }

  // The level of the seeds. NONE: the largest level that gives min_seeds(), or the scheduled level below it.
  Index level() const { return level_; }
  std::size_t min_seeds() const
  {
    return on_schedule_ ? (std::max)(wanted_, enough_) : wanted_ * (merges_by_quadrics_ ? seeds_for_quadrics : seeds_per_cluster);
  }
  bool is_on_schedule() const { return on_schedule_; }
  bool merges_by_quadrics() const { return merges_by_quadrics_ && !on_schedule_; }
  bool from_pieces() const { return from_pieces_; }
  std::size_t wanted() const { return wanted_; }

  bool may_begin_with(std::size_t clusters) const { return !is_climbing_ || clusters >= lowest_end_; }

  // Returns the highest level of the schedule that is at most `level`.
  static Index scheduled_level(Index level)
  {
    Index below = 0;
    while (next_scheduled_level(below) <= level)
      below = next_scheduled_level(below);
    return below;
  }

  // The smallest number of clusters reached so far.
  std::size_t nearest() const { return nearest_; }
  bool has_nearest() const { return nearest_ != (std::numeric_limits<std::size_t>::max)(); }

  // Records a failed attempt: with `seeds` seeds of level `level`, it ended with `reached` clusters; `reached` is 0 if merging
  // may not begin with these seeds. Returns whether another attempt remains. If not, nearest() is the smallest attainable number.
  bool revise(Index level, std::size_t seeds, std::size_t reached)
  {
    if (!on_schedule_) {
      if (reached == 0 && !from_pieces_ && wanted_ >= enough_)
        return take_pieces();
      restart(true, from_pieces_, wanted_ >= enough_ ? scheduled_level(level) : NONE);
      return true;
    }
    if (reached > wanted_ && reached < nearest_) {
      nearest_ = reached;
      nearest_level_ = level;
      nearest_from_pieces_ = from_pieces_;
    }
    const bool is_no_progress = reached == 0 || reached >= lowest_end_;
    levels_without_progress_ = is_no_progress ? levels_without_progress_ + 1 : 0;
    if (!is_no_progress)
      lowest_end_ = reached;
    if (first_scheduled_level_ == NONE) {
      first_scheduled_level_ = level;
      lowest_has_failed_ = level == 0 || seeds > max_seeds();
      is_climbing_ = reached > wanted_ && wanted_ < enough_ && seeds > 1;
    } else if (is_climbing_) {
      is_climbing_ = reached != 0 && seeds > 1 && levels_without_progress_ < max_levels_without_progress();
      if (!is_climbing_)
        levels_without_progress_ = 0;
    } else {
      lowest_has_failed_ = level == 0 || reached == 0 || seeds > max_seeds() ||
                           levels_without_progress_ >= max_levels_without_progress();
    }
    if (is_climbing_)
      level_ = next_scheduled_level(level);
    else if (!lowest_has_failed_)
      level_ = scheduled_level((std::min)(level, first_scheduled_level_) - 1);
    else
      return take_pieces();
    return true;
  }

private:
  // Seeds are distributed by the number of faces only. If there are more seeds than clusters, merging can balance masses.
  static constexpr std::size_t seeds_per_cluster = 2;
  // Quadrics need small clusters at the start. With 3, 5 and 10 seeds for each cluster, the models of compare_quality are 1.118,
  // 1.090 and 1.09 to 1.11 times as far as by edge collapse.
  static constexpr std::size_t seeds_for_quadrics = 5;

  static Index next_scheduled_level(Index level)
  {
    if (level < 2)
      return level + 1;
    const bool is_power_of_two = (level & (level - 1)) == 0;
    return is_power_of_two ? level + level / 2 : level / 3 * 4;
  }

  // With more seeds, merging takes long on large components, and the result is no better.
  std::size_t max_seeds() const { return 16 * enough_; }

  std::size_t max_levels_without_progress() const
  {
    const std::size_t faces_of_all_levels = 2000000, faces = from_pieces_ ? 3 * faces_ : faces_;
    return (std::max)(std::size_t(2), faces_of_all_levels / faces);
  }

  void restart(bool on_schedule, bool from_pieces, Index level)
  {
    on_schedule_ = on_schedule;
    from_pieces_ = from_pieces;
    level_ = level;
    levels_without_progress_ = 0;
    first_scheduled_level_ = NONE;
    is_climbing_ = lowest_has_failed_ = false;
  }

  bool take_pieces()
  {
    const bool remains = !from_pieces_;
    if (remains)
      restart(wanted_ < enough_, true, NONE);
    else if (has_nearest())
      restart(true, nearest_from_pieces_, nearest_level_);
    return remains;
  }

  std::size_t enough_ = 0, faces_ = 0, wanted_ = 0;
  std::size_t levels_without_progress_ = 0, lowest_end_ = 0; // of the levels since begin()
  Index level_ = NONE, first_scheduled_level_ = NONE, nearest_level_ = NONE;
  bool merges_by_quadrics_ = false, on_schedule_ = false, is_climbing_ = false, lowest_has_failed_ = false;
  bool from_pieces_ = false, nearest_from_pieces_ = false;
  std::size_t nearest_ = (std::numeric_limits<std::size_t>::max)();
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_COMPONENT_PLAN_H
