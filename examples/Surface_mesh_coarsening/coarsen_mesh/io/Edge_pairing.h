// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_EDGE_PAIRING_H
#define COARSENING_SUPPORT_EDGE_PAIRING_H

#include "io/Polygons.h"
#include "io/Text_scanner.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace coarsening_support {

// Pairs the sides of polygons that form an edge. A side has the number of the corner where it begins. If an edge has more
// than two sides, or two of the same direction, no edge is paired.
class Edge_pairing
{
public:
  typedef std::uint32_t Side;
  static constexpr Side none = (std::numeric_limits<Side>::max)();

  // All corners have to be below `vertices`. The polygons must not change.
  Edge_pairing(const Polygons& polygons, std::size_t vertices, const Stop& stop = nullptr);

  // Returns the sides of an edge that cannot be paired, in their order, or nothing. Of several such edges it is the one whose
  // second side comes first.
  const std::vector<Side>& unpaired() const { return unpaired_; }

  // The other side of each edge, `none` on the border.
  Side twin(Side s) const { return twins_[s]; }

  // The side with the lower number of each edge. Edges are ordered by their vertex with the lower number, then by the other one.
  const std::vector<Side>& edges() const { return edges_; }

private:
  struct Entry
  {
    Vertex_number other; // the end with the higher number
    Side side;
  };

  std::vector<Side> twins_, edges_, unpaired_;

  std::vector<std::size_t> sort_by_lower_end(const Polygons&, std::size_t vertices, const Stop&, std::vector<Entry>& entries);
  void pair(const Entry* begin, const Entry* end, const std::vector<Vertex_number>& sources);
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_EDGE_PAIRING_H
