// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_APPORTION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_APPORTION_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

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
  const auto clamped = [&](std::size_t i, double x) {
    return (std::min)((std::max)(x, double(least[i])), double(most[i]));
  };
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

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_APPORTION_H
