// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_EDGE_FLIPS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_EDGE_FLIPS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Coarse_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Trial_fan.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/fit_vertices.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Flips edges of a coarse mesh if the flip lowers the squared distance from the input enough for the loss in the smallest
// angles of the two triangles, or improves the angles enough for the added distance. The exchange rate between distance and
// angles is chosen such that the mean of the smallest angles reaches a goal.
class Edge_flips
{
public:
  // `mean_angle` is the goal in degrees. If vertices may leave their clusters, the costs of flips include narrow triangles, flips
  // create no angle below 10 degrees unless they unfold triangles, and the exchange rate of angles has a larger minimum. Otherwise
  // only flips across sharp edges would avoid narrow triangles.
  Edge_flips(Coarse_mesh& mesh, double mean_angle)
    : mesh_(mesh),
      lowest_exponent_(mesh.may_relocate() ? exponent_with_exchange(mean_angle) : exponent_without_exchange)
  {}

  // Reaches a mean angle by flips, as far as possible. The angle is in radians.
  void run(double mean_angle)
  {
    const double mean = measure_triangles();
    if (!(mean > 0))
      return;
    double budget = 0;
    for (const Measures& m : measures_)
      budget += m.angle - mean_angle;
    worth_ = {rate(lowest_exponent_, mean), narrow_part * mean};
    std::vector<Flip> flips = promising_flips();
    worth_.rate = rate_for(flips, budget, mean);
    apply(flips);
  }

  // Bounds the exchange rate before steady runs. The last run may have raised it as far as possible in vain, or have lowered it as
  // far as possible.
  void bound_rate()
  {
    constexpr double least = 0.3;
    worth_.rate = (std::min)((std::max)(worth_.rate, least * worth_.narrow_rate), high_rate * worth_.narrow_rate);
  }

  // Approaches the goal together with the other changes of several rounds: the logarithm of the exchange rate changes in proportion
  // to the missing angle, in degrees. The rate at which the flips alone reach the goal would oscillate, by a factor of 55 in ten
  // rounds of anchor_dense.off. If only the goal matters, the rate changes faster and may be larger. With gains of 0.5 or 0.85, the
  // models of compare_quality are 1 to 2 % farther.
  void run_steadily(double missing, bool only_goal_matters)
  {
    constexpr double gain = 0.7, largest_gain = 5, max_change = 1.1; // of the logarithm; gains are per degree
    const double mean = measure_triangles();
    if (!(mean > 0))
      return;
    const double last = worth_.rate > 0 ? worth_.rate / worth_.narrow_rate : 1;
    const double change = (only_goal_matters ? largest_gain : gain) * missing;
    const double wanted = (only_goal_matters ? last : (std::min)(last, high_rate)) *
                          std::exp((std::min)((std::max)(change, -max_change), max_change)) * mean * narrow_part;
    worth_ = {(std::min)((std::max)(wanted, rate(lowest_exponent_, mean)), rate(0, mean)), narrow_part * mean};
    std::vector<Flip> flips = promising_flips();
    apply(flips);
  }

  // The exchange rate of the last run.
  const Angle_worth& worth() const { return worth_; }

private:
  struct Flip
  {
    Index triangle;
    int corner;
    bool may_pay = false;
    double gain = 0; // in squared distance
    double loss = 0; // of angle
    double narrowing = 0;
    double profit(const Angle_worth& worth) const { return gain - worth.rate * loss - worth.narrow_rate * narrowing; }
  };

  struct Measures
  {
    double sharpest = 0, angle = 0, cost = 0;
  };

  // Returns the mean cost of a triangle.
  double measure_triangles()
  {
    measures_.resize(mesh_.triangles().size());
    for_each_number(mesh_.context(), measures_.size(), [this](Index t) {
      const double sharpest = sharpest_of(mesh_.positions(), mesh_.triangle(t));
      measures_[t] = {sharpest, angle(sharpest), mesh_.samples().cost(t)};
    });
    return mesh_.mean_cost();
  }

  // Returns the flips that may be profitable at the current exchange rate or a larger one.
  std::vector<Flip> promising_flips() const
  {
    std::vector<Flip> flips;
    for_each_part<std::vector<Flip> >(
      mesh_.context(), mesh_.triangles().size(), triangles_of_part,
      [this](std::vector<Flip>& trials, std::size_t begin, std::size_t end) { try_flips(begin, end, trials); },
      [&](const std::vector<Flip>& trials) {
        mesh_.context().poll(steps_of_flip * triangles_of_part);
        flips.insert(flips.end(), trials.begin(), trials.end());
      });
    return flips;
  }

  // Finds these flips at some triangles.
  void try_flips(std::size_t begin, std::size_t end, std::vector<Flip>& trials) const
  {
    trials.clear();
    for (std::size_t t = begin; t != end; ++t)
      for (int i = 0; i < 3; ++i) {
        const Flip flip = flip_at(Index(t), i);
        if (flip.may_pay)
          trials.push_back(flip);
      }
  }

  static double angle(double cosine) { return std::acos((std::min)(1., cosine)); }

  Flip flip_at(Index t, int i) const
  {
    Flip flip{t, i};
    const Index u = mesh_.across(t, i);
    if (u == NONE || u < t)
      return flip;
    const Triangle &old_t = mesh_.triangle(t), &old_u = mesh_.triangle(u);
    const Measures &of_t = measures_[t], &of_u = measures_[u];
    const Index a = old_t[i], b = old_t[(i + 1) % 3], c = mesh_.opposite(t, i), d = mesh_.opposite(u, mesh_.corner(u, b));
    const Triangle new_t{c, a, d}, new_u{c, d, b};
    const double sharpest_t = sharpest_of(mesh_.positions(), new_t), sharpest_u = sharpest_of(mesh_.positions(), new_u);
    const double sharpest = (std::max)(sharpest_t, sharpest_u);
    const bool is_narrow = sharpest > (std::max)({sharpest_allowed_, of_t.sharpest, of_u.sharpest});
    if ((is_narrow && !(sharpest < std::cos(min_angle_of_unfolded) && are_folded(t, u))) || !mesh_.may_flip(t, i, u) ||
        folds_over(old_t, old_u, new_t, new_u))
      return flip;
    const double angle_t = angle(sharpest_t), angle_u = angle(sharpest_u);
    flip.loss = of_t.angle + of_u.angle - angle_t - angle_u;
    if (mesh_.may_relocate())
      flip.narrowing = narrowness(angle_t) + narrowness(angle_u) - narrowness(of_t.angle) - narrowness(of_u.angle);
    const double now = of_t.cost + of_u.cost;
    // If the angles get worse, the flip is profitable only if the distance decreases by their worth.
    const bool is_closer = flip.loss >= 0 && flip.narrowing >= 0;
    const double pays = now + flip.profit(worth_);
    const double limit = is_closer ? pays : (std::max)(max_growth * now, pays);
    if (limit < 0)
      return flip;
    flip.gain = now - mesh_.samples().cost_instead(t, u, new_t, new_u, limit, is_closer);
    flip.may_pay = (!is_closer || flip.profit(worth_) > 0) && (!is_narrow || now - flip.gain <= max_part_of_unfolded * now);
    return flip;
  }

  // Returns whether two neighbors are folded onto each other.
  bool are_folded(Index t, Index u) const
  {
    const Vector n = mesh_.normal(t), m = mesh_.normal(u);
    return dot(n, m) < max_folded_cosine * length(n) * length(m);
  }

  // Returns whether the new triangles face away from each other or from the old triangles.
  bool folds_over(const Triangle& old_t, const Triangle& old_u, const Triangle& new_t, const Triangle& new_u) const
  {
    const std::vector<Vector>& positions = mesh_.positions();
    const Vector old_normal = normal_of(positions, old_t) + normal_of(positions, old_u);
    const Vector n = normal_of(positions, new_t), m = normal_of(positions, new_u);
    return !(dot(n, old_normal) > 0 && dot(m, old_normal) > 0 && dot(n, m) > 0);
  }

  // Returns the smallest rate at which all profitable flips together reduce the angles by at most `budget`. The rate is bounded,
  // because this rate need not exist. `unit` is a typical squared distance.
  double rate_for(const std::vector<Flip>& flips, double budget, double unit) const
  {
    double low = lowest_exponent_, high = 0;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      const Angle_worth worth{rate(middle, unit), worth_.narrow_rate};
      double loss = 0;
      for (const Flip& flip : flips)
        if (flip.profit(worth) > 0)
          loss += flip.loss;
      (loss > budget ? low : high) = middle;
    }
    return rate(high, unit);
  }

  static double rate(double exponent, double unit) { return unit * std::exp(exponent) * (180 / CGAL_PI); }

  // Makes the best flips first. Each triangle is flipped at most once, so the feet on the two triangles of a flip do not depend
  // on other flips.
  void apply(std::vector<Flip>& flips)
  {
    flips.erase(std::remove_if(flips.begin(), flips.end(), [this](const Flip& f) { return !(f.profit(worth_) > 0); }),
                flips.end());
    std::stable_sort(flips.begin(), flips.end(),
                     [this](const Flip& f, const Flip& g) { return f.profit(worth_) > g.profit(worth_); });
    std::vector<bool> is_done(mesh_.triangles().size(), false);
    std::vector<std::pair<Index, Index> > flipped;
    for (const Flip& flip : flips) {
      const Index t = flip.triangle, u = mesh_.across(t, flip.corner);
      if (is_done[t] || is_done[u] || !mesh_.may_flip(t, flip.corner, u))
        continue;
      mesh_.flip(t, flip.corner, u);
      is_done[t] = is_done[u] = true;
      flipped.emplace_back(t, u);
    }
    mesh_.context().poll(steps_of_flip * flipped.size());
    for_each_chunk(mesh_.context(), flipped.size(), 4, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        mesh_.samples().redistribute(flipped[i].first, flipped[i].second);
    });
  }

  // The exchange rate from which steady runs no longer raise it unless only the goal matters, in units of the worth of narrowness.
  static constexpr double high_rate = 3;
  static constexpr double min_angle_otherwise = 7 * CGAL_PI / 180;
  // A flip that unfolds two triangles may create smaller angles if it leaves at most this part of their distance: at a reflex corner
  // of a planar face, no other flip may be possible.
  static constexpr double max_folded_cosine = -0.9, min_angle_of_unfolded = CGAL_PI / 180, max_part_of_unfolded = 0.01;
  // The logarithm of the smallest exchange rate. With goals below 30 degrees, -8 instead of -6 lowers the distance of four mechanical
  // models at five sizes by 5 %.
  static constexpr double exponent_without_exchange = -30;
  static double exponent_with_exchange(double mean_angle)
  {
    constexpr double small_angle = 30;
    return mean_angle < small_angle ? -8 : -6;
  }
  static constexpr std::size_t steps_of_flip = 64, triangles_of_part = 16;
  // A flip for better angles that increases the distance by a larger factor is evaluated exactly only if the smallest rate pays it.
  static constexpr double max_growth = 1.2;

  Coarse_mesh& mesh_;
  const double lowest_exponent_;
  const double sharpest_allowed_ = std::cos(mesh_.may_relocate() ? min_angle : min_angle_otherwise);
  Angle_worth worth_;
  std::vector<Measures> measures_; // of each triangle
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_EDGE_FLIPS_H
