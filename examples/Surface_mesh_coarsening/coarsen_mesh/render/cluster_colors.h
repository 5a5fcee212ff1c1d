// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colors for clusters: neighbors differ, few colors are used, and equal labels always give equal colors.

#ifndef COARSENING_SUPPORT_CLUSTER_COLORS_H
#define COARSENING_SUPPORT_CLUSTER_COLORS_H

#include "io/Mesh.h"
#include "render/Rgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace coarsening_support {

// Converts hue (0 to 6), saturation and brightness (0 to 1) to a color.
inline Rgb from_hue(double hue, double saturation, double brightness)
{
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + hue, 6.);
    const double fall = (std::max)(0., (std::min)({k, 4. - k, 1.}));
    return static_cast<std::uint8_t>(std::lround(255. * brightness * (1. - saturation * fall)));
  };
  return {channel(5.), channel(3.), channel(1.)};
}

// The first colors are chosen manually; the rare further ones rotate the hue by the golden section.
inline Rgb palette_color(std::size_t i)
{
  static const std::array<Rgb, 8> chosen = {{{{126, 178, 221}},
                                             {{245, 184, 108}},
                                             {{143, 203, 146}},
                                             {{233, 140, 134}},
                                             {{184, 160, 216}},
                                             {{240, 222, 126}},
                                             {{120, 202, 196}},
                                             {{226, 168, 200}}}};
  if (i < chosen.size())
    return chosen[i];
  const double turn = std::fmod(0.618034 * static_cast<double>(i), 1.);
  return from_hue(6. * turn, 0.4, i % 2 == 0 ? 0.95 : 0.8);
}

// The pairs of different labels that share an edge, in both directions, sorted, each once.
inline std::vector<std::pair<std::size_t, std::size_t> > cluster_adjacencies(const Mesh& mesh,
                                                                             const std::vector<std::size_t>& labels)
{
  std::vector<std::pair<std::size_t, std::size_t> > pairs;
  for (Edge e : mesh.edges()) {
    const Face f = mesh.face(mesh.halfedge(e, 0)), g = mesh.face(mesh.halfedge(e, 1));
    if (!mesh.is_border(e) && labels[f] != labels[g]) {
      pairs.emplace_back(labels[f], labels[g]);
      pairs.emplace_back(labels[g], labels[f]);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

// Assigns a color number to each label: greedily, in the order of the labels, the least used color that no neighbor has
// yet, so that no color dominates.
inline std::vector<std::size_t> color_clusters(const Mesh& mesh, const std::vector<std::size_t>& labels)
{
  const std::size_t n = labels.empty() ? 0 : *std::max_element(labels.begin(), labels.end()) + 1;
  const auto pairs = cluster_adjacencies(mesh, labels);
  std::vector<std::size_t> colors(n, 0), uses(7, 0);
  auto pair = pairs.begin();
  for (std::size_t label = 0; label < n; ++label) {
    std::vector<bool> taken(uses.size(), false);
    for (; pair != pairs.end() && pair->first == label; ++pair)
      if (pair->second < label)
        taken[colors[pair->second]] = true;
    std::size_t best = uses.size();
    for (std::size_t c = 0; c < uses.size(); ++c)
      if (!taken[c] && (best == uses.size() || uses[c] < uses[best]))
        best = c;
    if (best == uses.size())
      uses.push_back(0);
    ++uses[best];
    colors[label] = best;
  }
  return colors;
}

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_CLUSTER_COLORS_H
